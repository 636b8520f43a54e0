//! Charges and cuts against exact optima of small problems.

use super::excess::legs;
use super::{Strong, Task};
use crate::geometry::DVec2;
use crate::machine::{Profile, preset};
use crate::plan::lower_bound::walks::Pass;
use crate::problem::{Item, Node, NodeId, Problem};
use rand::{RngExt, SeedableRng};
use rand_xoshiro::Xoshiro256PlusPlus;
use std::collections::BTreeMap;

/// Contours of two points each, at these places.
fn at(places: &[DVec2], closed: bool) -> Problem {
    let machine = Profile { return_home: closed, ..preset("length").unwrap() };
    let nodes = (0..).zip(places.iter().flat_map(|&p| [p, p + DVec2::new(9.0, 4.0)]));
    let nodes = nodes.map(|(twin, entry): (NodeId, _)| Node {
        item: twin / 2,
        entry,
        exit: entry,
        along: 0.0,
        reversed: false,
        twin,
    });
    let nodes: Vec<Node> = nodes.collect();
    let items = (0..NodeId::try_from(nodes.len()).unwrap())
        .step_by(2)
        .map(|n| Item { nodes: n..n + 2, ..Item::default() });
    Problem { items: items.collect(), nodes, closed, ..Problem::empty(machine) }
}

/// What walks prove with these charges and prices, which follow each other, and these cuts.
fn value(problem: &Problem, values: &[f64], cuts: &[Vec<bool>]) -> f64 {
    let mut strong = Strong::new(problem);
    while strong.task != Task::Row(0) {
        strong.once(f64::MAX);
    }
    cuts.iter().for_each(|cut| strong.charges.add(cut.clone()));
    strong.charges.set(values);
    let mut passes = <[Pass; 2]>::default();
    for (side, pass) in passes.iter_mut().enumerate().take(strong.ground.spaces.len()) {
        while pass.rows() < strong.ground.stops()[side] {
            strong.ground.advance(side, pass, &strong.charges);
        }
    }
    strong.ground.meet(&passes, &strong.charges)[0].value - strong.charges.back()
}

#[test]
fn no_charges_and_cuts_prove_more_than_the_optimum() {
    let mut rng = Xoshiro256PlusPlus::seed_from_u64(7);
    let mut changed = 0;
    for k in 0..300 {
        let count = 4 + k % 5;
        let mut place = || DVec2::new(rng.random_range(0.0..900.0), rng.random_range(0.0..600.0));
        let places: Vec<DVec2> = (0..count).map(|_| place()).collect();
        let problem = at(&places, k % 2 == 0);
        let homes = if problem.closed { 1 } else { 2 };
        let least = crate::solve::exact(&problem).unwrap().cost;
        let charges: Vec<f64> = (0..homes + count)
            .map(|i| if i < homes { 0.0 } else { rng.random_range(-200.0..200.0) })
            .collect();
        // Any sets, but not empty ones: those no tour comes to.
        let mut set = |k: usize| -> Vec<bool> {
            (0..homes + count).map(|i| i >= homes && (i == homes + k || rng.random_bool(0.5))).collect()
        };
        let cuts: Vec<Vec<bool>> = (0..3).map(&mut set).collect();
        let prices: Vec<f64> = cuts.iter().map(|_| rng.random_range(0.0..100.0)).collect();
        let with = value(&problem, &[charges.clone(), prices].concat(), &cuts);
        assert!(with <= least + 1e-6, "{k}: {with} above {least}");
        let without = value(&problem, &charges, &[]);
        assert!(without <= least + 1e-6, "{k}: {without} above {least}");
        changed += usize::from((with - without).abs() > 1.0);
    }
    assert!(changed > 200, "cuts made a difference in {changed} of 300 cases only");
}

/// Walks that never go to the far contours cost twice the price of the cut around them.
#[test]
fn a_cut_brings_walks_to_far_contours() {
    let places: Vec<DVec2> =
        (0..12).map(|i| DVec2::new(f64::from(20 * i) + if i < 6 { 0.0 } else { 880.0 }, 0.0)).collect();
    let problem = at(&places, true);
    let none = [0.0; 13];
    let without = value(&problem, &none, &[]);
    let far: Vec<bool> = (0..13).map(|i| i > 6).collect();
    let with = value(&problem, &[none.as_slice(), &[400.0]].concat(), &[far]);
    assert!(without < 700.0 && with > without + 799.0, "{without}, then {with}");
}

/// Legs between far items have no table at first, so that walks leap: they arrive at one place and leave from another.
#[test]
fn far_items_between_which_walks_go_get_tables() {
    let mut rng = Xoshiro256PlusPlus::seed_from_u64(3);
    let mut place = || DVec2::new(rng.random_range(0.0..2000.0), rng.random_range(0.0..2000.0));
    let places: Vec<DVec2> = (0..80).map(|_| place()).collect();
    let problem = at(&places, true);
    let mut strong = Strong::new(&problem);
    while strong.task != Task::Row(0) {
        strong.once(20_000.0);
    }
    let before = strong.wanted.len();
    while strong.walks.is_empty() || strong.task != Task::Row(0) {
        strong.once(20_000.0);
    }
    let more = strong.wanted.len() - before;
    assert!((1..40).contains(&more), "{more} tables more");
    let mut far: BTreeMap<[usize; 2], f64> = BTreeMap::new();
    for (weight, walk) in &strong.walks {
        for [a, b] in legs(walk, &strong.ground).into_iter().map(|leg| leg.map(|v| v.item)) {
            if strong.ground.pair(a, b).is_none() {
                *far.entry([a.min(b), a.max(b)]).or_default() += weight;
            }
        }
    }
    assert!(far.values().all(|&uses| uses <= 0.05), "{far:?}");
}
