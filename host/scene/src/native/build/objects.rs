//! The objects of the file become forms of the description.

use std::ops::Range;

use strahl_core::Vec3;
use strahl_core::geometry::{Cone, Polygon};
use strahl_core::math::MAX_COORDINATE;

use super::builder::SceneBuilder;
use super::thing::Thing;
use super::turn;
use crate::description::{Float3, ShapeDescription, vec3_of};
use crate::diagnostics::Diagnostic;
use crate::native::format::{self, Surface};
use crate::native::value::{Directions, Point, Points, Spanned};

/// One object.
trait Single {
    /// Its shape; none when that is wrong.
    fn form(&self, span: &Range<usize>, builder: &mut SceneBuilder<'_>) -> Option<ShapeDescription>;

    /// What it is made of.
    fn surface(&self) -> &Option<Surface>;

    /// How it moves.
    fn velocity(&self) -> &Option<Spanned<Point>>;
}

impl<T: Single> Thing for T {
    fn add(&self, span: &Range<usize>, builder: &mut SceneBuilder<'_>) {
        // Both, so that what is wrong with either is told.
        let (form, material) = (self.form(span, builder), builder.made_of(self.surface(), span));
        let velocity = builder.velocity(self.velocity());
        if let (Some(form), Some(material), Some(velocity)) = (form, material, velocity) {
            builder.push(form, material, velocity, span);
        }
    }
}

/// Declares what a kind of object becomes.
macro_rules! single {
    ($($Kind:ident: |$it:ident, $span:ident, $builder:ident| $form:expr;)*) => {$(
        impl Single for format::$Kind {
            fn form(&self, $span: &Range<usize>, $builder: &mut SceneBuilder<'_>) -> Option<ShapeDescription> {
                let $it = self;
                $form
            }

            fn surface(&self) -> &Option<Surface> {
                &self.material
            }

            fn velocity(&self) -> &Option<Spanned<Point>> {
                &self.velocity
            }
        }
    )*};
}

const ORIGIN: Float3 = [0.0; 3];
/// Upright on what lies on the floor.
const UPRIGHT: Float3 = [0.0, 1.0, 0.0];

single! {
    Sphere: |it, _span, _maker| {
        Some(ShapeDescription::Sphere { center: it.center.map_or(ORIGIN, |p| p.0), radius: it.radius.0 })
    };
    Plane: |it, _span, _maker| {
        let point = it.point.map_or(ORIGIN, |p| p.0);
        Some(ShapeDescription::Plane { point, normal: it.normal.map_or(UPRIGHT, |d| d.0) })
    };
    Disc: |it, _span, _maker| {
        let (center, normal) = (it.center.map_or(ORIGIN, |p| p.0), it.normal.map_or(UPRIGHT, |d| d.0));
        Some(ShapeDescription::Disc { center, normal, radius: it.radius.0 })
    };
    Torus: |it, _span, builder| {
        if it.tube.it.0 > it.radius.0 {
            let what = format!("the `tube` must be at most the `radius`, which is {}", it.radius.0);
            return builder.reader.wrong(Diagnostic::new(it.tube.span.clone(), what));
        }
        Some(ShapeDescription::Torus {
            center: it.center.map_or(ORIGIN, |p| p.0),
            axis: it.axis.map_or(UPRIGHT, |d| d.0),
            major_radius: it.radius.0,
            minor_radius: it.tube.it.0,
        })
    };
    Cylinder: |it, _span, builder| {
        let base = it.base.map_or(ORIGIN, |p| p.0);
        let end = axis(base, &it.end, builder)?;
        let (radius, capped) = (it.radius.0, it.open != Some(true));
        Some(ShapeDescription::Cone { base, base_radius: radius, end, end_radius: radius, capped })
    };
    Cone: |it, _span, builder| {
        let base = it.base.map_or(ORIGIN, |p| p.0);
        let (radius, end_radius) = (it.radius.it.0, it.end_radius.map_or(0.0, |r| r.0));
        if radius == 0.0 && end_radius == 0.0 {
            return builder.reader.wrong(Diagnostic::new(it.radius.span.clone(), "both radii of the cone are 0"));
        }
        let end = axis(base, &it.end, builder)?;
        Some(ShapeDescription::Cone { base, base_radius: radius, end, end_radius, capped: it.open != Some(true) })
    };
    Box: |it, span, builder| cuboid(it, span, builder);
    Triangle: |it, _span, builder| {
        let corners = &it.corners.it.0;
        if corners.len() != 3 {
            let what = format!("a triangle has three corners, not {}", corners.len());
            let fault = Diagnostic::new(it.corners.span.clone(), what);
            return builder.reader.wrong(fault.with_help("a [[polygon]] may have more"));
        }
        let normals = normals(corners.len(), &it.normals, builder)?;
        if plane(&it.corners.it).is_none() {
            return Some(ShapeDescription::Degenerate);
        }
        let first = builder.corners(corners.iter().map(|p| p.it.0), &normals);
        Some(ShapeDescription::Triangle { vertices: [first, first + 1, first + 2], smooth: !normals.is_empty() })
    };
    Polygon: |it, _span, builder| {
        let corners = &it.corners.it.0;
        let wrong = |what: &str| Diagnostic::new(it.corners.span.clone(), what);
        if corners.len() < 3 {
            return builder.reader.wrong(wrong("a polygon has at least three corners"));
        }
        let normals = normals(corners.len(), &it.normals, builder)?;
        if plane(&it.corners.it).is_none() {
            let fault = wrong("the polygon has no area");
            return builder.reader.wrong(fault.with_help("its corners are all in one line, or cross over"));
        }
        let first = builder.corners(corners.iter().map(|p| p.it.0), &normals);
        let count = u32::try_from(corners.len()).unwrap_or(u32::MAX);
        Some(ShapeDescription::Polygon { first, count, smooth: !normals.is_empty() })
    };
}

/// The plane of corners; none when they have no area.
fn plane(corners: &Points) -> Option<Polygon> {
    let corners: Vec<Vec3> = corners.0.iter().map(|p| vec3_of(p.it.0)).collect();
    Polygon::new(0, &corners, false)
}

/// As many normals as corners, or none at all.
fn normals(
    corners: usize,
    normals: &Option<Spanned<Directions>>,
    builder: &mut SceneBuilder<'_>,
) -> Option<Vec<Float3>> {
    let Some(Spanned { it, span }) = normals else { return Some(Vec::new()) };
    if it.0.len() != corners {
        let what = format!("there are {corners} corners, but {} normals", it.0.len());
        return builder.reader.wrong(Diagnostic::new(span.clone(), what));
    }
    Some(it.0.iter().map(|normal| normal.0).collect())
}

/// The end of a cylinder or cone whose length is one.
fn axis(base: Float3, end: &Spanned<Point>, builder: &mut SceneBuilder<'_>) -> Option<Float3> {
    let what = match Cone::new(vec3_of(base), 1.0, vec3_of(end.it.0), 1.0, false) {
        None => "it ends where it begins: `base` and `end` are the same".into(),
        Some(cone) if cone.height > MAX_COORDINATE => format!("it is longer than {MAX_COORDINATE:e}"),
        Some(_) => return Some(end.it.0),
    };
    builder.reader.wrong(Diagnostic::new(end.span.clone(), what))
}

/// A box, upright or turned.
fn cuboid(it: &format::Box, span: &Range<usize>, builder: &mut SceneBuilder<'_>) -> Option<ShapeDescription> {
    let (min, max) = match (&it.min, &it.max, &it.size) {
        (Some(min), Some(max), None) if it.center.is_none() => {
            let below = (0..3).find(|axis| min.it.0[*axis] > max.it.0[*axis]);
            if let Some(axis) = below {
                let (axis, low, high) = (["x", "y", "z"][axis], min.it.0[axis], max.it.0[axis]);
                let what = format!("`max` must not be below `min`, but {axis} goes from {low} to {high}");
                return builder.reader.wrong(Diagnostic::new(max.span.clone(), what));
            }
            (min.it.0, max.it.0)
        }
        (None, None, Some(size)) => {
            let center = it.center.as_ref().map_or(ORIGIN, |center| center.it.0);
            let half = size.it.0.map(|size| 0.5 * size);
            let corner = |sign: f32| std::array::from_fn(|axis| center[axis] + sign * half[axis]);
            let (min, max): (Float3, Float3) = (corner(-1.0), corner(1.0));
            if min.iter().chain(&max).any(|x| x.abs() > MAX_COORDINATE) {
                let what = format!("the box reaches beyond {MAX_COORDINATE:e}");
                return builder.reader.wrong(Diagnostic::new(size.span.clone(), what));
            }
            (min, max)
        }
        _ => {
            let mixed = it.min.is_some() || it.max.is_some();
            let centered = [it.center.as_ref().map(|c| &c.span), it.size.as_ref().map(|s| &s.span)];
            let help = "write `min` and `max`, or `size` and perhaps `center`";
            return match centered.into_iter().flatten().next() {
                Some(place) if mixed => {
                    let fault = Diagnostic::new(place.clone(), "the box has its extent in two ways");
                    builder.reader.wrong(fault.with_help(help))
                }
                _ => {
                    let fault = Diagnostic::new(span.clone(), "the extent of this `box` is missing");
                    builder.reader.misses(fault.with_help(help))
                }
            };
        }
    };
    let degrees = it.rotate.map_or(ORIGIN, |turn| turn.0);
    if degrees == ORIGIN {
        return Some(ShapeDescription::Cuboid { min, max });
    }
    let [first, _, third] = turn::axes(degrees);
    // A quotient of sums of what is in range, and so in range.
    let center = match (&it.size, &it.center) {
        (Some(_), center) => center.as_ref().map_or(ORIGIN, |center| center.it.0),
        _ => std::array::from_fn(|axis| 0.5 * (min[axis] + max[axis])),
    };
    let half = match &it.size {
        Some(size) => size.it.0.map(|size| 0.5 * size),
        None => std::array::from_fn(|axis| 0.5 * (max[axis] - min[axis])),
    };
    Some(ShapeDescription::OrientedCuboid { center, half_size: half, first, third })
}
