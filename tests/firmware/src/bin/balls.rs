//! Draws the sphereflake of the procedural databases, baked with its hierarchy, writes it as linear
//! floats, `balls.f32`, and tells what it took.
//!
//! Exit code 0, or 1 and a line that says why.

#![no_std]
#![no_main]

use cortex_m_rt::entry;
use semihosting::{fs::File, io::Write, println, process};
use strahl_core::accel::TraversalStack;
use strahl_core::baked::Pack;
use strahl_core::geometry::{ShapeKind, ShapeSet};
use strahl_core::scene::{EffectSet, Effects, LightKind, LightSet};
use strahl_core::{Single, World, include_baked_scene};
use strahl_firmware::draw::{DARK, Row, bytes, draw};
use strahl_firmware::packs::wanted;
use strahl_firmware::{count, stack};

static SCENE: &[u8] = include_baked_scene!("../../target/packs/balls.strahl");

/// Exactly what the scene asks for.
struct Mirrors;

impl Effects for Mirrors {
    const SET: EffectSet = EffectSet {
        shapes: ShapeSet::of(&[ShapeKind::Sphere, ShapeKind::Polygon]),
        lights: LightSet::of(&[LightKind::Point]),
        highlight: true,
        shadows: true,
        reflection: true,
        ..EffectSet::NONE
    };
}

#[entry]
fn main() -> ! {
    static mut ROW: Row = DARK;
    match picture(ROW) {
        Ok(()) => process::exit(0),
        Err(why) => {
            println!("balls: {why}");
            process::exit(1)
        }
    }
}

fn picture(row: &mut Row) -> Result<(), &'static str> {
    let (pack, opening) = count::of(|| Pack::open(SCENE));
    let pack = pack.map_err(|_| "these bytes are no scene")?;
    if pack.scene().required_effects() != Mirrors::SET {
        return Err("the scene does not ask for exactly what the tracer can do");
    }
    let bvh = pack.bvh::<TraversalStack<32>>().map_err(|_| "there is no hierarchy")?;
    let wanted = wanted(&pack)?;
    let mut file = File::create(c"balls.f32").map_err(|_| "balls.f32 cannot be created")?;
    let row = row.get_mut(..wanted.size.width() as usize).ok_or("a row is too wide")?;
    let took = draw::<_, Mirrors, _, _, _, 5>(
        &World::new(*pack.scene(), bvh),
        wanted,
        &mut Single,
        (),
        row,
        count::now,
        bytes,
        |row| file.write_all(row.as_flattened().as_flattened()).is_ok(),
    )?;
    let stack = stack::used();
    println!("pixels {}", wanted.size.width() * wanted.size.height());
    println!("instructions {}", took.instructions);
    println!("stack {stack}");
    println!("worker {}", took.worker);
    println!("pack {}", SCENE.len());
    println!("opening {opening}");
    Ok(())
}

#[panic_handler]
fn panic(info: &core::panic::PanicInfo) -> ! {
    println!("balls: {info}");
    process::exit(1)
}
