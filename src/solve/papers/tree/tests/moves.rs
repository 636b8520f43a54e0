//! Repartitioning: every move saves what it claims, each kind is checked by hand, and precedence is kept.

use super::super::forest::{Forest, ROOT};
use super::super::graph::{Graph, Neighbourhood};
use super::super::moves::{GainfulMoves, Reattach, TreeMove};
use super::super::repartition::{RepartitionMoves, improve};
use super::super::visits::{keeps_precedence, solution};
use super::super::{
    connect::Connections, edmonds::arborescence, entries, partitions, repair::repair, resolve::resolve,
    sequences,
};
use super::{PRE_CUT, graph, graph_of, near, random, random_forest, sheet, with_groups};
use crate::problem::NodeId;
use crate::solve::rng::seeded;
use std::mem::discriminant;

fn found(g: &Graph, forest: &Forest) -> Vec<(f64, TreeMove)> {
    found_by(Reattach::Reopened, g, forest)
}

fn found_by(reattach: Reattach, g: &Graph, forest: &Forest) -> Vec<(f64, TreeMove)> {
    let mut found = GainfulMoves { reattach, ..GainfulMoves::default() };
    for item in (0..).take(g.problem.items.len()) {
        partitions::look(g, forest, item, &mut found);
        sequences::look(g, forest, item, &mut found);
    }
    found.moves
}

#[test]
fn every_move_gains_what_it_says_and_leaves_a_tree() {
    let mut rng = seeded(3);
    let mut kinds = Vec::new();
    for round in 0..60 {
        let problem = random(3 + round % 9, 2 + round % 3, &mut rng);
        let g = graph(&problem);
        let forest = random_forest(&g, &mut rng);
        for (gain, change) in found(&g, &forest) {
            let mut next = forest.clone();
            change.apply(&g, &mut next);
            assert!(next.is_sound(&g), "{change:?}");
            near(forest.seconds(&g) - next.seconds(&g), gain);
            near(solution(&g, &next).cost, next.seconds(&g));
            let kind = discriminant(&change);
            if !kinds.contains(&kind) {
                kinds.push(kind);
            }
        }
    }
    assert_eq!(kinds.len(), 4, "all kinds of moves were tried");
}

#[test]
fn among_all_nodes_moves_gain_what_they_say_and_the_best_is_never_worse() {
    let mut rng = seeded(11);
    let (mut few, mut many) = (0, 0);
    for round in 0..30 {
        let problem = random(8 + round % 9, 2 + round % 3, &mut rng);
        let (g, everywhere) = (graph(&problem), graph_of(&problem, Neighbourhood::All));
        let forest = random_forest(&g, &mut rng);
        let best = |moves: &[(f64, TreeMove)]| moves.iter().fold(0.0, |best: f64, m| best.max(m.0));
        let (limited, all) = (found(&g, &forest), found(&everywhere, &forest));
        assert!(best(&all) >= best(&limited) - 1e-9, "{} {}", best(&all), best(&limited));
        for (gain, change) in &all {
            let mut next = forest.clone();
            change.apply(&everywhere, &mut next);
            assert!(next.is_sound(&everywhere), "{change:?}");
            near(forest.seconds(&everywhere) - next.seconds(&everywhere), *gain);
        }
        few += limited.len();
        many += all.len();
    }
    assert!(many > few * 3 / 2, "{many} moves instead of {few}");
}

