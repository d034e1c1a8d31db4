//! What somebody may have meant who wrote another word.

use strsim::damerau_levenshtein;

use crate::quote::quoted;

/// Words of other programs, and ours for the same.
const HINTS: &[(&str, &str)] = &[
    ("background_color", "background"),
    ("capped", "open"),
    ("closed", "open"),
    ("cube", "box"),
    ("cuboid", "box"),
    ("donut", "torus"),
    ("eye", "from"),
    ("exponent", "shininess"),
    ("field_of_view", "angle"),
    ("file_name", "file"),
    ("floor", "plane"),
    ("fov", "angle"),
    ("aperture", "lens_radius"),
    ("area_light", "rectangle_light"),
    ("focal_distance", "focus"),
    ("focus_distance", "focus"),
    ("glossiness", "shininess"),
    ("gloss", "highlight"),
    ("ground", "plane"),
    ("interior", "clarity"),
    ("absorption", "clarity"),
    ("ior", "index"),
    ("look_at", "at"),
    ("major", "radius"),
    ("max_depth", "levels"),
    ("depth", "levels"),
    ("minor", "tube"),
    ("model", "mesh"),
    ("opacity", "transmission"),
    ("path", "file"),
    ("pos", "position"),
    ("reflection", "mirror"),
    ("reflectivity", "mirror"),
    ("refraction", "transmission"),
    ("resolution", "size"),
    ("rotation", "rotate"),
    ("samples", "sampler"),
    ("settings", "render"),
    ("sky", "background"),
    ("specular", "highlight"),
    ("speed", "velocity"),
    ("motion", "velocity"),
    ("exposure", "shutter"),
    ("sun", "directional_light"),
    ("target", "at"),
    ("texture", "checker or gradient"),
    ("translation", "translate"),
    ("transparency", "transmission"),
    ("vertices", "corners"),
    ("points", "corners"),
    ("view", "camera"),
    ("viewpoint", "camera"),
    ("light", "point_light, directional_light or spot_light"),
    ("lights", "point_light, directional_light or spot_light"),
    ("ambient", "ambient_light"),
];

/// Which of the words somebody may have meant, as it stands in advice.
pub fn suggestion<'w>(word: &str, words: &[&'w str]) -> Option<String> {
    let word: String = word.to_lowercase().chars().take(40).collect();
    let ours = HINTS.iter().filter(|(theirs, _)| *theirs == word).map(|(_, ours)| *ours);
    // Some of ours are several, of which the first decides.
    let first = |ours: &str| ours.split([',', ' ']).next().unwrap_or_default().to_owned();
    if let Some(ours) = ours.into_iter().find(|ours| words.contains(&first(ours).as_str())) {
        return Some(ours.split(' ').map(quoted_list_word).collect::<Vec<_>>().join(" "));
    }
    let near = |other: &&'w str| {
        if other.len() > 60 {
            return None;
        }
        let distance = damerau_levenshtein(&word, &other.to_lowercase());
        (distance <= (other.chars().count() / 3).max(1)).then_some((distance, *other))
    };
    let nearest = words.iter().filter_map(near).min_by_key(|(distance, _)| *distance);
    nearest.map(|(_, other)| quoted(other))
}

/// A word of an advice, without the comma and the `or` between them.
fn quoted_list_word(word: &str) -> String {
    match word {
        "or" => word.into(),
        _ => match word.strip_suffix(',') {
            Some(word) => format!("`{word}`,"),
            None => format!("`{word}`"),
        },
    }
}

#[cfg(test)]
mod tests {
    use super::suggestion;

    #[test]
    fn slips_and_words_of_other_programs_are_understood() {
        let keys = ["color", "center", "index", "mirror", "checker", "gradient"];
        for (word, ours) in [
            ("colour", "`color`"),
            ("Color", "`color`"),
            ("centre", "`center`"),
            ("ior", "`index`"),
            ("reflection", "`mirror`"),
            ("texture", "`checker` or `gradient`"),
        ] {
            assert_eq!(suggestion(word, &keys).as_deref(), Some(ours), "{word}");
        }
        for word in ["", "x", "radius", "sun"] {
            assert_eq!(suggestion(word, &keys), None, "{word}");
        }
        assert_eq!(
            suggestion("light", &["point_light", "sphere"]).as_deref(),
            Some("`point_light`, `directional_light` or `spot_light`")
        );
    }
}
