//! Names and lines of items, materials and lights in the scene file.

use strahl_core::accel::List;
use strahl_core::geometry::{ItemId, Ray};
use strahl_core::tally::RayKind;
use strahl_core::{AllEffects, Real, Vec3, World};
use strahl_scene::description::{LoadedScene, ShapeDescription};
use strahl_scene::effects::object_count;

use super::tree::{ItemRecord, NameAndLine};

/// The source of a scene.
pub struct SourceNames<'n> {
    description: &'n LoadedScene,
    world: &'n World<'n, List<'n>>,
    /// The first item of each object of the description.
    first_items: Vec<u32>,
}

impl<'n> SourceNames<'n> {
    /// The names of a world that was built from a description.
    pub fn new(description: &'n LoadedScene, world: &'n World<'n, List<'n>>) -> Self {
        let mut next = 0;
        let firsts = description.objects.iter().map(|object| {
            let first = next;
            next += object_count(object) as u32;
            first
        });
        SourceNames { description, world, first_items: firsts.collect() }
    }

    /// The shape, line and material of an item.
    pub fn item(&self, item: ItemId) -> ItemRecord {
        let scene = self.world.scene().descriptor();
        let index = self.first_items.partition_point(|first| *first <= item.0).saturating_sub(1);
        let object = self.description.objects.get(index);
        let first = self.first_items.get(index).copied().unwrap_or(0);
        let is_mesh = object.is_some_and(|object| matches!(object.shape, ShapeDescription::Mesh { .. }));
        let material = scene.material_ids.get(item.0 as usize).map_or(0, |material| material.0);
        ItemRecord {
            object: item.0,
            shape: scene
                .geometry
                .shape(item)
                .and_then(|shape| scene.geometry.kind(shape))
                .map_or("nothing", |kind| kind.name()),
            triangle: is_mesh.then_some(item.0 - first),
            line: object.map_or(0, |object| object.line),
            material: self.material(material),
        }
    }

    /// The name and line of a material.
    pub fn material(&self, number: u16) -> NameAndLine {
        let material = self.description.materials.get(usize::from(number));
        material.map_or(NameAndLine { name: None, line: 0 }, |it| named(&it.name, it.line))
    }

    /// The name and line of a light.
    pub fn light(&self, number: u16) -> NameAndLine {
        let light = self.description.lights.get(usize::from(number));
        light.map_or(NameAndLine { name: None, line: 0 }, |it| named(&it.name, it.line))
    }

    /// The nearest item along a shadow ray, and its distance.
    pub fn nearest_occluder(&self, origin: Vec3, direction: Vec3, t_max: Real) -> Option<(ItemId, f32)> {
        let ray = Ray::new(origin, direction);
        let hit = self.world.nearest_hit::<AllEffects, _>(&ray, t_max, RayKind::Shadow, &mut (), &mut ())?;
        Some((hit.item, hit.t))
    }
}

fn named(name: &Option<String>, line: usize) -> NameAndLine {
    NameAndLine { name: name.clone(), line: line as u32 }
}
