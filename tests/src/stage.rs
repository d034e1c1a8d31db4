//! A scene with tables of its own, for the core that the room above names `strahl`.

use super::strahl::{
    Aabb, Background, Camera, CameraSample, Cone, Counters, Cuboid, Disc, Everything, FilmPoint, Geometry,
    Hit, ItemId, Light, Limits, List, Material, MaterialId, Moving, Parts, Plane, Polygon, Projection,
    ROUNDOFF, Ray, RayKind, Real, Rgb, Scene, Shape, Size, Sphere, Stream, Texture, TextureId, Torus, Tracer,
    TurnedCuboid, Vec3, View, Worker, World, group_count, leave, unit, vec3,
};
use crate::cast::{Core, Found};
use crate::thing::{Line, Thing};
use crate::vector::{Vector, vector};

/// A scene with tables of its own. Things are put on it one by one, each made of the material
/// that was named last: [`Material::MATTE`] at first.
#[derive(Clone, Debug)]
pub struct Stage {
    shapes: Vec<Shape>,
    points: Vec<Vec3>,
    normals: Vec<Vec3>,
    planes: Vec<Plane>,
    discs: Vec<Disc>,
    polygons: Vec<Polygon>,
    cuboids: Vec<Cuboid>,
    turned_cuboids: Vec<TurnedCuboid>,
    cones: Vec<Cone>,
    tori: Vec<Torus>,
    moving: Vec<Moving>,
    made_of: Vec<MaterialId>,
    materials: Vec<Material>,
    textures: Vec<Texture>,
    /// The lights.
    pub lights: Vec<Light>,
    /// Light from everywhere.
    pub ambient: Rgb,
    /// What is behind everything.
    pub background: Background,
    /// Whether light passes through bodies on its way from a light.
    pub colored_shadows: bool,
}

impl Default for Stage {
    fn default() -> Self {
        Stage {
            shapes: Vec::new(),
            points: Vec::new(),
            normals: Vec::new(),
            planes: Vec::new(),
            discs: Vec::new(),
            polygons: Vec::new(),
            cuboids: Vec::new(),
            turned_cuboids: Vec::new(),
            cones: Vec::new(),
            tori: Vec::new(),
            moving: Vec::new(),
            made_of: Vec::new(),
            materials: vec![Material::MATTE],
            textures: Vec::new(),
            lights: Vec::new(),
            ambient: Rgb::BLACK,
            background: Background::Color(Rgb::BLACK),
            colored_shadows: false,
        }
    }
}

/// The number of entries, as a place for the next.
fn next<T>(table: &[T]) -> u32 {
    table.len() as u32
}

impl Stage {
    /// Empty, dark space.
    pub fn new() -> Self {
        Self::default()
    }

    /// Names the material of everything that comes next.
    pub fn material(&mut self, material: Material) -> MaterialId {
        self.materials.push(material);
        MaterialId(next(&self.materials) as u16 - 1)
    }

    /// All materials, to change them.
    pub fn materials_mut(&mut self) -> &mut [Material] {
        &mut self.materials
    }

    /// A texture for materials to name.
    pub fn texture(&mut self, texture: Texture) -> TextureId {
        self.textures.push(texture);
        TextureId(next(&self.textures) as u16 - 1)
    }

    fn item(&mut self, shape: Shape) -> ItemId {
        self.shapes.push(shape);
        self.made_of.push(MaterialId(next(&self.materials) as u16 - 1));
        ItemId(next(&self.shapes) - 1)
    }

    /// A sphere.
    pub fn sphere(&mut self, center: Vec3, radius: Real) -> ItemId {
        self.item(Shape::Sphere(Sphere { center, radius }))
    }

    /// A plane. `normal` may have any length.
    pub fn plane(&mut self, point: Vec3, normal: Vec3) -> ItemId {
        let item = ItemId(next(&self.shapes));
        self.planes.push(Plane { point, normal: unit(normal).unwrap(), item });
        self.item(Shape::Plane(next(&self.planes) - 1))
    }

    /// A disc. `normal` may have any length.
    pub fn disc(&mut self, center: Vec3, normal: Vec3, radius: Real) -> ItemId {
        self.discs.push(Disc { center, normal: unit(normal).unwrap(), radius });
        self.item(Shape::Disc(next(&self.discs) - 1))
    }

    /// Corners, and one normal for each. The table of normals is as long as that of the points.
    fn corners(&mut self, corners: &[Vec3], normals: &[Vec3]) -> u32 {
        let first = next(&self.points);
        self.points.extend_from_slice(corners);
        self.normals.extend(normals.iter().map(|normal| unit(*normal).unwrap()));
        self.normals.resize(self.points.len(), Vec3::Z);
        first
    }

    /// A flat triangle.
    pub fn triangle(&mut self, corners: [Vec3; 3]) -> ItemId {
        let first = self.corners(&corners, &[]);
        self.item(Shape::Triangle([first, first + 1, first + 2]))
    }

    /// A smooth triangle. The normals may have any length.
    pub fn smooth_triangle(&mut self, corners: [Vec3; 3], normals: [Vec3; 3]) -> ItemId {
        let first = self.corners(&corners, &normals);
        self.item(Shape::SmoothTriangle([first, first + 1, first + 2]))
    }

    /// A polygon: smooth when there are normals, which may have any length.
    pub fn polygon(&mut self, corners: &[Vec3], normals: &[Vec3]) -> ItemId {
        let first = self.corners(corners, normals);
        self.polygons.push(Polygon::new(first, corners, !normals.is_empty()).unwrap());
        self.item(Shape::Polygon(next(&self.polygons) - 1))
    }

