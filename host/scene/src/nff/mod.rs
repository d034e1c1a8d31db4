//! NFF, the Neutral File Format (Eric Haines, 1988 to 1996): `v b l f c s p pp` and comments.
//!
//! The format is line-oriented, but writers break lines differently. So an entity is a keyword at the start of a line,
//! followed by its numbers, across any white space. Anything else is an error with its line; nothing is skipped silently,
//! except that `hither` has no meaning for a ray tracer.
//!
//! * Ambient light, and a light without a color, have the intensity `sqrt(n) / (2 n)`, where `n` is the number of lights
//!   (the rule of the Standard Procedural Databases).
//! * A negative radius makes a sphere or cone one-sided, visible from inside. Here every surface has two sides, and only
//!   the absolute value is used.
//! * A polygon without area keeps its index and is never hit; one warning counts them.

mod tokens;

use std::collections::{BTreeMap, HashMap};
use std::path::Path;

use strahl_core::geometry::{Cone, Polygon};
use strahl_core::math::MAX_COORDINATE;
use strahl_core::{Camera, Material, Resolution, Rgb, vec3};
use strahl_settings::SettingsOverrides;

use crate::description::{
    BackgroundDescription, CameraDescription, Float3, LightDescription, LightSourceDescription, LoadedScene,
    Located, ObjectDescription, ProjectionDescription, ShapeDescription,
};
use crate::error::LoadError;
use crate::limits::MAX_PIXELS_IN_FILE;
use crate::quantity::quantity;
use tokens::{NffError, NffResult, Token, Tokens};

/// Reads the bytes of the file at `path`.
///
/// Old files have comments in various encodings: invalid UTF-8 is an error only outside comments.
pub fn read(path: &Path, bytes: &[u8]) -> Result<LoadedScene, LoadError> {
    if let Some(position) = bytes.iter().position(|byte| *byte == 0) {
        let line = 1 + bytes[..position].iter().filter(|byte| **byte == b'\n').count();
        return Err(LoadError::at(path, line, "not a text file, so not an NFF scene"));
    }
    let text = String::from_utf8_lossy(bytes);
    // The file may start with a byte order mark.
    let text = text.strip_prefix('\u{feff}').unwrap_or(&text);
    NffReader::new(text).scene().map_err(|NffError { line, reason }| LoadError::at(path, line, reason))
}

/// A light; without a color it gets the default intensity.
struct NffLight {
    position: Float3,
    color: Option<Rgb>,
    line: usize,
}

/// The state of reading a file.
struct NffReader<'t> {
    tokens: Tokens<'t>,
    view: Option<Located<(CameraDescription, Resolution, usize)>>,
    background: Option<Located<Rgb>>,
    lights: Vec<NffLight>,
    materials: Vec<Located<Material>>,
    /// Where the material with these numbers stands.
    material_of: HashMap<[u32; 8], u16>,
    material: Option<u16>,
    objects: Vec<ObjectDescription>,
    points: Vec<Float3>,
    normals: Vec<Float3>,
    /// How many have no area, and the line of the first.
    degenerate: (usize, usize),
}

impl<'t> NffReader<'t> {
    fn new(text: &'t str) -> Self {
        NffReader {
            tokens: Tokens::of(text),
            view: None,
            background: None,
            lights: Vec::new(),
            materials: Vec::new(),
            material_of: HashMap::new(),
            material: None,
            objects: Vec::new(),
            points: Vec::new(),
            normals: Vec::new(),
            degenerate: (0, 0),
        }
    }

    fn scene(mut self) -> NffResult<LoadedScene> {
        if self.tokens.peeked.is_none() {
            return Err(NffError { line: 1, reason: "the file is empty".into() });
        }
        while let Some(token) = self.tokens.next() {
            if !token.begins_line {
                return token
                    .error(format!("{} does not belong here: a new entity begins a line", token.shown()));
            }
            match token.text {
                "v" => self.view(token)?,
                "b" => self.background(token)?,
                "l" => self.light(token)?,
                "f" => self.fill(token)?,
                "s" => self.sphere(token)?,
                "c" => self.cone(token)?,
                "p" => self.polygon(token, false)?,
                "pp" => self.polygon(token, true)?,
                _ => {
                    let shown = token.shown();
                    return token.error(format!("{shown} is not an NFF entity (v, b, l, f, c, s, p or pp)"));
                }
            }
        }
        self.finish()
    }

