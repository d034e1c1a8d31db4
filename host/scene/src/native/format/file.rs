//! The file as a whole, its camera and its background.

use super::lights::{AmbientLight, DirectionalLight, PointLight, RectangleLight, SphereLight, SpotLight};
use super::material::Material;
use super::objects::{Box, Cone, Cylinder, Disc, Mesh, Plane, Polygon, Sphere, Torus, Triangle};
use super::render::Render;
use crate::native::table::{Many, One, tables};
use crate::native::value::{Color, Direction, Length, Point, Shutter, Spanned, ViewAngle};

tables! {
    /// A scene for strahl.
    #[derive(Default)]
    #[schemars(default)]
    struct File {
        /// How the scene is looked at. By default so that everything with an end is seen.
        camera: One<Camera>,
        /// What picture is wanted; the command line wins.
        render: One<Render>,
        /// What is behind everything. By default black.
        background: One<Background>,
        /// Light from everywhere. By default a gray of 0.1.
        ambient_light: One<AmbientLight>,
        /// Lights that shine from one place in all directions.
        point_light: Many<PointLight>,
        /// Lights that are infinitely far away, as the sun.
        directional_light: Many<DirectionalLight>,
        /// Lights that shine from one place into a cone.
        spot_light: Many<SpotLight>,
        /// Lights that are spheres, whose shadows have soft rims.
        sphere_light: Many<SphereLight>,
        /// Lights that are rectangles, as windows and lamps in ceilings.
        rectangle_light: Many<RectangleLight>,
        /// Materials with names.
        material: Many<Material>,
        /// Spheres.
        sphere: Many<Sphere>,
        /// Planes without end.
        plane: Many<Plane>,
        /// Flat round discs.
        disc: Many<Disc>,
        /// Triangles.
        triangle: Many<Triangle>,
        /// Flat polygons of three corners or more.
        polygon: Many<Polygon>,
        /// Boxes.
        r#box: Many<Box>,
        /// Cylinders.
        cylinder: Many<Cylinder>,
        /// Cones, pointed or cut off.
        cone: Many<Cone>,
        /// Tori: tubes round circles.
        torus: Many<Torus>,
        /// Triangles from a file: .obj, .ply, .gltf or .glb.
        mesh: Many<Mesh>,
    }

    /// How the scene is looked at.
    struct Camera {
        /// The eye. Default: so far in front of `at`, and a little above, that everything is seen.
        from: Option<Spanned<Point>>,
        /// What is in the middle of the picture. Default: the middle of everything that has an end.
        at: Option<Spanned<Point>>,
        /// What is up. Default: [0, 1, 0].
        up: Option<Spanned<Direction>>,
        /// The full vertical angle of view, in degrees. Default: 45.
        angle: Option<Spanned<ViewAngle>>,
        /// Makes all rays run in one direction; how much is seen, in scene lengths.
        height: Option<Spanned<Length>>,
        /// The radius of a lens, which makes everything blurred that is not in focus. Default:
        /// none, everything is sharp.
        lens_radius: Option<Spanned<Length>>,
        /// How far away from the lens everything is sharp. Default: as far as `at`.
        focus: Option<Spanned<Length>>,
        /// When its shutter opens and closes, for things with a velocity; one number is how long it
        /// is open from the time 0 on. Default: [0, 1].
        shutter: Option<Spanned<Shutter>>,
    }

    /// What is behind everything: one colour, or two that pass into each other.
    struct Background {
        /// The colour.
        color: Option<Spanned<Color>>,
        /// The colour straight down.
        below: Option<Spanned<Color>>,
        /// The colour straight up.
        above: Option<Spanned<Color>>,
        /// What is up for `below` and `above`. Default: the camera's.
        up: Option<Spanned<Direction>>,
    }
}
