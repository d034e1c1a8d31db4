//! Validation of a geometry: ranges of all numbers, and references between its tables.

use super::tables::get;
use super::{Geometry, ItemId, Shape, ShapeError};
use crate::math::{is_in_range, is_normalized};

impl Geometry<'_> {
    /// Checks all tables: numbers in range, valid indices, consistent planes and bounds.
    ///
    /// # Errors
    ///
    /// The first invalid item and its error. Vertices and vertex normals are checked first; they belong to no
    /// item, so that an error of theirs names item 0.
    pub fn validate(&self) -> Result<(), (ItemId, ShapeError)> {
        if self.vertices.iter().any(|p| !is_in_range(*p)) {
            return Err((ItemId(0), ShapeError::Coordinate));
        }
        if self.vertex_normals.iter().any(|n| !is_normalized(*n)) {
            return Err((ItemId(0), ShapeError::NotNormalized));
        }
        for (shape, index) in self.shapes.iter().zip(0..) {
            self.validate_shape(*shape, ItemId(index)).map_err(|error| (ItemId(index), error))?;
        }
        // A tracer tests the table of planes, so every plane in it must be an item.
        for (plane, index) in self.planes.iter().zip(0..) {
            let shape = self.shape(plane.item).and_then(|shape| self.static_shape(shape)).copied();
            if shape != Some(Shape::Plane(index)) {
                return Err((plane.item, ShapeError::PlaneItem));
            }
        }
        Ok(())
    }

    fn validate_shape(&self, shape: Shape, item: ItemId) -> Result<(), ShapeError> {
        if let Shape::Moving(index) = shape {
            let moving = self.moving_shape(index).ok_or(ShapeError::IndexOutOfRange)?;
            moving.validate()?;
            return self.validate_static_shape(moving.shape, item);
        }
        self.validate_static_shape(shape, item)
    }

    fn validate_static_shape(&self, shape: Shape, item: ItemId) -> Result<(), ShapeError> {
        let missing = ShapeError::IndexOutOfRange;
        match shape {
            Shape::Sphere(sphere) => sphere.validate(),
            Shape::Triangle(indices) => match self.vertices(indices) {
                Some(_) => Ok(()),
                None => Err(missing),
            },
            Shape::SmoothTriangle(indices) => match (self.vertices(indices), self.vertex_normals(indices)) {
                (Some(_), Some(_)) => Ok(()),
                _ => Err(missing),
            },
            Shape::Plane(index) => {
                let plane = get(self.planes, index).ok_or(missing)?;
                plane.validate()?;
                if plane.item == item { Ok(()) } else { Err(ShapeError::PlaneItem) }
            }
            Shape::Disc(index) => get(self.discs, index).ok_or(missing)?.validate(),
            Shape::Polygon(index) => {
                get(self.polygons, index).ok_or(missing)?.validate(self.vertices, self.vertex_normals)
            }
            Shape::Cuboid(index) => get(self.cuboids, index).ok_or(missing)?.validate(),
            Shape::OrientedCuboid(index) => get(self.oriented_cuboids, index).ok_or(missing)?.validate(),
            Shape::Cone(index) => get(self.cones, index).ok_or(missing)?.validate(),
            Shape::Torus(index) => get(self.tori, index).ok_or(missing)?.validate(),
            Shape::Moving(_) => Err(ShapeError::NestedMotion),
        }
    }
}
