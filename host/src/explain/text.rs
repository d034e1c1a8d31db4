//! The ray tree as indented text.

use std::fmt::Write as _;

use strahl_scene::description::Float3;
use strahl_session::explain::tree::{
    HitRecord, ItemRecord, LightRecord, NameAndLine, PixelExplanation, RayRecord, SampleRecord, SampleSum,
    SecondaryRayRecord, SubpixelRecord, explained_settings,
};

/// Indent of wrapped lines.
pub const INDENT: usize = 12;

/// The whole explanation, or that of one sample.
pub fn text(explained: &PixelExplanation, only: Option<usize>) -> String {
    let PixelExplanation {
        scene, width, height, x, y, settings, color, srgb: [r, g, b], sum, samples, ..
    } = explained;
    let mut text = format!("{scene}: pixel {x},{y} of {width}x{height}\n");
    // Writing to a string cannot fail.
    let _ = writeln!(text, "  color     {}, in sRGB {r} {g} {b}", channels(*color));
    let words = explained_settings()
        .filter_map(|setting| Some(format!("{} {}", setting.name, setting.word(settings)?)));
    let _ = writeln!(text, "  settings  {}", words.collect::<Vec<_>>().join(", "));
    for sample in samples.iter().filter(|sample| only.is_none_or(|only| sample.number == only)) {
        let SampleRecord { number, x, y, color, .. } = sample;
        let _ = match samples.len() {
            1 => writeln!(text, "\nfilm position {x},{y}"),
            count => writeln!(text, "\nsample {number} of {count}, film position {x},{y}"),
        };
        TreeWriter { text: &mut text, sample }.ray(0, "", "");
        let _ = writeln!(text, "sum of the rays, in this order: {}", channels(*color));
    }
    let _ = write!(text, "\n{}", sum_text(sum, samples.len(), *color));
    text
}

/// How the samples are combined.
fn sum_text(sum: &SampleSum, count: usize, color: Float3) -> String {
    let color = channels(color);
    match sum {
        SampleSum::Mean { .. } if count == 1 => format!("the pixel is this sample: {color}\n"),
        SampleSum::Mean { share } => format!("the pixel is the sum of the samples times {share}: {color}\n"),
        SampleSum::Parts(parts) => {
            let mut text = String::from(
                "the pixel is the weighted sum of its subpixels, each the mean of four samples:\n",
            );
            for SubpixelRecord { x, y, side, samples: [a, b, c, d] } in parts {
                let _ = writeln!(text, "  samples {a} {b} {c} {d} weight {}  (at {x},{y})", side * side);
            }
            let _ = writeln!(text, "  total {color}");
            text
        }
    }
}

struct TreeWriter<'t> {
    text: &'t mut String,
    sample: &'t SampleRecord,
}

impl TreeWriter<'_> {
    /// A ray and its secondary rays: the first line begins with `first`, the others with `rest`.
    fn ray(&mut self, place: usize, first: &str, rest: &str) {
        let Some(ray) = self.sample.rays.get(place) else { return };
        let RayRecord { number, kind, level, weight, .. } = ray;
        let _ =
            writeln!(self.text, "{first}{kind} ray {number}, level {level}, weight {}", channels(*weight));
        let inner = if ray.is_leaf() { "    " } else { "│   " };
        for line in lines(ray) {
            let _ = writeln!(self.text, "{rest}{inner}{line}");
        }
        // The last secondary ray is traced first.
        for (place, sent) in ray.sends.iter().enumerate().rev() {
            let (branch, stem) = if place == 0 { ("└─ ", "   ") } else { ("├─ ", "│  ") };
            match sent.ray {
                Some(number) => self.ray(number - 1, &format!("{rest}{branch}"), &format!("{rest}{stem}")),
                None => {
                    let _ = writeln!(self.text, "{rest}{branch}{}", cut_line(sent));
                }
            }
        }
    }
}

/// The lines about a ray itself.
fn lines(ray: &RayRecord) -> Vec<String> {
    let mut lines = Vec::new();
    match &ray.hit {
        None => lines.push(format!("hits nothing, background {}", channels(ray.light))),
        Some(hit) => {
            lines.push(hit_line(hit));
            if hit.left != [1.0; 3] {
                let within = hit.within.as_ref().map_or("body".into(), |it| name_text("body of", it));
                let (left, weight) = (channels(hit.left), channels(ray.weight_there));
                lines.push(format!("attenuation in the {within}: {left}, weight {weight}"));
            }
            if hit.hidden {
                lines.push("surface inside a body of higher priority: ray continues unchanged".into());
            }
        }
    }
    lines.extend(ray.ambient.map(|light| format!("ambient {}", channels(light))));
    lines.extend(ray.lights.iter().map(light_line));
    if ray.total_reflection {
        lines.push("total internal reflection".into());
    }
    if ray.weight_there == [1.0; 3] {
        lines.push(format!("adds {}", channels(ray.adds)));
    } else if ray.hit.as_ref().is_none_or(|hit| !hit.hidden) {
        let (adds, weight, light) = (channels(ray.adds), channels(ray.weight_there), channels(ray.light));
        lines.push(format!("adds {adds} = {weight} * {light}"));
    }
    lines
}

