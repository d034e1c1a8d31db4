//! The models and the generated scenes in `scenes/` equal the output of their generators.

use std::fs;
use std::path::{Path, PathBuf};

use strahl::args::GenerateArgs;
use strahl_scene::procedural::{ProceduralScene, SceneFormat};
use strahl_tests::models;

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).parent().unwrap().to_owned()
}

fn text(name: &str) -> String {
    fs::read_to_string(root().join(name)).unwrap_or_else(|error| panic!("{name}: {error}"))
}

#[test]
fn the_models_of_revolution_equal_the_output_of_their_example() {
    for (name, bytes) in models::files() {
        assert!(fs::read(root().join("scenes/models").join(&name)).unwrap() == bytes, "{name}");
    }
}

/// The bytes that `strahl generate` writes into a file of this name.
fn generated(scene: ProceduralScene, size: u32, name: &str, bare: bool) -> Vec<u8> {
    let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    let (output, format) = (Some(path.clone()), None::<SceneFormat>);
    let args = GenerateArgs { scene, size: Some(size), output, format, bare, quiet: true };
    strahl::generate::run(&args).unwrap();
    fs::read(path).unwrap()
}

#[test]
fn the_generated_models_equal_the_output_of_generate() {
    for (scene, size, name) in [
        (ProceduralScene::Knot, 5000, "knot.ply"),
        (ProceduralScene::Tetra, 6, "tetra.ply"),
        (ProceduralScene::Mountain, 6, "mountain.ply"),
    ] {
        let model = fs::read(root().join("scenes/models").join(name)).unwrap();
        assert!(model == generated(scene, size, name, false), "{name}");
    }
}

#[test]
fn the_sphereflake_has_the_spheres_of_generate() {
    let generated =
        String::from_utf8(generated(ProceduralScene::Sphereflake, 3, "flake.toml", true)).unwrap();
    let spheres = &generated[generated.find("[[sphere]]").unwrap()..];
    assert_eq!(spheres.matches("[[sphere]]").count(), 820);
    assert!(text("scenes/sphereflake.toml").ends_with(spheres));
}
