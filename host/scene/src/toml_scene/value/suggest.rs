//! Suggestions for unknown keys and names.

use strsim::damerau_levenshtein;

use super::hints::HINTS;
use crate::quote::quoted;

/// The keys of `table` that an unknown key probably means, with a remark if needed: a sentence for an error message.
///
/// Searched in this order: the same word with other separators (`lookAt` for `look_at`), [`HINTS`] for keys of other
/// programs, and the key with the smallest edit distance.
pub fn key_suggestion(table: &str, word: &str, keys: &[&str], aliases: &[(&str, &str)]) -> Option<String> {
    let normal = normalized(word);
    let same = keys.iter().find(|key| normalized(key) == normal).copied();
    let same_alias = || aliases.iter().find(|(alias, _)| normalized(alias) == normal).map(|(_, key)| *key);
    if let Some(key) = same.or_else(same_alias) {
        return Some(did_you_mean(&quoted(key)));
    }
    let applies =
        |words: &str, tables: &[&str]| tables.contains(&table) && words.split(' ').any(|it| it == normal);
    for hint in HINTS.iter().filter(|hint| applies(hint.words, hint.tables)) {
        let meant: Vec<String> =
            hint.keys.split(' ').filter(|key| keys.contains(key)).map(|key| format!("`{key}`")).collect();
        let question = match meant.split_last() {
            Some((last, [])) => did_you_mean(last),
            Some((last, others)) => did_you_mean(&format!("{} or {last}", others.join(", "))),
            None if hint.keys.is_empty() => String::new(),
            None => continue,
        };
        return Some(format!("{question} {}", hint.note).trim().to_owned());
    }
    suggestion(word, keys).map(|key| did_you_mean(&key))
}

/// The name with the smallest edit distance, quoted; `None` if all names differ too much.
pub fn suggestion(word: &str, names: &[&str]) -> Option<String> {
    let word: String = word.to_lowercase().chars().take(40).collect();
    let near = |other: &&str| {
        if other.len() > 60 {
            return None;
        }
        let distance = damerau_levenshtein(&word, &other.to_lowercase());
        (distance <= (other.chars().count() / 3).max(1)).then_some((distance, quoted(other)))
    };
    names.iter().filter_map(near).min_by_key(|(distance, _)| *distance).map(|(_, other)| other)
}

/// The word in lower case, without separators, truncated to 40 characters.
pub fn normalized(word: &str) -> String {
    word.to_lowercase().chars().filter(|c| !matches!(c, '_' | '-' | ' ')).take(40).collect()
}

fn did_you_mean(keys: &str) -> String {
    format!("did you mean {keys}?")
}

#[cfg(test)]
mod tests {
    use super::*;

    const KEYS: &[&str] = &["color", "highlight", "mirror", "index", "checker", "gradient", "transmission"];

    fn for_material(word: &str) -> Option<String> {
        key_suggestion("material", word, KEYS, &[("ior", "index")])
    }

    #[test]
    fn misspelled_keys_have_a_suggestion() {
        for word in ["colour", "Color", "colr"] {
            assert_eq!(for_material(word).as_deref(), Some("did you mean `color`?"), "{word}");
        }
        for word in ["", "x", "radius", "sun"] {
            assert_eq!(for_material(word), None, "{word}");
        }
        assert_eq!(suggestion("centre", &["center", "radius"]).as_deref(), Some("`center`"));
    }

    #[test]
    fn keys_of_other_programs_have_a_suggestion_in_their_table_only() {
        for (word, expected) in [
            ("IOR", "did you mean `index`?"),
            ("base_color", "did you mean `color`?"),
            ("baseColor", "did you mean `color`?"),
            ("texture", "did you mean `checker` or `gradient`?"),
            ("opacity", "did you mean `transmission`? It is 1 - opacity."),
            ("emission", "Objects do not emit light: add a light."),
        ] {
            assert_eq!(for_material(word).as_deref(), Some(expected), "{word}");
        }
        assert_eq!(key_suggestion("point_light", "opacity", KEYS, &[]), None);
    }

    #[test]
    fn words_of_hints_are_normalized() {
        for word in HINTS.iter().flat_map(|hint| hint.words.split(' ')) {
            assert_eq!(normalized(word), word);
        }
    }
}
