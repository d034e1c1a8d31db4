//! Aliases of keys: names of other programs that are accepted.

use crate::text::{errors, loaded};

/// The text of a scene with `KEY` in place of a key, the key, and an alias of it.
const ALIASES: &[(&str, &str, &str)] = &[
    ("[camera]\nKEY = [1, 2, 3]\n", "from", "position"),
    ("[camera]\nKEY = [1, 2, 3]\n", "from", "eye"),
    ("[camera]\nKEY = [1, 2, 3]\n", "at", "look_at"),
    ("[camera]\nKEY = 30\n", "angle", "fov"),
    ("[camera]\nlens_radius = 0.1\nKEY = 2\n", "focus", "focus_distance"),
    ("[camera]\nlens_radius = 0.1\nKEY = 2\n", "focus", "focal_distance"),
    ("[render]\nKEY = 7\n", "levels", "max_depth"),
    ("[[spot_light]]\nposition = [0, 5, 0]\nKEY = [1, 0, 0]\n", "at", "look_at"),
    ("[[rectangle_light]]\nposition = [0, 5, 0]\nsize = 1\nKEY = [1, 0, 0]\n", "at", "look_at"),
    ("[[sphere]]\nradius = 1\nmaterial = { KEY = 0.5 }\n", "mirror", "reflection"),
    ("[[sphere]]\nradius = 1\nmaterial = { KEY = 0.5 }\n", "mirror", "reflectivity"),
    ("[[sphere]]\nradius = 1\nmaterial = { transmission = 1, KEY = 1.3 }\n", "index", "ior"),
    ("[[sphere]]\nradius = 1\nmaterial = { transmission = 1, KEY = 2 }\n", "clarity", "attenuation_distance"),
];

#[test]
fn an_alias_loads_the_same_scene_as_its_key() {
    let without = loaded("[[sphere]]\nradius = 1\n");
    for (text, key, alias) in ALIASES {
        let scene = loaded(&text.replace("KEY", key));
        assert_eq!(loaded(&text.replace("KEY", alias)), scene, "{alias}");
        assert_ne!(scene, without, "{key}");
    }
}

#[test]
fn every_alias_of_the_schema_is_tested() {
    let schema: serde_json::Value = serde_json::from_str(&strahl_scene::toml_scene::schema()).unwrap();
    for (name, table) in schema["$defs"].as_object().unwrap() {
        for (alias, property) in table["properties"].as_object().into_iter().flatten() {
            let is_alias = property["description"].as_str().is_some_and(|text| text.starts_with("Alias of "));
            // The alias of `[[mesh]]` is tested with mesh files.
            let is_tested = name == "Mesh" || ALIASES.iter().any(|(_, _, tested)| tested == alias);
            assert!(!is_alias || is_tested, "{alias} of {name}");
        }
    }
}

#[test]
fn a_key_and_its_alias_together_are_an_error() {
    let errors = errors("[camera]\neye = [1, 2, 3]\nfrom = [1, 2, 3]\nposition = [0, 0, 9]\n");
    let found: Vec<_> = errors.iter().map(|(line, _, marked, text)| (*line, &**marked, &**text)).collect();
    assert_eq!(
        found,
        [
            (3, "from", "`from` and `eye` are the same key\n"),
            (4, "position", "`position` and `eye` are the same key\n")
        ]
    );
}

#[test]
fn errors_name_a_key_as_it_is_written() {
    let [(.., text)] = &errors("[camera]\nfov = 200\n")[..] else { panic!("not one error") };
    assert!(text.contains("`fov` must be"), "{text}");
    let [(.., text)] = &errors("[render]\nmax_depth = 65\n")[..] else { panic!("not one error") };
    assert!(text.contains("`max_depth` must be an integer from 1 to 64"), "{text}");
}
