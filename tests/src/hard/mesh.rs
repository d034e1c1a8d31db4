//! Watertight meshes: no ray from inside escapes, also if it is aimed at an edge or a vertex.

use strahl_core::geometry::{Ray, ShapeFeatures, ShapeKind, ShapeKindSet};
use strahl_core::{Geometry, Shape, Vec3, vec3};

use super::case::{HardCase, HardCaseTally, Solver, as_f32};
use crate::textbook::TextbookShape;
use strahl_test_scene::vector::perpendicular_axes;
use strahl_test_scene::{DVec3, SplitMix64, TestRay, TestShape, dvec3, rounded};

const fn case(name: &'static str, mesh: fn(&mut SplitMix64) -> [HardCaseTally; 3]) -> HardCase {
    HardCase::own("mesh", name, "edges belong to neither of their triangles", 0.0, mesh)
}

pub(super) const CASES: [HardCase; 6] = [
    case("from inside an icosphere of 20,480 triangles", |rng| {
        evaluated(&ClosedMesh::icosphere(5, DVec3::ZERO, 1.0), rng)
    }),
    case("the same at 2e5 from the origin", |rng| {
        evaluated(&ClosedMesh::icosphere(5, dvec3(2e5, -1.3e5, 0.7e5), 100.0), rng)
    }),
    case("from inside a cube of 12", |rng| evaluated(&ClosedMesh::cube(DVec3::ZERO, 1.0), rng)),
    case("from inside a cone of 4,000 slivers", |rng| {
        evaluated(&ClosedMesh::fan(4000, DVec3::ZERO, 1.0), rng)
    }),
    case("the same at 2e5 from the origin", |rng| {
        evaluated(&ClosedMesh::fan(4000, dvec3(-2e5, 2e5, 1e5), 100.0), rng)
    }),
    case("a sheet of 5,000", |rng| evaluated(&ClosedMesh::sheet(50, dvec3(2e5, 0.0, -2e5), 100.0), rng)),
];

/// Triangles that share vertices, and the region where rays at them start.
pub struct ClosedMesh {
    /// Positions of the vertices.
    pub points: Vec<DVec3>,
    /// Indices of the vertices, counterclockwise as seen from outside.
    pub triangles: Vec<[u32; 3]>,
    /// Triangles of each vertex.
    around: Vec<Vec<u32>>,
    /// Vertices that are not on a border.
    targets: Vec<u32>,
    /// Center and radius of the ball in which rays start.
    viewpoint: (DVec3, f64),
}

impl ClosedMesh {
    fn new(
        points: Vec<DVec3>,
        triangles: Vec<[u32; 3]>,
        targets: Vec<u32>,
        viewpoint: (DVec3, f64),
    ) -> ClosedMesh {
        let points: Vec<DVec3> = points.into_iter().map(as_f32).collect();
        let mut around = vec![Vec::new(); points.len()];
        for (triangle, number) in triangles.iter().zip(0..) {
            triangle.iter().for_each(|vertex| around[*vertex as usize].push(number));
        }
        ClosedMesh { points, triangles, around, targets, viewpoint }
    }

