//! What stays the same during a search, laid out for speed: places to enter, boxes, precedence.
//!
//! A closed contour may be entered anywhere along it. Its places are a ring of [`GATES`] * 2^k points (`ring.rs`), so
//! the best entry between two given points is found coarse to fine: all gates (every 2^k-th place) first, then ever
//! smaller steps to both sides; then the corners, where the run along the contour costs less. What is left, under a
//! spacing, is slid away exactly on export (`polish.rs`). An item without a track has the places of its nodes; an open
//! contour has two, its ends.
//!
//! Home is one more item, the last, with one place; the tour starts at it. With a table of costs it is the problem's
//! last item, with all its nodes.

use super::ring::{nearest, ring};
use super::ring_in::RingIn;
use super::tour::Kept;
use super::travel::{Place, Travel, node_at, node_place};
use crate::geometry::{Aabb, DVec2};
use crate::problem::{Item, Node, NodeId, Problem, TABLES};
use crate::solve::precedence::Precedence;
use crate::solve::{Solution, Stop};

/// Coarse places of a ring: as many as tell its sides apart; neighbour lists are kept for each.
pub(super) const GATES: usize = 16;

/// The unchanging side of a search.
pub(super) struct Space<'p> {
    pub(super) problem: &'p Problem,
    pub(super) travel: Travel<'p>,
    /// The home item: one past the problem's items; with a table the last of them.
    pub(super) home: u32,
    /// Places of item i: `first[i]..first[i + 1]`.
    first: Vec<u32>,
    pub(super) place: Vec<Place>,
    /// Arc length of each place along its track, mm.
    along: Vec<f64>,
    /// Seconds on top for entering at each place; empty when no item has any.
    extra: Vec<f64>,
    /// Corners of item i: `corner_first[i]..corner_first[i + 1]`.
    corner_first: Vec<u32>,
    corner: Vec<u32>,
    /// Gates of item i: `gate_first[i]..gate_first[i + 1]`.
    pub(super) gate_first: Vec<u32>,
    kind: Vec<Kind>,
    spacing: Vec<f64>,
    /// No place of a ring costs less than the gate nearest to it by more than this many seconds, in any gap: that is
    /// at most the way there and back, and what places cost on top (the times of ways obey the triangle inequality).
    slack: Vec<f64>,
    /// Items that cost more one way than the other.
    pub(super) lopsided: Vec<u32>,
    /// Box of an item's places: middle and half size.
    middle: Vec<DVec2>,
    half: Vec<DVec2>,
    pub(super) rank: Vec<u32>,
    pub(super) precedence: Precedence,
}

#[derive(Clone, Copy, PartialEq, Eq)]
enum Kind {
    /// Places in order around a closed contour, `GATES` * 2^k of them.
    Ring,
    /// Ways with two ends, in pairs of out and back: those of an open contour, or through a pierce group.
    Open,
    /// Any places, in no order, each left where it is entered.
    Loose,
}

/// Where a stop lies between its neighbours: where the head comes from, and where it goes (`None`: nowhere, the last
/// stop of a path without return).
#[derive(Clone, Copy)]
pub(super) struct Gap {
    pub(super) from: Place,
    pub(super) to: Option<Place>,
}

/// How far one item is from places: what a table says lies at hand.
pub(super) struct Reaching<'s> {
    space: &'s Space<'s>,
    item: u32,
    rows: [Option<&'s [f64]>; 2],
}

impl Reaching<'_> {
    /// See [`Space::at_least`].
    #[inline]
    pub(super) fn at_least(&self, p: Place, back: bool) -> f64 {
        match self.rows[usize::from(back)] {
            Some(row) if TABLES => row[node_at(p) as usize],
            _ => self.space.at_least(p, self.item, back),
        }
    }
}

