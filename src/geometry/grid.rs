//! A uniform grid of points: nearest neighbours and everything within a radius.
//!
//! Points are sorted by cell once (counting sort), so a cell's points lie side by side in memory and building takes
//! one pass over the points and one over the cells. For the even spread of a cutting sheet this was the fastest of
//! the structures tried, and the smallest in wasm.

use super::aabb::Aabb;
use crate::order::sort_by;
use glam::DVec2;

/// Cells per point at most: keeps memory in proportion when a few points lie far from the others.
const CELLS_PER_POINT: f64 = 4.0;
/// Points per cell that [`Grid::even`] aims at: nine cells then hold about a dozen candidates.
const POINTS_PER_CELL: f64 = 1.5;

/// Points sorted into square cells. Points that are not finite are never found.
#[derive(Clone, Debug)]
pub struct Grid {
    origin: DVec2,
    cell: f64,
    columns: usize,
    rows: usize,
    /// `starts[c]..starts[c + 1]` are the places of cell `c` in `order`; row by row.
    starts: Vec<u32>,
    /// Indices of the points, by cell, ascending within a cell.
    order: Vec<u32>,
    /// The points in that order.
    points: Vec<DVec2>,
}

impl Grid {
    /// A grid with cells of `cell` mm, or larger ones when that would be more than four cells per point.
    pub fn new(points: &[DVec2], cell: f64) -> Self {
        let bounds = points.iter().filter(|p| p.is_finite()).fold(Aabb::EMPTY, |b, p| b.with(*p));
        let size = bounds.size();
        let most = (points.len() as f64 * CELLS_PER_POINT).max(1.0);
        // No axis takes more cells than there may be in all, and both together not either.
        let least = (size.max_element() / most).max((size.x * size.y / most).sqrt());
        let cell = if cell.is_finite() { cell.max(least) } else { least };
        let cell = if cell > 0.0 { cell } else { 1.0 };
        let origin = if bounds.is_empty() { DVec2::ZERO } else { bounds.min };
        let columns = whole(size.x / cell) + 1;
        let rows = whole(size.y / cell) + 1;
        let mut grid = Self {
            origin,
            cell,
            columns,
            rows,
            starts: vec![0; columns * rows + 1],
            order: vec![],
            points: vec![],
        };

        let cells: Vec<Option<usize>> = points
            .iter()
            .map(|p| p.is_finite().then(|| grid.cell_of(*p)).map(|(x, y)| y * columns + x))
            .collect();
        for c in cells.iter().flatten() {
            grid.starts[c + 1] += 1;
        }
        for c in 0..columns * rows {
            grid.starts[c + 1] += grid.starts[c];
        }
        let found = grid.starts[columns * rows] as usize;
        let mut next = grid.starts.clone();
        grid.order = vec![0; found];
        grid.points = vec![DVec2::ZERO; found];
        for ((i, c), p) in (0_u32..).zip(&cells).zip(points) {
            if let Some(c) = c {
                let at = next[*c] as usize;
                grid.order[at] = i;
                grid.points[at] = *p;
                next[*c] += 1;
            }
        }
        grid
    }

    /// A grid whose cells hold about one or two points each.
    pub fn even(points: &[DVec2]) -> Self {
        let bounds = points.iter().filter(|p| p.is_finite()).fold(Aabb::EMPTY, |b, p| b.with(*p));
        let size = bounds.size();
        let per_cell = POINTS_PER_CELL / points.len().max(1) as f64;
        // The first for points spread over an area, the second for points on a line.
        Self::new(points, (size.x * size.y * per_cell).sqrt().max(size.max_element() * per_cell))
    }

    /// Calls `visit` with the index and squared distance of every point within `radius` mm of `p`, in no particular
    /// (but always the same) order.
    pub fn each_within(&self, p: DVec2, radius: f64, mut visit: impl FnMut(usize, f64)) {
        if !p.is_finite() || radius.is_nan() || radius < 0.0 {
            return;
        }
        let (low, high) = (self.cell_of(p - radius), self.cell_of(p + radius));
        for y in low.1..=high.1 {
            for (i, d) in self.row(y, low.0, high.0, p) {
                if d <= radius * radius {
                    visit(i, d);
                }
            }
        }
    }