    fn view(&mut self, keyword: Token<'_>) -> NffResult<()> {
        if let Some(first) = &self.view {
            return keyword.error(format!("duplicate viewpoint; the first is in line {}", first.line));
        }
        let (mut from, mut at, mut up, mut angle, mut size) = (None, None, None, None, None);
        let mut hither = None;
        let keywords = ["from", "at", "up", "angle", "hither", "resolution"];
        while let Some(token) = self.tokens.peeked.filter(|token| keywords.contains(&token.text)) {
            self.tokens.next();
            let again = match token.text {
                "from" => from.replace(self.tokens.point("the eye position", token)?).is_some(),
                "at" => at.replace(self.tokens.point("the target", token)?).is_some(),
                "up" => up.replace(self.tokens.point("the up vector", token)?).is_some(),
                "angle" => angle.replace(self.tokens.number("the field of view", token)?).is_some(),
                "hither" => hither.replace(self.tokens.number("the hither plane", token)?).is_some(),
                _ => size.replace((self.size(token)?, token.line)).is_some(),
            };
            if again {
                return token.error(format!("duplicate `{}` in one viewpoint", token.text));
            }
        }
        let missing = |what: &str| {
            let (line, found) = match self.tokens.peeked {
                Some(token) => (token.line, format!("before {}", token.shown())),
                None => (self.tokens.lines, "at the end of the file".into()),
            };
            NffError {
                line,
                reason: format!("the viewpoint of line {} has no `{what}` {found}", keyword.line),
            }
        };
        let view = CameraDescription {
            from: from.ok_or_else(|| missing("from"))?,
            at: at.ok_or_else(|| missing("at"))?,
            up: up.ok_or_else(|| missing("up"))?,
            projection: ProjectionDescription::Perspective(angle.ok_or_else(|| missing("angle"))?),
        };
        let (size, line) = size.ok_or_else(|| missing("resolution"))?;
        if let Some(angle) = angle.filter(|angle| !(*angle > 0.0 && *angle < 180.0)) {
            let range = "more than 0 and less than 180 degrees";
            return keyword.error(format!("the field of view must be {range}, not {angle}"));
        }
        if let Err(fault) = Camera::new(&view.to_core(), size) {
            return keyword.error(format!("{fault}"));
        }
        self.view = Some(Located { value: (view, size, line), line: keyword.line, name: None });
        Ok(())
    }

    fn size(&mut self, keyword: Token<'_>) -> NffResult<Resolution> {
        let width = self.tokens.integer(1, Resolution::MAX_SIDE, "the width of the picture", keyword)?;
        let height = self.tokens.integer(1, Resolution::MAX_SIDE, "the height of the picture", keyword)?;
        match Resolution::new(width, height) {
            Some(size) if u64::from(width) * u64::from(height) <= MAX_PIXELS_IN_FILE => Ok(size),
            _ => keyword.error(format!(
                "{width} x {height} pixels are more than the limit for a file ({MAX_PIXELS_IN_FILE} pixels); use --size"
            )),
        }
    }

    fn background(&mut self, keyword: Token<'_>) -> NffResult<()> {
        if let Some(first) = &self.background {
            return keyword.error(format!("duplicate background; the first is in line {}", first.line));
        }
        let color = self.tokens.color("a channel of the background", keyword)?;
        self.background = Some(Located { value: color, line: keyword.line, name: None });
        Ok(())
    }

    fn light(&mut self, keyword: Token<'_>) -> NffResult<()> {
        let position = self.tokens.point("the light position", keyword)?;
        let color = match self.tokens.has_number() {
            true => Some(self.tokens.color("a channel of the light", keyword)?),
            false => None,
        };
        self.lights.push(NffLight { position, color, line: keyword.line });
        Ok(())
    }

    fn fill(&mut self, keyword: Token<'_>) -> NffResult<()> {
        let tokens = &mut self.tokens;
        let color = tokens.color("a channel of the material", keyword)?;
        let kd = tokens.number_in(0.0, Rgb::MAX_CHANNEL, "the diffuse factor Kd", keyword)?;
        let ks = tokens.number_in(0.0, 1.0, "the specular factor Ks", keyword)?;
        let shine = tokens.number_in(0.0, 1e6, "the exponent Shine", keyword)?;
        let t = tokens.number_in(0.0, 1.0, "the transmission factor T", keyword)?;
        // Many files have a zero if the index is unused.
        let (min, max) = if t > 0.0 { (0.01, 100.0) } else { (-MAX_COORDINATE, MAX_COORDINATE) };
        let index = tokens.number_in(min, max, "the index of refraction", keyword)?;

        let key = [color.r, color.g, color.b, kd, ks, shine, t, index].map(f32::to_bits);
        if let Some(id) = self.material_of.get(&key) {
            self.material = Some(*id);
            return Ok(());
        }
        let Ok(id) = u16::try_from(self.materials.len()) else {
            return keyword.error(format!("more than {} different materials", self.materials.len()));
        };
        let scattered = (color * kd).clamp_max(Rgb::MAX_CHANNEL);
        let material = Material {
            ambient: scattered,
            diffuse: scattered,
            highlight: Rgb::gray(ks),
            highlight_exponent: shine,
            reflection: Rgb::gray(ks),
            transmission: Rgb::gray(t),
            refractive_index: if t > 0.0 { index } else { 1.0 },
            ..Material::MATTE
        };
        self.materials.push(Located { value: material, line: keyword.line, name: None });
        self.material_of.insert(key, id);
        self.material = Some(id);
        Ok(())
    }