impl<'p> Space<'p> {
    pub(super) fn new(problem: &'p Problem) -> Self {
        let n = problem.items.len();
        let mut s = Self {
            problem,
            travel: Travel::new(problem),
            home: problem.start().unwrap_or(index(n)),
            first: vec![0],
            place: Vec::new(),
            along: Vec::new(),
            extra: Vec::new(),
            corner_first: vec![0],
            corner: Vec::new(),
            gate_first: vec![0],
            kind: Vec::with_capacity(n + 1),
            spacing: Vec::with_capacity(n + 1),
            slack: Vec::with_capacity(n + 1),
            lopsided: (0..)
                .zip(&problem.items)
                .filter(|(_, i)| !i.ways().is_empty())
                .map(|(id, _)| id)
                .collect(),
            middle: Vec::with_capacity(n + 1),
            half: Vec::with_capacity(n + 1),
            rank: problem.items.iter().map(|i| i.rank).collect(),
            precedence: Precedence::new(problem),
        };
        let charged = problem.items.iter().any(Item::is_uneven);
        for item in &problem.items {
            let nodes = &problem.nodes[item.nodes.start as usize..item.nodes.end as usize];
            let (kind, spacing) = match ring(item) {
                Some(ring) => {
                    s.place.extend(ring.points);
                    s.along.extend(ring.along);
                    s.extra.extend(ring.extra);
                    s.corner.extend(ring.corners);
                    (Kind::Ring, ring.spacing)
                }
                None => {
                    let by_table = s.travel.by_table();
                    let place =
                        |(node, id): (&Node, NodeId)| if by_table { node_place(id) } else { node.entry };
                    s.place.extend(nodes.iter().zip(item.nodes.clone()).map(place));
                    s.along.extend(nodes.iter().map(|node| node.along));
                    s.extra.extend(nodes.iter().filter(|_| charged).map(|n| item.extra(n.along)));
                    let ends = !nodes.is_empty()
                        && nodes
                            .chunks(2)
                            .zip((item.nodes.start..).step_by(2))
                            .all(|(n, id)| matches!(n, [a, b] if a.twin == id + 1 && b.twin == id));
                    (if ends { Kind::Open } else { Kind::Loose }, 0.0)
                }
            };
            s.close_item(kind, spacing, charged);
        }
        if problem.table().is_none() {
            let home = problem.home;
            s.place.push(if s.travel.by_table() { node_place(index(problem.nodes.len())) } else { home });
            s.along.push(0.0);
            s.close_item(Kind::Loose, 0.0, charged);
            s.rank.push(0);
        }
        s
    }

    /// Ends the places of the item being built.
    fn close_item(&mut self, kind: Kind, spacing: f64, charged: bool) {
        let from = self.first[self.first.len() - 1] as usize;
        let places = &self.place[from..];
        let count = places.len();
        let b = places.iter().fold(Aabb::EMPTY, |b, p| b.with(*p));
        self.middle.push(b.center());
        self.half.push(b.size() * 0.5);
        let gates = if self.travel.by_table() { places.len() } else { places.len().min(GATES) };
        self.gate_first.push(self.gate_first[self.gate_first.len() - 1] + index(gates));
        self.first.push(index(self.place.len()));
        self.corner_first.push(index(self.corner.len()));
        if charged {
            self.extra.resize(self.place.len(), 0.0);
        }
        // Places put on corners are off by up to half a spacing, as may be the gate.
        let apart = spacing * (0.5 * count as f64 / GATES as f64 + if charged { 1.0 } else { 0.0 });
        let top = &self.extra[from.min(self.extra.len())..];
        let [low, high] = top.iter().fold([0.0_f64; 2], |[low, high], &x| [low.min(x), high.max(x)]);
        self.slack.push(2.0 * self.travel.seconds_at_most(apart) + high - low);
        self.kind.push(kind);
        self.spacing.push(spacing);
    }

    /// An item's places.
    #[inline]
    pub(super) fn places(&self, item: u32) -> &[Place] {
        &self.place[self.first[item as usize] as usize..self.first[item as usize + 1] as usize]
    }

    /// How far from a place its neighbours on a ring are at most, mm.
    pub(super) fn reach(&self, item: u32) -> f64 {
        let item = item as usize;
        self.spacing[item] * if self.problem.items[item].uneven().is_some() { 2.0 } else { 1.0 }
    }

