//! Grid traversal: from cell to cell over the nearest cell plane.
//!
//! Each axis keeps the index of the next plane and its `t`. The `t` is computed from the index each time, as
//! in the slab test, and never accumulated: it does not drift, and the proof in [`cell_planes`] holds. A
//! traversal only steps forward, so it takes at most as many steps as there are cells along the three axes
//! together.
//!
//! Where a ray passes so close to an edge or a corner of cells that the widened `t` of the next plane reaches
//! another plane, the cells between the two are visited too.
//!
//! Source: Amanatides and Woo, "A Fast Voxel Traversal Algorithm for Ray Tracing", Eurographics 1987.
//! Difference: `t` is not accumulated, and all cells at an edge or corner are visited.
//!
//! [`cell_planes`]: crate::accel::cell_planes

use core::ops::ControlFlow;

use super::Grid;
use super::axis::AxisTraversal;
use crate::accel::mailbox::{Mailbox, MailboxQuery};
use crate::accel::{Accelerator, Query};
use crate::geometry::{Ray, RayInterval, WIDEN};
use crate::math::Real;

impl<const MAILBOX_ENTRIES: usize> Accelerator for Grid<'_, MAILBOX_ENTRIES> {
    type Scratch = Mailbox<MAILBOX_ENTRIES>;

    /// Not inlined, so that the loop has the registers to itself.
    #[inline(never)]
    fn traverse<Q: Query>(&self, ray: &Ray, mailbox: &mut Mailbox<MAILBOX_ENTRIES>, query: &mut Q) {
        query.count_box_tests(1);
        let Some(span) = self.bounds.intersect(ray) else { return };
        mailbox.begin_ray();
        let t_max = query.t_max();
        let query = MailboxQuery { ray, item_bounds: self.item_bounds, mailbox, query };
        self.visit_cells(ray, span, t_max, &mut GridVisitor { grid: self, query });
    }
}

/// Visits the cells along a ray.
///
/// A trait instead of a closure, because the traversal has two calls of it, of which only the common one is
/// to be inlined; the captures of a closure would be in memory for both.
trait CellVisitor {
    /// Visits a cell, by its index. Returns the remaining `t_max`, or breaks.
    fn visit_cell(&mut self, cell: usize) -> ControlFlow<(), Real>;
}

#[cfg(test)]
impl<F: FnMut(usize) -> ControlFlow<(), Real>> CellVisitor for F {
    fn visit_cell(&mut self, cell: usize) -> ControlFlow<(), Real> {
        self(cell)
    }
}

/// Tests the items of each visited cell.
struct GridVisitor<'a, Q, const MAILBOX_ENTRIES: usize> {
    grid: &'a Grid<'a, MAILBOX_ENTRIES>,
    query: MailboxQuery<'a, Q, MAILBOX_ENTRIES>,
}

impl<Q: Query, const MAILBOX_ENTRIES: usize> CellVisitor for GridVisitor<'_, Q, MAILBOX_ENTRIES> {
    #[inline(always)]
    fn visit_cell(&mut self, cell: usize) -> ControlFlow<(), Real> {
        self.query.test_items(self.grid.cell_entries(cell))
    }
}

impl<const MAILBOX_ENTRIES: usize> Grid<'_, MAILBOX_ENTRIES> {
    /// Visits the cells along the ray that begin within `t_max`, until `visitor` breaks.
    ///
    /// `span`: the interval of the ray in the bounds. `t_max`: finite.
    #[inline(always)]
    fn visit_cells(&self, ray: &Ray, span: RayInterval, mut t_max: Real, visitor: &mut impl CellVisitor) {
        let t_begin = if span.t_entry > 0.0 { span.t_entry } else { 0.0 };
        if t_begin > t_max {
            return;
        }
        let [width, height, depth] = self.resolution;
        let row = width as usize;
        let layer = row * height as usize;
        let (first, spacing) = self.planes.first_and_spacing();
        let Ray { origin: o, direction: d, inverse_direction: i, .. } = *ray;
        let (mut x, x0) = AxisTraversal::new((o.x, d.x, i.x), (first.x, spacing.x), width, 1, t_begin);
        let (mut y, y0) = AxisTraversal::new((o.y, d.y, i.y), (first.y, spacing.y), height, row, t_begin);
        let (mut z, z0) = AxisTraversal::new((o.z, d.z, i.z), (first.z, spacing.z), depth, layer, t_begin);
        let mut cell = x0 as usize + y0 as usize * row + z0 as usize * layer;
        loop {
            match visitor.visit_cell(cell) {
                ControlFlow::Continue(remaining) => t_max = remaining,
                ControlFlow::Break(()) => return,
            }
            let end = if x.next_crossing_t <= y.next_crossing_t && x.next_crossing_t <= z.next_crossing_t {
                step_axis(&mut x, &y, &z, &mut cell, &mut t_max, visitor)
            } else if y.next_crossing_t <= z.next_crossing_t {
                step_axis(&mut y, &x, &z, &mut cell, &mut t_max, visitor)
            } else {
                step_axis(&mut z, &x, &y, &mut cell, &mut t_max, visitor)
            };
            if end.is_break() {
                return;
            }
        }
    }
}

