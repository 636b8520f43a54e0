//! Which tours have kicks that cut long legs, and what these cut.

use super::super::exchange::{Stretches, draw_stretches};
use super::super::snapshot::TourSnapshot;
use super::super::space::Space;
use super::super::tour::Tour;
use super::{draw_between_long_legs, heat, percentage_of_kicks};
use crate::geometry::DVec2;
use crate::machine;
use crate::problem::{Item, Node, Problem};
use crate::solve::rng::seeded;

/// A row of groups of 40 points. The points of a group are 1 mm apart, the groups `apart` mm.
fn row(groups: u32, apart: f64) -> Problem {
    let place = |item: u32| DVec2::new(f64::from(item) + f64::from(item / 40) * (apart - 1.0), 0.0);
    let node =
        |item| Node { item, entry: place(item), exit: place(item), along: 0.0, reversed: false, twin: item };
    let count = 40 * groups;
    Problem {
        items: (0..count).map(|item| Item { nodes: item..item + 1, ..Item::default() }).collect(),
        nodes: (0..count).map(node).collect(),
        home: DVec2::new(-1.0, 0.0),
        closed: false,
        ..Problem::empty(machine::preset("length").unwrap())
    }
}

/// The tour along the row.
fn along(problem: &Problem) -> Tour<'_> {
    let space = Space::new(problem);
    let order = [space.home].into_iter().chain((0..).take(problem.items.len())).collect();
    Tour::new(space, TourSnapshot { order, at: vec![0; problem.items.len() + 1] })
}

fn mean_leg(tour: &Tour) -> f64 {
    tour.mean_leg(tour.cost())
}

/// How many of the legs that two stretches cut lead from group to group.
fn between_groups(tour: &Tour, Stretches { from, middle, to }: Stretches) -> usize {
    assert!(1 <= from && from <= middle && middle < to && to <= tour.last());
    [from - 1, middle, to].into_iter().filter(|&p| tour.leg_from(p) > 1.5 * tour.leg_from(0)).count()
}

#[test]
fn the_share_of_kicks_is_twice_that_of_long_legs_and_at_most_half() {
    // Of 400 legs 9 lead from group to group: 36 of 427 mm, 90 of 481 mm, 900 of 1,291 mm.
    for (apart, percent) in [(1.0, 0), (2.0, 0), (4.0, 16), (10.0, 37), (100.0, 50)] {
        let problem = row(10, apart);
        let tour = along(&problem);
        assert_eq!(percentage_of_kicks(&tour, mean_leg(&tour)), percent, "{apart} mm");
    }
}

#[test]
fn a_tour_of_no_length_has_no_such_kicks() {
    let mut problem = row(2, 1.0);
    problem.nodes.iter_mut().for_each(|node| (node.entry, node.exit) = (DVec2::ZERO, DVec2::ZERO));
    problem.home = DVec2::ZERO;
    let tour = along(&problem);
    assert_eq!(percentage_of_kicks(&tour, mean_leg(&tour)), 0);
}

#[test]
fn stretches_mostly_end_between_groups() {
    let problem = row(10, 100.0);
    let tour = along(&problem);
    let mut rng = seeded(1);
    let usual = (0..1000).filter_map(|_| draw_stretches(&tour, &mut rng, 300));
    let usual: usize = usual.map(|s| between_groups(&tour, s)).sum();
    let found = (0..1000).filter_map(|_| draw_between_long_legs(&tour, &mut rng));
    let found: usize = found.map(|s| between_groups(&tour, s)).sum();
    assert!(usual < 90 && found > 8 * usual, "{usual} usually, {found} of 3,000 cuts");
}

#[test]
fn stretches_are_never_empty() {
    for count in [1, 2] {
        let mut problem = row(1, 1.0);
        problem.items.truncate(count + 1);
        problem.nodes.truncate(count + 1);
        let tour = along(&problem);
        let mut rng = seeded(7);
        let drawn: Vec<Stretches> =
            (0..100).filter_map(|_| draw_between_long_legs(&tour, &mut rng)).collect();
        assert!(!drawn.is_empty());
        drawn.into_iter().for_each(|stretches| assert_eq!(between_groups(&tour, stretches), 0));
    }
}

#[test]
fn a_kick_is_as_hot_as_its_legs_are_long() {
    let problem = row(3, 100.0);
    let tour = along(&problem);
    // Two of the three legs lead from group to group.
    let between = Stretches { from: 41, middle: 80, to: 90 };
    assert!((heat(&tour, between, 3.0) - 201.0 / 9.0).abs() < 1e-9);
    let within = Stretches { from: 2, middle: 4, to: 9 };
    assert!((heat(&tour, within, 3.0) - 1.0).abs() < 1e-9);
}
