//! The effects that a scene requires, with reasons.

use std::fmt;

use strahl_core::{Material, Rgb};
use strahl_settings::OptionalEffect;

use crate::description::{
    LightDescription, LightSourceDescription, LoadedScene, ObjectDescription, ProjectionDescription,
    ShapeDescription,
};
use crate::quantity::quantity;

/// One part of the scene that requires an effect.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Reason {
    /// The part of the scene: `light` or `material` with its name, `camera`, `render` or a shape.
    pub source: String,
    /// Its line, counted from 1; 0 if it is not in a file.
    pub line: usize,
    /// The number of objects with this material, or of triangles of this mesh; `None` for other parts.
    pub objects: Option<usize>,
}

impl fmt::Display for Reason {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.source)?;
        if self.line > 0 {
            write!(f, " (line {})", self.line)?;
        }
        match self.objects {
            Some(objects) => write!(f, " on {}", quantity(objects, "object")),
            None => Ok(()),
        }
    }
}

/// An effect that the scene requires, with all reasons in the order of the file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct PlannedEffect {
    /// The effect.
    pub effect: OptionalEffect,
    /// The reasons, at least one.
    pub reasons: Vec<Reason>,
    /// Whether it is rendered; false if it was disabled.
    pub enabled: bool,
}

/// The effects that the scene requires, with reasons.
pub fn plan(description: &LoadedScene) -> Vec<PlannedEffect> {
    let used = MaterialUse::of(description);
    let planned = OptionalEffect::ALL.into_iter().map(|effect| {
        let reasons = reasons(description, &used, effect);
        PlannedEffect { effect, reasons, enabled: true }
    });
    planned.filter(|it| !it.reasons.is_empty()).collect()
}

/// Changes a scene so that it requires none of these effects, and returns those that it required.
pub fn disable(description: &mut LoadedScene, effects: &[OptionalEffect]) -> Vec<PlannedEffect> {
    let mut planned = plan(description);
    planned.retain(|it| effects.contains(&it.effect));
    planned.iter_mut().for_each(|it| it.enabled = false);
    effects.iter().for_each(|effect| disable_one(description, *effect));
    planned
}

/// How materials are used.
struct MaterialUse {
    /// The number of objects with each material.
    objects: Vec<usize>,
    /// Whether any used material is affected by lights.
    is_lit: bool,
}

impl MaterialUse {
    fn of(description: &LoadedScene) -> Self {
        let objects = object_counts(description);
        let mut used = description.materials.iter().zip(&objects).filter(|(_, objects)| **objects > 0);
        let is_lit = used.any(|(material, _)| material.value.is_lit());
        MaterialUse { objects, is_lit }
    }
}

/// The parts of the scene that require an effect.
fn reasons(description: &LoadedScene, used: &MaterialUse, effect: OptionalEffect) -> Vec<Reason> {
    let one = |what: &str, line| vec![Reason { source: what.into(), line, objects: None }];
    let is_called_for = |effect| !reasons(description, used, effect).is_empty();
    match effect {
        OptionalEffect::Shadows => light_reasons(description, used, |light| light.shadows),
        OptionalEffect::SoftShadows => light_reasons(description, used, is_area_light),
        OptionalEffect::ColoredShadows => match description.colored_shadows_line {
            Some(line)
                if is_called_for(OptionalEffect::Shadows) && is_called_for(OptionalEffect::Transmission) =>
            {
                one("render", line)
            }
            _ => Vec::new(),
        },
        OptionalEffect::Lens => match description.camera.projection {
            ProjectionDescription::Lens { .. } => one("camera", description.camera_line),
            _ => Vec::new(),
        },
        OptionalEffect::Reflection | OptionalEffect::Transmission | OptionalEffect::Gloss => {
            material_reasons(description, &used.objects, effect)
        }
        OptionalEffect::Motion => motion_reasons(description),
    }
}

/// Whether a material requires an effect.
fn is_required_by(effect: OptionalEffect, material: &Material) -> bool {
    match effect {
        OptionalEffect::Reflection => !material.reflection.is_black(),
        OptionalEffect::Transmission => material.is_transmitting(),
        OptionalEffect::Gloss => material.is_glossy(),
        _ => false,
    }
}

