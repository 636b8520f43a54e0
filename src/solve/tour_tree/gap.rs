//! Items between others: what it takes at least to reach one, and where it is entered best in a gap of the tour.

use super::boxes::ARCS;
use super::ring::GATES;
use super::ring_in::RingIn;
use super::space::Space;
use super::travel::Gap;
use super::travel::Place;
use crate::geometry::DVec2;

/// How far one item is from places: what a table says lies at hand.
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
    /// No way from `p` to any place of `item` (`back`: from any place of it to `p`) takes less than this.
    #[inline(always)]
    pub(super) fn at_least(&self, p: Place, item: u32, back: bool) -> f64 {
        if self.travel.by_table() {
            return self.travel.least(p, item, self.places(item), back);
        }
        self.travel.air(DVec2::ZERO, self.whole[item as usize].outside(p.point))
    }

    /// How far an item is, for where that is asked of one place after the other.
    pub(super) fn reaching(&self, item: u32) -> Reaching<'_> {
        Reaching { space: self, item, rows: [false, true].map(|back| self.travel.leasts(item, back)) }
    }

    /// Seconds from `gap.from` into an item at place `at` and on to `gap.to`, with what that place costs on top.
    pub(super) fn through(&self, item: u32, at: u32, gap: Gap) -> f64 {
        let entry = self.places(item).at(at);
        let exit = if self.two_ends(item) { self.exit(item, at) } else { entry };
        let on = gap.to.map_or(0.0, |to| self.travel.seconds_here(exit, to));
        self.travel.seconds_here(gap.from, entry) + on + self.extra(item, at)
    }

    /// The best entry of an item in a gap, from all its places: index and seconds. Where none costs less than
    /// `under`, any of them: the boxes of a ring's arcs often tell so already.
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
            let two_ends = self.two_ends(item);
            for (at, place) in (0..).zip(places.iter()) {
                // The way there alone tells of most that they cost more.
                let out = self.travel.seconds(gap.from, place);
                if out >= best.1 {
                    continue;
                }
                let exit = if two_ends { self.exit(item, at) } else { place };
                let on = gap.to.map_or(0.0, |to| self.travel.seconds(exit, to));
                let seconds = out + on + self.extra(item, at);
                if seconds < best.1 {
                    best = (at, seconds);
                }
            }
            return best;
        }
        let ring = self.ring_in(item, gap);
        let step = ring.points.len() / GATES;
        for (q, arc) in self.arcs[item as usize].iter().enumerate() {
            let least = ring.at_least(arc);
            // Not the smaller of the two: in wasm that is a call, as it heeds what is not a number.
            if least < best.1 && least < under {
                // In steps of one's own: those of the library begin with a division.
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

    /// A better entry near a given one, by halving steps to both sides; only rings have a near.
    pub(super) fn better_near(&self, item: u32, start: (u32, f64), gap: Gap) -> (u32, f64) {
        if !self.is_ring(item) {
            return start;
        }
        let mut best = start;
        self.ring_in(item, gap).better_near(&mut best);
        best
    }

    /// The ring of an item in a gap.
    #[inline(always)]
    fn ring_in(&self, item: u32, gap: Gap) -> RingIn<'_> {
        let places = self.first[item as usize] as usize..self.first[item as usize + 1] as usize;
        let extra = if self.extra.is_empty() { &[][..] } else { &self.extra[places.clone()] };
        RingIn {
            travel: &self.travel,
            points: &self.point[places],
            extra,
            from: gap.from.point,
            to: gap.to.map(|to| to.point),
        }
    }
}
