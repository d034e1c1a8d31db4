//! The plan of effects: what a scene asks to be simulated, and what in the file asks for it.

use std::fmt;

use strahl_core::{EffectSet, Material};

use crate::description::{Description, Form, Object};

/// An effect that a scene can ask for and a user can switch off, by its name on the command line.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Effect {
    /// Things stand in the way of light.
    Shadows,
    /// Mirrors.
    Reflection,
    /// Light passes through bodies.
    Transmission,
}

impl Effect {
    /// Every effect.
    pub const ALL: [Effect; 3] = [Effect::Shadows, Effect::Reflection, Effect::Transmission];

    /// The name on the command line.
    pub fn name(self) -> &'static str {
        match self {
            Effect::Shadows => "shadows",
            Effect::Reflection => "reflection",
            Effect::Transmission => "transmission",
        }
    }

    /// Whether it is in a set.
    pub fn is_in(self, set: &EffectSet) -> bool {
        match self {
            Effect::Shadows => set.shadows,
            Effect::Reflection => set.reflection,
            Effect::Transmission => set.transmission,
        }
    }

    /// Whether a material asks for it.
    fn is_asked_by(self, material: &Material) -> bool {
        match self {
            Effect::Shadows => false,
            Effect::Reflection => !material.mirror.is_black(),
            Effect::Transmission => material.is_transmitting(),
        }
    }
}

impl fmt::Display for Effect {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
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
            Some(1) => write!(f, " on 1 object"),
            Some(objects) => write!(f, " on {objects} objects"),
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
}

/// What must be simulated of a scene that asks for `asks`, and why.
pub fn plan(description: &Description, asks: &EffectSet) -> Vec<Step> {
    let made_of = made_of(description);
    let called_for = Effect::ALL.into_iter().filter(|effect| effect.is_in(asks));
    let steps = called_for.map(|effect| {
        let reasons = match effect {
            Effect::Shadows => lights(description),
            _ => materials(description, &made_of, effect),
        };
        Step { effect, reasons }
    });
    steps.collect()
}

fn lights(description: &Description) -> Vec<Reason> {
    let lights = description.lights.iter().filter(|light| light.it.shadows && !light.it.color.is_black());
    lights
        .map(|light| Reason { what: named("light", &light.name), line: light.line, objects: None })
        .collect()
}

fn materials(description: &Description, made_of: &[usize], effect: Effect) -> Vec<Reason> {
    let used = description.materials.iter().zip(made_of).filter(|(_, objects)| **objects > 0);
    let asking = used.filter(|(material, _)| effect.is_asked_by(&material.it));
    asking
        .map(|(material, objects)| Reason {
            what: named("material", &material.name),
            line: material.line,
            objects: Some(*objects),
        })
        .collect()
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
