//! A scene as Rust constants.

use std::fmt::Write as _;
use std::path::Path;

use strahl_core::geometry::{Aabb, Cone, Cuboid, Disc, ItemId, MovingShape, OrientedCuboid, Polygon, Torus};
use strahl_core::scene::{EffectSet, FresnelModel, Texture, TextureId};
use strahl_core::{
    Background, CameraDescriptor, Falloff, Geometry, Light, LightSource, Material, MaterialId, Plane,
    Projection, Rgb, Scene, Shape, Sphere, Vec3,
};

use super::settings::BakeSettings;

/// Constants of the scene: `SCENE`, `CAMERA`, `SIZE`, `LIMITS`, `ITEMS`, and `SceneEffects`, the effects.
pub(super) fn source(path: &Path, scene: &Scene<'_>, settings: &BakeSettings) -> String {
    let parts = scene.descriptor();
    let name = path.file_name().unwrap_or_default().to_string_lossy().replace(['\n', '\r'], " ");
    let (width, height) = (settings.size.width(), settings.size.height());
    let mut out = format!(
        "// Written by `strahl bake` from {name}.\n\nuse strahl_core::{{geometry::*, math::*, scene::*, trace::*}};\n\n\
         /// Size of the picture in pixels.\npub const SIZE: Resolution = Resolution::new({width}, {height}).unwrap();\n\n\
         /// Levels and cutoff.\n\
         pub const LIMITS: Limits = Limits {{ levels: {}, cutoff: {} }};\n\n\
         /// Camera.\npub const CAMERA: CameraDescriptor = {};\n\n\
         /// Number of items.\npub const ITEMS: u32 = {};\n\n",
        settings.levels,
        text(&settings.cutoff),
        text(&settings.camera),
        parts.material_ids.len(),
    );
    // The lens belongs to the camera, so the effects of the scene do not include it.
    let lens = matches!(settings.camera.projection, Projection::ThinLens { .. });
    effects(&mut out, &EffectSet { depth_of_field: lens, ..scene.required_effects() });
    out += "/// Tables of the scene, not yet validated.\npub static SCENE: SceneDescriptor<'static> = SceneDescriptor {\n    geometry: Geometry {\n";
    let (fields, constants) = geometry_tables(&parts.geometry);
    out += &fields;
    let _ = write!(
        out,
        "    }},\n    material_ids: &MATERIAL_IDS,\n    materials: &MATERIALS,\n    textures: &TEXTURES,\n    lights: &LIGHTS,\n    \
         ambient: {},\n    background: {},\n    colored_shadows: {},\n}};\n\n",
        text(&parts.ambient),
        text(&parts.background),
        parts.colored_shadows,
    );
    out += &constants;
    table(&mut out, "MATERIAL_IDS", "MaterialId", parts.material_ids);
    table(&mut out, "MATERIALS", "Material", parts.materials);
    table(&mut out, "TEXTURES", "Texture", parts.textures);
    table(&mut out, "LIGHTS", "Light", parts.lights);
    out
}

/// The fields of a `Geometry`, and the constants with its tables.
fn geometry_tables(geometry: &Geometry<'_>) -> (String, String) {
    let (mut fields, mut constants) = (String::new(), String::new());
    macro_rules! tables {
        ($($field:ident: $Type:ident),+ $(,)?) => {{
            // Names all fields, so that a new table cannot be forgotten.
            let Geometry { $($field),+ } = geometry;
            $(
                let constant = stringify!($field).to_uppercase();
                let _ = writeln!(fields, "        {}: &{constant},", stringify!($field));
                table(&mut constants, &constant, stringify!($Type), $field);
            )+
        }};
    }
    tables! {
        shapes: Shape,
        vertices: Vec3,
        vertex_normals: Vec3,
        planes: Plane,
        discs: Disc,
        polygons: Polygon,
        cuboids: Cuboid,
        oriented_cuboids: OrientedCuboid,
        cones: Cone,
        tori: Torus,
        moving_shapes: MovingShape,
    }
    (fields, constants)
}

fn table<T: RustLiteral>(out: &mut String, name: &str, of: &str, entries: &[T]) {
    let _ = writeln!(out, "static {name}: [{of}; {}] = [", entries.len());
    for entry in entries {
        out.push_str("    ");
        entry.write_literal(out);
        out.push_str(",\n");
    }
    out.push_str("];\n");
}

/// The effects that the scene requires, as a type.
fn effects(out: &mut String, set: &EffectSet) {
    out.push_str(
        "/// Exactly the effects that the scene requires.\n#[derive(Clone, Copy, Debug)]\npub struct SceneEffects;\n\n",
    );
    out.push_str("impl Effects for SceneEffects {\n    const SET: EffectSet = EffectSet {\n");
    let shapes: Vec<String> = set.shapes.iter().map(|kind| format!("ShapeKind::{kind:?}")).collect();
    let lights: Vec<String> = set.lights.iter().map(|kind| format!("LightKind::{kind:?}")).collect();
    let textures: Vec<String> = set.textures.iter().map(|kind| format!("TextureKind::{kind:?}")).collect();
    let _ = writeln!(out, "        shapes: ShapeKindSet::of(&[{}]),", shapes.join(", "));
    let _ = writeln!(out, "        lights: LightKindSet::of(&[{}]),", lights.join(", "));
    let _ = writeln!(out, "        textures: TextureKindSet::of(&[{}]),", textures.join(", "));
    for (name, is_required) in [
        ("smooth_shading", set.smooth_shading),
        ("highlight", set.highlight),
        ("shadows", set.shadows),
        ("reflection", set.reflection),
        ("transmission", set.transmission),
        ("absorption", set.absorption),
        ("colored_shadows", set.colored_shadows),
        ("soft_shadows", set.soft_shadows),
        ("depth_of_field", set.depth_of_field),
        ("gloss", set.gloss),
        ("motion_blur", set.motion_blur),
    ] {
        let _ = writeln!(out, "        {name}: {is_required},");
    }
    out.push_str("        ..EffectSet::NONE\n    };\n}\n\n");
}

