//! An owned scene for tests.

use std::ops::{Deref, DerefMut};

use strahl_core::accel::{List, group_count};
use strahl_core::geometry::{
    Aabb, Cone, Cuboid, Disc, Hit, ItemId, OrientedCuboid, Ray, Torus, offset_origin,
};
use strahl_core::math::{ROUNDOFF, SobolSequence, try_normalize};
use strahl_core::scene::{CameraSample, FilmPoint, Shading};
use strahl_core::tally::{Counters, RayKind};
use strahl_core::{
    AllEffects, Camera, CameraDescriptor, Limits, Material, MaterialId, Projection, Real, Resolution, Rgb,
    Scene, SceneTables, Sphere, Tracer, Vec3, Worker, World, vec3,
};

use crate::{CoreHit, DVec3, TestRay, TestShape, TestedCore, dvec3};

/// An owned scene. Each shape that is added gets the current material, white [`Material::matte`] at first.
#[derive(Clone, Debug)]
pub struct TestScene {
    tables: SceneTables,
    /// Material of the shapes that are added next.
    current_material: MaterialId,
}

impl Default for TestScene {
    fn default() -> Self {
        let mut tables = SceneTables::new();
        let current_material = tables.add_material(Material::matte(Rgb::WHITE));
        TestScene { tables, current_material }
    }
}

impl Deref for TestScene {
    type Target = SceneTables;

    fn deref(&self) -> &SceneTables {
        &self.tables
    }
}

impl DerefMut for TestScene {
    fn deref_mut(&mut self) -> &mut SceneTables {
        &mut self.tables
    }
}

impl TestScene {
    /// An empty scene with a black background.
    pub fn new() -> Self {
        Self::default()
    }

    /// Sets the material of the shapes that are added next.
    pub fn material(&mut self, material: Material) -> MaterialId {
        self.current_material = self.tables.add_material(material);
        self.current_material
    }

    /// Adds a sphere.
    pub fn sphere(&mut self, center: Vec3, radius: Real) -> ItemId {
        self.tables.add_sphere(Sphere { center, radius }, self.current_material)
    }

    /// Adds a plane. `normal` may have any length.
    pub fn plane(&mut self, point: Vec3, normal: Vec3) -> ItemId {
        self.tables.add_plane(point, try_normalize(normal).unwrap(), self.current_material)
    }

    /// Adds a disc. `normal` may have any length.
    pub fn disc(&mut self, center: Vec3, normal: Vec3, radius: Real) -> ItemId {
        self.tables
            .add_disc(Disc { center, normal: try_normalize(normal).unwrap(), radius }, self.current_material)
    }

    /// Adds a flat triangle.
    pub fn triangle(&mut self, vertices: [Vec3; 3]) -> ItemId {
        self.tables.add_mesh(&vertices, &[], &[[0, 1, 2]], self.current_material).start
    }

    /// Adds a triangle with vertex normals, which may have any length.
    pub fn smooth_triangle(&mut self, vertices: [Vec3; 3], normals: [Vec3; 3]) -> ItemId {
        let normals = normals.map(|normal| try_normalize(normal).unwrap());
        self.tables.add_mesh(&vertices, &normals, &[[0, 1, 2]], self.current_material).start
    }

    /// Adds a polygon, smooth if `normals` is not empty. The normals may have any length.
    pub fn polygon(&mut self, vertices: &[Vec3], normals: &[Vec3]) -> ItemId {
        let shading = if normals.is_empty() { Shading::Flat } else { Shading::Smooth };
        let normals: Vec<Vec3> = normals.iter().map(|normal| try_normalize(*normal).unwrap()).collect();
        let first = self.tables.add_vertices(vertices, &normals);
        self.tables.add_polygon(first..first + vertices.len() as u32, shading, self.current_material).unwrap()
    }

    /// Adds an axis-aligned box.
    pub fn cuboid(&mut self, min: Vec3, max: Vec3) -> ItemId {
        self.tables.add_cuboid(Cuboid { min, max }, self.current_material)
    }

