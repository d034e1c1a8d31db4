//! What `cast` answers.

use std::io::{BufRead, BufReader, Read, Write};
use std::process::{Command, Stdio};

use crate::program::{EMPTY, Folder, Running};

/// One of several kinds, in an order of the file that no order of kinds is.
const THINGS: &str = r#"
[[triangle]]
corners = [[9, -1, 0], [11, -1, 0], [10, 1, 0]]
[[sphere]]
radius = 1
[[cylinder]]
base = [20, 0, -1]
end = [20, 0, 1]
radius = 1
open = true
[[sphere]]
center = [0, 0, -5]
radius = 1
[[polygon]]
corners = [[29, 1, 0], [31, 1, 0], [31, -1, 0], [29, -1, 0]]
[[plane]]
point = [0, 0, -100]
normal = [0, 0, -1]
[[box]]
min = [39, -1, -1]
max = [41, 1, 1]
"#;

fn things() -> Folder {
    let folder = Folder::with(EMPTY);
    folder.write("things.toml", THINGS);
    folder
}

/// The rows that answer these lines.
fn rows(folder: &Folder, words: &str, lines: &str) -> Vec<String> {
    folder.write("rays.csv", lines);
    let out = folder.done(&format!("cast --rays rays.csv -q {words}"));
    let text = String::from_utf8(out).unwrap();
    assert!(text.is_empty() || text.ends_with('\n'), "{text}");
    text.lines().map(str::to_owned).collect()
}

const MISS: &str = "0,,,,,,,,";

#[test]
fn a_ray_is_answered_with_distance_object_point_and_normal() {
    let folder = things();
    for words in [
        "things.toml",
        "things.toml --precision double",
        "things.toml --bounds none",
        "things.toml --accel list",
    ] {
        assert_eq!(
            rows(&folder, words, "0,0,4,0,0,-1\n0,0,4,0,0,-2\n0,3,4,0,0,1\n0,0,0,0,0,-0.5\n"),
            ["1,3,1,0,0,1,0,0,1", "1,1.5,1,0,0,1,0,0,1", MISS, "1,2,1,0,0,-1,0,0,-1"],
            "{words}"
        );
    }
}

#[test]
fn objects_are_numbered_in_the_order_of_the_file_across_the_kinds() {
    let lines: String =
        ["10,0", "0,0", "20,1", "0,50", "30,0", "40,0"].map(|place| format!("{place},4,0,0,-1\n")).concat();
    let rows = rows(&things(), "things.toml", &lines);
    let objects: Vec<_> = rows.iter().map(|row| row.split(',').nth(2).unwrap()).collect();
    // The tube is hit in its wall, along which the ray runs; between the balls is the plane.
    assert_eq!(objects, ["0", "1", "5", "5", "4", "6"]);
}

#[test]
fn every_triangle_of_a_mesh_is_an_object() {
    let folder = things();
    folder.write("two.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3\nf 1 3 4\n");
    folder.write("mesh.toml", "[[sphere]]\ncenter = [5, 0, 0]\nradius = 1\n[[mesh]]\nfile = \"two.obj\"\n[[sphere]]\ncenter = [9, 0, 0]\nradius = 1\n");
    let rows = rows(&folder, "mesh.toml", "5,0,4,0,0,-1\n.75,.5,4,0,0,-1\n.25,.5,4,0,0,-1\n9,0,4,0,0,-1\n");
    let objects: Vec<_> = rows.iter().map(|row| row.split(',').nth(2).unwrap()).collect();
    // In TOML the order is that of the places in the file: the mesh is between the spheres.
    assert_eq!(objects, ["0", "1", "2", "3"]);
}