#[test]
fn every_move_around_pierce_groups_gains_what_it_says_and_leaves_a_tree() {
    let mut rng = seeded(7);
    let (mut hung, mut turned) = (0, 0);
    for round in 0..80 {
        let problem = random(3 + round % 9, [2, 4, 6][round % 3], &mut rng);
        let problem = with_groups(problem, &mut rng);
        let g = graph(&problem);
        let forest = random_forest(&g, &mut rng);
        near(solution(&g, &forest).cost, forest.seconds(&g));
        for (gain, change) in found(&g, &forest) {
            let mut next = forest.clone();
            change.apply(&g, &mut next);
            assert!(next.is_sound(&g), "{change:?}");
            let saved = forest.seconds(&g) - next.seconds(&g);
            assert!((saved - gain).abs() < 1e-9, "{change:?}: {saved} is not {gain}");
            near(solution(&g, &next).cost, next.seconds(&g));
            for item in (0..).take(problem.items.len()).filter(|&i| g.is_group(i) && next.children(i) > 0) {
                hung += 1;
                turned += usize::from(next.entry(item) != forest.entry(item));
            }
        }
    }
    assert!(hung > 100 && turned > 10, "{hung} {turned}");
}

#[test]
fn the_repair_puts_a_group_behind_what_would_be_too_late() {
    let mut rng = seeded(8);
    let mut late = 0;
    for round in 0..200 {
        let problem = random(3 + round % 6, 4, &mut rng);
        let problem = with_groups(problem, &mut rng);
        let g = graph(&problem);
        let mut forest = random_forest(&g, &mut rng);
        late += (0..).take(problem.items.len()).filter(|&i| forest.is_late(&g, i)).count();
        repair(&g, &mut forest);
        assert!(forest.is_sound(&g) && keeps_precedence(&g, &forest));
    }
    assert!(late > 10, "{late}");
}

#[test]
fn near_nodes_are_the_nearest_two_of_each_contour_and_on_demand_all_nodes() {
    let mut rng = seeded(2);
    for round in 0..20 {
        let problem = random(4 + 3 * round, 2 + round % 4, &mut rng);
        let (g, everywhere) = (graph(&problem), graph_of(&problem, Neighbourhood::All));
        for (id, node) in (0..).zip(&problem.nodes) {
            let seconds = |n: NodeId| g.air(node.exit, g.entry(n)).min(g.air(node.entry, g.entry(n)));
            let mut all: Vec<(f64, NodeId)> = (0..)
                .zip(&problem.nodes)
                .filter(|(_, n)| n.item != node.item)
                .map(|(n, _)| (seconds(n), n))
                .collect();
            all.sort_by(|a, b| a.partial_cmp(b).unwrap());
            assert_eq!(everywhere.near(id), all.iter().map(|n| n.1).collect::<Vec<_>>());
            let mut kept = vec![0; problem.items.len()];
            all.retain(|n| {
                kept[g.item(n.1) as usize] += 1;
                kept[g.item(n.1) as usize] <= 2
            });
            let wanted: Vec<NodeId> = all.iter().take(12).map(|n| n.1).collect();
            assert_eq!(g.near(id), wanted);
        }
    }
}

#[test]
fn with_precedence_no_move_breaks_it() {
    let mut rng = seeded(4);
    let (mut made, mut broken) = (0, 0);
    for round in 0..40 {
        let problem = random(4 + round % 12, 3, &mut rng);
        let g = graph(&problem);
        for keep in [true, false] {
            let mut forest = random_forest(&g, &mut rng);
            repair(&g, &mut forest);
            assert!(keeps_precedence(&g, &forest) && forest.is_sound(&g), "repaired");
            for item in (0..).take(problem.items.len()) {
                while improve(&g, &mut forest, item, (RepartitionMoves::Both, Reattach::Reopened), keep).0 {
                    made += 1;
                    broken += u32::from(!keeps_precedence(&g, &forest));
                    assert!(!keep || keeps_precedence(&g, &forest));
                }
            }
        }
    }
    assert!(made > 100 && broken > 10, "{made} {broken}");
}

