//! Validation of a geometry: ranges of all numbers, and references between its tables.

use super::tables::get;
use super::{Geometry, ItemId, Shape, ShapeFault};
use crate::math::{is_in_range, is_unit};

impl Geometry<'_> {
    /// Checks all tables: numbers in range, valid indices, consistent planes and bounds.
    ///
    /// # Errors
    ///
    /// The first invalid item and its error. For a vertex or a vertex normal that is out of range, item 0.
    pub fn check(&self) -> Result<(), (ItemId, ShapeFault)> {
        if self.points.iter().any(|p| !is_in_range(*p)) {
            return Err((ItemId(0), ShapeFault::Place));
        }
        if self.normals.iter().any(|n| !is_unit(*n)) {
            return Err((ItemId(0), ShapeFault::NotUnit));
        }
        for (shape, index) in self.shapes.iter().zip(0..) {
            self.validate_shape(*shape, ItemId(index)).map_err(|error| (ItemId(index), error))?;
        }
        // A tracer tests the table of planes, so every plane in it must be an item.
        for (plane, index) in self.planes.iter().zip(0..) {
            let shape = self.shape(plane.item).and_then(|shape| self.at_rest(shape)).copied();
            if shape != Some(Shape::Plane(index)) {
                return Err((plane.item, ShapeFault::Plane));
            }
        }
        Ok(())
    }

    fn validate_shape(&self, shape: Shape, item: ItemId) -> Result<(), ShapeFault> {
        if let Shape::Moving(index) = shape {
            let moving = self.moving(index).ok_or(ShapeFault::Missing)?;
            moving.check()?;
            return self.validate_static_shape(moving.shape, item);
        }
        self.validate_static_shape(shape, item)
    }

    fn validate_static_shape(&self, shape: Shape, item: ItemId) -> Result<(), ShapeFault> {
        let missing = ShapeFault::Missing;
        match shape {
            Shape::Sphere(sphere) => sphere.check(),
            Shape::Triangle(indices) => match self.corners(indices) {
                Some(_) => Ok(()),
                None => Err(missing),
            },
            Shape::SmoothTriangle(indices) => match (self.corners(indices), self.vertex_normals(indices)) {
                (Some(_), Some(_)) => Ok(()),
                _ => Err(missing),
            },
            Shape::Plane(index) => {
                let plane = get(self.planes, index).ok_or(missing)?;
                plane.check()?;
                if plane.item == item { Ok(()) } else { Err(ShapeFault::Plane) }
            }
            Shape::Disc(index) => get(self.discs, index).ok_or(missing)?.check(),
            Shape::Polygon(index) => {
                get(self.polygons, index).ok_or(missing)?.check(self.points, self.normals)
            }
            Shape::Cuboid(index) => get(self.cuboids, index).ok_or(missing)?.check(),
            Shape::TurnedCuboid(index) => get(self.turned_cuboids, index).ok_or(missing)?.check(),
            Shape::Cone(index) => get(self.cones, index).ok_or(missing)?.check(),
            Shape::Torus(index) => get(self.tori, index).ok_or(missing)?.check(),
            Shape::Moving(_) => Err(ShapeFault::Moving),
        }
    }
}