#[test]
fn normals_are_not_turned_towards_the_ray() {
    let folder = things();
    for (line, normal) in [
        // A ball from inside and from outside.
        ("0,0,4,0,0,-1", "0,0,1"),
        ("0,0,0,0,0,-1", "0,0,-1"),
        // The tube's wall from outside, and from inside.
        ("24,0,0,-1,0,0", "1,0,0"),
        ("20,0,0,1,0,0", "1,0,0"),
        // The triangle's corners run to the left, seen from above; the polygon's to the right.
        ("10,0,4,0,0,-1", "0,0,1"),
        ("10,0,-4,0,0,1", "0,0,1"),
        ("30,0.5,4,0,0,-1", "0,0,-1"),
        ("30,0.5,-4,0,0,1", "0,0,-1"),
        ("0,50,4,0,0,-1", "0,0,-1"),
        ("0,50,-400,0,0,1", "0,0,-1"),
        ("40,0,0,0,0,-1", "0,0,-1"),
    ] {
        let row = rows(&folder, "things.toml", line).remove(0);
        let found = row.splitn(7, ',').nth(6).unwrap().replace("-0,", "0,").replace(",-0", ",0");
        assert_eq!(
            found.strip_prefix("-0").filter(|rest| rest.starts_with(',')).unwrap_or(&found),
            normal,
            "{line}: {row}"
        );
    }
}

#[test]
fn a_hit_counts_up_to_the_very_limit_and_beyond_the_start_only() {
    let folder = things();
    let lines: String = ["3", "2.9999998", "inf", "1e39", "3e0", "0", "-0", "-1", "-inf", "nan", "1e-60"]
        .map(|limit| format!("0,0,4,0,0,-1,{limit}\n"))
        .concat();
    let hits: Vec<_> = rows(&folder, "things.toml", &lines).iter().map(|row| row.starts_with('1')).collect();
    assert_eq!(hits, [true, false, true, true, true, false, false, false, false, false, false]);
    // In units of the direction.
    let lines = "0,0,4,0,0,-0.25,12\n0,0,4,0,0,-0.25,11.999999\n";
    assert_eq!(rows(&folder, "things.toml", lines), ["1,12,1,0,0,1,0,0,1", MISS]);
    // On the ball: the point itself is not in front of it.
    assert_eq!(rows(&folder, "things.toml", "0,0,1,0,0,-1\n"), ["1,2,1,0,0,-1,0,0,-1"]);
}

#[test]
fn numbers_that_no_ray_has_are_answered_by_misses() {
    let folder = things();
    let mut lines = String::new();
    for word in ["nan", "-nan", "NaN", "inf", "-inf", "Infinity", "1e999", "-1e999"] {
        for place in 0..6 {
            let mut fields = ["0", "0", "4", "0", "0", "-1"];
            fields[place] = word;
            lines += &(fields.join(",") + "\n");
        }
    }
    // No direction; an origin beyond the largest coordinate of a scene.
    lines +=
        "0,0,4,0,0,0\n0,0,4,-0,0,-0\n0,0,4,0,0,1e-999\n0,0,1e16,0,0,-1\n1e19,0,4,-1,0,0\n1e300,0,4,-1,0,0\n";
    for words in ["things.toml", "things.toml --precision double"] {
        let rows = rows(&folder, words, &lines);
        assert_eq!(rows.len(), 8 * 6 + 6);
        assert!(rows.iter().all(|row| row == MISS), "{words}: {rows:?}");
        // A zero has a sign and is a number; as far away as a scene may reach is not too far.
        for line in ["-0,-0,4,-0,0,-1", "0,-0,4,0,-0,-1", "0,0,1e15,0,0,-1"] {
            assert!(self::rows(&folder, words, line)[0].starts_with("1,"), "{line}");
        }
    }
}