    /// Indices of the points within `radius` mm of `p`, ascending.
    pub fn within(&self, p: DVec2, radius: f64) -> Vec<usize> {
        let mut out = Vec::new();
        self.each_within(p, radius, |i, _| out.push(i));
        sort_by(&mut out, |&i| [i as u64, 0, 0]);
        out
    }

    /// Indices of the `k` points nearest to `p`, nearest first, ties by index. A point at `p` itself counts.
    pub fn nearest(&self, p: DVec2, k: usize) -> Vec<usize> {
        self.nearest_where(p, k, |_| true)
    }

    /// As [`Grid::nearest`], of the points that `wanted` takes only.
    pub fn nearest_where(&self, p: DVec2, k: usize, wanted: impl Fn(usize) -> bool) -> Vec<usize> {
        // The best so far, sorted: k is small, so insertion is quicker than a heap.
        let mut best: Vec<(f64, usize)> = Vec::with_capacity(k + 1);
        if k == 0 || !p.is_finite() {
            return Vec::new();
        }
        let (cx, cy) = self.cell_of(p);
        let rings = cx.max(self.columns - 1 - cx).max(cy).max(self.rows - 1 - cy);
        for ring in 0..=rings {
            // Everything in this ring and beyond lies outside the square of the cells seen.
            if best.len() == k && best.last().is_some_and(|worst| worst.0 < self.clearance(p, (cx, cy), ring))
            {
                break;
            }
            let (x0, x1) = (cx.saturating_sub(ring), (cx + ring).min(self.columns - 1));
            let (y0, y1) = (cy.saturating_sub(ring), (cy + ring).min(self.rows - 1));
            let mut take = |(i, d): (usize, f64)| {
                let full = best.len() == k;
                if (!full || best.last().is_some_and(|w| (d, i) < *w)) && wanted(i) {
                    let at = best.partition_point(|b| *b < (d, i));
                    best.insert(at, (d, i));
                    best.truncate(k);
                }
            };
            for y in y0..=y1 {
                if y + ring == cy || y == cy + ring {
                    self.row(y, x0, x1, p).for_each(&mut take);
                } else {
                    if x0 + ring == cx {
                        self.row(y, x0, x0, p).for_each(&mut take);
                    }
                    if x1 == cx + ring && ring > 0 {
                        self.row(y, x1, x1, p).for_each(&mut take);
                    }
                }
            }
        }
        best.into_iter().map(|(_, i)| i).collect()
    }

    /// Squared distance from `p` below which every point lies in a ring before `ring`.
    fn clearance(&self, p: DVec2, (cx, cy): (usize, usize), ring: usize) -> f64 {
        let corner = DVec2::new(cx as f64, cy as f64);
        let low = self.origin + (corner - (ring as f64 - 1.0)) * self.cell;
        let high = self.origin + (corner + ring as f64) * self.cell;
        let gap = (p - low).min(high - p).min_element().max(0.0);
        gap * gap
    }

    /// The points in columns `x0..=x1` of row `y`, with squared distances from `p`.
    fn row(&self, y: usize, x0: usize, x1: usize, p: DVec2) -> impl Iterator<Item = (usize, f64)> + '_ {
        let from = self.starts[y * self.columns + x0] as usize;
        let to = self.starts[y * self.columns + x1 + 1] as usize;
        let places = self.order[from..to].iter().zip(&self.points[from..to]);
        places.map(move |(i, q)| (*i as usize, q.distance_squared(p)))
    }

    /// Column and row of the cell that holds `p`, held inside the grid.
    fn cell_of(&self, p: DVec2) -> (usize, usize) {
        let c = (p - self.origin) / self.cell;
        (whole(c.x).min(self.columns - 1), whole(c.y).min(self.rows - 1))
    }
}

/// The whole part of a number, 0 below 0.
#[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "casts of floats saturate")]
fn whole(v: f64) -> usize {
    v as usize
}
