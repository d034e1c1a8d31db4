//! The scene: borrowed slices, checked once.

mod camera;
mod check;
#[cfg(not(feature = "double"))]
mod effect_set;
mod effects;
#[cfg(not(feature = "double"))]
mod error;
#[cfg(not(feature = "double"))]
mod field;
#[cfg(not(feature = "double"))]
mod fresnel;
#[cfg(not(feature = "double"))]
mod kind;
mod light;
mod material;
#[cfg(not(feature = "double"))]
mod reference;
#[cfg(not(feature = "double"))]
mod resolution;
#[cfg(feature = "alloc")]
#[cfg(not(feature = "double"))]
mod shading;
#[cfg(feature = "alloc")]
mod tables;
mod texture;
mod world;

// Without `Real`: one type for both precisions.
#[cfg(all(feature = "alloc", feature = "double"))]
use strahl_core::scene as shading;
#[cfg(feature = "double")]
use strahl_core::scene::{
    self as effect_set, self as error, self as field, self as fresnel, self as kind, self as reference,
    self as resolution,
};

pub use camera::{Camera, CameraDescriptor, CameraSample, FilmPoint, Projection};
pub use effect_set::{EffectSet, LevelLimitRadiance};
pub use effects::{AllEffects, Effects};
pub use error::{CameraError, SceneError};
pub use field::{Field, FieldError};
pub use fresnel::FresnelModel;
pub use kind::{LightKind, LightSet, TextureKind, TextureSet};
pub(crate) use light::LightSample;
pub use light::{Falloff, Light, LightSource};
pub use material::Material;
pub use reference::{MaterialId, TextureId};
pub use resolution::Resolution;
#[cfg(feature = "alloc")]
pub use shading::Shading;
#[cfg(feature = "alloc")]
pub use tables::SceneTables;
pub use texture::Texture;
pub use world::World;

use crate::geometry::{Geometry, ItemId, Shape};
use crate::math::{Rgb, Vec3, clamp};

/// What a ray sees that meets nothing.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "baked", derive(zerocopy::TryFromBytes, zerocopy::KnownLayout, zerocopy::Immutable))]
#[repr(u32)]
pub enum Background {
    /// One colour.
    Color(Rgb),
    /// From one colour to another, by the height of the direction.
    Gradient {
        /// What is up, of length one.
        up: Vec3,
        /// The colour straight down.
        below: Rgb,
        /// The colour straight up.
        above: Rgb,
    },
}

impl Background {
    fn validate(&self) -> Result<(), FieldError> {
        match *self {
            Background::Color(color) => check::color(Field::Color, color, Rgb::MAX_CHANNEL),
            Background::Gradient { up, below, above } => {
                check::direction(Field::Up, up)?;
                check::color(Field::Below, below, Rgb::MAX_CHANNEL)?;
                check::color(Field::Above, above, Rgb::MAX_CHANNEL)
            }
        }
    }

    /// The colour in a direction of length one.
    pub fn radiance(&self, direction: Vec3) -> Rgb {
        match *self {
            Background::Color(color) => color,
            Background::Gradient { up, below, above } => {
                below.lerp(above, clamp(0.5 + 0.5 * direction.dot(up), 0.0, 1.0))
            }
        }
    }
}

/// Everything that a scene is made of, before it is checked.
#[derive(Clone, Copy, Debug)]
pub struct SceneDescriptor<'s> {
    /// What is there.
    pub geometry: Geometry<'s>,
    /// What each item is made of, by its number.
    pub material_ids: &'s [MaterialId],
    /// The materials.
    pub materials: &'s [Material],
    /// The textures that materials name.
    pub textures: &'s [Texture],
    /// The lights.
    pub lights: &'s [Light],
    /// Light from everywhere, for the ambient share of materials.
    pub ambient: Rgb,
    /// What is behind everything.
    pub background: Background,
    /// Whether light passes through transmitting bodies on its way from a light, coloured and
    /// weakened but not bent; else they stand in its way like everything.
    pub colored_shadows: bool,
}

impl SceneDescriptor<'_> {
    /// Empty, dark space; a scene names what it has and takes the rest from here.
    pub const EMPTY: SceneDescriptor<'static> = SceneDescriptor {
        geometry: Geometry::EMPTY,
        material_ids: &[],
        materials: &[],
        textures: &[],
        lights: &[],
        ambient: Rgb::BLACK,
        background: Background::Color(Rgb::BLACK),
        colored_shadows: false,
    };

    /// The memory that all tables take, in bytes.
    pub const fn size_in_bytes(&self) -> usize {
        self.geometry.size_in_bytes()
            + size_of_val(self.material_ids)
            + size_of_val(self.materials)
            + size_of_val(self.textures)
            + size_of_val(self.lights)
    }
}

