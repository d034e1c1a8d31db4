//! Closest-hit and any-hit queries of a scene with an accelerator.
//!
//! [`World`] combines a scene and the accelerator of its items. A query traverses the accelerator, which
//! offers items near the ray; [`RayQuery`] intersects them, and its [`HitPolicy`] keeps the nearest hit or
//! stops at the first. Planes have no finite bounds, so they are not in the accelerator but tested before it.

use core::marker::PhantomData;
use core::ops::ControlFlow;

use super::Scene;
use super::effects::Effects;
use crate::accel::{Accelerator, Candidate, Query, TriangleBlock};
use crate::geometry::{Geometry, Hit, ItemId, Ray, Shape, ShapeKind, SurfaceInteraction, intersect_triangle};
use crate::math::{Real, Vec3};
use crate::tally::{CountedEvent, RayKind, Tally};

/// A scene and the accelerator of its items: answers ray queries.
///
/// ```
/// use strahl_core::geometry::{ItemId, Ray};
/// use strahl_core::tally::RayKind;
/// use strahl_core::*;
///
/// let shapes = [Shape::Sphere(Sphere { center: vec3(0.0, 0.0, -5.0), radius: 1.0 })];
/// let scene = Scene::new(SceneDescriptor {
///     geometry: Geometry { shapes: &shapes, ..Geometry::EMPTY },
///     material_ids: &[MaterialId(0)],
///     materials: &[Material::MATTE],
///     ..SceneDescriptor::EMPTY
/// })?;
/// let world = World::new(scene, BareList(1));
/// let ray = Ray::new(Vec3::ZERO, vec3(0.0, 0.0, -1.0));
/// let hit = world.nearest_hit::<AllEffects, _>(&ray, 100.0, RayKind::Camera, &mut (), &mut ()).unwrap();
/// assert_eq!((hit.item, hit.t), (ItemId(0), 4.0));
/// # Ok::<(), strahl_core::scene::SceneError>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct World<'s, A> {
    scene: Scene<'s>,
    accelerator: A,
}

impl<'s, A: Accelerator> World<'s, A> {
    /// Combines `scene` with the accelerator of its items.
    ///
    /// The accelerator must have been built from the bounds of the items ([`Geometry::all_bounds`]); items
    /// that it does not offer are not hit.
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

    /// Nearest hit along the ray, with `t` of at most `t_max`; `None` if there is none or the ray is not
    /// valid.
    ///
    /// Of hits with equal `t`, the one with the lower [`ItemId`]. Only the shapes of `E` are hit. `t` is
    /// measured in lengths of the ray's direction.
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

    /// [`World::nearest_hit`] of a ray that is known to be valid.
    // For the tracing loop only, so that it is inlined there and nowhere else.
    #[inline(always)]
    pub(crate) fn nearest_hit_unchecked<E: Effects, T: Tally>(
        &self,
        ray: &Ray,
        t_max: Real,
        kind: RayKind,
        scratch: &mut A::Scratch,
        tally: &mut T,
    ) -> Option<Hit> {
        // No item has the highest id, so a hit at exactly `t_max` wins against it.
        let policy = NearestHit(ItemId(u32::MAX));
        let mut query = RayQuery::<E, T, _>::new(self, ray, t_max, kind, tally, policy);
        self.run_query::<E, _>(ray, scratch, &mut query);
        let item = query.policy.0;
        (item != ItemId(u32::MAX)).then_some(Hit { t: query.t_max, item })
    }

    /// Any item that the ray hits with `t` of at most `t_max`; `None` if there is none or the ray is not
    /// valid.
    ///
    /// Only the shapes of `E` are hit.
    pub fn occluder<E: Effects, T: Tally>(
        &self,
        ray: &Ray,
        t_max: Real,
        kind: RayKind,
        scratch: &mut A::Scratch,
        tally: &mut T,
    ) -> Option<ItemId> {
        if ray.is_valid() { self.occluder_unchecked::<E, T>(ray, t_max, kind, scratch, tally) } else { None }
    }

