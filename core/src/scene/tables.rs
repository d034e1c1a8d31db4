//! An owned scene, for programs with a heap.
//!
//! Tables grow as shapes, materials, textures and lights are added. Adding an entry returns its index, with
//! which other entries refer to it. [`SceneTables::scene`] checks all tables and borrows the [`Scene`].

use alloc::vec::Vec;
use core::ops::Range;

use super::{
    Background, Light, Material, MaterialId, Scene, SceneDescriptor, SceneError, Shading, Texture, TextureId,
};
use crate::geometry::{
    Aabb, Cone, Cuboid, Disc, Geometry, ItemId, MovingShape, OrientedCuboid, Plane, Polygon, Shape,
    ShapeError, Sphere, Torus,
};
use crate::math::{Rgb, Vec3};

/// An owned scene: tables that grow. Requires the feature `alloc`.
///
/// Entries are checked by [`SceneTables::scene`], not when they are added (but a polygon is checked when it is
/// added, too). All positions and directions are
/// in world space; normals and axes are unit vectors.
///
/// ```
/// use strahl_core::{ListWithoutBounds, Material, Rgb, SceneTables, Sphere, World, vec3};
///
/// let mut tables = SceneTables::new();
/// let red = tables.add_material(Material::matte(Rgb::new(0.8, 0.1, 0.1)));
/// let ball = tables.add_sphere(Sphere { center: vec3(0.0, 1.0, 0.0), radius: 1.0 }, red);
/// let floor = tables.add_plane(vec3(0.0, 0.0, 0.0), vec3(0.0, 1.0, 0.0), red);
/// assert_eq!((ball.0, floor.0), (0, 1));
///
/// let scene = tables.scene()?;
/// assert_eq!(scene.descriptor().geometry.shapes.len(), 2);
/// let world = World::new(scene, ListWithoutBounds(tables.item_count() as u32));
/// # Ok::<(), strahl_core::scene::SceneError>(())
/// ```
#[derive(Clone, Debug)]
pub struct SceneTables {
    shapes: Vec<Shape>,
    vertices: Vec<Vec3>,
    vertex_normals: Vec<Vec3>,
    planes: Vec<Plane>,
    discs: Vec<Disc>,
    polygons: Vec<Polygon>,
    cuboids: Vec<Cuboid>,
    oriented_cuboids: Vec<OrientedCuboid>,
    cones: Vec<Cone>,
    tori: Vec<Torus>,
    moving_shapes: Vec<MovingShape>,
    material_ids: Vec<MaterialId>,
    materials: Vec<Material>,
    textures: Vec<Texture>,
    /// Lights.
    pub lights: Vec<Light>,
    /// Ambient light, which arrives at every surface from all directions.
    pub ambient: Rgb,
    /// Radiance of rays that hit no item.
    pub background: Background,
    /// Whether shadow rays pass through transmitting bodies ([`SceneDescriptor::colored_shadows`]).
    pub colored_shadows: bool,
}

impl Default for SceneTables {
    fn default() -> Self {
        Self::new()
    }
}

impl SceneTables {
    /// An empty, black scene.
    pub const fn new() -> Self {
        SceneTables {
            shapes: Vec::new(),
            vertices: Vec::new(),
            vertex_normals: Vec::new(),
            planes: Vec::new(),
            discs: Vec::new(),
            polygons: Vec::new(),
            cuboids: Vec::new(),
            oriented_cuboids: Vec::new(),
            cones: Vec::new(),
            tori: Vec::new(),
            moving_shapes: Vec::new(),
            material_ids: Vec::new(),
            materials: Vec::new(),
            textures: Vec::new(),
            lights: Vec::new(),
            ambient: Rgb::BLACK,
            background: SceneDescriptor::EMPTY.background,
            colored_shadows: false,
        }
    }

    /// Adds a material and returns its id, for the shapes that have it.
    pub fn add_material(&mut self, material: Material) -> MaterialId {
        MaterialId(push(&mut self.materials, material) as u16)
    }

    /// All materials, by [`MaterialId`], to be changed.
    pub fn materials_mut(&mut self) -> &mut [Material] {
        &mut self.materials
    }

