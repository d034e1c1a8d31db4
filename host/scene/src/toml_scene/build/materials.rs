//! Materials and textures.

use std::ops::Range;

use strahl_core::scene::{FresnelModel, TextureId};
use strahl_core::{Material, Rgb};

use super::builder::SceneBuilder;
use crate::description::{TextureDescription, vec3_of};
use crate::diagnostics::Diagnostic;
use crate::quote::quoted;
use crate::toml_scene::format::{self, MaterialRef};
use crate::toml_scene::table::TableArray;
use crate::toml_scene::value::Spanned;

/// The minimum size of a checker cell: the core stores cells per length.
const MIN_CELL: f32 = 1e-14;

impl SceneBuilder<'_> {
    /// Adds the named materials.
    pub fn materials(&mut self, materials: &TableArray<format::MaterialTable>) {
        for material in &materials.0 {
            let Some(name) = &material.value.name else {
                let diagnostic = Diagnostic::new(material.span.clone(), "`material` needs a `name`");
                self.reader.report_missing::<()>(diagnostic.with_help("objects refer to it by this name"));
                continue;
            };
            if let Some(first) = self.reader.material_names.span_of(&name.value)
                && *first != name.span
            {
                let message = format!("duplicate material name {}", quoted(&name.value));
                let diagnostic = Diagnostic::new(name.span.clone(), message);
                self.reader.diagnostics.push(diagnostic.with_related(first.clone(), "the first"));
                continue;
            }
            if let Some(place) = self.material(material, Some(name.value.clone())) {
                self.material_ids.named.insert(name.value.clone(), place);
            }
        }
    }

    /// The index of an object's material; `None` after an error.
    pub fn material_id(&mut self, surface: &Option<MaterialRef>, span: &Range<usize>) -> Option<u16> {
        match surface {
            Some(MaterialRef::Named(name)) => self.material_ids.named.get(name).copied(),
            Some(MaterialRef::Inline(own)) => self.material(own, None),
            None => {
                if self.material_ids.default.is_none() {
                    self.material_ids.default = self.add_material(Material::matte(Rgb::WHITE), None, span);
                }
                self.material_ids.default
            }
        }
    }

    /// Adds a material and returns its index.
    fn material(&mut self, at: &Spanned<format::MaterialTable>, name: Option<String>) -> Option<u16> {
        let it = &at.value;
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
        let has_shininess = it.shininess.is_some_and(|s| s.0 > 0.0);
        let highlight = it.highlight.map_or(if has_shininess { Rgb::gray(0.5) } else { Rgb::BLACK }, |c| c.0);
        let exponent = it.shininess.map_or(if highlight.is_black() { 0.0 } else { 50.0 }, |s| s.0);
        let times = |share: Rgb| {
            Rgb::new(color.r * share.r, color.g * share.g, color.b * share.b).clamp_max(Rgb::MAX_CHANNEL)
        };
        if transmitted.is_black() {
            self.warn_unused_keys(it);
        }
        if let Some(roughness) = &it.roughness
            && transmitted.is_black()
            && mirror.is_black()
        {
            let line = self.lines.line_number(roughness.span.start);
            let warning =
                format!("`roughness` in line {line} has no effect without `mirror` or `transmission`");
            self.scene.warnings.push(warning);
        }
        let material = Material {
            ambient: times(ambient),
            diffuse: times(diffuse),
            texture,
            highlight,
            highlight_exponent: exponent,
            reflection: mirror,
            transmission: transmitted,
            roughness: it.roughness.as_ref().map_or(0.0, |roughness| roughness.value.0),
            refractive_index: it.index.as_ref().map_or(1.5, |index| index.value.0),
            fresnel: match it.fresnel {
                Some(Spanned { value: true, .. }) => FresnelModel::Dielectric,
                _ => FresnelModel::None,
            },
            attenuation_length: it
                .clarity
                .as_ref()
                .map_or(Material::MATTE.attenuation_length, |clarity| clarity.value.0),
            priority: it.priority.as_ref().map_or(0, |priority| priority.value.0),
            two_sided: it.one_sided != Some(true),
        };
        // Without transmission there is no refraction.
        let index =
            if transmitted.is_black() { Material::MATTE.refractive_index } else { material.refractive_index };
        self.add_material(Material { refractive_index: index, ..material }, name, &at.span)
    }

    /// Warns of keys that are unused without `transmission`.
    fn warn_unused_keys(&mut self, it: &format::MaterialTable) {
        let keys = [
            ("index", it.index.as_ref().map(|at| at.span.start)),
            ("fresnel", it.fresnel.as_ref().filter(|at| at.value).map(|at| at.span.start)),
            ("clarity", it.clarity.as_ref().map(|at| at.span.start)),
            ("priority", it.priority.as_ref().map(|at| at.span.start)),
        ];
        for (key, place) in keys.into_iter().filter_map(|(key, place)| Some((key, place?))) {
            let line = self.lines.line_number(place);
            let warning = format!("`{key}` in line {line} has no effect without `transmission`");
            self.scene.warnings.push(warning);
        }
    }

    /// The id of a material's texture, or of none; `None` after an error.
    fn texture(&mut self, it: &format::MaterialTable) -> Option<TextureId> {
        let mut kinds: Vec<_> = [
            ("checker", it.checker.as_ref().map(|at| &at.span)),
            ("gradient", it.gradient.as_ref().map(|at| &at.span)),
            ("zone_plate", it.zone_plate.as_ref().map(|at| &at.span)),
        ]
        .into_iter()
        .filter_map(|(kind, span)| Some((kind, span?.clone())))
        .collect();
        if let [(one, _), (other, _), ..] = &kinds[..] {
            let message = format!("a material has either `{one}` or `{other}`");
            kinds.sort_by_key(|(_, span)| span.start);
            let diagnostic = Diagnostic::new(kinds[1].1.clone(), message);
            return self.reader.report(diagnostic.with_related(kinds[0].1.clone(), "the other one"));
        }
        let texture = match (&it.checker, &it.gradient, &it.zone_plate) {
            (None, None, None) => return Some(TextureId::NONE),
            (_, _, Some(Spanned { value: plate, .. })) => TextureDescription::ZonePlate {
                from: plate.from.map_or(Rgb::WHITE, |c| c.0),
                to: plate.to.map_or(Rgb::BLACK, |c| c.0),
                origin: plate.origin.map_or([0.0; 3], |p| p.0),
                frequency: plate.frequency.0,
            },
            (Some(Spanned { value: checker, .. }), _, _) => {
                let size = checker.size.as_ref().map_or([1.0, 0.0, 1.0], |size| size.value.0);
                if let Some(at) = &checker.size
                    && size.iter().any(|size| *size > 0.0 && *size < MIN_CELL)
                {
                    let message = format!("a checker cell must be 0 or at least {MIN_CELL:e}");
                    return self.reader.report(Diagnostic::new(at.span.clone(), message));
                }
                TextureDescription::Checker {
                    even: checker.even.map_or(Rgb::WHITE, |c| c.0),
                    odd: checker.odd.map_or(Rgb::gray(0.1), |c| c.0),
                    origin: checker.origin.map_or([0.0; 3], |p| p.0),
                    size,
                }
            }
            (_, Some(Spanned { value: gradient, .. }), _) => {
                let along = vec3_of(gradient.end.value.0) - vec3_of(gradient.start.0);
                // The core divides by its square.
                if along.dot(along) <= 0.0 {
                    let diagnostic =
                        Diagnostic::new(gradient.end.span.clone(), "`start` and `end` must differ");
                    return self.reader.report(diagnostic);
                }
                TextureDescription::Gradient {
                    from: gradient.from.map_or(Rgb::BLACK, |c| c.0),
                    to: gradient.to.map_or(Rgb::WHITE, |c| c.0),
                    start: gradient.start.0,
                    end: gradient.end.value.0,
                }
            }
        };
        self.scene.textures.push(texture);
        // There are no more textures than materials, whose number is checked when they are added.
        Some(u16::try_from(self.scene.textures.len() - 1).map_or(TextureId::NONE, TextureId))
    }
}
