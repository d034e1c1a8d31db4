//! The tables of the format and their keys. `scenes/FORMAT.md` tells the same at length.
//!
//! What is said of a table and of a key here is what an editor shows, by way of the schema.
//! An `Option` has a default, which is told with the key; everything else must be there.

use super::colors::{Clarity, Color, Share};
use super::materials::Surface;
use super::numbers::{
    BrightAngle, ConeAngle, Index, Intensity, Length, Priority, Roughness, Shininess, Size, ViewAngle,
};
use super::places::{Direction, Directions, Falloff, Pair, Point, Points, Scale, Shutter, Sizes, Turn};
use super::render::Render;
use super::table::{At, Many, One, tables};

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
        from: Option<At<Point>>,
        /// What is in the middle of the picture. Default: the middle of everything that has an end.
        at: Option<At<Point>>,
        /// What is up. Default: [0, 1, 0].
        up: Option<At<Direction>>,
        /// The full vertical angle of view, in degrees. Default: 45.
        angle: Option<At<ViewAngle>>,
        /// Makes all rays run in one direction; how much is seen, in scene lengths.
        height: Option<At<Length>>,
        /// The radius of a lens, which makes everything blurred that is not in focus. Default:
        /// none, everything is sharp.
        lens_radius: Option<At<Length>>,
        /// How far away from the lens everything is sharp. Default: as far as `at`.
        focus: Option<At<Length>>,
        /// When its shutter opens and closes, for things with a velocity; one number is how long it
        /// is open from the time 0 on. Default: [0, 1].
        shutter: Option<At<Shutter>>,
    }

    /// What is behind everything: one colour, or two that pass into each other.
    struct Background {
        /// The colour.
        color: Option<At<Color>>,
        /// The colour straight down.
        below: Option<At<Color>>,
        /// The colour straight up.
        above: Option<At<Color>>,
        /// What is up for `below` and `above`. Default: the camera's.
        up: Option<At<Direction>>,
    }

    /// Light from everywhere, for the ambient share of materials.
    struct AmbientLight {
        /// Its colour. Default: a gray of 0.1.
        color: Option<At<Color>>,
        /// What the colour is multiplied with. Default: 1.
        intensity: Option<At<Intensity>>,
    }

    /// A light that shines from one place in all directions.
    struct PointLight {
        /// What reports call it.
        name: Option<String>,
        /// The place.
        position: Point,
        /// Its colour. Default: white.
        color: Option<At<Color>>,
        /// What the colour is multiplied with. Default: 1.
        intensity: Option<At<Intensity>>,
        /// How it fades with the distance: "none", "linear", "square", or constant, linear and
        /// quadratic part of what it is divided by. Default: "none".
        falloff: Option<Falloff>,
        /// Whether things stand in its way. Default: true.
        shadows: Option<bool>,
    }

    /// A light that is infinitely far away, as the sun.
    struct DirectionalLight {
        /// What reports call it.
        name: Option<String>,
        /// Where its light goes: down is [0, -1, 0].
        direction: Direction,
        /// Its colour. Default: white.
        color: Option<At<Color>>,
        /// What the colour is multiplied with. Default: 1.
        intensity: Option<At<Intensity>>,
        /// Whether things stand in its way. Default: true.
        shadows: Option<bool>,
    }

    /// A light that shines from one place into a cone. It needs `at` or `direction`.
    struct SpotLight {
        /// What reports call it.
        name: Option<String>,
        /// The place.
        position: Point,
        /// What is in the middle of its cone.
        at: Option<At<Point>>,
        /// The middle of its cone, as a direction.
        direction: Option<At<Direction>>,
        /// The full angle of its cone, in degrees. Default: 40.
        angle: Option<ConeAngle>,
        /// The full angle within which it is fully bright, in degrees, at most `angle`.
        /// Default: 4/5 of `angle`.
        bright_angle: Option<At<BrightAngle>>,
        /// Its colour. Default: white.
        color: Option<At<Color>>,
        /// What the colour is multiplied with. Default: 1.
        intensity: Option<At<Intensity>>,
        /// How it fades with the distance: "none", "linear", "square", or constant, linear and
        /// quadratic part of what it is divided by. Default: "none".
        falloff: Option<Falloff>,
        /// Whether things stand in its way. Default: true.
        shadows: Option<bool>,
    }

    /// A light that is a sphere: as bright as one in its middle, with soft shadows. It is not seen.
    struct SphereLight {
        /// What reports call it.
        name: Option<String>,
        /// Its middle.
        position: Point,
        /// Its radius; 0 makes it a point.
        radius: Size,
        /// Its colour. Default: white.
        color: Option<At<Color>>,
        /// What the colour is multiplied with. Default: 1.
        intensity: Option<At<Intensity>>,
        /// How it fades with the distance: "none", "linear", "square", or constant, linear and
        /// quadratic part of what it is divided by. Default: "none".
        falloff: Option<Falloff>,
        /// Whether things stand in its way. Default: true.
        shadows: Option<bool>,
    }

    /// A light that is a rectangle and shines to its front, less to the side. It needs `at` or
    /// `direction`. It is not seen.
    struct RectangleLight {
        /// What reports call it.
        name: Option<String>,
        /// Its middle.
        position: Point,
        /// What is in front of its middle.
        at: Option<At<Point>>,
        /// Where its front looks to.
        direction: Option<At<Direction>>,
        /// What is up for its height. Default: [0, 1, 0], or [0, 0, 1] if it looks up or down.
        up: Option<At<Direction>>,
        /// Its width and its height.
        size: Pair,
        /// Its colour. Default: white.
        color: Option<At<Color>>,
        /// What the colour is multiplied with. Default: 1.
        intensity: Option<At<Intensity>>,
        /// How it fades with the distance: "none", "linear", "square", or constant, linear and
        /// quadratic part of what it is divided by. Default: "none".
        falloff: Option<Falloff>,
        /// Whether things stand in its way. Default: true.
        shadows: Option<bool>,
    }

    /// What something is made of: matte and white, but for what is said here.
    struct Material {
        /// What objects call it. A material that stands in an object has none.
        name: Option<At<String>>,
        /// What is scattered, by colour. Default: white.
        color: Option<Color>,
        /// A pattern of two colours, which `color` is multiplied with.
        checker: Option<At<Checker>>,
        /// From one colour to another, which `color` is multiplied with.
        gradient: Option<At<Gradient>>,
        /// Rings that become finer without end, which `color` is multiplied with.
        zone_plate: Option<At<ZonePlate>>,
        /// How much of `color` a light lets shine. Default: what `mirror` and `transmission`
        /// leave of 1.
        diffuse: Option<Color>,
        /// How much of `color` the ambient light lets shine. Default: as `diffuse`.
        ambient: Option<Color>,
        /// How bright highlights are. Default: 0.5 if there is `shininess`, else 0.
        highlight: Option<Color>,
        /// How narrow highlights are, 0 to 1000000. Default: 50 if there is a `highlight`.
        shininess: Option<Shininess>,
        /// The share of light from the mirrored direction. Default: 0.
        mirror: Option<Share>,
        /// The share of light from behind; more than 0 makes a body, as of glass. Default: 0.
        transmission: Option<Share>,
        /// How rough its mirror and its body are: 0 is polished, 1 is dull. Default: 0.
        roughness: Option<At<Roughness>>,
        /// The index of refraction of the body. Default: 1.5, as glass.
        index: Option<At<Index>>,
        /// Whether the angle decides how much of `transmission` is mirrored instead. Default:
        /// false.
        fresnel: Option<At<bool>>,
        /// How far light travels in the body until 1/e of it is left, in scene lengths: one
        /// number or one for each of red, green and blue. Default: inf, which is clear.
        clarity: Option<At<Clarity>>,
        /// Which body fills the space where several overlap: the highest. Default: 0.
        priority: Option<At<Priority>>,
        /// Whether a surface that is seen from behind is shaded as its front. Default: false.
        one_sided: Option<bool>,
    }

    /// Two colours in turn, in cells upright on the axes.
    struct Checker {
        /// The colour of the cell that begins in `origin`. Default: white.
        even: Option<Color>,
        /// The colour of its neighbours. Default: 0.1.
        odd: Option<Color>,
        /// A corner of cells. Default: [0, 0, 0].
        origin: Option<Point>,
        /// The size of a cell, one number or one for each axis; 0 is a cell without end.
        /// Default: [1, 0, 1], for floors.
        size: Option<At<Sizes>>,
    }

    /// From one colour to another, and constant beyond both.
    struct Gradient {
        /// The colour at `start`. Default: black.
        from: Option<Color>,
        /// The colour at `end`. Default: white.
        to: Option<Color>,
        /// Where it begins.
        start: Point,
        /// Where it ends.
        end: At<Point>,
    }

    /// Spheres round a point, from one colour to another and back, the finer the farther.
    struct ZonePlate {
        /// The colour in the middle. Default: white.
        from: Option<Color>,
        /// The other colour. Default: black.
        to: Option<Color>,
        /// The middle. Default: [0, 0, 0].
        origin: Option<Point>,
        /// How often the first colour returns up to a distance of one.
        frequency: Size,
    }

    /// A sphere.
    struct Sphere {
        /// The middle. Default: [0, 0, 0].
        center: Option<Point>,
        /// From the middle to the surface.
        radius: Length,
        /// What it is made of: a name, or a table. Default: matte and white.
        material: Option<Surface>,
        /// How far it moves in a time of one; it is in its place at the time 0. Default: it stands.
        velocity: Option<At<Point>>,
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
        velocity: Option<At<Point>>,
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
        velocity: Option<At<Point>>,
    }

    /// A triangle.
    struct Triangle {
        /// Three places.
        corners: At<Points>,
        /// Three directions: what counts as upright in the corners, for a look that is round.
        normals: Option<At<Directions>>,
        /// What it is made of: a name, or a table. Default: matte and white.
        material: Option<Surface>,
        /// How far it moves in a time of one; it is in its place at the time 0. Default: it stands.
        velocity: Option<At<Point>>,
    }

    /// A flat polygon, which may have bays.
    struct Polygon {
        /// Three places or more, in the order of the rim.
        corners: At<Points>,
        /// As many directions: what counts as upright in the corners, for a look that is round.
        normals: Option<At<Directions>>,
        /// What it is made of: a name, or a table. Default: matte and white.
        material: Option<Surface>,
        /// How far it moves in a time of one; it is in its place at the time 0. Default: it stands.
        velocity: Option<At<Point>>,
    }

    /// A box: `min` and `max`, or `size` and perhaps `center`.
    struct Box {
        /// The corner with the smallest coordinates.
        min: Option<At<Point>>,
        /// The corner with the largest coordinates.
        max: Option<At<Point>>,
        /// The middle. Default: [0, 0, 0].
        center: Option<At<Point>>,
        /// Its length along each axis, or one number for a cube.
        size: Option<At<Sizes>>,
        /// Degrees by which it is turned in its middle, about the x axis, then y, then z.
        rotate: Option<Turn>,
        /// What it is made of: a name, or a table. Default: matte and white.
        material: Option<Surface>,
        /// How far it moves in a time of one; it is in its place at the time 0. Default: it stands.
        velocity: Option<At<Point>>,
    }

    /// A cylinder.
    struct Cylinder {
        /// The middle of one end. Default: [0, 0, 0].
        base: Option<Point>,
        /// The middle of the other end.
        end: At<Point>,
        /// The radius.
        radius: Length,
        /// Whether it is a tube without discs at its ends. Default: false.
        open: Option<bool>,
        /// What it is made of: a name, or a table. Default: matte and white.
        material: Option<Surface>,
        /// How far it moves in a time of one; it is in its place at the time 0. Default: it stands.
        velocity: Option<At<Point>>,
    }

    /// A cone, pointed or cut off.
    struct Cone {
        /// The middle of one end. Default: [0, 0, 0].
        base: Option<Point>,
        /// The point, or the middle of the other end.
        end: At<Point>,
        /// The radius at the base.
        radius: At<Size>,
        /// The radius at the other end. Default: 0, a point.
        end_radius: Option<Size>,
        /// Whether it has no discs at its ends. Default: false.
        open: Option<bool>,
        /// What it is made of: a name, or a table. Default: matte and white.
        material: Option<Surface>,
        /// How far it moves in a time of one; it is in its place at the time 0. Default: it stands.
        velocity: Option<At<Point>>,
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
        tube: At<Length>,
        /// What it is made of: a name, or a table. Default: matte and white.
        material: Option<Surface>,
        /// How far it moves in a time of one; it is in its place at the time 0. Default: it stands.
        velocity: Option<At<Point>>,
    }

    /// Triangles from a file. They are scaled, then turned, then moved.
    struct Mesh {
        /// The file, beside the scene: .obj, .ply, .gltf or .glb.
        file: At<String>,
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
        velocity: Option<At<Point>>,
    }
}

/// The JSON Schema of the format.
pub(super) fn schema() -> schemars::Schema {
    schemars::schema_for!(File)
}
