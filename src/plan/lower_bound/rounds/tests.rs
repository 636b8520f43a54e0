//! Charges and cuts against exact optima of small problems.

use super::excess::legs;
use super::{Strong, Task};
use crate::geometry::{Arc, DVec2, Path, Segment};
use crate::machine::{AirTime, Lift, Profile, preset};
use crate::plan::lower_bound::level::level;
use crate::plan::lower_bound::walks::{Pass, Visit};
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

/// Circles that are entered anywhere.
fn circles(places: &[(f64, f64)], machine: &str) -> Problem {
    let of = |&(x, y): &(f64, f64)| {
        let center = DVec2::new(x, y);
        let ends = [center + DVec2::X * 9.0, center - DVec2::X * 9.0];
        let half = |k: usize| Segment::Arc(Arc::new(ends[k], ends[1 - k], center, true));
        Path::new(vec![half(0), half(1)], true)
    };
    let tracks: Vec<Path> = places.iter().map(of).collect();
    let machine = preset(machine).unwrap();
    let mut problem = at(&places.iter().map(|&(x, y)| DVec2::new(x + 9.0, y)).collect::<Vec<_>>(), true);
    for (k, track) in tracks.into_iter().enumerate() {
        let length = track.length();
        for (node, share) in problem.nodes[2 * k..2 * k + 2].iter_mut().zip([0.0, 0.5]) {
            node.along = share * length;
            node.entry = track.at(node.along).unwrap();
            node.exit = node.entry;
        }
        problem.items[k].track = Some(track);
    }
    Problem { machine, ..problem }
}

/// The best entries of three circles in a given order, against a grid of all of them.
#[test]
fn the_best_entries_of_an_order_are_found() {
    let mut balanced = 0;
    for machine in ["co2-100w", "fibre-3kw-thin", "length-chebyshev"] {
        let problem = circles(&[(60.0, 41.0), (92.0, 72.0), (125.0, 45.0)], machine);
        let strong = Strong::new(&problem);
        let walk: Vec<Visit> = (1..4).map(|item| Visit { item, knot: 0 }).collect();
        let level = level(&strong.ground, &walk).unwrap();
        let air = AirTime::new(&problem.machine);
        let places = |k: usize| {
            let track = problem.items[k].track.clone().unwrap();
            (0..400)
                .map(move |s| track.at(track.length() * f64::from(s) / 400.0).unwrap())
                .collect::<Vec<_>>()
        };
        // The least seconds up to each place of a circle.
        let mut reached = vec![(problem.home, 0.0)];
        for k in 0..3 {
            let to = |place: DVec2| {
                let all = reached.iter().map(|&(from, seconds)| seconds + air.seconds(from, place));
                (place, all.fold(f64::INFINITY, f64::min))
            };
            reached = places(k).into_iter().map(to).collect();
        }
        let home = reached.iter().map(|&(from, seconds)| seconds + air.seconds(from, problem.home));
        let least = home.fold(f64::INFINITY, f64::min);
        assert!(
            level.seconds <= least && level.seconds > least * (1.0 - 1e-3),
            "{machine}: {} of {least}",
            level.seconds
        );
        let list = level.mixtures.list();
        assert_eq!(list.len(), 4, "a mixture for each leg");
        let mixed =
            list.iter().filter(|l| (1..1 << 20).contains(&l.speed) || (1..1 << 20).contains(&l.ramps));
        balanced += mixed.count();
    }
    assert!(balanced >= 2, "{balanced}");
}

/// Between two pieces the seconds are nowhere below the numbers at their ends, whatever the mixture is.
#[test]
fn no_function_is_above_the_seconds() {
    let mut rng = Xoshiro256PlusPlus::seed_from_u64(3);
    let mut lifted = preset("co2-100w").unwrap();
    lifted.levers.lift = Some(Lift { height: 5.0, stay_down: 20.0, at_rest: true });
    lifted.z_speed = Some(40.0);
    for machine in [preset("co2-100w").unwrap(), preset("fibre-3kw-thin").unwrap(), lifted] {
        for _ in 0..300 {
            let mut place = || (rng.random_range(0.0..90.0), rng.random_range(0.0..60.0));
            let problem = Problem { machine: machine.clone(), ..circles(&[place(), place()], "co2-100w") };
            let mut strong = Strong::new(&problem);
            for item in &mut strong.ground.items[1..] {
                for _ in 0..rng.random_range(0..4) {
                    *item = item.halved(&vec![true; item.pieces.len()]).unwrap();
                }
            }
            let [p, q] = [1, 2].map(|k| {
                let item = &strong.ground.items[k];
                let piece = rng.random_range(0..item.pieces.len());
                let along = item.pieces[piece].knots.map(|knot| item.along[knot]);
                let lap = if along[1] <= along[0] { item.track().unwrap().length() } else { 0.0 };
                (k, piece, [along[0], along[1] + lap])
            });
            let pieces = [&p, &q].map(|(k, piece, _)| &strong.ground.items[*k].pieces[*piece]);
            let mixture = [rng.random_range(0.0..=1.0), rng.random_range(0.0..=1.0)];
            let minorant = &strong.ground.prices.minorant;
            for given in [None, Some(mixture)] {
                let corners = minorant.corners(pieces[0], pieces[1], given);
                for _ in 0..20 {
                    let shares: [f64; 2] = [rng.random_range(0.0..=1.0), rng.random_range(0.0..=1.0)];
                    let at = |(k, _, along): &(usize, usize, [f64; 2]), share: f64| {
                        let track = strong.ground.items[*k].track().unwrap();
                        let s = along[0] + share * (along[1] - along[0]);
                        track.at(s - if s > track.length() { track.length() } else { 0.0 })
                    };
                    let real = minorant.air().seconds(at(&p, shares[0]), at(&q, shares[1]));
                    let weight = |end: usize, share: f64| if end == 0 { 1.0 - share } else { share };
                    let below: f64 = [0, 1]
                        .into_iter()
                        .flat_map(|i| {
                            [0, 1].map(|j| weight(i, shares[0]) * weight(j, shares[1]) * corners[i][j])
                        })
                        .sum();
                    assert!(below <= real + 1e-12, "{}: {below} above {real}, {given:?}", machine.name);
                }
            }
        }
    }
}
