//! The cost of effects that a scene does not use, for each scene of `scenes/`, as `tests/reports/effects.md`:
//!
//! ```text
//! cargo run --release -p strahl-tests --features effects-cost --example effects_cost > tests/reports/effects.md
//! ```
//!
//! Each scene is traced with the prepared effect set of the program (`strahl_engine::prepared`), with all shapes and exactly
//! its effects, with exactly its shapes and effects, and with all effects. Callgrind counts the instructions below
//! `Tracer::trace`. The exit status is 1 if a scene costs more than 6 % extra in the program, or if the pictures differ.
//! Needs valgrind.

use std::error::Error;
use std::path::Path;
use std::process::{Command, ExitCode};

use strahl_core::accel::{
    Accelerator, BvhBuilder, BvhEntry, BvhNode, BvhSize, LeafLayout, List, TraversalStack, TriangleBlock,
    group_count,
};
use strahl_core::geometry::{Aabb, ShapeKind, ShapeKindSet};
use strahl_core::image::Pixel;
use strahl_core::scene::{EffectSet, Effects, LightKind, LightKindSet, TextureKind, TextureKindSet};
use strahl_core::tally::RayCounters;
use strahl_core::{
    AllEffects, Camera, CenterSampler, Limits, Resolution, Rgb, Tile, Tracer, Worker, World, render,
};
use strahl_engine::prepared::{self, prepared_for};
use strahl_session::tables::single;
use strahl_settings::{AccelKind, AccelSettings};

/// Pixels of the picture.
const SIZE: (u32, u32) = (64, 48);

/// Traces a scene with one effect set, and returns the hash of the picture.
type TraceFunction = fn(&Path) -> Result<u64, Box<dyn Error>>;

struct EffectsRow {
    scene: &'static str,
    required: EffectSet,
    exact: TraceFunction,
    exact_effects: TraceFunction,
}

/// Each scene with the effects that it requires.
macro_rules! scenes {
    ($($scene:literal [$($shape:ident),*] [$($light:ident),*] [$($texture:ident),*] [$($effect:ident),*];)*) => {
        [$({
            struct ExactSet;
            impl Effects for ExactSet {
                const SET: EffectSet = EffectSet {
                    shapes: ShapeKindSet::of(&[$(ShapeKind::$shape),*]),
                    lights: LightKindSet::of(&[$(LightKind::$light),*]),
                    textures: TextureKindSet::of(&[$(TextureKind::$texture),*]),
                    $($effect: true,)*
                    ..EffectSet::NONE
                };
            }
            struct ExactEffects;
            impl Effects for ExactEffects {
                const SET: EffectSet = EffectSet { shapes: ShapeKindSet::ALL, ..ExactSet::SET };
            }
            EffectsRow { scene: $scene, required: ExactSet::SET, exact: traced::<ExactSet>, exact_effects: traced::<ExactEffects> }
        }),*]
    };
}

fn rows() -> impl Iterator<Item = EffectsRow> {
    scenes! {
    "classic.toml" [Sphere, Polygon] [Point] [Checker] [highlight, shadows, reflection, transmission];
    "first.toml" [Sphere, Plane] [Directional] [] [highlight, shadows, reflection, transmission];
    "fjord.toml" [Triangle, Plane] [Directional] [Gradient] [shadows, reflection];
    "glass.toml" [Sphere, Triangle, Plane, Polygon, OrientedCuboid, Torus] [Point] [Checker] [highlight, shadows, transmission, absorption];
    "gloss.toml" [Sphere, Plane] [Directional] [Checker] [shadows, reflection, transmission, gloss];
    "knot.toml" [SmoothTriangle, Plane, Cone] [Point] [] [smooth_shading, highlight, shadows, reflection];
    "lens.toml" [Sphere, Plane] [Directional] [Checker] [highlight, shadows, reflection, depth_of_field];
    "marbles.toml" [Sphere, Plane, Torus] [Point] [] [highlight, shadows, reflection, transmission, absorption];
    "motion.toml" [Sphere, Plane, Cuboid] [Directional] [Checker] [highlight, shadows, reflection, motion_blur];
    "paper.toml" [Disc, Polygon] [Directional] [Gradient] [shadows];
    "penumbra.toml" [Sphere, Plane, OrientedCuboid, Cone, Torus] [Sphere, Rectangle] [] [highlight, shadows, soft_shadows];
    "pyramid.toml" [Triangle, Plane] [Directional] [] [shadows, reflection];
    "rotunda.nff" [Sphere, Polygon, Cone] [Point] [] [smooth_shading, highlight, shadows, reflection, transmission];
    "shapes.toml" [Sphere, SmoothTriangle, Plane, Disc, Polygon, OrientedCuboid, Cone, Torus] [Directional] [] [smooth_shading, highlight, shadows, reflection];
    "sphereflake.toml" [Sphere, Plane] [Directional] [] [highlight, shadows, reflection];
    "stage.toml" [Sphere, Plane, Cone] [Spot] [] [highlight, shadows, reflection];
    "stained.toml" [Sphere, Plane, Polygon, Cuboid] [Directional] [] [highlight, shadows, transmission, absorption, colored_shadows];
    "still-life.toml" [Sphere, SmoothTriangle, Plane, Cuboid, Cone] [Point, Directional, Spot] [Gradient] [smooth_shading, highlight, shadows, reflection, transmission, absorption];
    "zoneplate.toml" [Plane] [] [ZonePlate] [];
    }
    .into_iter()
}