    /// A sphere: an icosahedron whose triangles are quartered `level` times.
    pub fn icosphere(level: u32, center: DVec3, radius: f64) -> ClosedMesh {
        let g = 0.5 + 0.5 * 5.0_f64.sqrt();
        let mut points = Vec::new();
        for (a, b) in [(1.0, g), (-1.0, g), (1.0, -g), (-1.0, -g)] {
            points.extend([dvec3(a, b, 0.0), dvec3(0.0, a, b), dvec3(b, 0.0, a)]);
        }
        let mut points: Vec<DVec3> = points.into_iter().map(strahl_test_scene::vector::unit).collect();
        // All triples of neighboring vertices.
        let near = |a: usize, b: usize, points: &[DVec3]| points[a].dot(points[b]) > 0.4;
        let mut triangles = Vec::new();
        for a in 0..12 {
            for b in a + 1..12 {
                for c in b + 1..12 {
                    if near(a, b, &points) && near(b, c, &points) && near(a, c, &points) {
                        let outward =
                            (points[b] - points[a]).cross(points[c] - points[a]).dot(points[a]) > 0.0;
                        triangles
                            .push(if outward { [a, b, c] } else { [a, c, b] }.map(|vertex| vertex as u32));
                    }
                }
            }
        }
        for _ in 0..level {
            let mut halves = std::collections::HashMap::new();
            let mut quarters = Vec::with_capacity(4 * triangles.len());
            for [a, b, c] in triangles {
                let [ab, bc, ca] = [(a, b), (b, c), (c, a)].map(|(a, b)| {
                    *halves.entry((a.min(b), a.max(b))).or_insert_with(|| {
                        points.push(strahl_test_scene::vector::unit(points[a as usize] + points[b as usize]));
                        points.len() as u32 - 1
                    })
                });
                quarters.extend([[a, ab, ca], [b, bc, ab], [c, ca, bc], [ab, bc, ca]]);
            }
            triangles = quarters;
        }
        let targets = (0..points.len() as u32).collect();
        let points = points.into_iter().map(|p| center + p * radius).collect();
        ClosedMesh::new(points, triangles, targets, (center, 0.7 * radius))
    }

    /// A cube of twelve triangles.
    pub fn cube(center: DVec3, half: f64) -> ClosedMesh {
        let vertex = |i: u32| {
            let side = |bit: u32| if i >> bit & 1 == 0 { -half } else { half };
            center + dvec3(side(0), side(1), side(2))
        };
        let faces = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
        let triangles = faces.iter().flat_map(|[a, b, c, d]| [[*a, *b, *c], [*a, *c, *d]]).collect();
        ClosedMesh::new((0..8).map(vertex).collect(), triangles, (0..8).collect(), (center, 0.9 * half))
    }

    /// A cone. Its side has `slivers` triangles that share the apex, and so has its base.
    pub fn fan(slivers: u32, center: DVec3, size: f64) -> ClosedMesh {
        let axis = strahl_test_scene::vector::unit(dvec3(0.3, 0.5, 0.8));
        let (x, y) = perpendicular_axes(axis);
        let edge_point = |i: u32| {
            let angle = f64::from(i) * std::f64::consts::TAU / f64::from(slivers);
            center + (x * libm::cos(angle) + y * libm::sin(angle)) * size
        };
        let mut points: Vec<DVec3> = (0..slivers).map(edge_point).collect();
        points.extend([center + axis * (0.7 * size), center - axis * (0.4 * size)]);
        let next = |i: u32| (i + 1) % slivers;
        let side = (0..slivers).map(|i| [i, next(i), slivers]);
        let base = (0..slivers).map(|i| [next(i), i, slivers + 1]);
        let triangles = side.chain(base).collect();
        // The two apices are as frequent as all other vertices together.
        let targets = (0..slivers).flat_map(|i| [i, slivers + i % 2]).collect();
        ClosedMesh::new(points, triangles, targets, (center, 0.25 * size))
    }

    /// A tilted flat sheet of `side` times `side` squares, each of two triangles.
    pub fn sheet(side: u32, center: DVec3, size: f64) -> ClosedMesh {
        let normal = strahl_test_scene::vector::unit(dvec3(0.1, 0.9, 0.2));
        let (x, y) = perpendicular_axes(normal);
        let index = |i: u32, j: u32| i * (side + 1) + j;
        let step = 2.0 * size / f64::from(side);
        let point =
            |i: u32, j: u32| center + x * (f64::from(i) * step - size) + y * (f64::from(j) * step - size);
        let points =
            (0..=side).flat_map(|i| (0..=side).map(move |j| (i, j))).map(|(i, j)| point(i, j)).collect();
        let square = |(i, j): (u32, u32)| {
            let [a, b, c, d] = [index(i, j), index(i + 1, j), index(i + 1, j + 1), index(i, j + 1)];
            [[a, b, c], [a, c, d]]
        };
        let triangles = (0..side).flat_map(|i| (0..side).map(move |j| (i, j))).flat_map(square).collect();
        let inner =
            (1..side).flat_map(|i| (1..side).map(move |j| (i, j))).map(|(i, j)| index(i, j)).collect();
        ClosedMesh::new(points, triangles, inner, (center + normal * size, 0.3 * size))
    }

