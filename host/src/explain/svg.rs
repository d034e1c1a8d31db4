//! The ray tree as SVG: the camera at the top, and a box for each ray with its hit and the visible lights, above
//! the boxes of its secondary rays.

use std::fmt::Write as _;

use strahl_core::Rgb;
use strahl_scene::quantity::quantity;

use strahl_scene::description::Float3;
use strahl_session::explain::tree::{
    LightRecord, NameAndLine, PixelExplanation, RayRecord, SampleRecord, SecondaryRayRecord,
};

/// Width of a box.
const WIDTH: f64 = 222.0;
/// Width of a ray that was not traced.
const STUB: f64 = 92.0;
/// Horizontal distance of boxes.
const GAP: f64 = 18.0;
/// Vertical distance of the boxes of a ray and of its secondary rays.
const DROP: f64 = 64.0;
/// Width of the legend.
const LEGEND: f64 = 660.0;
/// Height of a row of text.
const ROW: f64 = 17.0;
/// Margin.
const MARGIN: f64 = 24.0;
/// Below the title.
const TOP: f64 = 92.0;
/// The characters of a row.
const CHARACTERS: usize = 33;
/// Maximum number of listed lights.
const LIGHTS: usize = 6;

const STYLE: &str = "\
svg { font: 12px ui-sans-serif, system-ui, 'Segoe UI', 'DejaVu Sans', sans-serif; background: #fff }
text { fill: #1c1c1c } .title { font-size: 15px; font-weight: 600 } .dim { fill: #5c5c5c }
.box { fill: #f6f6f4; stroke: #8a8a86 } .sky { fill: #eef3f8; stroke-dasharray: 3 3 }
.swatch { stroke: #00000055 } .bold { font-weight: 600 }
.ray { fill: none; stroke-width: 2 } .camera { stroke: #555 } .reflected { stroke: #1f6fb2 }
.transmitted { stroke: #2b8a3e } .cut { stroke-dasharray: 4 4 }
.on { fill: #f2b705; stroke: #9c7400 } .off { fill: none; stroke: #8a8a86 } .bar { stroke: #8a8a86 }
@media (prefers-color-scheme: dark) {
svg { background: #1b1c1e } text { fill: #ececea } .dim { fill: #a5a5a1 }
.box { fill: #26282b; stroke: #6d6f72 } .sky { fill: #222a33 } .swatch { stroke: #ffffff55 }
.camera { stroke: #aaa } .reflected { stroke: #6ab0ea } .transmitted { stroke: #6cc781 }
}";

/// The picture of one sample's tree.
pub fn picture(explained: &PixelExplanation, sample: &SampleRecord) -> String {
    let mut tree =
        TreeDrawing { sample, layouts: vec![BoxLayout::default(); sample.rays.len()], body: String::new() };
    let width = tree.width(0);
    let (title, sub) = titles(explained, sample);
    let whole = (width + 2.0 * MARGIN).max(LEGEND).max(9.0 * title.chars().count() as f64 + 2.0 * MARGIN);
    let left = (whole - width) / 2.0;
    let bottom = tree.draw(0, left, TOP + DROP);
    let height = bottom + MARGIN;

    let mut svg = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{whole:.0}\" height=\"{height:.0}\" \
         viewBox=\"0 0 {whole:.0} {height:.0}\" role=\"img\">\n<title>{}</title>\n<style>{STYLE}</style>\n",
        escaped(&title)
    );
    // Writing to a string cannot fail.
    let _ = writeln!(svg, "<text class=\"title\" x=\"{MARGIN}\" y=\"30\">{}</text>", escaped(&title));
    let _ = writeln!(svg, "<text class=\"dim\" x=\"{MARGIN}\" y=\"50\">{}</text>", escaped(&sub));
    legend(&mut svg);
    if let Some(layout) = tree.layouts.first() {
        let (x, y) = (layout.center, TOP);
        // The camera.
        let _ = writeln!(
            svg,
            "<path class=\"ray camera\" d=\"M{x0:.1} {y:.1}Q{x:.1} {up:.1} {x1:.1} {y:.1}Q{x:.1} {down:.1} {x0:.1} \
             {y:.1}Z\"/><circle class=\"ray camera\" cx=\"{x:.1}\" cy=\"{y:.1}\" r=\"4\"/>",
            x0 = x - 16.0,
            x1 = x + 16.0,
            up = y - 18.0,
            down = y + 18.0,
        );
        edge(&mut svg, "camera", "", (x, y + 9.0), (x, TOP + DROP));
    }
    svg.push_str(&tree.body);
    svg.push_str("</svg>\n");
    svg
}

fn titles(explained: &PixelExplanation, sample: &SampleRecord) -> (String, String) {
    let PixelExplanation { scene, x, y, width, height, settings, samples, .. } = explained;
    let title = format!("{scene}, pixel {x},{y} of {width}x{height}");
    let of = match samples.len() {
        1 => String::new(),
        count => format!("sample {} of {count}, ", sample.number),
    };
    let [r, g, b] = sample.color.map(short);
    let levels = quantity(settings.levels, "level");
    (title, format!("{of}at most {levels}, cutoff {}: light {r} {g} {b}", short(settings.cutoff)))
}

fn legend(svg: &mut String) {
    let mut x = MARGIN;
    for (class, name) in
        [("reflected", "reflected"), ("transmitted", "transmitted"), ("camera cut", "not traced")]
    {
        let _ = writeln!(
            svg,
            "<path class=\"ray {class}\" d=\"M{x:.1} 68h24\"/><text class=\"dim\" x=\"{:.1}\" y=\"72\">{name}</text>",
            x + 30.0
        );
        x += 52.0 + 7.0 * name.len() as f64;
    }
    for (class, bar, name) in
        [("on", false, "light visible"), ("off", true, "occluded by"), ("off", false, "no shadow ray")]
    {
        let _ = write!(svg, "<circle class=\"{class}\" cx=\"{:.1}\" cy=\"68\" r=\"4.5\"/>", x + 5.0);
        if bar {
            let _ = write!(svg, "<path class=\"bar\" d=\"M{:.1} 72.5l9 -9\"/>", x + 0.5);
        }
        let _ = writeln!(svg, "<text class=\"dim\" x=\"{:.1}\" y=\"72\">{name}</text>", x + 16.0);
        x += 38.0 + 7.0 * name.len() as f64;
    }
}

/// Position of the box of a ray.
#[derive(Clone, Copy, Default)]
struct BoxLayout {
    /// Width of its subtree.
    width: f64,
    /// Center of the box, horizontally.
    center: f64,
}

struct TreeDrawing<'s> {
    sample: &'s SampleRecord,
    layouts: Vec<BoxLayout>,
    body: String,
}

impl TreeDrawing<'_> {
    /// Computes the width of the subtree of a ray. The depth of recursion is at most the number of levels.
    fn width(&mut self, index: usize) -> f64 {
        let Some(ray) = self.sample.rays.get(index) else { return WIDTH };
        let below: f64 = ray.sends.iter().map(|sent| self.width_of(sent) + GAP).sum();
        let width = WIDTH.max(below - GAP);
        if let Some(layout) = self.layouts.get_mut(index) {
            layout.width = width;
        }
        width
    }

    fn width_of(&mut self, sent: &SecondaryRayRecord) -> f64 {
        sent.ray.map_or(STUB, |number| self.width(number - 1))
    }

    /// Draws the subtree of a ray from `left`; its lower edge.
    fn draw(&mut self, index: usize, left: f64, top: f64) -> f64 {
        let sample = self.sample;
        let (Some(ray), Some(it)) = (sample.rays.get(index), self.layouts.get(index).copied()) else {
            return top;
        };
        // The last secondary ray is traced first, and is at the left.
        let widths: Vec<f64> = ray.sends.iter().rev().map(|sent| self.width_of(sent)).collect();
        let below: f64 = widths.iter().map(|width| width + GAP).sum::<f64>() - GAP;
        let center = left + it.width / 2.0;
        if let Some(layout) = self.layouts.get_mut(index) {
            layout.center = center;
        }
        let box_bottom = self.node(ray, center, top);
        let mut bottom = box_bottom;
        let mut x = left + (it.width - below) / 2.0;
        for (sent, width) in ray.sends.iter().rev().zip(widths) {
            let (from, to) = ((center, box_bottom), (x + width / 2.0, box_bottom + DROP));
            let label = short(largest(sent.weight));
            match sent.ray {
                Some(number) => {
                    bottom = bottom.max(self.draw(number - 1, x, box_bottom + DROP));
                    edge(&mut self.body, sent.kind, &label, from, to);
                }
                None => {
                    let to = (to.0, box_bottom + 0.55 * DROP);
                    edge(&mut self.body, &format!("{} cut", sent.kind), &label, from, to);
                    let reason = sent.cut.unwrap_or_default();
                    let _ = writeln!(
                        self.body,
                        "<text class=\"dim\" text-anchor=\"middle\" x=\"{:.1}\" y=\"{:.1}\">{reason}</text>",
                        to.0,
                        to.1 + 14.0
                    );
                    bottom = bottom.max(to.1 + 18.0);
                }
            }
            x += width + GAP;
        }
        bottom
    }

    /// The box of a ray; its lower edge.
    fn node(&mut self, ray: &RayRecord, center: f64, top: f64) -> f64 {
        let (left, mut rows) = (center - WIDTH / 2.0, rows(ray));
        let hidden = ray.lights.len().saturating_sub(LIGHTS);
        let lights = &ray.lights[..ray.lights.len() - hidden];
        if hidden > 0 {
            rows.push(format!("and {hidden} more lights"));
        }
        let height = ROW * (rows.len() + lights.len() + 1) as f64 + 10.0;
        let sky = if ray.hit.is_none() { " sky" } else { "" };
        let [r, g, b] = Rgb::new(ray.adds[0], ray.adds[1], ray.adds[2]).to_srgb8();
        let _ = writeln!(
            self.body,
            "<rect class=\"box{sky}\" x=\"{left:.1}\" y=\"{top:.1}\" width=\"{WIDTH}\" height=\"{height:.1}\" rx=\"5\"/>"
        );
        let mut y = top + ROW + 1.0;
        for (index, row) in rows.iter().enumerate() {
            let class = if index == 0 { "bold" } else { "dim" };
            let (x, row) = (left + 9.0, escaped(&fitted(row)));
            let _ = writeln!(self.body, "<text class=\"{class}\" x=\"{x:.1}\" y=\"{y:.1}\">{row}</text>");
            y += ROW;
        }
        for light in lights {
            light_symbol(&mut self.body, light, left + 16.0, y - 4.0);
            y += ROW;
        }
        let adds = ray.adds.map(short).join(" ");
        let _ = writeln!(
            self.body,
            "<rect class=\"swatch\" x=\"{x:.1}\" y=\"{box_top:.1}\" width=\"12\" height=\"12\" \
             style=\"fill:rgb({r},{g},{b})\"/><text x=\"{text:.1}\" y=\"{y:.1}\">adds {adds}</text>",
            x = left + 9.0,
            box_top = y - 10.0,
            text = left + 27.0
        );
        top + height
    }
}

/// Text of the box of a ray.
fn rows(ray: &RayRecord) -> Vec<String> {
    let Some(hit) = &ray.hit else { return vec!["nothing".into(), "background".into()] };
    let thing = &hit.item;
    let place =
        if thing.line > 0 { format!("line {}", thing.line) } else { format!("object {}", thing.object) };
    let mut rows = vec![format!("{}, {place}", thing.shape)];
    let material = thing.material.name.as_ref().map(|name| format!("{name}, ")).unwrap_or_default();
    let side = if hit.outside { "outside" } else { "inside" };
    rows.push(format!("{material}distance {}, {side}", short(hit.distance)));
    if hit.left != [1.0; 3] {
        rows.push(format!("attenuation {}", hit.left.map(short).join(" ")));
    }
    if hit.hidden {
        rows.push("hidden surface".into());
    }
    if ray.total_reflection {
        rows.push("total internal reflection".into());
    }
    rows
}

/// Draws a light as a circle: filled if it is visible, struck through if it is occluded.
fn light_symbol(svg: &mut String, light: &LightRecord, x: f64, y: f64) {
    let is_visible = light.outcome == "seen";
    let class = if is_visible { "on" } else { "off" };
    let _ = write!(svg, "<circle class=\"{class}\" cx=\"{x:.1}\" cy=\"{y:.1}\" r=\"4.5\"/>");
    if light.outcome == "blocked" {
        let _ = write!(svg, "<path class=\"bar\" d=\"M{:.1} {:.1}l9 -9\"/>", x - 4.5, y + 4.5);
    }
    let name = match &light.named {
        NameAndLine { name: Some(name), .. } => name.clone(),
        NameAndLine { line: 0, .. } => format!("light {}", light.number),
        NameAndLine { line, .. } => format!("line {line}"),
    };
    let text = match (light.outcome, &light.occluder) {
        ("seen", _) if light.through.is_empty() => "visible".into(),
        ("seen", _) => "visible through glass".into(),
        ("blocked", Some(occluder)) if occluder.item.line > 0 => {
            format!("{}, line {}", occluder.item.shape, occluder.item.line)
        }
        ("blocked", Some(occluder)) => format!("{} {}", occluder.item.shape, occluder.item.object),
        ("behind", _) => "faces away".into(),
        ("dark", _) => "no light here".into(),
        ("unseen", _) => "highlight elsewhere".into(),
        (other, _) => other.into(),
    };
    let text = escaped(&fitted(&format!("{name}: {text}")));
    let _ = writeln!(svg, "<text class=\"dim\" x=\"{:.1}\" y=\"{:.1}\">{text}</text>", x + 11.0, y + 4.0);
}

/// Draws an edge between the boxes of a ray and of its secondary ray.
fn edge(svg: &mut String, class: &str, label: &str, (x0, y0): (f64, f64), (x1, y1): (f64, f64)) {
    let half = (y0 + y1) / 2.0;
    let _ = writeln!(
        svg,
        "<path class=\"ray {class}\" d=\"M{x0:.1} {y0:.1}C{x0:.1} {half:.1} {x1:.1} {half:.1} {x1:.1} {y1:.1}\"/>"
    );
    if !label.is_empty() {
        // Beside the end, on the outer side.
        let (x, anchor) = if x1 < x0 { (x1 - 5.0, "end") } else { (x1 + 5.0, "start") };
        let y = y1 - 8.0;
        let _ = writeln!(svg, "<text text-anchor=\"{anchor}\" x=\"{x:.1}\" y=\"{y:.1}\">{label}</text>");
    }
}

fn largest([r, g, b]: Float3) -> f32 {
    Rgb::new(r, g, b).max_component()
}

/// A number with three significant digits; the text has all digits.
fn short(number: f32) -> String {
    if number == 0.0 {
        return "0".into();
    }
    let digits = 2 - (libm::floor(libm::log10(f64::from(number.abs()))) as i64);
    match digits {
        ..=0 => format!("{number:.0}"),
        1..=6 => {
            let text = format!("{number:.*}", digits as usize);
            text.trim_end_matches('0').trim_end_matches('.').to_owned()
        }
        _ => format!("{number:.1e}"),
    }
}

/// The row, truncated to the width of a box.
fn fitted(row: &str) -> String {
    if row.chars().count() <= CHARACTERS {
        return row.to_owned();
    }
    row.chars().take(CHARACTERS - 1).chain(['…']).collect()
}

fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}
