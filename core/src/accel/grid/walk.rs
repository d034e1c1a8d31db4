//! Walking through a grid: from cell to cell over the nearest wall.
//!
//! Along each axis the walk knows the number of the wall ahead and its distance. The distance is
//! computed from the number each time, as the slab test does it, and never summed up: it does not
//! drift, and the proof in [`cell_planes`] holds. A walk steps forward only, so it takes at most as many
//! steps as there are cells along the three axes together.
//!
//! Where a ray passes close to an edge or a corner of cells, so close that the next wall's widened
//! distance reaches another wall, the cells that lie between the two are entered too.
//!
//! Source: "A Fast Voxel Traversal Algorithm for Ray Tracing", Amanatides and Woo, Eurographics
//! 1987. Differs from it: no sums, and corners.
//!
//! [`cell_planes`]: crate::accel::cell_planes

use core::ops::ControlFlow;

use super::Grid;
use crate::accel::Regions;
use crate::geometry::{Ray, Span, WIDEN};
use crate::math::Real;

/// The way along one axis.
#[derive(Clone, Copy)]
struct Along {
    origin: Real,
    inverse: Real,
    first: Real,
    spacing: Real,
    /// The distance of the wall ahead; infinite when the ray runs along the walls.
    ahead: Real,
    /// The number of the wall ahead, and what to add for the one behind it.
    wall: Real,
    step: Real,
    /// What to add to the number of a cell for the next one; wraps.
    stride: usize,
    /// How many cells come after this one.
    left: u32,
}

impl Along {
    /// The way from the first cell whose far wall, widened, is not before `begin`; and how many
    /// cells there are before it.
    #[inline(always)]
    fn new(
        ray: (Real, Real, Real),
        walls: (Real, Real),
        cells: u32,
        stride: usize,
        begin: Real,
    ) -> (Self, u32) {
        let ((origin, direction, inverse), (first, spacing)) = (ray, walls);
        let last = cells.saturating_sub(1);
        let guess = |at: Real| {
            let cell = ((at - first) / spacing) as u32;
            if cell < last { cell } else { last }
        };
        let mut along = Along {
            origin,
            inverse,
            first,
            spacing,
            ahead: Real::INFINITY,
            wall: 0.0,
            step: 1.0,
            stride,
            left: 0,
        };
        if !(inverse.abs() <= Real::MAX) {
            // It stays in this cell for ever. In a wall it may stay on either side.
            let mut cell = guess(origin);
            while cell > 0 && origin < along.place(cell as Real) {
                cell -= 1;
            }
            while cell < last && origin > along.place(cell as Real + 1.0) {
                cell += 1;
            }
            return (along, cell);
        }
        let is_left_behind = |along: &Along, wall: u32| !(along.distance(wall as Real) * WIDEN >= begin);
        let mut cell = guess(origin + direction * begin);
        if inverse > 0.0 {
            while cell > 0 && !is_left_behind(&along, cell) {
                cell -= 1;
            }
            while cell < last && is_left_behind(&along, cell + 1) {
                cell += 1;
            }
            along.wall = cell as Real + 1.0;
            along.left = last - cell;
        } else {
            while cell < last && !is_left_behind(&along, cell + 1) {
                cell += 1;
            }
            while cell > 0 && is_left_behind(&along, cell) {
                cell -= 1;
            }
            along.wall = cell as Real;
            along.step = -1.0;
            along.stride = stride.wrapping_neg();
            along.left = cell;
        }
        along.ahead = along.distance(along.wall);
        (along, cell)
    }

    #[inline(always)]
    fn place(&self, wall: Real) -> Real {
        self.first + wall * self.spacing
    }

    #[inline(always)]
    fn distance(&self, wall: Real) -> Real {
        (self.place(wall) - self.origin) * self.inverse
    }

    /// Over the wall ahead; unless there is no cell behind it.
    #[inline(always)]
    fn cross(&mut self, cell: &mut usize) -> ControlFlow<()> {
        if self.left == 0 {
            return ControlFlow::Break(());
        }
        self.left -= 1;
        *cell = cell.wrapping_add(self.stride);
        self.wall += self.step;
        self.ahead = self.distance(self.wall);
        ControlFlow::Continue(())
    }

    /// How many walls ahead, behind which there are cells, are not beyond `edge`.
    fn walls_until(&self, edge: Real) -> u32 {
        let mut count = 0;
        let mut wall = self.wall;
        while count < self.left && self.distance(wall) <= edge {
            count += 1;
            wall += self.step;
        }
        count
    }
}