    /// Adds a texture and returns its id, for [`Material::texture`].
    pub fn add_texture(&mut self, texture: Texture) -> TextureId {
        TextureId(push(&mut self.textures, texture) as u16)
    }

    /// Adds a light. Returns its index in [`SceneTables::lights`].
    pub fn add_light(&mut self, light: Light) -> usize {
        push(&mut self.lights, light) as usize
    }

    /// Adds a sphere and returns its item.
    pub fn add_sphere(&mut self, sphere: Sphere, material: MaterialId) -> ItemId {
        self.add_shape(Shape::Sphere(sphere), material)
    }

    /// Adds an infinite plane through `point` and returns its item. `normal`: unit vector.
    pub fn add_plane(&mut self, point: Vec3, normal: Vec3, material: MaterialId) -> ItemId {
        let item = self.next_item();
        let plane = push(&mut self.planes, Plane { point, normal, item });
        self.add_shape(Shape::Plane(plane), material)
    }

    /// Adds a disc and returns its item.
    pub fn add_disc(&mut self, disc: Disc, material: MaterialId) -> ItemId {
        let disc = push(&mut self.discs, disc);
        self.add_shape(Shape::Disc(disc), material)
    }

    /// Adds an axis-aligned box and returns its item.
    pub fn add_cuboid(&mut self, cuboid: Cuboid, material: MaterialId) -> ItemId {
        let cuboid = push(&mut self.cuboids, cuboid);
        self.add_shape(Shape::Cuboid(cuboid), material)
    }

    /// Adds an oriented box and returns its item.
    pub fn add_oriented_cuboid(&mut self, cuboid: OrientedCuboid, material: MaterialId) -> ItemId {
        let cuboid = push(&mut self.oriented_cuboids, cuboid);
        self.add_shape(Shape::OrientedCuboid(cuboid), material)
    }

    /// Adds a cone or cylinder and returns its item.
    pub fn add_cone(&mut self, cone: Cone, material: MaterialId) -> ItemId {
        let cone = push(&mut self.cones, cone);
        self.add_shape(Shape::Cone(cone), material)
    }

    /// Adds a torus and returns its item.
    pub fn add_torus(&mut self, torus: Torus, material: MaterialId) -> ItemId {
        let torus = push(&mut self.tori, torus);
        self.add_shape(Shape::Torus(torus), material)
    }

    /// Adds vertices for triangles and polygons, and returns the index of the first.
    ///
    /// `normals`: unit vectors for the first of the vertices, or none. Smooth triangles and polygons need a
    /// normal for each of their vertices.
    pub fn add_vertices(&mut self, vertices: &[Vec3], normals: &[Vec3]) -> u32 {
        let first = self.vertices.len();
        self.vertices.extend_from_slice(vertices);
        if !normals.is_empty() {
            // Normals have the indices of their vertices.
            self.vertex_normals.resize(first, Vec3::Z);
            self.vertex_normals.extend_from_slice(normals);
        }
        first as u32
    }

    /// Adds triangles by the indices of their vertices ([`SceneTables::add_vertices`]).
    pub fn add_triangles(
        &mut self,
        triangles: &[[u32; 3]],
        shading: Shading,
        material: MaterialId,
    ) -> Range<ItemId> {
        self.add_triangles_from(0, triangles, shading, material)
    }

    /// Adds triangles whose vertex indices are relative to `first`.
    fn add_triangles_from(
        &mut self,
        first: u32,
        triangles: &[[u32; 3]],
        shading: Shading,
        material: MaterialId,
    ) -> Range<ItemId> {
        let start = self.next_item();
        let shape = match shading {
            Shading::Flat => Shape::Triangle,
            Shading::Smooth => Shape::SmoothTriangle,
        };
        // Saturates, so that an index that is out of range stays out of range.
        let indices = triangles.iter().map(|vertices| vertices.map(|vertex| first.saturating_add(vertex)));
        self.shapes.extend(indices.map(shape));
        self.material_ids.resize(self.shapes.len(), material);
        start..self.next_item()
    }