/// Steps over the next plane of `nearest`, the axis whose next plane comes first. Visits the other cells
/// around the edge or corner there, if the ray passes close to one.
#[inline(always)]
fn step_axis(
    nearest: &mut AxisTraversal,
    second: &AxisTraversal,
    third: &AxisTraversal,
    cell: &mut usize,
    t_max: &mut Real,
    visitor: &mut impl CellVisitor,
) -> ControlFlow<()> {
    // The end only if strictly beyond: at equal `t` the item with the lower id wins, and it may be in the
    // next cell.
    if nearest.next_crossing_t > *t_max {
        return ControlFlow::Break(());
    }
    let widened_t = nearest.next_crossing_t * WIDEN;
    if second.next_crossing_t <= widened_t || third.next_crossing_t <= widened_t {
        // Copies, so that the originals can stay in registers.
        *t_max = visit_corner_cells(*second, *third, *cell, widened_t, *t_max, visitor)?;
    }
    nearest.advance(cell)
}

/// Visits the cells behind the planes of two axes up to `widened_t`, but before the plane of the third axis.
#[cold]
#[inline(never)]
fn visit_corner_cells(
    first: AxisTraversal,
    second: AxisTraversal,
    cell: usize,
    widened_t: Real,
    mut t_max: Real,
    visitor: &mut impl CellVisitor,
) -> ControlFlow<(), Real> {
    let (first_count, second_count) = (first.planes_within(widened_t), second.planes_within(widened_t));
    let mut row = cell;
    for j in 0..=second_count {
        let mut cell = row;
        for i in 0..=first_count {
            if (i, j) != (0, 0) {
                t_max = visitor.visit_cell(cell)?;
            }
            cell = cell.wrapping_add(first.stride);
        }
        row = row.wrapping_add(second.stride);
    }
    ControlFlow::Continue(t_max)
}

#[cfg(test)]
mod tests {
    use core::ops::ControlFlow;

    use heapless::Vec;

    use crate::accel::test_rays::SplitMix64;
    use crate::accel::{Grid, GridSize};
    use crate::geometry::{Aabb, Ray, RayInterval, WIDEN};
    use crate::math::{Real, Vec3, vec3};

    const MAX_CELLS: usize = 200;

