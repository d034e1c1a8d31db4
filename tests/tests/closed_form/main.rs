//! Pixels whose value is known in closed form.
//!
//! The scenes are small, and the expected value is a formula that is evaluated in `f64`. A pixel is computed
//! by some dozen rounded operations; its relative error is at most [`ROUNDINGS`], unless a test states
//! another tolerance.

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
use strahl_core::image::{Framebuffer, Pixel, StochasticSampler};
use strahl_core::math::try_normalize;
use strahl_core::scene::{FresnelModel, Texture, TextureId};
use strahl_core::tally::{Counters, RayKind};
use strahl_core::{
    AllEffects, Background, Camera, CameraDescriptor, CenterSampler, Falloff, Light, LightSource, Limits,
    Material, Projection, Real, Resolution, Rgb, Tile, Tracer, Vec3, Worker, World, render, vec3,
};
use strahl_test_scene::TestScene;

/// Relative tolerance: sixteen roundings of half a unit in the last place.
const ROUNDINGS: f64 = 16.0 * 6e-8;

/// All levels, no cutoff.
const ALL: Limits = Limits { levels: 64, cutoff: 0.0 };

/// This number of levels, no cutoff.
const fn levels(levels: u8) -> Limits {
    Limits { levels, cutoff: 0.0 }
}

/// Asserts the relative error of each channel.
#[track_caller]
fn assert_color(got: Rgb, expected: [f64; 3], tolerance: f64) {
    for (got, expected) in [got.r, got.g, got.b].map(f64::from).into_iter().zip(expected) {
        assert!((got - expected).abs() <= tolerance * expected.abs(), "{got} is not {expected}");
    }
}

#[track_caller]
fn assert_gray(got: Rgb, expected: f64, tolerance: f64) {
    assert_color(got, [expected; 3], tolerance);
}

/// A material whose surface has this color under any light. The scene's ambient light must be white.
const fn unlit(color: Rgb) -> Material {
    Material { ambient: color, diffuse: Rgb::BLACK, ..Material::MATTE }
}

/// Half of the width of a [`ruler`].
const RULER_HALF_WIDTH: f64 = 8.0;

/// Adds a horizontal plane at `height` whose brightness encodes the x coordinate.
fn ruler(scene: &mut TestScene, height: f64) {
    let half_width = RULER_HALF_WIDTH as Real;
    let texture = scene.add_texture(Texture::Gradient {
        start_color: Rgb::BLACK,
        end_color: Rgb::WHITE,
        origin: vec3(-half_width, 0.0, 0.0),
        axis: vec3(2.0 * half_width, 0.0, 0.0),
    });
    scene.material(Material { texture, ..unlit(Rgb::WHITE) });
    scene.plane(vec3(0.0, height as Real, 0.0), Vec3::Y);
    scene.ambient = Rgb::WHITE;
}

/// The x coordinate on a ruler with this color.
fn ruler_x(color: Rgb) -> f64 {
    2.0 * RULER_HALF_WIDTH * f64::from(color.r) - RULER_HALF_WIDTH
}

/// Absolute tolerance of [`ruler_x`].
const RULER_TOLERANCE: f64 = 2.0 * RULER_HALF_WIDTH * ROUNDINGS;

/// Traces a ray from `viewpoint` downward, at an angle from the vertical towards +x.
fn trace_down(scene: &TestScene, viewpoint: [f64; 2], angle: f64, limits: Limits) -> Rgb {
    trace_down_counted(scene, viewpoint, angle, limits).0
}

fn trace_down_counted(scene: &TestScene, [x, y]: [f64; 2], angle: f64, limits: Limits) -> (Rgb, Counters) {
    let viewpoint = vec3(x as Real, y as Real, 0.0);
    let target = vec3((x + angle.sin()) as Real, (y - angle.cos()) as Real, 0.0);
    scene.trace_counted(viewpoint, target, limits)
}
