//! Tours of one length take no stretch over from each other.

use super::super::queue::Queue;
use super::super::snapshot::TourSnapshot;
use super::super::space::Space;
use super::super::tour::Tour;
use super::recombine;
use crate::geometry::{DVec2, math};
use crate::machine;
use crate::problem::{Item, Node, Problem};
use crate::solve::rng::{Draw, seeded};

const COUNT: u32 = 800;

/// Points around a circle, which the tour through them in their order cannot visit on a shorter way; so wide that sums of legs are
/// rounded by more than the least gain.
fn around() -> Problem {
    let mut rng = seeded(1);
    let mut place = |k: u32| {
        let angle = std::f64::consts::TAU * (f64::from(k) + 0.5 * rng.uniform()) / f64::from(COUNT + 1);
        1e9 * DVec2::new(math::cos(angle), math::sin(angle))
    };
    let node =
        |item: u32, entry: DVec2| Node { item, entry, exit: entry, along: 0.0, reversed: false, twin: item };
    let nodes = (0..COUNT).map(|item| node(item, place(item))).collect();
    let items = (0..COUNT).map(|item| Item { nodes: item..item + 1, ..Item::default() }).collect();
    let machine = machine::preset("length").unwrap();
    Problem { items, nodes, home: place(COUNT), closed: true, ..Problem::empty(machine) }
}

/// What a tour through all points in their order gains from another one.
fn gain(problem: &Problem, other: &[u32]) -> f64 {
    let snapshot = |items: &[u32]| {
        let space = Space::new(problem);
        TourSnapshot { order: [&[space.home], items].concat(), at: vec![0; problem.items.len() + 1] }
    };
    let inner: Vec<u32> = (0..).take(problem.items.len()).collect();
    let mut tour = Tour::new(Space::new(problem), snapshot(&inner));
    let mut queue = Queue::new(problem.items.len() + 1);
    recombine(&mut tour, &mut queue, &snapshot(other))
}

/// On 17180pla85900 the search took rounding for a gain, and recombined the same two tours for ever.
#[test]
fn sums_that_differ_by_rounding_are_no_gain() {
    let problem = around();
    // The same tour the other way: every stretch has the same legs, but sums up to it are rounded otherwise.
    let back: Vec<u32> = (0..COUNT).rev().collect();
    let gained = gain(&problem, &back);
    assert!(gained <= 0.0, "a tour gained {gained} from itself");
}

#[test]
fn a_shorter_stretch_is_a_gain_where_sums_are_as_long() {
    let mut problem = around();
    // Three points in a row, of which the tour visits the second one first: 2 mm longer than need be.
    let first = problem.nodes[400].entry;
    for (item, x) in [(401, 2.0), (402, 1.0), (403, 3.0)] {
        let at = first + DVec2::new(x, 0.0);
        problem.nodes[item].entry = at;
        problem.nodes[item].exit = at;
    }
    let mut order: Vec<u32> = (0..COUNT).collect();
    order.swap(401, 402);
    let gained = gain(&problem, &order);
    assert!((gained - 2.0).abs() < 1e-3, "{gained}");
}