    /// A ray from the mesh's start region at a vertex or at a point of an edge, and triangles of which it
    /// must hit one.
    pub fn aim(&self, rng: &mut SplitMix64) -> (TestRay, Vec<u32>) {
        let origin = rng.in_ball(self.viewpoint.0, self.viewpoint.1);
        self.aim_from(origin, rng)
    }

    fn aim_from(&self, origin: DVec3, rng: &mut SplitMix64) -> (TestRay, Vec<u32>) {
        let vertex = self.targets[rng.below(self.targets.len() as u32) as usize];
        let around = &self.around[vertex as usize];
        let target = self.points[vertex as usize];
        if rng.below(3) == 0 {
            return (TestRay { origin, direction: as_f32(target - origin) }, around.clone());
        }
        let triangle = self.triangles[around[rng.below(around.len() as u32) as usize] as usize];
        let other = triangle[rng.below(3) as usize];
        let fraction = if rng.below(4) == 0 { 0.5 } else { rng.unit() };
        let target = target + (self.points[other as usize] - target) * fraction;
        let mut near = around.clone();
        near.extend(&self.around[other as usize]);
        (TestRay { origin, direction: as_f32(target - origin) }, near)
    }

    /// Vertices and shapes of the core.
    pub fn tables(&self) -> (Vec<Vec3>, Vec<Shape>) {
        let points = self.points.iter().map(|p| vec3(p.x as f32, p.y as f32, p.z as f32)).collect();
        (points, self.triangles.iter().copied().map(Shape::Triangle).collect())
    }
}

/// Flat triangles only.
struct TriangleEffects;

impl ShapeFeatures for TriangleEffects {
    const SHAPES: ShapeKindSet = ShapeKindSet::of(&[ShapeKind::Triangle]);
    const SMOOTH_SHADING: bool = false;
}

/// Number of rays, out of `rays`, that escape between the triangles of the mesh.
pub fn escapes(mesh: &ClosedMesh, rays: usize, rng: &mut SplitMix64) -> usize {
    let (points, shapes) = mesh.tables();
    let geometry = Geometry { vertices: &points, shapes: &shapes, ..Geometry::EMPTY };
    let escapes = |_: &usize| {
        let (ray, near) = mesh.aim(rng);
        let narrow = |v: DVec3| vec3(v.x as f32, v.y as f32, v.z as f32);
        let core_ray = Ray::new(narrow(ray.origin), narrow(ray.direction));
        let is_hit = |number: &u32| {
            geometry.intersect::<TriangleEffects>(&shapes[*number as usize], &core_ray).is_some()
        };
        !near.iter().any(is_hit)
    };
    (0..rays).filter(escapes).count()
}

