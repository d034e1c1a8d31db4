//! Invalid files, each with the line of its error and a part of the message.

/// A viewpoint in one line, so that the text after it starts in line 2.
pub const VIEW: &str = "v from 0 0 9 at 0 0 0 up 0 1 0 angle 30 hither 1 resolution 4 3\n";

/// An invalid file: its bytes, the line of the error, and a part of the message.
pub type BadNff = (Vec<u8>, usize, &'static str);

/// All invalid files.
pub fn invalid_files() -> Vec<BadNff> {
    let whole = WHOLE.iter().map(|(bytes, line, expected)| (bytes.to_vec(), *line, *expected));
    let views = VIEWS.iter().map(|(old, new, expected)| {
        let text = VIEW.replacen(old, new, 1);
        assert_ne!(text, VIEW, "`{old}` is not in the viewpoint");
        (text.into_bytes(), 1, *expected)
    });
    let after = AFTER_THE_VIEW.iter().map(|(text, line, expected)| {
        let text = format!("{VIEW}{text}");
        (text.into_bytes(), *line, *expected)
    });
    whole.chain(views).chain(after).collect()
}

/// Whole files.
const WHOLE: &[(&[u8], usize, &str)] = &[
    // Empty files.
    (b"", 1, "the file is empty"),
    (b"\n\n\n", 1, "the file is empty"),
    (b"# only\n# comments\n", 1, "the file is empty"),
    (b" \t\r\n", 1, "the file is empty"),
    // No viewpoint.
    (b"b 0 0 0\nl 1 2 3\n", 2, "the file has no viewpoint"),
    (b"b 0 0 0\nl 1 2 3\n\n\n# end", 5, "the file has no viewpoint"),
    // Not a text file.
    (b"\x89PNG\r\n\x1a\n\0\0\0\rIHDR", 3, "not a text file"),
    (b"b 0 0 0\nl 1 2 3\n\xff\xfe\n", 3, "is not an NFF entity"),
    (b"\xd8\xff\xe0\x10JFIF", 1, "is not an NFF entity"),
    (b"P6 4 3 255\n\x80\x90\xa0", 1, "`P6` is not an NFF entity"),
    (b"\0\0\0\0\0\0\0\0", 1, "not a text file"),
    (b"b 0 0 0\nl 1 2 \0\n", 2, "not a text file"),
    // Files of other formats.
    (b"#VRML V2.0\nShape {\n}\n", 2, "`Shape` is not an NFF entity"),
    (b"{\"objects\": []}", 1, "is not an NFF entity"),
    (b"\xef\xbb\xbfw", 1, "`w` is not an NFF entity"),
    // An incomplete viewpoint.
    (b"v", 1, "no `from` at the end of the file"),
    (b"v\n\n\n", 3, "no `from` at the end of the file"),
    (b"v\nfrom 0 0 9\nb 0 0 0\n", 3, "no `at` before `b`"),
    (b"v\nat 0 0 0\nup 0 1 0\nangle 3\nresolution 4 3\n", 5, "no `from`"),
    (b"v\nfrom 0 0 9\nup 0 1 0\nangle 3\nresolution 4 3\n", 5, "no `at`"),
    (b"v\nfrom 0 0 9\nat 0 0 0\nangle 3\nresolution 4 3\n", 5, "no `up`"),
    (b"v\nfrom 0 0 9\nat 0 0 0\nup 0 1 0\nresolution 4 3\n", 5, "no `angle`"),
    (b"v\nfrom 0 0 9\nat 0 0 0\nup 0 1 0\nangle 3\n", 5, "no `resolution`"),
    (b"v\nfrom 0 0 9\nfrom 0 0 9\n", 3, "duplicate `from`"),
    (b"from 0 0 9\n", 1, "`from` is not an NFF entity"),
    // It ends before a number.
    (b"b", 1, "unexpected end of file"),
    (b"b 0 0\n", 1, "unexpected end of file"),
    (
        b"b 0 0\n# end\n\n",
        3,
        "unexpected end of file; a channel of the background is missing (`b` in line 1)",
    ),
];

/// Changes of the viewpoint that make it invalid.
const VIEWS: &[(&str, &str, &str)] = &[
    ("angle 30", "angle 0", "the field of view must be more than 0 and less than 180 degrees"),
    ("angle 30", "angle 180", "the field of view must be more than 0 and less than 180 degrees"),
    ("angle 30", "angle -10", "the field of view must be more than 0 and less than 180 degrees"),
    ("angle 30", "angle 360", "the field of view must be more than 0 and less than 180 degrees"),
    ("angle 30", "angle 1e30", "the field of view must be more than 0 and less than 180 degrees"),
    ("angle 30", "angle NaN", "must be finite"),
    ("angle 30", "angle wide", "must be a number, not `wide`"),
    ("angle 30", "angle 30 40", "no `resolution` before `40`"),
    ("angle 30", "angle", "must be a number, not `hither`"),
    ("at 0 0 0", "at 0 0 9", "the position of the camera and its target are equal"),
    ("at 0 0 0", "at 0 0 9.0000001", "the position of the camera and its target are equal"),
    ("angle 30", "angle 179.9999999", "the field of view must be more than 0 and less than 180 degrees"),
    ("at 0 0 0", "at 0 0 1e16", "-1000000000000000 to 1000000000000000"),
    ("up 0 1 0", "up 0 0 1", "up is parallel"),
    ("up 0 1 0", "up 0 0 -5", "up is parallel"),
    ("up 0 1 0", "up 0 0 0", "up is parallel"),
    ("up 0 1 0", "up 0 1e-9 5", "up is parallel"),
    ("up 0 1 0", "up 0 1", "must be a number, not `angle`"),
    ("from 0 0 9", "from 0 0 -inf", "must be finite"),
    ("from 0 0 9", "from 0 0 -1e300", "must be finite"),
    ("hither 1", "hither x", "must be a number, not `x`"),
    ("hither 1", "hither 1 yon 2", "no `resolution` before `yon`"),
    ("resolution 4 3", "resolution 0 0", "the width of the picture must be an integer from 1 to 65536"),
    ("resolution 4 3", "resolution 4 0", "the height of the picture must be"),
    ("resolution 4 3", "resolution 100000 100000", "1 to 65536, not `100000`"),
    ("resolution 4 3", "resolution 65536 65536", "65536 x 65536 pixels are more than the limit for a file"),
    ("resolution 4 3", "resolution 4097 4096", "more than the limit for a file"),
    ("resolution 4 3", "resolution -5 3", "not `-5`"),
    ("resolution 4 3", "resolution 1.5 3", "not `1.5`"),
    ("resolution 4 3", "resolution 4e0 3", "not `4e0`"),
    ("resolution 4 3", "resolution 4294967297 3", "not `4294967297`"),
    ("resolution 4 3", "resolution 99999999999999999999999 3", "must be an integer"),
    ("resolution 4 3", "resolution 4", "unexpected end of file; the height of the picture is missing"),
    ("resolution 4 3", "resolution 4 3 2", "`2` does not belong here"),
];

/// Texts after a viewpoint in line 1.
const AFTER_THE_VIEW: &[(&str, usize, &str)] = &[
    // Entities that a scene can have once.
    (VIEW, 2, "duplicate viewpoint; the first is in line 1"),
    ("b 0 0 0\n\nb 1 1 1\n", 4, "duplicate background; the first is in line 2"),
    // Unknown entities.
    ("x 1 2 3\n", 2, "`x` is not an NFF entity"),
    ("S 0 0 0 1\n", 2, "`S` is not an NFF entity"),
    ("1 2 3\n", 2, "`1` is not an NFF entity"),
    ("b 0 0 0\n5\n", 3, "`5` is not an NFF entity"),
    ("b 0 0 0 s\n", 2, "`s` does not belong here"),
    ("sphere 0 0 0 1\n", 2, "`sphere` is not an NFF entity"),
    ("b 0 0 0\u{a0}1\nß\n", 2, "does not belong here"),
    ("\u{1b}[2J\n", 2, "`\\u{1b}[2J` is not an NFF entity"),
    // Too many numbers.
    ("b 0 0 0 0\n", 2, "`0` does not belong here"),
    ("l 1 2 3 1 1 1 1\n", 2, "`1` does not belong here"),
    ("f 1 1 1 1 0 0 0 0 0\n", 2, "`0` does not belong here"),
    ("f 1 1 1 1 0 0 0 0\ns 0 0 0 1 2\n", 3, "`2` does not belong here"),
    ("f 1 1 1 1 0 0 0 0\nc 0 0 0 1 0 0 1 1 7\n", 3, "`7` does not belong here"),
    ("f 1 1 1 1 0 0 0 0\np 3\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n", 7, "`0` is not an NFF entity"),
    // Too few numbers.
    ("l 1 2\nl 1 2 3\n", 3, "the light position must be a number, not `l`"),
    ("l 1 2 3 0.5\nb 0 0 0\n", 3, "a channel of the light must be a number, not `b`"),
    ("f 1 1 1 1 0 0 0\ns 0 0 0 1\n", 3, "the index of refraction must be a number, not `s`"),
    ("f 1 1 1 1 0 0 0 0\ns 0 0 0\n", 3, "unexpected end of file; the radius of the sphere is missing"),
    (
        "f 1 1 1 1 0 0 0 0\nc 0 0 0 1 0 0 1\n\n",
        4,
        "unexpected end of file; the radius of the apex is missing",
    ),
    ("f 1 1 1 1 0 0 0 0\np 3 0 0 0 1 0 0 0 1\n", 3, "unexpected end of file; a vertex is missing"),
    ("f 1 1 1 1 0 0 0 0\npp 3 0 0 0 1 0 0\n0 1\n", 4, "unexpected end of file; a vertex is missing"),
    ("f 1 1 1 1 0 0 0 0\npp 3 0 0 0 1 0\n", 3, "unexpected end of file; a vertex normal is missing"),
    // Words that are not numbers.
    ("b black 0 0\n", 2, "must be a number, not `black`"),
    ("b 0,0,0\n", 2, "must be a number, not `0,0,0`"),
    ("b 0x1 0 0\n", 2, "must be a number, not `0x1`"),
    ("b 1e 0 0\n", 2, "must be a number, not `1e`"),
    ("b -- 0 0\n", 2, "must be a number, not `--`"),
    ("b . 0 0\n", 2, "must be a number, not `.`"),
    ("b 1_0 0 0\n", 2, "must be a number, not `1_0`"),
    ("b 1f 0 0\n", 2, "must be a number, not `1f`"),
    ("b ０ 0 0\n", 2, "must be a number, not `０`"),
    (
        "b 12345678901234567890123456789012345678901234567890x 0 0\n",
        2,
        "`1234567890123456789012345678901234567890…`",
    ),
    ("l 1 2 3 -x 0 0\n", 2, "must be a number, not `-x`"),
    // Non-finite numbers.
    ("l NaN 2 3\n", 2, "must be finite, not `NaN`"),
    ("l 1 nan 3\n", 2, "must be finite, not `nan`"),
    ("l 1 2 inf\n", 2, "must be finite, not `inf`"),
    ("l 1 2 3 inf 0 0\n", 2, "must be finite, not `inf`"),
    ("l 1 2 -inf\n", 2, "must be finite, not `-inf`"),
    ("l 1 2 Infinity\n", 2, "must be finite, not `Infinity`"),
    ("l 1e400 2 3\n", 2, "must be finite, not `1e400`"),
    ("l 1e39 2 3\n", 2, "must be finite, not `1e39`"),
    // Numbers out of range.
    ("l 1.1e15 2 3\n", 2, "the light position must be -1000000000000000 to 1000000000000000"),
    ("l 0 0 -1e38\n", 2, "the light position must be -1000000000000000 to"),
    ("b -0.1 0 0\n", 2, "a channel of the background must be 0 to 1000000, not -0.1"),
    ("b 0 1.1e6 0\n", 2, "0 to 1000000"),
    ("l 1 2 3 0 -1 0\n", 2, "a channel of the light must be 0 to 1000000"),
    ("l 1 2 3 0 0 2e6\n", 2, "a channel of the light must be 0 to 1000000"),
    ("f -1 1 1 1 0 0 0 0\n", 2, "a channel of the material must be 0 to"),
    ("f 1 1 1 -1 0 0 0 0\n", 2, "the diffuse factor Kd must be 0 to"),
    ("f 1 1 1 2e6 0 0 0 0\n", 2, "the diffuse factor Kd must be 0 to"),
    ("f 1 1 1 1 1.01 0 0 0\n", 2, "the specular factor Ks must be 0 to 1, not 1.01"),
    ("f 1 1 1 1 -0.5 0 0 0\n", 2, "the specular factor Ks"),
    ("f 1 1 1 1 0 -1 0 0\n", 2, "the exponent Shine must be 0 to 1000000"),
    ("f 1 1 1 1 0 1e7 0 0\n", 2, "the exponent Shine"),
    ("f 1 1 1 1 0 0 1.5 1\n", 2, "the transmission factor T must be 0 to 1"),
    ("f 1 1 1 1 0 0 -1 1\n", 2, "the transmission factor T"),
    ("f 1 1 1 1 0 0 0.5 0\n", 2, "the index of refraction must be 0.01 to 100, not 0"),
    ("f 1 1 1 1 0 0 0.5 -1.5\n", 2, "the index of refraction"),
    ("f 1 1 1 1 0 0 1e-9 101\n", 2, "the index of refraction"),
    ("f 1 1 1 1 0 0 0 1e16\n", 2, "the index of refraction"),
    ("f 1 1 1 1 0 0 0 0\ns 0 1e16 0 1\n", 3, "the center of the sphere must be -1000000000000000 to"),
    ("f 1 1 1 1 0 0 0 0\ns 0 0 0 1e16\n", 3, "the radius of the sphere must be -1000000000000000 to"),
    ("f 1 1 1 1 0 0 0 0\nc 0 0 0 1\n0 0\n1e16 1\n", 5, "the apex of the cone must be -1000000000000000 to"),
    ("f 1 1 1 1 0 0 0 0\nc 0 0 0 1 0 0 1 -1e16\n", 3, "the radius of the apex must be -1000000000000000 to"),
    ("f 1 1 1 1 0 0 0 0\np 3\n0 0 0\n1 0 0\n0 1 1e16\n", 6, "a vertex must be -1000000000000000 to"),
    (
        "f 1 1 1 1 0 0 0 0\npp 3\n0 0 0 0 0 1\n1 0 0 0 0 1e16\n",
        5,
        "a vertex normal must be -1000000000000000 to",
    ),
    // Objects without a material.
    ("s 0 0 0 1\n", 2, "object before the first material"),
    ("c 0 0 0 1 0 0 1 1\n", 2, "object before the first material"),
    ("\np 3\n0 0 0\n1 0 0\n0 1 0\n", 3, "object before the first material"),
    ("p 3\n0 0 0\n0 0 0\n0 0 0\n", 2, "object before the first material"),
    ("pp 3 0 0 0 0 0 1 1 0 0 0 0 1 0 1 0 0 0 1\nf 1 1 1 1 0 0 0 0\n", 2, "object before the first material"),
    // Degenerate objects.
    ("f 1 1 1 1 0 0 0 0\ns 0 0 0 0\n", 3, "the radius of the sphere is 0"),
    ("f 1 1 1 1 0 0 0 0\ns 0 0 0 -0\n", 3, "the radius of the sphere is 0"),
    ("f 1 1 1 1 0 0 0 0\ns 0 0 0 1e-50\n", 3, "the radius of the sphere is 0"),
    ("f 1 1 1 1 0 0 0 0\nc 1 2 3 1\n1 2 3 2\n", 3, "the base and apex of the cone are equal"),
    ("f 1 1 1 1 0 0 0 0\nc 1 2 3 1 1.00000001 2 3 2\n", 3, "the base and apex of the cone are equal"),
    ("f 1 1 1 1 0 0 0 0\nc 1 2 3 0 4 5 6 -0\n", 3, "both radii of the cone are 0"),
    ("f 1 1 1 1 0 0 0 0\nc -1e15 0 0 1 1e15 0 0 1\n", 3, "the cone is longer than"),
    ("f 1 1 1 1 0 0 0 0\np 2 0 0 0 1 0 0\n", 3, "the number of vertices must be an integer from 3"),
    ("f 1 1 1 1 0 0 0 0\np 0\n", 3, "the number of vertices"),
    ("f 1 1 1 1 0 0 0 0\np -3\n", 3, "not `-3`"),
    ("f 1 1 1 1 0 0 0 0\np 3.0\n", 3, "not `3.0`"),
    ("f 1 1 1 1 0 0 0 0\np 4000000000\n0 0 0\n1 0 0\n", 5, "unexpected end of file; a vertex is missing"),
    ("f 1 1 1 1 0 0 0 0\npp 4294967295 0 0 0 0 0 1\n", 3, "unexpected end of file; a vertex is missing"),
    ("f 1 1 1 1 0 0 0 0\np 4294967296\n", 3, "not `4294967296`"),
    ("f 1 1 1 1 0 0 0 0\npp 99999999999999999999\n", 3, "not `99999999999999999999`"),
    ("f 1 1 1 1 0 0 0 0\npp 3\n0 0 0 0 0 1\n1 0 0\n0 0 0\n0 1 0 0 0 1\n", 6, "a vertex normal is zero"),
    ("f 1 1 1 1 0 0 0 0\npp 3 0 0 0 0 0 1 1 0 0 0 1e-50 0 0 1 0 0 0 1\n", 3, "a vertex normal is zero"),
];