    /// Once round a ring, mm; 0 for other items.
    pub(super) fn round(&self, item: u32) -> f64 {
        self.spacing[item as usize] * self.places(item).len() as f64
    }

    /// Seconds on top for entering an item at a place.
    #[inline]
    pub(super) fn extra(&self, item: u32, at: u32) -> f64 {
        if self.extra.is_empty() { 0.0 } else { self.extra[(self.first[item as usize] + at) as usize] }
    }

    /// The stop that enters an item at a place.
    pub(super) fn stop(&self, item: u32, at: u32) -> Stop {
        let first = self.problem.items[item as usize].nodes.start;
        match self.kind[item as usize] {
            Kind::Ring => Stop::whole(first, self.along[(self.first[item as usize] + at) as usize]),
            Kind::Open | Kind::Loose => Stop::at(self.problem, first + at),
        }
    }

    /// A solution as a tour: entered at the places nearest to its own.
    pub(super) fn kept(&self, solution: &Solution) -> Kept {
        let mut kept = Kept { order: vec![self.home], at: vec![0; self.kind.len()] };
        for stop in &solution.stops {
            let item = self.problem.nodes[stop.node as usize].item;
            if item != self.home {
                kept.order.push(item);
            }
            kept.at[item as usize] = self.entered_at(stop);
        }
        kept
    }

    /// The place nearest to where a stop begins.
    pub(super) fn entered_at(&self, stop: &Stop) -> u32 {
        let item = self.problem.nodes[stop.node as usize].item;
        match self.kind[item as usize] {
            Kind::Ring => self.nearest(item, stop.along),
            Kind::Open | Kind::Loose => stop.node - self.problem.items[item as usize].nodes.start,
        }
    }

    /// The place nearest to where a stop leaves its item unfinished.
    #[expect(clippy::float_cmp, reason = "an item without a track is left at a node, bit for bit")]
    pub(super) fn left_at(&self, stop: &Stop) -> u32 {
        let item = self.problem.nodes[stop.node as usize].item;
        if self.is_ring(item) {
            return self.nearest(item, stop.until);
        }
        let nodes = self.problem.items[item as usize].nodes.clone();
        nodes.zip(0..).find(|(n, _)| self.problem.nodes[*n as usize].along == stop.until).map_or(0, |n| n.1)
    }

    /// The place of a ring nearest to an arc length: no place is off its even spacing by more than half of it.
    fn nearest(&self, item: u32, along: f64) -> u32 {
        let (first, count) = (self.first[item as usize] as usize, self.places(item).len());
        let (guess, spacing) = (nearest(along / self.spacing[item as usize]), self.spacing[item as usize]);
        let off = |k: usize| {
            let off = (self.along[first + k] - along).abs();
            off.min(spacing * count as f64 - off)
        };
        let near = [guess, guess + count - 1, guess + 1].map(|k| k % count);
        index(near.into_iter().fold(near[0], |best, k| if off(k) < off(best) { k } else { best }))
    }

    /// Whether an item may be entered anywhere along its track.
    #[inline]
    pub(super) fn is_ring(&self, item: u32) -> bool {
        self.kind[item as usize] == Kind::Ring
    }

    /// Where the head leaves an item entered at place `at`.
    pub(super) fn exit(&self, item: u32, at: u32) -> Place {
        self.places(item)[at as usize ^ usize::from(self.two_ends(item))]
    }

    /// An open contour or a pierce group: run the other way, by the other node of its pair, entry and exit change places.
    #[inline]
    pub(super) fn two_ends(&self, item: u32) -> bool {
        self.kind[item as usize] == Kind::Open
    }

    /// The gate nearest to place `at` of an item, counted over all items.
    pub(super) fn gate(&self, item: u32, at: u32) -> usize {
        let i = item as usize;
        let gate = match self.kind[i] {
            Kind::Ring => {
                // Both are powers of two: a division would take longer than all the rest.
                let step = self.places(item).len() / GATES;
                (at as usize + step / 2) >> step.trailing_zeros() & (GATES - 1)
            }
            Kind::Open | Kind::Loose => (at as usize).min(self.gate_count(item) - 1),
        };
        self.gate_first[i] as usize + gate
    }

