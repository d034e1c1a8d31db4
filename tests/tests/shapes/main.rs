//! Every shape in both cores: hits, normals, and rays that leave the surface.

mod leaving;
mod oracle;
mod paper;

use strahl_test_scene as single;
use strahl_test_scene::{
    CoreHit, DVec3, SplitMix64, TestRay, TestShape, TestShapeKind, TestedCore, dvec3, rounded,
};
use strahl_test_scene_double as double;

/// Casts rays at one shape with one core, and offsets ray origins.
#[derive(Clone, Copy)]
struct ShapeCaster {
    cast: fn(&TestShape, &[TestRay]) -> Vec<Option<CoreHit>>,
    offset_origin: fn(&CoreHit, DVec3) -> DVec3,
    roundoff: f64,
    name: &'static str,
}

impl ShapeCaster {
    const fn of<C: TestedCore>() -> Self {
        let cast =
            |shape: &TestShape, rays: &[TestRay]| C::with_shapes(std::slice::from_ref(shape)).cast(rays);
        ShapeCaster { cast, offset_origin: C::offset_origin, roundoff: C::ROUNDOFF, name: C::NAME }
    }

    fn one(&self, shape: &TestShape, ray: TestRay) -> Option<CoreHit> {
        (self.cast)(shape, &[ray])[0]
    }
}

const SINGLE: ShapeCaster = ShapeCaster::of::<single::TestScene>();
const DOUBLE: ShapeCaster = ShapeCaster::of::<double::TestScene>();
const CORES: [ShapeCaster; 2] = [SINGLE, DOUBLE];

fn length(v: DVec3) -> f64 {
    v.dot(v).sqrt()
}

/// The ray from `origin` through `target`, with a direction of `speed` times their difference, rounded to
/// `f32`.
fn towards(origin: DVec3, target: DVec3, speed: f64) -> TestRay {
    let direction = (target - origin) * speed;
    TestRay { origin, direction: dvec3(rounded(direction.x), rounded(direction.y), rounded(direction.z)) }
}

/// A point on the shape or beside it.
fn target(shape: &TestShape, rng: &mut SplitMix64) -> DVec3 {
    let (center, radius) = shape.bounding_sphere();
    let near_vertices = |vertices: &[DVec3], rng: &mut SplitMix64| {
        let weights: Vec<f64> = vertices.iter().map(|_| rng.unit()).collect();
        let sum: DVec3 = vertices.iter().zip(&weights).map(|(vertex, weight)| *vertex * *weight).sum();
        center + (sum / weights.iter().sum::<f64>() - center) * rng.between(0.0, 2.5)
    };
    match shape {
        TestShape::Triangle { vertices } | TestShape::SmoothTriangle { vertices, .. } => {
            near_vertices(vertices, rng)
        }
        TestShape::Polygon { vertices } | TestShape::SmoothPolygon { vertices, .. } => {
            near_vertices(vertices, rng)
        }
        _ => rng.in_ball(center, 1.2 * radius),
    }
}

/// A ray that probably hits the shape, from inside or from up to a hundred of its sizes away, with a
/// direction of any length.
fn random_ray(shape: &TestShape, rng: &mut SplitMix64) -> TestRay {
    let (center, radius) = shape.bounding_sphere();
    let origin = match rng.below(4) {
        0 => rng.in_ball(center, 0.9 * radius),
        1 => rng.in_ball(center, 3.0 * radius),
        _ => {
            let away = rng.direction() * (rng.log_between(1.2, 100.0) * radius);
            rng.in_ball(center + away, 0.1 * radius)
        }
    };
    loop {
        let target = target(shape, rng);
        if length(target - origin) > 1e-3 * radius {
            return towards(origin, target, rng.log_between(0.01, 100.0));
        }
    }
}

/// Declares a test for each kind of shape.
macro_rules! for_every_kind {
    ($check:ident, $name:ident) => {
        $crate::for_every_kind! { $check, $name:
            a_sphere: Sphere,
            a_plane: Plane,
            a_disc: Disc,
            a_triangle: Triangle,
            a_smooth_triangle: SmoothTriangle,
            a_polygon: Polygon,
            a_smooth_polygon: SmoothPolygon,
            a_box: Cuboid,
            an_oriented_box: OrientedCuboid,
            an_open_cone: OpenCone,
            a_capped_cone: CappedCone,
            an_open_cylinder: OpenCylinder,
            a_capped_cylinder: CappedCylinder,
            a_torus: Torus,
        }
    };
    ($check:ident, $name:ident: $($shape:ident: $Kind:ident,)*) => { $(
        mod $shape {
            #[test]
            fn $name() {
                super::$check(super::TestShapeKind::$Kind);
            }
        }
    )* };
}
use for_every_kind;