/// Traces with the accelerator that the program chooses by default: the list for few items, otherwise the BVH.
fn traced<E: Effects>(path: &Path) -> Result<u64, Box<dyn Error>> {
    let description = strahl_scene::load(path)?;
    let tables = single::scene_tables(&description);
    let scene = tables.scene()?;
    let geometry = scene.descriptor().geometry;
    let boxes: Vec<_> = geometry.all_bounds().collect();
    let size = Resolution::new(SIZE.0, SIZE.1).ok_or("no size")?;
    let camera = Camera::new(&single::camera_descriptor(&description.camera), size)?;
    let levels = description.settings.levels.unwrap_or(Limits::DEFAULT.levels);
    let limits = Limits { levels, ..Limits::DEFAULT };
    let bounded = boxes.iter().filter(|aabb| !aabb.is_empty()).count();
    if AccelSettings::DEFAULT.resolve(bounded).kind == AccelKind::List {
        let mut groups = vec![Aabb::EMPTY; group_count(boxes.len())];
        return hash::<_, E>(&World::new(scene, List::with_boxes(&boxes, &mut groups)?), camera, limits);
    }
    let size_of_bvh = BvhSize::recommended(boxes.len());
    let (mut nodes, mut items) =
        (vec![BvhNode::EMPTY; size_of_bvh.nodes], vec![BvhEntry::EMPTY; size_of_bvh.entries]);
    let builder = BvhBuilder::new(&boxes, LeafLayout::TriangleBlocks(&geometry), &mut nodes, &mut items)?;
    let mut block_buffer = vec![TriangleBlock::EMPTY; builder.block_count()];
    let bvh = builder.into_block_bvh::<TraversalStack<64>>(&geometry, &mut block_buffer)?;
    hash::<_, E>(&World::new(scene, bvh), camera, limits)
}

/// The effects that a scene requires.
fn required_set(path: &Path) -> Result<EffectSet, Box<dyn Error>> {
    let description = strahl_scene::load(path)?;
    let tables = single::scene_tables(&description);
    let size = Resolution::new(SIZE.0, SIZE.1).ok_or("no size")?;
    let camera = Camera::new(&single::camera_descriptor(&description.camera), size)?;
    Ok(EffectSet { depth_of_field: camera.has_depth_of_field(), ..tables.scene()?.required_effects() })
}

/// The hash (FNV-1a) of the picture.
fn hash<A: Accelerator, E: Effects>(
    world: &World<'_, A>,
    camera: Camera,
    limits: Limits,
) -> Result<u64, Box<dyn Error>> {
    let size = Resolution::new(SIZE.0, SIZE.1).ok_or("no size")?;
    let tracer = Tracer::<_, E, 64>::new(world, camera, limits)?;
    let mut hash = 0xcbf2_9ce4_8422_2325_u64;
    let mut sink = |_: Pixel, color: Rgb| {
        for channel in [color.r, color.g, color.b] {
            hash = (hash ^ u64::from(channel.to_bits())).wrapping_mul(0x100_0000_01b3);
        }
    };
    let mut worker = Worker::new(RayCounters::new());
    let Ok(()) = render(
        &mut tracer.with_worker(&mut worker),
        &mut CenterSampler,
        Tile::full(size).pixels(),
        &mut sink,
    );
    Ok(hash)
}

