//! Points in square cells, searched outwards ring by ring. Points are inserted and removed while a tour is constructed.

use super::aabb::Aabb;
use super::cells::Cells;
use glam::DVec2;

/// Average number of points per cell; a ring of 8 cells then contains the nearest few contours.
const POINTS_PER_CELL: f64 = 8.0;

/// A grid of points with ids.
#[derive(Clone, Debug)]
pub struct Buckets {
    grid: Cells,
    cells: Vec<Vec<u32>>,
}

impl Buckets {
    /// An empty grid for about `count` points in `bounds`.
    pub fn new(bounds: Aabb, count: usize) -> Self {
        let grid = Cells::new(bounds, count as f64 / POINTS_PER_CELL);
        Self { cells: vec![Vec::new(); grid.columns * grid.rows], grid }
    }

    /// Inserts a point.
    pub fn insert(&mut self, id: u32, place: DVec2) {
        let cell = self.grid.cell(place);
        self.cells[cell.1 * self.grid.columns + cell.0].push(id);
    }

    /// Removes a point; `place` is the position it was inserted at.
    pub fn remove(&mut self, id: u32, place: DVec2) {
        let cell = self.grid.cell(place);
        let list = &mut self.cells[cell.1 * self.grid.columns + cell.0];
        if let Some(i) = list.iter().position(|&n| n == id) {
            list.swap_remove(i);
        }
    }

    /// Number of rings around `place` that cover every cell.
    pub fn rings(&self, place: DVec2) -> usize {
        self.grid.rings(place)
    }

    /// Least distance along x or along y, mm, of any place in ring `r` or beyond.
    pub fn distance_of_ring(&self, r: usize) -> f64 {
        self.grid.distance_of_ring(r)
    }

    /// The points in ring `r` around the cell of `place` (0: the cell itself).
    pub fn ring(&self, place: DVec2, r: usize) -> impl Iterator<Item = u32> {
        let (x, y) = self.grid.cell(place);
        let (left, right) = (x.checked_sub(r), Some(x + r).filter(|&c| c < self.grid.columns));
        let columns = x.saturating_sub(r)..(x + r + 1).min(self.grid.columns);
        let rows = y.saturating_sub(r)..(y + r + 1).min(self.grid.rows);
        rows.flat_map(move |row| {
            let whole = row + r == y || row == y + r;
            let (from, to) = if whole { (columns.start, columns.end) } else { (0, 0) };
            let sides = if whole || r == 0 { [None, None] } else { [left, right] };
            (from..to).chain(sides.into_iter().flatten()).map(move |column| (row, column))
        })
        .flat_map(|(row, column)| self.cells[row * self.grid.columns + column].iter().copied())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn filled(bounds: Aabb, places: &[DVec2]) -> Buckets {
        let mut b = Buckets::new(bounds, places.len());
        for (p, i) in places.iter().zip(0..) {
            b.insert(i, *p);
        }
        b
    }

    #[test]
    fn rings_contain_every_point_once_at_their_distance() {
        let places: Vec<DVec2> =
            (0..700).map(|k| DVec2::new(f64::from(k * 37 % 101), f64::from(k * 53 % 47))).collect();
        let b = filled(places.iter().fold(Aabb::EMPTY, |b, p| b.with(*p)), &places);
        for from in [DVec2::ZERO, DVec2::new(50.0, 20.0), DVec2::new(-30.0, 900.0)] {
            let mut seen = Vec::new();
            for r in 0..b.rings(from) {
                for n in b.ring(from, r) {
                    let d = (places[n as usize] - from).abs().max_element();
                    assert!(d >= b.distance_of_ring(r));
                    seen.push(n);
                }
            }
            seen.sort_unstable();
            assert_eq!(seen, (0..700).collect::<Vec<_>>());
        }
    }

    #[test]
    fn flat_empty_and_single() {
        let line: Vec<DVec2> = (0..90).map(|k| DVec2::new(f64::from(k) * 1e4, 5.0)).collect();
        let b = filled(line.iter().fold(Aabb::EMPTY, |b, p| b.with(*p)), &line);
        assert!(b.cells.len() < 100);
        assert_eq!(b.ring(line[0], 0).chain(b.ring(line[0], 1)).count(), 16);
        assert_eq!(Buckets::new(Aabb::EMPTY, 0).rings(DVec2::ONE), 1);
        let mut one = filled(Aabb::of(DVec2::ONE), &[DVec2::ONE]);
        assert_eq!(one.ring(DVec2::ZERO, 0).collect::<Vec<_>>(), [0]);
        one.remove(0, DVec2::ONE);
        assert_eq!(one.ring(DVec2::ZERO, 0).count(), 0);
    }
}