/// A scene that has been checked: every reference finds its table, every number is in range.
#[derive(Clone, Copy, Debug)]
pub struct Scene<'s> {
    descriptor: SceneDescriptor<'s>,
    required_effects: EffectSet,
}

impl<'s> Scene<'s> {
    /// The scene of these parts, or what is wrong with the first of them that does not fit.
    ///
    /// ```
    /// use strahl_core::{Geometry, Light, Material, MaterialId, SceneDescriptor, Rgb, Scene, Shape, Sphere, vec3};
    ///
    /// let shapes = [Shape::Sphere(Sphere { center: vec3(0.0, 0.0, -5.0), radius: 1.0 })];
    /// let scene = Scene::new(SceneDescriptor {
    ///     geometry: Geometry { shapes: &shapes, ..Geometry::EMPTY },
    ///     material_ids: &[MaterialId(0)],
    ///     materials: &[Material::MATTE],
    ///     ambient: Rgb::gray(0.2),
    ///     ..SceneDescriptor::EMPTY
    /// })?;
    /// assert!(!scene.required_effects().shadows); // there is no light that could be in the way of
    /// # Ok::<(), strahl_core::scene::SceneError>(())
    /// ```
    pub fn new(parts: SceneDescriptor<'s>) -> Result<Self, SceneError> {
        if u32::try_from(parts.geometry.shapes.len()).is_err() {
            return Err(SceneError::TooManyItems);
        }
        parts.geometry.validate().map_err(|(item, fault)| SceneError::Shape(item, fault))?;
        if parts.materials.len() > 1 << 16 {
            return Err(SceneError::TooManyMaterials);
        }
        for (material, place) in parts.materials.iter().zip(0..=u16::MAX) {
            let wrong = |fault| SceneError::Material(MaterialId(place), fault);
            material.validate(parts.textures.len()).map_err(wrong)?;
        }
        for number in 0..parts.geometry.shapes.len() {
            let material = parts.material_ids.get(number).and_then(|m| parts.materials.get(usize::from(m.0)));
            if material.is_none() {
                return Err(SceneError::MissingMaterial(ItemId(number as u32)));
            }
        }
        for (light, index) in parts.lights.iter().zip(0..) {
            light.validate().map_err(|error| SceneError::Light(index, error))?;
        }
        for (texture, index) in parts.textures.iter().zip(0..) {
            texture.validate().map_err(|error| SceneError::Texture(index, error))?;
        }
        check::color(Field::Ambient, parts.ambient, Rgb::MAX_CHANNEL).map_err(SceneError::Ambient)?;
        parts.background.validate().map_err(SceneError::Background)?;
        Ok(Scene { descriptor: parts, required_effects: find_required_effects(&parts) })
    }

    /// What it is made of.
    pub fn descriptor(&self) -> &SceneDescriptor<'s> {
        &self.descriptor
    }

    /// What must be simulated: what its shapes, materials and lights ask for, and no more. A
    /// material that no item is made of asks for nothing.
    pub fn required_effects(&self) -> EffectSet {
        self.required_effects
    }

    /// What an item is made of.
    pub fn material(&self, item: ItemId) -> Option<&'s Material> {
        let place = self.descriptor.material_ids.get(item.0 as usize)?.0;
        self.descriptor.materials.get(usize::from(place))
    }
}