/// Changes a scene so that it does not require an effect.
fn disable_one(description: &mut LoadedScene, effect: OptionalEffect) {
    let lights = description.lights.iter_mut().map(|light| &mut light.value);
    let materials = description.materials.iter_mut().map(|material| &mut material.value);
    match effect {
        OptionalEffect::Shadows => lights.for_each(|light| light.shadows = false),
        OptionalEffect::Reflection => materials.for_each(|material| material.reflection = Rgb::BLACK),
        OptionalEffect::Transmission => materials.for_each(|material| material.transmission = Rgb::BLACK),
        OptionalEffect::ColoredShadows => description.colored_shadows_line = None,
        OptionalEffect::SoftShadows => lights.for_each(|light| match &mut light.source {
            LightSourceDescription::Sphere { radius, .. } => *radius = 0.0,
            LightSourceDescription::Rectangle { soft_shadows, .. } => *soft_shadows = false,
            LightSourceDescription::Point { .. }
            | LightSourceDescription::Directional { .. }
            | LightSourceDescription::Spot { .. } => {}
        }),
        OptionalEffect::Lens => {
            if let ProjectionDescription::Lens { angle, .. } = description.camera.projection {
                description.camera.projection = ProjectionDescription::Perspective(angle);
            }
        }
        OptionalEffect::Gloss => materials.for_each(|material| material.roughness = 0.0),
        // All objects are at their positions at time 0.
        OptionalEffect::Motion => description.motions.clear(),
    }
}

fn is_area_light(light: &LightDescription) -> bool {
    match light.source {
        LightSourceDescription::Sphere { radius, .. } => radius > 0.0,
        LightSourceDescription::Rectangle { soft_shadows, .. } => soft_shadows,
        LightSourceDescription::Point { .. }
        | LightSourceDescription::Directional { .. }
        | LightSourceDescription::Spot { .. } => false,
    }
}

fn light_reasons(
    description: &LoadedScene,
    used: &MaterialUse,
    asks: fn(&LightDescription) -> bool,
) -> Vec<Reason> {
    let is_asking = |light: &LightDescription| used.is_lit && asks(light) && !light.color.is_black();
    let lights = description.lights.iter().filter(|light| is_asking(&light.value));
    lights
        .map(|light| Reason { source: source_name("light", &light.name), line: light.line, objects: None })
        .collect()
}

fn material_reasons(description: &LoadedScene, made_of: &[usize], effect: OptionalEffect) -> Vec<Reason> {
    let used = description.materials.iter().zip(made_of).filter(|(_, objects)| **objects > 0);
    let asking = used.filter(|(material, _)| is_required_by(effect, &material.value));
    asking
        .map(|(material, objects)| Reason {
            source: source_name("material", &material.name),
            line: material.line,
            objects: Some(*objects),
        })
        .collect()
}

fn motion_reasons(description: &LoadedScene) -> Vec<Reason> {
    let objects = description.motions.iter().filter_map(|motion| description.objects.get(motion.object));
    let reasons = objects.map(|object| Reason {
        source: object.shape.name().into(),
        line: object.line as usize,
        objects: matches!(object.shape, ShapeDescription::Mesh { .. }).then(|| object_count(object)),
    });
    reasons.collect()
}

fn source_name(what: &str, name: &Option<String>) -> String {
    match name {
        Some(name) => format!("{what} `{name}`"),
        None => what.into(),
    }
}

/// The number of objects with each material.
fn object_counts(description: &LoadedScene) -> Vec<usize> {
    let mut made_of = vec![0; description.materials.len()];
    for object in &description.objects {
        if let Some(count) = made_of.get_mut(usize::from(object.material)) {
            *count += object_count(object);
        }
    }
    made_of
}

/// The number of objects that an entry stands for: the triangles of a mesh, otherwise 1.
pub fn object_count(object: &ObjectDescription) -> usize {
    match object.shape {
        ShapeDescription::Mesh { count, .. } => count as usize,
        _ => 1,
    }
}
