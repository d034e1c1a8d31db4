//! Shapes in the textbook's representation.

use super::intersect::{cone, cuboid, is_inside, plane, sphere, torus, triangle};
use super::{TextbookHit, narrow};
use strahl_core::Vec3;
use strahl_test_scene::vector::{area, unit};
use strahl_test_scene::{TestRay, TestShape};

/// A shape in the textbook's representation, with precomputed values.
#[derive(Clone, Debug)]
#[allow(missing_docs)] // as in `TestShape`
pub enum TextbookShape {
    Sphere {
        center: Vec3,
        radius: f32,
    },
    /// `n . p = d`.
    Plane {
        normal: Vec3,
        d: f32,
    },
    Disc {
        center: Vec3,
        normal: Vec3,
        d: f32,
        radius: f32,
    },
    Triangle {
        vertices: [Vec3; 3],
    },
    Polygon {
        vertices: Vec<Vec3>,
        normal: Vec3,
        d: f32,
    },
    Cuboid {
        min: Vec3,
        max: Vec3,
    },
    /// Center in the box's own frame, and the axes of the frame.
    OrientedCuboid {
        center: Vec3,
        half: Vec3,
        axes: [Vec3; 3],
    },
    Cone {
        base: Vec3,
        axis: Vec3,
        height: f32,
        base_radius: f32,
        end_radius: f32,
        capped: bool,
    },
    Torus {
        center: Vec3,
        axis: Vec3,
        major: f32,
        minor: f32,
    },
}

impl TextbookShape {
    /// Converts a test shape.
    pub fn of(shape: &TestShape) -> TextbookShape {
        match shape {
            TestShape::Sphere { center, radius } => {
                TextbookShape::Sphere { center: narrow(*center), radius: *radius as f32 }
            }
            TestShape::Plane { point, normal } => {
                let normal = narrow(*normal).normalize();
                TextbookShape::Plane { normal, d: normal.dot(narrow(*point)) }
            }
            TestShape::Disc { center, normal, radius } => {
                let (center, normal) = (narrow(*center), narrow(*normal).normalize());
                TextbookShape::Disc { center, normal, d: normal.dot(center), radius: *radius as f32 }
            }
            TestShape::Triangle { vertices } | TestShape::SmoothTriangle { vertices, .. } => {
                TextbookShape::Triangle { vertices: vertices.map(narrow) }
            }
            TestShape::Polygon { vertices } | TestShape::SmoothPolygon { vertices, .. } => {
                let normal = narrow(unit(area(vertices)));
                let vertices: Vec<Vec3> = vertices.iter().copied().map(narrow).collect();
                let d = normal.dot(vertices[0]);
                TextbookShape::Polygon { vertices, normal, d }
            }
            TestShape::Cuboid { min, max } => TextbookShape::Cuboid { min: narrow(*min), max: narrow(*max) },
            TestShape::OrientedCuboid { center, half, first, third } => {
                let z = narrow(*third).normalize();
                let y = z.cross(narrow(*first)).normalize();
                let axes = [y.cross(z), y, z];
                let center = narrow(*center);
                TextbookShape::OrientedCuboid { center: to_frame(center, &axes), half: narrow(*half), axes }
            }
            TestShape::Cone { base, base_radius, end, end_radius, capped } => {
                let (base, end) = (narrow(*base), narrow(*end));
                let height = (end - base).length();
                TextbookShape::Cone {
                    base,
                    axis: (end - base) / height,
                    height,
                    base_radius: *base_radius as f32,
                    end_radius: *end_radius as f32,
                    capped: *capped,
                }
            }
            TestShape::Torus { center, axis, major, minor } => TextbookShape::Torus {
                center: narrow(*center),
                axis: narrow(*axis).normalize(),
                major: *major as f32,
                minor: *minor as f32,
            },
        }
    }

    /// Nearest hit of a ray.
    pub fn intersect(&self, ray: &TestRay) -> Option<TextbookHit> {
        self.hit(narrow(ray.origin), narrow(ray.direction))
    }

    /// Distance of the nearest hit of the ray from `o` in the direction `d`.
    pub fn distance(&self, o: Vec3, d: Vec3) -> Option<f32> {
        self.hit(o, d).map(|hit| hit.t)
    }

    /// Nearest hit of the ray from `o` in the direction `d`.
    #[inline]
    fn hit(&self, o: Vec3, d: Vec3) -> Option<TextbookHit> {
        match self {
            TextbookShape::Sphere { center, radius } => sphere(*center, *radius, o, d),
            TextbookShape::Plane { normal, d: level } => {
                plane(*normal, *level, o, d).map(|t| TextbookHit { t, normal: *normal })
            }
            TextbookShape::Disc { center, normal, d: level, radius } => {
                let t = plane(*normal, *level, o, d)?;
                let away = o + d * t - *center;
                (away.dot(away) <= radius * radius).then_some(TextbookHit { t, normal: *normal })
            }
            TextbookShape::Triangle { vertices } => triangle(vertices, o, d),
            TextbookShape::Polygon { vertices, normal, d: level } => {
                let t = plane(*normal, *level, o, d)?;
                is_inside(vertices, *normal, o + d * t).then_some(TextbookHit { t, normal: *normal })
            }
            TextbookShape::Cuboid { min, max } => cuboid(*min, *max, o, d),
            TextbookShape::OrientedCuboid { center, half, axes } => {
                let hit = cuboid(*center - *half, *center + *half, to_frame(o, axes), to_frame(d, axes))?;
                let n = hit.normal;
                Some(TextbookHit { t: hit.t, normal: axes[0] * n.x + axes[1] * n.y + axes[2] * n.z })
            }
            TextbookShape::Cone { base, axis, height, base_radius, end_radius, capped } => {
                cone(*base, *axis, *height, *base_radius, *end_radius, *capped, o, d)
            }
            TextbookShape::Torus { center, axis, major, minor } => {
                torus(*center, *axis, *major, *minor, o, d)
            }
        }
    }
}

fn to_frame(v: Vec3, axes: &[Vec3; 3]) -> Vec3 {
    Vec3::new(v.dot(axes[0]), v.dot(axes[1]), v.dot(axes[2]))
}
