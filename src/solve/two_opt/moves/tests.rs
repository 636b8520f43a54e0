//! Every move gains exactly what its price says, on closed and open tours of closed and open contours.

use super::*;
use crate::geometry::DVec2;
use crate::machine::presets;
use crate::problem::{Item, Node, Problem};
use rand::{RngExt, SeedableRng};
use rand_xoshiro::Xoshiro256PlusPlus;

/// Contours at random places: closed ones with one to five nodes, open ones; some inside others, two ranks.
fn random_problem(rng: &mut Xoshiro256PlusPlus, count: u32) -> Problem {
    let mut place = || DVec2::new(rng.random_range(0.0..100.0), rng.random_range(0.0..100.0));
    let (mut items, mut nodes) = (Vec::new(), Vec::<Node>::new());
    let id = |nodes: &[Node]| NodeId::try_from(nodes.len()).unwrap();
    for item in 0..count {
        let (first, at) = (id(&nodes), place());
        let node = |entry, exit, twin| Node { item, entry, exit, along: 0.0, reversed: false, twin };
        if item % 3 == 0 {
            let other = place();
            nodes.extend([node(at, other, first + 1), node(other, at, first)]);
        } else {
            for k in 0..=item % 5 {
                let corner = at + 0.15 * place();
                nodes.push(node(corner, corner, first + k));
            }
        }
        items.push(Item { nodes: first..id(&nodes), before: None, rank: item % 2, fixed: 0.0, track: None });
    }
    for item in 0..count as usize {
        let outer = item + 2 * (1 + item % 4);
        if item % 4 != 0 && outer < items.len() {
            items[item].before = u32::try_from(outer).ok();
        }
    }
    let machine = presets().swap_remove(rng.random_range(0..presets().len()));
    Problem { items, nodes, home: DVec2::new(-5.0, 3.0), closed: rng.random(), machine }
}

/// Ranks in order and, when asked, inner items before outer ones; each item once.
fn is_feasible(problem: &Problem, nodes: &[NodeId], nested: bool) -> bool {
    let items: Vec<usize> = nodes.iter().map(|&n| problem.nodes[n as usize].item as usize).collect();
    let mut at = vec![usize::MAX; problem.items.len()];
    for (k, &i) in items.iter().enumerate() {
        at[i] = k;
    }
    let once = at.iter().all(|&k| k != usize::MAX) && items.len() == at.len();
    let ranks = items.windows(2).all(|w| problem.items[w[0]].rank <= problem.items[w[1]].rank);
    let outer = |i: usize| problem.items[i].before.map_or(usize::MAX, |o| at[o as usize]);
    once && ranks && (!nested || (0..at.len()).all(|i| at[i] < outer(i)))
}

#[test]
fn gains_are_what_they_say_and_undo_takes_all_back() {
    let mut rng = Xoshiro256PlusPlus::seed_from_u64(11);
    let mut moves = 0;
    for round in 0..300 {
        let count = rng.random_range(1..40);
        let problem = random_problem(&mut rng, count);
        let mut order: Vec<NodeId> =
            problem.items.iter().map(|i| rng.random_range(i.nodes.clone())).collect();
        // By rank, otherwise as numbered: inner before outer.
        order.sort_by_key(|&n| problem.items[problem.nodes[n as usize].item as usize].rank);
        let mut tour = Tour::new(&problem, &order);
        tour.nested = round % 2 == 0;
        let mut lists = Neighbours::new(&problem);
        let (mut priced, mut touched) = (0, Vec::new());
        for k in 0..200 {
            let before = tour.solution();
            let Some(gain) = best_move(&mut tour, &mut lists, k % count, &mut priced) else { continue };
            gain.apply(&mut tour, &mut touched);
            let after = tour.solution();
            assert!((before.cost - after.cost - gain.seconds).abs() < 1e-9, "{gain:?}");
            assert!(is_feasible(&problem, tour.nodes(), tour.nested), "{gain:?}");
            for (p, &node) in (1..).zip(tour.nodes()) {
                assert_eq!(tour.position_of(node), p);
            }
            moves += 1;
        }
        tour.undo();
        assert_eq!(tour.nodes(), order);
    }
    assert!(moves > 3000, "{moves}");
}