#[test]
fn a_direction_may_have_any_length() {
    let folder = things();
    let place = |row: &str| row.splitn(4, ',').nth(3).unwrap().to_owned();
    let t = |row: &str, words: &str| {
        let text = row.split(',').nth(1).unwrap();
        match text.parse::<f32>() {
            Ok(t) if t.is_finite() && !words.contains("double") => f64::from(t),
            _ => text.parse::<f64>().unwrap(),
        }
    };
    for words in ["things.toml", "things.toml --precision double"] {
        let ray = |scale: f64, limit: f64| {
            let [x, y, z] = [0.01_f32, 0.02, -1.0].map(|d| f64::from(d) * scale);
            rows(&folder, words, &format!("0.3,-0.2,4,{x:e},{y:e},{z:e},{limit:e}")).remove(0)
        };
        let one = ray(1.0, f64::INFINITY);
        assert!(one.starts_with("1,"));
        // Powers of two change not one bit but those of t.
        for power in (-96..=96).step_by(12) {
            let scale = libm::scalbn(1.0, power);
            let limit = t(&one, words) / scale;
            let row = ray(scale, limit);
            assert_eq!(place(&row), place(&one), "{words} 2^{power}");
            assert_eq!(t(&row, words), limit, "{words} 2^{power}");
            let nearer = limit * (1.0 - 1e-6);
            assert_eq!(ray(scale, nearer), MISS, "{words} 2^{power}");
        }
        for length in ["1e-30", "1e-20", "1e20", "1e30"] {
            let row = rows(&folder, words, &format!("0,0,4,0,0,-{length}")).remove(0);
            let expected = 3.0 / length.parse::<f64>().unwrap();
            assert!((t(&row, words) / expected - 1.0).abs() < 1e-6, "{words} {length}: {row}");
            assert_eq!(place(&row), "0,0,1,0,0,1");
        }
    }
    // Beyond the range of single precision in t alone.
    let row = rows(&folder, "things.toml", "0,50,1e15,0,0,-1e-30").remove(0);
    assert!((t(&row, "") / 1e45 - 1.0).abs() < 1e-6 && row.ends_with(",5,0,50,-100,0,0,-1"), "{row}");
    assert_eq!(rows(&folder, "things.toml", "0,0,4,0,0,-1e-320"), [MISS]);
    assert!(rows(&folder, "things.toml --precision double", "0,0,4,0,0,-1e-300")[0].starts_with("1,3e300,1"));
}

#[test]
fn a_header_line_is_answered_by_one() {
    let folder = things();
    for header in [
        "ox,oy,oz,dx,dy,dz",
        "ox,oy,oz,dx,dy,dz,tmax",
        "\u{feff}ox,oy,oz,dx,dy,dz",
        "OX, \"oy\", oz, dx, dy, dz",
    ] {
        let rows = rows(&folder, "things.toml", &format!("{header}\r\n0,0,4,0,0,-1\r\n0,9,4,0,1,0"));
        assert_eq!(rows, ["hit,t,object,px,py,pz,nx,ny,nz", "1,3,1,0,0,1,0,0,1", MISS], "{header}");
    }
    assert_eq!(rows(&folder, "things.toml", "ox,oy,oz,dx,dy,dz"), ["hit,t,object,px,py,pz,nx,ny,nz"]);
    assert_eq!(rows(&folder, "things.toml", "\u{feff}0,0,4,0,0,-1"), ["1,3,1,0,0,1,0,0,1"]);
    assert!(rows(&folder, "things.toml", "").is_empty());
}

#[test]
fn a_header_of_other_names_or_in_another_order_is_refused() {
    let folder = things();
    for header in ["dx,dy,dz,ox,oy,oz", "a,b,c,d,e,f", "ox,oy,oz,dx,dy,dz,t"] {
        folder.write("rays.csv", format!("{header}\n0,0,4,0,0,-1\n"));
        let ran = folder.run("cast things.toml --rays rays.csv");
        ran.failed(65, &format!("strahl: rays.csv:1: `{header}` "));
        assert!(
            ran.stderr.contains("expected ox,oy,oz,dx,dy,dz or ox,oy,oz,dx,dy,dz,tmax"),
            "{}",
            ran.stderr
        );
    }
}

