//! The scenes of the repository, their schema and their description.

use std::path::{Path, PathBuf};

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../scenes")
}

#[test]
fn the_schema_in_the_repository_is_current() {
    let path = folder().join("strahl.schema.json");
    let schema = strahl_scene::toml_scene::schema();
    if std::env::var_os("STRAHL_ACCEPT").is_some() {
        std::fs::write(&path, &schema).unwrap();
    }
    let stored = std::fs::read_to_string(&path).unwrap_or_default();
    assert!(stored == schema, "write it anew with STRAHL_ACCEPT=1");
}

#[test]
fn the_schema_knows_every_table_of_the_format() {
    let schema: serde_json::Value = serde_json::from_str(&strahl_scene::toml_scene::schema()).unwrap();
    let tables = schema["properties"].as_object().unwrap();
    assert_eq!(tables.len(), 20);
    assert!(schema.get("required").is_none());
    let sphere = &schema["$defs"]["Sphere"];
    assert_eq!(sphere["required"], serde_json::json!(["radius"]));
    assert_eq!(sphere["additionalProperties"], false);
    assert_eq!(sphere["properties"]["radius"]["exclusiveMinimum"], 0);
    assert_eq!(tables["box"]["items"]["$ref"], "#/$defs/Box");
}

#[test]
fn the_description_of_the_format_names_every_table_and_key() {
    let text = std::fs::read_to_string(folder().join("FORMAT.md")).unwrap();
    let schema: serde_json::Value = serde_json::from_str(&strahl_scene::toml_scene::schema()).unwrap();
    for name in schema["properties"].as_object().unwrap().keys() {
        assert!(text.contains(&format!("[{name}]")), "[{name}]");
    }
    for table in schema["$defs"].as_object().unwrap().values() {
        for key in table["properties"].as_object().into_iter().flat_map(|keys| keys.keys()) {
            assert!(text.contains(&format!("`{key}`")), "`{key}`");
        }
    }
}

#[test]
fn every_scene_of_the_repository_loads() {
    let mut scenes = 0;
    for entry in std::fs::read_dir(folder()).unwrap() {
        let path = entry.unwrap().path();
        if path.extension().is_some_and(|extension| extension == "toml") {
            let it = strahl_scene::load(&path).unwrap_or_else(|failure| panic!("{failure}"));
            assert!(strahl_session::tables::single::scene_tables(&it).scene().is_ok());
            assert!(!it.objects.is_empty() && it.warnings.is_empty(), "{:?}", it.warnings);
            scenes += 1;
        }
    }
    assert!(scenes > 0);
}

#[test]
fn every_scene_in_the_description_of_the_format_loads() {
    let text = std::fs::read_to_string(folder().join("FORMAT.md")).unwrap();
    let examples: Vec<&str> =
        text.split("```toml\n").skip(1).filter_map(|part| part.split("```").next()).collect();
    assert!(examples.len() > 5);
    for example in examples.iter().filter(|example| !example.contains("file = ")) {
        crate::text::loaded(example);
    }
}
