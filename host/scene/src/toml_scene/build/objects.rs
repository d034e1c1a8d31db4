//! Objects that consist of one shape.

use std::ops::Range;

use strahl_core::Vec3;
use strahl_core::geometry::{Cone, Polygon};
use strahl_core::math::MAX_COORDINATE;

use super::add_to_scene::AddToScene;
use super::builder::SceneBuilder;
use super::rotation;
use crate::description::{Float3, ShapeDescription, vec3_of};
use crate::diagnostics::Diagnostic;
use crate::toml_scene::format::{self, MaterialRef};
use crate::toml_scene::value::{DirectionList, PointList, PointValue, Spanned};

/// A table of one shape.
trait SingleShape {
    /// Its shape; `None` after an error.
    fn shape(&self, span: &Range<usize>, builder: &mut SceneBuilder<'_>) -> Option<ShapeDescription>;

    /// Its material.
    fn material(&self) -> &Option<MaterialRef>;

    /// Its velocity.
    fn velocity(&self) -> &Option<Spanned<PointValue>>;
}

impl<T: SingleShape> AddToScene for T {
    fn add(&self, span: &Range<usize>, builder: &mut SceneBuilder<'_>) {
        // Evaluated together, so that errors in both are reported.
        let (form, material) = (self.shape(span, builder), builder.material_id(self.material(), span));
        let velocity = builder.checked_velocity(self.velocity());
        if let (Some(form), Some(material), Some(velocity)) = (form, material, velocity) {
            builder.add_object(form, material, velocity, span);
        }
    }
}

/// Implements `SingleShape` for the tables of objects.
macro_rules! single_shapes {
    ($($Kind:ident: |$it:ident, $span:ident, $builder:ident| $form:expr;)*) => {$(
        impl SingleShape for format::$Kind {
            fn shape(&self, $span: &Range<usize>, $builder: &mut SceneBuilder<'_>) -> Option<ShapeDescription> {
                let $it = self;
                $form
            }

            fn material(&self) -> &Option<MaterialRef> {
                &self.material
            }

            fn velocity(&self) -> &Option<Spanned<PointValue>> {
                &self.velocity
            }
        }
    )*};
}

const ORIGIN: Float3 = [0.0; 3];
/// The default normal and axis.
const UNIT_Y: Float3 = [0.0, 1.0, 0.0];

single_shapes! {
    SphereTable: |it, _span, _builder| {
        Some(ShapeDescription::Sphere { center: it.center.map_or(ORIGIN, |p| p.0), radius: it.radius.0 })
    };
    PlaneTable: |it, _span, _builder| {
        let point = it.point.map_or(ORIGIN, |p| p.0);
        Some(ShapeDescription::Plane { point, normal: it.normal.map_or(UNIT_Y, |d| d.0) })
    };
    DiscTable: |it, _span, _builder| {
        let (center, normal) = (it.center.map_or(ORIGIN, |p| p.0), it.normal.map_or(UNIT_Y, |d| d.0));
        Some(ShapeDescription::Disc { center, normal, radius: it.radius.0 })
    };
    TorusTable: |it, _span, builder| {
        if it.tube.value.0 > it.radius.0 {
            let message = format!("the `tube` must be at most the `radius`, which is {}", it.radius.0);
            return builder.reader.report(Diagnostic::new(it.tube.span.clone(), message));
        }
        Some(ShapeDescription::Torus {
            center: it.center.map_or(ORIGIN, |p| p.0),
            axis: it.axis.map_or(UNIT_Y, |d| d.0),
            major_radius: it.radius.0,
            minor_radius: it.tube.value.0,
        })
    };
    CylinderTable: |it, _span, builder| {
        let base = it.base.map_or(ORIGIN, |p| p.0);
        let end = checked_end(base, &it.end, builder)?;
        let (radius, capped) = (it.radius.0, it.open != Some(true));
        Some(ShapeDescription::Cone { base, base_radius: radius, end, end_radius: radius, capped })
    };
    ConeTable: |it, _span, builder| {
        let base = it.base.map_or(ORIGIN, |p| p.0);
        let (radius, end_radius) = (it.radius.value.0, it.end_radius.map_or(0.0, |r| r.0));
        if radius == 0.0 && end_radius == 0.0 {
            return builder.reader.report(Diagnostic::new(it.radius.span.clone(), "both radii of the cone are 0"));
        }
        let end = checked_end(base, &it.end, builder)?;
        Some(ShapeDescription::Cone { base, base_radius: radius, end, end_radius, capped: it.open != Some(true) })
    };
    BoxTable: |it, span, builder| box_shape(it, span, builder);
    TriangleTable: |it, _span, builder| {
        let corners = &it.corners.value.0;
        if corners.len() != 3 {
            let message = format!("a triangle has three corners, not {}", corners.len());
            let diagnostic = Diagnostic::new(it.corners.span.clone(), message);
            return builder.reader.report(diagnostic.with_help("a [[polygon]] may have more"));
        }
        let normals = normals(corners.len(), &it.normals, builder)?;
        if polygon_plane(&it.corners.value).is_none() {
            return Some(ShapeDescription::Degenerate);
        }
        let first = builder.add_vertices(corners.iter().map(|p| p.value.0), &normals);
        Some(ShapeDescription::Triangle { vertices: [first, first + 1, first + 2], smooth: !normals.is_empty() })
    };
    PolygonTable: |it, _span, builder| {
        let corners = &it.corners.value.0;
        let error = |message: &str| Diagnostic::new(it.corners.span.clone(), message);
        if corners.len() < 3 {
            return builder.reader.report(error("a polygon has at least three corners"));
        }
        let normals = normals(corners.len(), &it.normals, builder)?;
        if polygon_plane(&it.corners.value).is_none() {
            let diagnostic = error("the polygon has zero area");
            return builder.reader.report(diagnostic.with_help("its corners are collinear, or its edges cross"));
        }
        let first = builder.add_vertices(corners.iter().map(|p| p.value.0), &normals);
        let count = u32::try_from(corners.len()).unwrap_or(u32::MAX);
        Some(ShapeDescription::Polygon { first, count, smooth: !normals.is_empty() })
    };
}

/// The plane of a polygon; `None` if it has no area.
fn polygon_plane(corners: &PointList) -> Option<Polygon> {
    let corners: Vec<Vec3> = corners.0.iter().map(|p| vec3_of(p.value.0)).collect();
    Polygon::new(0, &corners, false)
}

/// The vertex normals: as many as corners, or none.
fn normals(
    corners: usize,
    normals: &Option<Spanned<DirectionList>>,
    builder: &mut SceneBuilder<'_>,
) -> Option<Vec<Float3>> {
    let Some(Spanned { value: it, span }) = normals else { return Some(Vec::new()) };
    if it.0.len() != corners {
        let message = format!("there are {corners} corners, but {} normals", it.0.len());
        return builder.reader.report(Diagnostic::new(span.clone(), message));
    }
    Some(it.0.iter().map(|normal| normal.0).collect())
}

/// The end of a cylinder or cone; `None` if its length is 0 or too large.
fn checked_end(base: Float3, end: &Spanned<PointValue>, builder: &mut SceneBuilder<'_>) -> Option<Float3> {
    let message = match Cone::new(vec3_of(base), 1.0, vec3_of(end.value.0), 1.0, false) {
        None => "`base` and `end` must differ".into(),
        Some(cone) if cone.height > MAX_COORDINATE => format!("the length exceeds {MAX_COORDINATE:e}"),
        Some(_) => return Some(end.value.0),
    };
    builder.reader.report(Diagnostic::new(end.span.clone(), message))
}

/// A box, axis-aligned or oriented.
fn box_shape(
    it: &format::BoxTable,
    span: &Range<usize>,
    builder: &mut SceneBuilder<'_>,
) -> Option<ShapeDescription> {
    let (min, max) = match (&it.min, &it.max, &it.size) {
        (Some(min), Some(max), None) if it.center.is_none() => {
            let below = (0..3).find(|axis| min.value.0[*axis] > max.value.0[*axis]);
            if let Some(axis) = below {
                let (axis, low, high) = (["x", "y", "z"][axis], min.value.0[axis], max.value.0[axis]);
                let message = format!("`max` must not be below `min`, but {axis} goes from {low} to {high}");
                return builder.reader.report(Diagnostic::new(max.span.clone(), message));
            }
            (min.value.0, max.value.0)
        }
        (None, None, Some(size)) => {
            let center = it.center.as_ref().map_or(ORIGIN, |center| center.value.0);
            let half = size.value.0.map(|size| 0.5 * size);
            let corner = |sign: f32| std::array::from_fn(|axis| center[axis] + sign * half[axis]);
            let (min, max): (Float3, Float3) = (corner(-1.0), corner(1.0));
            if min.iter().chain(&max).any(|x| x.abs() > MAX_COORDINATE) {
                let message = format!("the box extends beyond {MAX_COORDINATE:e}");
                return builder.reader.report(Diagnostic::new(size.span.clone(), message));
            }
            (min, max)
        }
        _ => {
            let mixed = it.min.is_some() || it.max.is_some();
            let centered = [it.center.as_ref().map(|c| &c.span), it.size.as_ref().map(|s| &s.span)];
            let help = "write `min` and `max`, or `size` and perhaps `center`";
            return match centered.into_iter().flatten().next() {
                Some(place) if mixed => {
                    let diagnostic = Diagnostic::new(place.clone(), "the box extent is given twice");
                    builder.reader.report(diagnostic.with_help(help))
                }
                _ => {
                    let diagnostic = Diagnostic::new(span.clone(), "this `box` has no extent");
                    builder.reader.report_missing(diagnostic.with_help(help))
                }
            };
        }
    };
    let degrees = it.rotate.map_or(ORIGIN, |turn| turn.0);
    if degrees == ORIGIN {
        return Some(ShapeDescription::Cuboid { min, max });
    }
    let [first, _, third] = rotation::rotated_axes(degrees);
    // The mean of two coordinates in range is in range.
    let center = match (&it.size, &it.center) {
        (Some(_), center) => center.as_ref().map_or(ORIGIN, |center| center.value.0),
        _ => std::array::from_fn(|axis| 0.5 * (min[axis] + max[axis])),
    };
    let half = match &it.size {
        Some(size) => size.value.0.map(|size| 0.5 * size),
        None => std::array::from_fn(|axis| 0.5 * (max[axis] - min[axis])),
    };
    Some(ShapeDescription::OrientedCuboid { center, half_size: half, first, third })
}
