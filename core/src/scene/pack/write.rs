//! Writing a baked scene: for hosts.
//!
//! Each type says field by field how it lies in memory, because the bytes between fields and behind
//! the shorter variants of an enum have no value that could be copied. Taking types apart without
//! `..` makes a new field an error here.

use super::Finder;
use super::header::{BARE, BVH, Checksum, Content, GRID, Header, MAGIC, OCTREE, TABLES, UNCHECKED};
use crate::accel::{Node, OctreeNode, Slot};
use crate::geometry::{Aabb, Cone, Cuboid, Disc, ItemId, Plane, Polygon, Shape, Sphere, Torus, TurnedCuboid};
use crate::math::{Real, Rgb, Vec3};
use crate::scene::{
    Background, Falloff, Interface, Light, Material, MaterialId, Pack, Projection, Scene, Size, Source,
    Texture, TextureId, View,
};

/// What is to be baked.
#[derive(Clone, Copy, Debug)]
pub struct Baking<'b> {
    /// The scene.
    pub scene: Scene<'b>,
    /// How it is looked at.
    pub view: View,
    /// The size of the picture.
    pub size: Size,
    /// Levels of rays.
    pub levels: u8,
    /// A ray is sent when more than this of it counts.
    pub cutoff: Real,
    /// What the scene is to be walked by.
    pub finder: Finder<'b>,
}

impl Baking<'_> {
    /// How many bytes it will take; none when they are more than the format can count.
    pub fn bytes(&self) -> Option<u32> {
        self.tables().map(|(_, end)| end)
    }

    /// Hands the bytes of the baked scene to `take`, piece by piece; false when they are more than
    /// the format can count, and then none is handed over.
    pub fn pour(&self, mut take: impl FnMut(&[u8])) -> bool {
        let Some((tables, bytes)) = self.tables() else { return false };
        // Once for the checksum, once in earnest.
        let mut checksum = Checksum::EMPTY;
        self.write_all(&tables, bytes, 0, &mut |piece, written| {
            if written >= UNCHECKED {
                checksum = checksum.and(piece);
            }
        });
        self.write_all(&tables, bytes, checksum.0, &mut |piece, _| take(piece));
        true
    }

    /// Where each table begins and how many entries it has; and where the last one ends.
    fn tables(&self) -> Option<([[u32; 2]; TABLES], u32)> {
        let mut tables = [[0; 2]; TABLES];
        let mut end = size_of::<Header>();
        let mut place = tables.iter_mut();
        self.each_table(&mut |count, size| {
            if let Some(table) = place.next() {
                *table = [u32::try_from(end).unwrap_or(u32::MAX), u32::try_from(count).unwrap_or(u32::MAX)];
            }
            end = end.saturating_add(count.saturating_mul(size)).next_multiple_of(4);
        });
        let end = u32::try_from(end).ok()?;
        Some((tables, end))
    }

    fn each_table(&self, see: &mut dyn FnMut(usize, usize)) {
        let mut silent = |_: &[u8], _: usize| ();
        let mut writer = Writer { take: &mut silent, written: 0, see: Some(see) };
        self.write_tables(&mut writer);
    }

    fn write_all(
        &self,
        tables: &[[u32; 2]; TABLES],
        bytes: u32,
        checksum: u32,
        take: &mut dyn FnMut(&[u8], usize),
    ) {
        let mut writer = Writer { take, written: 0, see: None };
        let w = &mut writer;
        [MAGIC, Pack::VERSION, bytes, checksum].whole(w);
        let Self { scene, view, size, levels, cutoff, finder } = self;
        [size.width(), size.height(), u32::from(*levels)].whole(w);
        cutoff.whole(w);
        view.whole(w);
        scene.parts().ambient.whole(w);
        scene.parts().background.whole(w);
        let nothing = (Aabb::POINT, [0; 3], 0);
        let (kind, (bounds, cells, depth)) = match finder {
            Finder::Bare(_) => (BARE, nothing),
            Finder::Grid(grid) => (GRID, (grid.parts().bounds, grid.parts().cells, 0)),
            Finder::Octree(octree) => (OCTREE, (octree.parts().bounds, [0; 3], 0)),
            Finder::Bvh(bvh) => (BVH, (Aabb::POINT, [0; 3], bvh.parts().depth)),
        };
        kind.whole(w);
        bounds.whole(w);
        cells.whole(w);
        depth.whole(w);
        tables.whole(w);
        debug_assert!(w.written == size_of::<Header>(), "the header has another layout than is written");
        self.write_tables(w);
    }

    /// In the order of [`Content`].
    fn write_tables(&self, w: &mut Writer<'_>) {
        let parts = self.scene.parts();
        let geometry = &parts.geometry;
        const _: () = assert!(Content::Tori as usize == 9 && Content::Items as usize == 15);
        w.table(geometry.shapes);
        w.table(geometry.points);
        w.table(geometry.normals);
        w.table(geometry.planes);
        w.table(geometry.discs);
        w.table(geometry.polygons);
        w.table(geometry.cuboids);
        w.table(geometry.turned_cuboids);
        w.table(geometry.cones);
        w.table(geometry.tori);
        w.table(parts.made_of);
        w.table(parts.materials);
        w.table(parts.textures);
        w.table(parts.lights);
        match &self.finder {
            Finder::Bare(_) => {
                w.table::<u32>(&[]);
                w.table::<u32>(&[]);
            }
            Finder::Grid(grid) => {
                w.table(grid.parts().starts);
                w.table(grid.parts().items);
            }
            Finder::Octree(octree) => {
                w.table(octree.parts().nodes);
                w.table(octree.parts().items);
            }
            Finder::Bvh(bvh) => {
                w.table(bvh.parts().nodes);
                w.table(bvh.parts().items);
            }
        }
    }
}