fn hit_line(hit: &HitRecord) -> String {
    let side = if hit.outside { "outside" } else { "inside" };
    format!("hits {} at distance {}, from {side}", item_text(&hit.item), number(hit.distance))
}

/// An item with its line in the file.
fn item_text(item: &ItemRecord) -> String {
    let ItemRecord { object, shape, triangle, line, material } = item;
    let what = match triangle {
        Some(number) => format!("{shape} {number} of the mesh"),
        None => (*shape).to_owned(),
    };
    let place = if *line > 0 { format!("line {line}") } else { format!("object {object}") };
    let made_of = match (&material.name, material.line) {
        (None, 0) => String::new(),
        _ => format!(" of {}", name_text("material", material)),
    };
    format!("{what} ({place}){made_of}")
}

fn name_text(what: &str, NameAndLine { name, line }: &NameAndLine) -> String {
    let name = name.as_ref().map(|name| format!(" `{name}`")).unwrap_or_default();
    let place = if *line > 0 { format!(" (line {line})") } else { String::new() };
    format!("{what}{name}{place}")
}

fn light_line(light: &LightRecord) -> String {
    let name = match light.named {
        NameAndLine { name: None, line: 0 } => format!("light {}", light.number),
        _ => name_text("light", &light.named),
    };
    let through: Vec<String> = light.through.iter().map(|it| item_text(&it.item)).collect();
    let through =
        if through.is_empty() { String::new() } else { format!(", through {}", through.join(" and ")) };
    let text = match (light.outcome, &light.adds, &light.occluder) {
        ("seen", Some(adds), _) => {
            let away =
                light.distance.map(|away| format!(" at distance {}", number(away))).unwrap_or_default();
            format!("visible{away}{through}, adds {}", channels(*adds))
        }
        ("blocked", _, Some(occluder)) => {
            format!(
                "occluded by {} at distance {}{through}",
                item_text(&occluder.item),
                number(occluder.distance)
            )
        }
        ("blocked", ..) => format!("occluded{through}"),
        ("behind", ..) => "the surface faces away".into(),
        ("dark", ..) => "no light arrives here".into(),
        _ => "its highlight is in another direction".into(),
    };
    format!("{name}: {text}")
}

fn cut_line(sent: &SecondaryRayRecord) -> String {
    let reason = match sent.cut {
        Some("levels") => "last level reached",
        _ => "weight is not above the cutoff",
    };
    format!("{} ray not traced, weight {}: {reason}", sent.kind, channels(sent.weight))
}

/// Red, green and blue, or one number for all three.
pub fn channels(color: Float3) -> String {
    let [r, g, b] = color;
    if r == g && g == b { number(r) } else { color.map(number).join(" ") }
}

/// A number in the shortest form that reads back exactly; with an exponent where that is much shorter.
fn number(x: f32) -> String {
    let magnitude = x.abs();
    let has_many_zeros = magnitude != 0.0 && (magnitude < 1e-5 || magnitude >= 1e9);
    if has_many_zeros && x.is_finite() { format!("{x:e}") } else { x.to_string() }
}

#[cfg(test)]
mod tests {
    use super::{channels, number};

    #[test]
    fn a_number_of_many_zeros_has_an_exponent_and_reads_back() {
        let numbers = [5.197_357e-39, -2e-6, 1e-5, 0.25, 0.0, 123_456_790.0, 3e20, f32::MAX];
        let texts = ["5.197357e-39", "-2e-6", "0.00001", "0.25", "0", "123456790", "3e20", "3.4028235e38"];
        assert_eq!(numbers.map(number), texts);
        assert_eq!(numbers.map(|x| number(x).parse::<f32>().unwrap()), numbers);
        assert_eq!(number(f32::INFINITY), "inf");
        assert_eq!(channels([1e-20, 0.5, 0.0]), "1e-20 0.5 0");
        assert_eq!(channels([1e-20; 3]), "1e-20");
    }
}
