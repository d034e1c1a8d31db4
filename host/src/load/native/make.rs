//! What has been read becomes a description.

use std::collections::BTreeMap;
use std::ops::Range;

use strahl_core::{Resolution, Rgb, Vec3, vec3};
use strahl_settings::PartialSettings;

use super::format::File;
use super::forms::{Thing, things};
use super::materials::Made;
use super::meshes::Meshes;
use super::table::Reader;
use super::view;
use crate::amount::amount;
use crate::description::{Background, Description, Form, Motion, Object, Projection, SHUTTER, Triple, View};
use crate::faults::Lines;

/// A description that grows, and what is wrong with what it is made of.
pub(super) struct Maker<'m> {
    pub(super) reader: Reader<'m>,
    pub(super) lines: &'m Lines,
    pub(super) description: Description,
    pub(super) made: Made,
    pub(super) meshes: Meshes<'m>,
    /// Of the picture, where the file does not say it.
    pub(super) size: Resolution,
    /// Whether it has been told that there are too many materials.
    pub(super) overflown: bool,
    /// Triangles without area, and the line of the first.
    flat: (usize, usize),
}

impl<'m> Maker<'m> {
    /// Nothing, for a picture of `size`.
    pub(super) fn new(reader: Reader<'m>, lines: &'m Lines, meshes: Meshes<'m>, size: Resolution) -> Self {
        let view = View {
            from: [0.0, 0.0, 1.0],
            at: [0.0; 3],
            up: view::UP,
            projection: Projection::Perspective(view::ANGLE),
        };
        let description = Description {
            view,
            view_line: 1,
            colored_shadows: None,
            settings: PartialSettings::default(),
            setting_lines: BTreeMap::new(),
            background: Background::Color(Rgb::BLACK),
            ambient: Rgb::BLACK,
            lights: Vec::new(),
            materials: Vec::new(),
            textures: Vec::new(),
            objects: Vec::new(),
            points: Vec::new(),
            normals: Vec::new(),
            triangles: Vec::new(),
            moving: Vec::new(),
            shutter: SHUTTER,
            warnings: Vec::new(),
        };
        Maker {
            reader,
            lines,
            description,
            made: Made::default(),
            meshes,
            size,
            overflown: false,
            flat: (0, 0),
        }
    }

    /// Makes everything, and answers with it and what is wrong.
    pub(super) fn scene(mut self, mut file: File) -> (Description, Reader<'m>) {
        self.settings(std::mem::take(&mut file.render));
        let file = &file;
        self.materials(&file.material);
        self.shutter(&file.camera);
        // Objects are numbered by their places in the file, whatever they are.
        let mut things: Vec<(&Range<usize>, &dyn Thing)> = things(file);
        things.sort_by_key(|(span, _)| span.start);
        for (span, thing) in things {
            thing.add(span, &mut self);
        }
        self.warn();
        self.lights(file);
        self.view(file);
        self.background(&file.background);
        (self.description, self.reader)
    }

    /// Puts an object into the table, which moves if there is a velocity.
    pub(super) fn push(&mut self, form: Form, material: u16, velocity: Triple, span: &Range<usize>) {
        let line = u32::try_from(self.lines.line(span.start)).unwrap_or(u32::MAX);
        if let Form::Nothing = form {
            let first = if self.flat.0 == 0 { line as usize } else { self.flat.1 };
            self.flat = (self.flat.0 + 1, first);
        }
        if velocity != [0.0; 3] {
            let object = self.description.objects.len();
            self.description.moving.push(Motion { object, velocity });
        }
        self.description.objects.push(Object { form, material, line });
    }

    /// Puts corners, and normals where there are some, into the tables; the place of the first.
    pub(super) fn corners(&mut self, points: impl IntoIterator<Item = Triple>, normals: &[Triple]) -> u32 {
        let it = &mut self.description;
        let first = it.points.len();
        it.points.extend(points);
        if !normals.is_empty() {
            // The normal of a corner has the corner's place; corners before it may have none.
            it.normals.resize(first, [0.0, 0.0, 1.0]);
            it.normals.extend(normals);
        }
        u32::try_from(first).unwrap_or(u32::MAX)
    }

    fn warn(&mut self) {
        let warnings = &mut self.description.warnings;
        let (count, line) = self.flat;
        match count {
            0 => {}
            1 => warnings.push(format!("1 triangle has no area and is never hit (line {line})")),
            _ => warnings.push(format!(
                "{} have no area and are never hit (the first in line {line})",
                amount(count, "triangle")
            )),
        }
        if self.description.objects.is_empty() {
            warnings.push("there is no object in the scene".into());
        }
    }
}

pub(super) fn vector([x, y, z]: Triple) -> Vec3 {
    vec3(x, y, z)
}
