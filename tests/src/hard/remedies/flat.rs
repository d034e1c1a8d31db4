//! What is flat, and boxes, with a switch for each remedy.

use strahl_core::{
    Aabb, Axis, Cuboid, Disc, Plane, Polygon, Span, TurnedCuboid, Vec3, difference_of_products, has_area,
};

use super::Ready;

/// `strahl_core`'s triangle, by its corners. `EXACT`: edge functions that cancel are found again
/// with the errors of their products.
#[inline(always)]
pub fn triangle<const EXACT: bool>([a, b, c]: &[Vec3; 3], ray: &Ready) -> Option<f32> {
    let seen = |corner: Vec3| {
        let p = corner - ray.o;
        [p.dot(ray.across), p.dot(ray.upward)]
    };
    let [at, bt, ct] = [seen(*a), seen(*b), seen(*c)];
    let sides = [ct[0] * bt[1] - ct[1] * bt[0], at[0] * ct[1] - at[1] * ct[0], bt[0] * at[1] - bt[1] * at[0]];
    if is_beside(sides) { None } else { contact::<EXACT>([a, b, c], [at, bt, ct], sides, ray) }
}

#[inline(always)]
fn is_beside([u, v, w]: [f32; 3]) -> bool {
    let least = |a: f32, b: f32| if a < b { a } else { b };
    let greatest = |a: f32, b: f32| if a > b { a } else { b };
    least(u, least(v, w)) < 0.0 && greatest(u, greatest(v, w)) > 0.0
}

#[inline(never)]
fn contact<const EXACT: bool>(
    corners: [&Vec3; 3],
    [a, b, c]: [[f32; 2]; 3],
    mut sides: [f32; 3],
    ray: &Ready,
) -> Option<f32> {
    if EXACT {
        let [u, v, w] = sides;
        let greatest = |a: f32, b: f32| if a > b { a } else { b };
        let extent = |[x, y]: [f32; 2]| greatest(x.abs(), y.abs());
        let extent = greatest(extent(a), greatest(extent(b), extent(c)));
        if !((u + v + w).abs() > 0.125 * (extent * extent)) || u == 0.0 || v == 0.0 || w == 0.0 {
            sides = exact_sides(a, b, c);
            if is_beside(sides) || !has_area(corners.map(|corner| *corner)) {
                return None;
            }
        }
    }
    let [u, v, w] = sides;
    let sum = u + v + w;
    let shares = [u / sum, v / sum, w / sum];
    let [a, b, c] = corners.map(|corner| ray.axis.to_third(*corner - ray.o).z);
    let t = (shares[0] * a + shares[1] * b + shares[2] * c) * ray.third;
    (t > 0.0 && t <= f32::MAX).then_some(t)
}

#[cold]
#[inline(never)]
fn exact_sides(a: [f32; 2], b: [f32; 2], c: [f32; 2]) -> [f32; 3] {
    [
        difference_of_products(c[0], b[1], c[1], b[0]),
        difference_of_products(a[0], c[1], a[1], c[0]),
        difference_of_products(b[0], a[1], b[1], a[0]),
    ]
}

/// "Fast, Minimum Storage Ray/Triangle Intersection", Moeller, Trumbore 1997, with no threshold but
/// zero.
#[inline(always)]
pub fn triangle_by_itself([a, b, c]: &[Vec3; 3], ray: &Ready) -> Option<f32> {
    let (e, f) = (*b - *a, *c - *a);
    let p = ray.d.cross(f);
    let determinant = e.dot(p);
    if determinant == 0.0 {
        return None;
    }
    let inverse = 1.0 / determinant;
    let s = ray.o - *a;
    let u = s.dot(p) * inverse;
    if u < 0.0 || u > 1.0 {
        return None;
    }
    let q = s.cross(e);
    let v = ray.d.dot(q) * inverse;
    if v < 0.0 || u + v > 1.0 {
        return None;
    }
    let t = f.dot(q) * inverse;
    (t > 0.0).then_some(t)
}

/// A triangle's distance, moved into its own box if `MOVED`, so that no accelerator can leave out
/// what the list takes.
#[inline(always)]
pub fn triangle_in_box<const MOVED: bool>(corners: &[Vec3; 3], ray: &Ready) -> Option<f32> {
    let t = triangle::<true>(corners, ray)?;
    if !MOVED {
        return Some(t);
    }
    let span = span::<true>(&Aabb::around(*corners), ray)?;
    let t = if t < span.entry { span.entry } else { t };
    Some(if t > span.exit { span.exit } else { t })
}

/// `strahl_core`'s slab test. `WIDENED`: the far end, by what rounding may have taken from it.
#[inline(always)]
pub fn span<const WIDENED: bool>(aabb: &Aabb, ray: &Ready) -> Option<Span> {
    let (low, high) = ((aabb.min - ray.o) * ray.inverse, (aabb.max - ray.o) * ray.inverse);
    let order = |inverse: f32, a: f32, b: f32| if inverse >= 0.0 { (a, b) } else { (b, a) };
    let i = ray.inverse;
    let (mut entry, mut exit) = (f32::NEG_INFINITY, f32::MAX);
    for (near, far) in [order(i.x, low.x, high.x), order(i.y, low.y, high.y), order(i.z, low.z, high.z)] {
        entry = if near > entry { near } else { entry };
        exit = if far < exit { far } else { exit };
    }
    let exit = if WIDENED { exit * (1.0 + 4.0 * f32::EPSILON) } else { exit };
    (entry <= exit && exit >= 0.0 && entry <= f32::MAX).then_some(Span { entry, exit })
}

