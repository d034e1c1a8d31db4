//! Numbers with nouns, for messages: `1 region`, `2,048 boxes`.

/// A number with grouped thousands, and its noun, which is given in the singular.
pub fn quantity(number: impl TryInto<u64>, noun: &str) -> String {
    // No count exceeds it.
    let number = number.try_into().unwrap_or(u64::MAX);
    format!("{} {}", grouped(number), plural(number, noun))
}

/// A number with grouped thousands.
pub fn grouped(number: u64) -> String {
    let digits = number.to_string();
    let is_apart = |index: usize| index > 0 && (digits.len() - index).is_multiple_of(3);
    let apart =
        digits.char_indices().flat_map(|(index, digit)| [is_apart(index).then_some(','), Some(digit)]);
    apart.flatten().collect()
}

/// The noun in the singular for 1, and in the plural otherwise.
pub fn plural(number: u64, noun: &str) -> String {
    let with = |ending: &str, plural: &str| Some(noun.strip_suffix(ending)?.to_owned() + plural);
    if number == 1 {
        return noun.to_owned();
    }
    let irregular = with("us", "i").or_else(|| with("ss", "sses")).or_else(|| with("x", "xes"));
    irregular.or_else(|| with("ry", "ries")).unwrap_or_else(|| noun.to_owned() + "s")
}

#[cfg(test)]
mod tests {
    use strahl_core::geometry::ShapeKind;

    use super::*;

    #[test]
    fn one_is_in_the_singular_and_everything_else_in_the_plural() {
        assert_eq!(
            [0, 1, 2, 307_200].map(|n: u64| quantity(n, "ray")),
            ["0 rays", "1 ray", "2 rays", "307,200 rays"]
        );
        let nouns = ["pass", "box", "entry", "torus", "smooth triangle", "texture"];
        let plurals = ["passes", "boxes", "entries", "tori", "smooth triangles", "textures"];
        assert_eq!(nouns.map(|noun| plural(2, noun)), plurals);
        assert_eq!(nouns.map(|noun| plural(1, noun)), nouns);
    }

    #[test]
    fn shapes_have_plurals() {
        let plurals = ShapeKind::ALL.map(|kind| plural(2, kind.name()));
        assert_eq!(
            plurals,
            [
                "spheres",
                "triangles",
                "smooth triangles",
                "planes",
                "discs",
                "polygons",
                "boxes",
                "oriented boxes",
                "cones",
                "tori"
            ]
        );
    }
}
