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
        /// Camera. By default it shows all bounded objects.
        camera: SingleTable<CameraTable>,
        /// Render settings; the command line takes precedence.
        render: SingleTable<RenderTable>,
        /// Background. Default: black.
        background: SingleTable<BackgroundTable>,
        /// Ambient light. Default: a gray of 0.1.
        ambient_light: SingleTable<AmbientLightTable>,
        /// Point lights.
        point_light: TableArray<PointLightTable>,
        /// Directional lights, such as the sun.
        directional_light: TableArray<DirectionalLightTable>,
        /// Spot lights.
        spot_light: TableArray<SpotLightTable>,
        /// Spherical area lights, with soft shadows.
        sphere_light: TableArray<SphereLightTable>,
        /// Rectangular area lights, such as windows.
        rectangle_light: TableArray<RectangleLightTable>,
        /// Named materials.
        material: TableArray<MaterialTable>,
        /// Spheres.
        sphere: TableArray<SphereTable>,
        /// Infinite planes.
        plane: TableArray<PlaneTable>,
        /// Discs.
        disc: TableArray<DiscTable>,
        /// Triangles.
        triangle: TableArray<TriangleTable>,
        /// Planar polygons, convex or concave.
        polygon: TableArray<PolygonTable>,
        /// Boxes.
        r#box: TableArray<BoxTable>,
        /// Cylinders.
        cylinder: TableArray<CylinderTable>,
        /// Cones and truncated cones.
        cone: TableArray<ConeTable>,
        /// Tori.
        torus: TableArray<TorusTable>,
        /// Triangle meshes from files: .obj, .ply, .gltf or .glb.
        mesh: TableArray<MeshTable>,
    }

    /// Camera.
    struct CameraTable as "Camera" {
        /// Eye position. Default: in front of and slightly above `at`, far enough to see all bounded objects.
        from | position | eye: Option<Spanned<PointValue>>,
        /// Point at the picture's center. Default: the center of all bounded objects.
        at | look_at: Option<Spanned<PointValue>>,
        /// Up direction. Default: [0, 1, 0].
        up: Option<Spanned<DirectionValue>>,
        /// Vertical field of view, full angle in degrees, from the center of the first pixel row to that of the last.
        /// Default: 45.
        angle | fov: Option<Spanned<ViewAngle>>,
        /// Makes the camera orthographic: visible height in scene lengths.
        height: Option<Spanned<PositiveLength>>,
        /// Lens radius, for depth of field. Default: none (pinhole).
        lens_radius: Option<Spanned<PositiveLength>>,
        /// Focus distance from the lens. Default: the distance to `at`.
        focus | focus_distance | focal_distance: Option<Spanned<PositiveLength>>,
        /// Shutter open and close time, for objects with a `velocity`; a single number is the closing time, with opening
        /// at 0. Default: [0, 1].
        shutter: Option<Spanned<ShutterInterval>>,
    }

    /// Background: one color, or a vertical gradient.
    struct BackgroundTable as "Background" {
        /// Color of the whole background.
        color: Option<Spanned<ColorValue>>,
        /// Color straight down.
        below: Option<Spanned<ColorValue>>,
        /// Color straight up.
        above: Option<Spanned<ColorValue>>,
        /// Up direction of the gradient. Default: the camera's.
        up: Option<Spanned<DirectionValue>>,
    }
}
