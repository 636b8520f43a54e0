//! Items in gaps of the tour: a lower bound of the seconds to reach an item, and its best entry in a gap.

use super::boxes::ARCS;
use super::ring::GATES;
use super::ring_in_gap::RingInGap;
use super::space::Space;
use super::travel::Gap;
use super::travel::Place;
use crate::geometry::DVec2;

/// The distance of one item from many places, with the rows of a table looked up once.
pub(super) struct Reaching<'s> {
    space: &'s Space<'s>,
    item: u32,
    rows: [Option<&'s [f64]>; 2],
}

impl Reaching<'_> {
    /// See [`Space::at_least`].
    #[inline(always)]
    pub(super) fn at_least(&self, p: Place, back: bool) -> f64 {
        match self.rows[usize::from(back)] {
            Some(row) => row[p.node as usize],
            _ => self.space.at_least(p, self.item, back),
        }
    }
}

impl Space<'_> {
    /// A lower bound of the seconds from `p` to any place of an item (`back`: from any place of it to `p`).
    #[inline(always)]
    pub(super) fn at_least(&self, p: Place, item: u32, back: bool) -> f64 {
        if self.travel.by_table() {
            return self.travel.least(p, item, self.places(item), back);
        }
        self.travel.air(DVec2::ZERO, self.whole[item as usize].outside(p.point)) - self.most_saved(item)
    }

    /// The distance of an item, for callers that ask it of many places.
    pub(super) fn reaching(&self, item: u32) -> Reaching<'_> {
        Reaching { space: self, item, rows: [false, true].map(|back| self.travel.least_costs(item, back)) }
    }

    /// Seconds of an item in a gap, entered at place `at`: both legs and the extra seconds of the place.
    pub(super) fn through(&self, item: u32, at: u32, gap: Gap) -> f64 {
        let entry = self.places(item).at(at);
        let exit = if self.leaves_elsewhere(item) { self.exit(item, at) } else { entry };
        let on = gap.to.map_or(0.0, |to| self.travel.seconds_here(exit, to));
        self.travel.seconds_here(gap.from, entry) + on + self.extra(item, at)
    }

    /// The best entry of an item in a gap, from all its places: index and seconds. If no entry costs less than `under`
    /// seconds, the result may be any entry: the boxes of a ring's arcs often exclude all places.
    pub(super) fn best_entry(&self, item: u32, gap: Gap, under: f64) -> (u32, f64) {
        let mut best = (0, f64::INFINITY);
        if !self.is_ring(item) {
            let places = self.places(item);
            let rows = gap.to.and_then(|to| self.travel.both_ways(gap.from, to, places));
            if let Some([out, on]) = rows {
                for (at, (out, on)) in (0..).zip(out.iter().zip(on)) {
                    if out + on < best.1 {
                        best = (at, out + on);
                    }
                }
                return best;
            }
            let elsewhere = self.leaves_elsewhere(item);
            for (at, place) in (0..).zip(places.iter()) {
                // The leg to the place alone excludes most places.
                let out = self.travel.seconds(gap.from, place);
                if out - self.most_saved(item) >= best.1 {
                    continue;
                }
                let exit = if elsewhere { self.exit(item, at) } else { place };
                let on = gap.to.map_or(0.0, |to| self.travel.seconds(exit, to));
                let seconds = out + on + self.extra(item, at);
                if seconds < best.1 {
                    best = (at, seconds);
                }
            }
            return best;
        }
        let ring = self.ring_in_gap(item, gap);
        let step = ring.points.len() / GATES;
        for (q, arc) in self.arcs[item as usize].iter().enumerate() {
            let least = ring.at_least(arc);
            // Two comparisons, not one with the minimum: in wasm the minimum is a call, because it respects NaN.
            if least < best.1 && least < under {
                // A counted loop, not `step_by`, which begins with a division.
                let mut at = GATES / ARCS * q * step;
                for _ in 0..GATES / ARCS {
                    ring.try_at(at, &mut best);
                    at += step;
                }
            }
        }
        if best.1 == f64::INFINITY {
            return best;
        }
        ring.better_near(&mut best);
        let corners =
            self.corner_first[item as usize] as usize..self.corner_first[item as usize + 1] as usize;
        for &at in &self.corner[corners] {
            ring.try_at(at as usize, &mut best);
        }
        best
    }

    /// A better entry near a given one, by halving steps to both sides. Only rings have places near each other.
    pub(super) fn better_near(&self, item: u32, start: (u32, f64), gap: Gap) -> (u32, f64) {
        if !self.is_ring(item) {
            return start;
        }
        let mut best = start;
        self.ring_in_gap(item, gap).better_near(&mut best);
        best
    }

    /// An item with a ring, in a gap.
    #[inline(always)]
    fn ring_in_gap(&self, item: u32, gap: Gap) -> RingInGap<'_> {
        let places = self.first[item as usize] as usize..self.first[item as usize + 1] as usize;
        let extra = if self.extra.is_empty() { &[][..] } else { &self.extra[places.clone()] };
        RingInGap {
            travel: &self.travel,
            points: &self.point[places],
            extra,
            from: gap.from.point,
            to: gap.to.map(|to| to.point),
        }
    }
}
