//! What stays the same during a search, laid out for speed: places of entry, boxes, precedence.
//!
//! A closed contour may be entered anywhere along it. Its places are a ring of [`GATES`] * 2^k points (`ring.rs`), so that
//! the best entry between two points is found from coarse to fine: all gates (every 2^k-th place) first, then ever smaller
//! steps to both sides, then the corners, where the run along the contour costs less. The exact entry within the spacing of
//! the ring is found at the end (`polish.rs`). An item without a track has the places of its nodes; an open contour has
//! two, its ends.
//!
//! Home is one more item, the last, with one place; the tour starts there. With a table of costs home is the problem's last
//! item, with all its nodes.

mod build;

use super::boxes::{ARCS, BoundingBox};
use super::index::index;
use super::leave_places::LeavePlaces;
use super::ring::{GATES, nearest};
use super::snapshot::TourSnapshot;
use super::travel::{Place, Places, Travel};
use crate::geometry::DVec2;
use crate::machine::PLANS_ALL_LEVERS;
use crate::problem::Problem;
use crate::solve::precedence::Precedence;
use crate::solve::{Solution, Stop};

/// The unchanging data of a search.
pub(super) struct Space<'p> {
    pub(super) problem: &'p Problem,
    pub(super) travel: Travel<'p>,
    /// The home item: one past the problem's items; with a table the last of them.
    pub(super) home: u32,
    /// Places of item i: `first[i]..first[i + 1]`.
    pub(super) first: Vec<u32>,
    /// Where each place is, mm. With a table a place has the number of its node, and the points mean nothing.
    pub(super) point: Vec<DVec2>,
    /// Where the head leaves a place of a loose item, mm; empty if that is always where it arrived.
    left: Vec<DVec2>,
    /// Arc length of each place of a ring along its track, mm; empty where all are evenly spaced.
    along: Vec<f64>,
    /// Extra seconds of entering at each place; empty if no item has any.
    pub(super) extra: Vec<f64>,
    /// Corners of item i: `corner_first[i]..corner_first[i + 1]`.
    pub(super) corner_first: Vec<u32>,
    pub(super) corner: Vec<u32>,
    /// Gates of item i: `gate_first[i]..gate_first[i + 1]`.
    pub(super) gate_first: Vec<u32>,
    kind: Vec<Kind>,
    /// By item: distance of the places of a ring, mm; 0 for other items.
    spacing: Vec<f64>,
    /// By item: the boxes of the arcs of its ring.
    pub(super) arcs: Vec<[BoundingBox; ARCS]>,
    /// Where pierce groups may be left.
    pub(super) leave_places: LeavePlaces<'p>,
    /// Items whose seconds depend on the direction: pierce groups.
    pub(super) direction_dependent: Vec<u32>,
    /// By item: the box of its places.
    pub(super) whole: Vec<BoundingBox>,
    /// By item: most seconds that a link from or to it saves; empty without links.
    pub(super) most_saved: Vec<f64>,
    pub(super) rank: Vec<u32>,
    pub(super) precedence: Precedence,
}

/// How the places of an item lie to each other.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Kind {
    /// Places in order around a closed contour, `GATES` * 2^k of them.
    Ring,
    /// Paths with two ends, in pairs of forth and back: along an open contour, or through a pierce group.
    Open,
    /// Places in no order, each left where it is entered.
    Loose,
    /// Places in no order, each left at a point of its own.
    Directed,
}

