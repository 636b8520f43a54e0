//! A path from outside to start a search from: one that another search found, or a worker before it was replaced.

mod feasible;
#[cfg(test)]
mod tests;

pub(super) use feasible::is_feasible;

use super::JobError;
use super::halves::joined;
use crate::problem::{Item, NodeId, Problem, Span, SubPath};
#[cfg(feature = "research")]
use crate::solve;
use crate::solve::{Solution, Stop};
use rustc_hash::FxHashSet;
use serde::{Deserialize, Serialize};

/// The order of the contours, where each is entered and in which direction it is cut, as in [`super::BestPath`].
#[derive(Clone, Debug, PartialEq, Default, Serialize, Deserialize)]
pub struct WarmPath {
    /// Contour of each stop.
    pub contours: Vec<u32>,
    /// Arc length from the contour's stored start to the entry, mm.
    pub along: Vec<f64>,
    /// Arc length from the stored start to where the stop ends, mm. If it is empty, every stop cuts the whole contour.
    #[serde(default)]
    pub until: Vec<f64>,
    /// 1 where a stop cuts its contour against the stored direction.
    pub reversed: Vec<u8>,
}

/// Largest distance between entries that count as the same, mm. Paths return bit for bit; this allows those written with
/// six digits, and is far below the distance of two entries.
const SAME_PLACE: f64 = 1e-6;

/// Paths whose costs differ by a smaller share are the same but for rounding.
const SAME_PATH: f64 = 1e-9;

/// Whether a path of this cost is better than one of that cost. Costs may be below 0 where contours are joined through waste.
pub(super) fn is_better(cost: f64, than: f64) -> bool {
    // The other cost may be infinite.
    cost < than && (than - cost) > SAME_PATH * cost.abs()
}

/// The stops of a path, if it visits every contour of the problem once, in a feasible order.
pub(super) fn solution(warm: &WarmPath, problem: &Problem) -> Result<Solution, JobError> {
    let places =
        warm.along.iter().enumerate().map(|(k, &along)| (along, *warm.until.get(k).unwrap_or(&along)));
    let all: Vec<Visit> = warm
        .contours
        .iter()
        .zip(places)
        .zip(&warm.reversed)
        .map(|((&contour, (along, until)), &reversed)| Visit {
            contour,
            along,
            until,
            reversed: reversed != 0,
        })
        .collect();
    let mut groups: Vec<Group> = problem.items.iter().filter_map(|i| Group::new(i, &all)).collect();
    let mut rest = all.as_slice();
    let stops = std::iter::from_fn(|| {
        let (visit, after) = rest.split_first()?;
        let second = after.first().filter(|v| v.contour == visit.contour);
        let halves = second.map(|v| [visit, v].map(|v| (v.along, v.until, v.reversed)));
        if let Some(stop) = halves.and_then(|halves| joined(problem, visit.contour, halves)) {
            rest = after.get(1..).unwrap_or_default();
            return Some(Some(stop));
        }
        let group = groups.iter_mut().find_map(|g| g.stop(rest));
        rest = group.map_or(after, |(_, visits)| rest.get(visits..).unwrap_or_default());
        Some(group.map_or_else(|| stop(problem, visit), |(stop, _)| Some(stop)))
    });
    stops
        .collect::<Option<Vec<Stop>>>()
        .filter(|stops| is_feasible(stops, problem))
        .map(|stops| Solution::new(problem, stops))
        .ok_or(JobError::UnfitPath)
}

/// The path of a solution in which every contour is cut by stops of its own. `None` if it cannot be told so, as with contours that are cut in halves.
#[cfg(feature = "research")]
pub(super) fn of(best: &Solution, problem: &Problem) -> Option<WarmPath> {
    let mut path = WarmPath::default();
    for stop in &best.stops {
        let node = problem.nodes.get(stop.node as usize)?;
        path.contours.push(node.item);
        path.along.push(stop.along);
        path.until.push(stop.until);
        path.reversed.push(node.reversed.into());
    }
    let is_same = |told: Solution| solve::priced(problem, told).cost <= best.cost;
    solution(&path, problem).is_ok_and(is_same).then_some(path)
}

