//! Spheres, cones and cylinders with a switch for each remedy.

use strahl_core::{Cone, Sphere, Vec3, sqrt, unit};

use super::Ready;

/// `strahl_core`'s sphere.
///
/// * `FOOT`: the discriminant from the foot of the perpendicular from the centre on the ray; else
///   `b^2 - a c`.
/// * `STABLE`: roots without cancellation; else `(b -+ root) / a`.
#[inline(always)]
pub fn sphere<const FOOT: bool, const STABLE: bool>(sphere: &Sphere, ray: &Ready) -> Option<f32> {
    let o = ray.o - sphere.center;
    let r2 = sphere.radius * sphere.radius;
    let b = -o.dot(ray.along);
    let c = o.dot(o) - r2;
    if b < 0.0 && c > 0.0 {
        return None;
    }
    let square = if FOOT {
        let foot = o + ray.along * (b / ray.square);
        ray.square * (r2 - foot.dot(foot))
    } else {
        b * b - ray.square * c
    };
    if !(square >= 0.0) {
        return None;
    }
    let root = sqrt(square);
    let t = if !STABLE {
        let near = (b - root) / ray.square;
        if near > 0.0 { near } else { (b + root) / ray.square }
    } else if b >= 0.0 {
        let q = b + root;
        if c > 0.0 { c / q } else { q / ray.square }
    } else {
        c / (b - root)
    };
    Some(t * ray.scale).filter(|t| *t > 0.0)
}

/// A sphere and a ray of any length, made ready here: with the direction brought to a length
/// of about one first, by a power of two, or as it is.
#[inline(always)]
pub fn sphere_any_length<const SCALED: bool>(it: &Sphere, ray: &Ready) -> Option<f32> {
    let scale = if SCALED { super::scale_of(ray.d) } else { 1.0 };
    let along = ray.d * scale;
    let ready = Ready { along, square: along.dot(along), scale, ..*ray };
    sphere::<true, true>(it, &ready)
}

/// The normal of a sphere: `UNIT` brought to length one, else divided by the radius.
#[inline(always)]
pub fn sphere_normal<const UNIT: bool>(it: &Sphere, ray: &Ready) -> Option<(f32, Vec3)> {
    let t = sphere::<true, true>(it, ray)?;
    let p = (ray.o - it.center) + ray.d * t;
    let normal = if UNIT { unit(p).unwrap_or(-ray.d) } else { p / it.radius };
    Some((t, normal))
}

/// `strahl_core`'s cone.
///
/// * `NEAR`: from the point of the ray that is nearest to the cone's middle; else from its origin.
/// * `SQUARES`: the discriminant as a difference of two squares; else `b^2 - a c`.
/// * `STABLE`: roots without cancellation; else `(b -+ root) / a`.
#[inline(always)]
pub fn cone<const NEAR: bool, const SQUARES: bool, const STABLE: bool>(
    cone: &Cone,
    ray: &Ready,
) -> Option<f32> {
    let d = ray.along;
    let far = ray.o - cone.base;
    let shift = if NEAR { (cone.axis * (0.5 * cone.height) - far).dot(d) / ray.square } else { 0.0 };
    let o = if NEAR { far + d * shift } else { far };
    let (oz, dz) = (o.dot(cone.axis), d.dot(cone.axis));
    let (op, dp) = (o - cone.axis * oz, d - cone.axis * dz);

    let mut nearest = f32::INFINITY;
    let mut offer = |t: f32| {
        let t = (shift + t) * ray.scale;
        if t > 0.0 && t < nearest {
            nearest = t;
        }
    };

    let k = (cone.end_radius - cone.base_radius) / cone.height;
    let radius = cone.base_radius + k * oz;
    let a = dp.dot(dp) - k * k * (dz * dz);
    let b = k * dz * radius - op.dot(dp);
    let c = op.dot(op) - radius * radius;
    let square = if SQUARES {
        let (w, x) = (dp * radius - op * (k * dz), op.cross(dp).dot(cone.axis));
        let (w, x) = (sqrt(w.dot(w)), x.abs());
        if w >= x { (w - x) * (w + x) } else { -1.0 }
    } else {
        b * b - a * c
    };
    if square >= 0.0 {
        let root = sqrt(square);
        let roots = if STABLE {
            let q = if b >= 0.0 { b + root } else { b - root };
            [q / a, c / q]
        } else {
            [(b - root) / a, (b + root) / a]
        };
        for t in roots {
            let z = oz + dz * t;
            if z >= 0.0 && z <= cone.height {
                offer(t);
            }
        }
    }
    if cone.capped {
        for (z, radius) in [(0.0, cone.base_radius), (cone.height, cone.end_radius)] {
            let t = (z - oz) / dz;
            let p = op + dp * t;
            if p.dot(p) <= radius * radius {
                offer(t);
            }
        }
    }
    (nearest < f32::INFINITY).then_some(nearest)
}