/// A polygon with what can be computed beforehand.
pub struct Outline {
    pub plane: Polygon,
    pub level: f32,
    pub corners: Vec<Vec3>,
}

/// `strahl_core`'s polygon.
///
/// * `NEAR`: its plane through a point among its corners; else by its distance from the origin.
/// * `HALF_OPEN`: an edge contains its lower end alone; else both.
#[inline(always)]
pub fn polygon<const NEAR: bool, const HALF_OPEN: bool>(it: &Outline, ray: &Ready) -> Option<f32> {
    let normal = it.plane.normal;
    let height = if NEAR { (it.plane.point - ray.o).dot(normal) } else { it.level - ray.o.dot(normal) };
    let t = height / ray.d.dot(normal);
    let way = ray.d * t;
    let seen = |corner: &Vec3| {
        let p = (*corner - ray.o) - way;
        match Axis::largest_of(normal) {
            Axis::X => [p.y, p.z],
            Axis::Y => [p.z, p.x],
            Axis::Z => [p.x, p.y],
        }
    };
    (t > 0.0 && is_inside::<HALF_OPEN>(&it.corners, seen)).then_some(t)
}

#[inline(always)]
fn is_inside<const HALF_OPEN: bool>(corners: &[Vec3], seen: impl Fn(&Vec3) -> [f32; 2]) -> bool {
    let mut inside = false;
    let Some(last) = corners.last() else { return false };
    let mut a = seen(last);
    for corner in corners {
        let b = seen(corner);
        let rises = b[1] > a[1];
        let is_level = if HALF_OPEN {
            (a[1] > 0.0) != (b[1] > 0.0)
        } else {
            (a[1] <= 0.0 && b[1] >= 0.0) || (b[1] <= 0.0 && a[1] >= 0.0)
        };
        if is_level && (a[0] * b[1] > a[1] * b[0]) == rises {
            inside = !inside;
        }
        a = b;
    }
    inside
}

/// A plane, and its distance from the origin.
pub struct Level<T> {
    pub it: T,
    pub level: f32,
}

/// `strahl_core`'s plane. `NEAR`: through its point; else by its distance from the origin.
#[inline(always)]
pub fn plane<const NEAR: bool>(it: &Level<Plane>, ray: &Ready) -> Option<f32> {
    let normal = it.it.normal;
    let height = if NEAR { (it.it.point - ray.o).dot(normal) } else { it.level - ray.o.dot(normal) };
    let t = height / ray.d.dot(normal);
    (t > 0.0 && t <= f32::MAX).then_some(t)
}

/// `strahl_core`'s disc. `NEAR`: the way is taken from the centre as the eye sees it; else the
/// point that is met, less the centre.
#[inline(always)]
pub fn disc<const NEAR: bool>(it: &Level<Disc>, ray: &Ready) -> Option<f32> {
    let normal = it.it.normal;
    let (t, p) = if NEAR {
        let o = it.it.center - ray.o;
        let t = o.dot(normal) / ray.d.dot(normal);
        (t, ray.d * t - o)
    } else {
        let t = (it.level - ray.o.dot(normal)) / ray.d.dot(normal);
        (t, (ray.o + ray.d * t) - it.it.center)
    };
    (t > 0.0 && p.dot(p) <= it.it.radius * it.it.radius).then_some(t)
}

/// `strahl_core`'s upright box.
///
/// * `QUOTIENTS`: of the distances of walls; else products with the reciprocal.
/// * `SIGNS`: the order of walls by the sign of the reciprocal, which tells 0 from -0; else by
///   `d >= 0`.
#[inline(always)]
pub fn cuboid<const QUOTIENTS: bool, const SIGNS: bool>(it: &Cuboid, ray: &Ready) -> Option<f32> {
    walls::<QUOTIENTS, SIGNS>(it.min - ray.o, it.max - ray.o, ray.d, ray.inverse)
}

#[inline(always)]
fn walls<const QUOTIENTS: bool, const SIGNS: bool>(
    low: Vec3,
    high: Vec3,
    d: Vec3,
    inverse: Vec3,
) -> Option<f32> {
    let (low, high) = if QUOTIENTS { (low / d, high / d) } else { (low * inverse, high * inverse) };
    let sign = if SIGNS { inverse } else { d };
    let (mut enter, mut leave) = (f32::NEG_INFINITY, f32::INFINITY);
    for (sign, low, high) in [(sign.x, low.x, high.x), (sign.y, low.y, high.y), (sign.z, low.z, high.z)] {
        let (near, far) = if sign >= 0.0 { (low, high) } else { (high, low) };
        enter = if near > enter { near } else { enter };
        leave = if far < leave { far } else { leave };
    }
    let t = if enter > 0.0 { enter } else { leave };
    (enter <= leave && t > 0.0 && t <= f32::MAX).then_some(t)
}

/// A turned box, and its centre in its own frame.
pub struct Turned {
    pub it: TurnedCuboid,
    pub own: Vec3,
}

/// A vector in the frame of these axes.
pub fn own(v: Vec3, [x, y, z]: [Vec3; 3]) -> Vec3 {
    Vec3::new(v.dot(x), v.dot(y), v.dot(z))
}

/// `strahl_core`'s turned box. `FIRST`: the centre is subtracted before anything is turned; else
/// afterwards.
#[inline(always)]
pub fn turned<const FIRST: bool>(it: &Turned, ray: &Ready) -> Option<f32> {
    let axes = it.it.axes;
    let o = if FIRST { own(ray.o - it.it.center, axes) } else { own(ray.o, axes) - it.own };
    let d = own(ray.d, axes);
    walls::<true, true>(-it.it.half - o, it.it.half - o, d, 1.0 / d)
}
