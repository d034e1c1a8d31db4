//! Octree traversal, and its special case: rays that lie in a cell plane.

use core::ops::ControlFlow;

use super::Octree;
use crate::accel::mailbox::{Mailbox, MailboxQuery};
use crate::accel::{Accelerator, Query};
use crate::geometry::Ray;
use crate::math::{Real, Vec3, floor, vec3};

impl<const MAILBOX_ENTRIES: usize> Accelerator for Octree<'_, MAILBOX_ENTRIES> {
    type Scratch = Mailbox<MAILBOX_ENTRIES>;

    fn traverse<Q: Query>(&self, ray: &Ray, mailbox: &mut Mailbox<MAILBOX_ENTRIES>, query: &mut Q) {
        query.count_box_tests(1);
        let Some(span) = self.bounds.intersect(ray) else { return };
        mailbox.begin_ray();
        let mut traverse = |ray: &Ray| {
            let t_max = query.t_max();
            let mut query = MailboxQuery { ray, item_bounds: self.item_bounds, mailbox, query };
            self.traverse_smart(ray, span, t_max, |leaf| query.test_items(self.leaf_entries(leaf)))
        };
        let end = if ray.inverse_direction.is_finite() {
            traverse(ray)
        } else {
            self.traverse_parallel(ray, traverse)
        };
        let (ControlFlow::Continue(()) | ControlFlow::Break(())) = end;
    }
}

impl<const MAILBOX_ENTRIES: usize> Octree<'_, MAILBOX_ENTRIES> {
    /// Traverses along a ray that is parallel to some cell planes.
    ///
    /// If the ray lies in a plane, it is traversed once on each side, because bounds that touch the plane are
    /// listed on one side only. The sign of the infinite reciprocal selects the side.
    #[cold]
    fn traverse_parallel(
        &self,
        ray: &Ray,
        mut traverse: impl FnMut(&Ray) -> ControlFlow<()>,
    ) -> ControlFlow<()> {
        let fractional_index = self.planes.fractional_index(ray.origin);
        let lies_in_plane = |offset: Real| {
            let index = |x: Real| floor(x + 0.5) + offset;
            let Vec3 { x, y, z } = fractional_index;
            let plane = self.planes.position(vec3(index(x), index(y), index(z)));
            let lies_in = |inverse: Real, plane: Real, origin: Real| !inverse.is_finite() && plane == origin;
            let (i, o) = (ray.inverse_direction, ray.origin);
            [lies_in(i.x, plane.x, o.x), lies_in(i.y, plane.y, o.y), lies_in(i.z, plane.z, o.z)]
        };
        // The nearest plane, and its neighbors in case the index is inaccurate.
        let [[x0, y0, z0], [x1, y1, z1], [x2, y2, z2]] = [-1.0, 0.0, 1.0].map(lies_in_plane);
        let signs = |lies_in_plane: bool| if lies_in_plane { &[1.0, -1.0][..] } else { &[1.0] };
        for x in signs(x0 | x1 | x2) {
            for y in signs(y0 | y1 | y2) {
                for z in signs(z0 | z1 | z2) {
                    let mut side = *ray;
                    side.inverse_direction *= vec3(*x, *y, *z);
                    traverse(&side)?;
                }
            }
        }
        ControlFlow::Continue(())
    }
}
