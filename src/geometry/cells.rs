//! Square cells over a sheet: which one a place lies in, and how far rings of cells around it reach.

use super::aabb::Aabb;
use glam::DVec2;

/// Cells along an axis at most, so that a long thin sheet needs no more memory than what lies on it.
const MOST: f64 = 2048.0;

/// Columns and rows of square cells.
#[derive(Clone, Debug)]
pub struct Cells {
    corner: DVec2,
    /// Side of a cell, mm.
    side: f64,
    /// How many there are along x.
    pub columns: usize,
    /// How many there are along y.
    pub rows: usize,
}

impl Cells {
    /// About `count` cells over `bounds`.
    pub fn new(bounds: Aabb, count: f64) -> Self {
        let (size, count) = (bounds.size(), count.max(1.0));
        // A sheet without width or height is cut along its length; a single point gets one cell.
        let side = (size.x * size.y / count).sqrt().max(size.max_element() / count.min(MOST));
        let side = if side > 0.0 && side.is_finite() { side } else { 1.0 };
        let along = |length: f64| whole(length / side).saturating_add(1);
        let corner = if bounds.is_empty() { DVec2::ZERO } else { bounds.min };
        Self { corner, side, columns: along(size.x), rows: along(size.y) }
    }

    /// Column and row of a place; of one beside them all, the nearest.
    pub fn cell(&self, place: DVec2) -> (usize, usize) {
        let d = (place - self.corner).max(DVec2::ZERO);
        (whole(d.x / self.side).min(self.columns - 1), whole(d.y / self.side).min(self.rows - 1))
    }

    /// How many rings around `place` it takes to see every cell.
    pub fn rings(&self, place: DVec2) -> usize {
        let (x, y) = self.cell(place);
        x.max(self.columns - 1 - x).max(y).max(self.rows - 1 - y) + 1
    }

    /// Whatever lies in ring `r` or beyond is at least this far from the place along x or along y, mm.
    pub fn distance_of_ring(&self, r: usize) -> f64 {
        self.side * r.saturating_sub(1) as f64
    }
}

#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "a float cast to an integer saturates; cells are few and not negative"
)]
fn whole(x: f64) -> usize {
    x as usize
}
