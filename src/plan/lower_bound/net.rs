//! The problem as the bound sees it: items with knots where legs of the tour may end.
//!
//! A closed contour is entered and left at the same knot, an open one at its two ends (`paired`: knots 0 and 1 belong
//! together, 2 and 3, and so on). Between knots are pieces: a contour that may be entered anywhere is a ring of pieces, and a
//! single node is a piece with one knot. Item 0 is home.

use super::extras::{Extras, HAS_EXTRAS, counts_extras};
use super::track::Track;
use crate::geometry::{Aabb, DVec2};
use crate::order::{real, sort_by};
use crate::problem::{self, NodeId, Problem};

/// Longest piece that is not halved, mm: places on it hardly differ by more than their rounding. Where contours share a corner, what is
/// lost there never ends, because the seconds of a leg go with the root of its length.
const SHORTEST: f64 = 1e-6;

/// A stretch of a contour between two knots, followed at even speed.
#[derive(Clone, Copy, Debug)]
pub(super) struct Piece {
    /// The knots at its ends, counted within the item.
    pub(super) knots: [usize; 2],
    /// Their places, mm.
    pub(super) ends: [DVec2; 2],
    /// Largest distance of a point of the piece from the point at the same share of its chord, mm.
    pub(super) off: f64,
    /// Half of the extra seconds of stops on it, at its ends: a straight function below the real ones.
    pub(super) halves: [f64; 2],
    /// The box around all of it.
    pub(super) around: Aabb,
    /// The arc length along the track where it ends, mm, which may be beyond the end of the track; 0 without a track.
    to: f64,
}

/// Something to be visited.
#[derive(Clone, Debug)]
pub(super) struct Item {
    /// Number of knots.
    pub(super) knots: usize,
    /// Arrived at one knot of a pair, left from the other.
    pub(super) paired: bool,
    pub(super) pieces: Vec<Piece>,
    /// Arc length of each knot along the track, ascending; empty without a track.
    pub(super) along: Vec<f64>,
    track: Option<Track>,
    /// The box around all of it.
    pub(super) around: Aabb,
}

/// All items of a problem: home first, and for an open path a second one, wherever it ends. With a table home is the
/// item at which the cycle starts.
pub(super) fn items(problem: &Problem) -> Vec<Item> {
    let contours = problem.items.iter().map(|item| of_item(problem, item));
    if problem.table().is_some() {
        let mut items: Vec<Item> = contours.collect();
        items.rotate_right(1);
        return items;
    }
    let home = points(&[problem.home], false);
    let mut items = if problem.closed { vec![home] } else { vec![home.clone(), home] };
    items.extend(contours);
    items
}

/// How many of the items are home.
pub(super) fn homes(problem: &Problem) -> usize {
    if problem.table().is_some() || problem.closed { 1 } else { 2 }
}

fn of_item(problem: &Problem, item: &problem::Item) -> Item {
    let nodes = &problem.nodes[item.nodes.start as usize..item.nodes.end as usize];
    if nodes.is_empty() {
        // A skipped contour: every tour visits it at home at no cost.
        return points(&[problem.home], false);
    }
    if let Some(path) = &item.track {
        let mut along: Vec<f64> = nodes.iter().map(|n| n.along).collect();
        sort_by(&mut along, |&s| [real(s), 0, 0]);
        along.dedup();
        let mut starts = vec![0.0];
        for s in &path.segments {
            starts.push(starts[starts.len() - 1] + s.length());
        }
        return ring(Track { path: path.clone(), starts, extras: Extras::new(item) }, &along);
    }
    let half = |id: NodeId| 0.5 * item.extra(id, problem.nodes[id as usize].along);
    if problem.table().is_some() || nodes.iter().all(|n| n.entry == n.exit) {
        let places: Vec<DVec2> = nodes.iter().map(|n| n.entry).collect();
        return points(&places, false).with_extras(item, item.nodes.clone().map(half));
    }
    let ways = nodes.iter().zip(item.nodes.clone()).filter(|(n, id)| *id <= n.twin);
    let ends: Vec<DVec2> = ways.clone().flat_map(|(n, _)| [n.entry, n.exit]).collect();
    points(&ends, true).with_extras(item, ways.flat_map(|(n, id)| [half(id).min(half(n.twin)); 2]))
}

/// An item with a knot at each of these places.
pub(super) fn points(places: &[DVec2], paired: bool) -> Item {
    let piece = |(k, &p): (usize, &DVec2)| Piece {
        knots: [k; 2],
        ends: [p; 2],
        off: 0.0,
        halves: [0.0; 2],
        around: Aabb::of(p),
        to: 0.0,
    };
    let pieces: Vec<Piece> = places.iter().enumerate().map(piece).collect();
    Item { knots: places.len(), paired, along: Vec::new(), track: None, around: hull(&pieces), pieces }
}

/// A stretch of a track between the arc lengths of two knots. `to`: the same as `end`, or a lap more.
#[derive(Clone, Copy, Debug)]
struct Stretch {
    start: f64,
    end: f64,
    to: f64,
}

/// All of a closed track, divided at these arc lengths.
fn ring(track: Track, along: &[f64]) -> Item {
    let length = track.length();
    let stretch = |k: usize| {
        let end = along[(k + 1) % along.len()];
        Stretch { start: along[k], end, to: if k + 1 < along.len() { end } else { end + length } }
    };
    of_stretches(track, &(0..along.len()).map(stretch).collect::<Vec<_>>())
}

