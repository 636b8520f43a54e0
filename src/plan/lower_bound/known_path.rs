//! A path that the bound knows, between the stops of searches and those of walks.

use crate::geometry::DVec2;
use crate::problem::Problem;
use crate::solve::Stop;

/// A path and its travel, s; infinite where none is known.
#[derive(Clone, Debug)]
pub(super) struct KnownPath {
    pub(super) seconds: f64,
    pub(super) entries: Vec<Entry>,
}

/// A stop of a path.
#[derive(Clone, Copy, Debug)]
pub(super) struct Entry {
    /// Which contour, counted from 0.
    pub(super) contour: usize,
    /// Where on its track, mm; without a track, it does not matter.
    pub(super) along: f64,
    /// Where the head arrives and leaves.
    pub(super) places: [DVec2; 2],
}

impl Default for KnownPath {
    fn default() -> Self {
        Self { seconds: f64::INFINITY, entries: Vec::new() }
    }
}

impl Entry {
    /// The entry of a stop; `None` if there is no such stop.
    pub(super) fn of(stop: &Stop, problem: &Problem) -> Option<Self> {
        let contour = problem.nodes.get(stop.node as usize)?.item as usize;
        let (arrives, leaves) = stop.ends(problem)?;
        Some(Self { contour, along: stop.along, places: [arrives, leaves] })
    }

    /// The stop whose ends are nearest to these places, and of several the one with the least extra seconds.
    pub(super) fn stop(&self, problem: &Problem) -> Option<Stop> {
        let item = problem.items.get(self.contour)?;
        let stop = |node| match &item.track {
            Some(_) => Stop::whole(node, self.along),
            None => Stop::at(problem, node),
        };
        let off = |stop: &Stop| {
            let ends = stop.ends(problem);
            ends.map_or(f64::INFINITY, |(a, b)| a.distance(self.places[0]) + b.distance(self.places[1]))
        };
        let extra = |stop: &Stop| item.extra(stop.node, stop.along);
        let stops = item.nodes.clone().map(stop);
        stops.min_by(|a, b| off(a).total_cmp(&off(b)).then(extra(a).total_cmp(&extra(b))))
    }
}
