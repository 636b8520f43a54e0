//! The improved proximity method, Qu & Du section II.B: from every feature point in turn, always to the nearest feature
//! point of a contour not yet visited; the shortest path is kept, with the way d0 from the origin (eq. (3)).
//!
//! Steps 1-3 are [`Walk`], steps 4 and 5 are here. A fixed start is kept in front of every path; the points in turn then
//! come second. A cycle given by a table is turned until it begins where the table says. Ties in step 5 are all kept, and
//! as the swarm needs many paths, so are the next shortest.

use super::super::keys::Keys;
use super::super::left::{Left, Walk};
use super::super::legs::Legs;
use crate::problem::NodeId;

/// The method under way.
pub(super) struct Proximity {
    /// Points still to start from, the next one last.
    starts: Vec<NodeId>,
    walk: Option<Walk>,
    /// Paths with their lengths, the shortest first; equals in the order of their starts.
    pub(super) paths: Vec<(f64, Vec<NodeId>)>,
    keep: usize,
    /// The shortest is new.
    fresh: bool,
}

impl Proximity {
    /// Keeps that many paths. `most`: steps of all walks together at most; with more points than that allows, every so
    /// manieth is taken, but never fewer than `keep`.
    pub(super) fn new(legs: &Legs, keys: &Keys, keep: usize, most: u64) -> Self {
        let problem = legs.problem();
        let fixed = keys.pinned.map(|n| problem.nodes[n as usize].item);
        let points = (0..).zip(&problem.nodes).filter(|(_, n)| Some(n.item) != fixed).map(|(n, _)| n);
        let points: Vec<NodeId> = points.collect();
        let walks = most / (keys.items().len() as u64).max(1);
        let count = points.len().min(usize::try_from(walks).unwrap_or(usize::MAX).max(keep));
        let mut starts: Vec<NodeId> = (0..count).rev().map(|k| points[k * points.len() / count]).collect();
        if points.is_empty() {
            starts.extend(keys.pinned);
        }
        Self { starts, walk: None, paths: Vec::new(), keep, fresh: false }
    }

    /// The shortest path so far, if it was not told yet.
    pub(super) fn shorter(&mut self) -> Option<Vec<NodeId>> {
        let fresh = std::mem::replace(&mut self.fresh, false);
        self.paths.first().filter(|_| fresh).map(|p| p.1.clone())
    }

    /// The next step; its price, or nothing when all paths are walked.
    pub(super) fn piece(&mut self, legs: &Legs, keys: &Keys, all: &Left) -> Option<u64> {
        let problem = legs.problem();
        let Some(walk) = &mut self.walk else {
            let start = self.starts.pop()?;
            let mut begun = vec![start];
            if let Some(fixed) = keys.pinned.filter(|&f| f != start) {
                begun.insert(0, fixed);
            }
            self.walk = Some(Walk::new(all.clone(), problem, &begun));
            return Some(problem.nodes.len() as u64);
        };
        if let Some(priced) = walk.step(legs) {
            return Some(priced);
        }
        let mut path = std::mem::take(&mut walk.tour);
        self.walk = None;
        if let Some(at) = path.iter().position(|&n| Some(problem.nodes[n as usize].item) == problem.start()) {
            path.rotate_left(at);
        }
        let (length, cost) = (legs.around(&path), path.len() as u64);
        let place = self.paths.partition_point(|p| p.0 <= length);
        self.fresh |= place == 0;
        self.paths.insert(place, (length, path));
        self.paths.truncate(self.keep);
        Some(cost)
    }
}