fn text(value: &impl RustLiteral) -> String {
    let mut out = String::new();
    value.write_literal(&mut out);
    out
}

/// A value that can be written as a Rust expression.
trait RustLiteral {
    fn write_literal(&self, out: &mut String);
}

impl RustLiteral for f32 {
    fn write_literal(&self, out: &mut String) {
        if *self == f32::INFINITY {
            out.push_str("f32::INFINITY");
        } else {
            // The shortest form that reads back exactly.
            let _ = write!(out, "{self:?}");
        }
    }
}

macro_rules! displayed {
    ($($Type:ty)*) => {$(
        impl RustLiteral for $Type {
            fn write_literal(&self, out: &mut String) {
                let _ = write!(out, "{self}");
            }
        }
    )*};
}
displayed!(u8 u16 u32 bool);

impl<T: RustLiteral, const N: usize> RustLiteral for [T; N] {
    fn write_literal(&self, out: &mut String) {
        let entries: Vec<String> = self.iter().map(text).collect();
        let _ = write!(out, "[{}]", entries.join(", "));
    }
}

macro_rules! calls {
    ($($Type:ident $name:literal ($($field:tt),*))*) => {$(
        impl RustLiteral for $Type {
            fn write_literal(&self, out: &mut String) {
                let fields: Vec<String> = vec![$(text(&self.$field)),*];
                let _ = write!(out, "{}({})", $name, fields.join(", "));
            }
        }
    )*};
}
calls! {
    Vec3 "vec3" (x, y, z)
    Rgb "Rgb::new" (r, g, b)
    ItemId "ItemId" (0)
    MaterialId "MaterialId" (0)
    TextureId "TextureId" (0)
}

impl RustLiteral for FresnelModel {
    fn write_literal(&self, out: &mut String) {
        let _ = write!(out, "FresnelModel::{self:?}");
    }
}

fn fields(out: &mut String, name: &str, fields: &[(&str, String)]) {
    let fields: Vec<String> = fields.iter().map(|(name, value)| format!("{name}: {value}")).collect();
    let _ = write!(out, "{name} {{ {} }}", fields.join(", "));
}

/// Structs, by their fields. Without `..`, so that a new field is an error here.
macro_rules! structs {
    ($($Struct:ident { $($field:ident),* })*) => {$(
        impl RustLiteral for $Struct {
            fn write_literal(&self, out: &mut String) {
                let $Struct { $($field),* } = self;
                fields(out, stringify!($Struct), &[$((stringify!($field), text($field))),*]);
            }
        }
    )*};
}
structs! {
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

/// Enums whose variants have fields with names.
macro_rules! variants {
    ($($Enum:ident { $($Variant:ident { $($field:ident),* })* })*) => {$(
        impl RustLiteral for $Enum {
            fn write_literal(&self, out: &mut String) {
                match self {
                    $($Enum::$Variant { $($field),* } => {
                        let name = concat!(stringify!($Enum), "::", stringify!($Variant));
                        fields(out, name, &[$((stringify!($field), text($field))),*]);
                    })*
                }
            }
        }
    )*};
}
variants! {
    Texture {
        Checker { even, odd, origin, frequency }
        Gradient { start_color, end_color, origin, axis }
        ZonePlate { start_color, end_color, origin, frequency }
    }
    Projection {
        Perspective { field_of_view }
        Orthographic { height }
        ThinLens { field_of_view, lens_radius, focus_distance }
    }
    LightSource {
        Point { position, falloff }
        Directional { to_light }
        Spot { position, direction, cos_inner, cos_outer, falloff }
        Sphere { position, radius, falloff }
        Rectangle { position, half_edges, soft_shadows, falloff }
    }
}

impl RustLiteral for Background {
    fn write_literal(&self, out: &mut String) {
        match self {
            Background::Color(color) => {
                let _ = write!(out, "Background::Color({})", text(color));
            }
            Background::Gradient { up, below, above } => {
                let all = [("up", text(up)), ("below", text(below)), ("above", text(above))];
                fields(out, "Background::Gradient", &all);
            }
        }
    }
}

impl RustLiteral for Shape {
    fn write_literal(&self, out: &mut String) {
        let place = match self {
            Shape::Sphere(sphere) => text(sphere),
            Shape::Triangle(corners) | Shape::SmoothTriangle(corners) => text(corners),
            Shape::Plane(place)
            | Shape::Disc(place)
            | Shape::Polygon(place)
            | Shape::Cuboid(place)
            | Shape::OrientedCuboid(place)
            | Shape::Cone(place)
            | Shape::Torus(place)
            | Shape::Moving(place) => text(place),
        };
        let kind = self.kind().map_or("Moving".into(), |kind| format!("{kind:?}"));
        let _ = write!(out, "Shape::{kind}({place})");
    }
}