impl<const MAILBOX: usize> Grid<'_, MAILBOX> {
    /// Enters the cells along the ray that begin within reach, as long as `cells` have enough of none.
    ///
    /// `span` is the part of the ray in the bounds, and `reach` is finite.
    #[inline(always)]
    pub(super) fn along(&self, ray: &Ray, span: Span, mut reach: Real, cells: &mut impl Regions<usize>) {
        let begin = if span.entry > 0.0 { span.entry } else { 0.0 };
        if begin > reach {
            return;
        }
        let [width, height, depth] = self.cells;
        let row = width as usize;
        let layer = row * height as usize;
        let (first, spacing) = self.walls.first_and_spacing();
        let Ray { origin: o, direction: d, inverse: i, .. } = *ray;
        let (mut x, x0) = Along::new((o.x, d.x, i.x), (first.x, spacing.x), width, 1, begin);
        let (mut y, y0) = Along::new((o.y, d.y, i.y), (first.y, spacing.y), height, row, begin);
        let (mut z, z0) = Along::new((o.z, d.z, i.z), (first.z, spacing.z), depth, layer, begin);
        let mut cell = x0 as usize + y0 as usize * row + z0 as usize * layer;
        loop {
            match cells.enter(cell) {
                ControlFlow::Continue(left) => reach = left,
                ControlFlow::Break(()) => return,
            }
            let end = if x.ahead <= y.ahead && x.ahead <= z.ahead {
                step(&mut x, &y, &z, &mut cell, &mut reach, cells)
            } else if y.ahead <= z.ahead {
                step(&mut y, &x, &z, &mut cell, &mut reach, cells)
            } else {
                step(&mut z, &x, &y, &mut cell, &mut reach, cells)
            };
            if end.is_break() {
                return;
            }
        }
    }
}

/// Over the next wall, which is that of `near`; through the corners of cells there, if any.
#[inline(always)]
fn step(
    near: &mut Along,
    other: &Along,
    third: &Along,
    cell: &mut usize,
    reach: &mut Real,
    cells: &mut impl Regions<usize>,
) -> ControlFlow<()> {
    // Strictly beyond: an item at the same distance may have the lower number, and must win.
    if near.ahead > *reach {
        return ControlFlow::Break(());
    }
    let edge = near.ahead * WIDEN;
    if other.ahead <= edge || third.ahead <= edge {
        // Copies, so that the ways themselves can stay in registers.
        *reach = corner(*other, *third, *cell, edge, *reach, cells)?;
    }
    near.cross(cell)
}

/// Enters the cells behind the walls of two axes that are not beyond `edge`, but not behind the
/// wall of the third axis.
#[cold]
#[inline(never)]
fn corner(
    one: Along,
    two: Along,
    cell: usize,
    edge: Real,
    mut reach: Real,
    cells: &mut impl Regions<usize>,
) -> ControlFlow<(), Real> {
    let (more, most) = (one.walls_until(edge), two.walls_until(edge));
    let mut row = cell;
    for j in 0..=most {
        let mut cell = row;
        for i in 0..=more {
            if (i, j) != (0, 0) {
                reach = cells.enter(cell)?;
            }
            cell = cell.wrapping_add(one.stride);
        }
        row = row.wrapping_add(two.stride);
    }
    ControlFlow::Continue(reach)
}

#[cfg(test)]
mod tests {
    use core::ops::ControlFlow;

    use heapless::Vec;

    use crate::accel::test_rays::SplitMix64;
    use crate::accel::{Grid, GridRoom};
    use crate::geometry::{Aabb, Ray, Span, WIDEN};
    use crate::math::{Real, Vec3, vec3};

    const MOST: usize = 200;

