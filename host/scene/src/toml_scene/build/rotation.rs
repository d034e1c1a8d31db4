//! Rotations about the three axes, in degrees.

use crate::description::Float3;

/// The rows of the matrix of a rotation about the x axis, then the y axis, then the z axis, all in world space.
pub fn rotation_matrix(degrees: Float3) -> [[f64; 3]; 3] {
    let [(sx, cx), (sy, cy), (sz, cz)] = degrees.map(sin_cos);
    [
        [cz * cy, cz * sy * sx - sz * cx, cz * sy * cx + sz * sx],
        [sz * cy, sz * sy * sx + cz * cx, sz * sy * cx - cz * sx],
        [-sy, cy * sx, cy * cx],
    ]
}

/// The images of the three axes under a rotation.
pub fn rotated_axes(degrees: Float3) -> [Float3; 3] {
    let rows = rotation_matrix(degrees);
    std::array::from_fn(|axis| rows.map(|row| row[axis] as f32))
}

/// Sine and cosine of an angle in degrees, exact for multiples of 90 degrees.
fn sin_cos(degrees: f32) -> (f64, f64) {
    let degrees = f64::from(degrees).rem_euclid(360.0);
    let quarter = [(0.0, (0.0, 1.0)), (90.0, (1.0, 0.0)), (180.0, (0.0, -1.0)), (270.0, (-1.0, 0.0))];
    match quarter.into_iter().find(|(angle, _)| *angle == degrees) {
        Some((_, exact)) => exact,
        // libm: identical on all platforms.
        None => (libm::sin(degrees.to_radians()), libm::cos(degrees.to_radians())),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rotations_by_90_degrees_are_exact_and_follow_the_right_hand_rule() {
        assert_eq!(rotated_axes([0.0, 0.0, 90.0]), [[0.0, 1.0, 0.0], [-1.0, 0.0, 0.0], [0.0, 0.0, 1.0]]);
        assert_eq!(rotated_axes([0.0, 90.0, 0.0]), [[0.0, 0.0, -1.0], [0.0, 1.0, 0.0], [1.0, 0.0, 0.0]]);
        assert_eq!(rotated_axes([90.0, 0.0, 0.0]), [[1.0, 0.0, 0.0], [0.0, 0.0, 1.0], [0.0, -1.0, 0.0]]);
        assert_eq!(rotated_axes([-270.0, 360.0, 720.0]), rotated_axes([90.0, 0.0, 0.0]));
    }

    #[test]
    fn the_rotation_about_x_is_first_and_that_about_z_is_last() {
        // x: the y axis goes to z; y: z goes to x; z: x goes to y.
        assert_eq!(rotated_axes([90.0, 90.0, 90.0])[1], [0.0, 1.0, 0.0]);
    }
}