/// The item of these stretches of its track.
fn of_stretches(track: Track, stretches: &[Stretch]) -> Item {
    let mut along: Vec<f64> = stretches.iter().flat_map(|s| [s.start, s.end]).collect();
    sort_by(&mut along, |&s| [real(s), 0, 0]);
    along.dedup_by(|a, b| a.to_bits() == b.to_bits());
    let at = |s: f64| track.path.at(s).unwrap_or_default();
    let piece = |s: &Stretch| {
        let ends = [at(s.start), at(s.end)];
        let off = track.off_chord(s.start, s.to, ends);
        let knots = [s.start, s.end].map(|x| along.partition_point(|&a| a < x));
        let halves = track.extras.below(s.start, s.to, track.length());
        Piece { knots, ends, off, halves, around: Aabb::of(ends[0]).with(ends[1]).grown(off), to: s.to }
    };
    let pieces: Vec<Piece> = stretches.iter().map(piece).collect();
    let around = hull(&pieces);
    Item { knots: along.len(), paired: false, along, track: Some(track), around, pieces }
}

/// Where the knots of each item start if they are counted through all items, and how many there are.
pub(super) fn bases(items: &[Item]) -> (Vec<usize>, usize) {
    let mut knots = 0;
    let start = |item: &Item| {
        knots += item.knots;
        knots - item.knots
    };
    (items.iter().map(start).collect(), knots)
}

fn hull(pieces: &[Piece]) -> Aabb {
    pieces.iter().fold(Aabb::EMPTY, |b, p| b.union(p.around))
}

impl Item {
    /// The same item of points with half of the extra seconds of a stop at each knot.
    fn with_extras(mut self, item: &problem::Item, halves: impl Iterator<Item = f64>) -> Self {
        if counts_extras(item) {
            self.pieces.iter_mut().zip(halves).for_each(|(piece, half)| piece.halves = [half; 2]);
        }
        self
    }

    /// Half of the extra seconds of a stop at a knot.
    pub(super) fn half(&self, knot: usize) -> f64 {
        if !HAS_EXTRAS {
            return 0.0;
        }
        let of_point = || self.pieces.get(knot).map_or(0.0, |p| p.halves[0]);
        self.track.as_ref().map_or_else(of_point, |t| t.extras.half(self.along[knot]))
    }

    /// The contour, if it may be entered anywhere.
    #[cfg(feature = "research")]
    pub(super) fn track(&self) -> Option<&Track> {
        self.track.as_ref()
    }

    /// Where a knot is.
    pub(super) fn place(&self, knot: usize) -> DVec2 {
        let end = |p: &Piece| p.knots.iter().position(|&k| k == knot).map(|side| p.ends[side]);
        self.pieces.iter().find_map(end).unwrap_or_default()
    }

    /// Whether it has pieces that can be halved.
    pub(super) fn can_halve(&self) -> bool {
        self.track.is_some()
    }

    /// Whether a piece can be halved.
    pub(super) fn can_be_halved(&self, piece: &Piece) -> bool {
        self.track.is_some() && piece.to - self.along[piece.knots[0]] > SHORTEST
    }

    /// The same item with knots at these arc lengths along its track; without a track there must be none.
    pub(super) fn with_knots(&self, along: &[f64]) -> Option<Self> {
        let Some(track) = &self.track else { return along.is_empty().then(|| self.clone()) };
        let length = track.length();
        let inside = along.iter().all(|s| (0.0..length).contains(s)) && along.windows(2).all(|w| w[0] < w[1]);
        if along.is_empty() || !inside {
            return None;
        }
        Some(ring(track.clone(), along)).filter(|item| item.knots == along.len())
    }

    /// The number of pieces that stay, see [`Item::finer`]: all of an item without a track.
    pub(super) fn pieces_left(&self, in_use: &[bool]) -> usize {
        let stays = |p: &&Piece| self.track.is_none() || p.touches(in_use);
        self.pieces.iter().filter(stays).count()
    }

    /// The same item with the marked pieces halved that can be; `None` without a track.
    pub(super) fn halved(&self, marked: &[bool]) -> Option<Self> {
        self.finer(marked, &vec![true; self.knots])
    }

    /// The same item with the marked pieces halved that can be, and without the pieces that touch no knot in use; `None` without a track.
    pub(super) fn finer(&self, marked: &[bool], in_use: &[bool]) -> Option<Self> {
        let track = self.track.as_ref()?;
        let length = track.length();
        let mut stretches = Vec::with_capacity(2 * self.pieces.len());
        for (piece, &marked) in self.pieces.iter().zip(marked) {
            let [start, end] = piece.knots.map(|k| self.along[k]);
            if !piece.touches(in_use) {
                continue;
            }
            if marked && self.can_be_halved(piece) {
                let middle = 0.5 * (start + piece.to);
                // Past the end of the track, its beginning.
                let lap = if middle >= length { length } else { 0.0 };
                stretches.push(Stretch { start, end: middle - lap, to: middle });
                stretches.push(Stretch { start: middle - lap, end, to: piece.to - lap });
            } else {
                stretches.push(Stretch { start, end, to: piece.to });
            }
        }
        Some(of_stretches(track.clone(), &stretches))
    }
}

impl Piece {
    fn touches(&self, in_use: &[bool]) -> bool {
        self.knots.iter().any(|&k| in_use[k])
    }
}