    /// [`World::occluder`] of a ray that is known to be valid.
    pub(crate) fn occluder_unchecked<E: Effects, T: Tally>(
        &self,
        ray: &Ray,
        t_max: Real,
        kind: RayKind,
        scratch: &mut A::Scratch,
        tally: &mut T,
    ) -> Option<ItemId> {
        let mut query = RayQuery::<E, T, _>::new(self, ray, t_max, kind, tally, AnyHit(None));
        self.run_query::<E, _>(ray, scratch, &mut query);
        query.policy.0
    }

    /// Whether the ray hits this item with `t` of at most `t_max`.
    ///
    /// The result is that of [`World::occluder`] in a scene without other items.
    pub fn is_occluded_by<E: Effects, T: Tally>(
        &self,
        item: ItemId,
        ray: &Ray,
        t_max: Real,
        kind: RayKind,
        tally: &mut T,
    ) -> bool {
        let mut query = RayQuery::<E, T, _>::new(self, ray, t_max, kind, tally, AnyHit(None));
        query.test_item(item).is_break()
    }

    /// Point, normals and error bounds of the surface at a hit; `None` if there is no such item.
    #[inline(always)]
    pub fn surface_interaction<E: Effects>(&self, ray: &Ray, hit: Hit) -> Option<SurfaceInteraction> {
        let geometry = &self.scene.descriptor().geometry;
        geometry.surface_interaction::<E>(geometry.shape(hit.item)?, ray, hit.t)
    }

    /// Shadow terminator offset of a point of a smooth item; `None` for other items.
    ///
    /// * `point`: on the item, at rest.
    /// * `front_face`: whether the shadow ray starts on the side of the vertex normals.
    pub(crate) fn terminator_offset<E: Effects>(
        &self,
        item: ItemId,
        point: Vec3,
        front_face: bool,
    ) -> Option<Vec3> {
        let geometry = &self.scene.descriptor().geometry;
        geometry.terminator_offset::<E>(*geometry.static_shape(geometry.shape(item)?)?, point, front_face)
    }

    /// Displacement of an item at `time`; zero for items at rest.
    #[inline(always)]
    pub(crate) fn motion_offset<E: Effects>(&self, item: ItemId, time: Real) -> Vec3 {
        if !(E::SET.motion_blur && self.scene.required_effects().motion_blur) {
            return Vec3::ZERO;
        }
        let geometry = &self.scene.descriptor().geometry;
        geometry.shape(item).map_or(Vec3::ZERO, |shape| geometry.motion_offset(shape, time))
    }

    /// Tests the planes, which are not in the accelerator, and then traverses it. Planes first, because their
    /// hits reduce `t_max`.
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

/// A query: intersects the items that an accelerator offers.
struct RayQuery<'q, E, T, G> {
    geometry: &'q Geometry<'q>,
    ray: &'q Ray,
    /// Largest `t` at which a hit is accepted. Finite, so that an infinite `t` never is.
    t_max: Real,
    kind: RayKind,
    tally: &'q mut T,
    policy: G,
    effects: PhantomData<E>,
}

/// Which hits a query keeps.
trait HitPolicy {
    /// Whether nearer hits replace farther ones, so that front-to-back traversal pays.
    const ORDERED: bool;

    /// Takes a hit with `t` of at most `t_max`; may reduce `t_max`. `Break` ends the query.
    fn accept(&mut self, item: ItemId, t: Real, t_max: &mut Real) -> ControlFlow<()>;
}

/// Keeps the nearest hit, which becomes `t_max`.
struct NearestHit(ItemId);

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
struct AnyHit(Option<ItemId>);

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

    fn new<A>(
        world: &'q World<'_, A>,
        ray: &'q Ray,
        t_max: Real,
        kind: RayKind,
        tally: &'q mut T,
        policy: G,
    ) -> Self {
        let t_max = if t_max < Real::MAX { t_max } else { Real::MAX };
        let geometry = &world.scene.descriptor().geometry;
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
    fn test_range(&mut self, count: u32) -> ControlFlow<()> {
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
