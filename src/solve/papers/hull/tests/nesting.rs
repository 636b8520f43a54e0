//! Chromosomes are read as visits that nest, with no more travel.

use super::super::chromosome::{genes, keys};
use super::super::decode::Decoder;
use super::super::model::{Gene, Model, Visit};
use super::super::nested::nested;
use super::sheets::{model, random_sheet, sheet};
use crate::problem::{Node, NodeId, Problem};
use crate::solve::papers::Measure;
use crate::solve::rng::{Draw, Rng, seeded};
use std::collections::BTreeSet;

/// Checks that the visits of every contour join and go around it once, and that visits of different contours nest.
fn assert_nested(problem: &Problem, path: &[Visit]) {
    let item = |n: NodeId| problem.nodes[n as usize].item;
    let mut open: Vec<(u32, NodeId, NodeId)> = Vec::new();
    let mut done = BTreeSet::new();
    for v in path {
        let begun = open.pop_if(|o| o.0 == item(v.enter));
        let start = begun.map_or(v.enter, |o| o.1);
        assert!(begun.is_none_or(|o| o.2 == v.enter), "goes on where it was left");
        let nodes = &problem.items[item(v.enter) as usize].nodes;
        let place = |n: NodeId| (n + nodes.end - nodes.start - start) % (nodes.end - nodes.start);
        if v.leave == start {
            assert!(done.insert(item(v.enter)), "once");
        } else {
            assert!(place(v.leave) > place(v.enter), "in the stored direction");
            open.push((item(v.enter), start, v.leave));
        }
    }
    assert!(open.is_empty() && done.len() == problem.items.len());
}

#[test]
fn any_chromosome_nests_with_no_more_travel() {
    let mut rng = seeded(1);
    let mut same = 0;
    for round in 0..4000 {
        let problem = random_sheet(1 + round % 7, round % 3 > 0, &mut rng);
        let model = model(&problem);
        let order = genes(&model, &keys(&model, &mut rng));
        let visits = model.visits(&order);
        let path = nested(&model, &visits);
        assert_nested(&problem, &path);
        let (before, after) = (model.travel(&visits), model.travel(&path));
        assert!(after <= before + 1e-9, "{after} {before}");
        same += u32::from(after > before - 1e-9);
    }
    assert!(same > 200, "{same}");
}

/// A random walk over the same moves and segments: the same multigraph, traversed in another order and direction.
fn shuffled(model: &Model, path: &[Gene], rng: &mut Rng) -> Vec<Gene> {
    const HOME: NodeId = NodeId::MAX;
    // Edges: air moves, and segments with their genes.
    let mut edges: Vec<(NodeId, NodeId, Option<Gene>)> = Vec::new();
    let mut here = HOME;
    for &gene in path {
        let cut = model.cut(gene);
        if here != cut.enter {
            edges.push((here, cut.enter, None));
        }
        edges.push((cut.enter, cut.leave, Some(gene)));
        here = cut.leave;
    }
    let (Some(&first), Some(last)) = (edges.first(), path.last()) else { return Vec::new() };
    edges.push((model.cut(*last).leave, HOME, None));
    // Hierholzer's algorithm from the first move on, choosing edges at random.
    let mut used = vec![false; edges.len()];
    used[0] = true;
    let mut tour = vec![first];
    let mut at = 0;
    while at < tour.len() {
        let mut insert = at + 1;
        let mut here = tour[at].1;
        loop {
            let open: Vec<usize> = (0..edges.len())
                .filter(|&e| !used[e] && (edges[e].0 == here || edges[e].1 == here))
                .collect();
            if open.is_empty() {
                break;
            }
            let e = open[rng.below(open.len())];
            used[e] = true;
            let (a, b, gene) = edges[e];
            let step = if a == here { (a, b, gene) } else { (b, a, gene.map(|g| g ^ 1)) };
            here = step.1;
            tour.insert(insert, step);
            insert += 1;
        }
        // Stays at the same position until it has no unused edges.
        at += usize::from(insert == at + 1);
    }
    tour.into_iter().filter_map(|e| e.2).collect()
}

