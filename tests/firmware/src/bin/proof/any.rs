//! Values that are opaque to the optimizer.

use core::hint::black_box;

use strahl_core::geometry::{ItemId, Ray};
use strahl_core::{Real, Rgb, Vec3};

/// A value of which the optimizer knows only the type.
pub fn any<T>(example: T) -> T {
    black_box(example)
}

/// Uses a result, so that its computation is not removed.
pub fn used<T>(result: T) {
    black_box(result);
}

/// A slice of any length, address and content.
pub fn slice<T>(example: &[T]) -> &[T] {
    any(example)
}

pub fn number() -> Real {
    any(1.0)
}

pub fn vector() -> Vec3 {
    any(Vec3::X)
}

pub fn color() -> Rgb {
    any(Rgb::WHITE)
}

pub fn any_item() -> ItemId {
    any(ItemId(0))
}

pub fn any_ray() -> Ray {
    Ray::with_time(Ray::new(vector(), vector()), number())
}
