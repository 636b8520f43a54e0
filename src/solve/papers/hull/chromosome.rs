//! The chromosome, eq. (3): M paths, one for each contour, which together contain all N segments with their cutting
//! directions. The paths one after the other give the cutting order. A path has as many places as its contour has segments,
//! but may contain segments of other contours. A migration makes it longer or shorter; the next crossover restores its
//! length as far as there are blanks.

use super::model::{Gene, Model};
use crate::solve::rng::{Draw, Rng};

/// A feasible solution of the paper's model.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Chromosome {
    /// The genes of all paths, one path after the other.
    pub(super) genes: Vec<Gene>,
    /// The end of each path in `genes`.
    pub(super) ends: Vec<u32>,
    /// TL, its empty travel.
    pub(super) length: f64,
}

impl Chromosome {
    /// A chromosome with these genes and paths of these sizes. Its length is not computed yet.
    pub(super) fn new(genes: Vec<Gene>, sizes: &[u32]) -> Self {
        let ends = sizes.iter().scan(0, |sum, &size| {
            *sum += size;
            Some(*sum)
        });
        Self { genes, ends: ends.collect(), length: f64::INFINITY }
    }

    /// The range of a path in `genes`.
    pub(super) fn path(&self, m: usize) -> std::ops::Range<usize> {
        let start = m.checked_sub(1).map_or(0, |m| self.ends[m]);
        start as usize..self.ends[m] as usize
    }

    /// The paper's mutation: two genes of a path exchange their places. Both places may be the same; then nothing changes.
    pub(super) fn mutate(&mut self, rng: &mut Rng) {
        let path = self.path(rng.below(self.ends.len()));
        if !path.is_empty() {
            let [a, b] = [(); 2].map(|()| path.start + rng.below(path.len()));
            self.genes.swap(a, b);
        }
    }

    /// The paper's migration: a run of genes moves from one path to another.
    pub(super) fn migrate(&mut self, rng: &mut Rng) {
        let paths = self.ends.len();
        if paths < 2 {
            return;
        }
        let from = rng.below(paths);
        let to = (from + 1 + rng.below(paths - 1)) % paths;
        let path = self.path(from);
        if path.is_empty() {
            return;
        }
        let run = run(path.len(), rng);
        let place = rng.below(self.path(to).len() + 1);
        let moved: Vec<Gene> = self.genes.drain(path.start + run.start..path.start + run.end).collect();
        let count = u32::try_from(moved.len()).unwrap_or(0);
        self.ends[from..].iter_mut().for_each(|e| *e -= count);
        let at = self.path(to).start + place;
        self.genes.splice(at..at, moved);
        self.ends[to..].iter_mut().for_each(|e| *e += count);
    }
}

/// A random range of at least one place.
pub(super) fn run(places: usize, rng: &mut Rng) -> std::ops::Range<usize> {
    let [a, b] = [(); 2].map(|()| rng.below(places));
    a.min(b)..a.max(b) + 1
}

/// Random keys: one for the turn of each segment, then one for the direction of each. All methods draw their first
/// solutions this way, so with one seed they start from the same population. By eq. (3) a path is the sequence of its own
/// contour's segments, so the turns of contour m of M lie in the m-th part of the range. The first chromosomes therefore
/// cut contour by contour in drawing order, with random orders and directions within a contour.
pub(super) fn keys(model: &Model, rng: &mut Rng) -> Vec<f32> {
    let paths = model.sizes.len() as f64;
    let own = |(m, &size): (usize, &u32)| std::iter::repeat_n(m as f64, size as usize);
    let turns: Vec<f64> =
        model.sizes.iter().enumerate().flat_map(own).map(|m| (m + rng.uniform()) / paths).collect();
    let ways = (0..model.segments()).map(|_| rng.uniform());
    #[expect(clippy::cast_possible_truncation, reason = "fewer digits are as random")]
    turns.into_iter().chain(ways).map(|k| k as f32).collect()
}

/// The genes that keys represent: segments in ascending order of their turn, cut against the stored direction if the
/// direction key is at least a half.
pub(super) fn genes(model: &Model, keys: &[f32]) -> Vec<Gene> {
    let (turns, ways) = keys.split_at(model.segments());
    let order = ascending(turns);
    order.into_iter().map(|s| 2 * s + u32::from(ways[s as usize] >= 0.5)).collect()
}

/// Indices in ascending order of their keys; equal keys stay in order. This is a radix sort in three passes of 11 bits,
/// because a comparison sort of 80,000 keys would be the longest piece of all.
pub(super) fn ascending(keys: &[f32]) -> Vec<u32> {
    const BITS: u32 = 11;
    // Converts bits so that they sort like the numbers: those of negative numbers are inverted and come first.
    let rank = |k: f32| {
        let bits = k.to_bits();
        if bits >> 31 == 1 { !bits } else { bits | 1 << 31 }
    };
    let mut order: Vec<(u32, u32)> = (0..).zip(keys).map(|(i, &k)| (rank(k), i)).collect();
    let mut sorted = order.clone();
    for shift in [0, BITS, 2 * BITS] {
        let digit = |rank: u32| (rank >> shift) as usize & ((1 << BITS) - 1);
        let mut places = vec![0; 1 << BITS];
        order.iter().for_each(|o| places[digit(o.0)] += 1);
        let mut sum = 0;
        places.iter_mut().for_each(|p| sum += std::mem::replace(p, sum));
        for &o in &order {
            let place = &mut places[digit(o.0)];
            sorted[*place] = o;
            *place += 1;
        }
        std::mem::swap(&mut order, &mut sorted);
    }
    order.into_iter().map(|o| o.1).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::solve::rng::seeded;

    #[test]
    fn keys_in_order_as_std_sorts() {
        let mut rng = seeded(1);
        for round in 0..200 {
            #[expect(clippy::cast_possible_truncation, reason = "test data")]
            let mut keys: Vec<f32> = (0..round).map(|_| rng.standard_normal() as f32).collect();
            keys.extend(keys.clone().iter().step_by(3));
            keys.extend([0.0, 1.0, -2.5, f32::MIN_POSITIVE, 1e30]);
            let mut wanted: Vec<u32> = (0..).take(keys.len()).collect();
            wanted.sort_by(|&a, &b| keys[a as usize].total_cmp(&keys[b as usize]));
            assert_eq!(ascending(&keys), wanted);
        }
    }
}
