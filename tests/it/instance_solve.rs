//! The search on instances given by tables: against brute force on small ones of every kind, the same in slices of any
//! size, and never behind its start.
#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]
#![allow(clippy::float_cmp, reason = "costs are whole numbers")]

use kerfway::problem::{Instance, Problem, check, instance};
use kerfway::solve::{self, Solution};
use std::fmt::Write;

/// A linear congruential generator: numbers that look random, the same ones every time.
struct Lcg(u64);

impl Lcg {
    fn below(&mut self, n: u64) -> u64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 33) % n
    }
}

/// A PCGLNS file: sets of 1 to 3 nodes (all of one, sometimes), some in a given order, costs in the plane or any.
fn random(seed: u64, sets: u64) -> String {
    let mut rng = Lcg(seed);
    let most = if seed.is_multiple_of(5) { 1 } else { 3 };
    let sizes: Vec<u64> = (0..sets).map(|_| 1 + rng.below(most)).collect();
    let nodes: u64 = sizes.iter().sum();
    let symmetric = seed.is_multiple_of(2);
    let places: Vec<[u64; 2]> = (0..nodes).map(|_| [rng.below(100), rng.below(100)]).collect();
    let mut text = format!("NAME : r\nTYPE : PCGLNS\nDIMENSION : {nodes}\nGTSP_SETS : {sets}\n");
    text += "EDGE_WEIGHT_TYPE : EXPLICIT\nEDGE_WEIGHT_FORMAT : FULL_MATRIX\nEDGE_WEIGHT_SECTION\n";
    for a in &places {
        for b in &places {
            let plane = a[0].abs_diff(b[0]) + a[1].abs_diff(b[1]);
            write!(text, "{} ", if symmetric { plane } else { plane / 2 + rng.below(60) }).unwrap();
        }
        text.push('\n');
    }
    text += "GTSP_SET_SECTION\n";
    let mut node = 0;
    for (set, size) in (1..).zip(&sizes) {
        let members: Vec<String> = (node + 1..=node + size).map(|n| n.to_string()).collect();
        writeln!(text, "{set} {} -1", members.join(" ")).unwrap();
        node += size;
    }
    let start = 1 + rng.below(sets);
    text += "GTSP_SET_ORDERING\n";
    for first in 1..=sets {
        for then in first + 1..=sets {
            if !seed.is_multiple_of(3) && then != start && rng.below(3) == 0 {
                writeln!(text, "{first} {then} -1").unwrap();
            }
        }
    }
    writeln!(text, "START_GROUP_SECTION\n{start}\nEOF").unwrap();
    text
}

/// Least cost over all allowed orders and nodes.
fn brute(p: &Problem) -> f64 {
    fn go(p: &Problem, tour: &mut Vec<u32>, spent: f64, least: &mut f64) {
        let table = p.table.as_ref().unwrap();
        let visited = |tour: &[u32], item: u32| tour.iter().any(|&n| p.nodes[n as usize].item == item);
        if spent >= *least {
            return;
        }
        if tour.len() == p.items.len() {
            *least = least.min(spent + table.cost(tour[tour.len() - 1], tour[0]));
            return;
        }
        for (item, id) in p.items.iter().zip(0..) {
            let waits = p.pairs.iter().any(|&(a, b)| b == id && !visited(tour, a));
            if waits || visited(tour, id) {
                continue;
            }
            for node in item.nodes.clone() {
                let way = table.cost(tour[tour.len() - 1], node);
                tour.push(node);
                go(p, tour, spent + way, least);
                tour.pop();
            }
        }
    }
    let mut least = f64::INFINITY;
    for node in p.items.last().unwrap().nodes.clone() {
        go(p, &mut vec![node], 0.0, &mut least);
    }
    least
}

fn checked(instance: &Instance, solution: &Solution) -> f64 {
    let length = check(instance, &instance.tour(solution.stops.iter().map(|s| s.node))).unwrap();
    assert!((length - solution.cost).abs() < 1e-6, "{length} is not {}", solution.cost);
    length
}

#[test]
fn reaches_the_optimum_of_small_instances_of_every_kind() {
    for seed in 0..120 {
        let instance = instance(random(seed, 1 + seed % 7).as_bytes()).unwrap();
        let mut search = solve::methods()[0].start(&instance.problem, seed, None);
        search.step(60_000);
        assert_eq!(checked(&instance, search.best()), brute(&instance.problem), "seed {seed}");
    }
}

#[test]
fn tours_of_larger_instances_stay_valid_and_never_get_worse() {
    for seed in 0..6 {
        let instance = instance(random(seed, 40).as_bytes()).unwrap();
        for method in solve::methods() {
            let mut search = method.start(&instance.problem, seed, None);
            let mut last = checked(&instance, search.best());
            for _ in 0..40 {
                search.step(5_000);
                let now = checked(&instance, search.best());
                assert!(now <= last);
                last = now;
            }
        }
    }
}

#[test]
fn slices_of_any_size_give_the_same_tour() {
    let instance = instance(random(8, 30).as_bytes()).unwrap();
    let run = |slice: u64| {
        let mut search = solve::methods()[0].start(&instance.problem, 3, None);
        let mut left = 300_000;
        while left > 0 {
            left -= search.step(slice.min(left)).done;
        }
        search.best().clone()
    };
    let whole = run(300_000);
    for slice in [999, 20_011] {
        assert_eq!(run(slice), whole);
    }
}
