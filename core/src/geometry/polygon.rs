//! Simple polygon of any number of corners, concave ones too.
//!
//! Its plane goes through the middle of its corners, upright on the sum of the areas that
//! they span (Newell's rule), so that one corner somewhat off it does no harm. Whether a point of the plane is
//! inside is asked in two dimensions, by counting the edges that a line from the point to the
//! right crosses; an edge contains its lower end and not its upper one, so that a corner level
//! with the point counts once ("Point in Polygon Strategies", Haines, Graphics Gems IV).

use zerocopy::{Immutable, KnownLayout, TryFromBytes};

use super::meet::moved_into;
use super::plane::{above, level};
use super::{Aabb, Ray, ShapeFault, Surface, check_point, check_unit};
use crate::math::{Axis, Real, Vec3, abs, gamma, length, unit, vec3};

/// A polygon whose corners lie in the scene's table of points.
#[derive(Clone, Copy, Debug, PartialEq, TryFromBytes, KnownLayout, Immutable)]
#[repr(C)]
pub struct Polygon {
    /// The place of its first corner in the table.
    pub first: u32,
    /// How many corners, one after the other; at least 3.
    pub count: u32,
    /// A point on its plane, near its corners.
    pub point: Vec3,
    /// Upright on it by the right hand round the corners, of length one.
    pub normal: Vec3,
    /// The box round its corners ([`Aabb::of_points`]).
    pub bounds: Aabb,
    /// Whether the shading normal is interpolated between those of the corners.
    pub smooth: bool,
}

impl Polygon {
    /// The polygon of `corners`, which lie in the table of points from place `first` on.
    ///
    /// Its normal is right-handed round the corners. None for a polygon without area, and for
    /// one of fewer than three corners.
    pub fn new(first: u32, corners: &[Vec3], smooth: bool) -> Option<Self> {
        let (start, count) = (*corners.first()?, u32::try_from(corners.len()).ok()?);
        // Relative to the first corner, so that the place of the polygon does not count.
        let relative = || corners.iter().map(|corner| *corner - start);
        let size = relative().map(abs).fold(Vec3::ZERO, Vec3::max).max_element();
        let round = relative().skip(1).chain(relative().take(1));
        let area = relative().zip(round).fold(Vec3::ZERO, |sum, (a, b)| sum + (a / size).cross(b / size));
        let normal = unit(area)?;
        // Of three corners an exact zero is no area; more may leave some roundings of it.
        if length(area) <= gamma(4 * count.min(1 << 16)) && !(count == 3 && length(area) > gamma(2)) {
            return None;
        }
        let middle = start + relative().fold(Vec3::ZERO, |sum, p| sum + p) / count as Real;
        Some(Polygon { first, count, point: middle, normal, bounds: Aabb::of_points(corners), smooth })
    }

    pub(super) fn check(&self, points: &[Vec3], normals: &[Vec3]) -> Result<(), ShapeFault> {
        check_point(self.point)?;
        check_unit(self.normal)?;
        let corners = self.of(points).ok_or(ShapeFault::Missing)?;
        if self.count < 3 || self.smooth && self.of(normals).is_none() {
            return Err(ShapeFault::Missing);
        }
        if self.bounds == Aabb::of_points(corners) { Ok(()) } else { Err(ShapeFault::Bounds) }
    }

