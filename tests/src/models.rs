//! The models of revolution of `scenes/models`: a pear, a wine glass, its wine, a bottle.
//!
//! Each is a profile that rotates around the y axis. The profile is a centripetal Catmull-Rom spline through
//! a few points, which neither overshoots nor loops. A repeated point is a sharp edge.
//!
//! Source: Yuksel, Schaefer and Keyser, "Parameterization and applications of Catmull-Rom curves",
//! Computer-Aided Design 43(7), 2011.

/// Distance from the axis, and height.
type ProfilePoint = [f64; 2];

/// From the axis at the bottom, outside upwards, and back to the axis.
const PEAR: &[ProfilePoint] = &[
    [0.0, 0.06],
    [0.18, 0.02],
    [0.52, 0.14],
    [0.76, 0.55],
    [0.70, 1.00],
    [0.48, 1.36],
    [0.36, 1.66],
    [0.27, 1.90],
    [0.12, 2.00],
    [0.0, 1.97],
];
const GLASS: &[ProfilePoint] = &[
    [0.0, 0.0],
    [0.58, 0.0],
    [0.60, 0.02],
    [0.56, 0.045],
    [0.20, 0.10],
    [0.065, 0.22],
    [0.055, 0.60],
    [0.06, 0.95],
    [0.14, 1.10],
    [0.42, 1.32],
    [0.62, 1.75],
    [0.60, 2.20],
    [0.51, 2.62],
    [0.495, 2.64],
    [0.48, 2.62],
    [0.57, 2.20],
    [0.59, 1.75],
    [0.40, 1.38],
    [0.13, 1.19],
    [0.0, 1.17],
];
/// Ends inside the glass: in the overlap the body with the higher priority counts.
const WINE: &[ProfilePoint] = &[
    [0.0, 1.15],
    [0.14, 1.16],
    [0.41, 1.36],
    [0.595, 1.72],
    [0.605, 1.80],
    [0.605, 1.80],
    [0.30, 1.80],
    [0.0, 1.80],
];
const BOTTLE: &[ProfilePoint] = &[
    [0.0, 0.10],
    [0.40, 0.0],
    [0.56, 0.03],
    [0.60, 0.14],
    [0.60, 1.00],
    [0.60, 1.90],
    [0.52, 2.25],
    [0.28, 2.60],
    [0.21, 2.90],
    [0.20, 3.50],
    [0.26, 3.52],
    [0.26, 3.68],
    [0.20, 3.72],
    [0.14, 3.70],
    [0.14, 2.90],
    [0.22, 2.58],
    [0.46, 2.22],
    [0.53, 1.90],
    [0.53, 0.20],
    [0.40, 0.12],
    [0.0, 0.20],
];

/// The models: name, profile, segments between two of its points, segments around the axis.
const MODELS: [(&str, &[ProfilePoint], u32, u32); 4] =
    [("pear", PEAR, 4, 40), ("glass", GLASS, 4, 48), ("wine", WINE, 3, 48), ("bottle", BOTTLE, 3, 40)];

/// File names and contents.
pub fn files() -> impl Iterator<Item = (String, Vec<u8>)> {
    MODELS
        .iter()
        .map(|(name, profile, fine, around)| (format!("{name}.ply"), ply(&curve(profile, *fine), *around)))
}

/// Points on the spline, each with the tangent of the spline.
fn curve(points: &[ProfilePoint], fine: u32) -> Vec<(ProfilePoint, ProfilePoint)> {
    let last = points.len() - 1;
    let mut curve = Vec::new();
    for i in 0..last {
        if points[i] == points[i + 1] {
            continue;
        }
        // Before the first and behind the last point the profile is mirrored at the axis; at an edge it
        // continues straight.
        let beyond = |from: usize, to: usize| {
            let ([x, y], [fx, fy]) = (points[to], points[from]);
            if x == 0.0 { [-fx, fy] } else { [2.0 * x - fx, 2.0 * y - fy] }
        };
        let before = if i == 0 || points[i - 1] == points[i] { beyond(i + 1, i) } else { points[i - 1] };
        let after =
            if i + 1 == last || points[i + 2] == points[i + 1] { beyond(i, i + 1) } else { points[i + 2] };
        let p = [before, points[i], points[i + 1], after];
        let is_edge = i + 1 == last || points[i + 2] == points[i + 1];
        // The end of a segment is the start of the next one, except at an edge.
        for step in 0..fine + u32::from(is_edge) {
            curve.push(spline(p, f64::from(step) / f64::from(fine)));
        }
    }
    curve
}

