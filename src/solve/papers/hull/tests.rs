//! Codes and operators, checked by hand and by brute force.

use super::chromosome::{Chromosome, genes, keys};
use super::crossover::{OPERATORS, Operator, Torn, cross};
use super::decode::Decoder;
use super::filling::Filling;
use super::model::{BLANK, Gene, Model, Visit};
use super::nested::nested;
use crate::problem::{Node, NodeId, Problem};
use crate::solve::papers::{Legs, Measure, test_sheet};
use crate::solve::rng::{Draw, Rng, seeded};
use std::collections::BTreeSet;

/// Closed contours with these corners, which may be left at no cost; a closed path returns to (0, 0).
fn sheet(contours: &[&[[f64; 2]]], closed: bool) -> Problem {
    Problem { closed, ..test_sheet::sheet(contours, Some(0.0), "length-partial") }
}

fn random_sheet(contours: usize, closed: bool, rng: &mut Rng) -> Problem {
    let mut place = || [rng.uniform() * 100.0, rng.uniform() * 100.0];
    let corners: Vec<Vec<[f64; 2]>> =
        (0..contours).map(|c| (0..2 + c % 5).map(|_| place()).collect()).collect();
    sheet(&corners.iter().map(Vec::as_slice).collect::<Vec<_>>(), closed)
}

fn model(problem: &Problem) -> Model<'_> {
    Model::new(Legs::new(problem, Measure::Euclidean), false)
}

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

fn chromosome(paths: &[&[Gene]]) -> Chromosome {
    let sizes: Vec<u32> = paths.iter().map(|p| u32::try_from(p.len()).unwrap()).collect();
    Chromosome::new(paths.concat(), &sizes)
}

/// The paper counts segments from 1; a minus sign means against the stored direction.
fn coded(paths: &[&[i32]]) -> Chromosome {
    let code = |&s: &i32| 2 * (s.unsigned_abs() - 1) + u32::from(s < 0);
    let paths: Vec<Vec<Gene>> = paths.iter().map(|p| p.iter().map(code).collect()).collect();
    chromosome(&paths.iter().map(Vec::as_slice).collect::<Vec<_>>())
}

fn cross_often(by: Operator, parents: [&Chromosome; 2], sizes: &[u32]) -> Vec<[Torn; 2]> {
    (0..400).map(|seed| cross(by, parents, sizes, &mut seeded(seed))).collect()
}

/// Figure 6 in words: chromosome 1 receives {5, 2} from chromosome 2. 2 then occurs twice, and the one outside the run is
/// blanked.
#[test]
fn received_codes_stay_and_their_doubles_are_blanked() {
    let one = coded(&[&[1, 4, 3], &[2, 6, 5]]);
    let two = coded(&[&[6, 5, 2], &[3, 1, 4]]);
    let wanted = |torn: &[Torn; 2]| torn[0].chromosome.genes[..3] == coded(&[&[1, 5, 2]]).genes[..];
    let all = cross_often(Operator::Positive, [&one, &two], &[3, 3]);
    let [a, b] = all.iter().find(|t| wanted(t) && t[0].chromosome.genes[3] == BLANK).unwrap();
    // A run of path 2 was exchanged as well: 5 or 6 of it was given away or occurs twice.
    assert_eq!(a.chromosome.genes[3], BLANK, "2 outside is blanked");
    for torn in [a, b] {
        let blanks = torn.chromosome.genes.iter().filter(|&&g| g == BLANK).count();
        assert_eq!(blanks, torn.missing.len());
        let held: BTreeSet<u32> =
            torn.chromosome.genes.iter().filter(|&&g| g != BLANK).map(|g| g / 2).collect();
        assert_eq!(held.len() + torn.missing.len(), 6, "every segment stands once or is missing");
        assert!(torn.missing.iter().all(|s| !held.contains(s)));
    }
}

