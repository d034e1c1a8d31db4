//! Bounding boxes of the objects of a loaded scene.

use strahl_core::geometry::{Aabb, Cone, Cuboid, Disc, ItemId, OrientedCuboid, Torus};
use strahl_core::math::try_normalize;
use strahl_core::scene::{SceneTables, Shading};
use strahl_core::{Material, MaterialId, Sphere, Vec3};

use crate::description::{LoadedScene, ShapeDescription, vec3_of};

/// The bounding boxes of all items, as computed by the core; `None` if the core rejects the scene.
pub fn bounding_boxes(description: &LoadedScene) -> Option<Vec<Aabb>> {
    let mut tables = SceneTables::new();
    let vertices: Vec<Vec3> = description.vertices.iter().map(|p| vec3_of(*p)).collect();
    tables.add_vertices(&vertices, &[]);
    let material = tables.add_material(Material::MATTE);
    let mut moving = description.motions.iter().peekable();
    for (index, object) in description.objects.iter().enumerate() {
        let first = tables.item_count() as u32;
        if let ShapeDescription::Mesh { first, count, .. } = object.shape {
            let end = first as usize + count as usize;
            let triangles = description.triangles.get(first as usize..end).unwrap_or_default();
            tables.add_triangles(triangles, Shading::Flat, material);
        } else if add(&mut tables, object.shape, material).is_none() {
            // Degenerate: an empty triangle takes its number.
            if tables.descriptor().geometry.vertices.is_empty() {
                tables.add_vertices(&[Vec3::ZERO], &[]);
            }
            tables.add_triangles(&[[0; 3]], Shading::Flat, material);
        }
        if let Some(motion) = moving.next_if(|motion| motion.object == index) {
            let [opening, closing] = description.shutter.map(|time| vec3_of(motion.velocity) * time);
            (first..tables.item_count() as u32)
                .for_each(|item| tables.set_motion(ItemId(item), opening, closing));
        }
    }
    tables.scene().is_ok().then(|| tables.bounds())
}

/// Adds an object that is one item; `None` if it is degenerate or a mesh.
fn add(tables: &mut SceneTables, form: ShapeDescription, material: MaterialId) -> Option<ItemId> {
    Some(match form {
        ShapeDescription::Sphere { center, radius } => {
            tables.add_sphere(Sphere { center: vec3_of(center), radius }, material)
        }
        ShapeDescription::Plane { point, normal } => {
            tables.add_plane(vec3_of(point), try_normalize(vec3_of(normal))?, material)
        }
        ShapeDescription::Disc { center, normal, radius } => {
            let disc = Disc { center: vec3_of(center), normal: try_normalize(vec3_of(normal))?, radius };
            tables.add_disc(disc, material)
        }
        ShapeDescription::Cuboid { min, max } => {
            tables.add_cuboid(Cuboid { min: vec3_of(min), max: vec3_of(max) }, material)
        }
        ShapeDescription::OrientedCuboid { center, half_size: half, first, third } => {
            let cuboid = OrientedCuboid::new(vec3_of(center), vec3_of(half), vec3_of(first), vec3_of(third))?;
            tables.add_oriented_cuboid(cuboid, material)
        }
        ShapeDescription::Cone { base, base_radius, end, end_radius, capped } => {
            let cone = Cone::new(vec3_of(base), base_radius, vec3_of(end), end_radius, capped)?;
            tables.add_cone(cone, material)
        }
        ShapeDescription::Torus { center, axis, major_radius: major, minor_radius: minor } => {
            let (center, axis) = (vec3_of(center), try_normalize(vec3_of(axis))?);
            let torus = Torus { center, axis, major_radius: major, minor_radius: minor };
            tables.add_torus(torus, material)
        }
        ShapeDescription::Triangle { vertices: corners, .. } => {
            tables.add_triangles(&[corners], Shading::Flat, material).start
        }
        ShapeDescription::Polygon { first, count, .. } => {
            tables.add_polygon(first..first.checked_add(count)?, Shading::Flat, material).ok()?
        }
        ShapeDescription::Mesh { .. } | ShapeDescription::Degenerate => return None,
    })
}
