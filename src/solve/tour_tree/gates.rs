//! A grid of all gates. Its cells are stored row by row in one list, so that the gates around a point are a few runs of it.

use super::config::CONFIG;
use crate::geometry::{Aabb, Cells, DVec2};

/// A gate: its item and its point.
pub(super) type Gate = (u32, DVec2);

pub(super) struct Gates {
    grid: Cells,
    /// Gates of cell c, row by row: `first[c]..first[c + 1]`.
    first: Vec<u32>,
    gates: Vec<Gate>,
}

impl Gates {
    pub(super) fn new(gates: &[Gate]) -> Self {
        let bounds = gates.iter().fold(Aabb::EMPTY, |b, g| b.with(g.1));
        let grid = Cells::new(bounds, gates.len() as f64 / CONFIG.neighbours.gates_per_cell);
        let (columns, count) = (grid.columns, grid.columns * grid.rows);
        // Counting sort: cells are counted, the counts added up, then the gates are filled in.
        let cells: Vec<usize> = gates.iter().map(|g| grid.cell(g.1)).map(|(x, y)| y * columns + x).collect();
        let mut ends = vec![0_u32; count + 1];
        cells.iter().for_each(|&c| ends[c + 1] += 1);
        for c in 0..count {
            ends[c + 1] += ends[c];
        }
        let first = ends.clone();
        let mut placed = vec![(0, DVec2::ZERO); gates.len()];
        for (&gate, c) in gates.iter().zip(cells) {
            placed[ends[c] as usize] = gate;
            ends[c] += 1;
        }
        Self { grid, first, gates: placed }
    }

    /// How many rings of cells around `place` hold every cell.
    pub(super) fn rings(&self, place: DVec2) -> usize {
        self.grid.rings(place)
    }

    /// Every gate in ring `r` or beyond is at least this far away along x or along y, mm.
    pub(super) fn distance_of_ring(&self, r: usize) -> f64 {
        self.grid.distance_of_ring(r)
    }

    /// Calls `show` with the gates in ring `r` around the cell of `place` (0: the cell itself), in runs.
    pub(super) fn ring(&self, place: DVec2, r: usize, mut show: impl FnMut(&[Gate])) {
        let (x, y) = self.grid.cell(place);
        let (left, right) = (x.saturating_sub(r), (x + r).min(self.grid.columns - 1));
        for row in y.saturating_sub(r)..=(y + r).min(self.grid.rows - 1) {
            if row + r == y || row == y + r {
                show(self.run(row, left, right));
                continue;
            }
            if x >= r {
                show(self.run(row, left, left));
            }
            if x + r < self.grid.columns {
                show(self.run(row, right, right));
            }
        }
    }

    /// The gates of one row between two columns.
    fn run(&self, row: usize, left: usize, right: usize) -> &[Gate] {
        let start = row * self.grid.columns;
        &self.gates[self.first[start + left] as usize..self.first[start + right + 1] as usize]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn line(count: u32, apart: f64) -> Vec<Gate> {
        (0..count).map(|k| (k, DVec2::new(f64::from(k) * apart, 5.0))).collect()
    }

    #[test]
    fn rings_hold_every_gate_once_and_as_far_as_they_say() {
        let gates: Vec<Gate> =
            (0..700).map(|k| (k, DVec2::new(f64::from(k * 37 % 101), f64::from(k * 53 % 47)))).collect();
        let grid = Gates::new(&gates);
        for from in [DVec2::ZERO, DVec2::new(50.0, 20.0), DVec2::new(-30.0, 900.0)] {
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
        assert_eq!(Gates::new(&[]).rings(DVec2::ONE), 1);
        let one = line(1, 0.0);
        Gates::new(&one).ring(DVec2::ZERO, 0, |run| assert_eq!(run, one));
    }
}