#[test]
fn a_wrong_line_is_named_with_status_65_and_the_rows_before_it_stay() {
    let folder = things();
    let good = "0,0,4,0,0,-1\n0,9,4,0,1,0\n";
    for (line, says) in [
        ("1,2,3", "3 fields"),
        ("1,2,3,4,5,6,7,8", "8 fields"),
        ("", "1 field"),
        ("0,0,4,0,0,up", "dz is `up`, not a number"),
        ("0,0,4,0,0,-1,", "tmax is empty"),
        ("ox,oy,oz,dx,dy,dz", "ox is `ox`, not a number"),
    ] {
        folder.write("rays.csv", format!("{good}{line}\n{good}"));
        for words in ["", "--threads 1", "--threads 7", "--precision double"] {
            let ran = folder.run(&format!("cast things.toml --rays rays.csv {words}"));
            assert_eq!(ran.status, Some(65), "{line}");
            assert!(ran.stderr.starts_with(&format!("strahl: rays.csv:3: {says}")), "{}", ran.stderr);
            assert_eq!(ran.stdout, format!("1,3,1,0,0,1,0,0,1\n{MISS}\n").as_bytes());
        }
        let ran = folder.run("cast things.toml --rays rays.csv -o hits.csv");
        assert_eq!((ran.status, folder.read("hits.csv").len()), (Some(65), 28));
    }
    // Far behind, among many that are worked on at once.
    let many = format!("{}x\n{}", good.repeat(20_000), good.repeat(20_000));
    folder.write("rays.csv", many);
    let ran = folder.run("cast things.toml --rays rays.csv --threads 7");
    assert_eq!(ran.status, Some(65));
    assert!(ran.stderr.starts_with("strahl: rays.csv:40001: "), "{}", ran.stderr);
    assert_eq!(ran.stdout.iter().filter(|byte| **byte == b'\n').count(), 40_000);
    // A file that is one endless line does not fill the memory.
    folder.write("rays.csv", "1".repeat(1 << 20));
    folder.run("cast things.toml --rays rays.csv").failed(65, "rays.csv:1: the line is longer than");
}

#[test]
fn rows_come_in_the_order_of_the_lines_with_any_number_of_threads() {
    let folder = things();
    let lines: String = (0..30_000).map(|i| format!("0,0,{},0,0,-1\n", 2 + i)).collect();
    let one = rows(&folder, "things.toml --threads 1", &lines);
    for (row, i) in one.iter().zip(0..) {
        let t: f64 = row.split(',').nth(1).unwrap().parse().unwrap();
        assert!((t - f64::from(1 + i)).abs() < 0.5, "{row} in place {i}");
    }
    assert_eq!(one.len(), 30_000);
    for threads in [2, 7] {
        assert_eq!(rows(&folder, &format!("things.toml --threads {threads}"), &lines), one);
    }
}

#[test]
fn numbers_are_read_back_exactly() {
    let folder = things();
    let lines: String = (0..500)
        .map(|i| {
            format!(
                "{},{},4,0.1,{},-1.3\n",
                0.001 * f64::from(i),
                -0.0007 * f64::from(i),
                0.0001 * f64::from(i)
            )
        })
        .collect();
    for row in rows(&folder, "things.toml", &lines).iter().filter(|row| *row != MISS) {
        let fields: Vec<f32> = row.split(',').map(|field| field.parse().unwrap()).collect();
        let again: Vec<_> =
            row.split(',').zip(&fields).map(|(field, x)| (field.len(), format!("{x}").len())).collect();
        assert!(again.iter().all(|(ours, other)| ours <= other), "{row}");
        let n = &fields[6..9];
        let length = n.iter().map(|x| f64::from(*x).powf(2.0)).sum::<f64>();
        assert!((length - 1.0).abs() < 1e-6, "{row}");
    }
}

#[test]
fn both_precisions_find_nearly_the_same_of_the_same_scene() {
    let folder = Folder::with(EMPTY);
    // In double precision 0.1 is another number, but not in a scene.
    folder.write("ball.toml", "[[sphere]]\nradius = 0.1\n");
    let radius = f64::from(0.1_f32);
    let t = |words: &str| {
        let row = rows(&folder, &format!("ball.toml {words}"), "0,0,4,0,0,-1").remove(0);
        row.split(',').nth(1).unwrap().parse::<f64>().unwrap()
    };
    assert_eq!(t("--precision double"), 4.0 - radius);
    assert_eq!(t(""), 3.9);
}

