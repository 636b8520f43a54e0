//! Paths from outside, accepted and refused.

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
