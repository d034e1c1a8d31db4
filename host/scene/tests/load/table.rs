//! Wrong files: what is in them, the line that is to blame, and a part of what is said of it.

/// A viewpoint in one line, so that what follows begins in line 2.
pub const VIEW: &str = "v from 0 0 9 at 0 0 0 up 0 1 0 angle 30 hither 1 resolution 4 3\n";

/// A wrong file: its bytes, the line that is to blame, and a part of what is said.
pub type Wrong = (Vec<u8>, usize, &'static str);

/// All of them.
pub fn wrong_files() -> Vec<Wrong> {
    let whole = WHOLE.iter().map(|(bytes, line, says)| (bytes.to_vec(), *line, *says));
    let views = VIEWS.iter().map(|(old, new, says)| {
        let text = VIEW.replacen(old, new, 1);
        assert_ne!(text, VIEW, "`{old}` is not in the viewpoint");
        (text.into_bytes(), 1, *says)
    });
    let after = AFTER_THE_VIEW.iter().map(|(text, line, says)| {
        let text = format!("{VIEW}{text}");
        (text.into_bytes(), *line, *says)
    });
    whole.chain(views).chain(after).collect()
}

/// Whole files.
const WHOLE: &[(&[u8], usize, &str)] = &[
    // Nothing.
    (b"", 1, "no scene"),
    (b"\n\n\n", 1, "no scene"),
    (b"# only\n# comments\n", 1, "no scene"),
    (b" \t\r\n", 1, "no scene"),
    // No viewpoint.
    (b"b 0 0 0\nl 1 2 3\n", 2, "without a viewpoint"),
    (b"b 0 0 0\nl 1 2 3\n\n\n# end", 5, "without a viewpoint"),
    // No text.
    (b"\x89PNG\r\n\x1a\n\0\0\0\rIHDR", 3, "not text"),
    (b"b 0 0 0\nl 1 2 3\n\xff\xfe\n", 3, "is no NFF entity"),
    (b"\xd8\xff\xe0\x10JFIF", 1, "is no NFF entity"),
    (b"P6 4 3 255\n\x80\x90\xa0", 1, "`P6` is no NFF entity"),
    (b"\0\0\0\0\0\0\0\0", 1, "not text"),
    (b"b 0 0 0\nl 1 2 \0\n", 2, "not text"),
    // Another kind of file.
    (b"#VRML V2.0\nShape {\n}\n", 2, "`Shape` is no NFF entity"),
    (b"{\"objects\": []}", 1, "is no NFF entity"),
    (b"\xef\xbb\xbfw", 1, "`w` is no NFF entity"),
    // A viewpoint that is not whole.
    (b"v", 1, "no `from` at the end of the file"),
    (b"v\n\n\n", 3, "no `from` at the end of the file"),
    (b"v\nfrom 0 0 9\nb 0 0 0\n", 3, "no `at` before `b`"),
    (b"v\nat 0 0 0\nup 0 1 0\nangle 3\nresolution 4 3\n", 5, "no `from`"),
    (b"v\nfrom 0 0 9\nup 0 1 0\nangle 3\nresolution 4 3\n", 5, "no `at`"),
    (b"v\nfrom 0 0 9\nat 0 0 0\nangle 3\nresolution 4 3\n", 5, "no `up`"),
    (b"v\nfrom 0 0 9\nat 0 0 0\nup 0 1 0\nresolution 4 3\n", 5, "no `angle`"),
    (b"v\nfrom 0 0 9\nat 0 0 0\nup 0 1 0\nangle 3\n", 5, "no `resolution`"),
    (b"v\nfrom 0 0 9\nfrom 0 0 9\n", 3, "a second `from`"),
    (b"from 0 0 9\n", 1, "`from` is no NFF entity"),
    // It ends where a number should follow.
    (b"b", 1, "the file ends"),
    (b"b 0 0\n", 1, "the file ends"),
    (b"b 0 0\n# end\n\n", 3, "the file ends where a channel of the background should follow (`b` in line 1)"),
];

/// Changes of the viewpoint.
const VIEWS: &[(&str, &str, &str)] = &[
    ("angle 30", "angle 0", "the angle"),
    ("angle 30", "angle 180", "the angle"),
    ("angle 30", "angle -10", "the angle"),
    ("angle 30", "angle 360", "the angle"),
    ("angle 30", "angle 1e30", "the angle"),
    ("angle 30", "angle NaN", "not a finite number"),
    ("angle 30", "angle wide", "`wide` is no number"),
    ("angle 30", "angle 30 40", "no `resolution` before `40`"),
    ("angle 30", "angle", "`hither` is no number"),
    ("at 0 0 0", "at 0 0 9", "the position of the camera and its target are equal"),
    ("at 0 0 0", "at 0 0 9.0000001", "the position of the camera and its target are equal"),
    ("angle 30", "angle 179.9999999", "the angle"),
    ("at 0 0 0", "at 0 0 1e16", "between -1000000000000000 and 1000000000000000"),
    ("up 0 1 0", "up 0 0 1", "up is parallel"),
    ("up 0 1 0", "up 0 0 -5", "up is parallel"),
    ("up 0 1 0", "up 0 0 0", "up is parallel"),
    ("up 0 1 0", "up 0 1e-9 5", "up is parallel"),
    ("up 0 1 0", "up 0 1", "`angle` is no number"),
    ("from 0 0 9", "from 0 0 -inf", "not a finite number"),
    ("from 0 0 9", "from 0 0 -1e300", "not a finite number"),
    ("hither 1", "hither x", "`x` is no number"),
    ("hither 1", "hither 1 yon 2", "no `resolution` before `yon`"),
    ("resolution 4 3", "resolution 0 0", "the width of the picture must be an integer between 1 and 65536"),
    ("resolution 4 3", "resolution 4 0", "the height of the picture must be"),
    ("resolution 4 3", "resolution 100000 100000", "between 1 and 65536, not `100000`"),
    ("resolution 4 3", "resolution 65536 65536", "65536 x 65536 pixels are more than a file may ask for"),
    ("resolution 4 3", "resolution 4097 4096", "more than a file may ask for"),
    ("resolution 4 3", "resolution -5 3", "not `-5`"),
    ("resolution 4 3", "resolution 1.5 3", "not `1.5`"),
    ("resolution 4 3", "resolution 4e0 3", "not `4e0`"),
    ("resolution 4 3", "resolution 4294967297 3", "not `4294967297`"),
    ("resolution 4 3", "resolution 99999999999999999999999 3", "must be an integer"),
    ("resolution 4 3", "resolution 4", "the file ends where the height of the picture should follow"),
    ("resolution 4 3", "resolution 4 3 2", "`2` does not belong here"),
];

/// What follows a viewpoint in line 1.
const AFTER_THE_VIEW: &[(&str, usize, &str)] = &[
    // What a scene has only once.
    (VIEW, 2, "a second viewpoint; the first is in line 1"),
    ("b 0 0 0\n\nb 1 1 1\n", 4, "a second background; the first is in line 2"),
    // No entity.
    ("x 1 2 3\n", 2, "`x` is no NFF entity"),
    ("S 0 0 0 1\n", 2, "`S` is no NFF entity"),
    ("1 2 3\n", 2, "`1` is no NFF entity"),
    ("b 0 0 0\n5\n", 3, "`5` is no NFF entity"),
    ("b 0 0 0 s\n", 2, "`s` does not belong here"),
    ("sphere 0 0 0 1\n", 2, "`sphere` is no NFF entity"),
    ("b 0 0 0\u{a0}1\nß\n", 2, "does not belong here"),
    ("\u{1b}[2J\n", 2, "`\\u{1b}[2J` is no NFF entity"),
    // A number too many.
    ("b 0 0 0 0\n", 2, "`0` does not belong here"),
    ("l 1 2 3 1 1 1 1\n", 2, "`1` does not belong here"),
    ("f 1 1 1 1 0 0 0 0 0\n", 2, "`0` does not belong here"),
    ("f 1 1 1 1 0 0 0 0\ns 0 0 0 1 2\n", 3, "`2` does not belong here"),
    ("f 1 1 1 1 0 0 0 0\nc 0 0 0 1 0 0 1 1 7\n", 3, "`7` does not belong here"),
    ("f 1 1 1 1 0 0 0 0\np 3\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n", 7, "`0` is no NFF entity"),
    // A number too few.
    ("l 1 2\nl 1 2 3\n", 3, "`l` is no number; the place of the light is expected"),
    ("l 1 2 3 0.5\nb 0 0 0\n", 3, "`b` is no number; a channel of the light is expected"),
    ("f 1 1 1 1 0 0 0\ns 0 0 0 1\n", 3, "`s` is no number; the index of refraction is expected"),
    ("f 1 1 1 1 0 0 0 0\ns 0 0 0\n", 3, "the file ends where the radius of the sphere should follow"),
    ("f 1 1 1 1 0 0 0 0\nc 0 0 0 1 0 0 1\n\n", 4, "the file ends where the radius of the apex should follow"),
    ("f 1 1 1 1 0 0 0 0\np 3 0 0 0 1 0 0 0 1\n", 3, "the file ends where a corner should follow"),
    ("f 1 1 1 1 0 0 0 0\npp 3 0 0 0 1 0 0\n0 1\n", 4, "the file ends where a corner should follow"),
    ("f 1 1 1 1 0 0 0 0\npp 3 0 0 0 1 0\n", 3, "the file ends where the normal of a corner should follow"),
    // No number.
    ("b black 0 0\n", 2, "`black` is no number"),
    ("b 0,0,0\n", 2, "`0,0,0` is no number"),
    ("b 0x1 0 0\n", 2, "`0x1` is no number"),
    ("b 1e 0 0\n", 2, "`1e` is no number"),
    ("b -- 0 0\n", 2, "`--` is no number"),
    ("b . 0 0\n", 2, "`.` is no number"),
    ("b 1_0 0 0\n", 2, "`1_0` is no number"),
    ("b 1f 0 0\n", 2, "`1f` is no number"),
    ("b ０ 0 0\n", 2, "is no number"),
    (
        "b 12345678901234567890123456789012345678901234567890x 0 0\n",
        2,
        "`1234567890123456789012345678901234567890…`",
    ),
    ("l 1 2 3 -x 0 0\n", 2, "`-x` is no number"),
    // No finite number.
    ("l NaN 2 3\n", 2, "`NaN` is not a finite number"),
    ("l 1 nan 3\n", 2, "`nan` is not a finite number"),
    ("l 1 2 inf\n", 2, "`inf` is not a finite number"),
    ("l 1 2 3 inf 0 0\n", 2, "`inf` is not a finite number"),
    ("l 1 2 -inf\n", 2, "`-inf` is not a finite number"),
    ("l 1 2 Infinity\n", 2, "`Infinity` is not a finite number"),
    ("l 1e400 2 3\n", 2, "`1e400` is not a finite number"),
    ("l 1e39 2 3\n", 2, "`1e39` is not a finite number"),
    // A number out of range.
    ("l 1.1e15 2 3\n", 2, "the place of the light must be between -1000000000000000 and 1000000000000000"),
    ("l 0 0 -1e38\n", 2, "the place of the light must be between"),
    ("b -0.1 0 0\n", 2, "a channel of the background must be between 0 and 1000000, not -0.1"),
    ("b 0 1.1e6 0\n", 2, "between 0 and 1000000"),
    ("l 1 2 3 0 -1 0\n", 2, "a channel of the light must be between"),
    ("l 1 2 3 0 0 2e6\n", 2, "a channel of the light must be between"),
    ("f -1 1 1 1 0 0 0 0\n", 2, "a channel of the surface must be between"),
    ("f 1 1 1 -1 0 0 0 0\n", 2, "the diffuse share Kd must be between"),
    ("f 1 1 1 2e6 0 0 0 0\n", 2, "the diffuse share Kd must be between"),
    ("f 1 1 1 1 1.01 0 0 0\n", 2, "the mirrored share Ks must be between 0 and 1, not 1.01"),
    ("f 1 1 1 1 -0.5 0 0 0\n", 2, "the mirrored share Ks"),
    ("f 1 1 1 1 0 -1 0 0\n", 2, "the exponent Shine must be between 0 and 1000000"),
    ("f 1 1 1 1 0 1e7 0 0\n", 2, "the exponent Shine"),
    ("f 1 1 1 1 0 0 1.5 1\n", 2, "the transmitted share T must be between 0 and 1"),
    ("f 1 1 1 1 0 0 -1 1\n", 2, "the transmitted share T"),
    ("f 1 1 1 1 0 0 0.5 0\n", 2, "the index of refraction must be between 0.01 and 100, not 0"),
    ("f 1 1 1 1 0 0 0.5 -1.5\n", 2, "the index of refraction"),
    ("f 1 1 1 1 0 0 1e-9 101\n", 2, "the index of refraction"),
    ("f 1 1 1 1 0 0 0 1e16\n", 2, "the index of refraction"),
    ("f 1 1 1 1 0 0 0 0\ns 0 1e16 0 1\n", 3, "the centre of the sphere must be between"),
    ("f 1 1 1 1 0 0 0 0\ns 0 0 0 1e16\n", 3, "the radius of the sphere must be between"),
    ("f 1 1 1 1 0 0 0 0\nc 0 0 0 1\n0 0\n1e16 1\n", 5, "the apex of the cone must be between"),
    ("f 1 1 1 1 0 0 0 0\nc 0 0 0 1 0 0 1 -1e16\n", 3, "the radius of the apex must be between"),
    ("f 1 1 1 1 0 0 0 0\np 3\n0 0 0\n1 0 0\n0 1 1e16\n", 6, "a corner must be between"),
    ("f 1 1 1 1 0 0 0 0\npp 3\n0 0 0 0 0 1\n1 0 0 0 0 1e16\n", 5, "the normal of a corner must be between"),
    // An object of nothing.
    ("s 0 0 0 1\n", 2, "an object before the first surface"),
    ("c 0 0 0 1 0 0 1 1\n", 2, "an object before the first surface"),
    ("\np 3\n0 0 0\n1 0 0\n0 1 0\n", 3, "an object before the first surface"),
    ("p 3\n0 0 0\n0 0 0\n0 0 0\n", 2, "an object before the first surface"),
    (
        "pp 3 0 0 0 0 0 1 1 0 0 0 0 1 0 1 0 0 0 1\nf 1 1 1 1 0 0 0 0\n",
        2,
        "an object before the first surface",
    ),
    // An object that is none.
    ("f 1 1 1 1 0 0 0 0\ns 0 0 0 0\n", 3, "the radius of the sphere is 0"),
    ("f 1 1 1 1 0 0 0 0\ns 0 0 0 -0\n", 3, "the radius of the sphere is 0"),
    ("f 1 1 1 1 0 0 0 0\ns 0 0 0 1e-50\n", 3, "the radius of the sphere is 0"),
    ("f 1 1 1 1 0 0 0 0\nc 1 2 3 1\n1 2 3 2\n", 3, "base and apex are at the same place"),
    ("f 1 1 1 1 0 0 0 0\nc 1 2 3 1 1.00000001 2 3 2\n", 3, "base and apex are at the same place"),
    ("f 1 1 1 1 0 0 0 0\nc 1 2 3 0 4 5 6 -0\n", 3, "both radii of the cone are 0"),
    ("f 1 1 1 1 0 0 0 0\nc -1e15 0 0 1 1e15 0 0 1\n", 3, "the cone is longer than"),
    ("f 1 1 1 1 0 0 0 0\np 2 0 0 0 1 0 0\n", 3, "the number of corners must be an integer between 3"),
    ("f 1 1 1 1 0 0 0 0\np 0\n", 3, "the number of corners"),
    ("f 1 1 1 1 0 0 0 0\np -3\n", 3, "not `-3`"),
    ("f 1 1 1 1 0 0 0 0\np 3.0\n", 3, "not `3.0`"),
    ("f 1 1 1 1 0 0 0 0\np 4000000000\n0 0 0\n1 0 0\n", 5, "the file ends where a corner should follow"),
    ("f 1 1 1 1 0 0 0 0\npp 4294967295 0 0 0 0 0 1\n", 3, "the file ends where a corner should follow"),
    ("f 1 1 1 1 0 0 0 0\np 4294967296\n", 3, "not `4294967296`"),
    ("f 1 1 1 1 0 0 0 0\npp 99999999999999999999\n", 3, "not `99999999999999999999`"),
    (
        "f 1 1 1 1 0 0 0 0\npp 3\n0 0 0 0 0 1\n1 0 0\n0 0 0\n0 1 0 0 0 1\n",
        6,
        "the normal of a corner is zero",
    ),
    (
        "f 1 1 1 1 0 0 0 0\npp 3 0 0 0 0 0 1 1 0 0 0 1e-50 0 0 1 0 0 0 1\n",
        3,
        "the normal of a corner is zero",
    ),
];