fn find_required_effects(parts: &SceneDescriptor<'_>) -> EffectSet {
    let mut asks = EffectSet::NONE;
    let mut lit = false;
    for (shape, material_id) in parts.geometry.shapes.iter().zip(parts.material_ids) {
        asks.motion_blur |= matches!(shape, Shape::Moving(_));
        let Some(shape) = parts.geometry.static_shape(shape) else { continue };
        asks.shapes = shape.kind().map_or(asks.shapes, |kind| asks.shapes.with(kind));
        asks.smooth_shading |= match *shape {
            Shape::SmoothTriangle(_) => true,
            Shape::Polygon(place) => parts.geometry.polygons.get(place as usize).is_some_and(|p| p.smooth),
            _ => false,
        };
        let Some(material) = parts.materials.get(usize::from(material_id.0)) else { continue };
        lit |= material.is_lit();
        asks.highlight |= material.has_highlight() && !parts.lights.is_empty();
        asks.reflection |= !material.reflection.is_black();
        asks.transmission |= material.is_transmitting();
        asks.absorption |= material.is_absorbing();
        asks.gloss |= material.is_glossy();
        if let Some(texture) = parts.textures.get(usize::from(material.texture.0)) {
            asks.textures = asks.textures.with(texture.kind());
        }
    }
    for light in parts.lights.iter().filter(|light| lit && !light.color.is_black()) {
        asks.lights = asks.lights.with(light.kind());
        asks.shadows |= light.casts_shadows;
        asks.penumbra |= light.has_penumbra();
    }
    asks.colored_shadows = parts.colored_shadows && asks.shadows && asks.transmission;
    asks
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::{Plane, ShapeError, Sphere};
    use crate::math::vec3;

    const BALL: Shape = Shape::Sphere(Sphere { center: Vec3::ZERO, radius: 1.0 });
    const LAMP: Light = Light {
        source: LightSource::Point { position: Vec3::ONE, falloff: Falloff::NONE },
        color: Rgb::WHITE,
        casts_shadows: true,
    };

    fn parts<'s>(shapes: &'s [Shape], materials: &'s [Material]) -> SceneDescriptor<'s> {
        let geometry = Geometry { shapes, ..Geometry::EMPTY };
        SceneDescriptor {
            geometry,
            material_ids: &[MaterialId(0)],
            materials,
            lights: &[LAMP],
            ..SceneDescriptor::EMPTY
        }
    }

    #[test]
    fn a_scene_asks_for_what_its_items_are_made_of_and_no_more() {
        let matte = [Material::MATTE];
        let asks = Scene::new(parts(&[BALL], &matte)).unwrap().required_effects();
        let local = EffectSet {
            shapes: crate::geometry::ShapeSet::of(&[crate::geometry::ShapeKind::Sphere]),
            lights: LightSet::of(&[LightKind::Point]),
            shadows: true,
            ..EffectSet::NONE
        };
        assert_eq!(asks, local);
        // The second material is nobody's.
        let glass = Material { transmission: Rgb::WHITE, ..Material::MATTE };
        let asks = Scene::new(parts(&[BALL], &[Material::MATTE, glass])).unwrap().required_effects();
        assert_eq!(asks, local);
        let asks = Scene::new(parts(&[BALL], &[glass])).unwrap().required_effects();
        assert_eq!(asks, EffectSet { transmission: true, ..local });
        assert!(EffectSet::ALL.is_superset(&asks) && !local.is_superset(&asks));
    }

    #[test]
    fn parts_that_do_not_fit_are_named() {
        let matte = [Material::MATTE];
        let fault = |parts| Scene::new(parts).unwrap_err();
        let flat = [Shape::Sphere(Sphere { center: Vec3::ZERO, radius: 0.0 })];
        assert_eq!(fault(parts(&flat, &matte)), SceneError::Shape(ItemId(0), ShapeError::Radius));
        let far = [Shape::Sphere(Sphere { center: vec3(2e15, 0.0, 0.0), radius: 1.0 })];
        assert_eq!(fault(parts(&far, &matte)), SceneError::Shape(ItemId(0), ShapeError::Coordinate));
        assert_eq!(
            fault(parts(&[Shape::Triangle([0, 1, 2])], &matte)),
            SceneError::Shape(ItemId(0), ShapeError::IndexOutOfRange)
        );
        assert_eq!(fault(parts(&[BALL], &[])), SceneError::MissingMaterial(ItemId(0)));
        let dark = [Material { attenuation_length: Rgb::BLACK, ..Material::MATTE }];
        assert_eq!(
            fault(parts(&[BALL], &dark)),
            SceneError::Material(MaterialId(0), FieldError { field: Field::AttenuationLength, value: 0.0 })
        );
        let lamp = [Light { color: Rgb::gray(-1.0), ..LAMP }];
        let dark = FieldError { field: Field::Color, value: -1.0 };
        assert_eq!(
            fault(SceneDescriptor { lights: &lamp, ..parts(&[BALL], &matte) }),
            SceneError::Light(0, dark)
        );
    }

    #[test]
    fn a_plane_must_stand_in_its_table_under_its_own_number() {
        let matte = [Material::MATTE];
        let planes = [Plane { point: Vec3::ZERO, normal: Vec3::Y, item: ItemId(1) }];
        let geometry = Geometry { shapes: &[Shape::Plane(0)], planes: &planes, ..Geometry::EMPTY };
        let fault = Scene::new(SceneDescriptor { geometry, ..parts(&[], &matte) }).unwrap_err();
        assert_eq!(fault, SceneError::Shape(ItemId(0), ShapeError::PlaneItem));
    }
}