    /// A grid of `8 x 5 x 3` cells or less, as `shape` says, round the cube from -1 to 1.
    fn with_grid(size: Vec3, density: Real, test: impl FnOnce(&Grid<'_, 0>)) {
        let boxes = [Aabb { min: -size, max: size }; 4];
        let (mut cells, mut entries) = ([0; MOST], [0; 4 * MOST]);
        test(&Grid::with_density(density, &boxes, &mut cells, &mut entries).unwrap());
    }

    fn numbers(grid: &Grid<'_, 0>, cell: usize) -> [u32; 3] {
        let [width, height, _] = grid.cells;
        let cell = cell as u32;
        [cell % width, cell / width % height, cell / (width * height)]
    }

    /// The cell between its walls.
    fn cell_box(grid: &Grid<'_, 0>, cell: usize) -> Aabb {
        let [x, y, z] = numbers(grid, cell).map(|n| n as Real);
        Aabb { min: grid.walls.position(vec3(x, y, z)), max: grid.walls.position(vec3(x, y, z) + 1.0) }
    }

    /// Walks the whole way, and holds the cells against all that the slab test says the ray meets,
    /// in the order of their beginnings. Answers how many there are.
    fn check(grid: &Grid<'_, 0>, ray: &Ray) -> usize {
        let mut walked = Vec::<usize, MOST>::new();
        if let Some(span) = grid.bounds.span(ray) {
            grid.along(ray, span, Real::MAX, &mut |cell| {
                walked.push(cell).expect("no cell is entered twice");
                ControlFlow::Continue(Real::MAX)
            });
        }
        let span = |cell: usize| cell_box(grid, cell).span(ray);
        let mut last = Real::NEG_INFINITY;
        for cell in &walked {
            let Some(Span { entry, .. }) = span(*cell) else { panic!("cell {cell} is not met by {ray:?}") };
            assert!(last <= 0.0 || entry * WIDEN >= last, "{entry} after {last}: {ray:?}");
            last = if entry > last { entry } else { last };
        }
        let runs_in_walls = [ray.inverse.x, ray.inverse.y, ray.inverse.z].map(|i| i.is_infinite());
        for cell in 0..grid.regions() {
            let is_met = span(cell).is_some() && grid.bounds.span(ray).is_some();
            // A ray in a wall walks on one side of it.
            let is_beside = |other: &usize| {
                let (a, b) = (numbers(grid, cell), numbers(grid, *other));
                (0..3).all(|axis| a[axis] == b[axis] || runs_in_walls[axis] && a[axis].abs_diff(b[axis]) == 1)
            };
            assert!(
                !is_met || walked.iter().any(is_beside),
                "{cell} of {:?} is left out: {ray:?}",
                grid.cells
            );
        }
        walked.len()
    }

    #[test]
    fn the_cells_of_a_walk_are_those_that_the_ray_meets_sorted_by_their_beginnings() {
        let mut random = SplitMix64(0x5eed_6001);
        let mut walked = 0;
        for (size, density, expected) in [
            (vec3(1.0, 0.625, 0.375), 30.0, [8, 5, 3]),
            (vec3(1.0, 1.0, 1.0), 16.0, [4, 4, 4]),
            (vec3(0.7, 1.0, 0.0), 20.0, [7, 11, 1]),
            (vec3(0.0, 1.0, 0.0), 3.0, [1, 12, 1]),
        ] {
            with_grid(size, density, |grid| {
                assert_eq!(grid.cells, expected);
                for _ in 0..250_000 {
                    let wall = |random: &mut SplitMix64| {
                        let [x, y, z] = grid.cells.map(|n| random.below(n + 1) as Real);
                        grid.walls.position(vec3(x, y, z))
                    };
                    walked += check(grid, &random.ray(wall));
                }
            });
        }
        assert!(walked > 1_000_000, "{walked}");
    }

    #[test]
    fn a_ray_through_the_corners_of_cells_enters_all_eight_round_each() {
        with_grid(Vec3::ONE, 16.0, |grid| {
            assert_eq!(check(grid, &Ray::new(vec3(-2.0, -2.0, -2.0), Vec3::ONE)), 4 + 3 * 6);
            assert_eq!(check(grid, &Ray::new(vec3(2.0, 2.0, -2.0), vec3(-1.0, -1.0, 1.0))), 4 + 3 * 6);
            // From the middle, which is a corner: half of the way.
            assert_eq!(check(grid, &Ray::new(Vec3::ZERO, Vec3::ONE)), 8 + 7);
        });
    }

    #[test]
    fn a_walk_ends_at_the_first_wall_beyond_its_reach() {
        with_grid(Vec3::ONE, 16.0, |grid| {
            let ray = Ray::new(vec3(-2.0, 0.1, 0.1), Vec3::X);
            let span = grid.bounds.span(&ray).unwrap();
            let wall = |number: Real| grid.walls.position(Vec3::splat(number)).x + 2.0;
            let count = |reach: Real| {
                let mut cells = 0;
                grid.along(&ray, span, reach, &mut |_| {
                    cells += 1;
                    ControlFlow::Continue(reach)
                });
                cells
            };
            assert_eq!((count(0.999), count(1.0)), (0, 1));
            // A wall at the very reach is stepped over.
            assert_eq!((count(wall(2.0).next_down()), count(wall(2.0))), (2, 3));
            assert_eq!((count(100.0), count(Real::MAX)), (4, 4));
        });
    }

    #[test]
    fn a_grid_of_nothing_is_walked_by_no_ray() {
        let room = GridRoom::comfortable(&[]);
        assert_eq!((room.cells, room.items), (2, 0));
        let mut cells = [7; 2];
        let grid = Grid::<0>::build(&[Aabb::EMPTY; 3], &mut cells, &mut []).unwrap();
        assert_eq!((grid.regions(), grid.entries(), grid.bytes()), (1, 0, 8 + 3 * size_of::<Aabb>()));
        assert_eq!(check(&grid, &Ray::new(Vec3::ZERO, Vec3::X)), 0);
    }
}
