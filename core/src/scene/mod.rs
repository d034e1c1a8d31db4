//! Scenes: shapes, materials, textures, lights and cameras.
//!
//! A [`SceneDescriptor`] borrows the tables of a scene; [`Scene::new`] checks them once, so that tracing
//! cannot fail. A [`World`] adds the accelerator and finds the items that rays hit.

mod background;
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
mod ray_query;
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

pub use background::Background;
pub use camera::{Camera, CameraDescriptor, CameraSample, FilmPoint, Projection};
pub use effect_set::{EffectSet, LevelLimitRadiance};
pub use effects::{AllEffects, Effects};
pub use error::{CameraError, SceneError};
pub use field::{Field, FieldError};
pub use fresnel::FresnelModel;
pub use kind::{LightKind, LightKindSet, TextureKind, TextureKindSet};
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

use check::FieldChecks;

use crate::geometry::{Geometry, ItemId, Shape};
use crate::math::Rgb;

/// The tables of a scene, borrowed and not yet checked: the input of [`Scene::new`].
///
/// Items have the indices of their shapes. Constructors of shapes, materials and lights are `const` where they
/// need no square root, so the tables of a device can be `static`, in flash. With the feature `alloc`,
/// `SceneTables` fills the tables.
#[derive(Clone, Copy, Debug)]
pub struct SceneDescriptor<'s> {
    /// Shapes and their tables.
    pub geometry: Geometry<'s>,
    /// Material of each item, in the order of the shapes.
    pub material_ids: &'s [MaterialId],
    /// Materials that `material_ids` refers to.
    pub materials: &'s [Material],
    /// Textures that [`Material::texture`] refers to.
    pub textures: &'s [Texture],
    /// Light sources, in the order in which their light is added.
    pub lights: &'s [Light],
    /// Ambient light, which arrives at every surface from all directions, each channel in `0..=1e6`.
    pub ambient: Rgb,
    /// Radiance of rays that hit no item.
    pub background: Background,
    /// Whether shadow rays pass through transmitting bodies (transparent shadows). The light is multiplied by
    /// each body's transmission, attenuation and, at each surface, what the Fresnel model leaves; it is not
    /// refracted. If not, transmitting bodies occlude lights like all other items.
    pub colored_shadows: bool,
}

impl SceneDescriptor<'_> {
    /// An empty, black scene: the default of all fields.
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

    /// Size of all tables, in bytes.
    pub const fn size_in_bytes(&self) -> usize {
        self.geometry.size_in_bytes()
            + size_of_val(self.material_ids)
            + size_of_val(self.materials)
            + size_of_val(self.textures)
            + size_of_val(self.lights)
    }
}

/// A valid scene: every index is in its table, every field in its range.
#[derive(Clone, Copy, Debug)]
pub struct Scene<'s> {
    descriptor: SceneDescriptor<'s>,
    required_effects: EffectSet,
}