#[test]
fn the_three_crossovers_give_runs_as_they_say() {
    let one = coded(&[&[1, 2, 3, 4, 5]]);
    let two = coded(&[&[-3, -2, -1, -5, -4]]);
    // The runs that side 0 received from side 1, where every segment is cut against the stored direction; RSX turns them
    // back.
    let runs = |by| -> BTreeSet<(usize, Vec<Gene>)> {
        let all = cross_often(by, [&one, &two], &[5]);
        let own: Vec<Vec<Gene>> = all.into_iter().map(|[t, _]| t.chromosome.genes).collect();
        let run = |genes: &Vec<Gene>| {
            let given: Vec<usize> = (0..5)
                .filter(|&k| genes[k] != BLANK && (genes[k] % 2 == 1 || genes[k] != one.genes[k]))
                .collect();
            Some((*given.first()?, given.iter().map(|&k| genes[k]).collect()))
        };
        own.iter().filter_map(run).collect()
    };
    // PSX: places 1 and 2 get -2 -1 of chromosome 2; RSX: reversed, 1 2; ISX: also runs from other places of chromosome 2.
    let psx = runs(Operator::Positive);
    assert!(psx.contains(&(1, vec![3, 1])));
    assert!(psx.iter().all(|(at, run)| two.genes[*at..*at + run.len()] == run[..]));
    assert!(runs(Operator::Reverse).contains(&(1, vec![0, 2])));
    let isx = runs(Operator::Intersect);
    assert!(isx.is_superset(&psx) || isx.contains(&(1, vec![3, 1])));
    // Paths of equal length exchange the same places; a longer one gives any of its places.
    let short = coded(&[&[1], &[2, 3, 4, 5]]);
    let given: BTreeSet<Gene> =
        cross_often(Operator::Intersect, [&short, &coded(&[&[5, 4, 3], &[2, 1]])], &[2, 3])
            .iter()
            .map(|t| t[0].chromosome.genes[0])
            .collect();
    assert!(given.is_superset(&BTreeSet::from([8, 6, 4])), "{given:?}");
}

#[test]
fn crossovers_bring_paths_back_to_their_lengths_and_keep_every_segment() {
    let mut rng = seeded(5);
    for round in 0..600 {
        let problem = random_sheet(2 + round % 6, true, &mut rng);
        let model = model(&problem);
        let mut parents =
            [(); 2].map(|()| Chromosome::new(genes(&model, &keys(&model, &mut rng)), &model.sizes));
        for parent in &mut parents {
            for _ in 0..round % 4 {
                parent.migrate(&mut rng);
                parent.mutate(&mut rng);
            }
            let mut held: Vec<u32> = parent.genes.iter().map(|g| g / 2).collect();
            held.sort_unstable();
            assert!(held.into_iter().eq(0..u32::try_from(model.segments()).unwrap()));
            assert_eq!(parent.ends[parent.ends.len() - 1] as usize, model.segments());
        }
        let lengths = |c: &Chromosome| (0..model.sizes.len()).map(|m| c.path(m).len()).collect::<Vec<_>>();
        for by in OPERATORS {
            let torn = cross(by, [&parents[0], &parents[1]], &model.sizes, &mut rng);
            for (torn, parent) in torn.into_iter().zip(&parents) {
                let (now, was) = (lengths(&torn.chromosome), lengths(parent));
                for (m, &size) in model.sizes.iter().enumerate() {
                    let size = size as usize;
                    assert!((now[m] >= size || now[m] >= was[m]) && (now[m] <= size || now[m] <= was[m]));
                }
                let mut filling = Filling::new(&model, torn, &mut rng);
                while filling.work(&model) > 0 {}
                let child = filling.full().unwrap();
                let held: BTreeSet<u32> = child.genes.iter().map(|g| g / 2).collect();
                assert_eq!((held.len(), child.genes.len()), (model.segments(), model.segments()));
            }
        }
    }
}

#[test]
fn blanks_take_first_what_goes_on_and_then_what_adds_least() {
    // Two squares: genes 0, 2, 4, 6 go around the first, 8 to 14 around the second.
    let squares: [&[[f64; 2]]; 2] =
        [&[[0., 0.], [1., 0.], [1., 1.], [0., 1.]], &[[9., 0.], [10., 0.], [10., 1.], [9., 1.]]];
    let problem = sheet(&squares, true);
    let model = model(&problem);
    let fill = |genes: &[Gene], missing: &[u32]| {
        let torn = Torn { chromosome: Chromosome::new(genes.to_vec(), &[4, 4]), missing: missing.to_vec() };
        let mut filling = Filling::new(&model, torn, &mut seeded(1));
        filling.work(&model);
        filling.full().unwrap().genes
    };
    assert_eq!(fill(&[0, BLANK, 4, 6, 8, 10, BLANK, 14], &[1, 6]), [0, 2, 4, 6, 8, 10, 12, 14]);
    // From the end: 2 leads to 4.
    assert_eq!(fill(&[BLANK, BLANK, 4, 6, 8, 10, 12, 14], &[0, 1]), [0, 2, 4, 6, 8, 10, 12, 14]);
    // Nothing continues from 6, but 14 leads to 8.
    let genes = fill(&[0, 2, 4, 6, BLANK, 8, 10, 12], &[7]);
    assert_eq!(genes, [0, 2, 4, 6, 14, 8, 10, 12], "it leads to the one behind");
    let genes = fill(&[12, 0, 2, 4, BLANK, 8, 10, BLANK], &[3, 7]);
    assert_eq!(genes[4], 6, "3 goes on from 2");
    assert_eq!(genes[7] / 2, 7);
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
