//! Objects.

use super::surface::Surface;
use crate::native::table::tables;
use crate::native::value::{Direction, Directions, Length, Point, Points, Scale, Size, Sizes, Spanned, Turn};

tables! {
    /// A sphere.
    struct Sphere {
        /// The middle. Default: [0, 0, 0].
        center: Option<Point>,
        /// From the middle to the surface.
        radius: Length,
        /// What it is made of: a name, or a table. Default: matte and white.
        material: Option<Surface>,
        /// How far it moves in a time of one; it is in its place at the time 0. Default: it stands.
        velocity: Option<Spanned<Point>>,
    }

    /// A plane without end.
    struct Plane {
        /// A point on it. Default: [0, 0, 0].
        point: Option<Point>,
        /// Upright on it. Default: [0, 1, 0].
        normal: Option<Direction>,
        /// What it is made of: a name, or a table. Default: matte and white.
        material: Option<Surface>,
        /// How far it moves in a time of one; it is in its place at the time 0. Default: it stands.
        velocity: Option<Spanned<Point>>,
    }

    /// A flat round disc.
    struct Disc {
        /// The middle. Default: [0, 0, 0].
        center: Option<Point>,
        /// Upright on it. Default: [0, 1, 0].
        normal: Option<Direction>,
        /// From the middle to the rim.
        radius: Length,
        /// What it is made of: a name, or a table. Default: matte and white.
        material: Option<Surface>,
        /// How far it moves in a time of one; it is in its place at the time 0. Default: it stands.
        velocity: Option<Spanned<Point>>,
    }

    /// A triangle.
    struct Triangle {
        /// Three places.
        corners: Spanned<Points>,
        /// Three directions: what counts as upright in the corners, for a look that is round.
        normals: Option<Spanned<Directions>>,
        /// What it is made of: a name, or a table. Default: matte and white.
        material: Option<Surface>,
        /// How far it moves in a time of one; it is in its place at the time 0. Default: it stands.
        velocity: Option<Spanned<Point>>,
    }

    /// A flat polygon, which may have bays.
    struct Polygon {
        /// Three places or more, in the order of the rim.
        corners: Spanned<Points>,
        /// As many directions: what counts as upright in the corners, for a look that is round.
        normals: Option<Spanned<Directions>>,
        /// What it is made of: a name, or a table. Default: matte and white.
        material: Option<Surface>,
        /// How far it moves in a time of one; it is in its place at the time 0. Default: it stands.
        velocity: Option<Spanned<Point>>,
    }

    /// A box: `min` and `max`, or `size` and perhaps `center`.
    struct Box {
        /// The corner with the smallest coordinates.
        min: Option<Spanned<Point>>,
        /// The corner with the largest coordinates.
        max: Option<Spanned<Point>>,
        /// The middle. Default: [0, 0, 0].
        center: Option<Spanned<Point>>,
        /// Its length along each axis, or one number for a cube.
        size: Option<Spanned<Sizes>>,
        /// Degrees by which it is turned in its middle, about the x axis, then y, then z.
        rotate: Option<Turn>,
        /// What it is made of: a name, or a table. Default: matte and white.
        material: Option<Surface>,
        /// How far it moves in a time of one; it is in its place at the time 0. Default: it stands.
        velocity: Option<Spanned<Point>>,
    }

    /// A cylinder.
    struct Cylinder {
        /// The middle of one end. Default: [0, 0, 0].
        base: Option<Point>,
        /// The middle of the other end.
        end: Spanned<Point>,
        /// The radius.
        radius: Length,
        /// Whether it is a tube without discs at its ends. Default: false.
        open: Option<bool>,
        /// What it is made of: a name, or a table. Default: matte and white.
        material: Option<Surface>,
        /// How far it moves in a time of one; it is in its place at the time 0. Default: it stands.
        velocity: Option<Spanned<Point>>,
    }

    /// A cone, pointed or cut off.
    struct Cone {
        /// The middle of one end. Default: [0, 0, 0].
        base: Option<Point>,
        /// The point, or the middle of the other end.
        end: Spanned<Point>,
        /// The radius at the base.
        radius: Spanned<Size>,
        /// The radius at the other end. Default: 0, a point.
        end_radius: Option<Size>,
        /// Whether it has no discs at its ends. Default: false.
        open: Option<bool>,
        /// What it is made of: a name, or a table. Default: matte and white.
        material: Option<Surface>,
        /// How far it moves in a time of one; it is in its place at the time 0. Default: it stands.
        velocity: Option<Spanned<Point>>,
    }

    /// A tube round a circle.
    struct Torus {
        /// The middle of the hole. Default: [0, 0, 0].
        center: Option<Point>,
        /// Upright on the circle. Default: [0, 1, 0].
        axis: Option<Direction>,
        /// The radius of the circle, in the middle of the tube.
        radius: Length,
        /// The radius of the tube, at most `radius`.
        tube: Spanned<Length>,
        /// What it is made of: a name, or a table. Default: matte and white.
        material: Option<Surface>,
        /// How far it moves in a time of one; it is in its place at the time 0. Default: it stands.
        velocity: Option<Spanned<Point>>,
    }

    /// Triangles from a file. They are scaled, then turned, then moved.
    struct Mesh {
        /// The file, beside the scene: .obj, .ply, .gltf or .glb.
        file: Spanned<String>,
        /// What it is made of, whatever the file says: a name, or a table. Default: what the
        /// file says, else matte and white.
        material: Option<Surface>,
        /// What it is multiplied with, one number or one for each axis. Default: 1.
        scale: Option<Scale>,
        /// Degrees by which it is turned in the origin, about the x axis, then y, then z.
        rotate: Option<Turn>,
        /// How far it is moved. Default: [0, 0, 0].
        translate: Option<Point>,
        /// How far it moves in a time of one; it is in its place at the time 0. Default: it stands.
        velocity: Option<Spanned<Point>>,
    }
}
