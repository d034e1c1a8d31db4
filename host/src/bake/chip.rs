//! Stack and instructions that a baked scene needs on a Cortex-M4F.
//!
//! The stack, in bytes, was measured on the chip for six effect sets. A scene is reported with the smallest of these
//! sets that contains its effects. The instructions of a picture are estimated: the events that are counted while it is
//! rendered on the workstation, times the instructions of each kind of event.
//!
//! `tests/firmware/check` measures the stack of each set and the instructions of its scenes again, and fails if a number
//! of this module is wrong.

use strahl_core::geometry::{ShapeKind, ShapeKindSet};
use strahl_core::scene::{EffectSet, LightKind, LightKindSet};
use strahl_core::tally::Counters;
use strahl_settings::AccelKind;

/// The measured maximum stack of a tracer that is compiled for an effect set, including its worker.
pub struct StackUsage {
    /// The name of the set in messages.
    pub name: &'static str,
    /// The effect set.
    pub set: EffectSet,
    /// The number of levels that the worker stores.
    pub levels: u8,
    /// The maximum stack, in bytes.
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

/// The stack of the smallest measured set that contains `required`; `None` if no set does.
pub fn stack_usage(required: &EffectSet) -> Option<&'static StackUsage> {
    STACK_USAGE.iter().find(|stack| stack.set.is_superset(required))
}

/// How far [`instructions`] may be off: for every measured scene, the estimate and the measurement differ by at most this
/// factor.
pub const ESTIMATE_FACTOR: f64 = 1.5;

/// The estimated number of instructions that the chip executes for a picture with these event counts.
///
/// Counted are rays, box tests and shape tests. The instructions of each event are fitted to five scenes whose
/// instructions were counted on the chip. The cost of entering a region is part of the cost of its boxes.
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

/// Instructions of one ray: it is generated and its hit is shaded.
const INSTRUCTIONS_PER_RAY: u64 = 570;

/// Instructions of one shape test, as a mean over hits and misses; most tests are misses.
fn instructions_per_shape_test(kind: ShapeKind) -> u64 {
    match kind {
        ShapeKind::Sphere | ShapeKind::Plane | ShapeKind::Polygon | ShapeKind::Disc => 60,
        ShapeKind::Cuboid | ShapeKind::OrientedCuboid | ShapeKind::Cone => 150,
        ShapeKind::Triangle | ShapeKind::SmoothTriangle => 200,
        ShapeKind::Torus => 600,
    }
}