    /// Adds a planar polygon by the indices of its vertices ([`SceneTables::add_vertices`]). It may be
    /// concave. Seen from the side of its normal, the vertices run counterclockwise.
    ///
    /// # Errors
    ///
    /// [`ShapeError::IndexOutOfRange`] if a vertex is missing, if there are fewer than three, or if the area is
    /// zero.
    pub fn add_polygon(
        &mut self,
        vertices: Range<u32>,
        shading: Shading,
        material: MaterialId,
    ) -> Result<ItemId, ShapeError> {
        let own = self.vertices.get(vertices.start as usize..vertices.end as usize);
        let polygon = own.and_then(|own| Polygon::new(vertices.start, own, shading == Shading::Smooth));
        let polygon = push(&mut self.polygons, polygon.ok_or(ShapeError::IndexOutOfRange)?);
        Ok(self.add_shape(Shape::Polygon(polygon), material))
    }

    /// Adds a triangle mesh with its own vertices; `triangles` are indices into `vertices`.
    ///
    /// `normals`: one unit vector for each vertex, for smooth shading; or none, for flat shading.
    pub fn add_mesh(
        &mut self,
        vertices: &[Vec3],
        normals: &[Vec3],
        triangles: &[[u32; 3]],
        material: MaterialId,
    ) -> Range<ItemId> {
        let first = self.add_vertices(vertices, normals);
        let shading = if normals.is_empty() { Shading::Flat } else { Shading::Smooth };
        self.add_triangles_from(first, triangles, shading, material)
    }

    /// Moves an item along a straight line while the shutter is open, between these offsets from its
    /// position. Unit: scene lengths, world space.
    ///
    /// Does nothing if there is no such item.
    pub fn set_motion(&mut self, item: ItemId, offset_at_open: Vec3, offset_at_close: Vec3) {
        self.clear_motion(item);
        if let Some(shape) = self.shapes.get_mut(item.0 as usize) {
            let moving =
                push(&mut self.moving_shapes, MovingShape { shape: *shape, offset_at_open, offset_at_close });
            *shape = Shape::Moving(moving);
        }
    }

    /// Removes the motion of an item. Does nothing if it does not move, or if there is no such item.
    pub fn clear_motion(&mut self, item: ItemId) {
        let shape = self.shapes.get_mut(item.0 as usize);
        if let Some(shape) = shape
            && let Shape::Moving(index) = *shape
            && let Some(moving) = self.moving_shapes.get(index as usize)
        {
            *shape = moving.shape;
        }
    }

    /// Number of items.
    pub fn item_count(&self) -> usize {
        self.shapes.len()
    }

    /// Bounds of all items, from which accelerators are built ([`Geometry::all_bounds`]).
    pub fn bounds(&self) -> Vec<Aabb> {
        self.descriptor().geometry.all_bounds().collect()
    }

    /// Borrows the tables without checking them.
    pub fn descriptor(&self) -> SceneDescriptor<'_> {
        SceneDescriptor {
            geometry: Geometry {
                shapes: &self.shapes,
                vertices: &self.vertices,
                vertex_normals: &self.vertex_normals,
                planes: &self.planes,
                discs: &self.discs,
                polygons: &self.polygons,
                cuboids: &self.cuboids,
                oriented_cuboids: &self.oriented_cuboids,
                cones: &self.cones,
                tori: &self.tori,
                moving_shapes: &self.moving_shapes,
            },
            material_ids: &self.material_ids,
            materials: &self.materials,
            textures: &self.textures,
            lights: &self.lights,
            ambient: self.ambient,
            background: self.background,
            colored_shadows: self.colored_shadows,
        }
    }

    /// Checks the tables and borrows them as a scene.
    ///
    /// # Errors
    ///
    /// The first entry that is out of range or refers to a missing entry, as for [`Scene::new`].
    pub fn scene(&self) -> Result<Scene<'_>, SceneError> {
        Scene::new(self.descriptor())
    }

    fn next_item(&self) -> ItemId {
        ItemId(self.shapes.len() as u32)
    }

    fn add_shape(&mut self, shape: Shape, material: MaterialId) -> ItemId {
        let item = self.next_item();
        self.shapes.push(shape);
        self.material_ids.push(material);
        item
    }
}

