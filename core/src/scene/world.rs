//! The scene and the accelerator that knows where its items lie: answers to rays.

use core::marker::PhantomData;
use core::ops::ControlFlow;

use super::Scene;
use super::effects::Effects;
use crate::accel::{Accelerator, Candidate, Query, TriangleBlock};
use crate::geometry::{Geometry, Hit, ItemId, Ray, Shape, ShapeKind, SurfaceInteraction, intersect_triangle};
use crate::math::{Real, Vec3};
use crate::tally::{CountedEvent, RayKind, Tally};

/// A scene that can be asked what a ray meets.
#[derive(Clone, Copy, Debug)]
pub struct World<'s, A> {
    scene: Scene<'s>,
    accelerator: A,
}

impl<'s, A: Accelerator> World<'s, A> {
    /// The world of `scene`. The accelerator must have been built from the boxes of its items
    /// ([`Geometry::all_bounds`]); what it does not offer is not there.
    ///
    /// [`Geometry::all_bounds`]: crate::Geometry::all_bounds
    pub fn new(scene: Scene<'s>, accelerator: A) -> Self {
        World { scene, accelerator }
    }

    /// The scene.
    pub fn scene(&self) -> &Scene<'s> {
        &self.scene
    }

    /// The accelerator.
    pub fn accelerator(&self) -> &A {
        &self.accelerator
    }

    /// The nearest item along the ray, at most `reach` lengths of its direction away. Of items
    /// equally far away, the one with the lower number.
    ///
    /// Only the shapes of `E` can be met.
    pub fn nearest_hit<E: Effects, T: Tally>(
        &self,
        ray: &Ray,
        t_max: Real,
        kind: RayKind,
        scratch: &mut A::Scratch,
        tally: &mut T,
    ) -> Option<Hit> {
        if ray.is_valid() {
            self.nearest_hit_unchecked::<E, T>(ray, t_max, kind, scratch, tally)
        } else {
            None
        }
    }

    /// The same of a ray that is known to be sound. For the loop: what else asks has the other door,
    /// so that this one is inlined there and nowhere else.
    #[inline(always)]
    pub(crate) fn nearest_hit_unchecked<E: Effects, T: Tally>(
        &self,
        ray: &Ray,
        reach: Real,
        kind: RayKind,
        scratch: &mut A::Scratch,
        tally: &mut T,
    ) -> Option<Hit> {
        // No item has the highest number: the first at the very reach wins against it.
        let goal = NearestHit(ItemId(u32::MAX));
        let mut search = RayQuery::<E, T, _>::new(self, ray, reach, kind, tally, goal);
        self.run_query::<E, _>(ray, scratch, &mut search);
        let item = search.policy.0;
        (item != ItemId(u32::MAX)).then_some(Hit { t: search.reach, item })
    }

    /// Some item along the ray, at most `reach` lengths of its direction away.
    ///
    /// Only the shapes of `E` can be in the way.
    pub fn occluder<E: Effects, T: Tally>(
        &self,
        ray: &Ray,
        reach: Real,
        kind: RayKind,
        scratch: &mut A::Scratch,
        tally: &mut T,
    ) -> Option<ItemId> {
        if ray.is_valid() { self.occluder_unchecked::<E, T>(ray, reach, kind, scratch, tally) } else { None }
    }

    /// The same of a ray that is known to be sound.
    pub(crate) fn occluder_unchecked<E: Effects, T: Tally>(
        &self,
        ray: &Ray,
        reach: Real,
        kind: RayKind,
        scratch: &mut A::Scratch,
        tally: &mut T,
    ) -> Option<ItemId> {
        let mut search = RayQuery::<E, T, _>::new(self, ray, reach, kind, tally, AnyHit(None));
        self.run_query::<E, _>(ray, scratch, &mut search);
        search.policy.0
    }

    /// Whether this item is along the ray, at most `reach` lengths of its direction away.
    ///
    /// As [`World::occluder`] would find if there were no other.
    pub fn is_occluded_by<E: Effects, T: Tally>(
        &self,
        item: ItemId,
        ray: &Ray,
        reach: Real,
        kind: RayKind,
        tally: &mut T,
    ) -> bool {
        let mut search = RayQuery::<E, T, _>::new(self, ray, reach, kind, tally, AnyHit(None));
        search.test_item(item).is_break()
    }

    /// What the item that was hit is like there.
    #[inline(always)]
    pub fn surface_interaction<E: Effects>(&self, ray: &Ray, hit: Hit) -> Option<SurfaceInteraction> {
        let geometry = &self.scene.descriptor().geometry;
        geometry.surface_interaction::<E>(geometry.shape(hit.item)?, ray, hit.t)
    }

    /// How far off a point of a smooth item the round surface is that is meant, where it is to stand
    /// in no light of its own; none for other items. `point`: where the item is at rest. `outside`: on the side of its normals.
    pub(crate) fn terminator_offset<E: Effects>(
        &self,
        item: ItemId,
        point: Vec3,
        outside: bool,
    ) -> Option<Vec3> {
        let geometry = &self.scene.descriptor().geometry;
        geometry.terminator_offset::<E>(*geometry.static_shape(geometry.shape(item)?)?, point, outside)
    }

    /// How far away from its own place an item is at `time`; zero where nothing moves.
    #[inline(always)]
    pub(crate) fn motion_offset<E: Effects>(&self, item: ItemId, time: Real) -> Vec3 {
        if !(E::SET.motion_blur && self.scene.required_effects().motion_blur) {
            return Vec3::ZERO;
        }
        let geometry = &self.scene.descriptor().geometry;
        geometry.shape(item).map_or(Vec3::ZERO, |shape| geometry.motion_offset(shape, time))
    }

    /// Planes have no box, so they are tested here and first: what they leave in reach is less.
    #[inline(always)]
    fn run_query<E: Effects, Q: Query>(&self, ray: &Ray, scratch: &mut A::Scratch, query: &mut Q) {
        if E::SET.shapes.contains(ShapeKind::Plane) {
            for plane in self.scene.descriptor().geometry.planes {
                if query.test_item(plane.item).is_break() {
                    return;
                }
            }
        }
        self.accelerator.traverse(ray, scratch, query);
    }
}

