//! Closest-hit and any-hit queries of a scene with an accelerator.
//!
//! [`World`] combines a scene and the accelerator of its items. A query traverses the accelerator, which
//! offers items near the ray; [`RayQuery`] intersects them, and keeps the nearest hit or stops at the first.
//! Planes have no finite bounds, so they are not in the accelerator but tested before it.

use super::Scene;
use super::effects::Effects;
use super::ray_query::{AnyHit, NearestHit, RayQuery};
use crate::accel::{Accelerator, Query};
use crate::geometry::{Geometry, Hit, ItemId, Ray, ShapeKind, SurfaceInteraction};
use crate::math::{Real, Vec3};
use crate::tally::{RayKind, Tally};

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
/// let world = World::new(scene, ListWithoutBounds(1));
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
    /// The accelerator must have been built from the bounds of the items ([`Geometry::all_bounds`]). Bounded
    /// items that it does not offer are not hit; planes always are.
    ///
    /// [`Geometry::all_bounds`]: crate::Geometry::all_bounds
    pub fn new(scene: Scene<'s>, accelerator: A) -> Self {
        World { scene, accelerator }
    }

    /// The scene of this world.
    pub fn scene(&self) -> &Scene<'s> {
        &self.scene
    }

    /// The accelerator of the items of the scene.
    pub fn accelerator(&self) -> &A {
        &self.accelerator
    }

    /// Nearest hit along the ray, with `t` of at most `t_max`; `None` if there is none or the ray is not
    /// valid.
    ///
    /// Of hits with equal `t`, the one with the lower [`ItemId`]. Only the shapes of `E` are hit. `t` is
    /// measured in lengths of the ray's direction; `kind` is for the tally only.
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
        let mut query = RayQuery::<E, T, _>::new(self.geometry(), ray, t_max, kind, tally, policy);
        self.run_query::<E, _>(ray, scratch, &mut query);
        let item = query.policy.0;
        (item != ItemId(u32::MAX)).then_some(Hit { t: query.t_max, item })
    }

    /// Any item that the ray hits with `t` of at most `t_max`, not necessarily the nearest; `None` if there
    /// is none or the ray is not valid.
    ///
    /// Only the shapes of `E` are hit. `t` is measured in lengths of the ray's direction; `kind` is for the
    /// tally only.
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
        let mut query = RayQuery::<E, T, _>::new(self.geometry(), ray, t_max, kind, tally, AnyHit(None));
        self.run_query::<E, _>(ray, scratch, &mut query);
        query.policy.0
    }

    /// Whether the ray hits this item with `t` of at most `t_max`; false if there is no such item.
    ///
    /// The result for a valid ray is that of [`World::occluder`] in a scene without other items.
    pub fn is_occluded_by<E: Effects, T: Tally>(
        &self,
        item: ItemId,
        ray: &Ray,
        t_max: Real,
        kind: RayKind,
        tally: &mut T,
    ) -> bool {
        let mut query = RayQuery::<E, T, _>::new(self.geometry(), ray, t_max, kind, tally, AnyHit(None));
        query.test_item(item).is_break()
    }

    /// Point, normals and error bounds of the surface at a hit; `None` if there is no such item.
    #[inline(always)]
    pub fn surface_interaction<E: Effects>(&self, ray: &Ray, hit: Hit) -> Option<SurfaceInteraction> {
        let geometry = self.geometry();
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
        let geometry = self.geometry();
        geometry.terminator_offset::<E>(*geometry.static_shape(geometry.shape(item)?)?, point, front_face)
    }

    /// Displacement of an item at `time`; zero for items at rest.
    #[inline(always)]
    pub(crate) fn motion_offset<E: Effects>(&self, item: ItemId, time: Real) -> Vec3 {
        if !(E::SET.motion_blur && self.scene.required_effects().motion_blur) {
            return Vec3::ZERO;
        }
        let geometry = self.geometry();
        geometry.shape(item).map_or(Vec3::ZERO, |shape| geometry.motion_offset(shape, time))
    }

    /// The shapes of the scene.
    fn geometry(&self) -> &Geometry<'s> {
        &self.scene.descriptor().geometry
    }

    /// Tests the planes, which are not in the accelerator, and then traverses it. Planes first, because their
    /// hits reduce `t_max`.
    #[inline(always)]
    fn run_query<E: Effects, Q: Query>(&self, ray: &Ray, scratch: &mut A::Scratch, query: &mut Q) {
        if E::SET.shapes.contains(ShapeKind::Plane) {
            for plane in self.geometry().planes {
                if query.test_item(plane.item).is_break() {
                    return;
                }
            }
        }
        self.accelerator.traverse(ray, scratch, query);
    }
}
