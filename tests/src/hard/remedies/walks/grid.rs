//! The walk through a grid.

use std::ops::ControlFlow;

use strahl_core::{Aabb, Vec3};

use super::{Met, Nearest, Ready, WIDEN, Walls, span};

/// A grid of about [`CELLS`] cells for each box.
pub struct Grid {
    boxes: Vec<Aabb>,
    bounds: Aabb,
    walls: Walls,
    cells: [u32; 3],
    /// For each cell, where its items begin; they end where those of the next one begin.
    starts: Vec<u32>,
    items: Vec<u32>,
}

impl AsRef<[Aabb]> for Grid {
    fn as_ref(&self) -> &[Aabb] {
        &self.boxes
    }
}

const CELLS: f32 = 8.0;

/// So many cells, as cubic as whole numbers allow: how many along each axis.
fn resolution(extent: Vec3, count: f32) -> Vec3 {
    let sides = extent.to_array().into_iter().filter(|side| *side > 0.0);
    let (axes, space) = sides.fold((0, 1.0), |(axes, space), side| (axes + 1, space * side));
    let side = libm::powf(space / count, 1.0 / axes as f32);
    let cells = |extent: f32| {
        let cells = libm::roundf(extent / side);
        if !(cells > 1.0) {
            1.0
        } else if cells < MOST_ALONG {
            cells
        } else {
            MOST_ALONG
        }
    };
    Vec3::from_array(extent.to_array().map(cells))
}

const MOST_ALONG: f32 = 4096.0;

impl Grid {
    /// `TOUCHED`: a box is listed on both sides of a wall that it touches, held against the walls
    /// themselves; else in the cells from that of its lower corner to that of the other.
    pub fn of<const TOUCHED: bool>(boxes: Vec<Aabb>) -> Grid {
        let bounds = boxes.iter().fold(Aabb::EMPTY, |all, aabb| all.union(*aabb));
        let cells = resolution(bounds.max - bounds.min, CELLS * boxes.len() as f32);
        let walls = Walls::new(bounds, cells);
        let mut lists = vec![Vec::new(); cells.element_product() as usize];
        for (aabb, item) in boxes.iter().zip(0..) {
            let [x, y, z] = [0, 1, 2].map(|axis| {
                let last = cells[axis] as u32 - 1;
                let wall = |number: u32| walls.first[axis] + number as f32 * walls.spacing[axis];
                let (low, high) = (aabb.min[axis], aabb.max[axis]);
                let guess = |x: f32| (((x - walls.first[axis]) / walls.spacing[axis]) as u32).min(last);
                let (mut i, mut j) = (guess(low), guess(high));
                if TOUCHED {
                    while i > 0 && wall(i) >= low {
                        i -= 1;
                    }
                    while i < last && wall(i + 1) < low {
                        i += 1;
                    }
                    while j < last && wall(j + 1) <= high {
                        j += 1;
                    }
                    while j > i && wall(j) > high {
                        j -= 1;
                    }
                }
                i..=j
            });
            for z in z {
                for y in y.clone() {
                    for x in x.clone() {
                        lists[((z * cells.y as u32 + y) * cells.x as u32 + x) as usize].push(item);
                    }
                }
            }
        }
        let end = |end: &mut u32, list: &Vec<u32>| {
            *end += list.len() as u32;
            Some(*end)
        };
        let starts = std::iter::once(0).chain(lists.iter().scan(0, end)).collect();
        let cells = cells.to_array().map(|n| n as u32);
        Grid { boxes, bounds, walls, cells, starts, items: lists.concat() }
    }

    /// `strahl_core`'s walk.
    ///
    /// * `COMPUTED`: the distance of a wall from its number; else the last one's and what lies
    ///   between two walls.
    /// * `CORNERS`: close to an edge the cells on both sides of it are entered.
    /// * `SEARCHED`: the first cell is the one whose walls say so; else that of the point.
    /// * `ZEROS`: a ray along the walls of an axis meets none of them; else `d >= 0` goes up.
    #[inline(always)]
    pub fn nearest<const COMPUTED: bool, const CORNERS: bool, const SEARCHED: bool, const ZEROS: bool>(
        &self,
        ray: &Ready,
    ) -> Option<Met> {
        let mut nearest = Nearest::new(&self.boxes, ray);
        let span = span::<true>(&self.bounds, ray)?;
        let begin = if span.entry > 0.0 { span.entry } else { 0.0 };
        let [width, height, _] = self.cells;
        let strides = [1, width as usize, (width * height) as usize];
        let along = |axis: usize| Along::new::<SEARCHED, ZEROS>(self, ray, axis, strides[axis], begin);
        let ((mut x, x0), (mut y, y0), (mut z, z0)) = (along(0), along(1), along(2));
        let mut cell = x0 as usize + y0 as usize * strides[1] + z0 as usize * strides[2];
        let mut enter = |cell: usize| {
            let (start, end) = (self.starts[cell] as usize, self.starts[cell + 1] as usize);
            for item in &self.items[start..end] {
                nearest.test::<true>(*item);
            }
            nearest.reach
        };
        loop {
            let reach = enter(cell);
            let end = if x.ahead <= y.ahead && x.ahead <= z.ahead {
                step::<COMPUTED, CORNERS>(&mut x, &y, &z, &mut cell, reach, &mut enter)
            } else if y.ahead <= z.ahead {
                step::<COMPUTED, CORNERS>(&mut y, &x, &z, &mut cell, reach, &mut enter)
            } else {
                step::<COMPUTED, CORNERS>(&mut z, &x, &y, &mut cell, reach, &mut enter)
            };
            if end.is_break() {
                return nearest.met();
            }
        }
    }
}

