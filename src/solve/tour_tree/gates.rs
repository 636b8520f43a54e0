//! The gates of all items by place, in square cells that stand in rows: what lies around a place is a few runs of one list.

use super::travel::Place;
use crate::geometry::{Aabb, DVec2};

/// Gates to a cell, on average: 2 and 8 take as long, 16 longer (10,000 contours).
const PER_CELL: f64 = 4.0;
/// Cells along an axis at most, so that a long thin sheet needs no more memory than its gates.
const MOST_CELLS: f64 = 2048.0;

/// A gate: its item and where it is.
pub(super) type Gate = (u32, Place);

pub(super) struct Gates {
    corner: DVec2,
    /// Side of a cell, mm.
    side: f64,
    columns: usize,
    rows: usize,
    /// Gates of cell c, row by row: `first[c]..first[c + 1]`.
    first: Vec<u32>,
    gates: Vec<Gate>,
}

impl Gates {
    pub(super) fn new(gates: &[Gate]) -> Self {
        let bounds = gates.iter().fold(Aabb::EMPTY, |b, g| b.with(g.1));
        let size = bounds.size().max(DVec2::ZERO);
        let cells = (gates.len() as f64 / PER_CELL).max(1.0);
        // A sheet without width or height is cut along its length; a single point gets one cell.
        let side = (size.x * size.y / cells).sqrt().max(size.max_element() / cells.min(MOST_CELLS));
        let side = if side > 0.0 && side.is_finite() { side } else { 1.0 };
        let (columns, rows) = (whole(size.x / side) + 1, whole(size.y / side) + 1);
        let corner = if bounds.is_empty() { DVec2::ZERO } else { bounds.min };
        let mut grid = Self { corner, side, columns, rows, first: Vec::new(), gates: Vec::new() };
        // Counted, added up, then filled in.
        let cells: Vec<usize> = gates.iter().map(|g| grid.cell(g.1)).map(|[x, y]| y * columns + x).collect();
        let mut ends = vec![0_u32; columns * rows + 1];
        cells.iter().for_each(|&c| ends[c + 1] += 1);
        for c in 0..columns * rows {
            ends[c + 1] += ends[c];
        }
        grid.first = ends.clone();
        grid.gates = vec![(0, Place::ZERO); gates.len()];
        for (&gate, c) in gates.iter().zip(cells) {
            grid.gates[ends[c] as usize] = gate;
            ends[c] += 1;
        }
        grid
    }

    /// How many rings around `place` it takes to see every cell.
    pub(super) fn rings(&self, place: Place) -> usize {
        let [x, y] = self.cell(place);
        x.max(self.columns - 1 - x).max(y).max(self.rows - 1 - y) + 1
    }

    /// Whatever lies in ring `r` or beyond is at least this far from the place along x or along y, mm.
    pub(super) fn distance_of_ring(&self, r: usize) -> f64 {
        self.side * r.saturating_sub(1) as f64
    }

    /// Shows the gates in ring `r` around the cell of `place` (0: the cell itself), in runs.
    pub(super) fn ring(&self, place: Place, r: usize, mut show: impl FnMut(&[Gate])) {
        let [x, y] = self.cell(place);
        let (left, right) = (x.saturating_sub(r), (x + r).min(self.columns - 1));
        for row in y.saturating_sub(r)..=(y + r).min(self.rows - 1) {
            if row + r == y || row == y + r {
                show(self.run(row, left, right));
                continue;
            }
            if x >= r {
                show(self.run(row, left, left));
            }
            if x + r < self.columns {
                show(self.run(row, right, right));
            }
        }
    }

    /// The gates of one row between two columns.
    fn run(&self, row: usize, left: usize, right: usize) -> &[Gate] {
        let start = row * self.columns;
        &self.gates[self.first[start + left] as usize..self.first[start + right + 1] as usize]
    }

    fn cell(&self, place: Place) -> [usize; 2] {
        let d = ((place - self.corner) / self.side).max(DVec2::ZERO);
        [whole(d.x).min(self.columns - 1), whole(d.y).min(self.rows - 1)]
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

#[cfg(test)]
mod tests {
    use super::*;

    fn line(count: u32, apart: f64) -> Vec<Gate> {
        (0..count).map(|k| (k, Place::new(f64::from(k) * apart, 5.0))).collect()
    }

    #[test]
    fn rings_hold_every_gate_once_and_as_far_as_they_say() {
        let gates: Vec<Gate> =
            (0..700).map(|k| (k, Place::new(f64::from(k * 37 % 101), f64::from(k * 53 % 47)))).collect();
        let grid = Gates::new(&gates);
        for from in [Place::ZERO, Place::new(50.0, 20.0), Place::new(-30.0, 900.0)] {
            let mut seen = Vec::new();
            for r in 0..grid.rings(from) {
                grid.ring(from, r, |run| {
                    for &(item, place) in run {
                        assert_eq!(place, gates[item as usize].1);
                        assert!((place - from).abs().max_element() >= grid.distance_of_ring(r));
                        seen.push(item);
                    }
                });
            }
            seen.sort_unstable();
            assert_eq!(seen, (0..700).collect::<Vec<_>>());
        }
    }

    #[test]
    fn flat_empty_and_single() {
        let flat = Gates::new(&line(90, 1e4));
        assert!(flat.first.len() < 100, "{}", flat.first.len());
        assert_eq!(Gates::new(&[]).rings(Place::ONE), 1);
        let one = line(1, 0.0);
        Gates::new(&one).ring(Place::ZERO, 0, |run| assert_eq!(run, one));
    }
}