    /// Its own part of a table.
    fn of<'t>(&self, table: &'t [Vec3]) -> Option<&'t [Vec3]> {
        let first = self.first as usize;
        table.get(first..first.checked_add(self.count as usize)?)
    }

    /// How far, moved into its box ([`moved_into`] says why).
    #[inline(always)]
    pub(super) fn hit(&self, points: &[Vec3], ray: &Ray) -> Option<Real> {
        let t = (self.point - ray.origin).dot(self.normal) / ray.direction.dot(self.normal);
        // Nothing is inside when it is infinite: all corners then lie to one side, or to none.
        if !(t > 0.0) {
            return None;
        }
        let (o, d) = (ray.origin, ray.direction);
        self.hit_at(points, t, o.x, o.y, o.z, d.x, d.y, d.z)
    }

    /// The same where the ray meets its plane, `t` away.
    ///
    /// Not inlined, because most rays miss the plane or meet it behind them.
    #[inline(never)]
    #[allow(clippy::too_many_arguments)] // in registers
    fn hit_at(
        &self,
        points: &[Vec3],
        t: Real,
        ox: Real,
        oy: Real,
        oz: Real,
        dx: Real,
        dy: Real,
        dz: Real,
    ) -> Option<Real> {
        let (o, d) = (vec3(ox, oy, oz), vec3(dx, dy, dz));
        let way = d * t;
        let corners = self.of(points)?;
        // In the plane of the two axes that are least upright on it.
        let inside = match Axis::largest_of(self.normal) {
            Axis::X => self.is_inside(corners, |p| (p.y - o.y) - way.y, |p| (p.z - o.z) - way.z),
            Axis::Y => self.is_inside(corners, |p| (p.z - o.z) - way.z, |p| (p.x - o.x) - way.x),
            Axis::Z => self.is_inside(corners, |p| (p.x - o.x) - way.x, |p| (p.y - o.y) - way.y),
        };
        if inside { moved_into(self.bounds, t, o, 1.0 / d) } else { None }
    }

    /// Whether the corners go round a point in two dimensions, seen from which they lie so far to the
    /// `right` and so far `up`.
    #[inline(always)]
    fn is_inside(&self, corners: &[Vec3], right: impl Fn(&Vec3) -> Real, up: impl Fn(&Vec3) -> Real) -> bool {
        // When all of them are to one side, so is the box, to the same side by the same numbers.
        let Aabb { min, max } = &self.bounds;
        if right(min) > 0.0 || right(max) < 0.0 || up(min) > 0.0 || up(max) <= 0.0 {
            return false;
        }
        let Some(mut last) = corners.last() else { return false };
        let (mut inside, mut rest) = (false, corners);
        if corners.len() >= GROUP {
            let (groups, few) = corners.as_chunks();
            (inside, last) = is_odd(groups, last, &right, &up);
            rest = few;
        }
        let (mut a, mut a_up) = (last, up(last));
        let mut a_above = a_up > 0.0;
        for b in rest {
            let b_up = up(b);
            let b_above = b_up > 0.0;
            if a_above != b_above && is_crossed([right(a), a_up], [right(b), b_up]) {
                inside = !inside;
            }
            (a, a_up, a_above) = (b, b_up, b_above);
        }
        inside
    }

    /// How far off `point` the round surface is that is meant, where the polygon is smooth.
    pub(super) fn lift(&self, points: &[Vec3], normals: &[Vec3], point: Vec3, outside: bool) -> Option<Vec3> {
        if !self.smooth {
            return None;
        }
        let (corners, normals) = (self.of(points)?, self.of(normals)?);
        let value = |corner, normal| above(corner, normal, outside);
        let (sum, all) = mixed(point, self.normal, corners, normals, value)?;
        Some(sum / all)
    }

    pub(super) fn surface(&self, points: &[Vec3], normals: Option<&[Vec3]>, ray: &Ray, t: Real) -> Surface {
        let mut surface = level(ray, t, self.point, self.normal);
        // A corner may lie some roundings off the plane, and its box with it.
        surface.error += abs(self.point) * gamma(4);
        if self.smooth
            && let Some(normals) = normals
            && let (Some(corners), Some(normals)) = (self.of(points), self.of(normals))
            && let Some((sum, _)) = mixed(surface.point, self.normal, corners, normals, |_, normal| normal)
            && let Some(shading) = unit(sum)
        {
            surface.shading = shading;
        }
        surface
    }
}

/// Whether an edge is crossed whose ends are seen on different sides: `b` is the upper one exactly
/// when it is above.
#[inline(always)]
fn is_crossed(a: [Real; 2], b: [Real; 2]) -> bool {
    (a[0] * b[1] > a[1] * b[0]) == (b[1] > 0.0)
}

/// How many corners are asked at once whether they are above.
const GROUP: usize = 16;

