//! Whether the tables of a geometry fit together.

use super::{Geometry, ItemId, Shape, ShapeFault, of};
use crate::math::{is_in_range, is_unit};

impl Geometry<'_> {
    /// Whether every shape is one and finds what it refers to; else the first that does not.
    pub fn check(&self) -> Result<(), (ItemId, ShapeFault)> {
        if self.points.iter().any(|p| !is_in_range(*p)) {
            return Err((ItemId(0), ShapeFault::Place));
        }
        if self.normals.iter().any(|n| !is_unit(*n)) {
            return Err((ItemId(0), ShapeFault::NotUnit));
        }
        for (shape, number) in self.shapes.iter().zip(0..) {
            self.check_shape(*shape, ItemId(number)).map_err(|fault| (ItemId(number), fault))?;
        }
        // Planes are met through their table, so each must be an item.
        for (plane, place) in self.planes.iter().zip(0..) {
            let shape = self.shape(plane.item).and_then(|shape| self.at_rest(shape)).copied();
            if shape != Some(Shape::Plane(place)) {
                return Err((plane.item, ShapeFault::Plane));
            }
        }
        Ok(())
    }

    fn check_shape(&self, shape: Shape, item: ItemId) -> Result<(), ShapeFault> {
        if let Shape::Moving(place) = shape {
            let moving = self.moving(place).ok_or(ShapeFault::Missing)?;
            moving.check()?;
            return self.check_rest(moving.shape, item);
        }
        self.check_rest(shape, item)
    }

    fn check_rest(&self, shape: Shape, item: ItemId) -> Result<(), ShapeFault> {
        let missing = ShapeFault::Missing;
        match shape {
            Shape::Sphere(sphere) => sphere.check(),
            Shape::Triangle(corners) => match self.corners(corners) {
                Some(_) => Ok(()),
                None => Err(missing),
            },
            Shape::SmoothTriangle(corners) => match (self.corners(corners), self.corner_normals(corners)) {
                (Some(_), Some(_)) => Ok(()),
                _ => Err(missing),
            },
            Shape::Plane(place) => {
                let plane = of(self.planes, place).ok_or(missing)?;
                plane.check()?;
                if plane.item == item { Ok(()) } else { Err(ShapeFault::Plane) }
            }
            Shape::Disc(place) => of(self.discs, place).ok_or(missing)?.check(),
            Shape::Polygon(place) => {
                of(self.polygons, place).ok_or(missing)?.check(self.points, self.normals)
            }
            Shape::Cuboid(place) => of(self.cuboids, place).ok_or(missing)?.check(),
            Shape::TurnedCuboid(place) => of(self.turned_cuboids, place).ok_or(missing)?.check(),
            Shape::Cone(place) => of(self.cones, place).ok_or(missing)?.check(),
            Shape::Torus(place) => of(self.tori, place).ok_or(missing)?.check(),
            Shape::Moving(_) => Err(ShapeFault::Moving),
        }
    }
}