impl Space<'_> {
    /// Most seconds that a link from or to an item saves on its air move.
    #[inline(always)]
    pub(super) fn most_saved(&self, item: u32) -> f64 {
        if PLANS_ALL_LEVERS { self.most_saved.get(item as usize).copied().unwrap_or(0.0) } else { 0.0 }
    }

    /// An item's places.
    #[inline]
    pub(super) fn places(&self, item: u32) -> Places<'_> {
        let (first, end) = (self.first[item as usize], self.first[item as usize + 1]);
        Places { points: &self.point[first as usize..end as usize], first }
    }

    /// Largest distance of a place from its neighbours on a ring, mm.
    pub(super) fn reach(&self, item: u32) -> f64 {
        let item = item as usize;
        self.spacing[item] * if self.problem.items[item].uneven().is_some() { 2.0 } else { 1.0 }
    }

    /// Length of a ring, mm; 0 for other items.
    pub(super) fn perimeter(&self, item: u32) -> f64 {
        self.spacing[item as usize] * self.places(item).len() as f64
    }

    /// Extra seconds of entering an item at a place.
    #[inline]
    pub(super) fn extra(&self, item: u32, at: u32) -> f64 {
        if self.extra.is_empty() { 0.0 } else { self.extra[(self.first[item as usize] + at) as usize] }
    }

    /// Arc length of a place of a ring along its track, mm.
    fn along(&self, item: u32, at: u32) -> f64 {
        let along = self.along.get((self.first[item as usize] + at) as usize);
        along.copied().unwrap_or(self.spacing[item as usize] * f64::from(at))
    }

    /// The stop that enters an item at a place.
    pub(super) fn stop(&self, item: u32, at: u32) -> Stop {
        let first = self.problem.items[item as usize].nodes.start;
        match self.kind[item as usize] {
            Kind::Ring => Stop::whole(first, self.along(item, at)),
            Kind::Open | Kind::Loose | Kind::Directed => Stop::at(self.problem, first + at),
        }
    }

    /// The tour of a solution, with entries at the places nearest to its own.
    pub(super) fn snapshot(&self, solution: &Solution) -> TourSnapshot {
        let mut snapshot = TourSnapshot { order: vec![self.home], at: vec![0; self.kind.len()] };
        for stop in &solution.stops {
            let item = self.problem.nodes[stop.node as usize].item;
            if item != self.home {
                snapshot.order.push(item);
            }
            snapshot.at[item as usize] = self.entered_at(stop);
        }
        snapshot
    }

    /// The place nearest to where a stop begins.
    pub(super) fn entered_at(&self, stop: &Stop) -> u32 {
        let item = self.problem.nodes[stop.node as usize].item;
        match self.kind[item as usize] {
            Kind::Ring => self.nearest(item, stop.along),
            Kind::Open | Kind::Loose | Kind::Directed => {
                stop.node - self.problem.items[item as usize].nodes.start
            }
        }
    }

    /// The place nearest to where a stop leaves its item unfinished.
    #[expect(clippy::float_cmp, reason = "an item without a track is left at a node, bit for bit")]
    pub(super) fn left_at(&self, stop: &Stop) -> u32 {
        let item = self.problem.nodes[stop.node as usize].item;
        if self.leave_places.is_group(item) {
            let places = self.leave_places.on_path(item, self.entered_at(stop));
            let is_here = |k: &u32| self.leave_places.place(item, *k).is_some_and(|p| p.along == stop.until);
            return places.clone().find(is_here).unwrap_or(places.start);
        }
        if self.is_ring(item) {
            return self.nearest(item, stop.until);
        }
        let nodes = self.problem.items[item as usize].nodes.clone();
        nodes.zip(0..).find(|(n, _)| self.problem.nodes[*n as usize].along == stop.until).map_or(0, |n| n.1)
    }

    /// The place of a ring nearest to an arc length. No place is farther from its even spacing than half of it, so that
    /// the neighbours of the first guess suffice.
    fn nearest(&self, item: u32, along: f64) -> u32 {
        let count = self.places(item).len();
        let (guess, spacing) = (nearest(along / self.spacing[item as usize]), self.spacing[item as usize]);
        let off = |k: usize| {
            let off = (self.along(item, index(k)) - along).abs();
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
        let place = self.places(item).at(at ^ u32::from(self.two_ends(item)));
        match self.left.get((self.first[item as usize] + at) as usize) {
            Some(&point) if self.is_directed(item) => Place { point, ..place },
            _ => place,
        }
    }

    /// Whether the head leaves an item elsewhere than it arrives, whichever way the tour runs: a contour with leads.
    #[inline]
    pub(super) fn is_directed(&self, item: u32) -> bool {
        self.kind[item as usize] == Kind::Directed
    }

    /// Whether an item is an open contour or a pierce group. Run the other way, by the other node of its pair, its entry
    /// and exit change places.
    #[inline]
    pub(super) fn two_ends(&self, item: u32) -> bool {
        self.kind[item as usize] == Kind::Open
    }

    /// Whether the head leaves an item elsewhere than it arrives.
    #[inline]
    pub(super) fn leaves_elsewhere(&self, item: u32) -> bool {
        matches!(self.kind[item as usize], Kind::Open | Kind::Directed)
    }

    /// Whether legs to and from an item have the same end and, in any direction, the same price.
    #[inline]
    pub(super) fn is_entered_where_left(&self, item: u32) -> bool {
        !self.travel.by_table() && !self.leaves_elsewhere(item)
    }

    /// The number of the gate nearest to place `at` of an item; gates are numbered over all items.
    pub(super) fn gate(&self, item: u32, at: u32) -> usize {
        let i = item as usize;
        let gate = match self.kind[i] {
            Kind::Ring => {
                // Both are powers of two, so that no division is needed.
                let step = self.places(item).len() / GATES;
                (at as usize + step / 2) >> step.trailing_zeros() & (GATES - 1)
            }
            Kind::Open | Kind::Loose | Kind::Directed => (at as usize).min(self.gate_count(item) - 1),
        };
        self.gate_first[i] as usize + gate
    }

    #[inline]
    fn gate_count(&self, item: u32) -> usize {
        (self.gate_first[item as usize + 1] - self.gate_first[item as usize]) as usize
    }

    /// The gates of an item.
    pub(super) fn gates(&self, item: u32) -> impl Iterator<Item = Place> {
        let places = self.places(item);
        let step = if self.is_ring(item) { places.len() / GATES } else { 1 };
        places.iter().step_by(step).take(self.gate_count(item))
    }

    /// Steps along a ring from one place to another, negative for backwards; 0 if they are a gate or more apart, or if the
    /// item has no ring.
    pub(super) fn steps(&self, item: u32, from: u32, to: u32) -> i32 {
        let count = index(self.places(item).len());
        let (ahead, back) = (to.wrapping_sub(from) & (count - 1), from.wrapping_sub(to) & (count - 1));
        let steps = if ahead < back { ahead.cast_signed() } else { -back.cast_signed() };
        if self.is_ring(item) && ahead.min(back) < count / index(GATES) { steps } else { 0 }
    }

    /// The place of a ring that is `steps` farther along.
    pub(super) fn stepped(&self, item: u32, from: u32, steps: i32) -> u32 {
        from.wrapping_add_signed(steps) & (index(self.places(item).len()) - 1)
    }
}
