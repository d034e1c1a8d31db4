//! What a surface does to the direction of light, and how it parts it.
//!
//! Directions have length one. A ray comes in along `d`, and `n` is the normal on its side, so
//! that `d . n` is below zero.
//!
//! Total reflection is found before any root is taken, so that no NaN arises.

use crate::math::{Real, Rgb, Vec3, exp, max, sqrt};

/// The mirrored direction.
pub fn reflect(d: Vec3, n: Vec3) -> Vec3 {
    d - n * (2.0 * d.dot(n))
}

/// Light on the other side of a surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Refraction {
    /// Where it goes, of length one.
    pub direction: Vec3,
    /// The share that Fresnel's formulas mirror instead, of unpolarised light.
    pub reflectance: Real,
}

/// The broken direction by Snell's law, where `ratio` is the index of refraction on the side
/// that light comes from over that of the other side. None when all light is thrown back.
pub fn refract(d: Vec3, n: Vec3, ratio: Real) -> Option<Refraction> {
    if ratio == 1.0 {
        return Some(Refraction { direction: d, reflectance: 0.0 });
    }
    let cos = max(-d.dot(n), 0.0);
    // The part along the surface, as it is behind it. Its square is right also where neither
    // direction is exactly one long, which that of `1 - cos^2` is not.
    let flat = (d + n * cos) * ratio;
    // The square of the sine behind the surface, tested before any root is taken.
    let sin2 = flat.dot(flat);
    if !(sin2 < 1.0) {
        return None;
    }
    let cos_behind = sqrt(1.0 - sin2);
    let direction = flat - n * cos_behind;
    let across = (ratio * cos - cos_behind) / (ratio * cos + cos_behind);
    let along = (cos - ratio * cos_behind) / (cos + ratio * cos_behind);
    Some(Refraction { direction, reflectance: 0.5 * (across * across + along * along) })
}

/// What is left of light after a way through a medium (Beer's law).
pub fn transmittance(clarity: Rgb, way: Real) -> Rgb {
    clarity.map(|clarity| if clarity < Real::INFINITY { exp(-(way / clarity)) } else { 1.0 })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::{PI, cos, length, sin, vec3};

    /// Light that comes down at an angle from the upright.
    fn at(angle: Real) -> Vec3 {
        vec3(sin(angle), -cos(angle), 0.0)
    }

    #[test]
    fn a_mirror_keeps_the_angle() {
        assert!(length(reflect(at(0.3), Vec3::Y) - vec3(sin(0.3), cos(0.3), 0.0)) < 1e-6);
    }

    #[test]
    fn snells_law_holds_on_the_way_in_and_out() {
        for angle in [0.0, 0.1, 0.6, 1.2, 1.5] {
            for ratio in [1.0 / 1.5, 1.5, 1.0 / 2.4] {
                let Some(out) = refract(at(angle), Vec3::Y, ratio) else {
                    assert!(sin(angle) * ratio >= 1.0);
                    continue;
                };
                assert!((out.direction.x - ratio * sin(angle)).abs() < 1e-6);
                assert!((length(out.direction) - 1.0).abs() < 1e-6 && out.direction.y < 0.0);
            }
        }
    }

    #[test]
    fn fresnels_share_meets_its_known_values() {
        // Upright: ((n - 1) / (n + 1))^2, from either side. Brewster's angle: 0 for one half of
        // the light; the other half mirrors ((n^2 - 1) / (n^2 + 1))^2.
        let share = |angle, ratio| refract(at(angle), Vec3::Y, ratio).unwrap().reflectance;
        assert!((share(0.0, 1.0 / 1.5) - 0.04).abs() < 1e-6);
        assert!((share(0.0, 1.5) - 0.04).abs() < 1e-6);
        let angle = crate::math::acos(1.0 / sqrt(1.0 + 1.5 * 1.5)); // its tangent is 1.5
        let half: Real = (1.5 * 1.5 - 1.0) / (1.5 * 1.5 + 1.0);
        assert!((share(angle, 1.0 / 1.5) - 0.5 * half * half).abs() < 1e-6);
        // Grazing: everything.
        assert!(share(PI / 2.0 - 1e-4, 1.0 / 1.5) > 0.999);
    }

    #[test]
    fn beyond_the_critical_angle_no_light_passes() {
        let critical = PI / 2.0 - crate::math::acos(1.0 / 1.5);
        assert!(refract(at(critical - 1e-3), Vec3::Y, 1.5).is_some());
        assert!(refract(at(critical + 1e-3), Vec3::Y, 1.5).is_none());
    }

    #[test]
    fn one_over_e_is_left_after_one_clarity() {
        let left = transmittance(Rgb::new(2.0, Real::INFINITY, 1e-30), 2.0);
        assert!((left.r - 0.367_879_44).abs() < 1e-6);
        assert_eq!((left.g, left.b), (1.0, 0.0));
    }
}