impl<'s> Scene<'s> {
    /// Checks the tables of `descriptor`.
    ///
    /// # Errors
    ///
    /// The first entry that is out of range or refers to a missing entry; see [`SceneError`].
    ///
    /// ```
    /// use strahl_core::{Geometry, Material, MaterialId, Rgb, Scene, SceneDescriptor, Shape, Sphere, vec3};
    ///
    /// let shapes = [Shape::Sphere(Sphere { center: vec3(0.0, 0.0, -5.0), radius: 1.0 })];
    /// let scene = Scene::new(SceneDescriptor {
    ///     geometry: Geometry { shapes: &shapes, ..Geometry::EMPTY },
    ///     material_ids: &[MaterialId(0)],
    ///     materials: &[Material::MATTE],
    ///     ambient: Rgb::gray(0.2),
    ///     ..SceneDescriptor::EMPTY
    /// })?;
    /// assert!(!scene.required_effects().shadows); // there is no light
    /// # Ok::<(), strahl_core::scene::SceneError>(())
    /// ```
    pub fn new(descriptor: SceneDescriptor<'s>) -> Result<Self, SceneError> {
        if u32::try_from(descriptor.geometry.shapes.len()).is_err() {
            return Err(SceneError::TooManyItems);
        }
        descriptor.geometry.validate().map_err(|(item, error)| SceneError::Shape(item, error))?;
        if descriptor.materials.len() > 1 << 16 {
            return Err(SceneError::TooManyMaterials);
        }
        for (material, index) in descriptor.materials.iter().zip(0..=u16::MAX) {
            let error = |error| SceneError::Material(MaterialId(index), error);
            FieldChecks::run(|fields| material.validate(descriptor.textures.len(), fields)).map_err(error)?;
        }
        for item in 0..descriptor.geometry.shapes.len() {
            let material =
                descriptor.material_ids.get(item).and_then(|id| descriptor.materials.get(usize::from(id.0)));
            if material.is_none() {
                return Err(SceneError::MissingMaterial(ItemId(item as u32)));
            }
        }
        for (light, index) in descriptor.lights.iter().zip(0..) {
            let error = |error| SceneError::Light(index, error);
            FieldChecks::run(|fields| light.validate(fields)).map_err(error)?;
        }
        for (texture, index) in descriptor.textures.iter().zip(0..) {
            let error = |error| SceneError::Texture(index, error);
            FieldChecks::run(|fields| texture.validate(fields)).map_err(error)?;
        }
        let ambient = |fields: &mut FieldChecks| {
            fields.color(Field::Ambient, &descriptor.ambient, Rgb::MAX_CHANNEL);
        };
        FieldChecks::run(ambient).map_err(SceneError::Ambient)?;
        let background = |fields: &mut FieldChecks| descriptor.background.validate(fields);
        FieldChecks::run(background).map_err(SceneError::Background)?;
        Ok(Scene { descriptor, required_effects: find_required_effects(&descriptor) })
    }

    /// The tables of the scene, as they were checked.
    pub fn descriptor(&self) -> &SceneDescriptor<'s> {
        &self.descriptor
    }

    /// Effects that its shapes, materials and lights require, and no others.
    ///
    /// Materials that no item has require nothing. Depth of field depends on the camera and is not included.
    pub fn required_effects(&self) -> EffectSet {
        self.required_effects
    }

    /// Material of an item; `None` if there is no such item.
    pub fn material(&self, item: ItemId) -> Option<&'s Material> {
        let id = self.descriptor.material_ids.get(item.0 as usize)?;
        self.descriptor.materials.get(usize::from(id.0))
    }
}