    /// Adds an oriented box.
    pub fn oriented_cuboid(&mut self, center: Vec3, half: Vec3, first: Vec3, third: Vec3) -> ItemId {
        let cuboid = OrientedCuboid::new(center, half, first, third).unwrap();
        self.tables.add_oriented_cuboid(cuboid, self.current_material)
    }

    /// Adds a cone or cylinder.
    pub fn cone(&mut self, cone: Cone) -> ItemId {
        self.tables.add_cone(cone, self.current_material)
    }

    /// Adds a torus. `axis` may have any length.
    pub fn torus(&mut self, center: Vec3, axis: Vec3, major: Real, minor: Real) -> ItemId {
        self.tables.add_torus(
            Torus { center, axis: try_normalize(axis).unwrap(), major_radius: major, minor_radius: minor },
            self.current_material,
        )
    }

    /// Removes the motion of all items.
    pub fn clear_motions(&mut self) {
        (0..self.item_count()).for_each(|item| self.tables.clear_motion(ItemId(item)));
    }

    /// Adds a test shape.
    pub fn add_shape(&mut self, shape: &TestShape) -> ItemId {
        let all = |vertices: &[DVec3]| vertices.iter().copied().map(narrow).collect::<Vec<_>>();
        match shape {
            TestShape::Sphere { center, radius } => self.sphere(narrow(*center), *radius as Real),
            TestShape::Plane { point, normal } => self.plane(narrow(*point), narrow(*normal)),
            TestShape::Disc { center, normal, radius } => {
                self.disc(narrow(*center), narrow(*normal), *radius as Real)
            }
            TestShape::Triangle { vertices } => self.triangle(vertices.map(narrow)),
            TestShape::SmoothTriangle { vertices, normals } => {
                self.smooth_triangle(vertices.map(narrow), normals.map(narrow))
            }
            TestShape::Polygon { vertices } => self.polygon(&all(vertices), &[]),
            TestShape::SmoothPolygon { vertices, normals } => self.polygon(&all(vertices), &all(normals)),
            TestShape::Cuboid { min, max } => self.cuboid(narrow(*min), narrow(*max)),
            TestShape::OrientedCuboid { center, half, first, third } => {
                self.oriented_cuboid(narrow(*center), narrow(*half), narrow(*first), narrow(*third))
            }
            TestShape::Cone { base, base_radius, end, end_radius, capped } => self.cone(
                Cone::new(narrow(*base), *base_radius as Real, narrow(*end), *end_radius as Real, *capped)
                    .unwrap(),
            ),
            TestShape::Torus { center, axis, major, minor } => {
                self.torus(narrow(*center), narrow(*axis), *major as Real, *minor as Real)
            }
        }
    }

    /// Number of items.
    pub fn item_count(&self) -> u32 {
        self.tables.item_count() as u32
    }

    /// The scene that borrows these tables.
    pub fn as_scene(&self) -> Scene<'_> {
        self.tables.scene().unwrap()
    }

    /// Mean color of `n` camera rays from `viewpoint` to `target` that differ only in their random numbers.
    pub fn trace_samples(
        &self,
        viewpoint: Vec3,
        target: Vec3,
        limits: Limits,
        n: u32,
        seed: u32,
    ) -> [f64; 3] {
        let world = World::new(self.as_scene(), List::without_bounds(self.item_count()));
        let tracer =
            Tracer::<_, AllEffects, 64>::new(&world, one_ray_camera(viewpoint, target), limits).unwrap();
        let mut worker = Worker::new(());
        let mut sum = [0.0; 3];
        for index in 0..n {
            let sample = CameraSample {
                point: FilmPoint { x: 0.5, y: 0.5 },
                sequence: SobolSequence::new(7, 5, index, seed),
            };
            let color = tracer.trace(sample, &mut worker).color;
            #[allow(clippy::useless_conversion)] // where `Real` is f64
            for (sum, channel) in sum.iter_mut().zip([color.r, color.g, color.b]) {
                *sum += f64::from(channel) / f64::from(n);
            }
        }
        sum
    }

    /// Color of the ray from `viewpoint` to `target`, traced with a list without bounds.
    pub fn trace(&self, viewpoint: Vec3, target: Vec3, limits: Limits) -> Rgb {
        self.trace_counted(viewpoint, target, limits).0
    }

    /// Color of the ray from `viewpoint` to `target`, and the counters of tracing it.
    pub fn trace_counted(&self, viewpoint: Vec3, target: Vec3, limits: Limits) -> (Rgb, Counters) {
        let world = World::new(self.as_scene(), List::without_bounds(self.item_count()));
        let tracer =
            Tracer::<_, AllEffects, 64>::new(&world, one_ray_camera(viewpoint, target), limits).unwrap();
        let mut worker = Worker::new(Counters::new());
        let sample =
            CameraSample { point: FilmPoint { x: 0.5, y: 0.5 }, sequence: SobolSequence::new(0, 0, 0, 0) };
        let color = tracer.trace(sample, &mut worker).color;
        assert!(color.is_in_range(Real::MAX), "{color:?} is not a color");
        (color, worker.into_tally())
    }
}

