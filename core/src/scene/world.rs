//! The scene and the accelerator that knows where its items lie: answers to rays.

use core::marker::PhantomData;
use core::ops::ControlFlow;

use super::Scene;
use super::effects::Effects;
use crate::accel::{Accelerator, Query};
use crate::geometry::{Geometry, Hit, ItemId, Ray, ShapeKind, Surface};
use crate::math::Real;
use crate::tally::{Event, RayKind, Tally};

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
    pub fn nearest<E: Effects, T: Tally>(
        &self,
        ray: &Ray,
        reach: Real,
        kind: RayKind,
        scratch: &mut A::Scratch,
        tally: &mut T,
    ) -> Option<Hit> {
        let search = Search::<E, T>::new(self, ray, reach, kind, tally);
        // No item has the highest number: the first at the very reach wins against it.
        let mut query = Nearest { search, item: ItemId(u32::MAX) };
        self.ask::<E, _>(ray, scratch, &mut query);
        (query.item != ItemId(u32::MAX)).then_some(Hit { t: query.search.reach, item: query.item })
    }

    /// Some item along the ray, at most `reach` lengths of its direction away.
    ///
    /// Only the shapes of `E` can be in the way.
    pub fn blocker<E: Effects, T: Tally>(
        &self,
        ray: &Ray,
        reach: Real,
        kind: RayKind,
        scratch: &mut A::Scratch,
        tally: &mut T,
    ) -> Option<ItemId> {
        let search = Search::<E, T>::new(self, ray, reach, kind, tally);
        let mut query = Blocker { search, item: None };
        self.ask::<E, _>(ray, scratch, &mut query);
        query.item
    }

    /// What the item that was hit is like there.
    pub fn surface<E: Effects>(&self, ray: &Ray, hit: Hit) -> Option<Surface> {
        let geometry = &self.scene.parts().geometry;
        geometry.surface::<E>(geometry.shape(hit.item)?, ray, hit.t)
    }

    /// Planes have no box, so they are tested here and first: what they leave in reach is less.
    fn ask<E: Effects, Q: Query>(&self, ray: &Ray, scratch: &mut A::Scratch, query: &mut Q) {
        if !ray.is_sound() {
            return;
        }
        if E::SET.shapes.has(ShapeKind::Plane) {
            for plane in self.scene.parts().geometry.planes {
                if query.test(plane.item).is_break() {
                    return;
                }
            }
        }
        self.accelerator.walk(ray, scratch, query);
    }
}

/// A ray on its way, and the far limit of what it looks for.
struct Search<'q, E, T> {
    geometry: &'q Geometry<'q>,
    ray: &'q Ray,
    /// Finite, so that an infinite distance is beyond every reach.
    reach: Real,
    kind: RayKind,
    tally: &'q mut T,
    effects: PhantomData<E>,
}

impl<'q, E: Effects, T: Tally> Search<'q, E, T> {
    fn new<A>(world: &'q World<'_, A>, ray: &'q Ray, reach: Real, kind: RayKind, tally: &'q mut T) -> Self {
        let reach = if reach < Real::MAX { reach } else { Real::MAX };
        Search { geometry: &world.scene.parts().geometry, ray, reach, kind, tally, effects: PhantomData }
    }

    /// How far away the item is, if it is met within reach.
    #[inline(always)]
    fn distance(&mut self, item: ItemId) -> Option<Real> {
        let shape = self.geometry.shape(item)?;
        self.tally.count(Event::Shape(self.kind, shape.kind()));
        self.geometry.distance::<E>(shape, self.ray).filter(|t| *t <= self.reach)
    }

    fn boxes(&mut self, count: u32) {
        self.tally.count(Event::Boxes(self.kind, count));
    }

    fn enter(&mut self) {
        self.tally.count(Event::Region(self.kind));
    }

    fn skipped(&mut self) {
        self.tally.count(Event::Skipped(self.kind));
    }
}

/// Looks for the nearest item: every hit shortens the reach.
struct Nearest<'q, E, T> {
    search: Search<'q, E, T>,
    item: ItemId,
}

impl<E: Effects, T: Tally> Query for Nearest<'_, E, T> {
    fn reach(&self) -> Real {
        self.search.reach
    }

    #[inline(always)]
    fn test(&mut self, item: ItemId) -> ControlFlow<()> {
        if let Some(t) = self.search.distance(item)
            && (t < self.search.reach || item < self.item)
        {
            self.search.reach = t;
            self.item = item;
        }
        ControlFlow::Continue(())
    }

    fn boxes(&mut self, count: u32) {
        self.search.boxes(count);
    }

    fn enter(&mut self) {
        self.search.enter();
    }

    fn skipped(&mut self) {
        self.search.skipped();
    }
}

/// Looks for any item: the first ends the walk.
struct Blocker<'q, E, T> {
    search: Search<'q, E, T>,
    item: Option<ItemId>,
}

impl<E: Effects, T: Tally> Query for Blocker<'_, E, T> {
    fn reach(&self) -> Real {
        self.search.reach
    }

    #[inline(always)]
    fn test(&mut self, item: ItemId) -> ControlFlow<()> {
        match self.search.distance(item) {
            Some(_) => {
                self.item = Some(item);
                ControlFlow::Break(())
            }
            None => ControlFlow::Continue(()),
        }
    }

    fn boxes(&mut self, count: u32) {
        self.search.boxes(count);
    }

    fn enter(&mut self) {
        self.search.enter();
    }

    fn skipped(&mut self) {
        self.search.skipped();
    }
}
