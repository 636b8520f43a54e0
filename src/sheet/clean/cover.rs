//! The part of a line or circle that is already covered, as disjoint intervals.

use std::cmp::Ordering;
use std::collections::BTreeMap;

/// A floating-point number with a total order, for use as a key.
#[derive(Clone, Copy, PartialEq)]
pub(super) struct Key(pub(super) f64);

impl Eq for Key {}
impl PartialOrd for Key {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}
impl Ord for Key {
    fn cmp(&self, other: &Self) -> Ordering {
        self.0.total_cmp(&other.0)
    }
}

/// Disjoint closed intervals in order. Every interval that a query visits is merged into the interval added next, so n
/// queries with n additions take O(n log n) in total.
#[derive(Default)]
pub(super) struct Cover(BTreeMap<Key, f64>);

impl Cover {
    /// The covered parts of `[a, b]`, clipped to it, in order.
    pub(super) fn within(&self, a: f64, b: f64) -> impl Iterator<Item = (f64, f64)> {
        let before = self.0.range(..Key(a)).next_back().filter(|&(_, &end)| end > a);
        let inside = self.0.range(Key(a)..Key(b));
        before.into_iter().chain(inside).map(move |(start, &end)| (start.0.max(a), end.min(b)))
    }

    /// Covers `[a, b]` and merges it with all intervals it touches.
    pub(super) fn add(&mut self, mut a: f64, mut b: f64) {
        if let Some((&start, &end)) = self.0.range(..Key(a)).next_back()
            && end >= a
        {
            a = start.0;
            b = b.max(end);
        }
        while let Some((&start, &end)) = self.0.range(Key(a)..=Key(b)).next() {
            b = b.max(end);
            self.0.remove(&start);
        }
        self.0.insert(Key(a), b);
    }
}

/// The parts of `[a, b]` outside the `covered` parts, which are in order and clipped to it. Covered parts and remaining
/// parts no longer than `least` are ignored, because ends that overlap by rounding form a joint, not an overlap.
pub(super) fn rest(a: f64, b: f64, covered: impl Iterator<Item = (f64, f64)>, least: f64) -> Vec<(f64, f64)> {
    let mut left = Vec::new();
    let mut from = a;
    let mut last: Option<(f64, f64)> = None;
    let mut close = |(start, end): (f64, f64), from: &mut f64| {
        if end - start > least {
            if start - *from > least {
                left.push((*from, start));
            }
            *from = end;
        }
    };
    for (start, end) in covered {
        match &mut last {
            Some(l) if start <= l.1 => l.1 = l.1.max(end),
            _ => {
                if let Some(l) = last.replace((start, end)) {
                    close(l, &mut from);
                }
            }
        }
    }
    if let Some(l) = last {
        close(l, &mut from);
    }
    if b - from > least {
        left.push((from, b));
    }
    left
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn intervals_merge_and_rest_is_the_uncovered_part() {
        let mut c = Cover::default();
        c.add(0.0, 1.0);
        c.add(4.0, 5.0);
        c.add(2.0, 3.0);
        assert_eq!(c.within(0.5, 4.5).collect::<Vec<_>>(), [(0.5, 1.0), (2.0, 3.0), (4.0, 4.5)]);
        assert_eq!(rest(0.5, 4.5, c.within(0.5, 4.5), 0.01), [(1.0, 2.0), (3.0, 4.0)]);
        c.add(0.9, 4.1);
        assert_eq!(c.within(-9.0, 9.0).collect::<Vec<_>>(), [(0.0, 5.0)]);
        assert_eq!(rest(0.5, 4.5, c.within(0.5, 4.5), 0.01), []);
    }

    #[test]
    fn touching_intervals_do_not_overlap_and_short_rests_are_dropped() {
        assert_eq!(rest(0.0, 10.0, [(0.0, 0.005)].into_iter(), 0.01), [(0.0, 10.0)]);
        assert_eq!(rest(0.0, 10.0, [(0.005, 9.995)].into_iter(), 0.01), []);
    }
}