/// Camera of a picture of one pixel whose central ray runs from `viewpoint` to `target`. It is orthographic, so
/// that the ray starts at `viewpoint` exactly.
fn one_ray_camera(viewpoint: Vec3, target: Vec3) -> Camera {
    let direction = target - viewpoint;
    let up = if direction.x.abs() < direction.y.abs() { Vec3::X } else { Vec3::Y };
    let projection = Projection::Orthographic { height: 1.0 };
    let view = CameraDescriptor { position: viewpoint, target, up, projection };
    Camera::new(&view, Resolution::new(1, 1).unwrap()).unwrap()
}

/// Converts to the core's `Real`; exact for numbers of `SplitMix64`.
fn narrow(v: DVec3) -> Vec3 {
    vec3(v.x as Real, v.y as Real, v.z as Real)
}

#[allow(clippy::useless_conversion)] // where `Real` is f64
fn wide(v: Vec3) -> DVec3 {
    dvec3(v.x.into(), v.y.into(), v.z.into())
}

impl TestedCore for TestScene {
    #[allow(clippy::unnecessary_cast)] // where `Real` is f64
    const ROUNDOFF: f64 = ROUNDOFF as f64;
    const NAME: &'static str = if cfg!(feature = "double") { "double" } else { "single" };

    fn with_shapes(shapes: &[TestShape]) -> Self {
        let mut scene = TestScene::new();
        for shape in shapes {
            scene.add_shape(shape);
        }
        scene
    }

    fn cast(&self, rays: &[TestRay]) -> Vec<Option<CoreHit>> {
        let unbounded = World::new(self.as_scene(), List::without_bounds(self.item_count()));
        let boxes = self.bounds();
        let mut groups = vec![Aabb::EMPTY; group_count(boxes.len())];
        let bounded = World::new(self.as_scene(), List::with_boxes(&boxes, &mut groups).unwrap());

        #[allow(clippy::useless_conversion)] // where `Real` is f64
        let cast = |ray: &TestRay| {
            let core_ray = Ray::new(narrow(ray.origin), narrow(ray.direction));
            let hit = unbounded.nearest_hit::<AllEffects, _>(
                &core_ray,
                Real::INFINITY,
                RayKind::Camera,
                &mut (),
                &mut (),
            );
            let other_hit = bounded.nearest_hit::<AllEffects, _>(
                &core_ray,
                Real::INFINITY,
                RayKind::Camera,
                &mut (),
                &mut (),
            );
            let bits = |hit: Hit| (hit.item, hit.t.to_bits());
            assert_eq!(hit.map(bits), other_hit.map(bits), "with boxes: {ray:?}");
            let hit = hit?;
            let surface = unbounded.surface_interaction::<AllEffects>(&core_ray, hit);
            assert_eq!(surface, bounded.surface_interaction::<AllEffects>(&core_ray, hit));
            let surface = surface.expect("a hit has a surface");
            Some(CoreHit {
                item: hit.item.0,
                t: hit.t.into(),
                point: wide(surface.point),
                error: wide(surface.point_error),
                normal: wide(surface.normal),
                shading: wide(surface.shading_normal),
            })
        };
        rays.iter().map(cast).collect()
    }

    fn offset_origin(hit: &CoreHit, side: DVec3) -> DVec3 {
        wide(offset_origin(narrow(hit.point), narrow(hit.error), narrow(side)))
    }
}