#[test]
fn the_hits_may_go_into_a_file_and_the_rays_come_from_the_standard_input() {
    let folder = things();
    let mut command = folder.command("cast things.toml -o hits.csv");
    let mut child =
        command.stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap();
    child.stdin.take().unwrap().write_all(b"0,0,4,0,0,-1").unwrap();
    let out = child.wait_with_output().unwrap();
    assert_eq!((out.status.code(), out.stdout.len()), (Some(0), 0));
    assert_eq!(folder.read("hits.csv"), b"1,3,1,0,0,1,0,0,1\n");
    let said = String::from_utf8(out.stderr).unwrap();
    assert!(said.starts_with("strahl: 1 ray, 1 hit, "), "{said}");
    assert!(said.contains("; list with boxes ("), "{said}");
    assert_eq!(folder.names(), ["hits.csv", "scene.nff", "things.toml"]);
}

#[test]
fn files_that_cannot_be_read_or_written_are_reported() {
    let folder = things();
    folder.write("rays.csv", "0,0,4,0,0,-1\n");
    folder.run("cast missing.toml --rays rays.csv").failed(66, "missing.toml");
    folder.run("cast things.toml --rays missing.csv").failed(66, "cannot read missing.csv");
    folder.run("cast things.toml --rays .").failed(66, "cannot read .");
    folder.run("cast things.toml --rays rays.csv -o missing/hits.csv").failed(74, "missing/hits.csv");
    folder.run("cast things.toml --rays rays.csv -o rays.csv").failed(2, "would overwrite");
    folder.run("cast things.toml --rays rays.csv -o things.toml").failed(2, "would overwrite");
    folder.run("cast things.toml --threads 0").failed(2, "1 to 1024");
    folder.run("cast things.toml --accel tree").failed(2, "tree");
    folder.run("cast things.toml --precision half").failed(2, "half");
    folder.write("wrong.toml", "[[sphere]]\nradius = -1\n");
    folder.run("cast wrong.toml --rays rays.csv").failed(65, "wrong.toml");
}

/// The program with pipes at its ends.
fn piped(folder: &Folder, words: &str) -> std::process::Child {
    let mut command: Command = folder.command(words);
    command.stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap()
}

#[test]
fn who_writes_a_line_and_waits_is_answered() {
    let folder = things();
    let mut child = piped(&folder, "cast things.toml -q");
    let (mut rays, mut hits) = (child.stdin.take().unwrap(), BufReader::new(child.stdout.take().unwrap()));
    for (line, row) in [
        ("0,0,4,0,0,-1\n", "1,3,1,0,0,1,0,0,1\n"),
        ("0,0,5,0,0,-1\n0,0,", "1,4,1,0,0,1,0,0,1\n"),
        ("6,0,0,-1\n", "1,5,1,0,0,1,0,0,1\n"),
    ] {
        rays.write_all(line.as_bytes()).unwrap();
        let mut answer = String::new();
        hits.read_line(&mut answer).unwrap();
        assert_eq!(answer, row);
    }
    // A wrong line ends it, though more could come.
    rays.write_all(b"what?\n").unwrap();
    let ended = Running::of(child).end();
    assert_eq!(ended.code(), Some(65));
    drop(rays);
}

#[cfg(unix)]
#[test]
fn hits_that_nobody_reads_end_it_with_status_74() {
    let folder = things();
    let mut child = piped(&folder, "cast things.toml -q");
    drop(child.stdout.take());
    let (mut rays, mut said) = (child.stdin.take().unwrap(), child.stderr.take().unwrap());
    // Rays without end; the program ends, and then they cannot be written either.
    while rays.write_all(b"0,0,4,0,0,-1\n").is_ok() {}
    assert_eq!(Running::of(child).end().code(), Some(74));
    let mut text = String::new();
    said.read_to_string(&mut text).unwrap();
    assert!(text.starts_with("strahl: cannot write to the standard output: "), "{text}");
}
