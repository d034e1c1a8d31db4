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
use crate::cast::{Core, Found};
use crate::thing::{Line, Thing};
use crate::vector::{Vector, vector};

/// A scene with tables of its own. Things are put on it one by one, each made of the material
/// that was named last: [`Material::MATTE`] at first.
#[derive(Clone, Debug)]
pub struct Stage {
    tables: SceneTables,
    /// The material of what comes next.
    made_of: MaterialId,
}

impl Default for Stage {
    fn default() -> Self {
        let mut tables = SceneTables::new();
        let made_of = tables.add_material(Material::MATTE);
        Stage { tables, made_of }
    }
}

impl Deref for Stage {
    type Target = SceneTables;

    fn deref(&self) -> &SceneTables {
        &self.tables
    }
}

impl DerefMut for Stage {
    fn deref_mut(&mut self) -> &mut SceneTables {
        &mut self.tables
    }
}

impl Stage {
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
    pub fn turned_cuboid(&mut self, center: Vec3, half: Vec3, first: Vec3, third: Vec3) -> ItemId {
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
    pub fn stand_still(&mut self) {
        (0..self.item_count()).for_each(|item| self.tables.clear_motion(ItemId(item)));
    }

    /// Any thing.
    pub fn thing(&mut self, thing: &Thing) -> ItemId {
        let all = |corners: &[Vector]| corners.iter().copied().map(narrow).collect::<Vec<_>>();
        match thing {
            Thing::Sphere { center, radius } => self.sphere(narrow(*center), *radius as Real),
            Thing::Plane { point, normal } => self.plane(narrow(*point), narrow(*normal)),
            Thing::Disc { center, normal, radius } => {
                self.disc(narrow(*center), narrow(*normal), *radius as Real)
            }
            Thing::Triangle { corners } => self.triangle(corners.map(narrow)),
            Thing::SmoothTriangle { corners, normals } => {
                self.smooth_triangle(corners.map(narrow), normals.map(narrow))
            }
            Thing::Polygon { corners } => self.polygon(&all(corners), &[]),
            Thing::SmoothPolygon { corners, normals } => self.polygon(&all(corners), &all(normals)),
            Thing::Cuboid { min, max } => self.cuboid(narrow(*min), narrow(*max)),
            Thing::OrientedCuboid { center, half, first, third } => {
                self.turned_cuboid(narrow(*center), narrow(*half), narrow(*first), narrow(*third))
            }
            Thing::Cone { base, base_radius, end, end_radius, capped } => self.cone(
                Cone::new(narrow(*base), *base_radius as Real, narrow(*end), *end_radius as Real, *capped)
                    .unwrap(),
            ),
            Thing::Torus { center, axis, major, minor } => {
                self.torus(narrow(*center), narrow(*axis), *major as Real, *minor as Real)
            }
        }
    }

    /// How many items there are.
    pub fn item_count(&self) -> u32 {
        self.tables.len() as u32
    }

    /// The scene.
    pub fn scene(&self) -> Scene<'_> {
        self.tables.scene().unwrap()
    }

    /// The mean of what `n` camera rays see that differ in nothing but what they leave to chance.
    pub fn look_often(&self, eye: Vec3, target: Vec3, limits: Limits, n: u32, seed: u32) -> [f64; 3] {
        let world = World::new(self.scene(), List::without_bounds(self.item_count()));
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
    pub fn look(&self, eye: Vec3, target: Vec3, limits: Limits) -> Rgb {
        self.look_and_count(eye, target, limits).0
    }

    /// The same, and what it took.
    pub fn look_and_count(&self, eye: Vec3, target: Vec3, limits: Limits) -> (Rgb, Counters) {
        let world = World::new(self.scene(), List::without_bounds(self.item_count()));
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

/// To the core's own numbers; exact for what [`crate::Random`] gives.
fn narrow(v: Vector) -> Vec3 {
    vec3(v.x as Real, v.y as Real, v.z as Real)
}

#[allow(clippy::useless_conversion)] // in the twin
fn wide(v: Vec3) -> Vector {
    vector(v.x.into(), v.y.into(), v.z.into())
}

impl Core for Stage {
    #[allow(clippy::unnecessary_cast)] // in the twin
    const ROUNDOFF: f64 = ROUNDOFF as f64;
    const NAME: &'static str = super::NAME;

    fn with(things: &[Thing]) -> Self {
        let mut stage = Stage::new();
        for thing in things {
            stage.thing(thing);
        }
        stage
    }

    fn cast(&self, rays: &[Line]) -> Vec<Option<Found>> {
        let bare = World::new(self.scene(), List::without_bounds(self.item_count()));
        let boxes = self.bounds();
        let mut groups = vec![Aabb::EMPTY; group_count(boxes.len())];
        let boxed = World::new(self.scene(), List::with_boxes(&boxes, &mut groups).unwrap());

        #[allow(clippy::useless_conversion)] // in the twin
        let cast = |line: &Line| {
            let ray = Ray::new(narrow(line.origin), narrow(line.direction));
            let hit = bare.nearest::<AllEffects, _>(&ray, Real::INFINITY, RayKind::Camera, &mut (), &mut ());
            let other =
                boxed.nearest::<AllEffects, _>(&ray, Real::INFINITY, RayKind::Camera, &mut (), &mut ());
            let bits = |hit: Hit| (hit.item, hit.t.to_bits());
            assert_eq!(hit.map(bits), other.map(bits), "with boxes: {line:?}");
            let hit = hit?;
            let surface = bare.surface::<AllEffects>(&ray, hit);
            assert_eq!(surface, boxed.surface::<AllEffects>(&ray, hit));
            let surface = surface.expect("what was hit has a surface");
            Some(Found {
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

    fn leave(found: &Found, side: Vector) -> Vector {
        wide(offset_origin(narrow(found.point), narrow(found.error), narrow(side)))
    }
}
