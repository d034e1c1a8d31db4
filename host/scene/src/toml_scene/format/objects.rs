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
        /// Center. Default: [0, 0, 0].
        center: Option<PointValue>,
        /// Radius.
        radius: PositiveLength,
        /// Material: a name or an inline table. Default: white, diffuse.
        material: Option<MaterialRef>,
        /// Displacement per unit of time; the object is at its given position at time 0. Default: 0.
        velocity: Option<Spanned<PointValue>>,
    }

    /// An infinite plane.
    struct PlaneTable as "Plane" {
        /// Point of the plane. Default: [0, 0, 0].
        point: Option<PointValue>,
        /// Normal. Default: [0, 1, 0].
        normal: Option<DirectionValue>,
        /// Material: a name or an inline table. Default: white, diffuse.
        material: Option<MaterialRef>,
        /// Displacement per unit of time; the object is at its given position at time 0. Default: 0.
        velocity: Option<Spanned<PointValue>>,
    }

    /// A disc.
    struct DiscTable as "Disc" {
        /// Center. Default: [0, 0, 0].
        center: Option<PointValue>,
        /// Normal. Default: [0, 1, 0].
        normal: Option<DirectionValue>,
        /// Radius.
        radius: PositiveLength,
        /// Material: a name or an inline table. Default: white, diffuse.
        material: Option<MaterialRef>,
        /// Displacement per unit of time; the object is at its given position at time 0. Default: 0.
        velocity: Option<Spanned<PointValue>>,
    }

    /// A triangle.
    struct TriangleTable as "Triangle" {
        /// Three vertices.
        corners: Spanned<PointList>,
        /// Three vertex normals, for smooth shading.
        normals: Option<Spanned<DirectionList>>,
        /// Material: a name or an inline table. Default: white, diffuse.
        material: Option<MaterialRef>,
        /// Displacement per unit of time; the object is at its given position at time 0. Default: 0.
        velocity: Option<Spanned<PointValue>>,
    }

    /// A planar polygon, convex or concave.
    struct PolygonTable as "Polygon" {
        /// Three or more vertices, in order.
        corners: Spanned<PointList>,
        /// Vertex normals, as many as corners, for smooth shading.
        normals: Option<Spanned<DirectionList>>,
        /// Material: a name or an inline table. Default: white, diffuse.
        material: Option<MaterialRef>,
        /// Displacement per unit of time; the object is at its given position at time 0. Default: 0.
        velocity: Option<Spanned<PointValue>>,
    }

    /// A box: `min` and `max`, or `size` and optionally `center`.
    struct BoxTable as "Box" {
        /// Corner with the smallest coordinates.
        min: Option<Spanned<PointValue>>,
        /// Corner with the largest coordinates.
        max: Option<Spanned<PointValue>>,
        /// Center. Default: [0, 0, 0].
        center: Option<Spanned<PointValue>>,
        /// Size along each axis, or one number for a cube.
        size: Option<Spanned<BoxSize>>,
        /// Rotation around its center in degrees, about x, then y, then z. Default: [0, 0, 0].
        rotate: Option<EulerAngles>,
        /// Material: a name or an inline table. Default: white, diffuse.
        material: Option<MaterialRef>,
        /// Displacement per unit of time; the object is at its given position at time 0. Default: 0.
        velocity: Option<Spanned<PointValue>>,
    }

    /// A cylinder.
    struct CylinderTable as "Cylinder" {
        /// Center of one end. Default: [0, 0, 0].
        base: Option<PointValue>,
        /// Center of the other end.
        end: Spanned<PointValue>,
        /// Radius.
        radius: PositiveLength,
        /// Whether the ends are open. Default: false.
        open: Option<bool>,
        /// Material: a name or an inline table. Default: white, diffuse.
        material: Option<MaterialRef>,
        /// Displacement per unit of time; the object is at its given position at time 0. Default: 0.
        velocity: Option<Spanned<PointValue>>,
    }

    /// A cone or truncated cone.
    struct ConeTable as "Cone" {
        /// Center of one end. Default: [0, 0, 0].
        base: Option<PointValue>,
        /// Apex, or center of the other end.
        end: Spanned<PointValue>,
        /// Radius at the base.
        radius: Spanned<NonNegativeLength>,
        /// Radius at the other end. Default: 0 (apex).
        end_radius: Option<NonNegativeLength>,
        /// Whether the ends are open. Default: false.
        open: Option<bool>,
        /// Material: a name or an inline table. Default: white, diffuse.
        material: Option<MaterialRef>,
        /// Displacement per unit of time; the object is at its given position at time 0. Default: 0.
        velocity: Option<Spanned<PointValue>>,
    }

    /// A torus.
    struct TorusTable as "Torus" {
        /// Center. Default: [0, 0, 0].
        center: Option<PointValue>,
        /// Axis. Default: [0, 1, 0].
        axis: Option<DirectionValue>,
        /// Major radius.
        radius: PositiveLength,
        /// Minor radius, at most `radius`.
        tube: Spanned<PositiveLength>,
        /// Material: a name or an inline table. Default: white, diffuse.
        material: Option<MaterialRef>,
        /// Displacement per unit of time; the object is at its given position at time 0. Default: 0.
        velocity: Option<Spanned<PointValue>>,
    }

    /// A triangle mesh from a file. Transform order: scale, rotate, translate.
    struct MeshTable as "Mesh" {
        /// File, relative to the scene: .obj, .ply, .gltf or .glb.
        file: Spanned<String>,
        /// Material, instead of those of the file: a name or an inline table. Default: those of the file, else white,
        /// diffuse.
        material: Option<MaterialRef>,
        /// Scale factor, one number or one per axis. Default: 1.
        scale: Option<ScaleFactors>,
        /// Rotation around the origin in degrees, about x, then y, then z. Default: [0, 0, 0].
        rotate: Option<EulerAngles>,
        /// Translation. Default: [0, 0, 0].
        translate | translation: Option<PointValue>,
        /// Displacement per unit of time; the object is at its given position at time 0. Default: 0.
        velocity: Option<Spanned<PointValue>>,
    }
}
