//! Lights, in the order of the file.

use std::ops::Range;

use strahl_core::math::try_normalize;
use strahl_core::{Rgb, vec3};

use super::builder::SceneBuilder;
use crate::description::{Float3, LightDescription, LightSourceDescription, Located, vec3_of};
use crate::diagnostics::Diagnostic;
use crate::toml_scene::format::{RectangleLightTable, SceneFile, SpotLightTable};
use crate::toml_scene::value::{
    ColorValue, DirectionValue, FalloffValue, Intensity, PointValue, RectangleSize, Spanned,
};

/// The default ambient light, a gray.
const DEFAULT_AMBIENT: f32 = 0.1;

/// The default cone of a spot light, full angle in degrees.
const DEFAULT_SPOT_ANGLE: f32 = 40.0;

impl SceneBuilder<'_> {
    /// Adds all lights of the file.
    pub fn lights(&mut self, file: &SceneFile) {
        let mut lights: Vec<(usize, Option<Located<LightDescription>>)> = Vec::new();
        for Spanned { value: it, span } in &file.point_light.0 {
            let source =
                LightSourceDescription::Point { position: it.position.0, falloff: falloff(it.falloff) };
            let light =
                self.described_light(Some(source), &it.color, &it.intensity, it.shadows, &it.name, span);
            lights.push((span.start, light));
        }
        for Spanned { value: it, span } in &file.directional_light.0 {
            let source = LightSourceDescription::Directional { to_light: it.direction.0.map(|x| 0.0 - x) };
            let light =
                self.described_light(Some(source), &it.color, &it.intensity, it.shadows, &it.name, span);
            lights.push((span.start, light));
        }
        for Spanned { value: it, span } in &file.spot_light.0 {
            let source = self.spot(it, span);
            let light = self.described_light(source, &it.color, &it.intensity, it.shadows, &it.name, span);
            lights.push((span.start, light));
        }
        for Spanned { value: it, span } in &file.sphere_light.0 {
            let (position, radius, falloff) = (it.position.0, it.radius.0, falloff(it.falloff));
            let source = LightSourceDescription::Sphere { position, radius, falloff };
            let light =
                self.described_light(Some(source), &it.color, &it.intensity, it.shadows, &it.name, span);
            lights.push((span.start, light));
        }
        for Spanned { value: it, span } in &file.rectangle_light.0 {
            let source = self.rectangle(it, span);
            let light = self.described_light(source, &it.color, &it.intensity, it.shadows, &it.name, span);
            lights.push((span.start, light));
        }
        lights.sort_by_key(|(place, _)| *place);
        self.scene.lights = lights.into_iter().filter_map(|(_, light)| light).collect();

        let ambient = file.ambient_light.0.as_ref();
        self.scene.ambient = match ambient {
            Some(Spanned { value: it, .. }) => {
                let gray = Spanned { value: ColorValue(Rgb::gray(DEFAULT_AMBIENT)), span: 0..0 };
                let color = Some(it.color.as_ref().map_or(gray, Spanned::clone));
                self.radiance(&color, &it.intensity).unwrap_or(Rgb::BLACK)
            }
            None => Rgb::gray(DEFAULT_AMBIENT),
        };
    }

    /// The direction of a light that has `at` or `direction`; `help` explains `at`.
    fn light_direction(
        &mut self,
        position: Float3,
        at: &Option<Spanned<PointValue>>,
        direction: &Option<Spanned<DirectionValue>>,
        (table, help): (&str, &str),
        span: &Range<usize>,
    ) -> Option<Float3> {
        match (at, direction) {
            (None, Some(direction)) => Some(direction.value.0),
            (Some(at), None) => {
                let direction: Float3 = std::array::from_fn(|axis| at.value.0[axis] - position[axis]);
                if direction == [0.0; 3] {
                    let diagnostic = Diagnostic::new(at.span.clone(), "`at` must differ from `position`");
                    return self.reader.report(diagnostic);
                }
                Some(direction)
            }
            (Some(at), Some(direction)) => {
                let diagnostic =
                    Diagnostic::new(direction.span.clone(), "a light has either `direction` or `at`");
                self.reader.report(diagnostic.with_related(at.span.clone(), "the other one"))
            }
            (None, None) => {
                let message = format!("`{table}` needs `at` or `direction`");
                self.reader.report_missing(Diagnostic::new(span.clone(), message).with_help(help))
            }
        }
    }

    fn rectangle(&mut self, it: &RectangleLightTable, span: &Range<usize>) -> Option<LightSourceDescription> {
        let position = it.position.0;
        let names = ("rectangle_light", "`at` is a point in front of its center");
        let front =
            try_normalize(vec3_of(self.light_direction(position, &it.at, &it.direction, names, span)?))?;
        let RectangleSize([width, height]) = it.size;
        let up = match &it.up {
            Some(up) => vec3_of(up.value.0),
            // +y is parallel to a vertical direction.
            None if front.x == 0.0 && front.z == 0.0 => vec3(0.0, 0.0, 1.0),
            None => vec3(0.0, 1.0, 0.0),
        };
        let Some(right) = try_normalize(up).and_then(|up| try_normalize(up.cross(front))) else {
            let span = it.up.as_ref().map_or(span, |up| &up.span);
            let diagnostic = Diagnostic::new(span.clone(), "`up` is parallel to the light's direction");
            return self.reader.report(diagnostic.with_help("choose another `up`"));
        };
        let half = [right * (0.5 * width), front.cross(right) * (0.5 * height)];
        let half = half.map(|half| half.to_array());
        Some(LightSourceDescription::Rectangle {
            position,
            half_edges: half,
            soft_shadows: true,
            falloff: falloff(it.falloff),
        })
    }

    fn spot(&mut self, it: &SpotLightTable, span: &Range<usize>) -> Option<LightSourceDescription> {
        let position = it.position.0;
        let names = ("spot_light", "`at` is a point on the axis of its cone");
        let direction = self.light_direction(position, &it.at, &it.direction, names, span)?;
        let angle = it.angle.map_or(DEFAULT_SPOT_ANGLE, |angle| angle.0);
        let bright_angle = match &it.bright_angle {
            Some(Spanned { value: bright, span }) if bright.0 > angle => {
                let message = format!("`bright_angle` must be at most `angle`, which is {angle}");
                return self.reader.report(Diagnostic::new(span.clone(), message));
            }
            Some(bright) => bright.value.0,
            None => 0.8 * angle,
        };
        let (bright, dark) = (0.5 * bright_angle, 0.5 * angle);
        Some(LightSourceDescription::Spot {
            position,
            direction,
            inner_angle: bright,
            outer_angle: dark,
            falloff: falloff(it.falloff),
        })
    }

    fn described_light(
        &mut self,
        source: Option<LightSourceDescription>,
        color: &Option<Spanned<ColorValue>>,
        intensity: &Option<Spanned<Intensity>>,
        shadows: Option<bool>,
        name: &Option<String>,
        span: &Range<usize>,
    ) -> Option<Located<LightDescription>> {
        let color = self.radiance(color, intensity)?;
        let it = LightDescription { source: source?, color, shadows: shadows != Some(false) };
        Some(Located { value: it, line: self.lines.line_number(span.start), name: name.clone() })
    }

    /// The color times the intensity.
    fn radiance(
        &mut self,
        color: &Option<Spanned<ColorValue>>,
        intensity: &Option<Spanned<Intensity>>,
    ) -> Option<Rgb> {
        let base = color.as_ref().map_or(Rgb::WHITE, |color| color.value.0);
        let Some(Spanned { value: Intensity(factor), span }) = intensity else { return Some(base) };
        let shining = base * *factor;
        if !shining.is_in_range(Rgb::MAX_CHANNEL) {
            let message = format!("`color` times `intensity` must be at most {}", Rgb::MAX_CHANNEL);
            return self.reader.report(Diagnostic::new(span.clone(), message));
        }
        Some(shining)
    }
}

fn falloff(falloff: Option<FalloffValue>) -> Float3 {
    falloff.map_or([1.0, 0.0, 0.0], |falloff| falloff.0)
}
