//! A path from outside to start a search from: one that another search found, or a worker before it was replaced.

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
pub(super) const SAME_PATH: f64 = 1e-9;

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

/// An unfinished item: where it was begun, where it was left, and the path through it if it is a pierce group.
struct Open<'p> {
    item: usize,
    start: f64,
    left: f64,
    path: Option<&'p SubPath>,
}

/// Whether a path is feasible: every item that can be visited is visited, once around; nothing is finished before what lies
/// inside it or before what a sequence puts before it, or begun before a lower rank; only contours that may be left are, they
/// are resumed where they were left, and visits nest.
#[expect(clippy::float_cmp, reason = "visits of a contour join bit for bit")]
pub(super) fn is_feasible(stops: &[Stop], problem: &Problem) -> bool {
    let mut finished = vec![None; problem.items.len()];
    let mut open: Vec<Open> = Vec::new();
    let mut rank = 0;
    for (k, stop) in stops.iter().enumerate() {
        let Some(item) = problem.nodes.get(stop.node as usize).map(|n| n.item as usize) else { return false };
        let path = problem.items[item].path(stop.node);
        let resumed = open.pop_if(|o| o.item == item);
        let start = resumed.as_ref().map_or(stop.along, |o| o.start);
        let joined = resumed.is_none_or(|o| o.left == stop.along) && !open.iter().any(|o| o.item == item);
        if !joined || finished[item].is_some() || problem.items[item].rank < rank {
            return false;
        }
        rank = problem.items[item].rank;
        if stop.until == start {
            finished[item] = Some(k);
            // Where a group was left for an item in one of its areas, the area must still hold.
            let inside = open.iter().filter(|o| problem.items[item].before == u32::try_from(o.item).ok());
            let due = |o: &Open| o.path.map_or(f64::INFINITY, |path| path.due(problem.items[item].area));
            if inside.into_iter().any(|o| o.left >= due(o)) {
                return false;
            }
        } else {
            // Orders places by their position on a round from the start.
            let order = |place: f64| (place < start, place);
            let may_be_left = match path {
                Some(path) => path.leave_point(stop.until).is_some(),
                None => problem.items[item].leave.is_some(),
            };
            if !may_be_left || order(stop.until) <= order(stop.along) {
                return false;
            }
            open.push(Open { item, start, left: stop.until, path });
        }
    }
    let order = stops.iter().map(|s| problem.nodes[s.node as usize].item);
    let in_turn = |&(first, then): &(u32, u32)| finished[first as usize] <= finished[then as usize];
    open.is_empty()
        && problem.pairs.iter().all(in_turn)
        && problem.groups.are_together(order, |i| problem.items[i as usize].rank)
        && problem.items.iter().zip(&finished).all(|(item, at)| match at {
            None => item.nodes.is_empty(),
            Some(_) => item.before.is_none_or(|outer| finished[outer as usize].is_none_or(|o| Some(o) > *at)),
        })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::DVec2;
    use crate::machine;
    use crate::problem::{Item, Node};

    /// Three items with two entries each; the first lies inside the last.
    fn problem() -> Problem {
        let entry = |item, x: f64, along| Node {
            item,
            entry: DVec2::new(x, 0.0),
            exit: DVec2::new(x, 0.0),
            along,
            reversed: false,
            twin: 0,
        };
        let nodes = (0..3).flat_map(|i| [entry(i, f64::from(i), 0.0), entry(i, f64::from(i) + 0.5, 10.0)]);
        let mut nodes: Vec<Node> = nodes.collect();
        for (node, id) in nodes.iter_mut().zip(0..) {
            node.twin = id;
        }
        let item = |i: u32, before| Item { nodes: 2 * i..2 * i + 2, before, fixed: 1.0, ..Item::default() };
        let machine = machine::preset("length").unwrap();
        Problem {
            items: vec![item(0, Some(2)), item(1, None), item(2, None)],
            nodes,
            home: DVec2::ZERO,
            closed: false,
            ..Problem::empty(machine)
        }
    }

    fn warm(contours: &[u32], along: &[f64]) -> WarmPath {
        WarmPath {
            contours: contours.to_vec(),
            along: along.to_vec(),
            until: vec![],
            reversed: vec![0; contours.len()],
        }
    }

    /// The fault, the contours, and where each visit begins and ends.
    type Refused<'a> = (&'a str, &'a [u32], &'a [(f64, f64)]);

    /// The same problem, where the outer contour may be left at the cost `leave`.
    fn left(contours: &[u32], places: &[(f64, f64)], leave: Option<f64>) -> Result<Solution, JobError> {
        let mut problem = problem();
        problem.items[2].leave = leave;
        let (along, until) = places.iter().copied().unzip();
        let reversed = vec![0; contours.len()];
        solution(&WarmPath { contours: contours.to_vec(), along, until, reversed }, &problem)
    }

    #[test]
    fn a_contour_left_unfinished_is_resumed_where_it_was_left() {
        let places = [(0.0, 10.0), (0.0, 0.0), (0.0, 0.0), (10.0, 0.0)];
        let order = [2, 0, 1, 2];
        let found = left(&order, &places, Some(4.0)).unwrap();
        // From home at 0 to 2, along to 2.5, back to 0, to 1, to 2.5, along to 2: air moves, plus the cost of leaving.
        assert!((found.cost - (2.0 + 2.5 + 1.0 + 1.5 + 4.0)).abs() < 1e-12, "{}", found.cost);
        assert!(left(&order, &places, None).is_err(), "where nothing may be left");
        let refused: [Refused; 5] = [
            ("never resumed", &order[..3], &places[..3]),
            ("resumed elsewhere", &order, &[places[0], places[1], places[2], (0.0, 0.0)]),
            ("round twice", &order, &[places[0], places[1], places[2], (10.0, 10.0)]),
            ("finished before what is inside", &[2, 1, 2, 0], &[places[0], places[1], places[3], places[2]]),
            ("begun where it is not left", &[2, 2, 0, 1], &[places[0], places[0], places[1], places[2]]),
        ];
        for (what, order, places) in refused {
            assert!(left(order, places, Some(4.0)).is_err(), "{what}");
        }
    }

    #[test]
    fn a_path_of_this_drawing_becomes_the_nodes_it_names() {
        let found = solution(&warm(&[1, 0, 2], &[10.0, 0.0, 10.0]), &problem()).unwrap();
        assert_eq!(found.stops.iter().map(|s| s.node).collect::<Vec<_>>(), [3, 0, 5]);
        // From home at 0 to 1.5, back to 0, on to 2.5, at unit speed.
        assert!((found.cost - 5.5).abs() < 1e-12, "{}", found.cost);
    }

    #[test]
    fn a_path_of_another_drawing_is_refused() {
        let cases = [
            ("too short", warm(&[1, 0], &[0.0, 0.0])),
            ("twice the same", warm(&[0, 0, 2], &[0.0, 0.0, 0.0])),
            ("no such contour", warm(&[0, 1, 7], &[0.0, 0.0, 0.0])),
            ("no such entry", warm(&[0, 1, 2], &[0.0, 3.0, 0.0])),
            ("outer before inner", warm(&[2, 0, 1], &[0.0, 0.0, 0.0])),
        ];
        for (what, path) in cases {
            assert!(solution(&path, &problem()).is_err(), "{what}");
        }
    }
}
