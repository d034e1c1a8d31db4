//! Other crates, in their fastest configuration: triangles in the order of the leaves where possible.

use bvh::aabb::{Aabb, Bounded};
use bvh::bounding_hierarchy::BHShape;
use nalgebra::{Point3, Vector3};
use obvhs::bvh2::Bvh2;
use obvhs::ray::RayHit;
use strahl_core::Vec3;
use strahl_core::geometry::Ray;

use crate::comparison::{ClosestTriangle, Contender};
use crate::mesh::BenchMesh;

/// `obvhs`: a binary BVH with its medium build.
pub struct ObvhsContender {
    tree: Bvh2,
    /// In the order of the leaves.
    triangles: Vec<obvhs::triangle::Triangle>,
}

fn aligned(v: Vec3) -> glam::Vec3A {
    glam::Vec3A::new(v.x, v.y, v.z)
}

impl ObvhsContender {
    pub fn build(mesh: &BenchMesh) -> Self {
        let triangle = |[a, b, c]: [Vec3; 3]| obvhs::triangle::Triangle {
            v0: aligned(a),
            v1: aligned(b),
            v2: aligned(c),
        };
        let triangles: Vec<_> = mesh.vertices().map(triangle).collect();
        let tree = obvhs::bvh2::builder::build_bvh2_from_tris(
            &triangles,
            obvhs::BvhBuildParams::medium_build(),
            &mut Default::default(),
        );
        let triangles = tree.primitive_indices.iter().map(|index| triangles[*index as usize]).collect();
        ObvhsContender { tree, triangles }
    }
}

impl Contender for ObvhsContender {
    fn bytes(&self) -> usize {
        size_of_val(self.tree.nodes.as_slice())
            + size_of_val(self.tree.primitive_indices.as_slice())
            + size_of_val(self.triangles.as_slice())
    }

    fn intersect_nearest(&mut self, ray: &Ray) -> Option<ClosestTriangle> {
        let mut hit = RayHit::none();
        let ray = obvhs::ray::Ray::new_inf(aligned(ray.origin), aligned(ray.direction));
        let is_hit = self.tree.ray_traverse(ray, &mut hit, |ray, index| self.triangles[index].intersect(ray));
        is_hit.then(|| ClosestTriangle {
            t: hit.t,
            item: self.tree.primitive_indices[hit.primitive_id as usize],
        })
    }

    fn occluded(&mut self, ray: &Ray, t_max: f32) -> bool {
        let ray = obvhs::ray::Ray::new(aligned(ray.origin), aligned(ray.direction), 0.0, t_max);
        !self.tree.ray_traverse_miss(ray, |ray, index| self.triangles[index].intersect(ray))
    }
}

/// `bvh`.
pub struct BvhCrateContender {
    tree: bvh::bvh::Bvh<f32, 3>,
    triangles: Vec<BvhCrateTriangle>,
}

struct BvhCrateTriangle {
    vertices: [Point3<f32>; 3],
    number: u32,
    node: usize,
}

impl Bounded<f32, 3> for BvhCrateTriangle {
    fn aabb(&self) -> Aabb<f32, 3> {
        let [a, b, c] = self.vertices;
        Aabb::empty().grow(&a).grow(&b).grow(&c)
    }
}

impl BHShape<f32, 3> for BvhCrateTriangle {
    fn set_bh_node_index(&mut self, node: usize) {
        self.node = node;
    }

    fn bh_node_index(&self) -> usize {
        self.node
    }
}

impl BvhCrateTriangle {
    /// Two-sided intersection (Möller and Trumbore, 1997); that of the crate is one-sided.
    fn hit(&self, origin: &Point3<f32>, direction: &Vector3<f32>) -> Option<f32> {
        let [a, b, c] = &self.vertices;
        let (ab, ac) = (b - a, c - a);
        let p = direction.cross(&ac);
        let inverse = 1.0 / ab.dot(&p);
        let o = origin - a;
        let u = o.dot(&p) * inverse;
        if !(0.0..=1.0).contains(&u) {
            return None;
        }
        let q = o.cross(&ab);
        let v = direction.dot(&q) * inverse;
        if v < 0.0 || u + v > 1.0 {
            return None;
        }
        let t = ac.dot(&q) * inverse;
        (t > 0.0).then_some(t)
    }
}

impl BvhCrateContender {
    pub fn build(mesh: &BenchMesh) -> Self {
        let point = |v: Vec3| Point3::new(v.x, v.y, v.z);
        let triangle = |(vertices, number): ([Vec3; 3], u32)| BvhCrateTriangle {
            vertices: vertices.map(point),
            number,
            node: 0,
        };
        let mut triangles: Vec<_> = mesh.vertices().zip(0..).map(triangle).collect();
        let tree = bvh::bvh::Bvh::build(&mut triangles);
        BvhCrateContender { tree, triangles }
    }
}

fn bvh_ray(ray: &Ray) -> bvh::ray::Ray<f32, 3> {
    let (o, d) = (ray.origin, ray.direction);
    bvh::ray::Ray::new(Point3::new(o.x, o.y, o.z), Vector3::new(d.x, d.y, d.z))
}

impl Contender for BvhCrateContender {
    fn bytes(&self) -> usize {
        size_of_val(self.tree.nodes.as_slice()) + size_of_val(self.triangles.as_slice())
    }

    fn intersect_nearest(&mut self, ray: &Ray) -> Option<ClosestTriangle> {
        let ray = bvh_ray(ray);
        let mut best: Option<ClosestTriangle> = None;
        for triangle in self.tree.traverse_iterator(&ray, &self.triangles) {
            if let Some(t) = triangle.hit(&ray.origin, &ray.direction)
                && best.is_none_or(|best| t < best.t)
            {
                best = Some(ClosestTriangle { t, item: triangle.number });
            }
        }
        best
    }

    fn occluded(&mut self, ray: &Ray, t_max: f32) -> bool {
        let ray = bvh_ray(ray);
        self.tree
            .traverse_iterator(&ray, &self.triangles)
            .any(|triangle| triangle.hit(&ray.origin, &ray.direction).is_some_and(|t| t <= t_max))
    }
}

/// `bvh`, with traversal from near to far.
pub struct BvhCrateNearest(pub BvhCrateContender);

impl Contender for BvhCrateNearest {
    fn bytes(&self) -> usize {
        self.0.bytes()
    }

    fn intersect_nearest(&mut self, ray: &Ray) -> Option<ClosestTriangle> {
        let ray = bvh_ray(ray);
        let mut best: Option<ClosestTriangle> = None;
        for triangle in self.0.tree.nearest_traverse_iterator(&ray, &self.0.triangles) {
            // In the order in which the ray enters their bounds.
            if let Some(best) = best
                && ray.intersection_slice_for_aabb(&triangle.aabb()).is_some_and(|(entry, _)| entry > best.t)
            {
                break;
            }
            if let Some(t) = triangle.hit(&ray.origin, &ray.direction)
                && best.is_none_or(|best| t < best.t)
            {
                best = Some(ClosestTriangle { t, item: triangle.number });
            }
        }
        best
    }

    fn occluded(&mut self, ray: &Ray, t_max: f32) -> bool {
        self.0.occluded(ray, t_max)
    }
}