/// The trace function with a prepared effect set of the program.
fn prepared(name: &str) -> Result<TraceFunction, Box<dyn Error>> {
    macro_rules! by_name {
        ($($name:ident)*) => {
            match name {
                $(stringify!($name) => Ok(traced::<prepared::$name>),)*
                "AllEffects" => Ok(traced::<AllEffects>),
                _ => Err(format!("unknown prepared effect set {name}").into()),
            }
        };
    }
    by_name! {
        Unlit Sunlit Whitted SoftShadows SunlitDistributed Stained
    }
}

/// The number of instructions below `trace`, and the hash of the picture.
fn measured(scene: &str, effects: &str) -> Result<(f64, String), Box<dyn Error>> {
    let done = Command::new("valgrind")
        .args(["--tool=callgrind", "--callgrind-out-file=/dev/null", "--toggle-collect=*Tracer<*>::trace"])
        .arg(std::env::current_exe()?)
        .args([scene, effects])
        .output()?;
    let log = String::from_utf8(done.stderr)?;
    let collected = log.lines().find_map(|line| line.rsplit_once("Collected :")?.1.trim().parse().ok());
    Ok((collected.ok_or(log)?, String::from_utf8(done.stdout)?))
}

fn main() -> Result<ExitCode, Box<dyn Error>> {
    let scenes = Path::new(env!("CARGO_MANIFEST_DIR")).join("../scenes");
    let words: Vec<String> = std::env::args().skip(1).collect();
    if let [scene, effects] = &words[..] {
        let row = rows().find(|row| row.scene == scene).ok_or("no such scene")?;
        let trace = match effects.as_str() {
            "exact" => row.exact,
            "effects" => row.exact_effects,
            "prepared" => prepared(prepared_for(&row.required))?,
            "everything" => traced::<AllEffects>,
            _ => return Err("no such effect set".into()),
        };
        println!("{:016x}", trace(&scenes.join(scene))?);
        return Ok(ExitCode::SUCCESS);
    }
    println!("# The cost of unused effects\n");
    println!(
        "Generated by\n\n    cargo run --release -p strahl-tests --features effects-cost --example effects_cost > tests/reports/effects.md\n"
    );
    println!(
        "Instructions of tracing each scene of `scenes/`, {} x {} pixels, counted by callgrind, without loading and building. The\n\
         accelerator is the default of the program: the list with boxes for few items, otherwise the BVH. A tracer is\n\
         compiled for a set of effects. *Own set*: the tracer of all shapes and of exactly the effects, lights and\n\
         textures that the scene requires. Compared with it: *prepared*, the set that the program chooses\n\
         (`strahl_engine::prepared`); *everything*, all effects; *shapes*, the own set with the scene's shapes only,\n\
         as on a device. All four pictures are the same, bit for bit.\n",
        SIZE.0, SIZE.1
    );
    println!(
        "| scene | prepared set | own set, millions | prepared | everything | shapes |\n|---|---|---|---|---|---|"
    );
    let mut passed = true;
    for row in rows() {
        if required_set(&scenes.join(row.scene))? != row.required {
            return Err(format!("{} requires other effects than its row", row.scene).into());
        }
        let name = prepared_for(&row.required);
        let measured =
            ["effects", "prepared", "everything", "exact"].map(|effects| measured(row.scene, effects));
        let [own, prepared, everything, exact] = measured;
        let (own, prepared, everything, exact) = (own?, prepared?, everything?, exact?);
        let over = |it: &(f64, String)| 100.0 * (it.0 / own.0 - 1.0);
        println!(
            "| {} | {name} | {:.2} | {:+.1} % | {:+.1} % | {:+.1} % |",
            row.scene,
            own.0 / 1e6,
            over(&prepared),
            over(&everything),
            over(&exact),
        );
        passed &= over(&prepared) <= 6.0;
        passed &= [&prepared, &everything, &exact].iter().all(|it| it.1 == own.1);
    }
    Ok(if passed { ExitCode::SUCCESS } else { ExitCode::FAILURE })
}