/// Whether an odd number of the edges that end in these corners is crossed, the first of which begins
/// in `last`; and the corner in which the next one begins.
///
/// Of many corners few are on another side than the one before, and only they need both coordinates.
/// Which are above is written into bits, by the same steps for each corner of a group and without a
/// branch: compilers make of it instructions that count four numbers at once.
#[inline(always)]
fn is_odd<'c>(
    groups: &'c [[Vec3; GROUP]],
    mut last: &'c Vec3,
    right: impl Fn(&Vec3) -> Real,
    up: impl Fn(&Vec3) -> Real,
) -> (bool, &'c Vec3) {
    let mut odd = false;
    let mut last_above = u32::from(up(last) > 0.0);
    for group in groups {
        // The lowest bit is for the one before the group.
        let mut above = last_above;
        for (place, corner) in group.iter().enumerate() {
            above |= u32::from(up(corner) > 0.0) << (place + 1);
        }
        last_above = above >> GROUP;
        let mut changes = above ^ (above >> 1 | last_above << GROUP);
        while changes != 0 {
            let place = changes.trailing_zeros() as usize;
            let a = group.get(place.wrapping_sub(1)).unwrap_or(last);
            let crossed = |b| is_crossed([right(a), up(a)], [right(b), up(b)]);
            odd ^= group.get(place).is_some_and(crossed);
            changes &= changes - 1;
        }
        let [.., end] = group;
        last = end;
    }
    (odd, last)
}

/// The mean at `p` of a value of each corner (of the corner as it is seen from `p`, and its normal),
/// times the number that comes with it, by mean value coordinates ("Mean value coordinates", Floater
/// 2003): smooth for every simple polygon, linear along its edges.
///
/// They need the tangent of half of each angle under which an edge is seen from `p`, which is
/// `(|a||b| - a.b) / (a x b)`.
#[inline(always)]
fn mixed(
    p: Vec3,
    upright: Vec3,
    corners: &[Vec3],
    normals: &[Vec3],
    value: impl Fn(Vec3, Vec3) -> Vec3,
) -> Option<(Vec3, Real)> {
    let seen = |(corner, normal): (&Vec3, &Vec3)| (*corner - p, value(*corner - p, *normal));
    let round = corners.iter().zip(normals).map(seen);
    let (mut sum, mut all) = (Vec3::ZERO, 0.0);
    let (mut a, mut value_a) = round.clone().next_back()?;
    for (b, value_b) in round {
        let (la, lb) = (length(a), length(b));
        if lb == 0.0 {
            return Some((value_b, 1.0)); // on the corner
        }
        let (dot, cross) = (a.dot(b), a.cross(b).dot(upright));
        let tangent = (la * lb - dot) / cross;
        if la > 0.0 && tangent.abs() <= Real::MAX {
            sum += value_a * (tangent / la) + value_b * (tangent / lb);
            all += tangent / la + tangent / lb;
        } else if dot < 0.0 {
            return Some((value_a * lb + value_b * la, la + lb)); // on the edge
        }
        (a, value_a) = (b, value_b);
    }
    Some((sum, all))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Whether the corners go round a place, in whole numbers, which are exact.
    fn go_round(corners: &[[i32; 2]], [x, y]: [i32; 2]) -> bool {
        let edges = corners.iter().zip(corners.iter().cycle().skip(1));
        let crossed = edges.filter(|([ax, ay], [bx, by])| {
            let rightward = (ax - x) * (by - y) > (ay - y) * (bx - x);
            (*ay > y) != (*by > y) && rightward == (*by > y)
        });
        crossed.count() % 2 == 1
    }

    #[test]
    fn corners_few_or_many_go_round_the_places_that_they_do_in_whole_numbers() {
        let mut seed = 1_u32;
        let mut random = || {
            seed = seed.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            (seed >> 16) as i32 % 9
        };
        let mut met = 0;
        for count in (3..=70).flat_map(|count| [count; 4]) {
            let flat: [[i32; 2]; 70] = core::array::from_fn(|_| [random(), random()]);
            let flat = &flat[..count];
            let points: [Vec3; 70] = core::array::from_fn(|place| {
                let [x, y] = flat[place % count];
                vec3(x as Real, y as Real, 0.0)
            });
            let Some(polygon) = Polygon::new(0, &points[..count], false) else { continue };
            for [x, y] in (0..81).map(|place| [place % 9, place / 9]) {
                let ray = Ray::new(vec3(x as Real, y as Real, 1.0), vec3(0.0, 0.0, -1.0));
                let hit = polygon.hit(&points, &ray);
                assert_eq!(hit.is_some(), go_round(flat, [x, y]), "{x}, {y} in {flat:?}");
                met += u32::from(hit.is_some());
            }
        }
        assert!(met > 5_000, "only {met} places met");
    }
}