    /// An upright box.
    pub fn cuboid(&mut self, min: Vec3, max: Vec3) -> ItemId {
        self.cuboids.push(Cuboid { min, max });
        self.item(Shape::Cuboid(next(&self.cuboids) - 1))
    }

    /// A turned box.
    pub fn turned_cuboid(&mut self, center: Vec3, half: Vec3, first: Vec3, third: Vec3) -> ItemId {
        self.turned_cuboids.push(TurnedCuboid::new(center, half, first, third).unwrap());
        self.item(Shape::TurnedCuboid(next(&self.turned_cuboids) - 1))
    }

    /// A cone or cylinder.
    pub fn cone(&mut self, cone: Cone) -> ItemId {
        self.cones.push(cone);
        self.item(Shape::Cone(next(&self.cones) - 1))
    }

    /// A torus. `axis` may have any length.
    pub fn torus(&mut self, center: Vec3, axis: Vec3, major: Real, minor: Real) -> ItemId {
        self.tori.push(Torus { center, axis: unit(axis).unwrap(), major, minor });
        self.item(Shape::Torus(next(&self.tori) - 1))
    }

    /// Lets an item move while the shutter is open, from one distance from its place to another.
    pub fn moving(&mut self, item: ItemId, opening: Vec3, closing: Vec3) {
        let place = next(&self.moving);
        let shape = &mut self.shapes[item.0 as usize];
        self.moving.push(Moving { shape: *shape, opening, closing });
        *shape = Shape::Moving(place);
    }

    /// Lets everything stand in its place.
    pub fn stand_still(&mut self) {
        for shape in &mut self.shapes {
            if let Shape::Moving(place) = *shape {
                *shape = self.moving[place as usize].shape;
            }
        }
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
            Thing::TurnedCuboid { center, half, first, third } => {
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
    pub fn len(&self) -> u32 {
        next(&self.shapes)
    }

    /// Whether there is nothing.
    pub fn is_empty(&self) -> bool {
        self.shapes.is_empty()
    }

    /// What the scene is made of.
    pub fn parts(&self) -> Parts<'_> {
        Parts {
            geometry: Geometry {
                shapes: &self.shapes,
                points: &self.points,
                normals: &self.normals,
                planes: &self.planes,
                discs: &self.discs,
                polygons: &self.polygons,
                cuboids: &self.cuboids,
                turned_cuboids: &self.turned_cuboids,
                cones: &self.cones,
                tori: &self.tori,
                moving: &self.moving,
            },
            made_of: &self.made_of,
            materials: &self.materials,
            textures: &self.textures,
            lights: &self.lights,
            ambient: self.ambient,
            background: self.background,
            colored_shadows: self.colored_shadows,
        }
    }

    /// The scene.
    pub fn scene(&self) -> Scene<'_> {
        Scene::new(self.parts()).unwrap()
    }

    /// The boxes round all items.
    pub fn boxes(&self) -> Vec<Aabb> {
        self.parts().geometry.all_bounds().collect()
    }

    /// The mean of what `n` camera rays see that differ in nothing but what they leave to chance.
    pub fn look_often(&self, eye: Vec3, target: Vec3, limits: Limits, n: u32, seed: u32) -> [f64; 3] {
        let world = World::new(self.scene(), List::without_bounds(self.len()));
        let tracer = Tracer::<_, Everything, 64>::new(&world, straight(eye, target), limits).unwrap();
        let mut worker = Worker::new(());
        let mut sum = [0.0; 3];
        for index in 0..n {
            let sample =
                CameraSample { point: FilmPoint { x: 0.5, y: 0.5 }, stream: Stream::new(7, 5, index, seed) };
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
        let world = World::new(self.scene(), List::without_bounds(self.len()));
        let tracer = Tracer::<_, Everything, 64>::new(&world, straight(eye, target), limits).unwrap();
        let mut worker = Worker::new(Counters::new());
        let sample = CameraSample { point: FilmPoint { x: 0.5, y: 0.5 }, stream: Stream::new(0, 0, 0, 0) };
        let color = tracer.trace(sample, &mut worker).color;
        assert!(color.is_within(Real::MAX), "{color:?} is no light");
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
    Camera::new(&view, Size::new(1, 1).unwrap()).unwrap()
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
        let bare = World::new(self.scene(), List::without_bounds(self.len()));
        let boxes = self.boxes();
        let mut groups = vec![Aabb::EMPTY; group_count(boxes.len())];
        let boxed = World::new(self.scene(), List::with_boxes(&boxes, &mut groups).unwrap());

        #[allow(clippy::useless_conversion)] // in the twin
        let cast = |line: &Line| {
            let ray = Ray::new(narrow(line.origin), narrow(line.direction));
            let hit = bare.nearest::<Everything, _>(&ray, Real::INFINITY, RayKind::Camera, &mut (), &mut ());
            let other =
                boxed.nearest::<Everything, _>(&ray, Real::INFINITY, RayKind::Camera, &mut (), &mut ());
            let bits = |hit: Hit| (hit.item, hit.t.to_bits());
            assert_eq!(hit.map(bits), other.map(bits), "with boxes: {line:?}");
            let hit = hit?;
            let surface = bare.surface::<Everything>(&ray, hit);
            assert_eq!(surface, boxed.surface::<Everything>(&ray, hit));
            let surface = surface.expect("what was hit has a surface");
            Some(Found {
                item: hit.item.0,
                t: hit.t.into(),
                point: wide(surface.point),
                error: wide(surface.error),
                normal: wide(surface.normal),
                shading: wide(surface.shading),
            })
        };
        rays.iter().map(cast).collect()
    }

    fn leave(found: &Found, side: Vector) -> Vector {
        wide(leave(narrow(found.point), narrow(found.error), narrow(side)))
    }
}
