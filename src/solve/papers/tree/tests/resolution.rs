//! The four cases of figure 5, mergers at one node, and the repair, each checked by hand.

use super::super::drawn_partitions::partitions;
use super::super::forest::{Forest, ROOT};
use super::super::graph::Graph;
use super::super::repair::repair;
use super::super::resolve::connect;
use super::super::visits::{finished, keeps_precedence, solution};
use super::{PRE_CUT, graph, near, sheet};
use crate::problem::Problem;

/// Contours with two nodes: A from (0,0) to (0,10); B starts 5 mm and C 10 mm further right; D is left of A.
fn contours() -> Problem {
    sheet(&[
        &[[0.0, 0.0], [0.0, 10.0]],
        &[[5.0, 10.0], [5.0, 20.0]],
        &[[10.0, 10.0], [10.0, 20.0]],
        &[[-5.0, 10.0], [-5.0, 20.0]],
    ])
}
const A: u32 = 0;
const B: u32 = 1;
const C: u32 = 2;
const D: u32 = 3;
const A0: u32 = 0;
const A1: u32 = 1;
const B0: u32 = 2;
const B1: u32 = 3;
const D0: u32 = 6;

/// The root with A, entered at A0, and an unattached partition of B and C, entered at B0 and C0.
fn loose(g: &Graph) -> Forest {
    let mut forest = Forest::new(g);
    forest.splice(ROOT, 0, vec![A]);
    forest.open(vec![B, C]);
    forest
}

fn seconds(g: &Graph, forest: &Forest) -> f64 {
    let path = solution(g, forest);
    near(path.cost, forest.seconds(g));
    path.cost
}

#[test]
fn case_a_hangs_the_child_at_the_parents_node() {
    let problem = contours();
    let g = graph(&problem);
    let mut forest = loose(&g);
    connect(&g, &mut forest, Some(A1), B0);
    assert_eq!(forest.at(forest.route_of(B)), Some(A1));
    assert_eq!(forest.items(forest.route_of(C)), [B, C]);
    // From A1 5 to B0, 5 to C0, 10 back.
    near(seconds(&g, &forest), 20.0 + PRE_CUT);
}

#[test]
fn case_b_makes_the_connection_contour_a_partition_between() {
    let problem = contours();
    let g = graph(&problem);
    let mut forest = loose(&g);
    connect(&g, &mut forest, Some(A1), B1);
    assert_eq!((forest.entry(B), forest.at(forest.route_of(B))), (B1, Some(A1)));
    assert_eq!((forest.items(forest.route_of(B)), forest.at(forest.route_of(C))), (&[B][..], Some(B0)));
    let told = partitions(&problem, &solution(&g, &forest));
    let parents: Vec<_> = told.parents.iter().map(|p| (p.contour, p.at)).collect();
    assert_eq!((told.of, parents), (vec![0, 1, 2, -1], vec![(A, [0.0, 10.0]), (B, [5.0, 10.0])]));
    // (0,10) to (5,20) and back; from B0 5 to C0 and back.
    near(seconds(&g, &forest), 2.0 * 125.0_f64.sqrt() + PRE_CUT + 10.0 + PRE_CUT);
}

#[test]
fn case_c_puts_the_connection_contour_beside_the_parents() {
    let problem = contours();
    let g = graph(&problem);
    let mut forest = loose(&g);
    connect(&g, &mut forest, Some(A0), B1);
    assert_eq!((forest.items(ROOT), forest.entry(B)), (&[A, B][..], B1));
    assert_eq!(forest.at(forest.route_of(C)), Some(B0));
    // From A0 to B1 and home; from B0 5 to C0 and back.
    near(seconds(&g, &forest), 2.0 * 425.0_f64.sqrt() + 10.0 + PRE_CUT);
}

#[test]
fn case_d_makes_both_one() {
    let problem = contours();
    let g = graph(&problem);
    // Home counts as a contour entered at home.
    for from in [Some(A0), None] {
        let mut forest = loose(&g);
        connect(&g, &mut forest, from, B0);
        assert_eq!((forest.items(ROOT).len(), forest.used().count()), (3, 1));
        // To (5,10), 5 to (10,10), home.
        near(seconds(&g, &forest), 125.0_f64.sqrt() + 5.0 + 200.0_f64.sqrt());
    }
}

#[test]
fn children_at_one_node_become_one() {
    let problem = contours();
    let g = graph(&problem);
    let mut forest = loose(&g);
    connect(&g, &mut forest, Some(A1), B0);
    forest.open(vec![D]);
    connect(&g, &mut forest, Some(A1), D0);
    assert_eq!((forest.route_of(D), forest.used().count()), (forest.route_of(B), 2));
    // 5 to B0, 5 to C0, 15 to D0, 5 back; the pre-cut once.
    near(seconds(&g, &forest), 30.0 + PRE_CUT);
}

#[test]
fn a_contour_finished_too_early_goes_behind_what_is_inside_it() {
    let mut problem = contours();
    // D lies inside A, and A inside B.
    problem.items[D as usize].before = Some(A);
    problem.items[A as usize].before = Some(B);
    let g = graph(&problem);
    let mut forest = Forest::new(&g);
    // B comes first and is left for A, which is left for C; D comes last.
    forest.splice(ROOT, 0, vec![B, D]);
    let route = forest.open(vec![A]);
    forest.hang(&g, route, B1);
    let route = forest.open(vec![C]);
    forest.hang(&g, route, A1);
    assert!(!keeps_precedence(&g, &forest));
    let (moved, _) = repair(&g, &mut forest);
    // A moves to after D, and C takes its place; then B moves to after A, and C takes its place.
    assert_eq!((moved, forest.items(ROOT)), (vec![A, B], &[C, D, A, B][..]));
    assert!(keeps_precedence(&g, &forest) && forest.is_sound(&g));
    assert_eq!(finished(&g, &forest), [2, 3, 0, 1]);
}
