//! A scene with tables of its own, for the core that the room above names `strahl`.

use std::ops::{Deref, DerefMut};

use super::strahl::accel::{List, group_count};
use super::strahl::geometry::{
    Aabb, Cone, Cuboid, Disc, Hit, ItemId, OrientedCuboid, Ray, Torus, offset_origin,
};
use super::strahl::math::{ROUNDOFF, SobolSequence, try_normalize};
use super::strahl::scene::{CameraSample, FilmPoint, Shading};
use super::strahl::tally::{Counters, RayKind};
use super::strahl::{
    AllEffects, Camera, Limits, Material, MaterialId, Projection, Real, Resolution, Rgb, Scene, SceneTables,
    Sphere, Tracer, Vec3, View, Worker, World, vec3,
};
use crate::cast::{CoreHit, TestedCore};
use crate::test_shape::{TestRay, TestShape};
use crate::vector::{DVec3, dvec3};

/// A scene with tables of its own. Things are put on it one by one, each made of the material
/// that was named last: [`Material::MATTE`] at first.
#[derive(Clone, Debug)]
pub struct TestScene {
    tables: SceneTables,
    /// The material of what comes next.
    made_of: MaterialId,
}

impl Default for TestScene {
    fn default() -> Self {
        let mut tables = SceneTables::new();
        let made_of = tables.add_material(Material::MATTE);
        TestScene { tables, made_of }
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
    /// Empty, dark space.
    pub fn new() -> Self {
        Self::default()
    }

    /// Names the material of everything that comes next.
    pub fn material(&mut self, material: Material) -> MaterialId {
        self.made_of = self.tables.add_material(material);
        self.made_of
    }

    /// A sphere.
    pub fn sphere(&mut self, center: Vec3, radius: Real) -> ItemId {
        self.tables.add_sphere(Sphere { center, radius }, self.made_of)
    }

    /// A plane. `normal` may have any length.
    pub fn plane(&mut self, point: Vec3, normal: Vec3) -> ItemId {
        self.tables.add_plane(point, try_normalize(normal).unwrap(), self.made_of)
    }

    /// A disc. `normal` may have any length.
    pub fn disc(&mut self, center: Vec3, normal: Vec3, radius: Real) -> ItemId {
        self.tables.add_disc(Disc { center, normal: try_normalize(normal).unwrap(), radius }, self.made_of)
    }

    /// A flat triangle.
    pub fn triangle(&mut self, corners: [Vec3; 3]) -> ItemId {
        self.tables.add_mesh(&corners, &[], &[[0, 1, 2]], self.made_of).start
    }

    /// A smooth triangle. The normals may have any length.
    pub fn smooth_triangle(&mut self, corners: [Vec3; 3], normals: [Vec3; 3]) -> ItemId {
        let normals = normals.map(|normal| try_normalize(normal).unwrap());
        self.tables.add_mesh(&corners, &normals, &[[0, 1, 2]], self.made_of).start
    }

    /// A polygon: smooth when there are normals, which may have any length.
    pub fn polygon(&mut self, corners: &[Vec3], normals: &[Vec3]) -> ItemId {
        let shading = if normals.is_empty() { Shading::Flat } else { Shading::Smooth };
        let normals: Vec<Vec3> = normals.iter().map(|normal| try_normalize(*normal).unwrap()).collect();
        let first = self.tables.add_vertices(corners, &normals);
        self.tables.add_polygon(first..first + corners.len() as u32, shading, self.made_of).unwrap()
    }

    /// An upright box.
    pub fn cuboid(&mut self, min: Vec3, max: Vec3) -> ItemId {
        self.tables.add_cuboid(Cuboid { min, max }, self.made_of)
    }

    /// A turned box.
    pub fn oriented_cuboid(&mut self, center: Vec3, half: Vec3, first: Vec3, third: Vec3) -> ItemId {
        let cuboid = OrientedCuboid::new(center, half, first, third).unwrap();
        self.tables.add_turned_cuboid(cuboid, self.made_of)
    }

    /// A cone or cylinder.
    pub fn cone(&mut self, cone: Cone) -> ItemId {
        self.tables.add_cone(cone, self.made_of)
    }

    /// A torus. `axis` may have any length.
    pub fn torus(&mut self, center: Vec3, axis: Vec3, major: Real, minor: Real) -> ItemId {
        self.tables.add_torus(
            Torus { center, axis: try_normalize(axis).unwrap(), major_radius: major, minor_radius: minor },
            self.made_of,
        )
    }

    /// Lets everything stand in its place.
    pub fn clear_motions(&mut self) {
        (0..self.item_count()).for_each(|item| self.tables.clear_motion(ItemId(item)));
    }

    /// Any thing.
    pub fn add_shape(&mut self, shape: &TestShape) -> ItemId {
        let all = |corners: &[DVec3]| corners.iter().copied().map(narrow).collect::<Vec<_>>();
        match shape {
            TestShape::Sphere { center, radius } => self.sphere(narrow(*center), *radius as Real),
            TestShape::Plane { point, normal } => self.plane(narrow(*point), narrow(*normal)),
            TestShape::Disc { center, normal, radius } => {
                self.disc(narrow(*center), narrow(*normal), *radius as Real)
            }
            TestShape::Triangle { corners } => self.triangle(corners.map(narrow)),
            TestShape::SmoothTriangle { corners, normals } => {
                self.smooth_triangle(corners.map(narrow), normals.map(narrow))
            }
            TestShape::Polygon { corners } => self.polygon(&all(corners), &[]),
            TestShape::SmoothPolygon { corners, normals } => self.polygon(&all(corners), &all(normals)),
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

    /// How many items there are.
    pub fn item_count(&self) -> u32 {
        self.tables.len() as u32
    }

    /// The scene.
    pub fn as_scene(&self) -> Scene<'_> {
        self.tables.scene().unwrap()
    }

    /// The mean of what `n` camera rays see that differ in nothing but what they leave to chance.
    pub fn trace_samples(&self, eye: Vec3, target: Vec3, limits: Limits, n: u32, seed: u32) -> [f64; 3] {
        let world = World::new(self.as_scene(), List::without_bounds(self.item_count()));
        let tracer = Tracer::<_, AllEffects, 64>::new(&world, straight(eye, target), limits).unwrap();
        let mut worker = Worker::new(());
        let mut sum = [0.0; 3];
        for index in 0..n {
            let sample = CameraSample {
                point: FilmPoint { x: 0.5, y: 0.5 },
                stream: SobolSequence::new(7, 5, index, seed),
            };
            let color = tracer.trace(sample, &mut worker).color;
            #[allow(clippy::useless_conversion)] // in the twin
            for (sum, channel) in sum.iter_mut().zip([color.r, color.g, color.b]) {
                *sum += f64::from(channel) / f64::from(n);
            }
        }
        sum
    }

    /// What arrives at `eye` from the direction of `target`, by the bare list.
    pub fn trace(&self, eye: Vec3, target: Vec3, limits: Limits) -> Rgb {
        self.trace_counted(eye, target, limits).0
    }

    /// The same, and what it took.
    pub fn trace_counted(&self, eye: Vec3, target: Vec3, limits: Limits) -> (Rgb, Counters) {
        let world = World::new(self.as_scene(), List::without_bounds(self.item_count()));
        let tracer = Tracer::<_, AllEffects, 64>::new(&world, straight(eye, target), limits).unwrap();
        let mut worker = Worker::new(Counters::new());
        let sample =
            CameraSample { point: FilmPoint { x: 0.5, y: 0.5 }, stream: SobolSequence::new(0, 0, 0, 0) };
        let color = tracer.trace(sample, &mut worker).color;
        assert!(color.is_in_range(Real::MAX), "{color:?} is no light");
        (color, worker.into_tally())
    }
}

/// The camera of a picture of one pixel, whose middle is the ray from `eye` to `target`: all its
/// rays are parallel, so that this one starts in the eye.
fn straight(eye: Vec3, target: Vec3) -> Camera {
    let way = target - eye;
    let up = if way.x.abs() < way.y.abs() { Vec3::X } else { Vec3::Y };
    let projection = Projection::Orthographic { height: 1.0 };
    let view = View { from: eye, at: target, up, projection };
    Camera::new(&view, Resolution::new(1, 1).unwrap()).unwrap()
}

/// To the core's own numbers; exact for what [`crate::SplitMix64`] gives.
fn narrow(v: DVec3) -> Vec3 {
    vec3(v.x as Real, v.y as Real, v.z as Real)
}

#[allow(clippy::useless_conversion)] // in the twin
fn wide(v: Vec3) -> DVec3 {
    dvec3(v.x.into(), v.y.into(), v.z.into())
}

impl TestedCore for TestScene {
    #[allow(clippy::unnecessary_cast)] // in the twin
    const ROUNDOFF: f64 = ROUNDOFF as f64;
    const NAME: &'static str = super::NAME;

    fn with_shapes(shapes: &[TestShape]) -> Self {
        let mut scene = TestScene::new();
        for shape in shapes {
            scene.add_shape(shape);
        }
        scene
    }

    fn cast(&self, rays: &[TestRay]) -> Vec<Option<CoreHit>> {
        let bare = World::new(self.as_scene(), List::without_bounds(self.item_count()));
        let boxes = self.bounds();
        let mut groups = vec![Aabb::EMPTY; group_count(boxes.len())];
        let boxed = World::new(self.as_scene(), List::with_boxes(&boxes, &mut groups).unwrap());

        #[allow(clippy::useless_conversion)] // in the twin
        let cast = |ray: &TestRay| {
            let core_ray = Ray::new(narrow(ray.origin), narrow(ray.direction));
            let hit =
                bare.nearest::<AllEffects, _>(&core_ray, Real::INFINITY, RayKind::Camera, &mut (), &mut ());
            let other =
                boxed.nearest::<AllEffects, _>(&core_ray, Real::INFINITY, RayKind::Camera, &mut (), &mut ());
            let bits = |hit: Hit| (hit.item, hit.t.to_bits());
            assert_eq!(hit.map(bits), other.map(bits), "with boxes: {ray:?}");
            let hit = hit?;
            let surface = bare.surface::<AllEffects>(&core_ray, hit);
            assert_eq!(surface, boxed.surface::<AllEffects>(&core_ray, hit));
            let surface = surface.expect("what was hit has a surface");
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
