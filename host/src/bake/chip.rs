//! Stack and instructions of a baked scene on a Cortex-M4F: measured there, or estimated from event counts.
//!
//! `tests/firmware/check` measures the stack of every set below on the chip, compares the estimates with the
//! instructions of all its scenes, and fails if this module is wrong.

use strahl_core::geometry::{ShapeKind, ShapeKindSet};
use strahl_core::scene::{EffectSet, LightKind, LightKindSet};
use strahl_core::tally::Counters;
use strahl_settings::AccelKind;

/// Maximum stack of a tracer with an effect set, including the worker.
pub struct StackUsage {
    /// Name of the set in messages.
    pub name: &'static str,
    /// Effect set.
    pub set: EffectSet,
    /// Levels of its worker.
    pub levels: u8,
    /// Bytes.
    pub bytes: usize,
}

const LOCAL: EffectSet = EffectSet {
    shapes: ShapeKindSet::of(&[ShapeKind::Plane, ShapeKind::Sphere]),
    lights: LightKindSet::of(&[LightKind::Point]),
    ..EffectSet::NONE
};
const SHADOWS: EffectSet = EffectSet { shadows: true, ..LOCAL };
const MIRRORS: EffectSet = EffectSet { reflection: true, ..SHADOWS };
const GLASS: EffectSet = EffectSet { transmission: true, ..MIRRORS };

const DISTRIBUTED: EffectSet = EffectSet {
    lights: LightKindSet::of(&[LightKind::Sphere]),
    soft_shadows: true,
    gloss: true,
    depth_of_field: true,
    ..GLASS
};

/// The measured sets, smallest first.
pub const STACK_USAGE: [StackUsage; 6] = [
    StackUsage { name: "local", set: LOCAL, levels: 5, bytes: 1120 },
    StackUsage { name: "shadows", set: SHADOWS, levels: 5, bytes: 1216 },
    StackUsage { name: "mirrors", set: MIRRORS, levels: 5, bytes: 1296 },
    StackUsage { name: "glass", set: GLASS, levels: 5, bytes: 1376 },
    StackUsage { name: "distributed", set: DISTRIBUTED, levels: 5, bytes: 1552 },
    StackUsage { name: "everything", set: EffectSet::ALL, levels: 6, bytes: 3232 },
];

/// The smallest measured set that contains `required`.
pub fn stack_usage(required: &EffectSet) -> Option<&'static StackUsage> {
    STACK_USAGE.iter().find(|stack| stack.set.is_superset(required))
}

/// Largest ratio of the estimate to the measured instructions, or the reverse, for the measured scenes.
pub const ESTIMATE_FACTOR: f64 = 1.5;

/// Estimated instructions of a picture, from its event counts.
///
/// Fitted to five scenes whose instructions are counted on the chip. The cost of entering a region is part of
/// the cost of its boxes.
pub fn instructions(counts: &Counters, accelerator: AccelKind) -> u64 {
    // A BVH tests the boxes of a node one after the other; a grid and an octree test one box, for an item
    // that they have looked up.
    let per_box = if accelerator == AccelKind::Bvh { 62 } else { 125 };
    let shapes = ShapeKind::ALL
        .into_iter()
        .map(|kind| counts.shape_tests_by_kind[kind] * instructions_per_shape_test(kind))
        .sum::<u64>();
    INSTRUCTIONS_PER_RAY * counts.rays.sum() + per_box * counts.box_tests.sum() + shapes
}

/// Generating a ray and shading its hit.
const INSTRUCTIONS_PER_RAY: u64 = 570;

/// Instructions of one test of a shape; most tests are misses.
fn instructions_per_shape_test(kind: ShapeKind) -> u64 {
    match kind {
        ShapeKind::Sphere | ShapeKind::Plane | ShapeKind::Polygon | ShapeKind::Disc => 60,
        ShapeKind::Cuboid | ShapeKind::OrientedCuboid | ShapeKind::Cone => 150,
        ShapeKind::Triangle | ShapeKind::SmoothTriangle => 200,
        ShapeKind::Torus => 600,
    }
}
