//! Objects.

use super::material_ref::MaterialRef;
use crate::toml_scene::table::tables;
use crate::toml_scene::value::{
    BoxSize, DirectionList, DirectionValue, EulerAngles, NonNegativeLength, PointList, PointValue,
    PositiveLength, ScaleFactors, Spanned,
};

tables! {
    /// A sphere.
    struct SphereTable as "Sphere" {
        /// The middle. Default: [0, 0, 0].
        center: Option<PointValue>,
        /// From the middle to the surface.
        radius: PositiveLength,
        /// What it is made of: a name, or a table. Default: matte and white.
        material: Option<MaterialRef>,
        /// How far it moves in a time of one; it is in its place at the time 0. Default: it stands.
        velocity: Option<Spanned<PointValue>>,
    }

    /// A plane without end.
    struct PlaneTable as "Plane" {
        /// A point on it. Default: [0, 0, 0].
        point: Option<PointValue>,
        /// Upright on it. Default: [0, 1, 0].
        normal: Option<DirectionValue>,
        /// What it is made of: a name, or a table. Default: matte and white.
        material: Option<MaterialRef>,
        /// How far it moves in a time of one; it is in its place at the time 0. Default: it stands.
        velocity: Option<Spanned<PointValue>>,
    }

    /// A flat round disc.
    struct DiscTable as "Disc" {
        /// The middle. Default: [0, 0, 0].
        center: Option<PointValue>,
        /// Upright on it. Default: [0, 1, 0].
        normal: Option<DirectionValue>,
        /// From the middle to the rim.
        radius: PositiveLength,
        /// What it is made of: a name, or a table. Default: matte and white.
        material: Option<MaterialRef>,
        /// How far it moves in a time of one; it is in its place at the time 0. Default: it stands.
        velocity: Option<Spanned<PointValue>>,
    }

    /// A triangle.
    struct TriangleTable as "Triangle" {
        /// Three places.
        corners: Spanned<PointList>,
        /// Three directions: what counts as upright in the corners, for a look that is round.
        normals: Option<Spanned<DirectionList>>,
        /// What it is made of: a name, or a table. Default: matte and white.
        material: Option<MaterialRef>,
        /// How far it moves in a time of one; it is in its place at the time 0. Default: it stands.
        velocity: Option<Spanned<PointValue>>,
    }

    /// A flat polygon, which may have bays.
    struct PolygonTable as "Polygon" {
        /// Three places or more, in the order of the rim.
        corners: Spanned<PointList>,
        /// As many directions: what counts as upright in the corners, for a look that is round.
        normals: Option<Spanned<DirectionList>>,
        /// What it is made of: a name, or a table. Default: matte and white.
        material: Option<MaterialRef>,
        /// How far it moves in a time of one; it is in its place at the time 0. Default: it stands.
        velocity: Option<Spanned<PointValue>>,
    }

    /// A box: `min` and `max`, or `size` and perhaps `center`.
    struct BoxTable as "Box" {
        /// The corner with the smallest coordinates.
        min: Option<Spanned<PointValue>>,
        /// The corner with the largest coordinates.
        max: Option<Spanned<PointValue>>,
        /// The middle. Default: [0, 0, 0].
        center: Option<Spanned<PointValue>>,
        /// Its length along each axis, or one number for a cube.
        size: Option<Spanned<BoxSize>>,
        /// Degrees by which it is turned in its middle, about the x axis, then y, then z.
        rotate: Option<EulerAngles>,
        /// What it is made of: a name, or a table. Default: matte and white.
        material: Option<MaterialRef>,
        /// How far it moves in a time of one; it is in its place at the time 0. Default: it stands.
        velocity: Option<Spanned<PointValue>>,
    }

    /// A cylinder.
    struct CylinderTable as "Cylinder" {
        /// The middle of one end. Default: [0, 0, 0].
        base: Option<PointValue>,
        /// The middle of the other end.
        end: Spanned<PointValue>,
        /// The radius.
        radius: PositiveLength,
        /// Whether it is a tube without discs at its ends. Default: false.
        open: Option<bool>,
        /// What it is made of: a name, or a table. Default: matte and white.
        material: Option<MaterialRef>,
        /// How far it moves in a time of one; it is in its place at the time 0. Default: it stands.
        velocity: Option<Spanned<PointValue>>,
    }

    /// A cone, pointed or cut off.
    struct ConeTable as "Cone" {
        /// The middle of one end. Default: [0, 0, 0].
        base: Option<PointValue>,
        /// The point, or the middle of the other end.
        end: Spanned<PointValue>,
        /// The radius at the base.
        radius: Spanned<NonNegativeLength>,
        /// The radius at the other end. Default: 0, a point.
        end_radius: Option<NonNegativeLength>,
        /// Whether it has no discs at its ends. Default: false.
        open: Option<bool>,
        /// What it is made of: a name, or a table. Default: matte and white.
        material: Option<MaterialRef>,
        /// How far it moves in a time of one; it is in its place at the time 0. Default: it stands.
        velocity: Option<Spanned<PointValue>>,
    }

    /// A tube round a circle.
    struct TorusTable as "Torus" {
        /// The middle of the hole. Default: [0, 0, 0].
        center: Option<PointValue>,
        /// Upright on the circle. Default: [0, 1, 0].
        axis: Option<DirectionValue>,
        /// The radius of the circle, in the middle of the tube.
        radius: PositiveLength,
        /// The radius of the tube, at most `radius`.
        tube: Spanned<PositiveLength>,
        /// What it is made of: a name, or a table. Default: matte and white.
        material: Option<MaterialRef>,
        /// How far it moves in a time of one; it is in its place at the time 0. Default: it stands.
        velocity: Option<Spanned<PointValue>>,
    }

    /// Triangles from a file. They are scaled, then turned, then moved.
    struct MeshTable as "Mesh" {
        /// The file, beside the scene: .obj, .ply, .gltf or .glb.
        file: Spanned<String>,
        /// What it is made of, whatever the file says: a name, or a table. Default: what the
        /// file says, else matte and white.
        material: Option<MaterialRef>,
        /// What it is multiplied with, one number or one for each axis. Default: 1.
        scale: Option<ScaleFactors>,
        /// Degrees by which it is turned in the origin, about the x axis, then y, then z.
        rotate: Option<EulerAngles>,
        /// How far it is moved. Default: [0, 0, 0].
        translate: Option<PointValue>,
        /// How far it moves in a time of one; it is in its place at the time 0. Default: it stands.
        velocity: Option<Spanned<PointValue>>,
    }
}
