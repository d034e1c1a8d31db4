//! Nothing that was read is written over, by any command, under any name.

use std::fs;

use crate::program::{EMPTY, Folder};

const MODEL: &str = "mtllib model.mtl\nusemtl wood\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
const LIBRARY: &str = "newmtl wood\nKd 1 1 1\nmap_Kd -s 1 1 1 model.png\nbump my bumps.png\n";
const SCENE: &str = "[[mesh]]\nfile = \"model.obj\"\n";
const PART: &str = r#"{"asset": {"version": "2.0"}, "buffers": [{"byteLength": 36, "uri": "part.png"}],
    "bufferViews": [{"buffer": 0, "byteLength": 36}], "nodes": [{"mesh": 0}],
    "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"}],
    "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}], "scenes": [{"nodes": [0]}],
    "images": [{"uri": "my%20wood.png"}, {"uri": "data:,"}, {"bufferView": 0}]}"#;
const CORNERS: [f32; 9] = [0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0];
const DEVICE: &str = "scene,width,height,precision,levels,cutoff,sampler,instructions,rays,rmse\nscene,4,3,single,5,0,single,1,1,\n";

/// A folder with inputs of every kind.
fn inputs() -> Folder {
    let folder = Folder::with(EMPTY);
    folder.write("scene.toml", SCENE);
    folder.write("model.obj", MODEL);
    folder.write("model.mtl", LIBRARY);
    folder.write("model.png", "wood");
    folder.write("rays.csv", "0,0,1,0,0,-1\n");
    folder.write("part.gltf", PART);
    folder.write("part.png", CORNERS.map(f32::to_le_bytes).concat());
    folder.write("my wood.png", "wood");
    fs::create_dir(folder.path("scene-study")).unwrap();
    folder.write("scene-study/study.csv", DEVICE);
    folder.done("render scene.nff -q -o mask.png");
    folder.done("render scene.nff -q -o other.png");
    folder
}

/// Everything that stands in a folder, and in the folders in it.
fn contents(folder: &Folder) -> Vec<(String, Vec<u8>)> {
    let names = folder.names().into_iter().filter(|name| folder.path(name).is_file());
    names.chain(["scene-study/study.csv".into()]).map(|name| (name.clone(), folder.read(&name))).collect()
}

#[test]
fn no_command_writes_over_what_it_reads() {
    let folder = inputs();
    let before = contents(&folder);
    for (words, input) in [
        ("render scene.toml --stats-file scene.toml", "scene.toml"),
        ("render scene.toml --stats-file model.obj", "model.obj"),
        ("render scene.toml --stats-file model.mtl", "model.mtl"),
        ("render scene.toml -o model.png", "model.png"),
        ("render scene.toml -o a.png --cost model.png", "model.png"),
        ("render scene.nff -o mask.png --mask mask.png", "mask.png"),
        ("render scene.nff -o a.png --mask mask.png --cost ./mask.png", "mask.png"),
        ("render scene.nff --mask mask.png --stats-file scene-study/../mask.png", "mask.png"),
        // The name that the picture has when nobody names one.
        ("render model.obj", "model.png"),
        ("render part.gltf", "part.png"),
        ("watch scene.toml -o model.png", "model.png"),
        ("watch scene.nff -o mask.png --mask mask.png", "mask.png"),
        ("bake scene.toml -o model.obj", "model.obj"),
        ("bake scene.toml -o model.mtl", "model.mtl"),
        ("bake scene.toml -o scene.toml", "scene.toml"),
        ("cast scene.toml --rays rays.csv -o model.obj", "model.obj"),
        ("cast scene.toml --rays rays.csv -o rays.csv", "rays.csv"),
        ("explain scene.toml 1,1 --svg model.obj", "model.obj"),
        ("compare mask.png other.png -o mask.png", "mask.png"),
        ("compare mask.png other.png -o ./other.png", "other.png"),
        ("study scene.nff --device scene-study/study.csv", "scene-study/study.csv"),
    ] {
        let ran = folder.run(words);
        ran.failed(2, &format!(" would overwrite the input {input}; choose another output"));
        assert_eq!(contents(&folder), before, "{words}");
    }
}

#[test]
fn textures_are_guarded_although_they_are_not_read() {
    let folder = inputs();
    let picture = |scene: &str, output: &str| {
        let mut command = folder.command(&format!("render {scene} -q -o"));
        command.arg(output).output().unwrap().status.code()
    };
    assert_eq!(picture("model.obj", "my bumps.png"), Some(2));
    assert_eq!(picture("model.obj", "my own.png"), Some(0));
    assert_eq!(picture("part.gltf", "my wood.png"), Some(2));
    assert_eq!(folder.read("my wood.png"), b"wood");
}

#[cfg(unix)]
#[test]
fn an_input_is_known_under_all_of_its_names() {
    use std::os::unix::fs::symlink;
    let folder = inputs();
    symlink("scene.toml", folder.path("link.png")).unwrap();
    symlink("link.png", folder.path("link of link.png")).unwrap();
    fs::hard_link(folder.path("scene.toml"), folder.path("hard.png")).unwrap();
    symlink(".", folder.path("here")).unwrap();
    let before = contents(&folder);
    for words in [
        "render scene.toml -o link.png",
        "render scene.toml -o here/link.png",
        "render scene.toml -o hard.png",
        "render here/here/scene.toml -o link.png",
        "watch scene.toml -o hard.png",
    ] {
        folder.run(words).failed(2, "scene.toml; choose another output");
        assert_eq!(contents(&folder), before, "{words}");
    }
}

#[cfg(unix)]
#[test]
fn what_comes_by_the_standard_input_is_not_written_over() {
    let folder = inputs();
    let rays = fs::File::open(folder.path("rays.csv")).unwrap();
    let ended = folder.command("cast scene.toml -o rays.csv").stdin(rays).output().unwrap();
    let said = String::from_utf8(ended.stderr).unwrap();
    assert_eq!(ended.status.code(), Some(2), "{said}");
    assert!(said.contains("rays.csv would overwrite the input <stdin>"), "{said}");
    assert_eq!(folder.read("rays.csv"), b"0,0,1,0,0,-1\n");
}

#[test]
fn no_output_writes_over_another() {
    let folder = inputs();
    let before = contents(&folder);
    for words in [
        "render scene.nff -o a.png --stats-file a.png",
        "render scene.nff -o a.png --stats-file ./a.png",
        "render scene.nff -o a.png --cost a.png",
        "render scene.nff -o a.png --cost b.png --stats-file b.png",
        "generate knot -o a.ply --format toml",
    ] {
        folder.run(words).failed(2, " would overwrite the output ");
        assert_eq!(contents(&folder), before, "{words}");
    }
}

#[cfg(unix)]
#[test]
fn a_device_may_be_both_read_and_written() {
    let folder = inputs();
    folder.done("cast scene.toml --rays /dev/null -o /dev/null");
}