/// Appends an entry and returns its index.
fn push<T>(table: &mut Vec<T>, entry: T) -> u32 {
    let index = table.len() as u32;
    table.push(entry);
    index
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::vec3;

    const VERTICES: [Vec3; 4] = [Vec3::ZERO, vec3(1.0, 0.0, 0.0), vec3(1.0, 1.0, 0.0), vec3(0.0, 1.0, 0.0)];
    const SPHERE: Sphere = Sphere { center: Vec3::ZERO, radius: 1.0 };

    #[test]
    fn every_kind_of_shape_can_be_added() {
        let mut tables = SceneTables::new();
        let matte = tables.add_material(Material::MATTE);
        tables.add_plane(Vec3::ZERO, Vec3::Y, matte);
        tables.add_sphere(SPHERE, matte);
        tables.add_disc(Disc { center: Vec3::ZERO, normal: Vec3::Y, radius: 1.0 }, matte);
        tables.add_cuboid(Cuboid { min: Vec3::ZERO, max: Vec3::ONE }, matte);
        tables.add_oriented_cuboid(
            OrientedCuboid::new(Vec3::ZERO, Vec3::ONE, Vec3::X, Vec3::Z).unwrap(),
            matte,
        );
        tables.add_cone(Cone::new(Vec3::ZERO, 1.0, Vec3::Y, 0.5, true).unwrap(), matte);
        tables.add_torus(
            Torus { center: Vec3::ZERO, axis: Vec3::Y, major_radius: 1.0, minor_radius: 0.25 },
            matte,
        );
        tables.add_mesh(&VERTICES, &[], &[[0, 1, 2], [0, 2, 3]], matte);
        let smooth = tables.add_mesh(&VERTICES, &[Vec3::Z; 4], &[[0, 1, 2]], matte);
        let first = tables.add_vertices(&VERTICES, &[]);
        tables.add_polygon(first..first + 4, Shading::Flat, matte).unwrap();
        tables.set_motion(smooth.start, Vec3::ZERO, Vec3::X);
        assert_eq!(tables.item_count(), 11);
        let effects = tables.scene().unwrap().required_effects();
        assert_eq!(effects.shapes, crate::geometry::ShapeKindSet::ALL);
        assert!(effects.motion_blur && effects.smooth_shading);
    }

    #[test]
    fn indices_of_a_mesh_are_relative_to_its_vertices() {
        let mut tables = SceneTables::new();
        let matte = tables.add_material(Material::MATTE);
        let a = tables.add_mesh(&VERTICES, &[], &[[0, 1, 2]], matte);
        let b = tables.add_mesh(&VERTICES, &[Vec3::Z; 4], &[[0, 1, 2], [0, 2, 3]], matte);
        assert_eq!((a, b), (ItemId(0)..ItemId(1), ItemId(1)..ItemId(3)));
        let shapes = tables.descriptor().geometry.shapes;
        assert_eq!(shapes[1], Shape::SmoothTriangle([4, 5, 6]));
        tables.scene().unwrap();
    }

    #[test]
    fn an_index_out_of_range_is_an_error() {
        let mut tables = SceneTables::new();
        let item = tables.add_sphere(SPHERE, MaterialId(3));
        assert_eq!(tables.scene().unwrap_err(), SceneError::MissingMaterial(item));
        let mut tables = SceneTables::new();
        let matte = tables.add_material(Material::MATTE);
        let mesh = tables.add_mesh(&VERTICES, &[], &[[0, 1, 4]], matte);
        assert_eq!(tables.scene().unwrap_err(), SceneError::Shape(mesh.start, ShapeError::IndexOutOfRange));
        assert_eq!(tables.add_polygon(2..5, Shading::Flat, matte), Err(ShapeError::IndexOutOfRange));
    }

    #[test]
    fn motion_can_be_replaced_and_removed() {
        let mut tables = SceneTables::new();
        let matte = tables.add_material(Material::MATTE);
        let item = tables.add_sphere(SPHERE, matte);
        tables.set_motion(item, Vec3::X, Vec3::Y);
        tables.set_motion(item, Vec3::ZERO, Vec3::Z);
        assert!(tables.scene().unwrap().required_effects().motion_blur);
        tables.clear_motion(item);
        assert_eq!(tables.descriptor().geometry.shapes, [Shape::Sphere(SPHERE)]);
        tables.set_motion(ItemId(7), Vec3::X, Vec3::Y);
        assert!(!tables.scene().unwrap().required_effects().motion_blur);
    }
}
