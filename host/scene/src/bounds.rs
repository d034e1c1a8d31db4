//! Where the objects of a description are.

use strahl_core::geometry::{Aabb, Cone, Cuboid, Disc, ItemId, OrientedCuboid, Torus};
use strahl_core::math::try_normalize;
use strahl_core::scene::{SceneTables, Shading};
use strahl_core::{Material, MaterialId, Sphere, Vec3};

use crate::description::{Description, Form, vector};

/// The bounding boxes of all items, as the core knows them; none where it cannot take them.
pub fn boxes(description: &Description) -> Option<Vec<Aabb>> {
    let mut tables = SceneTables::new();
    let vertices: Vec<Vec3> = description.points.iter().map(|p| vector(*p)).collect();
    tables.add_vertices(&vertices, &[]);
    let material = tables.add_material(Material::MATTE);
    let mut moving = description.moving.iter().peekable();
    for (index, object) in description.objects.iter().enumerate() {
        let first = tables.len() as u32;
        if let Form::Mesh { first, count, .. } = object.form {
            let end = first as usize + count as usize;
            let triangles = description.triangles.get(first as usize..end).unwrap_or_default();
            tables.add_triangles(triangles, Shading::Flat, material);
        } else if add(&mut tables, object.form, material).is_none() {
            // Nothing is left of it: an empty triangle has its number.
            if tables.parts().geometry.vertices.is_empty() {
                tables.add_vertices(&[Vec3::ZERO], &[]);
            }
            tables.add_triangles(&[[0; 3]], Shading::Flat, material);
        }
        if let Some(motion) = moving.next_if(|motion| motion.object == index) {
            let [opening, closing] = description.shutter.map(|time| vector(motion.velocity) * time);
            (first..tables.len() as u32).for_each(|item| tables.set_motion(ItemId(item), opening, closing));
        }
    }
    tables.scene().is_ok().then(|| tables.bounds())
}

/// Adds an object that is one shape; none when nothing is left of it.
fn add(tables: &mut SceneTables, form: Form, material: MaterialId) -> Option<ItemId> {
    Some(match form {
        Form::Sphere { center, radius } => {
            tables.add_sphere(Sphere { center: vector(center), radius }, material)
        }
        Form::Plane { point, normal } => {
            tables.add_plane(vector(point), try_normalize(vector(normal))?, material)
        }
        Form::Disc { center, normal, radius } => {
            let disc = Disc { center: vector(center), normal: try_normalize(vector(normal))?, radius };
            tables.add_disc(disc, material)
        }
        Form::Cuboid { min, max } => {
            tables.add_cuboid(Cuboid { min: vector(min), max: vector(max) }, material)
        }
        Form::OrientedCuboid { center, half, first, third } => {
            let cuboid = OrientedCuboid::new(vector(center), vector(half), vector(first), vector(third))?;
            tables.add_turned_cuboid(cuboid, material)
        }
        Form::Cone { base, base_radius, end, end_radius, capped } => {
            let cone = Cone::new(vector(base), base_radius, vector(end), end_radius, capped)?;
            tables.add_cone(cone, material)
        }
        Form::Torus { center, axis, major, minor } => {
            let (center, axis) = (vector(center), try_normalize(vector(axis))?);
            let torus = Torus { center, axis, major_radius: major, minor_radius: minor };
            tables.add_torus(torus, material)
        }
        Form::Triangle { corners, .. } => tables.add_triangles(&[corners], Shading::Flat, material).start,
        Form::Polygon { first, count, .. } => {
            tables.add_polygon(first..first.checked_add(count)?, Shading::Flat, material).ok()?
        }
        Form::Mesh { .. } | Form::Nothing => return None,
    })
}