/// Who writes, and how far.
pub(crate) struct Writer<'w> {
    /// Is given a piece, and how much was written before it.
    take: &'w mut dyn FnMut(&[u8], usize),
    written: usize,
    /// If there is one, it is told the length of each table and the size of its entries, and nothing
    /// is written.
    see: Option<&'w mut dyn FnMut(usize, usize)>,
}

impl Writer<'_> {
    fn piece(&mut self, bytes: &[u8]) {
        (self.take)(bytes, self.written);
        self.written += bytes.len();
    }

    /// Zeros up to a place that `alignment` divides.
    fn align(&mut self, alignment: usize) {
        while self.written % alignment != 0 {
            self.piece(&[0]);
        }
    }

    fn table<T: Put>(&mut self, entries: &[T]) {
        if let Some(see) = &mut self.see {
            see(entries.len(), size_of::<T>());
            return;
        }
        for entry in entries {
            entry.whole(self);
        }
        self.align(4);
    }
}

/// Something that can be written as it lies in memory, in `repr(C)`.
pub(crate) trait Put: Sized {
    /// Its fields, in order.
    fn put(&self, w: &mut Writer<'_>);

    /// Where its alignment puts it: its fields, and zeros to its full size.
    fn whole(&self, w: &mut Writer<'_>) {
        w.align(align_of::<Self>());
        let end = w.written + size_of::<Self>();
        self.put(w);
        while w.written < end {
            w.piece(&[0]);
        }
        debug_assert!(w.written == end, "a type has another layout than is written");
    }
}

macro_rules! numbers {
    ($($Number:ty)*) => {$(
        impl Put for $Number {
            fn put(&self, w: &mut Writer<'_>) {
                w.piece(&self.to_le_bytes());
            }
        }
    )*};
}
numbers!(u8 u16 u32 f32);

impl Put for bool {
    fn put(&self, w: &mut Writer<'_>) {
        w.piece(&[u8::from(*self)]);
    }
}

impl<T: Put, const N: usize> Put for [T; N] {
    fn put(&self, w: &mut Writer<'_>) {
        self.iter().for_each(|one| one.whole(w));
    }
}

impl Put for Vec3 {
    fn put(&self, w: &mut Writer<'_>) {
        self.to_array().put(w);
    }
}

/// Structs, by their fields in the order of their declaration.
macro_rules! structs {
    ($($Struct:ident { $($field:ident),* })*) => {$(
        impl Put for $Struct {
            fn put(&self, w: &mut Writer<'_>) {
                let $Struct { $($field),* } = self;
                $($field.whole(w);)*
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
    Polygon { first, count, point, normal, smooth }
    Cuboid { min, max }
    TurnedCuboid { center, half, axes }
    Cone { base, axis, height, base_radius, end_radius, capped }
    Torus { center, axis, major, minor }
    Material {
        ambient, diffuse, texture, highlight, exponent, mirror, transmitted, index, interface, clarity, priority,
        two_sided
    }
    Light { source, color, shadows }
    Falloff { constant, linear, quadratic }
    View { from, at, up, projection }
}

/// Structs of one number.
macro_rules! newtypes {
    ($($Struct:ident)*) => {$(
        impl Put for $Struct {
            fn put(&self, w: &mut Writer<'_>) {
                self.0.whole(w);
            }
        }
    )*};
}
newtypes!(ItemId MaterialId TextureId);

impl Put for OctreeNode {
    fn put(&self, w: &mut Writer<'_>) {
        self.words().whole(w);
    }
}

impl Put for Node {
    fn put(&self, w: &mut Writer<'_>) {
        self.words().whole(w);
    }
}

impl Put for Slot {
    fn put(&self, w: &mut Writer<'_>) {
        self.word().whole(w);
    }
}

impl Put for Interface {
    fn put(&self, w: &mut Writer<'_>) {
        (*self as u8).put(w);
    }
}

/// The number of a variant, and its fields.
macro_rules! variant {
    ($w:ident, $number:literal $(, $field:ident)*) => {{
        let number: u32 = $number;
        number.whole($w);
        $($field.whole($w);)*
    }};
}

impl Put for Shape {
    fn put(&self, w: &mut Writer<'_>) {
        match self {
            Shape::Sphere(sphere) => variant!(w, 0, sphere),
            Shape::Triangle(corners) => variant!(w, 1, corners),
            Shape::SmoothTriangle(corners) => variant!(w, 2, corners),
            Shape::Plane(place) => variant!(w, 3, place),
            Shape::Disc(place) => variant!(w, 4, place),
            Shape::Polygon(place) => variant!(w, 5, place),
            Shape::Cuboid(place) => variant!(w, 6, place),
            Shape::TurnedCuboid(place) => variant!(w, 7, place),
            Shape::Cone(place) => variant!(w, 8, place),
            Shape::Torus(place) => variant!(w, 9, place),
        }
    }
}

impl Put for Texture {
    fn put(&self, w: &mut Writer<'_>) {
        match self {
            Texture::Checker { even, odd, origin, frequency } => variant!(w, 0, even, odd, origin, frequency),
            Texture::Gradient { from, to, origin, along } => variant!(w, 1, from, to, origin, along),
        }
    }
}

impl Put for Background {
    fn put(&self, w: &mut Writer<'_>) {
        match self {
            Background::Color(color) => variant!(w, 0, color),
            Background::Gradient { up, below, above } => variant!(w, 1, up, below, above),
        }
    }
}

impl Put for Projection {
    fn put(&self, w: &mut Writer<'_>) {
        match self {
            Projection::Perspective { angle } => variant!(w, 0, angle),
            Projection::Orthographic { height } => variant!(w, 1, height),
        }
    }
}

impl Put for Source {
    fn put(&self, w: &mut Writer<'_>) {
        match self {
            Source::Point { position, falloff } => variant!(w, 0, position, falloff),
            Source::Directional { toward } => variant!(w, 1, toward),
            Source::Spot { position, direction, cos_bright, cos_dark, falloff } => {
                variant!(w, 2, position, direction, cos_bright, cos_dark, falloff)
            }
        }
    }
}
