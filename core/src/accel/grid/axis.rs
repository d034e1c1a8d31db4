//! One axis of the traversal of a grid: the next cell plane and its `t`.

use core::ops::ControlFlow;

use crate::geometry::WIDEN;
use crate::math::Real;

/// The state of a traversal along one axis.
#[derive(Clone, Copy)]
pub(super) struct AxisTraversal {
    origin: Real,
    inverse: Real,
    first_plane: Real,
    plane_spacing: Real,
    /// The `t` of the next plane; infinite if the ray is parallel to the planes.
    pub(super) next_crossing_t: Real,
    /// Index of the next plane.
    next_plane: Real,
    /// Difference between the indices of two planes that follow each other along the ray: 1 or -1.
    step: Real,
    /// Difference between the indices of two cells that follow each other along the ray; wraps around.
    pub(super) stride: usize,
    /// Number of cells after the current one.
    cells_left: u32,
}

impl AxisTraversal {
    /// The state in the first cell that does not end before `t_begin`, even after widening, and the index of
    /// this cell along the axis.
    ///
    /// * `ray`: components of origin, direction and reciprocal of the direction.
    /// * `planes`: position of plane 0, and the distance between planes.
    /// * `cells`: number of cells.
    /// * `stride`: difference between the indices of neighboring cells.
    #[inline(always)]
    pub(super) fn new(
        ray: (Real, Real, Real),
        planes: (Real, Real),
        cells: u32,
        stride: usize,
        t_begin: Real,
    ) -> (Self, u32) {
        let ((origin, direction, inverse), (first_plane, plane_spacing)) = (ray, planes);
        let last = cells.saturating_sub(1);
        let estimate = |position: Real| {
            let cell = ((position - first_plane) / plane_spacing) as u32;
            if cell < last { cell } else { last }
        };
        let mut axis = AxisTraversal {
            origin,
            inverse,
            first_plane,
            plane_spacing,
            next_crossing_t: Real::INFINITY,
            next_plane: 0.0,
            step: 1.0,
            stride,
            cells_left: 0,
        };
        if !(inverse.abs() <= Real::MAX) {
            // Parallel to the planes: it stays in one cell. In a plane, either side is right.
            let mut cell = estimate(origin);
            while cell > 0 && origin < axis.plane_position(cell as Real) {
                cell -= 1;
            }
            while cell < last && origin > axis.plane_position(cell as Real + 1.0) {
                cell += 1;
            }
            return (axis, cell);
        }
        let is_before_begin =
            |axis: &AxisTraversal, plane: u32| !(axis.plane_t(plane as Real) * WIDEN >= t_begin);
        let mut cell = estimate(origin + direction * t_begin);
        if inverse > 0.0 {
            while cell > 0 && !is_before_begin(&axis, cell) {
                cell -= 1;
            }
            while cell < last && is_before_begin(&axis, cell + 1) {
                cell += 1;
            }
            axis.next_plane = cell as Real + 1.0;
            axis.cells_left = last - cell;
        } else {
            while cell < last && !is_before_begin(&axis, cell + 1) {
                cell += 1;
            }
            while cell > 0 && is_before_begin(&axis, cell) {
                cell -= 1;
            }
            axis.next_plane = cell as Real;
            axis.step = -1.0;
            axis.stride = stride.wrapping_neg();
            axis.cells_left = cell;
        }
        axis.next_crossing_t = axis.plane_t(axis.next_plane);
        (axis, cell)
    }

    /// Position of a plane along the axis, by its index.
    #[inline(always)]
    fn plane_position(&self, plane: Real) -> Real {
        self.first_plane + plane * self.plane_spacing
    }

    /// The `t` of a plane, computed as in the slab test.
    #[inline(always)]
    fn plane_t(&self, plane: Real) -> Real {
        (self.plane_position(plane) - self.origin) * self.inverse
    }

    /// Steps over the next plane into the next cell; breaks if there is none.
    #[inline(always)]
    pub(super) fn advance(&mut self, cell: &mut usize) -> ControlFlow<()> {
        if self.cells_left == 0 {
            return ControlFlow::Break(());
        }
        self.cells_left -= 1;
        *cell = cell.wrapping_add(self.stride);
        self.next_plane += self.step;
        self.next_crossing_t = self.plane_t(self.next_plane);
        ControlFlow::Continue(())
    }

    /// Number of the next planes that are not beyond `t` and have a cell behind them.
    pub(super) fn planes_within(&self, t: Real) -> u32 {
        let mut count = 0;
        let mut plane = self.next_plane;
        while count < self.cells_left && self.plane_t(plane) <= t {
            count += 1;
            plane += self.step;
        }
        count
    }
}
