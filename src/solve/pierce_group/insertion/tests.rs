//! The heuristic by hand, and compared with the heuristic as it is written down.

use super::*;
use crate::geometry::math::unit;
use crate::geometry::{DVec2, Path, Segment};
use crate::machine::preset;
use crate::problem::{Element, GroupProblem};

/// Two parts of 20 by 10 that share the side between nodes 0 and 1. `shared` is the number of that side among the three
/// elements; the outline of the left part comes before that of the right one.
fn two_parts(shared: usize) -> GroupProblem {
    let place = |p: [f64; 2]| DVec2::from(p);
    let path = |points: &[[f64; 2]]| {
        let line = |w: &[[f64; 2]]| Segment::line(place(w[0]), place(w[1]));
        Path::new(points.windows(2).map(line).collect(), false)
    };
    let element = |points: &[[f64; 2]], faces| Element {
        contour: 0,
        from: 0.0,
        to: 0.0,
        ends: [0, 1],
        faces,
        path: path(points),
    };
    let side = element(&[[20.0, 0.0], [20.0, 10.0]], [1, 2]);
    let left = element(&[[20.0, 0.0], [0.0, 0.0], [0.0, 10.0], [20.0, 10.0]], [0, 1]);
    let right = element(&[[20.0, 0.0], [40.0, 0.0], [40.0, 10.0], [20.0, 10.0]], [2, 0]);
    let mut elements = vec![left, right];
    elements.insert(shared, side);
    GroupProblem {
        nodes: vec![place([20.0, 0.0]), place([20.0, 10.0])],
        elements,
        faces: 3,
        beside: Vec::new(),
    }
}

#[test]
fn the_cheapest_insertion_that_keeps_the_order_possible_by_hand() {
    let machine = preset("fibre-6kw-thick").unwrap();
    let group = two_parts(0);
    let net = Net::new(&group, &machine, false);
    // The order begins with the shared side upwards and ends with the left outline, both from 0 to 1. The right outline
    // goes between them: downwards, from 1 to 0, it takes away the air move from 1 to 0; upwards it would add another.
    assert_eq!(order(&net, 0, 1), Some(vec![0, 5, 2]));
    // From 1 to 0 all directions are turned.
    assert_eq!(order(&net, 1, 0), Some(vec![1, 4, 3]));
    // Every node has an odd number of elements: without an air move nothing leads back to where it began, so the cheapest
    // insertion has one, upwards from 0 after the head has come to 1.
    let back = order(&net, 0, 0).unwrap();
    assert_eq!((net.ends(&back), back.len()), ([0, 0], 3));

    // If the order would end with the shared side, both of its parts had fallen out before: there is no such order.
    let group = two_parts(1);
    let net = Net::new(&group, &machine, false);
    assert_eq!(order(&net, 0, 1), None);
}

/// A grid of parts that share their sides, with its nodes moved by up to `off` mm.
fn grid(columns: u32, rows: u32, off: f64) -> GroupProblem {
    let node = |x: u32, y: u32| x * (rows + 1) + y;
    let face = |x: u32, y: u32| if x < columns && y < rows { 1 + x * rows + y } else { 0 };
    let at = |x: u32, y: u32| {
        let turn = f64::from(7 * x + 3 * y);
        DVec2::new(f64::from(x) * 30.0, f64::from(y) * 20.0) + unit(turn) * off
    };
    let places = || (0..=columns).flat_map(|x| (0..=rows).map(move |y| (x, y)));
    let side = |from: (u32, u32), to: (u32, u32), faces| Element {
        contour: 0,
        from: 0.0,
        to: 0.0,
        ends: [node(from.0, from.1), node(to.0, to.1)],
        faces,
        path: Path::new(vec![Segment::line(at(from.0, from.1), at(to.0, to.1))], false),
    };
    let mut elements = Vec::new();
    for (x, y) in places() {
        if x < columns {
            elements.push(side((x, y), (x + 1, y), [face(x, y), y.checked_sub(1).map_or(0, |y| face(x, y))]));
        }
        if y < rows {
            elements.push(side((x, y), (x, y + 1), [x.checked_sub(1).map_or(0, |x| face(x, y)), face(x, y)]));
        }
    }
    GroupProblem {
        nodes: places().map(|(x, y)| at(x, y)).collect(),
        elements,
        faces: 1 + columns * rows,
        beside: Vec::new(),
    }
}

/// The heuristic as it is written down: every insertion is priced and tried in each round, until one is possible.
fn as_written(net: &Net, from: u32, to: u32) -> Option<Order> {
    let first = net.steps().find(|&s| net.step(s)[0] == from)?;
    let last = net.steps().find(|&s| net.step(s)[1] == to && s / 2 != first / 2);
    let mut growing = Growing { net, order: std::iter::once(first).chain(last).collect(), left: Vec::new() };
    let mut left: Vec<u32> = net.elements().filter(|e| !growing.order.iter().any(|s| s / 2 == *e)).collect();
    while !left.is_empty() {
        let mut ways: Vec<(usize, Insertion)> = Vec::new();
        for (which, e) in left.iter().enumerate() {
            for place in growing.places() {
                ways.extend([2 * e, 2 * e + 1].map(|step| (which, growing.insertion(step, place))));
            }
        }
        ways.sort_by_key(|(which, way)| way.key(*which));
        let possible = |(which, way): &(usize, Insertion)| {
            let mut order = growing.order.clone();
            order.insert(way.place, way.step);
            let mut held = net.held();
            for _ in 0..net.group.faces {
                for (_, &e) in left.iter().enumerate().filter(|(other, _)| other != which) {
                    net.put_back(&mut held, 2 * e);
                }
            }
            order.iter().rev().all(|&s| net.put_back(&mut held, s))
        };
        let (which, way) = ways.into_iter().find(possible)?;
        growing.order.insert(way.place, way.step);
        left.swap_remove(which);
    }
    let order = growing.order;
    (net.ends(&order) == [from, to] && net.is_possible(&order)).then_some(order)
}

#[test]
fn the_orders_are_those_of_the_heuristic_as_it_is_written_down() {
    let mut found = 0;
    for name in ["fibre-6kw-thick", "co2-100w"] {
        let machine = preset(name).unwrap();
        for (columns, rows, off) in [(2, 1, 0.0), (2, 2, 1.0), (3, 2, 0.0), (4, 3, 2.0), (3, 4, 0.0)] {
            let group = grid(columns, rows, off);
            let net = Net::new(&group, &machine, false);
            for from in net.nodes().step_by(3) {
                for to in net.nodes().step_by(2) {
                    let wanted = as_written(&net, from, to);
                    found += usize::from(wanted.is_some());
                    assert_eq!(order(&net, from, to), wanted, "{name}: {columns} x {rows}, {from} to {to}");
                }
            }
        }
    }
    assert!(found > 100, "{found}");
}
