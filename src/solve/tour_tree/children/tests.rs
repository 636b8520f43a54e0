//! The search over routes against brute force on small problems of every kind; gains, ranks and precedence are asserted
//! on every kick by the debug assertions of `mod.rs`.

#![expect(clippy::float_cmp, reason = "places of nodes are the same number, bit for bit, or not")]

use super::super::TourTree;
use super::super::tests::small;
use crate::geometry::DVec2;
use crate::machine::AirTime;
use crate::problem::{NodeId, Problem};
use crate::solve::Solver;

/// Begun and finished items, and the seconds so far.
#[derive(Clone)]
struct State {
    head: DVec2,
    spent: f64,
    begun: Vec<bool>,
    finished: Vec<bool>,
    /// Items left unfinished: where they were begun and where they were left.
    open: Vec<(usize, f64, f64)>,
}

/// Least seconds over all orders, entries, and places where items are left, visits nested.
fn brute(problem: &Problem) -> f64 {
    let n = problem.items.len();
    let (begun, finished) = (vec![false; n], vec![false; n]);
    let start = State { head: problem.home, spent: 0.0, begun, finished, open: Vec::new() };
    let mut least = f64::INFINITY;
    go(problem, &AirTime::new(&problem.machine), &start, &mut least);
    least
}

fn go(p: &Problem, air: &AirTime, s: &State, least: &mut f64) {
    if s.spent >= *least {
        return;
    }
    if s.finished.iter().all(|f| *f) {
        *least = least.min(s.spent + if p.closed { air.seconds(s.head, p.home) } else { 0.0 });
        return;
    }
    let unfinished = || (0..p.items.len()).filter(|&i| !s.finished[i]);
    let may_end = |i: usize| unfinished().all(|c| p.items[c].before != u32::try_from(i).ok());
    let nodes = |i: usize| p.items[i].nodes.clone().map(|n| (n, &p.nodes[n as usize]));
    let to = |s: &State, id: NodeId| {
        let node = p.nodes[id as usize];
        let seconds = air.seconds(s.head, node.entry) + p.items[node.item as usize].extra(id, node.along);
        State { head: node.exit, spent: s.spent + seconds, ..s.clone() }
    };
    let rank = unfinished().map(|i| p.items[i].rank).min();
    for i in unfinished().filter(|&i| !s.begun[i] && Some(p.items[i].rank) == rank) {
        for (id, node) in nodes(i) {
            let mut next = to(s, id);
            next.begun[i] = true;
            if may_end(i) {
                let mut whole = next.clone();
                whole.finished[i] = true;
                go(p, air, &whole, least);
            }
            for (_, until) in nodes(i).filter(|(_, u)| p.items[i].leave.is_some() && u.along != node.along) {
                let mut left = next.clone();
                left.head = until.entry;
                left.open.push((i, node.along, until.along));
                go(p, air, &left, least);
            }
        }
    }
    if let Some(&(i, start, left)) = s.open.last() {
        let (id, _) = nodes(i).find(|(_, n)| n.along == left).unwrap();
        let mut next = to(s, id);
        next.spent += p.items[i].resume();
        next.open.pop();
        for (_, until) in nodes(i) {
            let mut next = next.clone();
            next.head = until.entry;
            if until.along == start && may_end(i) {
                next.finished[i] = true;
                go(p, air, &next, least);
            } else if until.along != start && (until.along < start, until.along) > (left < start, left) {
                next.open.push((i, start, until.along));
                go(p, air, &next, least);
            }
        }
    }
}

#[test]
fn reaches_the_optimum_of_small_problems_with_items_left_unfinished() {
    let mut left = 0;
    for (machine, charge) in
        [("length", 0.0), ("length", 40.0), ("length-chebyshev", 5.0), ("co2-100w", 0.01)]
    {
        for seed in 0..30 {
            let mut problem = small(seed, 2 + u32::try_from(seed % 4).unwrap(), machine, seed % 3 > 0);
            let Problem { items, nodes, .. } = &mut problem;
            for item in items {
                let ends = nodes[item.nodes.start as usize];
                item.leave = (ends.entry == ends.exit && item.rank == 0).then_some(charge);
            }
            let mut search = TourTree.start(&problem, seed, None);
            search.step(200_000);
            let (found, least) = (search.best().cost, brute(&problem));
            assert!(found <= least + 1e-9, "{machine} {charge} {seed}: {found} is not {least}");
            assert!(found >= least - 1e-9, "{machine} {charge} {seed}: {found} is below the optimum {least}");
            left += usize::from(search.best().stops.len() > problem.items.len());
        }
    }
    assert!(left > 15, "only in {left} problems was anything left unfinished");
}