    fn add(&mut self, shape: ShapeDescription, keyword: Token<'_>) -> NffResult<()> {
        let Some(material) = self.material else {
            return keyword.error("object before the first material (`f`)");
        };
        self.objects.push(ObjectDescription { shape, material, line: keyword.line as u32 });
        Ok(())
    }

    fn sphere(&mut self, keyword: Token<'_>) -> NffResult<()> {
        let center = self.tokens.point("the center of the sphere", keyword)?;
        let radius = self.tokens.coordinate("the radius of the sphere", keyword)?.abs();
        if radius == 0.0 {
            return keyword.error("the radius of the sphere is 0");
        }
        self.add(ShapeDescription::Sphere { center, radius }, keyword)
    }

    fn cone(&mut self, keyword: Token<'_>) -> NffResult<()> {
        let base = self.tokens.point("the base of the cone", keyword)?;
        let base_radius = self.tokens.coordinate("the radius of the base", keyword)?.abs();
        let end = self.tokens.point("the apex of the cone", keyword)?;
        let end_radius = self.tokens.coordinate("the radius of the apex", keyword)?.abs();
        let vec3_of = |[x, y, z]: Float3| vec3(x, y, z);
        match Cone::new(vec3_of(base), base_radius, vec3_of(end), end_radius, false) {
            None => return keyword.error("the base and apex of the cone are equal"),
            Some(cone) if cone.height > MAX_COORDINATE => {
                return keyword.error(format!("the cone is longer than {MAX_COORDINATE}"));
            }
            Some(_) => {}
        }
        if base_radius == 0.0 && end_radius == 0.0 {
            return keyword.error("both radii of the cone are 0");
        }
        self.add(ShapeDescription::Cone { base, base_radius, end, end_radius, capped: false }, keyword)
    }

    fn polygon(&mut self, keyword: Token<'_>, smooth: bool) -> NffResult<()> {
        let count = self.tokens.integer(3, u32::MAX, "the number of vertices", keyword)?;
        let first = self.points.len();
        if smooth {
            // A normal has the index of its vertex; earlier vertices may have no normal.
            self.normals.resize(first, [0.0, 0.0, 1.0]);
        }
        for _ in 0..count {
            let corner = self.tokens.point("a vertex", keyword)?;
            self.points.push(corner);
            if smooth {
                let token = self.tokens.peeked;
                let normal = self.tokens.point("a vertex normal", keyword)?;
                if normal == [0.0; 3] {
                    return token.unwrap_or(keyword).error("a vertex normal is zero");
                }
                self.normals.push(normal);
            }
        }
        let Ok(end) = u32::try_from(self.points.len()) else {
            return keyword.error("too many vertices");
        };

        let corners: Vec<_> = self.points[first..].iter().map(|[x, y, z]| vec3(*x, *y, *z)).collect();
        let first = end - count;
        let shape = if Polygon::new(first, &corners, smooth).is_none() {
            self.degenerate = (
                self.degenerate.0 + 1,
                if self.degenerate.0 == 0 { keyword.line } else { self.degenerate.1 },
            );
            ShapeDescription::Degenerate
        } else if count == 3 {
            ShapeDescription::Triangle { vertices: [first, first + 1, first + 2], smooth }
        } else {
            ShapeDescription::Polygon { first, count, smooth }
        };
        self.add(shape, keyword)
    }

    fn finish(self) -> NffResult<LoadedScene> {
        let Some(Located { value: (view, size, line), .. }) = self.view else {
            return Err(NffError {
                line: self.tokens.lines,
                reason: "the file has no viewpoint (`v`)".into(),
            });
        };
        // The rule of the Standard Procedural Databases.
        let n = self.lights.len().max(1) as f32;
        let intensity = Rgb::gray((f64::from(n).sqrt() / (2.0 * f64::from(n))) as f32);
        let lights = self.lights.iter().map(|light| {
            let source = LightSourceDescription::Point { position: light.position, falloff: [1.0, 0.0, 0.0] };
            let color = light.color.unwrap_or(intensity);
            Located { value: LightDescription { source, color, shadows: true }, line: light.line, name: None }
        });
        let mut warnings = Vec::new();
        match self.degenerate {
            (0, _) => {}
            (1, line) => warnings.push(format!("1 polygon has zero area and is never hit (line {line})")),
            (count, line) => warnings.push(format!(
                "{} have zero area and are never hit (the first in line {line})",
                quantity(count, "polygon")
            )),
        }
        Ok(LoadedScene {
            settings: SettingsOverrides { size: Some(size), ..SettingsOverrides::default() },
            setting_lines: BTreeMap::from([("size", line)]),
            background: BackgroundDescription::Color(self.background.map_or(Rgb::BLACK, |b| b.value)),
            ambient: intensity,
            lights: lights.collect(),
            materials: self.materials,
            objects: self.objects,
            vertices: self.points,
            normals: self.normals,
            warnings,
            ..LoadedScene::new(view)
        })
    }
}
