//! How far away the eye stands so that everything is in the picture.
//!
//! In the frame of the eye a point at `(x, y, z)`, `z` towards the eye, is inside when
//! `|x| <= s (d - z)`, where `d` is the distance of the eye and `s` the slope of the picture's edge.
//! So each edge of the picture asks for `d >= z + |x| / s`, and the eye stands as near as the four
//! of them allow.
//!
//! Reckoned in double precision, because the numbers of a scene may be of any size.

use strahl_core::Resolution;

/// A place or a direction.
pub type Vec3d = [f64; 3];

/// The direction of an eye, and how much it sees.
#[derive(Clone, Copy, Debug)]
pub struct CameraFrame {
    /// To the right and up in the picture, and towards the eye: of length one, upright on each other.
    axes: [Vec3d; 3],
    /// Half the width and half the height of what is seen in a distance of one.
    slopes: [f64; 2],
}

/// The distances that the edges of the picture ask for.
#[derive(Clone, Copy, Debug)]
pub struct EdgeDistances {
    /// The right and the left, the upper and the lower edge.
    edges: [[f64; 2]; 2],
    /// That of the point next to the eye.
    pub nearest: f64,
}

impl CameraFrame {
    /// From an eye `toward` which one looks away, into a picture of `size` with this vertical angle
    /// in degrees, of which this share is to be filled.
    pub fn new(toward: Vec3d, up: Vec3d, degrees: f64, filled: f64, size: Resolution) -> Self {
        let back = unit(toward).unwrap_or([0.0, 0.0, 1.0]);
        // Where nothing is up any direction is as good; that this is no view is told elsewhere.
        let right = [up, [0.0, 1.0, 0.0], [1.0, 0.0, 0.0]].into_iter().find_map(|up| unit(cross(up, back)));
        let right = right.unwrap_or([1.0, 0.0, 0.0]);
        let (sin, cos) = sin_cos(0.5 * degrees);
        let slope = filled * sin / cos;
        let aspect = f64::from(size.width()) / f64::from(size.height());
        CameraFrame { axes: [right, cross(back, right), back], slopes: [slope * aspect, slope] }
    }

    /// To the right and up in the picture, and towards the eye.
    pub fn axes(&self) -> [Vec3d; 3] {
        self.axes
    }

    /// What it takes to see these points when one looks at `middle`.
    pub fn edge_distances(&self, middle: Vec3d, points: impl IntoIterator<Item = Vec3d>) -> EdgeDistances {
        let [right, above, back] = self.axes;
        let mut edges = [[f64::NEG_INFINITY; 2]; 2];
        let mut nearest = f64::NEG_INFINITY;
        for point in points {
            let from_middle = [0, 1, 2].map(|i| point[i] - middle[i]);
            let z = dot(from_middle, back);
            nearest = larger(nearest, z);
            for (side, axis) in [right, above].into_iter().enumerate() {
                let x = dot(from_middle, axis) / self.slopes[side];
                edges[side] = [larger(edges[side][0], z + x), larger(edges[side][1], z - x)];
            }
        }
        EdgeDistances { edges, nearest }
    }

    /// The distance when the middle may move across the picture, and how far it moves to the right
    /// and up: the demands of the left and of the right edge are made equal, and so are the others.
    pub fn distance_and_shift(&self, demands: &EdgeDistances) -> (f64, [f64; 2]) {
        let [wide, high] = demands.edges.map(|[one, other]| 0.5 * (one + other));
        let moves = [0, 1].map(|i| 0.5 * (demands.edges[i][0] - demands.edges[i][1]) * self.slopes[i]);
        (larger(wide, high), moves)
    }
}

impl EdgeDistances {
    /// The distance when the middle stays where it is.
    pub fn max_distance(&self) -> f64 {
        let [wide, high] = self.edges.map(|[one, other]| larger(one, other));
        larger(wide, high)
    }
}

pub fn larger(a: f64, b: f64) -> f64 {
    if b > a { b } else { a }
}

/// libm's, which are the same everywhere.
pub fn sin_cos(degrees: f64) -> (f64, f64) {
    libm::sincos(degrees.to_radians())
}

pub fn dot(a: Vec3d, b: Vec3d) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

pub fn cross(a: Vec3d, b: Vec3d) -> Vec3d {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

/// The direction; none of nothing.
pub fn unit(v: Vec3d) -> Option<Vec3d> {
    let most = v.iter().fold(0.0, |most, x| larger(most, x.abs()));
    // Divided first, so that no square is too large or too small.
    let v = v.map(|x| x / most);
    let length = dot(v, v).sqrt();
    length.is_finite().then(|| v.map(|x| x / length))
}
