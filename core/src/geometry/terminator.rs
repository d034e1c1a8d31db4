//! The line between light and shadow on smooth shapes.
//!
//! A smooth shape is flat and only looks round. Where its shading normal still faces a light that
//! stands under the horizon of the flat face, a ray towards the light would go into the shape at
//! once, and whole faces would be dark: the shadow's edge follows the faces. The round surface
//! that is meant lies farther out. So such a ray starts from there: the point is lifted to where
//! the planes upright on the normals of the corners are, in the mean ("Hacking the Shadow
//! Terminator", Hanika, Ray Tracing Gems II 4).
//!
//! Rays towards a light above the horizon start from the face itself, so that nothing between the
//! face and the round surface is skipped by them: a ray that is lifted was dark before.

use super::{Geometry, Shape, ShapeKind, Shapes, of, triangle};
use crate::math::Vec3;

impl Geometry<'_> {
    /// How far off a point of a smooth shape the round surface is that is meant, on the side of its
    /// normals or on the other; nothing for any other shape.
    pub(crate) fn lift<S: Shapes>(&self, shape: Shape, point: Vec3, outside: bool) -> Option<Vec3> {
        let can = |kind| S::SMOOTH && S::SHAPES.has(kind);
        match shape {
            Shape::SmoothTriangle(corners) if can(ShapeKind::SmoothTriangle) => {
                Some(triangle::lift(self.corners(corners)?, self.corner_normals(corners)?, point, outside))
            }
            Shape::Polygon(place) if can(ShapeKind::Polygon) => {
                of(self.polygons, place)?.lift(self.points, self.normals, point, outside)
            }
            _ => None,
        }
    }
}