#[test]
fn what_is_reattached_as_it_is_keeps_its_order_and_entries() {
    let mut rng = seeded(13);
    let (mut reattached, mut moved, mut reopened) = (0, 0, 0);
    for round in 0..40 {
        let problem = random(6 + round % 6, 3, &mut rng);
        let g = graph(&problem);
        let forest = random_forest(&g, &mut rng);
        let changes = |reattach| {
            let found = found_by(reattach, &g, &forest).into_iter();
            found.filter(|m| matches!(m.1, TreeMove::Reattach { .. })).count()
        };
        reopened += changes(Reattach::Reopened);
        for (gain, change) in found_by(Reattach::AsItIs, &g, &forest) {
            match change {
                TreeMove::Reattach { route, first, enter, .. } => {
                    let entered = forest.entry(forest.items(route)[0]);
                    assert!(first == 0 && enter.is_none_or(|n| n == entered), "{change:?}");
                    reattached += 1;
                }
                TreeMove::Own { enter, .. } | TreeMove::Into { enter, .. } => {
                    assert_eq!(enter, None);
                    moved += 1;
                }
                TreeMove::Merge { .. } => {}
            }
            let mut next = forest.clone();
            change.apply(&g, &mut next);
            near(forest.seconds(&g) - next.seconds(&g), gain);
        }
    }
    assert!(reattached > 10 && moved > 100 && reopened > 2 * reattached, "{reattached} {moved} {reopened}");
}

#[test]
fn entries_are_chosen_again_for_all_contours_or_for_some() {
    let problem = tall();
    let g = graph(&problem);
    let begun = || {
        let mut forest = Forest::new(&g);
        forest.splice(ROOT, 0, vec![0, 1, 2]);
        // Above, below, above: each way between them is 10 mm longer than it has to be.
        for (item, enter) in [(0, 1), (1, 2), (2, 5)] {
            forest.enter(item, enter);
        }
        forest
    };
    let improved = |only: Option<&[u32]>| {
        let mut forest = begun();
        assert!(entries::improve(&g, &mut forest, ROOT, true, only).0);
        [0, 1, 2].map(|item| forest.entry(item))
    };
    assert_eq!(improved(None), [0, 2, 4]);
    assert_eq!(improved(Some(&[2])), [1, 2, 4]);
}

#[test]
fn resolving_any_tree_leaves_a_tree() {
    let mut rng = seeded(6);
    for round in 0..80 {
        let problem = random(2 + round % 15, 2 + round % 4, &mut rng);
        let g = graph(&problem);
        let mut forest = random_forest(&g, &mut rng);
        let mut connections = Connections::default();
        let routes: Vec<u32> = forest.used().collect();
        for &route in &routes {
            connections.look(&g, &forest, route);
        }
        let number = |r: usize| routes.iter().position(|&o| o as usize == r).unwrap();
        let mut arcs: Vec<_> = connections.all.iter().map(|c| c.arc).collect();
        arcs.iter_mut().for_each(|a| (a.from, a.to) = (number(a.from), number(a.to)));
        let chosen = arborescence(routes.len(), number(ROOT as usize), &arcs).unwrap();
        let chosen: Vec<_> = chosen.into_iter().map(|k| connections.all[k]).collect();
        resolve(&g, &mut forest, &chosen);
        assert!(forest.is_sound(&g));
        near(solution(&g, &forest).cost, forest.seconds(&g));
    }
}

/// Four tall contours next to each other, 2 mm apart: (0|2|4|6, 0) to (0|2|4|6, 10).
fn tall() -> crate::problem::Problem {
    sheet(&[
        &[[0.0, 0.0], [0.0, 10.0]],
        &[[2.0, 0.0], [2.0, 10.0]],
        &[[4.0, 0.0], [4.0, 10.0]],
        &[[6.0, 0.0], [6.0, 10.0]],
    ])
}

/// The best move of a kind, and the tree after it.
fn best(g: &Graph, forest: &Forest, kind: fn(&TreeMove) -> bool) -> (f64, Forest) {
    let moves = found(g, forest);
    let (gain, change) = moves.iter().filter(|m| kind(&m.1)).max_by(|a, b| a.0.total_cmp(&b.0)).unwrap();
    let mut next = forest.clone();
    change.apply(g, &mut next);
    (*gain, next)
}

