//! Square cells over a sheet: the cell of a place, and the distance that rings of cells around it cover.

use super::aabb::Aabb;
use glam::DVec2;

/// Largest number of cells along an axis, so that a long thin sheet does not need more memory than its points.
const MAX_CELLS_PER_AXIS: f64 = 2048.0;

/// A grid of square cells.
#[derive(Clone, Debug)]
pub struct Cells {
    corner: DVec2,
    /// Side of a cell, mm.
    side: f64,
    /// Number of cells along x.
    pub columns: usize,
    /// Number of cells along y.
    pub rows: usize,
}

impl Cells {
    /// About `count` cells over `bounds`.
    pub fn new(bounds: Aabb, count: f64) -> Self {
        let (size, count) = (bounds.size(), count.max(1.0));
        // A sheet without width or height is divided along its length; a single point gets one cell.
        let side = (size.x * size.y / count).sqrt().max(size.max_element() / count.min(MAX_CELLS_PER_AXIS));
        let side = if side > 0.0 && side.is_finite() { side } else { 1.0 };
        let along = |length: f64| whole(length / side).saturating_add(1);
        let corner = if bounds.is_empty() { DVec2::ZERO } else { bounds.min };
        Self { corner, side, columns: along(size.x), rows: along(size.y) }
    }

    /// Column and row of a place; for a place outside all cells, those of the nearest one.
    pub fn cell(&self, place: DVec2) -> (usize, usize) {
        let d = (place - self.corner).max(DVec2::ZERO);
        (whole(d.x / self.side).min(self.columns - 1), whole(d.y / self.side).min(self.rows - 1))
    }

    /// Number of rings around `place` that cover every cell.
    pub fn rings(&self, place: DVec2) -> usize {
        let (x, y) = self.cell(place);
        x.max(self.columns - 1 - x).max(y).max(self.rows - 1 - y) + 1
    }

    /// Least distance along x or along y, mm, of any place in ring `r` or beyond.
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