/// A point between the second and the third control point, and the tangent.
fn spline(p: [ProfilePoint; 4], t: f64) -> (ProfilePoint, ProfilePoint) {
    let knot = |a: ProfilePoint, b: ProfilePoint| libm::sqrt(libm::hypot(b[0] - a[0], b[1] - a[1]));
    let (d0, d1, d2) = (knot(p[0], p[1]), knot(p[1], p[2]), knot(p[2], p[3]));
    // Slopes at the two points, for a cubic in Hermite form.
    let slope = |a: f64, b: f64, c: f64, da: f64, db: f64| (b - a) / da - (c - a) / (da + db) + (c - b) / db;
    let u = 1.0 - t;
    let along = |axis: usize| {
        let [before, a, b, after] = p.map(|point| point[axis]);
        let (m, n) = (d1 * slope(before, a, b, d0, d1), d1 * slope(a, b, after, d1, d2));
        let position =
            u * u * (1.0 + 2.0 * t) * a + t * u * u * m + t * t * (3.0 - 2.0 * t) * b - t * t * u * n;
        let tangent = 6.0 * t * u * (b - a) + u * (1.0 - 3.0 * t) * m + t * (3.0 * t - 2.0) * n;
        (position, tangent)
    };
    let ((x, tangent_x), (y, tangent_y)) = (along(0), along(1));
    ([x, y], [tangent_x, tangent_y])
}

/// The surface of revolution of a curve around the y axis, as binary PLY.
fn ply(curve: &[(ProfilePoint, ProfilePoint)], around: u32) -> Vec<u8> {
    let rings = curve.len() as u32;
    let mut points = Vec::new();
    for ([r, y], [wr, wy]) in curve {
        let length = libm::hypot(*wr, *wy);
        // Perpendicular to the curve, away from the axis where the curve rises.
        let (out, up) = (wy / length, -wr / length);
        for k in 0..around {
            let angle = 2.0 * std::f64::consts::PI * f64::from(k) / f64::from(around);
            let (c, s) = (libm::cos(angle), libm::sin(angle));
            let r = if *r < 1e-9 { 0.0 } else { *r };
            points.extend([r * c, *y, -r * s, out * c, up, -out * s].map(|x| (x + 0.0) as f32));
        }
    }
    let mut triangles: Vec<[u32; 3]> = Vec::new();
    for ring in 0..rings - 1 {
        let is_on_axis = |ring: u32| curve[ring as usize].0[0] < 1e-9;
        // A repeated point: an edge.
        if curve[ring as usize].0 == curve[ring as usize + 1].0 {
            continue;
        }
        for k in 0..around {
            let (next, low, high) = ((k + 1) % around, ring * around, (ring + 1) * around);
            if !is_on_axis(ring) {
                triangles.push([low + k, low + next, high + k]);
            }
            if !is_on_axis(ring + 1) {
                triangles.push([low + next, high + next, high + k]);
            }
        }
    }
    let mut file = format!(
        "ply\nformat binary_little_endian 1.0\nelement vertex {}\nproperty float x\nproperty float y\n\
         property float z\nproperty float nx\nproperty float ny\nproperty float nz\nelement face {}\n\
         property list uchar ushort vertex_indices\nend_header\n",
        points.len() / 6,
        triangles.len()
    )
    .into_bytes();
    points.iter().for_each(|x| file.extend(x.to_le_bytes()));
    for triangle in triangles {
        file.push(3);
        triangle.iter().for_each(|corner| file.extend((*corner as u16).to_le_bytes()));
    }
    file
}
