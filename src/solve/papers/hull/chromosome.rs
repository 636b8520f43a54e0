//! The chromosome, eq. (3): M paths, as many as contours, that hold all N segments, each with the way it is cut. One after
//! the other they give the order of cutting. A path has as many places as its contour has segments, but may hold those of
//! others; after a migration it is longer or shorter, and the next crossover brings its length back.

use super::model::{Gene, Model};
use crate::order::{real, sort_by};
use crate::solve::dice::Dice;

/// A feasible solution of the paper's model.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Chromosome {
    /// All paths, one after the other.
    pub(super) genes: Vec<Gene>,
    /// Where each path ends.
    pub(super) ends: Vec<u32>,
    /// TL, its empty travel.
    pub(super) length: f64,
}

impl Chromosome {
    /// The genes of an order and ways in the paths' own lengths; it has no length yet.
    pub(super) fn new(genes: Vec<Gene>, sizes: &[u32]) -> Self {
        let ends = sizes.iter().scan(0, |sum, &size| {
            *sum += size;
            Some(*sum)
        });
        Self { genes, ends: ends.collect(), length: f64::INFINITY }
    }

    /// Places of a path.
    pub(super) fn path(&self, m: usize) -> std::ops::Range<usize> {
        let start = m.checked_sub(1).map_or(0, |m| self.ends[m]);
        start as usize..self.ends[m] as usize
    }

    /// Two codes of a path change places: the paper's mutation.
    pub(super) fn mutate(&mut self, dice: &mut Dice) {
        let path = self.path(dice.below(self.ends.len()));
        if !path.is_empty() {
            let [a, b] = [(); 2].map(|()| path.start + dice.below(path.len()));
            self.genes.swap(a, b);
        }
    }

    /// A run of codes of a path moves to a place on another path: the paper's migration.
    pub(super) fn migrate(&mut self, dice: &mut Dice) {
        let paths = self.ends.len();
        if paths < 2 {
            return;
        }
        let from = dice.below(paths);
        let to = (from + 1 + dice.below(paths - 1)) % paths;
        let path = self.path(from);
        if path.is_empty() {
            return;
        }
        let run = run(path.len(), dice);
        let place = dice.below(self.path(to).len() + 1);
        let moved: Vec<Gene> = self.genes.drain(path.start + run.start..path.start + run.end).collect();
        let count = u32::try_from(moved.len()).unwrap_or(0);
        self.ends[from..].iter_mut().for_each(|e| *e -= count);
        let at = self.path(to).start + place;
        self.genes.splice(at..at, moved);
        self.ends[to..].iter_mut().for_each(|e| *e += count);
    }
}

/// A run of places, one at least, of so many.
pub(super) fn run(places: usize, dice: &mut Dice) -> std::ops::Range<usize> {
    let [a, b] = [(); 2].map(|()| dice.below(places));
    a.min(b)..a.max(b) + 1
}

/// Random keys: one a segment for its turn, then one a segment for its way. All methods draw their first ones so, and from
/// one seed they have the same. Eq. (3) says that a path is the sequence of its own contour's segments, so the turns of contour
/// m of M lie in the m-th part of the range: first chromosomes cut contour by contour in drawing order, each in a random way.
pub(super) fn keys(model: &Model, dice: &mut Dice) -> Vec<f32> {
    let paths = model.sizes.len() as f64;
    let own = |(m, &size): (usize, &u32)| std::iter::repeat_n(m as f64, size as usize);
    let turns: Vec<f64> =
        model.sizes.iter().enumerate().flat_map(own).map(|m| (m + dice.even()) / paths).collect();
    let ways = (0..model.segments()).map(|_| dice.even());
    #[expect(clippy::cast_possible_truncation, reason = "fewer digits are as random")]
    turns.into_iter().chain(ways).map(|k| k as f32).collect()
}

/// What keys stand for: segments in ascending order of their first key, against the stored direction where the second one
/// is at least a half.
pub(super) fn genes(model: &Model, keys: &[f32]) -> Vec<Gene> {
    let (turns, ways) = keys.split_at(model.segments());
    let mut order: Vec<Gene> = (0..).take(model.segments()).collect();
    sort_by(&mut order, |&s| [real(turns[s as usize].into()), 0, 0]);
    order.into_iter().map(|s| 2 * s + u32::from(ways[s as usize] >= 0.5)).collect()
}
