//! Transforms of glTF nodes.

use super::json::GltfNode;
use crate::description::Float3;

/// An affine transform in double precision, so that long chains of nodes round once.
#[derive(Clone, Copy, Debug)]
pub struct AffineTransform {
    /// The images of the three axes.
    columns: [[f64; 3]; 3],
    translation: [f64; 3],
}

impl AffineTransform {
    /// The identity.
    pub const IDENTITY: AffineTransform = AffineTransform {
        columns: [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
        translation: [0.0; 3],
    };

    /// The transform of a node; `None` if a number is not finite or the quaternion is zero.
    pub fn of_node(node: &GltfNode) -> Option<Self> {
        let transform = match &node.matrix {
            Some(m) => AffineTransform {
                columns: [[m[0], m[1], m[2]], [m[4], m[5], m[6]], [m[8], m[9], m[10]]],
                translation: [m[12], m[13], m[14]],
            },
            None => {
                let scale = node.scale.as_deref().copied().unwrap_or([1.0; 3]);
                let mut columns =
                    rotation_matrix(node.rotation.as_deref().copied().unwrap_or([0.0, 0.0, 0.0, 1.0]))?;
                for (column, scale) in columns.iter_mut().zip(scale) {
                    *column = column.map(|x| x * scale);
                }
                AffineTransform {
                    columns,
                    translation: node.translation.as_deref().copied().unwrap_or([0.0; 3]),
                }
            }
        };
        let numbers = transform.columns.as_flattened().iter().chain(&transform.translation);
        numbers.copied().all(f64::is_finite).then_some(transform)
    }

    /// Applies `inner` first, then this.
    pub fn compose(&self, inner: &AffineTransform) -> Self {
        AffineTransform {
            columns: inner.columns.map(|column| self.linear(column)),
            translation: self.transform(inner.translation),
        }
    }

    /// Whether it changes the handedness.
    pub fn flips_orientation(&self) -> bool {
        self.determinant() < 0.0
    }

    /// Transforms a point.
    pub fn transform_point(&self, point: Float3) -> Float3 {
        self.transform(point.map(f64::from)).map(|x| x as f32)
    }

    /// Transforms a normal by the inverse transpose, to length 1. Zero if the transform is singular.
    pub fn transform_normal(&self, normal: Float3) -> Float3 {
        // The columns of the inverse transpose are the cross products of the columns, divided by the determinant, of
        // which only the sign matters.
        let [a, b, c] = self.columns;
        let cofactors = [cross(b, c), cross(c, a), cross(a, b)];
        let n = normal.map(f64::from);
        let sign = if self.flips_orientation() { -1.0 } else { 1.0 };
        let turned = [0, 1, 2].map(|i| sign * (0..3).map(|j| cofactors[j][i] * n[j]).sum::<f64>());
        let largest = turned.iter().fold(0.0, |most: f64, x| if x.abs() > most { x.abs() } else { most });
        if !(largest > 0.0 && largest.is_finite()) {
            return [0.0; 3];
        }
        let scaled = turned.map(|x| x / largest);
        let length = scaled.iter().map(|x| x * x).sum::<f64>().sqrt();
        scaled.map(|x| (x / length) as f32)
    }

    fn determinant(&self) -> f64 {
        let [a, b, c] = self.columns;
        let n = cross(a, b);
        n[0] * c[0] + n[1] * c[1] + n[2] * c[2]
    }

    fn linear(&self, v: [f64; 3]) -> [f64; 3] {
        [0, 1, 2].map(|i| (0..3).map(|j| self.columns[j][i] * v[j]).sum())
    }

    fn transform(&self, point: [f64; 3]) -> [f64; 3] {
        let linear = self.linear(point);
        [0, 1, 2].map(|i| linear[i] + self.translation[i])
    }
}

fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

/// The rotation matrix of the quaternion `x y z w`, of any length; `None` if it is zero or not finite.
fn rotation_matrix(quaternion: [f64; 4]) -> Option<[[f64; 3]; 3]> {
    let length = quaternion.iter().map(|x| x * x).sum::<f64>().sqrt();
    if !(length > 0.0 && length.is_finite()) {
        return None;
    }
    let [x, y, z, w] = quaternion.map(|q| q / length);
    Some([
        [1.0 - 2.0 * (y * y + z * z), 2.0 * (x * y + w * z), 2.0 * (x * z - w * y)],
        [2.0 * (x * y - w * z), 1.0 - 2.0 * (x * x + z * z), 2.0 * (y * z + w * x)],
        [2.0 * (x * z + w * y), 2.0 * (y * z - w * x), 1.0 - 2.0 * (x * x + y * y)],
    ])
}
