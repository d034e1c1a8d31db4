//! The crates that a user would take instead, at their best: triangles in the order of their
//! leaves where that is possible.

use bvh::aabb::{Aabb, Bounded};
use bvh::bounding_hierarchy::BHShape;
use nalgebra::{Point3, Vector3};
use obvhs::bvh2::Bvh2;
use obvhs::ray::RayHit;
use strahl_core::Vec3;
use strahl_core::geometry::Ray;

use crate::contest::{Contender, Found};
use crate::mesh::Mesh;

/// `obvhs`, a binary tree by its medium build.
pub struct Obvhs {
    tree: Bvh2,
    /// In the order of the leaves.
    triangles: Vec<obvhs::triangle::Triangle>,
}

fn aligned(v: Vec3) -> glam::Vec3A {
    glam::Vec3A::new(v.x, v.y, v.z)
}

impl Obvhs {
    pub fn build(mesh: &Mesh) -> Self {
        let triangle = |[a, b, c]: [Vec3; 3]| obvhs::triangle::Triangle {
            v0: aligned(a),
            v1: aligned(b),
            v2: aligned(c),
        };
        let triangles: Vec<_> = mesh.corners().map(triangle).collect();
        let tree = obvhs::bvh2::builder::build_bvh2_from_tris(
            &triangles,
            obvhs::BvhBuildParams::medium_build(),
            &mut Default::default(),
        );
        let triangles = tree.primitive_indices.iter().map(|place| triangles[*place as usize]).collect();
        Obvhs { tree, triangles }
    }
}

impl Contender for Obvhs {
    fn bytes(&self) -> usize {
        size_of_val(self.tree.nodes.as_slice())
            + size_of_val(self.tree.primitive_indices.as_slice())
            + size_of_val(self.triangles.as_slice())
    }

    fn closest(&mut self, ray: &Ray) -> Option<Found> {
        let mut hit = RayHit::none();
        let ray = obvhs::ray::Ray::new_inf(aligned(ray.origin), aligned(ray.direction));
        let met = self.tree.ray_traverse(ray, &mut hit, |ray, place| self.triangles[place].intersect(ray));
        met.then(|| Found { t: hit.t, item: self.tree.primitive_indices[hit.primitive_id as usize] })
    }

    fn any(&mut self, ray: &Ray, reach: f32) -> bool {
        let ray = obvhs::ray::Ray::new(aligned(ray.origin), aligned(ray.direction), 0.0, reach);
        !self.tree.ray_traverse_miss(ray, |ray, place| self.triangles[place].intersect(ray))
    }
}

/// `bvh`.
pub struct Svenstaro {
    tree: bvh::bvh::Bvh<f32, 3>,
    triangles: Vec<Triangle>,
}

struct Triangle {
    corners: [Point3<f32>; 3],
    number: u32,
    node: usize,
}

impl Bounded<f32, 3> for Triangle {
    fn aabb(&self) -> Aabb<f32, 3> {
        let [a, b, c] = self.corners;
        Aabb::empty().grow(&a).grow(&b).grow(&c)
    }
}

impl BHShape<f32, 3> for Triangle {
    fn set_bh_node_index(&mut self, node: usize) {
        self.node = node;
    }

    fn bh_node_index(&self) -> usize {
        self.node
    }
}

impl Triangle {
    /// From both sides, unlike the crate's own (Möller and Trumbore, 1997).
    fn hit(&self, origin: &Point3<f32>, direction: &Vector3<f32>) -> Option<f32> {
        let [a, b, c] = &self.corners;
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

impl Svenstaro {
    pub fn build(mesh: &Mesh) -> Self {
        let point = |v: Vec3| Point3::new(v.x, v.y, v.z);
        let triangle =
            |(corners, number): ([Vec3; 3], u32)| Triangle { corners: corners.map(point), number, node: 0 };
        let mut triangles: Vec<_> = mesh.corners().zip(0..).map(triangle).collect();
        let tree = bvh::bvh::Bvh::build(&mut triangles);
        Svenstaro { tree, triangles }
    }
}

fn theirs(ray: &Ray) -> bvh::ray::Ray<f32, 3> {
    let (o, d) = (ray.origin, ray.direction);
    bvh::ray::Ray::new(Point3::new(o.x, o.y, o.z), Vector3::new(d.x, d.y, d.z))
}

impl Contender for Svenstaro {
    fn bytes(&self) -> usize {
        size_of_val(self.tree.nodes.as_slice()) + size_of_val(self.triangles.as_slice())
    }

    fn closest(&mut self, ray: &Ray) -> Option<Found> {
        let ray = theirs(ray);
        let mut best: Option<Found> = None;
        for triangle in self.tree.traverse_iterator(&ray, &self.triangles) {
            if let Some(t) = triangle.hit(&ray.origin, &ray.direction)
                && best.is_none_or(|best| t < best.t)
            {
                best = Some(Found { t, item: triangle.number });
            }
        }
        best
    }

    fn any(&mut self, ray: &Ray, reach: f32) -> bool {
        let ray = theirs(ray);
        self.tree
            .traverse_iterator(&ray, &self.triangles)
            .any(|triangle| triangle.hit(&ray.origin, &ray.direction).is_some_and(|t| t <= reach))
    }
}

/// `bvh`, whose triangles come nearest first.
pub struct SvenstaroNearest(pub Svenstaro);

impl Contender for SvenstaroNearest {
    fn bytes(&self) -> usize {
        self.0.bytes()
    }

    fn closest(&mut self, ray: &Ray) -> Option<Found> {
        let ray = theirs(ray);
        let mut best: Option<Found> = None;
        for triangle in self.0.tree.nearest_traverse_iterator(&ray, &self.0.triangles) {
            // They come in the order in which the ray enters their boxes.
            if let Some(best) = best
                && ray.intersection_slice_for_aabb(&triangle.aabb()).is_some_and(|(entry, _)| entry > best.t)
            {
                break;
            }
            if let Some(t) = triangle.hit(&ray.origin, &ray.direction)
                && best.is_none_or(|best| t < best.t)
            {
                best = Some(Found { t, item: triangle.number });
            }
        }
        best
    }

    fn any(&mut self, ray: &Ray, reach: f32) -> bool {
        self.0.any(ray, reach)
    }
}
