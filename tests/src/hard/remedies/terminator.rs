//! The way to a light from a coarse smooth ball, with its start lifted and without.

use strahl_core::{Bvh, BvhRoom, Everything, LastFirst, Node, Ray, RayKind, Slot, Vec3, World, leave};

use super::{Trial, Tried, narrow};
use crate::hard::cost::Work;
use crate::hard::terminator::{ball, eyes};
use crate::single::Stage;
use crate::thing::{Thing, Vector};
use crate::{Core, Random};

/// A point of a smooth triangle whose shading normal faces the light.
struct Lit {
    point: Vec3,
    error: Vec3,
    /// The normal of the flat triangle, on the side from which the light comes.
    side: Vec3,
    outside: bool,
    corners: [Vec3; 3],
    normals: [Vec3; 3],
    light: Vec3,
}

impl Lit {
    /// Where the way to the light starts. `LIFTED`: from the round surface that is meant, if the
    /// light stands under the horizon of the flat one.
    #[inline(always)]
    fn start<const LIFTED: bool>(&self) -> Vec3 {
        let from = leave(self.point, self.error, self.side);
        if LIFTED && self.side.dot(self.light) <= 0.0 { from + self.lift() } else { from }
    }

    #[cold]
    #[inline(never)]
    fn lift(&self) -> Vec3 {
        let seen = self.corners.map(|corner| corner - self.point);
        let [a, b, c] = seen;
        let upright = (b - a).cross(c - a);
        let all = upright.dot(upright);
        let shares = [b.cross(c), c.cross(a), a.cross(b)].map(|area| area.dot(upright) / all);
        let above = |corner: Vec3, normal: Vec3| {
            let height = corner.dot(normal);
            if if self.outside { height > 0.0 } else { height < 0.0 } { normal * height } else { Vec3::ZERO }
        };
        let share = |sum: Vec3, ((corner, normal), share)| sum + above(corner, normal) * share;
        seen.into_iter().zip(self.normals).zip(shares).fold(Vec3::ZERO, share)
    }
}

type Found = World<'static, Bvh<'static, LastFirst<64>>>;

/// A ball, and points of it that face a light.
struct Scene {
    world: Found,
    points: Vec<Lit>,
}

impl Scene {
    fn new(level: u32, random: &mut Random) -> Scene {
        let radius = random.scale(1e-3, 1e3);
        let center = random.near(Vector::ZERO, 10.0 * radius);
        let light = random.direction();
        let things = ball(level, center, radius, None);
        let eyes = eyes(center, radius, light, random);
        // Works live as long as the program that measures them, and so do their scenes.
        let stage: &'static Stage = Box::leak(Box::new(Stage::with(&things)));
        let boxes = stage.boxes();
        let room = BvhRoom::comfortable(boxes.len());
        let (nodes, items) = (vec![Node::EMPTY; room.nodes].leak(), vec![Slot::EMPTY; room.items].leak());
        let tree = Bvh::build(&boxes, nodes, items).expect("a comfortable room is enough");
        let point = |(found, eye): (Option<crate::Found>, &crate::Line)| {
            let found = found?;
            let Thing::SmoothTriangle { corners, normals } = things[found.item as usize] else { return None };
            let outside = found.normal.dot(eye.direction) <= 0.0;
            let turned = |n: Vector| if outside { n } else { -n };
            // What shows least of the light is left to rounding.
            (turned(found.shading).dot(light) > 1e-3).then(|| Lit {
                point: narrow(found.point),
                error: narrow(found.error),
                side: narrow(turned(found.normal)),
                outside,
                corners: corners.map(narrow),
                normals: normals.map(narrow),
                light: narrow(light),
            })
        };
        let points = stage.cast(&eyes).into_iter().zip(&eyes).filter_map(point).collect();
        Scene { world: World::new(stage.scene(), tree), points }
    }

    /// How many points lie in the shadow of their own ball.
    #[inline(always)]
    fn dark<const LIFTED: bool>(&self) -> usize {
        let mut scratch = LastFirst::default();
        let mut is_dark = |lit: &&Lit| {
            let ray = Ray::new(lit.start::<LIFTED>(), lit.light);
            let kind = RayKind::Shadow;
            self.world.blocker::<Everything, _>(&ray, f32::MAX, kind, &mut scratch, &mut ()).is_some()
        };
        self.points.iter().filter(|lit| is_dark(lit)).count()
    }
}

fn scenes(seed: u64, levels: &[u32]) -> Vec<Scene> {
    let mut random = Random::new(seed);
    levels.iter().map(|level| Scene::new(*level, &mut random)).collect()
}

fn work<const LIFTED: bool>(scenes: Vec<Scene>) -> Work {
    let rays = scenes.iter().map(|scene| scene.points.len()).sum();
    Work::new(rays, move || scenes.iter().map(|scene| scene.dark::<LIFTED>() as f64).sum())
}

/// Balls of 20 to 320 triangles are hard, balls of 1,280 are ordinary; the ray itself is the core's.
pub fn lifting() -> Trial {
    let ordinary = || scenes(0x5eed_0012, &[3; 10]);
    let hard = || scenes(0x5eed_0013, &[0, 1, 2].repeat(8));
    Trial {
        ordinary: [work::<true>(ordinary()), work::<false>(ordinary())],
        hard: Box::new(move || {
            let hard_scenes = hard();
            let rays = hard_scenes.iter().map(|scene| scene.points.len()).sum();
            let faults = [
                hard_scenes.iter().map(Scene::dark::<true>).sum(),
                hard_scenes.iter().map(Scene::dark::<false>).sum(),
            ];
            (Tried { rays, faults, worst: None }, [work::<true>(hard()), work::<false>(hard())])
        }),
    }
}
