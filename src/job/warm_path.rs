//! A path from outside to start a search from: one that another search found, or a worker before it was replaced.

use super::JobError;
use crate::problem::{Item, Problem, Span};
use crate::solve::{Solution, Stop};
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
    let groups: Vec<&Item> = problem.items.iter().filter(|i| i.is_pierce_group()).collect();
    let mut rest = all.as_slice();
    let stops = std::iter::from_fn(|| {
        let (visit, after) = rest.split_first()?;
        let group = group_stop(problem, &groups, rest);
        rest = group.map_or(after, |(_, visits)| rest.get(visits..).unwrap_or_default());
        Some(group.map_or_else(|| stop(problem, visit), |(stop, _)| Some(stop)))
    });
    stops
        .collect::<Option<Vec<Stop>>>()
        .filter(|stops| is_feasible(stops, problem))
        .map(|stops| Solution::new(problem, stops))
        .ok_or_else(|| {
            JobError::Options(
                "The path to start from does not fit this drawing and these options. Start without it."
                    .into(),
            )
        })
}

/// One stop of the path.
#[derive(Clone, Copy)]
struct Visit {
    contour: u32,
    along: f64,
    until: f64,
    reversed: bool,
}

/// The stop at the pierce group whose stretches these visits begin with, and the number of stretches.
fn group_stop(problem: &Problem, groups: &[&Item], visits: &[Visit]) -> Option<(Stop, usize)> {
    let is = |v: &Visit, s: &Span| {
        let places = (v.along - s.along).abs().max((v.until - s.until).abs());
        v.contour == s.contour && v.reversed == s.reversed && places <= SAME_PLACE
    };
    groups.iter().find_map(|item| {
        item.nodes.clone().zip(&item.paths).find_map(|(node, path)| {
            let spans = path.spans().count();
            let alike =
                spans > 0 && visits.len() >= spans && visits.iter().zip(path.spans()).all(|(v, s)| is(v, s));
            alike.then(|| (Stop::at(problem, node), spans))
        })
    })
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
            None => stops.find(|s| same_way(s) && (s.along - along).abs() <= SAME_PLACE),
        }
    };
    Some(Stop { until: at(until)?.along, ..at(along)? })
}

/// An unfinished contour: where it was begun, and where it was left.
struct Open {
    item: usize,
    start: f64,
    left: f64,
}

/// Whether a path is feasible: every item that can be visited is visited, once around; nothing is finished before what lies
/// inside it or begun before a lower rank; only contours that may be left are, they are resumed where they were left, and
/// visits nest.
#[expect(clippy::float_cmp, reason = "visits of a contour join bit for bit")]
fn is_feasible(stops: &[Stop], problem: &Problem) -> bool {
    let mut finished = vec![None; problem.items.len()];
    let mut open: Vec<Open> = Vec::new();
    let mut rank = 0;
    for (k, stop) in stops.iter().enumerate() {
        let item = problem.nodes[stop.node as usize].item as usize;
        let resumed = open.pop_if(|o| o.item == item);
        let start = resumed.as_ref().map_or(stop.along, |o| o.start);
        let joined = resumed.is_none_or(|o| o.left == stop.along) && !open.iter().any(|o| o.item == item);
        if !joined || finished[item].is_some() || problem.items[item].rank < rank {
            return false;
        }
        rank = problem.items[item].rank;
        if stop.until == start {
            finished[item] = Some(k);
        } else {
            // Orders places by their position on a round from the start.
            let order = |place: f64| (place < start, place);
            if problem.items[item].leave.is_none() || order(stop.until) <= order(stop.along) {
                return false;
            }
            open.push(Open { item, start, left: stop.until });
        }
    }
    let order = stops.iter().map(|s| problem.nodes[s.node as usize].item);
    open.is_empty()
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
    use crate::problem::{Groups, Item, Node};

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
            machine,
            pairs: Vec::new(),
            groups: Groups::default(),
            table: None,
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
