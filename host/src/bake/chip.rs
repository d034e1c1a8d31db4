//! What a baked scene takes on a Cortex-M4F: measured there, or estimated from what is counted here.
//!
//! `tests/firmware/check` measures the stack of every set below on the chip, holds the estimates
//! against the instructions of all its scenes, and fails where this room is wrong.

use strahl_core::geometry::{ShapeKind, ShapeSet};
use strahl_core::scene::{EffectSet, LightKind, LightSet};
use strahl_core::tally::Counters;
use strahl_settings::AccelKind;

/// The most bytes of stack that a tracer of this set takes, the worker among them.
pub struct Stack {
    /// What it can do.
    pub name: &'static str,
    /// The set.
    pub set: EffectSet,
    /// Levels that its worker has room for.
    pub levels: u8,
    /// Bytes.
    pub bytes: usize,
}

const LOCAL: EffectSet = EffectSet {
    shapes: ShapeSet::of(&[ShapeKind::Plane, ShapeKind::Sphere]),
    lights: LightSet::of(&[LightKind::Point]),
    ..EffectSet::NONE
};
const SHADOWS: EffectSet = EffectSet { shadows: true, ..LOCAL };
const MIRRORS: EffectSet = EffectSet { reflection: true, ..SHADOWS };
const GLASS: EffectSet = EffectSet { transmission: true, ..MIRRORS };

const DISTRIBUTED: EffectSet = EffectSet {
    lights: LightSet::of(&[LightKind::Sphere]),
    penumbra: true,
    gloss: true,
    depth_of_field: true,
    ..GLASS
};

/// From the smallest to everything.
pub const STACKS: [Stack; 6] = [
    Stack { name: "local", set: LOCAL, levels: 5, bytes: 1120 },
    Stack { name: "shadows", set: SHADOWS, levels: 5, bytes: 1216 },
    Stack { name: "mirrors", set: MIRRORS, levels: 5, bytes: 1296 },
    Stack { name: "glass", set: GLASS, levels: 5, bytes: 1376 },
    Stack { name: "distributed", set: DISTRIBUTED, levels: 5, bytes: 1552 },
    Stack { name: "everything", set: EffectSet::ALL, levels: 6, bytes: 3232 },
];

/// The first set that is measured and contains what is asked for.
pub fn stack(asks: &EffectSet) -> Option<&'static Stack> {
    STACKS.iter().find(|stack| stack.set.is_superset(asks))
}

/// The estimate is this factor off at most, either way, for the scenes that are measured.
pub const DOUBT: f64 = 1.5;

/// Instructions of a picture, by what happened in it on the way through an accelerator.
///
/// Fitted to five scenes whose instructions are counted on the chip. A step into a region is part of
/// what its boxes cost.
pub fn instructions(counts: &Counters, accelerator: AccelKind) -> u64 {
    // A hierarchy holds the boxes of a node against a ray one after the other; a grid and an octree
    // hold one box, for an item that they have looked up.
    let per_box = if accelerator == AccelKind::Bvh { 62 } else { 125 };
    let shapes = ShapeKind::ALL
        .into_iter()
        .map(|kind| counts.shape_tests_by_kind[kind] * per_shape(kind))
        .sum::<u64>();
    PER_RAY * counts.rays.sum() + per_box * counts.box_tests.sum() + shapes
}

/// Making a ray, and shading what it meets.
const PER_RAY: u64 = 570;

/// Holding a shape against a ray: most are missed.
fn per_shape(kind: ShapeKind) -> u64 {
    match kind {
        ShapeKind::Sphere | ShapeKind::Plane | ShapeKind::Polygon | ShapeKind::Disc => 60,
        ShapeKind::Cuboid | ShapeKind::OrientedCuboid | ShapeKind::Cone => 150,
        ShapeKind::Triangle | ShapeKind::SmoothTriangle => 200,
        ShapeKind::Torus => 600,
    }
}
