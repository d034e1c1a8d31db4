//! How the core's types lie in memory, told field by field.
//!
//! The bytes between fields and behind the shorter variants of an enum have no value that could be
//! copied, so each type is taken apart. Without `..`, so that a new field is an error here.

use crate::accel::{BvhNode, LeafEntry, OctreeNode};
use crate::geometry::{
    Aabb, Cone, Cuboid, Disc, ItemId, MovingShape, OrientedCuboid, Plane, Polygon, Shape, Sphere, Torus,
};
use crate::math::{Rgb, Vec3};
use crate::scene::{
    Background, CameraDescriptor, Falloff, FresnelModel, Light, LightSource, Material, MaterialId,
    Projection, Texture, TextureId,
};

/// Who writes, and how far.
pub(super) struct LayoutWriter<'w> {
    /// Is given a piece, and how much was written before it.
    pub(super) output: &'w mut dyn FnMut(&[u8], usize),
    pub(super) written: usize,
    /// If there is one, it is told the length of each table and the size of its entries, and nothing
    /// is written.
    pub(super) measure: Option<&'w mut dyn FnMut(usize, usize)>,
}

impl LayoutWriter<'_> {
    fn write(&mut self, bytes: &[u8]) {
        (self.output)(bytes, self.written);
        self.written += bytes.len();
    }

    /// Zeros up to a place that `alignment` divides.
    fn align(&mut self, alignment: usize) {
        while !self.written.is_multiple_of(alignment) {
            self.write(&[0]);
        }
    }

    pub(super) fn table<T: WriteLayout>(&mut self, entries: &[T]) {
        if let Some(see) = &mut self.measure {
            see(entries.len(), size_of::<T>());
            return;
        }
        for entry in entries {
            entry.write_padded(self);
        }
        self.align(4);
    }
}

/// Something that can be written as it lies in memory, in `repr(C)`.
pub(super) trait WriteLayout: Sized {
    /// Its fields, in order.
    fn write_fields(&self, w: &mut LayoutWriter<'_>);

    /// Where its alignment puts it: its fields, and zeros to its full size.
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

/// Structs, by their fields in the order of their declaration.
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

/// Structs of one number.
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

impl WriteLayout for LeafEntry {
    fn write_fields(&self, w: &mut LayoutWriter<'_>) {
        self.word().write_padded(w);
    }
}

impl WriteLayout for FresnelModel {
    fn write_fields(&self, w: &mut LayoutWriter<'_>) {
        (*self as u8).write_fields(w);
    }
}

/// The number of a variant, and its fields.
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
            Shape::Triangle(corners) => variant!(w, 1, corners),
            Shape::SmoothTriangle(corners) => variant!(w, 2, corners),
            Shape::Plane(place) => variant!(w, 3, place),
            Shape::Disc(place) => variant!(w, 4, place),
            Shape::Polygon(place) => variant!(w, 5, place),
            Shape::Cuboid(place) => variant!(w, 6, place),
            Shape::OrientedCuboid(place) => variant!(w, 7, place),
            Shape::Cone(place) => variant!(w, 8, place),
            Shape::Torus(place) => variant!(w, 9, place),
            Shape::Moving(place) => variant!(w, 10, place),
        }
    }
}

impl WriteLayout for Texture {
    fn write_fields(&self, w: &mut LayoutWriter<'_>) {
        match self {
            Texture::Checker { even, odd, origin, frequency } => variant!(w, 0, even, odd, origin, frequency),
            Texture::Gradient { start_color: from, end_color: to, origin, axis: along } => {
                variant!(w, 1, from, to, origin, along)
            }
            Texture::ZonePlate { start_color: from, end_color: to, origin, frequency } => {
                variant!(w, 2, from, to, origin, frequency)
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
            Projection::Perspective { field_of_view: angle } => variant!(w, 0, angle),
            Projection::Orthographic { height } => variant!(w, 1, height),
            Projection::ThinLens { field_of_view: angle, lens_radius: radius, focus_distance: focus } => {
                variant!(w, 2, angle, radius, focus)
            }
        }
    }
}

impl WriteLayout for LightSource {
    fn write_fields(&self, w: &mut LayoutWriter<'_>) {
        match self {
            LightSource::Point { position, falloff } => variant!(w, 0, position, falloff),
            LightSource::Directional { to_light: toward } => variant!(w, 1, toward),
            LightSource::Spot { position, direction, cos_inner, cos_outer, falloff } => {
                variant!(w, 2, position, direction, cos_inner, cos_outer, falloff)
            }
            LightSource::Sphere { position, radius, falloff } => variant!(w, 3, position, radius, falloff),
            LightSource::Rectangle { position, half_edges: half, soft_shadows: soft, falloff } => {
                variant!(w, 4, position, half, soft, falloff)
            }
        }
    }
}