/// A ray on its way, the far limit of what it looks for, and what that is.
struct RayQuery<'q, E, T, G> {
    geometry: &'q Geometry<'q>,
    ray: &'q Ray,
    /// Finite, so that an infinite distance is beyond every reach.
    reach: Real,
    kind: RayKind,
    tally: &'q mut T,
    policy: G,
    effects: PhantomData<E>,
}

/// What is looked for.
trait HitPolicy {
    /// Whether nearer items are the better ones.
    const ORDERED: bool;

    /// An item is met, at most `reach` away. `Break` when that is enough.
    fn meet(&mut self, item: ItemId, t: Real, reach: &mut Real) -> ControlFlow<()>;
}

/// The nearest item: every hit shortens the reach.
struct NearestHit(ItemId);

impl HitPolicy for NearestHit {
    const ORDERED: bool = true;

    #[inline(always)]
    fn meet(&mut self, item: ItemId, t: Real, reach: &mut Real) -> ControlFlow<()> {
        if t < *reach || item < self.0 {
            *reach = t;
            self.0 = item;
        }
        ControlFlow::Continue(())
    }
}

/// Any item: the first ends the walk.
struct AnyHit(Option<ItemId>);

impl HitPolicy for AnyHit {
    const ORDERED: bool = false;

    #[inline(always)]
    fn meet(&mut self, item: ItemId, _: Real, _: &mut Real) -> ControlFlow<()> {
        self.0 = Some(item);
        ControlFlow::Break(())
    }
}

impl<'q, E: Effects, T: Tally, G: HitPolicy> RayQuery<'q, E, T, G> {
    /// Which of both sorts of triangles can be met.
    const TRIANGLES: [bool; 2] =
        [E::SET.shapes.contains(ShapeKind::Triangle), E::SET.shapes.contains(ShapeKind::SmoothTriangle)];

