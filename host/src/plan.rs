//! The plan of effects: what a scene asks to be simulated, and what in the file asks for it.

use std::fmt;

use strahl_core::scene::EffectSet;
use strahl_core::{Material, Rgb, Scene};
pub use strahl_settings::Effect;

use crate::amount::amount;
use crate::description::{Description, Form, Light, Object, Projection, Source};
use crate::stock::single::scene_tables;

/// What asks for an effect, and how it is left out.
trait Asked {
    /// Whether a material asks for it.
    fn needed_by(self, material: &Material) -> bool;

    /// Makes a scene that does not ask for it.
    fn leave_out(self, description: &mut Description);
}

impl Asked for Effect {
    fn needed_by(self, material: &Material) -> bool {
        match self {
            Effect::Reflection => !material.mirror.is_black(),
            Effect::Transmission => material.is_transmitting(),
            Effect::Gloss => material.is_rough(),
            _ => false,
        }
    }

    fn leave_out(self, description: &mut Description) {
        let lights = description.lights.iter_mut().map(|light| &mut light.it);
        let materials = description.materials.iter_mut().map(|material| &mut material.it);
        match self {
            Effect::Shadows => lights.for_each(|light| light.shadows = false),
            Effect::Reflection => materials.for_each(|material| material.mirror = Rgb::BLACK),
            Effect::Transmission => materials.for_each(|material| material.transmitted = Rgb::BLACK),
            Effect::ColoredShadows => description.colored_shadows = None,
            Effect::Penumbra => lights.for_each(|light| match &mut light.source {
                Source::Sphere { radius, .. } => *radius = 0.0,
                Source::Rectangle { soft, .. } => *soft = false,
                _ => {}
            }),
            Effect::Lens => {
                if let Projection::Lens { angle, .. } = description.view.projection {
                    description.view.projection = Projection::Perspective(angle);
                }
            }
            Effect::Gloss => materials.for_each(|material| material.roughness = 0.0),
            // Everything stands where it is at the time 0.
            Effect::Motion => description.moving.clear(),
        }
    }
}

/// Changes a scene so that it asks for none of these, and tells what of them it asked for.
pub fn leave_out(description: &mut Description, effects: &[Effect]) -> Vec<Step> {
    if effects.is_empty() {
        return Vec::new();
    }
    let stock = scene_tables(description);
    // What is no scene asks for nothing; the tracer says what is wrong with it.
    let asks = stock.scene().map_or(EffectSet::NONE, |scene| asked_by(description, &scene));
    let mut steps = plan(description, &asks);
    steps.retain(|step| effects.contains(&step.effect));
    steps.iter_mut().for_each(|step| step.simulated = false);
    effects.iter().for_each(|effect| effect.leave_out(description));
    steps
}

/// What a scene asks for, the camera included.
pub fn asked_by(description: &Description, scene: &Scene<'_>) -> EffectSet {
    EffectSet { lens: description.view.projection.has_lens(), ..scene.effects() }
}

/// One thing in the file that asks for an effect.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Reason {
    /// What asks: `light`, or `material` and its name.
    pub what: String,
    /// Its line, counted from 1; 0 where no file has it.
    pub line: usize,
    /// How many objects are made of it; none for a light.
    pub objects: Option<usize>,
}

impl fmt::Display for Reason {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.what)?;
        if self.line > 0 {
            write!(f, " (line {})", self.line)?;
        }
        match self.objects {
            Some(objects) => write!(f, " on {}", amount(objects, "object")),
            None => Ok(()),
        }
    }
}

/// An effect that the scene asks for, with everything that asks for it, in the order of the file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Step {
    /// The effect.
    pub effect: Effect,
    /// At least one.
    pub reasons: Vec<Reason>,
    /// Whether it is simulated, or was switched off.
    pub simulated: bool,
}

/// What must be simulated of a scene that asks for `asks`, and why.
pub fn plan(description: &Description, asks: &EffectSet) -> Vec<Step> {
    let made_of = made_of(description);
    let called_for = Effect::ALL.into_iter().filter(|effect| effect.is_in(asks));
    let steps = called_for.map(|effect| {
        let one = |what: &str, line| vec![Reason { what: what.into(), line, objects: None }];
        let reasons = match effect {
            Effect::Shadows => lights(description, |light| light.shadows),
            Effect::Penumbra => lights(description, is_soft),
            Effect::ColoredShadows => one("render", description.colored_shadows.unwrap_or(1)),
            Effect::Lens => one("camera", description.view_line),
            Effect::Reflection | Effect::Transmission | Effect::Gloss => {
                materials(description, &made_of, effect)
            }
            Effect::Motion => moving(description),
        };
        Step { effect, reasons, simulated: true }
    });
    steps.collect()
}

fn is_soft(light: &Light) -> bool {
    match light.source {
        Source::Sphere { radius, .. } => radius > 0.0,
        Source::Rectangle { soft, .. } => soft,
        _ => false,
    }
}

fn lights(description: &Description, asks: fn(&Light) -> bool) -> Vec<Reason> {
    let lights = description.lights.iter().filter(|light| asks(&light.it) && !light.it.color.is_black());
    lights
        .map(|light| Reason { what: named("light", &light.name), line: light.line, objects: None })
        .collect()
}

fn materials(description: &Description, made_of: &[usize], effect: Effect) -> Vec<Reason> {
    let used = description.materials.iter().zip(made_of).filter(|(_, objects)| **objects > 0);
    let asking = used.filter(|(material, _)| effect.needed_by(&material.it));
    asking
        .map(|(material, objects)| Reason {
            what: named("material", &material.name),
            line: material.line,
            objects: Some(*objects),
        })
        .collect()
}

fn moving(description: &Description) -> Vec<Reason> {
    let objects = description.moving.iter().filter_map(|motion| description.objects.get(motion.object));
    let reasons = objects.map(|object| Reason {
        what: object.form.name().into(),
        line: object.line as usize,
        objects: matches!(object.form, Form::Mesh { .. }).then(|| objects_in(object)),
    });
    reasons.collect()
}

fn named(what: &str, name: &Option<String>) -> String {
    match name {
        Some(name) => format!("{what} `{name}`"),
        None => what.into(),
    }
}

/// How many objects are made of each material.
fn made_of(description: &Description) -> Vec<usize> {
    let mut made_of = vec![0; description.materials.len()];
    for object in &description.objects {
        if let Some(count) = made_of.get_mut(usize::from(object.material)) {
            *count += objects_in(object);
        }
    }
    made_of
}

/// How many objects an entry of the description is.
pub fn objects_in(object: &Object) -> usize {
    match object.form {
        Form::Mesh { count, .. } => count as usize,
        _ => 1,
    }
}