#[test]
fn a_partition_is_hung_up_where_it_is_near() {
    let problem = tall();
    let g = graph(&problem);
    let mut forest = Forest::new(&g);
    forest.splice(ROOT, 0, vec![0, 1, 2]);
    let route = forest.open(vec![3]);
    // 6 mm away, attached above and entered above.
    forest.enter(3, 7);
    forest.hang(&g, route, 1);
    let (gain, next) = best(&g, &forest, |m| matches!(m, TreeMove::Reattach { .. }));
    near(gain, 2.0 * 6.0 - 2.0 * 2.0);
    assert_eq!(next.at(next.route_of(3)), Some(5));
}

#[test]
fn a_chain_of_single_contours_becomes_one_partition() {
    let problem = tall();
    let g = graph(&problem);
    let mut forest = Forest::new(&g);
    forest.splice(ROOT, 0, vec![0]);
    // 1 is attached to 0, 2 to 1, 3 to 2. They are entered alternately above and below, as far apart as possible.
    for (item, at, enter) in [(1, 1, 2), (2, 3, 4), (3, 5, 6)] {
        forest.enter(item, enter);
        let route = forest.open(vec![item]);
        forest.hang(&g, route, at);
    }
    let leg = |x: f64| 2.0 * (x * x + 100.0).sqrt();
    near(forest.seconds(&g), 3.0 * leg(2.0) + 3.0 * PRE_CUT);
    let (gain, next) = best(&g, &forest, |m| matches!(m, TreeMove::Merge { nodes, .. } if nodes.len() == 3));
    // All three in one row above, from (0,10) to (6,10) and back, one pre-cut.
    near(next.seconds(&g), 12.0 + PRE_CUT);
    near(gain, 3.0 * leg(2.0) + 2.0 * PRE_CUT - 12.0);
    assert_eq!(next.items(next.route_of(1)).len(), 3);
}

#[test]
fn a_sub_sequence_becomes_a_partition() {
    let problem = tall();
    let g = graph(&problem);
    let mut forest = Forest::new(&g);
    forest.splice(ROOT, 0, vec![0, 1, 2, 3]);
    for (item, enter) in [(1, 3), (2, 5)] {
        forest.enter(item, enter);
    }
    // 0 to (2,10), (4,10), (6,0), home.
    let slant = 104.0_f64.sqrt();
    near(forest.seconds(&g), 2.0 * slant + 2.0 + 6.0);
    let (gain, next) = best(&g, &forest, |m| matches!(m, TreeMove::Own { places, .. } if places.len() == 2));
    // Both are attached above, at (0,10): 2, 2 and 4; below, 6 and 6.
    near(next.seconds(&g), 8.0 + PRE_CUT + 12.0);
    near(gain, 2.0 * slant + 8.0 - 20.0 - PRE_CUT);
    assert_eq!(next.items(next.route_of(1)), [1, 2]);
}

#[test]
fn a_sub_sequence_goes_into_another_partition() {
    let problem = tall();
    let g = graph(&problem);
    let mut forest = Forest::new(&g);
    forest.splice(ROOT, 0, vec![0, 2]);
    forest.enter(2, 5);
    let route = forest.open(vec![1, 3]);
    forest.enter(1, 3);
    forest.enter(3, 7);
    forest.hang(&g, route, 1);
    let before = forest.seconds(&g);
    near(before, 2.0 * 116.0_f64.sqrt() + 12.0 + PRE_CUT);
    let (gain, next) = best(&g, &forest, |m| matches!(m, TreeMove::Into { .. }));
    // The second contour of the root moves between the two above, or after them, which is as far. The root is then 0 alone.
    assert_eq!((next.items(ROOT), next.items(route).len(), next.route_of(2)), (&[0][..], 3, route));
    near(gain, 2.0 * 116.0_f64.sqrt());
    near(next.seconds(&g), 12.0 + PRE_CUT);
}
