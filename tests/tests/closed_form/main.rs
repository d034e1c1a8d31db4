//! Light whose amount is known on paper.
//!
//! The scenes have few things at round places, and the answer is a formula, computed in `f64`.
//! A pixel is the product and sum of some dozen rounded numbers: [`ROUNDINGS`] is what that may
//! cost, relative to what is expected, unless a test says more.

mod distributed;
mod glass;
mod light;
mod media;
mod mirror;
mod saturation;
mod shadow;
mod view;

use strahl_core::accel::List;
use strahl_core::geometry::Cone;
use strahl_core::image::{Frame, Pixel, Stochastic};
use strahl_core::math::try_normalize;
use strahl_core::scene::{Interface, Texture, TextureId};
use strahl_core::tally::{Counters, RayKind};
use strahl_core::{
    AllEffects, Background, Camera, Falloff, Light, Limits, Material, Projection, Real, Resolution, Rgb,
    Single, Source, Tile, Tracer, Vec3, View, Worker, World, render, vec3,
};
use strahl_tests::single::TestScene;

/// Sixteen roundings of half a unit in the last place.
const ROUNDINGS: f64 = 16.0 * 6e-8;

/// All levels, and nothing cut off.
const ALL: Limits = Limits { levels: 64, cutoff: 0.0 };

/// Levels, and nothing cut off.
const fn levels(levels: u8) -> Limits {
    Limits { levels, cutoff: 0.0 }
}

/// Holds a colour against what is known, channel by channel.
#[track_caller]
fn assert_color(got: Rgb, want: [f64; 3], tolerance: f64) {
    for (got, want) in [got.r, got.g, got.b].map(f64::from).into_iter().zip(want) {
        assert!((got - want).abs() <= tolerance * want.abs(), "{got} is not {want}");
    }
}

#[track_caller]
fn assert_gray(got: Rgb, want: f64, tolerance: f64) {
    assert_color(got, [want; 3], tolerance);
}

/// A surface that shines by itself and does nothing else: the scene's ambient light must be
/// white.
const fn shining(color: Rgb) -> Material {
    Material { ambient: color, diffuse: Rgb::BLACK, ..Material::MATTE }
}

/// How far the walls of [`ruler`] reach to both sides.
const REACH: f64 = 8.0;

/// A wall level with `height`, seen from both sides, whose brightness tells where it is seen.
fn ruler(scene: &mut TestScene, height: f64) {
    let reach = REACH as Real;
    let texture = scene.add_texture(Texture::Gradient {
        from: Rgb::BLACK,
        to: Rgb::WHITE,
        origin: vec3(-reach, 0.0, 0.0),
        along: vec3(2.0 * reach, 0.0, 0.0),
    });
    scene.material(Material { texture, ..shining(Rgb::WHITE) });
    scene.plane(vec3(0.0, height as Real, 0.0), Vec3::Y);
    scene.ambient = Rgb::WHITE;
}

/// The x at which a ruler is seen.
fn place(color: Rgb) -> f64 {
    2.0 * REACH * f64::from(color.r) - REACH
}

/// How well a ruler can be read: its length, and the ways to it, times some roundings.
const READING: f64 = 2.0 * REACH * ROUNDINGS;

/// The look from `eye` down at an angle from the upright, towards +x.
fn slanted(scene: &TestScene, eye: [f64; 2], angle: f64, limits: Limits) -> Rgb {
    slanted_and_counted(scene, eye, angle, limits).0
}

fn slanted_and_counted(scene: &TestScene, [x, y]: [f64; 2], angle: f64, limits: Limits) -> (Rgb, Counters) {
    let eye = vec3(x as Real, y as Real, 0.0);
    let target = vec3((x + angle.sin()) as Real, (y - angle.cos()) as Real, 0.0);
    scene.trace_counted(eye, target, limits)
}