/// The way along one axis.
struct Along {
    origin: f32,
    inverse: f32,
    first: f32,
    spacing: f32,
    ahead: f32,
    between: f32,
    wall: f32,
    step: f32,
    stride: usize,
    left: u32,
}

impl Along {
    #[inline(always)]
    fn new<const SEARCHED: bool, const ZEROS: bool>(
        grid: &Grid,
        ray: &Ready,
        axis: usize,
        stride: usize,
        begin: f32,
    ) -> (Self, u32) {
        let along = |v: Vec3| v.to_array()[axis];
        let (origin, direction, inverse) = (along(ray.o), along(ray.d), along(ray.inverse));
        let (first, spacing) = (along(grid.walls.first), along(grid.walls.spacing));
        let last = grid.cells[axis] - 1;
        let guess = |at: f32| {
            let cell = ((at - first) / spacing) as u32;
            if cell < last { cell } else { last }
        };
        let mut along = Along {
            origin,
            inverse,
            first,
            spacing,
            ahead: f32::INFINITY,
            between: (spacing * inverse).abs(),
            wall: 0.0,
            step: 1.0,
            stride,
            left: 0,
        };
        if ZEROS && !(inverse.abs() <= f32::MAX) {
            let mut cell = guess(origin);
            while cell > 0 && origin < along.place(cell as f32) {
                cell -= 1;
            }
            while cell < last && origin > along.place(cell as f32 + 1.0) {
                cell += 1;
            }
            return (along, cell);
        }
        let is_left_behind = |along: &Along, wall: u32| !(along.distance(wall as f32) * WIDEN >= begin);
        let mut cell = guess(origin + direction * begin);
        if if ZEROS { inverse > 0.0 } else { direction >= 0.0 } {
            while SEARCHED && cell > 0 && !is_left_behind(&along, cell) {
                cell -= 1;
            }
            while SEARCHED && cell < last && is_left_behind(&along, cell + 1) {
                cell += 1;
            }
            along.wall = cell as f32 + 1.0;
            along.left = last - cell;
        } else {
            while SEARCHED && cell < last && !is_left_behind(&along, cell + 1) {
                cell += 1;
            }
            while SEARCHED && cell > 0 && is_left_behind(&along, cell) {
                cell -= 1;
            }
            along.wall = cell as f32;
            along.step = -1.0;
            along.stride = stride.wrapping_neg();
            along.left = cell;
        }
        along.ahead = along.distance(along.wall);
        (along, cell)
    }

    #[inline(always)]
    fn place(&self, wall: f32) -> f32 {
        self.first + wall * self.spacing
    }

    #[inline(always)]
    fn distance(&self, wall: f32) -> f32 {
        (self.place(wall) - self.origin) * self.inverse
    }

    #[inline(always)]
    fn cross<const COMPUTED: bool>(&mut self, cell: &mut usize) -> ControlFlow<()> {
        if self.left == 0 {
            return ControlFlow::Break(());
        }
        self.left -= 1;
        *cell = cell.wrapping_add(self.stride);
        if COMPUTED {
            self.wall += self.step;
            self.ahead = self.distance(self.wall);
        } else {
            self.ahead += self.between;
        }
        ControlFlow::Continue(())
    }

    fn walls_until(&self, edge: f32) -> u32 {
        let (mut count, mut wall) = (0, self.wall);
        while count < self.left && self.distance(wall) <= edge {
            count += 1;
            wall += self.step;
        }
        count
    }
}

#[inline(always)]
fn step<const COMPUTED: bool, const CORNERS: bool>(
    near: &mut Along,
    other: &Along,
    third: &Along,
    cell: &mut usize,
    reach: f32,
    enter: &mut impl FnMut(usize) -> f32,
) -> ControlFlow<()> {
    if near.ahead > reach {
        return ControlFlow::Break(());
    }
    if CORNERS {
        let edge = near.ahead * WIDEN;
        if other.ahead <= edge || third.ahead <= edge {
            corner(other, third, *cell, edge, enter);
        }
    }
    near.cross::<COMPUTED>(cell)
}

#[cold]
fn corner(one: &Along, two: &Along, cell: usize, edge: f32, enter: &mut impl FnMut(usize) -> f32) {
    let (more, most) = (one.walls_until(edge), two.walls_until(edge));
    let mut row = cell;
    for j in 0..=most {
        let mut cell = row;
        for i in 0..=more {
            if (i, j) != (0, 0) {
                enter(cell);
            }
            cell = cell.wrapping_add(one.stride);
        }
        row = row.wrapping_add(two.stride);
    }
}
