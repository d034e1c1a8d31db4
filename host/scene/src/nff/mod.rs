//! NFF, the Neutral File Format (Eric Haines, 1988 to 1996): `v b l f c s p pp` and comments.
//!
//! The format is line-oriented, but writers break lines differently, so each entity is a keyword
//! that begins a line and as many numbers as belong to it, across any white space. Whatever
//! does not belong is an error with its line; nothing is skipped silently, except that
//! `hither` is read and has no meaning for a ray tracer.
//!
//! * A light without a colour, and ambient light, have the intensity `sqrt(n) / (2 n)`, where
//!   `n` is the number of lights (the rule of the Standard Procedural Databases).
//! * The negative radius of a one-sided sphere or cone is its inside; here every surface has
//!   both sides, and only its size counts.
//! * A polygon without area keeps its number and is never hit; one warning counts them.

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
/// Old files have comments in all sorts of encodings: what is no UTF-8 is an error only where it
/// is no comment.
pub fn read(path: &Path, bytes: &[u8]) -> Result<LoadedScene, LoadError> {
    if let Some(place) = bytes.iter().position(|byte| *byte == 0) {
        let line = 1 + bytes[..place].iter().filter(|byte| **byte == b'\n').count();
        return Err(LoadError::at(path, line, "this is not text, so it is no NFF scene"));
    }
    let text = String::from_utf8_lossy(bytes);
    // A byte order mark may begin the file.
    let text = text.strip_prefix('\u{feff}').unwrap_or(&text);
    NffReader::new(text).scene().map_err(|NffError { line, reason }| LoadError::at(path, line, reason))
}

/// A light as the file has it.
struct NffLight {
    position: Float3,
    color: Option<Rgb>,
    line: usize,
}

