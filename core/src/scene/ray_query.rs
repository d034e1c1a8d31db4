//! The query along a ray: intersects the items that an accelerator offers.
//!
//! One query serves both kinds of rays: [`NearestHit`] keeps the closest hit, [`AnyHit`] stops at the first
//! one.

use core::marker::PhantomData;
use core::ops::ControlFlow;

use super::effects::Effects;
use crate::accel::{Candidate, Query, TriangleBlock};
use crate::geometry::{Geometry, ItemId, Ray, Shape, ShapeKind, intersect_triangle};
use crate::math::Real;
use crate::tally::{CountedEvent, RayKind, Tally};

/// A query: intersects the items that an accelerator offers.
pub(super) struct RayQuery<'q, E, T, G> {
    geometry: &'q Geometry<'q>,
    ray: &'q Ray,
    /// Largest `t` at which a hit is accepted. Finite, so that an infinite `t` never is.
    pub(super) t_max: Real,
    kind: RayKind,
    tally: &'q mut T,
    pub(super) policy: G,
    effects: PhantomData<E>,
}

/// Which hits a query keeps.
pub(super) trait HitPolicy {
    /// Whether nearer hits replace farther ones, so that front-to-back traversal pays.
    const ORDERED: bool;

    /// Takes a hit with `t` of at most `t_max`; may reduce `t_max`. `Break` ends the query.
    fn accept(&mut self, item: ItemId, t: Real, t_max: &mut Real) -> ControlFlow<()>;
}

/// Keeps the nearest hit, which becomes `t_max`.
pub(super) struct NearestHit(pub(super) ItemId);

impl HitPolicy for NearestHit {
    const ORDERED: bool = true;

    #[inline(always)]
    fn accept(&mut self, item: ItemId, t: Real, t_max: &mut Real) -> ControlFlow<()> {
        if t < *t_max || item < self.0 {
            *t_max = t;
            self.0 = item;
        }
        ControlFlow::Continue(())
    }
}

/// Ends the query at the first hit.
pub(super) struct AnyHit(pub(super) Option<ItemId>);

impl HitPolicy for AnyHit {
    const ORDERED: bool = false;

    #[inline(always)]
    fn accept(&mut self, item: ItemId, _: Real, _: &mut Real) -> ControlFlow<()> {
        self.0 = Some(item);
        ControlFlow::Break(())
    }
}

impl<'q, E: Effects, T: Tally, G: HitPolicy> RayQuery<'q, E, T, G> {
    /// Whether flat and smooth triangles are supported.
    const TRIANGLES: [bool; 2] =
        [E::SET.shapes.contains(ShapeKind::Triangle), E::SET.shapes.contains(ShapeKind::SmoothTriangle)];

    /// A query for the items of `geometry` along `ray`, at most `t_max` away.
    pub(super) fn new(
        geometry: &'q Geometry<'q>,
        ray: &'q Ray,
        t_max: Real,
        kind: RayKind,
        tally: &'q mut T,
        policy: G,
    ) -> Self {
        let t_max = if t_max < Real::MAX { t_max } else { Real::MAX };
        RayQuery { geometry, ray, t_max, kind, tally, policy, effects: PhantomData }
    }

    /// Passes a hit to the policy if its `t` is at most `t_max`.
    #[inline(always)]
    fn accept_within(&mut self, item: ItemId, t: Option<Real>) -> ControlFlow<()> {
        match t {
            Some(t) if t <= self.t_max => self.policy.accept(item, t, &mut self.t_max),
            _ => ControlFlow::Continue(()),
        }
    }

    /// Intersects a shape.
    #[inline(always)]
    fn test_shape(&mut self, item: ItemId, shape: &Shape) -> ControlFlow<()> {
        self.count_shape_test(shape);
        self.accept_within(item, self.geometry.intersect::<E>(shape, self.ray))
    }

    /// Counts the test of a shape, by the kind of the shape.
    #[inline(always)]
    fn count_shape_test(&mut self, shape: &Shape) {
        if T::COUNTS_TESTS
            && let Some(kind) = self.geometry.kind(shape)
        {
            self.tally.count(CountedEvent::ShapeTest(self.kind, kind));
        }
    }

    /// Whether this triangle is flat or smooth as supported; known at compile time if both are.
    #[inline(always)]
    fn is_supported(&self, triangle: ItemId) -> bool {
        match Self::TRIANGLES {
            [true, true] => true,
            [flat, smooth] => match self.geometry.shape(triangle) {
                Some(Shape::Triangle(_)) => flat,
                Some(Shape::SmoothTriangle(_)) => smooth,
                _ => false,
            },
        }
    }

    /// Counts the test of an item.
    #[inline(always)]
    fn count_item_test(&mut self, item: ItemId) {
        if let Some(shape) = self.geometry.shape(item) {
            self.count_shape_test(shape);
        }
    }
}

impl<E: Effects, T: Tally, G: HitPolicy> Query for RayQuery<'_, E, T, G> {
    const ORDERED: bool = G::ORDERED;

    fn t_max(&self) -> Real {
        self.t_max
    }

    #[inline(always)]
    fn test_item(&mut self, item: ItemId) -> ControlFlow<()> {
        match self.geometry.shape(item) {
            Some(shape) => self.test_shape(item, shape),
            None => ControlFlow::Continue(()),
        }
    }

    #[inline(always)]
    fn test_first(&mut self, count: u32) -> ControlFlow<()> {
        // Written as a loop: an iterator's `try_for_each` would not be inlined in two callers.
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
        block.items_in_mask(!hits).for_each(|item| self.count_item_test(item));
        let mut mask = hits;
        while let Some(Candidate { item, corners }) = block.take_candidate(&mut mask) {
            match corners {
                Some(corners) if self.is_supported(item) => {
                    self.count_item_test(item);
                    self.accept_within(item, intersect_triangle(corners.each_ref(), self.ray))?;
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
