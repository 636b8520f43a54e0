//! Parts of the partition-tree method, checked by hand and by brute force.

mod exact;
mod moves;
mod resolution;

use super::forest::{Forest, ROOT};
use super::graph::{Graph, Neighbourhood};
use crate::problem::{LeavePoint, NodeId, Problem, SubPath};
use crate::solve::papers::test_sheet;
use crate::solve::rng::{Draw, Rng};
use glam::DVec2;

/// Seconds of leaving a contour in most tests.
const PRE_CUT: f64 = 1.0;

/// Closed contours with these corners, which may be left for [`PRE_CUT`]; a path of 1 mm takes a second.
fn sheet(contours: &[&[[f64; 2]]]) -> Problem {
    test_sheet::sheet(contours, Some(PRE_CUT), "length")
}

/// Random contours with this number of corners. Some lie inside others, some may not be left, and a few are open.
fn random(contours: usize, corners: usize, rng: &mut Rng) -> Problem {
    let mut place = || [rng.uniform() * 100.0, rng.uniform() * 100.0];
    let all: Vec<Vec<[f64; 2]>> = (0..contours).map(|_| (0..corners).map(|_| place()).collect()).collect();
    let mut problem = sheet(&all.iter().map(Vec::as_slice).collect::<Vec<_>>());
    problem.closed = rng.below(2) == 0;
    for k in 0..contours {
        let item = &mut problem.items[k];
        // Outer contours have lower numbers, so that there are no cycles.
        item.before = (k > 0 && rng.below(3) == 0).then(|| u32::try_from(rng.below(k)).unwrap());
        item.leave = (rng.below(4) > 0).then(|| rng.uniform() * 20.0);
        if corners == 2 && rng.below(4) == 0 {
            item.leave = None;
            let (a, b) = (item.nodes.start, item.nodes.start + 1);
            for (own, other) in [(a, b), (b, a)] {
                problem.nodes[own as usize].exit = problem.nodes[other as usize].entry;
                problem.nodes[own as usize].twin = other;
            }
        }
    }
    problem
}

/// Makes the contours of an even number of corners pierce groups, every other one: each pair of corners are the ends of a path
/// and the path back, which pass some of three nodes in a random order.
fn with_groups(mut problem: Problem, rng: &mut Rng) -> Problem {
    for item in problem.items.iter_mut().step_by(2).filter(|i| i.nodes.len() % 2 == 0) {
        let places: Vec<DVec2> =
            (0..3).map(|_| DVec2::new(rng.uniform() * 100.0, rng.uniform() * 100.0)).collect();
        item.leave = None;
        for node in item.nodes.clone() {
            let twin = item.nodes.start + ((node - item.nodes.start) ^ 1);
            let exit = problem.nodes[twin as usize].entry;
            let own = &mut problem.nodes[node as usize];
            (own.exit, own.twin, own.along) = (exit, twin, 0.0);
            let mut leave_points = Vec::new();
            for k in 0..3 {
                let node = u32::try_from(rng.below(3)).unwrap();
                let returns = if rng.below(3) == 0 { rng.below(3) } else { node as usize };
                leave_points.push(LeavePoint {
                    along: 1.0 + f64::from(k),
                    node,
                    ends: [places[node as usize], places[returns]],
                    seconds: rng.uniform() * 20.0 - 5.0,
                    strokes: 0,
                    spans: 0,
                    pre_cut: None,
                });
            }
            let falls = vec![f64::INFINITY, 1.0 + rng.uniform() * 3.0];
            let seconds = rng.uniform() * 10.0;
            item.paths.push(SubPath {
                lead_in: None,
                ends: [own.entry, exit],
                strokes: Vec::new(),
                seconds,
                leave_points,
                falls,
            });
        }
    }
    for k in 0..problem.items.len() {
        problem.items[k].area = (rng.below(2) == 0).then_some(1);
    }
    problem
}

/// The graph with its near nodes.
fn graph(problem: &Problem) -> Graph<'_> {
    graph_of(problem, Neighbourhood::Near)
}

/// The graph in which moves lead this far.
fn graph_of(problem: &Problem, neighbourhood: Neighbourhood) -> Graph<'_> {
    let mut g = Graph::new(problem, neighbourhood);
    while g.list_near().is_some() {}
    g
}

/// A random tree: every contour in a random gap or at a random free node.
fn random_forest(g: &Graph, rng: &mut Rng) -> Forest {
    let mut forest = Forest::new(g);
    for (item, k) in (0..).zip(0..g.problem.items.len()) {
        let nodes = g.nodes(item);
        forest.enter(item, nodes.start + NodeId::try_from(rng.below(nodes.len())).unwrap());
        let other = u32::try_from(rng.below(k.max(1))).unwrap();
        let free: Vec<NodeId> = g.parent_nodes(other).filter(|&n| k > 0 && forest.is_free(g, n)).collect();
        if free.is_empty() || rng.below(2) == 0 {
            let (route, pos) =
                if k > 0 { (forest.route_of(other), forest.pos(other) + 1) } else { (ROOT, 0) };
            forest.splice(route, pos, vec![item]);
        } else {
            let route = forest.open(vec![item]);
            forest.hang(g, route, free[rng.below(free.len())]);
        }
    }
    assert!(forest.is_sound(g));
    forest
}

#[track_caller]
fn near(a: f64, b: f64) {
    assert!((a - b).abs() < 1e-9, "{a} is not {b}");
}