/// One stop of the path.
#[derive(Clone, Copy)]
struct Visit {
    contour: u32,
    along: f64,
    until: f64,
    reversed: bool,
}

/// A pierce group, and the path through it that a warm path takes.
struct Group<'p> {
    node: NodeId,
    path: &'p SubPath,
    /// Number of its stretches that have been cut.
    cut: usize,
    /// The place on the path up to which it has been cut, mm.
    along: f64,
}

impl<'p> Group<'p> {
    /// The group of an item; `None` if it is no group, or if the visits take none of its paths.
    fn new(item: &'p Item, visits: &[Visit]) -> Option<Self> {
        // Most items are no groups. Going through all visits for each of them would be quadratic.
        if item.paths.is_empty() {
            return None;
        }
        let contours: FxHashSet<u32> =
            item.paths.iter().flat_map(SubPath::spans).map(|s| s.contour).collect();
        let own: Vec<&Visit> = visits.iter().filter(|v| contours.contains(&v.contour)).collect();
        let is_taken = |path: &&SubPath| {
            own.len() == path.spans().count() && own.iter().zip(path.spans()).all(|(v, s)| v.is(s))
        };
        let taken = item.nodes.clone().zip(&item.paths).find(|(_, path)| is_taken(path));
        taken.map(|(node, path)| Self { node, path, cut: 0, along: 0.0 })
    }

    /// The stop that cuts the stretches these visits begin with, and the number of stretches.
    fn stop(&mut self, visits: &[Visit]) -> Option<(Stop, usize)> {
        let left = self.path.spans().skip(self.cut);
        let alike = visits.iter().zip(left).take_while(|(v, s)| v.is(s)).count();
        let cut = self.cut + alike;
        if alike == 0 {
            return None;
        }
        let until = if self.path.spans().nth(cut).is_none() {
            0.0
        } else {
            // The sum is made as the place of a leave point is: stretch by stretch.
            self.path.spans().take(cut).map(|s| s.length).fold(0.0, |sum, length| sum + length)
        };
        let stop = Stop { node: self.node, along: self.along, until };
        (self.cut, self.along) = (cut, until);
        Some((stop, alike))
    }
}

impl Visit {
    /// Whether it is a stretch of a path through a pierce group.
    fn is(&self, s: &Span) -> bool {
        let places = (self.along - s.along).abs().max((self.until - s.until).abs());
        self.contour == s.contour && self.reversed == s.reversed && places <= SAME_PLACE
    }
}

/// The stop between two places: anywhere along a track, otherwise at nodes.
fn stop(problem: &Problem, visit: &Visit) -> Option<Stop> {
    let Visit { contour, along, until, reversed } = *visit;
    // A pierce group is recognised by its stretches only.
    let item = problem.items.get(contour as usize).filter(|i| !i.is_pierce_group())?;
    let at = |along: f64| {
        let mut stops = item.nodes.clone().map(|node| Stop::at(problem, node));
        let same_way = |s: &Stop| problem.nodes[s.node as usize].reversed == reversed;
        match &item.track {
            Some(track) if (0.0..=track.length()).contains(&along) => {
                stops.find(same_way).map(|s| Stop::whole(s.node, along))
            }
            Some(_) => None,
            // Where it is also entered from the edge of the sheet, without piercing, it is the quicker one.
            None => stops
                .filter(|s| same_way(s) && (s.along - along).abs() <= SAME_PLACE)
                .min_by(|a, b| item.extra(a.node, a.along).total_cmp(&item.extra(b.node, b.along))),
        }
    };
    Some(Stop { until: at(until)?.along, ..at(along)? })
}