/// Number of rays from outside, out of `rays`, that cross the surface of a convex mesh an odd number of
/// times.
///
/// A ray through a vertex or an edge hits all of its triangles at the same distance. Hits from one side are
/// one crossing; hits from both sides are two, an entry and an exit.
pub fn odd_crossings(mesh: &ClosedMesh, rays: usize, rng: &mut SplitMix64) -> usize {
    let (points, shapes) = mesh.tables();
    let geometry = Geometry { vertices: &points, shapes: &shapes, ..Geometry::EMPTY };
    let is_odd = |_: &usize| {
        let origin = as_f32(mesh.viewpoint.0 + rng.direction() * (mesh.viewpoint.1 * rng.between(4.0, 20.0)));
        let (ray, _) = mesh.aim_from(origin, rng);
        let narrow = |v: DVec3| vec3(v.x as f32, v.y as f32, v.z as f32);
        let core_ray = Ray::new(narrow(ray.origin), narrow(ray.direction));
        let mut hits: Vec<(f32, [u32; 3], bool)> = Vec::new();
        for (shape, vertices) in shapes.iter().zip(&mesh.triangles) {
            if let Some(t) = geometry.intersect::<TriangleEffects>(shape, &core_ray) {
                let [a, b, c] = vertices.map(|vertex| mesh.points[vertex as usize]);
                hits.push((t, *vertices, (b - a).cross(c - a).dot(ray.direction) < 0.0));
            }
        }
        hits.sort_by(|a, b| a.0.total_cmp(&b.0));
        let mut crossings = 0;
        let mut rest = &hits[..];
        while let Some((first, more)) = rest.split_first() {
            // The following hits at nearly the same distance.
            let count = more.iter().take_while(|hit| hit.0 - first.0 <= 1e-4 * first.0).count();
            let group = &rest[..=count];
            let is_both = group.iter().any(|hit| hit.2) && group.iter().any(|hit| !hit.2);
            crossings += if is_both { 2 } else { 1 };
            rest = &rest[count + 1..];
        }
        crossings % 2 == 1
    };
    (0..rays).filter(is_odd).count()
}

/// Evaluates 10,000 rays at the mesh.
fn evaluated(mesh: &ClosedMesh, rng: &mut SplitMix64) -> [HardCaseTally; 3] {
    const RAYS: usize = 10_000;
    let double = |rng: &mut SplitMix64| {
        use strahl_core_double::geometry::Ray;
        use strahl_core_double::{Geometry, Shape};
        let shapes: Vec<Shape> = mesh.triangles.iter().copied().map(Shape::Triangle).collect();
        let geometry = Geometry { vertices: &mesh.points, shapes: &shapes, ..Geometry::EMPTY };
        let escapes = |_: &usize| {
            let (ray, near) = mesh.aim(rng);
            let core_ray = Ray::new(ray.origin, ray.direction);
            let is_hit = |number: &u32| {
                geometry.intersect::<TriangleEffectsDouble>(&shapes[*number as usize], &core_ray).is_some()
            };
            !near.iter().any(is_hit)
        };
        (0..RAYS).filter(escapes).count()
    };
    let textbook_triangles: Vec<TextbookShape> = mesh
        .triangles
        .iter()
        .map(|vertices| {
            TextbookShape::of(&TestShape::Triangle {
                vertices: vertices.map(|vertex| mesh.points[vertex as usize]),
            })
        })
        .collect();
    let textbook = |rng: &mut SplitMix64| {
        let escapes = |_: &usize| {
            let (ray, near) = mesh.aim(rng);
            !near.iter().any(|number| textbook_triangles[*number as usize].intersect(&ray).is_some())
        };
        (0..RAYS).filter(escapes).count()
    };
    let each = |solver| {
        let rng = &mut rng.clone();
        let faults = match solver {
            Solver::Textbook => textbook(rng),
            Solver::Single => escapes(mesh, RAYS, rng),
            Solver::Double => double(rng),
        };
        HardCaseTally { rays: RAYS, unclear: 0, faults, worst: rounded(0.0) }
    };
    Solver::ALL.map(each)
}

/// Flat triangles only, in double precision.
struct TriangleEffectsDouble;

impl strahl_core_double::geometry::ShapeFeatures for TriangleEffectsDouble {
    const SHAPES: strahl_core_double::geometry::ShapeKindSet =
        strahl_core_double::geometry::ShapeKindSet::of(&[strahl_core_double::geometry::ShapeKind::Triangle]);
    const SMOOTH_SHADING: bool = false;
}