    /// Calls `test` with the grid of the box from `-size` to `size`.
    fn with_grid(size: Vec3, density: Real, test: impl FnOnce(&Grid<'_, 0>)) {
        let boxes = [Aabb { min: -size, max: size }; 4];
        let (mut cells, mut entries) = ([0; MAX_CELLS], [0; 4 * MAX_CELLS]);
        test(&Grid::build_with_density(density, &boxes, &mut cells, &mut entries).unwrap());
    }

    #[test]
    fn a_density_that_is_out_of_range_gives_the_finest_or_coarsest_grid() {
        with_grid(Vec3::ONE, Real::INFINITY, |grid| assert!((50..MAX_CELLS).contains(&grid.cell_count())));
        for density in [Real::NAN, Real::NEG_INFINITY, -1.0, 0.0] {
            with_grid(Vec3::ONE, density, |grid| assert_eq!(grid.cell_count(), 1));
        }
    }

    /// The index of a cell along each axis.
    fn cell_coordinates(grid: &Grid<'_, 0>, cell: usize) -> [u32; 3] {
        let [width, height, _] = grid.resolution;
        let cell = cell as u32;
        [cell % width, cell / width % height, cell / (width * height)]
    }

    /// The box between the planes of a cell.
    fn cell_bounds(grid: &Grid<'_, 0>, cell: usize) -> Aabb {
        let [x, y, z] = cell_coordinates(grid, cell).map(|n| n as Real);
        Aabb { min: grid.planes.position(vec3(x, y, z)), max: grid.planes.position(vec3(x, y, z) + 1.0) }
    }

    /// Visits all cells along the ray, and checks that they are those that the slab test finds, in the order
    /// of `t_entry`. Returns their number.
    fn check(grid: &Grid<'_, 0>, ray: &Ray) -> usize {
        let mut visited = Vec::<usize, MAX_CELLS>::new();
        if let Some(span) = grid.bounds.intersect(ray) {
            grid.visit_cells(ray, span, Real::MAX, &mut |cell| {
                visited.push(cell).expect("no cell is visited twice");
                ControlFlow::Continue(Real::MAX)
            });
        }
        let span = |cell: usize| cell_bounds(grid, cell).intersect(ray);
        let mut last = Real::NEG_INFINITY;
        for cell in &visited {
            let Some(RayInterval { t_entry: entry, .. }) = span(*cell) else {
                panic!("{ray:?} misses cell {cell}")
            };
            assert!(last <= 0.0 || entry * WIDEN >= last, "{entry} after {last}: {ray:?}");
            last = if entry > last { entry } else { last };
        }
        let is_parallel = [ray.inverse_direction.x, ray.inverse_direction.y, ray.inverse_direction.z]
            .map(|i| i.is_infinite());
        for cell in 0..grid.cell_count() {
            let is_hit = span(cell).is_some() && grid.bounds.intersect(ray).is_some();
            // Of the cells on both sides of a plane that contains the ray, one is visited.
            let is_beside = |other: &usize| {
                let (a, b) = (cell_coordinates(grid, cell), cell_coordinates(grid, *other));
                (0..3).all(|axis| a[axis] == b[axis] || is_parallel[axis] && a[axis].abs_diff(b[axis]) == 1)
            };
            assert!(
                !is_hit || visited.iter().any(is_beside),
                "cell {cell} of {:?} is not visited: {ray:?}",
                grid.resolution
            );
        }
        visited.len()
    }

    #[test]
    fn traversal_visits_the_cells_on_the_ray_in_order_of_t_entry() {
        let mut random = SplitMix64(0x5eed_6001);
        let mut visit_count = 0;
        for (size, density, expected) in [
            (vec3(1.0, 0.625, 0.375), 30.0, [8, 5, 3]),
            (vec3(1.0, 1.0, 1.0), 16.0, [4, 4, 4]),
            (vec3(0.7, 1.0, 0.0), 20.0, [7, 11, 1]),
            (vec3(0.0, 1.0, 0.0), 3.0, [1, 12, 1]),
        ] {
            with_grid(size, density, |grid| {
                assert_eq!(grid.resolution, expected);
                for _ in 0..250_000 {
                    let plane = |random: &mut SplitMix64| {
                        let [x, y, z] = grid.resolution.map(|n| random.below(n + 1) as Real);
                        grid.planes.position(vec3(x, y, z))
                    };
                    visit_count += check(grid, &random.ray(plane));
                }
            });
        }
        assert!(visit_count > 1_000_000, "{visit_count}");
    }

    #[test]
    fn a_ray_through_cell_corners_visits_all_eight_cells_around_each() {
        with_grid(Vec3::ONE, 16.0, |grid| {
            assert_eq!(check(grid, &Ray::new(vec3(-2.0, -2.0, -2.0), Vec3::ONE)), 4 + 3 * 6);
            assert_eq!(check(grid, &Ray::new(vec3(2.0, 2.0, -2.0), vec3(-1.0, -1.0, 1.0))), 4 + 3 * 6);
            // From the center, which is a corner of cells.
            assert_eq!(check(grid, &Ray::new(Vec3::ZERO, Vec3::ONE)), 8 + 7);
        });
    }

    #[test]
    fn traversal_ends_at_the_first_plane_beyond_t_max() {
        with_grid(Vec3::ONE, 16.0, |grid| {
            let ray = Ray::new(vec3(-2.0, 0.1, 0.1), Vec3::X);
            let span = grid.bounds.intersect(&ray).unwrap();
            let plane_t = |index: Real| grid.planes.position(Vec3::splat(index)).x + 2.0;
            let count = |t_max: Real| {
                let mut cells = 0;
                grid.visit_cells(&ray, span, t_max, &mut |_| {
                    cells += 1;
                    ControlFlow::Continue(t_max)
                });
                cells
            };
            assert_eq!((count(0.999), count(1.0)), (0, 1));
            // A plane at `t_max` itself is not beyond it.
            assert_eq!((count(plane_t(2.0).next_down()), count(plane_t(2.0))), (2, 3));
            assert_eq!((count(100.0), count(Real::MAX)), (4, 4));
        });
    }

    #[test]
    fn an_empty_grid_visits_no_cell() {
        let size = GridSize::recommended(&[]);
        assert_eq!((size.cells, size.entries), (2, 0));
        let mut cells = [7; 2];
        let grid = Grid::<0>::build(&[Aabb::EMPTY; 3], &mut cells, &mut []).unwrap();
        assert_eq!(
            (grid.cell_count(), grid.entry_count(), grid.size_in_bytes()),
            (1, 0, 8 + 3 * size_of::<Aabb>())
        );
        assert_eq!(check(&grid, &Ray::new(Vec3::ZERO, Vec3::X)), 0);
    }
}
