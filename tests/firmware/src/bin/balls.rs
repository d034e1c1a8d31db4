//! Draws the sphereflake of the procedural databases, baked with its BVH, writes it as linear floats,
//! `balls.f32`, and prints its cost.
//!
//! The exit code is 0, or 1 after a line with the reason.

#![no_std]
#![no_main]

use cortex_m_rt::entry;
use semihosting::{fs::File, io::Write, println, process};
use strahl_core::accel::TraversalStack;
use strahl_core::baked::BakedScene;
use strahl_core::geometry::{ShapeKind, ShapeKindSet};
use strahl_core::scene::{EffectSet, Effects, LightKind, LightKindSet};
use strahl_core::{CenterSampler, World, include_baked_scene};
use strahl_device::draw::{BLACK_ROW, PixelRow, bytes, draw};
use strahl_firmware::packs::draw_settings;
use strahl_firmware::{count, stack};

static SCENE: &[u8] = include_baked_scene!("../../target/packs/balls.strahl");

/// Exactly the effects that the scene requires.
struct SphereflakeEffects;

impl Effects for SphereflakeEffects {
    const SET: EffectSet = EffectSet {
        shapes: ShapeKindSet::of(&[ShapeKind::Sphere, ShapeKind::Polygon]),
        lights: LightKindSet::of(&[LightKind::Point]),
        highlight: true,
        shadows: true,
        reflection: true,
        ..EffectSet::NONE
    };
}

#[entry]
fn main() -> ! {
    static mut ROW: PixelRow = BLACK_ROW;
    match picture(ROW) {
        Ok(()) => process::exit(0),
        Err(reason) => {
            println!("balls: {reason}");
            process::exit(1)
        }
    }
}

fn picture(row: &mut PixelRow) -> Result<(), &'static str> {
    let (pack, opening) = count::of(|| BakedScene::open(SCENE));
    let pack = pack.map_err(|_| "invalid baked scene")?;
    if pack.scene().required_effects() != SphereflakeEffects::SET {
        return Err("the scene does not require exactly the effects of the tracer");
    }
    let bvh = pack.bvh::<TraversalStack<32>>().map_err(|_| "the scene has no BVH")?;
    let settings = draw_settings(&pack)?;
    let mut file = File::create(c"balls.f32").map_err(|_| "balls.f32 cannot be created")?;
    let row = row.get_mut(..settings.size.width() as usize).ok_or("the picture is too wide")?;
    let cost = draw::<_, SphereflakeEffects, _, _, _, 5>(
        &World::new(*pack.scene(), bvh),
        settings,
        &mut CenterSampler,
        (),
        row,
        count::now,
        bytes,
        |row| file.write_all(row.as_flattened().as_flattened()).is_ok(),
    )?;
    let stack = stack::used();
    println!("pixels {}", settings.size.width() * settings.size.height());
    println!("instructions {}", cost.instructions);
    println!("stack {stack}");
    println!("worker {}", cost.worker);
    println!("pack {}", SCENE.len());
    println!("opening {opening}");
    Ok(())
}

#[panic_handler]
fn panic(info: &core::panic::PanicInfo) -> ! {
    println!("balls: {info}");
    process::exit(1)
}
