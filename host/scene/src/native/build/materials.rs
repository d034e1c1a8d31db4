//! The materials of the file become materials of the description.

use std::ops::Range;

use strahl_core::scene::{FresnelModel, TextureId};
use strahl_core::{Material, Rgb};

use super::builder::SceneBuilder;
use crate::description::{TextureDescription, vec3_of};
use crate::diagnostics::Diagnostic;
use crate::native::format::{self, Surface};
use crate::native::table::Many;
use crate::native::value::Spanned;
use crate::quote::quoted;

/// The core counts cells per length, and no more of them than lengths.
const LEAST_CELL: f32 = 1e-14;

impl SceneBuilder<'_> {
    /// Makes the materials that have names.
    pub fn materials(&mut self, materials: &Many<format::Material>) {
        for material in &materials.0 {
            let Some(name) = &material.it.name else {
                let fault = Diagnostic::new(material.span.clone(), "this `material` has no `name`");
                self.reader.misses::<()>(fault.with_help("give it the name that objects call it by"));
                continue;
            };
            if let Some(first) = self.reader.names.first(&name.it)
                && *first != name.span
            {
                let what = format!("a second material is called {}", quoted(&name.it));
                let fault = Diagnostic::new(name.span.clone(), what);
                self.reader.faults.push(fault.with_related(first.clone(), "the first"));
                continue;
            }
            if let Some(place) = self.material(material, Some(name.it.clone())) {
                self.made.named.insert(name.it.clone(), place);
            }
        }
    }

    /// The place of the material of an object at `span`.
    pub fn made_of(&mut self, surface: &Option<Surface>, span: &Range<usize>) -> Option<u16> {
        match surface {
            Some(Surface::Named(name)) => self.made.named.get(name).copied(),
            Some(Surface::Own(own)) => self.material(own, None),
            None => {
                if self.made.default.is_none() {
                    self.made.default = self.keep(Material::MATTE, None, span);
                }
                self.made.default
            }
        }
    }

    /// Makes one material.
    fn material(&mut self, at: &Spanned<format::Material>, name: Option<String>) -> Option<u16> {
        let it = &at.it;
        let texture = self.texture(it)?;
        let color = it.color.map_or(Rgb::WHITE, |c| c.0);
        let mirror = it.mirror.map_or(Rgb::BLACK, |s| s.0);
        let transmitted = it.transmission.map_or(Rgb::BLACK, |s| s.0);
        let left = |mirror: f32, transmitted: f32| {
            let left = 1.0 - mirror - transmitted;
            if left > 0.0 { left } else { 0.0 }
        };
        let rest = Rgb::new(
            left(mirror.r, transmitted.r),
            left(mirror.g, transmitted.g),
            left(mirror.b, transmitted.b),
        );
        let diffuse = it.diffuse.map_or(rest, |c| c.0);
        let ambient = it.ambient.map_or(diffuse, |c| c.0);
        let asks = it.shininess.is_some_and(|s| s.0 > 0.0);
        let highlight = it.highlight.map_or(if asks { Rgb::gray(0.5) } else { Rgb::BLACK }, |c| c.0);
        let exponent = it.shininess.map_or(if highlight.is_black() { 0.0 } else { 50.0 }, |s| s.0);
        let times = |share: Rgb| {
            Rgb::new(color.r * share.r, color.g * share.g, color.b * share.b).clamp_max(Rgb::MAX_CHANNEL)
        };
        if transmitted.is_black() {
            self.idle(it);
        }
        if let Some(roughness) = &it.roughness
            && transmitted.is_black()
            && mirror.is_black()
        {
            let line = self.lines.line_number(roughness.span.start);
            let warning =
                format!("`roughness` in line {line} has no effect without `mirror` or `transmission`");
            self.description.warnings.push(warning);
        }
        let material = Material {
            ambient: times(ambient),
            diffuse: times(diffuse),
            texture,
            highlight,
            highlight_exponent: exponent,
            reflection: mirror,
            transmission: transmitted,
            roughness: it.roughness.as_ref().map_or(0.0, |roughness| roughness.it.0),
            refractive_index: it.index.as_ref().map_or(1.5, |index| index.it.0),
            fresnel: match it.fresnel {
                Some(Spanned { it: true, .. }) => FresnelModel::Dielectric,
                _ => FresnelModel::Constant,
            },
            attenuation_length: it
                .clarity
                .as_ref()
                .map_or(Material::MATTE.attenuation_length, |clarity| clarity.it.0),
            priority: it.priority.as_ref().map_or(0, |priority| priority.it.0),
            two_sided: it.one_sided != Some(true),
        };
        // A body that is none bends no light.
        let index =
            if transmitted.is_black() { Material::MATTE.refractive_index } else { material.refractive_index };
        self.keep(Material { refractive_index: index, ..material }, name, &at.span)
    }

    /// Warns of keys that say something about a body where there is none.
    fn idle(&mut self, it: &format::Material) {
        let keys = [
            ("index", it.index.as_ref().map(|at| at.span.start)),
            ("fresnel", it.fresnel.as_ref().filter(|at| at.it).map(|at| at.span.start)),
            ("clarity", it.clarity.as_ref().map(|at| at.span.start)),
            ("priority", it.priority.as_ref().map(|at| at.span.start)),
        ];
        for (key, place) in keys.into_iter().filter_map(|(key, place)| Some((key, place?))) {
            let line = self.lines.line_number(place);
            let warning = format!("`{key}` in line {line} has no effect without `transmission`");
            self.description.warnings.push(warning);
        }
    }

    /// The place of a material's texture, if it has one.
    fn texture(&mut self, it: &format::Material) -> Option<TextureId> {
        let mut kinds: Vec<_> = [
            ("checker", it.checker.as_ref().map(|at| &at.span)),
            ("gradient", it.gradient.as_ref().map(|at| &at.span)),
            ("zone_plate", it.zone_plate.as_ref().map(|at| &at.span)),
        ]
        .into_iter()
        .filter_map(|(kind, span)| Some((kind, span?.clone())))
        .collect();
        if let [(one, _), (other, _), ..] = &kinds[..] {
            let what = format!("a material has either a `{one}` or a `{other}`");
            kinds.sort_by_key(|(_, span)| span.start);
            let fault = Diagnostic::new(kinds[1].1.clone(), what);
            return self.reader.wrong(fault.with_related(kinds[0].1.clone(), "the other"));
        }
        let texture = match (&it.checker, &it.gradient, &it.zone_plate) {
            (None, None, None) => return Some(TextureId::NONE),
            (_, _, Some(Spanned { it: plate, .. })) => TextureDescription::ZonePlate {
                from: plate.from.map_or(Rgb::WHITE, |c| c.0),
                to: plate.to.map_or(Rgb::BLACK, |c| c.0),
                origin: plate.origin.map_or([0.0; 3], |p| p.0),
                frequency: plate.frequency.0,
            },
            (Some(Spanned { it: checker, .. }), _, _) => {
                let size = checker.size.as_ref().map_or([1.0, 0.0, 1.0], |size| size.it.0);
                if let Some(at) = &checker.size
                    && size.iter().any(|size| *size > 0.0 && *size < LEAST_CELL)
                {
                    let what = format!("a cell of a checker must be 0 or at least {LEAST_CELL:e}");
                    return self.reader.wrong(Diagnostic::new(at.span.clone(), what));
                }
                TextureDescription::Checker {
                    even: checker.even.map_or(Rgb::WHITE, |c| c.0),
                    odd: checker.odd.map_or(Rgb::gray(0.1), |c| c.0),
                    origin: checker.origin.map_or([0.0; 3], |p| p.0),
                    size,
                }
            }
            (_, Some(Spanned { it: gradient, .. }), _) => {
                let along = vec3_of(gradient.end.it.0) - vec3_of(gradient.start.0);
                // Its square is what the core divides by.
                if along.dot(along) <= 0.0 {
                    let fault = Diagnostic::new(gradient.end.span.clone(), "a gradient ends where it starts");
                    return self.reader.wrong(fault);
                }
                TextureDescription::Gradient {
                    from: gradient.from.map_or(Rgb::BLACK, |c| c.0),
                    to: gradient.to.map_or(Rgb::WHITE, |c| c.0),
                    start: gradient.start.0,
                    end: gradient.end.it.0,
                }
            }
        };
        self.description.textures.push(texture);
        // No more than materials, which are counted when they are kept.
        Some(u16::try_from(self.description.textures.len() - 1).map_or(TextureId::NONE, TextureId))
    }
}
