//! What the search finds where moves avoid tipped pieces.

use super::{all_tip, ignored, tipping};
use crate::testkit::searches::{searched, slices_of_any_size_find_the_same};
use crate::testkit::sheets::{Builder, XorShift, circle, nested_sheet, p, rectangle};
use kerfway::job::problem_of;
use kerfway::machine::{Levers, Profile, Tips};
use kerfway::plan::{self, Move, Plan, Way};
use kerfway::problem::{Item, NodeId, Problem, Start};
use kerfway::sheet::{Pin, Sheet};
use kerfway::tipping::Piece;

/// The seconds of the best order and entries at nodes, over every order, with the entries of each order by dynamic programming.
pub(super) fn every_order(problem: &Problem) -> f64 {
    every_order_of(problem, |_, _| true)
}

/// The same over the orders in which each item may come after those before it.
pub(crate) fn every_order_of(problem: &Problem, may: impl Fn(&[u32], u32) -> bool) -> f64 {
    let items: Vec<u32> =
        (0..).zip(&problem.items).filter(|(_, i)| !i.nodes.is_empty()).map(|(id, _)| id).collect();
    let mut least = f64::INFINITY;
    let mut order = Vec::new();
    permute(problem, &items, &may, &mut order, &mut |order| least = least.min(entries(problem, order)));
    least
}

fn permute(
    problem: &Problem,
    items: &[u32],
    may: &impl Fn(&[u32], u32) -> bool,
    order: &mut Vec<u32>,
    each: &mut impl FnMut(&[u32]),
) {
    if order.len() == items.len() {
        return each(order);
    }
    for &next in items {
        let known = &problem.items[next as usize];
        let waits = |&o: &u32| {
            let other: &Item = &problem.items[o as usize];
            !order.contains(&o) && (other.before == Some(next) || other.rank < known.rank)
        };
        if order.contains(&next) || items.iter().any(waits) || !may(order, next) {
            continue;
        }
        order.push(next);
        permute(problem, items, may, order, each);
        order.pop();
    }
}

fn entries(problem: &Problem, order: &[u32]) -> f64 {
    let zones = problem.zones.as_ref().unwrap();
    let free = |k: usize| move |piece: &Piece| piece.cut_by.iter().all(|c| order[..k].contains(c));
    let leg = |from, to, k: usize| zones.leg(from, to, free(k)).seconds;
    let passes = |from, to, k: usize| zones.is_near(from, &free(k)) || zones.crosses(from, to, free(k));
    // What chains and starts on kerfs take that are there by then.
    let joined = |before: Option<NodeId>, from, node: NodeId, entry, k: usize| {
        let link =
            before.and_then(|b| problem.links.between(b, node)).map_or(f64::INFINITY, |link| {
                match link.via {
                    None if zones.crosses(from, entry, free(k)) => f64::INFINITY,
                    None => link.seconds,
                    Some(via) if passes(via, entry, k) => f64::INFINITY,
                    Some(via) => link.seconds + leg(from, via, k) - zones.least(from, via),
                }
            });
        let there = |s: &&Start| s.kerf.is_none_or(|kerf| order[..k].contains(&kerf));
        let starts = problem.starts.of(node).iter().filter(there);
        let starts = starts.filter(|s| s.from == entry || !passes(s.from, entry, k));
        starts.map(|s| leg(from, s.from, k) + s.seconds).fold(link, f64::min)
    };
    let mut so_far: Vec<(f64, Option<NodeId>)> = vec![(0.0, None)];
    for (k, &item) in order.iter().enumerate() {
        let known = &problem.items[item as usize];
        let reach = |node: NodeId| {
            let n = &problem.nodes[node as usize];
            let from =
                |before: Option<NodeId>| before.map_or(problem.home, |b| problem.nodes[b as usize].exit);
            let way = |b| leg(from(b), n.entry, k).min(joined(b, from(b), node, n.entry, k));
            let least = so_far.iter().map(|(s, b)| s + way(*b)).fold(f64::INFINITY, f64::min);
            (least + known.extra(node, n.along), Some(node))
        };
        so_far = known.nodes.clone().map(reach).collect();
    }
    let home = |(seconds, node): &(f64, Option<NodeId>)| {
        let exit = problem.nodes[node.unwrap() as usize].exit;
        seconds + if problem.closed { leg(exit, problem.home, order.len()) } else { 0.0 }
    };
    so_far.iter().map(home).fold(f64::INFINITY, f64::min)
}