/// The file, and what has been read of it.
struct NffReader<'t> {
    words: Tokens<'t>,
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
            words: Tokens::of(text),
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
        if self.words.peeked.is_none() {
            return Err(NffError { line: 1, reason: "the file has no scene in it".into() });
        }
        while let Some(word) = self.words.next() {
            if !word.begins_line {
                return word
                    .error(format!("{} does not belong here: a new entity begins a line", word.shown()));
            }
            match word.text {
                "v" => self.view(word)?,
                "b" => self.background(word)?,
                "l" => self.light(word)?,
                "f" => self.fill(word)?,
                "s" => self.sphere(word)?,
                "c" => self.cone(word)?,
                "p" => self.polygon(word, false)?,
                "pp" => self.polygon(word, true)?,
                _ => {
                    let shown = word.shown();
                    return word.error(format!("{shown} is no NFF entity (v, b, l, f, c, s, p or pp)"));
                }
            }
        }
        self.finish()
    }

    fn view(&mut self, of: Token<'_>) -> NffResult<()> {
        if let Some(first) = &self.view {
            return of.error(format!("a second viewpoint; the first is in line {}", first.line));
        }
        let (mut from, mut at, mut up, mut angle, mut size) = (None, None, None, None, None);
        let mut hither = None;
        let keywords = ["from", "at", "up", "angle", "hither", "resolution"];
        while let Some(word) = self.words.peeked.filter(|word| keywords.contains(&word.text)) {
            self.words.next();
            let again = match word.text {
                "from" => from.replace(self.words.point("the eye's place", word)?).is_some(),
                "at" => at.replace(self.words.point("the place looked at", word)?).is_some(),
                "up" => up.replace(self.words.point("the direction of up", word)?).is_some(),
                "angle" => angle.replace(self.words.number("the angle of view", word)?).is_some(),
                "hither" => hither.replace(self.words.number("the hither plane", word)?).is_some(),
                _ => size.replace((self.size(word)?, word.line)).is_some(),
            };
            if again {
                return word.error(format!("a second `{}` in one viewpoint", word.text));
            }
        }
        let missing = |what: &str| {
            let (line, found) = match self.words.peeked {
                Some(word) => (word.line, format!("before {}", word.shown())),
                None => (self.words.lines, "at the end of the file".into()),
            };
            NffError { line, reason: format!("the viewpoint of line {} has no `{what}` {found}", of.line) }
        };
        let view = CameraDescription {
            from: from.ok_or_else(|| missing("from"))?,
            at: at.ok_or_else(|| missing("at"))?,
            up: up.ok_or_else(|| missing("up"))?,
            projection: ProjectionDescription::Perspective(angle.ok_or_else(|| missing("angle"))?),
        };
        let (size, line) = size.ok_or_else(|| missing("resolution"))?;
        if let Err(fault) = Camera::new(&view.to_core(), size) {
            return of.error(format!("{fault}"));
        }
        self.view = Some(Located { value: (view, size, line), line: of.line, name: None });
        Ok(())
    }

    fn size(&mut self, of: Token<'_>) -> NffResult<Resolution> {
        let width = self.words.integer(1, Resolution::MAX_SIDE, "the width of the picture", of)?;
        let height = self.words.integer(1, Resolution::MAX_SIDE, "the height of the picture", of)?;
        match Resolution::new(width, height) {
            Some(size) if u64::from(width) * u64::from(height) <= MAX_PIXELS_IN_FILE => Ok(size),
            _ => of.error(format!(
                "{width} x {height} pixels are more than a file may ask for ({MAX_PIXELS_IN_FILE}); --size may"
            )),
        }
    }

    fn background(&mut self, of: Token<'_>) -> NffResult<()> {
        if let Some(first) = &self.background {
            return of.error(format!("a second background; the first is in line {}", first.line));
        }
        let color = self.words.color("a channel of the background", of)?;
        self.background = Some(Located { value: color, line: of.line, name: None });
        Ok(())
    }

    fn light(&mut self, of: Token<'_>) -> NffResult<()> {
        let position = self.words.point("the place of the light", of)?;
        let color = match self.words.has_number() {
            true => Some(self.words.color("a channel of the light", of)?),
            false => None,
        };
        self.lights.push(NffLight { position, color, line: of.line });
        Ok(())
    }

    fn fill(&mut self, of: Token<'_>) -> NffResult<()> {
        let words = &mut self.words;
        let color = words.color("a channel of the surface", of)?;
        let kd = words.number_in(0.0, Rgb::MAX_CHANNEL, "the diffuse share Kd", of)?;
        let ks = words.number_in(0.0, 1.0, "the mirrored share Ks", of)?;
        let shine = words.number_in(0.0, 1e6, "the exponent Shine", of)?;
        let t = words.number_in(0.0, 1.0, "the transmitted share T", of)?;
        // Many files have no use for the index, and a zero there.
        let (least, most) = if t > 0.0 { (0.01, 100.0) } else { (-MAX_COORDINATE, MAX_COORDINATE) };
        let index = words.number_in(least, most, "the index of refraction", of)?;

        let key = [color.r, color.g, color.b, kd, ks, shine, t, index].map(f32::to_bits);
        if let Some(known) = self.material_of.get(&key) {
            self.material = Some(*known);
            return Ok(());
        }
        let Ok(place) = u16::try_from(self.materials.len()) else {
            return of.error(format!("more than {} different surfaces", self.materials.len()));
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
        self.materials.push(Located { value: material, line: of.line, name: None });
        self.material_of.insert(key, place);
        self.material = Some(place);
        Ok(())
    }

    fn add(&mut self, form: ShapeDescription, of: Token<'_>) -> NffResult<()> {
        let Some(material) = self.material else {
            return of.error("an object before the first surface (`f`)");
        };
        self.objects.push(ObjectDescription { shape: form, material, line: of.line as u32 });
        Ok(())
    }

    fn sphere(&mut self, of: Token<'_>) -> NffResult<()> {
        let center = self.words.point("the centre of the sphere", of)?;
        let radius = self.words.coordinate("the radius of the sphere", of)?.abs();
        if radius == 0.0 {
            return of.error("the radius of the sphere is 0");
        }
        self.add(ShapeDescription::Sphere { center, radius }, of)
    }

    fn cone(&mut self, of: Token<'_>) -> NffResult<()> {
        let base = self.words.point("the base of the cone", of)?;
        let base_radius = self.words.coordinate("the radius of the base", of)?.abs();
        let end = self.words.point("the apex of the cone", of)?;
        let end_radius = self.words.coordinate("the radius of the apex", of)?.abs();
        let place = |[x, y, z]: Float3| vec3(x, y, z);
        match Cone::new(place(base), base_radius, place(end), end_radius, false) {
            None => return of.error("the cone's base and apex are at the same place"),
            Some(cone) if cone.height > MAX_COORDINATE => {
                return of.error(format!("the cone is longer than {MAX_COORDINATE}"));
            }
            Some(_) => {}
        }
        if base_radius == 0.0 && end_radius == 0.0 {
            return of.error("both radii of the cone are 0");
        }
        self.add(ShapeDescription::Cone { base, base_radius, end, end_radius, capped: false }, of)
    }

    fn polygon(&mut self, of: Token<'_>, smooth: bool) -> NffResult<()> {
        let count = self.words.integer(3, u32::MAX, "the number of corners", of)?;
        let first = self.points.len();
        if smooth {
            // The normal of a corner has the corner's place; corners before it may have none.
            self.normals.resize(first, [0.0, 0.0, 1.0]);
        }
        for _ in 0..count {
            let corner = self.words.point("a corner", of)?;
            self.points.push(corner);
            if smooth {
                let word = self.words.peeked;
                let normal = self.words.point("the normal of a corner", of)?;
                if normal == [0.0; 3] {
                    return word.unwrap_or(of).error("the normal of a corner is zero");
                }
                self.normals.push(normal);
            }
        }
        let Ok(end) = u32::try_from(self.points.len()) else {
            return of.error("more corners than a scene can number");
        };

        let corners: Vec<_> = self.points[first..].iter().map(|[x, y, z]| vec3(*x, *y, *z)).collect();
        let first = end - count;
        let form = if Polygon::new(first, &corners, smooth).is_none() {
            self.degenerate =
                (self.degenerate.0 + 1, if self.degenerate.0 == 0 { of.line } else { self.degenerate.1 });
            ShapeDescription::Degenerate
        } else if count == 3 {
            ShapeDescription::Triangle { vertices: [first, first + 1, first + 2], smooth }
        } else {
            ShapeDescription::Polygon { first, count, smooth }
        };
        self.add(form, of)
    }

    fn finish(self) -> NffResult<LoadedScene> {
        let Some(Located { value: (view, size, line), .. }) = self.view else {
            return Err(NffError {
                line: self.words.lines,
                reason: "the file ends without a viewpoint (`v`)".into(),
            });
        };
        // The rule of the procedural databases.
        let n = self.lights.len().max(1) as f32;
        let intensity = Rgb::gray((f64::from(n).sqrt() / (2.0 * f64::from(n))) as f32);
        let lights = self.lights.iter().map(|lamp| {
            let source = LightSourceDescription::Point { position: lamp.position, falloff: [1.0, 0.0, 0.0] };
            let color = lamp.color.unwrap_or(intensity);
            Located { value: LightDescription { source, color, shadows: true }, line: lamp.line, name: None }
        });
        let mut warnings = Vec::new();
        match self.degenerate {
            (0, _) => {}
            (1, line) => warnings.push(format!("1 polygon has no area and is never hit (line {line})")),
            (count, line) => warnings.push(format!(
                "{} have no area and are never hit (the first in line {line})",
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
