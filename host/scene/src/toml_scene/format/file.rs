//! The file as a whole, its camera and its background.

use super::lights::{
    AmbientLightTable, DirectionalLightTable, PointLightTable, RectangleLightTable, SphereLightTable,
    SpotLightTable,
};
use super::material::MaterialTable;
use super::objects::{
    BoxTable, ConeTable, CylinderTable, DiscTable, MeshTable, PlaneTable, PolygonTable, SphereTable,
    TorusTable, TriangleTable,
};
use super::render::RenderTable;
use crate::toml_scene::table::{SingleTable, TableArray, tables};
use crate::toml_scene::value::{
    ColorValue, DirectionValue, PointValue, PositiveLength, ShutterInterval, Spanned, ViewAngle,
};

tables! {
    /// A scene for strahl.
    #[derive(Default)]
    #[schemars(default)]
    struct SceneFile as "File" {
        /// How the scene is looked at. By default so that everything with an end is seen.
        camera: SingleTable<CameraTable>,
        /// What picture is wanted; the command line wins.
        render: SingleTable<RenderTable>,
        /// What is behind everything. By default black.
        background: SingleTable<BackgroundTable>,
        /// Light from everywhere. By default a gray of 0.1.
        ambient_light: SingleTable<AmbientLightTable>,
        /// Lights that shine from one place in all directions.
        point_light: TableArray<PointLightTable>,
        /// Lights that are infinitely far away, as the sun.
        directional_light: TableArray<DirectionalLightTable>,
        /// Lights that shine from one place into a cone.
        spot_light: TableArray<SpotLightTable>,
        /// Lights that are spheres, whose shadows have soft rims.
        sphere_light: TableArray<SphereLightTable>,
        /// Lights that are rectangles, as windows and lamps in ceilings.
        rectangle_light: TableArray<RectangleLightTable>,
        /// Materials with names.
        material: TableArray<MaterialTable>,
        /// Spheres.
        sphere: TableArray<SphereTable>,
        /// Planes without end.
        plane: TableArray<PlaneTable>,
        /// Flat round discs.
        disc: TableArray<DiscTable>,
        /// Triangles.
        triangle: TableArray<TriangleTable>,
        /// Flat polygons of three corners or more.
        polygon: TableArray<PolygonTable>,
        /// Boxes.
        r#box: TableArray<BoxTable>,
        /// Cylinders.
        cylinder: TableArray<CylinderTable>,
        /// Cones, pointed or cut off.
        cone: TableArray<ConeTable>,
        /// Tori: tubes round circles.
        torus: TableArray<TorusTable>,
        /// Triangles from a file: .obj, .ply, .gltf or .glb.
        mesh: TableArray<MeshTable>,
    }

    /// How the scene is looked at.
    struct CameraTable as "Camera" {
        /// The eye. Default: so far in front of `at`, and a little above, that everything is seen.
        from: Option<Spanned<PointValue>>,
        /// What is in the middle of the picture. Default: the middle of everything that has an end.
        at: Option<Spanned<PointValue>>,
        /// What is up. Default: [0, 1, 0].
        up: Option<Spanned<DirectionValue>>,
        /// The full vertical angle of view, in degrees. Default: 45.
        angle: Option<Spanned<ViewAngle>>,
        /// Makes all rays run in one direction; how much is seen, in scene lengths.
        height: Option<Spanned<PositiveLength>>,
        /// The radius of a lens, which makes everything blurred that is not in focus. Default:
        /// none, everything is sharp.
        lens_radius: Option<Spanned<PositiveLength>>,
        /// How far away from the lens everything is sharp. Default: as far as `at`.
        focus: Option<Spanned<PositiveLength>>,
        /// When its shutter opens and closes, for things with a velocity; one number is how long it
        /// is open from the time 0 on. Default: [0, 1].
        shutter: Option<Spanned<ShutterInterval>>,
    }

    /// What is behind everything: one colour, or two that pass into each other.
    struct BackgroundTable as "Background" {
        /// The colour.
        color: Option<Spanned<ColorValue>>,
        /// The colour straight down.
        below: Option<Spanned<ColorValue>>,
        /// The colour straight up.
        above: Option<Spanned<ColorValue>>,
        /// What is up for `below` and `above`. Default: the camera's.
        up: Option<Spanned<DirectionValue>>,
    }
}