/// Effects that the items, materials and lights require.
fn find_required_effects(descriptor: &SceneDescriptor<'_>) -> EffectSet {
    let mut effects = EffectSet::NONE;
    let mut is_lit = false;
    for (shape, material_id) in descriptor.geometry.shapes.iter().zip(descriptor.material_ids) {
        effects.motion_blur |= matches!(shape, Shape::Moving(_));
        let Some(shape) = descriptor.geometry.static_shape(shape) else { continue };
        effects.shapes = shape.kind().map_or(effects.shapes, |kind| effects.shapes.with(kind));
        effects.smooth_shading |= match *shape {
            Shape::SmoothTriangle(_) => true,
            Shape::Polygon(index) => {
                descriptor.geometry.polygons.get(index as usize).is_some_and(|p| p.smooth)
            }
            Shape::Sphere(_)
            | Shape::Triangle(_)
            | Shape::Plane(_)
            | Shape::Disc(_)
            | Shape::Cuboid(_)
            | Shape::OrientedCuboid(_)
            | Shape::Cone(_)
            | Shape::Torus(_)
            | Shape::Moving(_) => false,
        };
        let Some(material) = descriptor.materials.get(usize::from(material_id.0)) else { continue };
        is_lit |= material.is_lit();
        effects.highlight |= material.has_highlight() && !descriptor.lights.is_empty();
        effects.reflection |= !material.reflection.is_black();
        effects.transmission |= material.is_transmitting();
        effects.absorption |= material.is_absorbing();
        effects.gloss |= material.is_glossy();
        if let Some(texture) = descriptor.textures.get(usize::from(material.texture.0)) {
            effects.textures = effects.textures.with(texture.kind());
        }
    }
    for light in descriptor.lights.iter().filter(|light| is_lit && !light.color.is_black()) {
        effects.lights = effects.lights.with(light.kind());
        effects.shadows |= light.casts_shadows;
        effects.soft_shadows |= light.has_soft_shadows();
    }
    effects.colored_shadows = descriptor.colored_shadows && effects.shadows && effects.transmission;
    effects
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::{Plane, ShapeError, Sphere};
    use crate::math::{Vec3, vec3};

    const SPHERE: Shape = Shape::Sphere(Sphere { center: Vec3::ZERO, radius: 1.0 });
    const LIGHT: Light = Light {
        source: LightSource::Point { position: Vec3::ONE, falloff: Falloff::NONE },
        color: Rgb::WHITE,
        casts_shadows: true,
    };

    fn descriptor<'s>(shapes: &'s [Shape], materials: &'s [Material]) -> SceneDescriptor<'s> {
        let geometry = Geometry { shapes, ..Geometry::EMPTY };
        SceneDescriptor {
            geometry,
            material_ids: &[MaterialId(0)],
            materials,
            lights: &[LIGHT],
            ..SceneDescriptor::EMPTY
        }
    }

    #[test]
    fn only_materials_in_use_require_effects() {
        let matte = [Material::MATTE];
        let effects = Scene::new(descriptor(&[SPHERE], &matte)).unwrap().required_effects();
        let local = EffectSet {
            shapes: crate::geometry::ShapeKindSet::of(&[crate::geometry::ShapeKind::Sphere]),
            lights: LightKindSet::of(&[LightKind::Point]),
            shadows: true,
            ..EffectSet::NONE
        };
        assert_eq!(effects, local);
        // No item has the second material.
        let glass = Material { transmission: Rgb::WHITE, ..Material::MATTE };
        let effects =
            Scene::new(descriptor(&[SPHERE], &[Material::MATTE, glass])).unwrap().required_effects();
        assert_eq!(effects, local);
        let effects = Scene::new(descriptor(&[SPHERE], &[glass])).unwrap().required_effects();
        assert_eq!(effects, EffectSet { transmission: true, ..local });
        assert!(EffectSet::ALL.is_superset(&effects) && !local.is_superset(&effects));
    }

    #[test]
    fn the_error_names_the_invalid_entry() {
        let matte = [Material::MATTE];
        let error = |descriptor| Scene::new(descriptor).unwrap_err();
        let flat = [Shape::Sphere(Sphere { center: Vec3::ZERO, radius: 0.0 })];
        assert_eq!(error(descriptor(&flat, &matte)), SceneError::Shape(ItemId(0), ShapeError::Radius));
        let far = [Shape::Sphere(Sphere { center: vec3(2e15, 0.0, 0.0), radius: 1.0 })];
        assert_eq!(error(descriptor(&far, &matte)), SceneError::Shape(ItemId(0), ShapeError::Coordinate));
        assert_eq!(
            error(descriptor(&[Shape::Triangle([0, 1, 2])], &matte)),
            SceneError::Shape(ItemId(0), ShapeError::IndexOutOfRange)
        );
        assert_eq!(error(descriptor(&[SPHERE], &[])), SceneError::MissingMaterial(ItemId(0)));
        let dark = [Material { attenuation_length: Rgb::BLACK, ..Material::MATTE }];
        assert_eq!(
            error(descriptor(&[SPHERE], &dark)),
            SceneError::Material(MaterialId(0), FieldError { field: Field::AttenuationLength, value: 0.0 })
        );
        let lamp = [Light { color: Rgb::gray(-1.0), ..LIGHT }];
        let dark = FieldError { field: Field::Color, value: -1.0 };
        assert_eq!(
            error(SceneDescriptor { lights: &lamp, ..descriptor(&[SPHERE], &matte) }),
            SceneError::Light(0, dark)
        );
    }

    #[test]
    fn the_item_of_a_plane_must_be_its_own_index() {
        let matte = [Material::MATTE];
        let planes = [Plane { point: Vec3::ZERO, normal: Vec3::Y, item: ItemId(1) }];
        let geometry = Geometry { shapes: &[Shape::Plane(0)], planes: &planes, ..Geometry::EMPTY };
        let error = Scene::new(SceneDescriptor { geometry, ..descriptor(&[], &matte) }).unwrap_err();
        assert_eq!(error, SceneError::Shape(ItemId(0), ShapeError::PlaneItem));
    }
}
