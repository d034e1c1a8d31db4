//! The camera distance at which all points are in the picture.
//!
//! In the camera frame a point at `(x, y, z)`, with `z` towards the camera, is inside if `|x| <= s (d - z)`, where `d` is
//! the distance of the camera and `s` the slope of the edge of the picture. So each edge requires `d >= z + |x| / s`, and
//! the smallest distance that satisfies all four edges is used.
//!
//! Computed in double precision, because the numbers of a scene may have any magnitude.

use strahl_core::Resolution;

/// A point or a direction in double precision.
pub type Vec3d = [f64; 3];

/// The axes of a camera, and the slopes of the edges of its picture.
#[derive(Clone, Copy, Debug)]
pub struct CameraFrame {
    /// To the right and up in the picture, and towards the camera; orthonormal.
    axes: [Vec3d; 3],
    /// Half the visible width and half the visible height at a distance of 1.
    slopes: [f64; 2],
}

/// The distances that the edges of the picture require.
#[derive(Clone, Copy, Debug)]
pub struct EdgeDistances {
    /// For the right and the left, and for the upper and the lower edge.
    edges: [[f64; 2]; 2],
    /// The distance at which the camera is at the nearest point.
    pub nearest: f64,
}

impl CameraFrame {
    /// A camera in the direction `toward` from the scene, for a picture of `size` with a vertical field of view in
    /// `degrees` (full angle), of which the share `filled` is used.
    pub fn new(toward: Vec3d, up: Vec3d, degrees: f64, filled: f64, size: Resolution) -> Self {
        let back = unit(toward).unwrap_or([0.0, 0.0, 1.0]);
        // If `up` is unusable, any direction does; the camera reports the error.
        let right = [up, [0.0, 1.0, 0.0], [1.0, 0.0, 0.0]].into_iter().find_map(|up| unit(cross(up, back)));
        let right = right.unwrap_or([1.0, 0.0, 0.0]);
        let (sin, cos) = sin_cos(0.5 * degrees);
        let slope = filled * sin / cos;
        let aspect = f64::from(size.width()) / f64::from(size.height());
        CameraFrame { axes: [right, cross(back, right), back], slopes: [slope * aspect, slope] }
    }

    /// The axes to the right and up in the picture, and towards the camera.
    pub fn axes(&self) -> [Vec3d; 3] {
        self.axes
    }

    /// The distances from `target` at which these points are in the picture.
    pub fn edge_distances(&self, target: Vec3d, points: impl IntoIterator<Item = Vec3d>) -> EdgeDistances {
        let [right, above, back] = self.axes;
        let mut edges = [[f64::NEG_INFINITY; 2]; 2];
        let mut nearest = f64::NEG_INFINITY;
        for point in points {
            let from_target = [0, 1, 2].map(|i| point[i] - target[i]);
            let z = dot(from_target, back);
            nearest = larger(nearest, z);
            for (side, axis) in [right, above].into_iter().enumerate() {
                let x = dot(from_target, axis) / self.slopes[side];
                edges[side] = [larger(edges[side][0], z + x), larger(edges[side][1], z - x)];
            }
        }
        EdgeDistances { edges, nearest }
    }

    /// The smallest distance if the target may shift across the picture, and the shift to the right and up: it makes
    /// the distances of opposite edges equal.
    pub fn distance_and_shift(&self, distances: &EdgeDistances) -> (f64, [f64; 2]) {
        let [wide, high] = distances.edges.map(|[one, other]| 0.5 * (one + other));
        let moves = [0, 1].map(|i| 0.5 * (distances.edges[i][0] - distances.edges[i][1]) * self.slopes[i]);
        (larger(wide, high), moves)
    }
}

impl EdgeDistances {
    /// The smallest distance if the target is fixed.
    pub fn max_distance(&self) -> f64 {
        let [wide, high] = self.edges.map(|[one, other]| larger(one, other));
        larger(wide, high)
    }
}

/// The larger number; `a` if `b` is NaN.
pub fn larger(a: f64, b: f64) -> f64 {
    if b > a { b } else { a }
}

/// Sine and cosine of libm, which are identical on all platforms.
pub fn sin_cos(degrees: f64) -> (f64, f64) {
    libm::sincos(degrees.to_radians())
}

pub fn dot(a: Vec3d, b: Vec3d) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

pub fn cross(a: Vec3d, b: Vec3d) -> Vec3d {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

/// The unit vector; `None` for the zero vector.
pub fn unit(v: Vec3d) -> Option<Vec3d> {
    let largest = v.iter().fold(0.0, |largest, x| larger(largest, x.abs()));
    // Divided first, so that squares neither overflow nor underflow.
    let v = v.map(|x| x / largest);
    let length = dot(v, v).sqrt();
    length.is_finite().then(|| v.map(|x| x / length))
}