    fn new<A>(
        world: &'q World<'_, A>,
        ray: &'q Ray,
        reach: Real,
        kind: RayKind,
        tally: &'q mut T,
        goal: G,
    ) -> Self {
        let reach = if reach < Real::MAX { reach } else { Real::MAX };
        let geometry = &world.scene.descriptor().geometry;
        RayQuery { geometry, ray, reach, kind, tally, policy: goal, effects: PhantomData }
    }

    #[inline(always)]
    fn meet(&mut self, item: ItemId, t: Option<Real>) -> ControlFlow<()> {
        match t {
            Some(t) if t <= self.reach => self.policy.meet(item, t, &mut self.reach),
            _ => ControlFlow::Continue(()),
        }
    }

    #[inline(always)]
    fn test_shape(&mut self, item: ItemId, shape: &Shape) -> ControlFlow<()> {
        self.count(shape);
        self.meet(item, self.geometry.intersect::<E>(shape, self.ray))
    }

    #[inline(always)]
    fn count(&mut self, shape: &Shape) {
        if T::COUNTS_TESTS
            && let Some(kind) = self.geometry.kind(shape)
        {
            self.tally.count(CountedEvent::ShapeTest(self.kind, kind));
        }
    }

    /// Whether this triangle is of a sort that can be met; not asked where both can.
    #[inline(always)]
    fn can_meet(&self, triangle: ItemId) -> bool {
        match Self::TRIANGLES {
            [true, true] => true,
            [flat, smooth] => match self.geometry.shape(triangle) {
                Some(Shape::Triangle(_)) => flat,
                Some(Shape::SmoothTriangle(_)) => smooth,
                _ => false,
            },
        }
    }

    /// The item has been held against the ray.
    #[inline(always)]
    fn tested(&mut self, item: ItemId) {
        if let Some(shape) = self.geometry.shape(item) {
            self.count(shape);
        }
    }
}

impl<E: Effects, T: Tally, G: HitPolicy> Query for RayQuery<'_, E, T, G> {
    const ORDERED: bool = G::ORDERED;

    fn t_max(&self) -> Real {
        self.reach
    }

    #[inline(always)]
    fn test_item(&mut self, item: ItemId) -> ControlFlow<()> {
        match self.geometry.shape(item) {
            Some(shape) => self.test_shape(item, shape),
            None => ControlFlow::Continue(()),
        }
    }

    #[inline(always)]
    fn test_range(&mut self, count: u32) -> ControlFlow<()> {
        // A loop of its own: an iterator's would be called where two places ask.
        for (shape, item) in self.geometry.shapes.iter().zip(0..count) {
            self.test_shape(ItemId(item), shape)?;
        }
        ControlFlow::Continue(())
    }

    #[inline(always)]
    fn test_block(&mut self, block: &TriangleBlock) -> ControlFlow<()> {
        if Self::TRIANGLES == [false, false] {
            return block.items().try_for_each(|item| self.test_item(item));
        }
        let hits = block.possible_hits(self.ray);
        block.items_in_mask(!hits).for_each(|item| self.tested(item));
        let mut mask = hits;
        while let Some(Candidate { item, corners }) = block.take_candidate(&mut mask) {
            match corners {
                Some(corners) if self.can_meet(item) => {
                    self.tested(item);
                    self.meet(item, intersect_triangle(corners.each_ref(), self.ray))?;
                }
                Some(_) => {}
                None => self.test_item(item)?,
            }
        }
        ControlFlow::Continue(())
    }

    fn count_box_tests(&mut self, count: u32) {
        self.tally.count(CountedEvent::BoxTests(self.kind, count));
    }

    fn count_leaf_visit(&mut self) {
        self.tally.count(CountedEvent::LeafVisit(self.kind));
    }

    fn count_mailbox_hit(&mut self) {
        self.tally.count(CountedEvent::MailboxHit(self.kind));
    }
}
