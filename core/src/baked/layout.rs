//! Memory layout of the core's types, written field by field.
//!
//! Padding between fields and after the shorter variants of an enum has no defined value, so each type is
//! destructured and padding is written as zeros. Patterns have no `..`, so that a new field is a compile error here.

use crate::accel::{BvhEntry, BvhNode, OctreeNode};
use crate::geometry::{
    Aabb, Cone, Cuboid, Disc, ItemId, MovingShape, OrientedCuboid, Plane, Polygon, Shape, Sphere, Torus,
};
use crate::math::{Rgb, Vec3};
use crate::scene::{
    Background, CameraDescriptor, Falloff, FresnelModel, Light, LightSource, Material, MaterialId,
    Projection, Texture, TextureId,
};

/// Writes values in their memory layout.
pub(super) struct LayoutWriter<'w> {
    /// Receives each piece, and the number of bytes before it.
    pub(super) output: &'w mut dyn FnMut(&[u8], usize),
    /// Number of bytes so far.
    pub(super) written: usize,
    /// If it is given, it receives the number and size of the entries of each table, and nothing is written.
    pub(super) measure: Option<&'w mut dyn FnMut(usize, usize)>,
}

impl LayoutWriter<'_> {
    fn write(&mut self, bytes: &[u8]) {
        (self.output)(bytes, self.written);
        self.written += bytes.len();
    }

    /// Writes zeros up to a multiple of `alignment`.
    fn align(&mut self, alignment: usize) {
        while !self.written.is_multiple_of(alignment) {
            self.write(&[0]);
        }
    }

    /// Writes a table.
    pub(super) fn table<T: WriteLayout>(&mut self, entries: &[T]) {
        if let Some(measure) = &mut self.measure {
            measure(entries.len(), size_of::<T>());
            return;
        }
        for entry in entries {
            entry.write_padded(self);
        }
        self.align(4);
    }
}