    #[inline]
    fn gate_count(&self, item: u32) -> usize {
        (self.gate_first[item as usize + 1] - self.gate_first[item as usize]) as usize
    }

    /// Places of an item's gates.
    pub(super) fn gates(&self, item: u32) -> impl Iterator<Item = Place> {
        let places = self.places(item);
        let step = if self.is_ring(item) { places.len() / GATES } else { 1 };
        places.iter().step_by(step).take(self.gate_count(item)).copied()
    }

    /// No way from `p` to any place of `item` (`back`: from any place of it to `p`) takes less than this.
    pub(super) fn at_least(&self, p: Place, item: u32, back: bool) -> f64 {
        if self.travel.by_table() {
            return self.travel.least(p, item, self.places(item), back);
        }
        let i = item as usize;
        let d = (p - self.middle[i]).abs() - self.half[i];
        // In wasm the maximum of glam is a call, as it heeds what is not a number.
        let outside = |d: f64| 0.5 * (d + d.abs());
        self.travel.seconds_here(DVec2::ZERO, DVec2::new(outside(d.x), outside(d.y)))
    }

    /// How far an item is, for where that is asked of one place after the other.
    pub(super) fn reaching(&self, item: u32) -> Reaching<'_> {
        Reaching { space: self, item, rows: [false, true].map(|back| self.travel.leasts(item, back)) }
    }

    /// Seconds from `gap.from` into an item at place `at` and on to `gap.to`, with what that place costs on top.
    pub(super) fn through(&self, item: u32, at: u32, gap: Gap) -> f64 {
        let entry = self.places(item)[at as usize];
        let exit = if self.two_ends(item) { self.exit(item, at) } else { entry };
        let on = gap.to.map_or(0.0, |to| self.travel.seconds(exit, to));
        self.travel.seconds(gap.from, entry) + on + self.extra(item, at)
    }

    /// The best entry of an item in a gap, from all its places: index and seconds. Where none costs less than
    /// `under`, any of them: every fourth gate of a ring often tells so already.
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
            for (at, &place) in (0..).zip(places) {
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
        let step = ring.places.len() / GATES;
        for (first, every, reach) in [(0, 4, 4.0), (2, 4, 2.0), (1, 2, 1.0)] {
            // In steps of one's own: those of the library begin with a division.
            let mut at = first * step;
            while at < ring.places.len() {
                ring.try_at(at, &mut best);
                at += every * step;
            }
            if best.1 - reach * self.slack[item as usize] >= under {
                return best;
            }
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

    /// How many places on along a ring one is from another; 0 if it is a gate farther, or on no ring.
    pub(super) fn steps(&self, item: u32, from: u32, to: u32) -> i32 {
        let count = index(self.places(item).len());
        let (ahead, back) = (to.wrapping_sub(from) & (count - 1), from.wrapping_sub(to) & (count - 1));
        let steps = if ahead < back { ahead.cast_signed() } else { -back.cast_signed() };
        if self.is_ring(item) && ahead.min(back) < count / index(GATES) { steps } else { 0 }
    }

    /// The place of a ring so many places on.
    pub(super) fn stepped(&self, item: u32, from: u32, steps: i32) -> u32 {
        from.wrapping_add_signed(steps) & (index(self.places(item).len()) - 1)
    }

    /// The ring of an item in a gap.
    fn ring_in(&self, item: u32, gap: Gap) -> RingIn<'_> {
        let places = self.first[item as usize] as usize..self.first[item as usize + 1] as usize;
        let extra = if self.extra.is_empty() { &[][..] } else { &self.extra[places.clone()] };
        RingIn { travel: &self.travel, places: &self.place[places], extra, gap }
    }
}

/// Counts fit 32 bits: the reader's limits leave fewer than 2^32 places.
#[expect(clippy::cast_possible_truncation, reason = "see above")]
pub(super) fn index(n: usize) -> u32 {
    n as u32
}