/// A tree of contours: each is entered at its first node and left for at most one other at each later node.
fn tree(model: &Model, contours: &mut Vec<u32>, rng: &mut Rng, out: &mut Vec<Gene>) {
    let Some(item) = contours.pop() else { return };
    let nodes = model.problem().items[item as usize].nodes.clone();
    let genes: Vec<Gene> = nodes.clone().map(|n| 2 * n).collect();
    for (k, gene) in genes.into_iter().enumerate() {
        if k > 0 && rng.uniform() < 0.6 {
            tree(model, contours, rng, out);
        }
        out.push(gene);
    }
}

#[test]
fn a_path_of_nested_visits_keeps_its_travel_however_its_moves_are_gone() {
    let mut rng = seeded(2);
    let mut turned = 0;
    for round in 0..3000 {
        let problem = random_sheet(1 + round % 9, round % 2 > 0, &mut rng);
        let model = model(&problem);
        let mut contours: Vec<u32> = (0..).take(problem.items.len()).collect();
        let mut path = Vec::new();
        while !contours.is_empty() {
            tree(&model, &mut contours, &mut rng, &mut path);
        }
        let travel = |genes: &[Gene]| model.travel(&model.visits(genes));
        let walk = shuffled(&model, &path, &mut rng);
        assert_eq!(walk.len(), path.len(), "the same segments");
        assert!((travel(&walk) - travel(&path)).abs() < 1e-9);
        let read = nested(&model, &model.visits(&walk));
        assert_nested(&problem, &read);
        assert!((model.travel(&read) - travel(&path)).abs() < 1e-9);
        turned += u32::from(walk != path);
    }
    assert!(turned > 2000, "{turned}");
}

#[test]
fn contours_cut_whole_are_taken_along_either_way() {
    // Contours 0 and 1 may be left; 2 is open, 3 is closed and cut whole.
    let corners: [&[[f64; 2]]; 4] = [
        &[[0., 1.], [9., 1.], [5., 5.]],
        &[[0., 7.], [3., 9.]],
        &[[1., 1.], [2., 8.]],
        &[[4., 4.], [6., 6.]],
    ];
    let mut problem = sheet(&corners, true);
    problem.items[2].leave = None;
    problem.items[3].leave = None;
    let [a, b] = [problem.nodes[5].entry, problem.nodes[6].entry];
    problem.nodes[5] = Node { exit: b, twin: 6, ..problem.nodes[5] };
    problem.nodes[6] = Node { exit: a, twin: 5, reversed: true, ..problem.nodes[6] };
    let decoder = Decoder::new(&problem, Measure::Euclidean);
    let mut rng = seeded(3);
    assert_eq!(decoder.model.sizes, [3, 2, 1, 2]);
    for _ in 0..500 {
        let order = genes(&decoder.model, &keys(&decoder.model, &mut rng));
        let (length, visits) = decoder.price(&order);
        let solution = decoder.solution(visits);
        assert_eq!(solution.stops.iter().filter(|s| problem.nodes[s.node as usize].item >= 2).count(), 2);
        // At unit speed, seconds are millimetres.
        assert!(solution.cost <= length + 1e-9);
    }
}

/// The paper prints both paths of its figure 5, but not the coordinates: here all lies on one line but for the parts' depth.
#[test]
#[allow(clippy::float_cmp, reason = "the numbers of the example are exact")]
fn figure_5_leaving_a_part_saves_travel() {
    let first = [[1.0, 0.0], [2.0, 1.0], [4.0, 1.0], [5.0, 0.0], [3.0, -1.0]];
    let second = [[6.0, 0.0], [8.0, 1.0], [9.0, 0.0], [8.0, -1.0]];
    let problem = sheet(&[&first, &second], true);
    let model = model(&problem);
    let travel = |genes: &[Gene]| model.travel(&model.visits(genes));
    // Figure 5a: S' = O P11 + P11 P12 + P12 O.
    assert_eq!(travel(&[0, 2, 4, 6, 8, 10, 12, 14, 16]), 1.0 + 5.0 + 6.0);
    // Figure 5b, part 1 left at P41: S = 2 O P11 + 2 P41 P12.
    assert_eq!(travel(&[0, 2, 4, 10, 12, 14, 16, 6, 8]), 2.0 * 1.0 + 2.0 * 1.0);
}