/// A type that can be written in its memory layout (`repr(C)`).
pub(super) trait WriteLayout: Sized {
    /// Writes its fields in order.
    fn write_fields(&self, w: &mut LayoutWriter<'_>);

    /// Writes padding for its alignment, its fields, and padding up to its size.
    fn write_padded(&self, w: &mut LayoutWriter<'_>) {
        w.align(align_of::<Self>());
        let end = w.written + size_of::<Self>();
        self.write_fields(w);
        while w.written < end {
            w.write(&[0]);
        }
        debug_assert!(w.written == end, "a type has another layout than is written");
    }
}

macro_rules! numbers {
    ($($Number:ty)*) => {$(
        impl WriteLayout for $Number {
            fn write_fields(&self, w: &mut LayoutWriter<'_>) {
                w.write(&self.to_le_bytes());
            }
        }
    )*};
}
numbers!(u8 u16 u32 f32);

impl WriteLayout for bool {
    fn write_fields(&self, w: &mut LayoutWriter<'_>) {
        w.write(&[u8::from(*self)]);
    }
}

impl<T: WriteLayout, const N: usize> WriteLayout for [T; N] {
    fn write_fields(&self, w: &mut LayoutWriter<'_>) {
        self.iter().for_each(|one| one.write_padded(w));
    }
}

impl WriteLayout for Vec3 {
    fn write_fields(&self, w: &mut LayoutWriter<'_>) {
        self.to_array().write_fields(w);
    }
}

/// Structs: their fields in the order of declaration.
macro_rules! structs {
    ($($Struct:ident { $($field:ident),* })*) => {$(
        impl WriteLayout for $Struct {
            fn write_fields(&self, w: &mut LayoutWriter<'_>) {
                let $Struct { $($field),* } = self;
                $($field.write_padded(w);)*
            }
        }
    )*};
}
structs! {
    Rgb { r, g, b }
    Aabb { min, max }
    Sphere { center, radius }
    Plane { point, normal, item }
    Disc { center, normal, radius }
    Polygon { first_vertex, vertex_count, point, normal, bounds, smooth }
    Cuboid { min, max }
    OrientedCuboid { center, half_extents, axes }
    Cone { base, axis, height, base_radius, end_radius, capped }
    Torus { center, axis, major_radius, minor_radius }
    MovingShape { shape, offset_at_open, offset_at_close }
    Material {
        ambient, diffuse, texture, highlight, highlight_exponent, reflection, transmission, roughness, refractive_index, fresnel, attenuation_length,
        priority, two_sided
    }
    Light { source, color, casts_shadows }
    Falloff { constant, linear, quadratic }
    CameraDescriptor { position, target, up, projection }
}

/// Structs of one field.
macro_rules! newtypes {
    ($($Struct:ident)*) => {$(
        impl WriteLayout for $Struct {
            fn write_fields(&self, w: &mut LayoutWriter<'_>) {
                self.0.write_padded(w);
            }
        }
    )*};
}
newtypes!(ItemId MaterialId TextureId);

impl WriteLayout for OctreeNode {
    fn write_fields(&self, w: &mut LayoutWriter<'_>) {
        self.words().write_padded(w);
    }
}

impl WriteLayout for BvhNode {
    fn write_fields(&self, w: &mut LayoutWriter<'_>) {
        self.words().write_padded(w);
    }
}

impl WriteLayout for BvhEntry {
    fn write_fields(&self, w: &mut LayoutWriter<'_>) {
        self.word().write_padded(w);
    }
}

impl WriteLayout for FresnelModel {
    fn write_fields(&self, w: &mut LayoutWriter<'_>) {
        (*self as u8).write_fields(w);
    }
}

/// Discriminant of a variant (its place in the declaration), and its fields.
macro_rules! variant {
    ($w:ident, $number:literal $(, $field:ident)*) => {{
        let number: u32 = $number;
        number.write_padded($w);
        $($field.write_padded($w);)*
    }};
}

impl WriteLayout for Shape {
    fn write_fields(&self, w: &mut LayoutWriter<'_>) {
        match self {
            Shape::Sphere(sphere) => variant!(w, 0, sphere),
            Shape::Triangle(vertices) => variant!(w, 1, vertices),
            Shape::SmoothTriangle(vertices) => variant!(w, 2, vertices),
            Shape::Plane(index) => variant!(w, 3, index),
            Shape::Disc(index) => variant!(w, 4, index),
            Shape::Polygon(index) => variant!(w, 5, index),
            Shape::Cuboid(index) => variant!(w, 6, index),
            Shape::OrientedCuboid(index) => variant!(w, 7, index),
            Shape::Cone(index) => variant!(w, 8, index),
            Shape::Torus(index) => variant!(w, 9, index),
            Shape::Moving(index) => variant!(w, 10, index),
        }
    }
}

impl WriteLayout for Texture {
    fn write_fields(&self, w: &mut LayoutWriter<'_>) {
        match self {
            Texture::Checker { even, odd, origin, frequency } => variant!(w, 0, even, odd, origin, frequency),
            Texture::Gradient { start_color, end_color, origin, axis } => {
                variant!(w, 1, start_color, end_color, origin, axis)
            }
            Texture::ZonePlate { start_color, end_color, origin, frequency } => {
                variant!(w, 2, start_color, end_color, origin, frequency)
            }
        }
    }
}

impl WriteLayout for Background {
    fn write_fields(&self, w: &mut LayoutWriter<'_>) {
        match self {
            Background::Color(color) => variant!(w, 0, color),
            Background::Gradient { up, below, above } => variant!(w, 1, up, below, above),
        }
    }
}

impl WriteLayout for Projection {
    fn write_fields(&self, w: &mut LayoutWriter<'_>) {
        match self {
            Projection::Perspective { field_of_view } => variant!(w, 0, field_of_view),
            Projection::Orthographic { height } => variant!(w, 1, height),
            Projection::ThinLens { field_of_view, lens_radius, focus_distance } => {
                variant!(w, 2, field_of_view, lens_radius, focus_distance)
            }
        }
    }
}

impl WriteLayout for LightSource {
    fn write_fields(&self, w: &mut LayoutWriter<'_>) {
        match self {
            LightSource::Point { position, falloff } => variant!(w, 0, position, falloff),
            LightSource::Directional { to_light } => variant!(w, 1, to_light),
            LightSource::Spot { position, direction, cos_inner, cos_outer, falloff } => {
                variant!(w, 2, position, direction, cos_inner, cos_outer, falloff)
            }
            LightSource::Sphere { position, radius, falloff } => variant!(w, 3, position, radius, falloff),
            LightSource::Rectangle { position, half_edges, soft_shadows, falloff } => {
                variant!(w, 4, position, half_edges, soft_shadows, falloff)
            }
        }
    }
}