/// A row of four contours close together, and up to two more: the second is cut first and the third last, so the head has to get
/// past the second, which has tipped, from the first to the fourth or back.
fn crowded(seed: u32) -> Sheet {
    let mut rng = XorShift::new(seed.into());
    let mut b = Builder::new();
    for k in 0..4 {
        let at = p(60.0 + 48.0 * f64::from(k), 40.0);
        let size = p(rng.between(24.0, 44.0), rng.between(24.0, 44.0));
        match rng.below(3) {
            0 => b.cut(circle(at + size / 2.0, size.x / 2.0), None),
            _ => b.cut(rectangle(at, size), None),
        };
    }
    b.sheet.contours[1].pin = Pin::First;
    b.sheet.contours[2].pin = Pin::Last;
    for k in 0..seed % 3 {
        let at = p(rng.between(60.0, 240.0), 100.0 + 40.0 * f64::from(k));
        b.cut(rectangle(at, p(20.0, 20.0)), None);
    }
    b.sheet
}

#[test]
fn up_to_six_contours_are_as_good_as_every_order_and_entry() {
    let mut bent = 0;
    let mut tried = 0;
    for seed in 0..30_u32 {
        let sheet = crowded(seed);
        let machine = tipping([0.05, 0.4, 3.0][seed as usize % 3], all_tip());
        let problem = problem_of(&sheet, &machine);
        tried += 1;
        let least = every_order(&problem);
        let (found, plan) = searched(&sheet, &machine, 200_000, 1);
        assert!(found.cost <= least + 1e-9, "seed {seed}: {} s, not {least} s", found.cost);
        // Entries off their nodes save little.
        assert!(found.cost >= 0.5 * least, "seed {seed}: {} s, {least} s", found.cost);
        assert_eq!(plan.summary.crossings, 0);
        bent += plan.summary.lifts + plan.summary.detours;
        // What the search minimises is what the plan says.
        let fixed: f64 = problem.items.iter().map(|i| i.fixed).sum();
        let total = plan.summary.total_time;
        assert!(
            (total - fixed - found.cost).abs() < 1e-6,
            "seed {seed}: {total} s, {} s",
            fixed + found.cost
        );
    }
    assert!(tried >= 12 && bent > 10, "{tried} sheets, {bent} moves with something in the way");
}

#[test]
fn avoiding_is_never_slower_than_lifting_always_and_never_faster_than_ignoring() {
    for seed in 0..4 {
        let sheet = nested_sheet(40, seed);
        let machine = tipping(0.2, all_tip());
        let (_, avoid) = searched(&sheet, &machine, 300_000, seed);
        let ignore = tipping(0.2, ignored(all_tip()));
        let down = Profile { levers: Levers { lift: None, ..ignore.levers }, ..ignore.clone() };
        let lifting = Profile { levers: Levers { tips: None, ..machine.levers }, ..machine.clone() };
        // The same search without knowing of tips, and then every move lifted.
        let (path, straight) = searched(&sheet, &down, 300_000, seed);
        let lifted = plan::from_solution(&sheet, &problem_of(&sheet, &lifting), &path);
        let total = |plan: &Plan| plan.summary.total_time;
        assert!(total(&avoid) < total(&lifted), "{} s, {} s", total(&avoid), total(&lifted));
        assert!(total(&avoid) > total(&straight) - 1e-6);
        assert!(straight.summary.crossings > 0 && avoid.summary.crossings == 0);
        // The same path, made safe afterwards, is no better than what the search found knowing it.
        let after = plan::from_solution(&sheet, &problem_of(&sheet, &machine), &path);
        assert_eq!(plan::check(&sheet, &machine, &after), Ok(()));
        assert!(total(&avoid) <= total(&after) + 1e-9, "{} s, {} s", total(&avoid), total(&after));
    }
}

#[test]
fn slices_of_any_size_give_the_same_plan() {
    let sheet = nested_sheet(30, 5);
    slices_of_any_size_find_the_same(&problem_of(&sheet, &tipping(0.3, all_tip())));
}

#[test]
fn tips_that_are_ignored_change_nothing_but_what_is_said() {
    let sheet = nested_sheet(30, 2);
    let known = tipping(0.2, ignored(all_tip()));
    let down = Profile { levers: Levers { lift: None, ..known.levers }, ..known.clone() };
    let none = Profile { levers: Levers { tips: None, ..down.levers }, ..down.clone() };
    let ((path, plan), (same, plain)) =
        (searched(&sheet, &down, 50_000, 3), searched(&sheet, &none, 50_000, 3));
    assert_eq!(path, same);
    let crosses = |m: &&Move| matches!(m, Move::Air { way: Way::Crosses, .. });
    let marked = plan.moves.iter().filter(crosses).count();
    assert!(marked > 0 && plan.summary.crossings as usize == marked);
    let unmarked: Vec<Move> = plan
        .moves
        .into_iter()
        .map(|m| if let Move::Air { to, .. } = m { Move::air(to) } else { m })
        .collect();
    assert_eq!(unmarked, plain.moves);
    // With the head lifted for every move, none is risky.
    let (_, lifted) = searched(&sheet, &known, 50_000, 3);
    assert_eq!(lifted.summary.crossings, 0);
    assert!(Tips::default().avoids());
}
