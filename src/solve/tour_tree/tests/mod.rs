//! The search against brute force on small problems of every kind; gains and precedence are asserted on every kick
//! by the debug assertions of `anneal`.

mod slide;

use super::*;
use crate::geometry::{Arc, DVec2, Path, Segment};
use crate::machine::{self, AirTime, ClosedRun};
use crate::problem::{Groups, Item, Node, NodeId};
use crate::solve::rng::seeded;
use rand_xoshiro::Xoshiro256PlusPlus;
use rand_xoshiro::rand_core::{Rng, SeedableRng};

struct TestRng(Xoshiro256PlusPlus);

impl TestRng {
    fn below(&mut self, n: u64) -> u32 {
        u32::try_from(self.0.next_u64() % n).unwrap()
    }

    fn place(&mut self) -> DVec2 {
        DVec2::new(f64::from(self.below(1000)), f64::from(self.below(700)))
    }
}

/// Closed items with up to three loose entries, open items, some inside others, some of a later rank.
pub(super) fn small(seed: u64, count: u32, machine: &str, closed: bool) -> Problem {
    let mut rng = TestRng(Xoshiro256PlusPlus::seed_from_u64(seed));
    let machine = machine::preset(machine).unwrap();
    let (mut items, mut nodes): (Vec<Item>, Vec<Node>) = (Vec::new(), Vec::new());
    for item in 0..count {
        let first = NodeId::try_from(nodes.len()).unwrap();
        if rng.below(3) == 0 {
            let (a, b) = (rng.place(), rng.place());
            nodes.push(Node { item, entry: a, exit: b, along: 0.0, reversed: false, twin: first + 1 });
            nodes.push(Node { item, entry: b, exit: a, along: 0.0, reversed: true, twin: first });
        } else {
            for k in 0..=rng.below(3) {
                let entry = rng.place();
                let along = 0.25 * f64::from(k);
                nodes.push(Node { item, entry, exit: entry, along, reversed: false, twin: first + k });
            }
        }
        let rank = u32::from(item >= count - 1 && rng.below(2) == 0);
        // Later items lie around earlier ones.
        let before = (item + 1 < count && rng.below(2) == 0)
            .then(|| item + 1 + rng.below(u64::from(count - item - 1)));
        let end = NodeId::try_from(nodes.len()).unwrap();
        // Closed ones cost more or less by entry, as a polygon entered at a corner or on the way along its sides.
        let corner: Vec<DVec2> = (0..5).map(|_| rng.place() * 1e-3).collect();
        let run = (0..5).map(|k| Segment::line(corner[k], corner[(k + 1) % 5])).collect::<Vec<_>>();
        let open = nodes[first as usize].twin != first;
        let run = if open { None } else { ClosedRun::new(&machine, &machine.cut, false, &run) };
        items.push(Item { nodes: first..end, before, rank, run, ..Item::default() });
    }
    Problem { items, nodes, home: DVec2::new(-20.0, 10.0), closed, ..Problem::empty(machine) }
}

/// The same, with every item and what must come before it as a group.
fn grouped(mut problem: Problem) -> Problem {
    let inner = |i: u32| problem.items.iter().any(|item| item.before == Some(i));
    let ids = 0..u32::try_from(problem.items.len()).unwrap();
    let of = ids.clone().map(|i| if inner(i) { Some(i) } else { problem.items[i as usize].before }).collect();
    let around = ids.map(|i| problem.items[i as usize].before).collect();
    problem.groups = Groups::new(of, around);
    problem
}

/// Least seconds over all allowed orders and entries.
fn brute(problem: &Problem) -> f64 {
    fn go(p: &Problem, air: &AirTime, order: &mut Vec<u32>, head: DVec2, spent: f64, least: &mut f64) {
        let together = p.groups.are_together(order.iter().copied(), |i| p.items[i as usize].rank);
        if spent >= *least || !together {
            return;
        }
        if order.len() == p.items.len() {
            *least = least.min(spent + if p.closed { air.seconds(head, p.home) } else { 0.0 });
            return;
        }
        let left: Vec<u32> = (0..).take(p.items.len()).filter(|i| !order.contains(i)).collect();
        let rank = left.iter().map(|&i| p.items[i as usize].rank).min();
        for &i in &left {
            let waits = left.iter().any(|&c| p.items[c as usize].before == Some(i));
            if waits || Some(p.items[i as usize].rank) != rank {
                continue;
            }
            order.push(i);
            for n in p.items[i as usize].nodes.clone() {
                let node = &p.nodes[n as usize];
                let there = air.seconds(head, node.entry) + p.items[i as usize].extra(n, node.along);
                go(p, air, order, node.exit, spent + there, least);
            }
            order.pop();
        }
    }
    let mut least = f64::INFINITY;
    go(problem, &AirTime::new(&problem.machine), &mut Vec::new(), problem.home, 0.0, &mut least);
    least
}

#[test]
fn reaches_the_optimum_of_small_problems_of_every_kind() {
    for machine in ["length", "length-chebyshev", "co2-100w"] {
        for seed in 0..40 {
            let problem = small(seed, 1 + u32::try_from(seed % 6).unwrap(), machine, seed % 3 > 0);
            let problem = if seed % 4 > 1 { grouped(problem) } else { problem };
            let mut search = TourTree.start(&problem, seed, None);
            search.step(60_000);
            let (found, least) = (search.best().cost, brute(&problem));
            assert!(found <= least + 1e-9, "{machine} {seed}: {found} is not {least}");
            assert!(found >= least - 1e-9, "{machine} {seed}: {found} is below the optimum {least}");
        }
    }
}

/// Circles of radius 10 in a row, entered anywhere.
pub(super) fn circles(centers: &[DVec2]) -> Problem {
    let mut nodes = Vec::new();
    let items = (0..).zip(centers).map(|(item, &c)| {
        let path = Path::new(vec![Segment::Arc(Arc::circle(c, 10.0))], true);
        let entry = c + DVec2::new(10.0, 0.0);
        nodes.push(Node { item, entry, exit: entry, along: 0.0, reversed: false, twin: item });
        Item { nodes: item..item + 1, track: Some(path), ..Item::default() }
    });
    let items = items.collect();
    let machine = machine::preset("length").unwrap();
    Problem { items, nodes, home: DVec2::ZERO, closed: true, ..Problem::empty(machine) }
}

/// Holes of radius 10 in a grid that is not quite even, and a circle around all of them, the last item.
fn perforated(side: u32) -> Problem {
    let mut rng = TestRng(Xoshiro256PlusPlus::seed_from_u64(1));
    let mut off = || DVec2::new(f64::from(rng.below(100)), f64::from(rng.below(100))) * 0.2;
    let mut centers: Vec<DVec2> = (0..side * side)
        .map(|k| DVec2::new(f64::from(k % side), f64::from(k / side)) * 50.0 + off())
        .collect();
    let middle = DVec2::splat(f64::from(side) * 25.0);
    centers.push(middle);
    let mut problem = circles(&centers);
    let around = Arc::circle(middle, f64::from(side) * 40.0);
    if let (Some(item), Some(node)) = (problem.items.last_mut(), problem.nodes.last_mut()) {
        item.track = Some(Path::new(vec![Segment::Arc(around)], true));
        let start = Segment::Arc(around).start();
        (node.entry, node.exit) = (start, start);
    }
    problem
}

/// With 16 lists for each hole, a sheet of 100,000 holes was searched for eight seconds before the first path shorter than
/// nearest-next; one list took its place.
#[test]
fn on_very_large_sheets_small_items_have_one_list() {
    let problem = perforated(142);
    let (tour, near) = tour(&problem);
    let space = &tour.space;
    let lists = |item: u32| -> Vec<&[u32]> {
        (0..u32::try_from(space.places(item).len()).unwrap())
            .map(|at| near.of_place(space, item, at))
            .collect()
    };
    // A hole in the middle has its four neighbours, whichever side is asked.
    let hole = 71 * 142 + 71;
    let of_hole = lists(hole);
    for beside in [hole - 1, hole + 1, hole - 142, hole + 142] {
        assert!(of_hole[0].contains(&beside), "{beside} is not in {:?}", of_hole[0]);
    }
    assert!(of_hole.iter().all(|list| *list == of_hole[0]));
    // The circle around them has other neighbours on its left and on its right.
    let around = lists(142 * 142);
    assert!(around.iter().any(|list| *list != around[0]));

    let first = greedy(&problem).cost;
    let mut search = TourTree.start(&problem, 1, None);
    search.step(600_000);
    assert!(search.best().cost < 0.9 * first, "{} of {first}", search.best().cost);
}

/// Sixteen places 30 mm apart, and one far beyond their corner.
fn group_and_one() -> Vec<DVec2> {
    let group = (0..16).map(|k| DVec2::new(f64::from(k % 4), f64::from(k / 4)) * 30.0);
    group.chain([DVec2::splat(390.0)]).collect()
}

/// Without it, the search never changed how groups of holes follow each other: each hole knew only its own group.
#[test]
fn holes_of_a_group_know_the_next_hole_in_each_quadrant() {
    let problem = circles(&group_and_one());
    let (tour, near) = tour(&problem);
    let space = &tour.space;
    let (corner, alone) = (15, 16);
    let places = 0..u32::try_from(space.places(corner).len()).unwrap();
    let knows = |at: u32| near.of_place(space, corner, at).contains(&alone);
    assert!(places.clone().all(knows));
    // One in the middle has others of its group in every quadrant.
    assert!(!near.of_place(space, 5, 0).contains(&alone));
    // The others are the nearest: those beside it and across.
    for beside in [10, 11, 14] {
        assert!(places.clone().all(|at| near.of_place(space, corner, at).contains(&beside)));
    }
}

/// A table has no quadrants; its lists reach beyond a group by what is nearer to a place than to all in the list.
#[test]
fn places_of_a_group_know_the_next_group_by_the_table() {
    let places = group_and_one();
    let mut problem = circles(&places);
    for (item, &place) in places.iter().enumerate() {
        let id = NodeId::try_from(item).unwrap();
        problem.nodes[item] =
            Node { item: id, entry: place, exit: place, along: 0.0, twin: id, ..problem.nodes[item] };
        problem.items[item] = Item { nodes: id..id + 1, ..Item::default() };
    }
    problem.nodes.truncate(places.len());
    let costs = places.iter().flat_map(|a| places.iter().map(|b| a.distance(*b))).collect();
    (problem.closed, problem.table) = (true, crate::problem::Table::new(places.len(), costs));
    let (tour, near) = tour(&problem);
    // The corner lies nearer to the one that is alone than all others do. The last place is filled with the next nearest.
    assert_eq!(near.of_place(&tour.space, 15, 0), [11, 14, 10, 7, 13, 6, 9, 16]);
    assert!(!near.of_place(&tour.space, 5, 0).contains(&16));
}

#[test]
fn entries_slide_to_the_exact_minimum() {
    // Out to the near side of the farther circle and back; the nearer one touches the way.
    let problem = circles(&[DVec2::new(50.0, 10.0), DVec2::new(100.0, 0.0)]);
    let mut search = TourTree.start(&problem, 1, None);
    search.step(50_000);
    assert!((search.best().cost - 180.0).abs() < 1e-6, "{}", search.best().cost);
    for stop in &search.best().stops {
        let (entry, exit) = stop.ends(&problem).unwrap();
        assert_eq!(entry, exit);
    }
}

#[test]
fn nothing_and_a_single_item_end_at_once() {
    let none = circles(&[]);
    let mut search = TourTree.start(&none, 1, None);
    assert_eq!(search.step(1000).status, Status::Exhausted);
    assert_eq!(search.best().stops, []);
    let one = circles(&[DVec2::new(30.0, 40.0)]);
    let mut search = TourTree.start(&one, 1, None);
    assert_eq!(search.step(10_000).status, Status::Exhausted);
    assert!((search.best().cost - 80.0).abs() < 1e-6, "{}", search.best().cost);
}

#[test]
fn a_better_path_from_elsewhere_is_taken() {
    let problem = small(11, 6, "length", true);
    let mut far = TourTree.start(&problem, 3, None);
    far.step(60_000);
    let mut near = TourTree.start(&problem, 4, None);
    near.offer(far.best());
    assert_eq!(near.best(), far.best());
    let warm = TourTree.start(&problem, 4, Some(far.best()));
    assert_eq!(warm.best(), far.best());
}

/// The tour of the first feasible path, and its neighbour lists.
fn tour(problem: &Problem) -> (Tour<'_>, neighbours::Neighbours) {
    let space = Space::new(problem);
    let snapshot = space.snapshot(&greedy(problem));
    let tour = Tour::new(space, snapshot);
    let mut near = neighbours::Neighbours::new(&tour.space);
    while near.extend(&tour.space).is_some() {}
    (tour, near)
}

/// Problems of points and of tables, with and without precedence, some with legs that cost more one way than the other.
fn small_problems() -> impl Iterator<Item = Problem> {
    (0..60).map(|seed| {
        let mut problem = small(seed, 7, "length", seed % 3 > 0);
        if seed % 2 == 0 {
            problem.items.iter_mut().for_each(|i| i.before = None);
        }
        if seed % 4 > 1 {
            let mut rng = TestRng(Xoshiro256PlusPlus::seed_from_u64(seed));
            let n = problem.nodes.len();
            let mut costs: Vec<f64> = (0..n * n).map(|_| f64::from(rng.below(100))).collect();
            if seed % 8 < 4 {
                (0..n).for_each(|a| (0..a).for_each(|b| costs[a * n + b] = costs[b * n + a]));
            }
            problem.nodes.iter_mut().zip(0..).for_each(|(node, id)| node.twin = id);
            // The cycle starts at the last item: nothing comes before it.
            let start = Some(6);
            problem.items.iter_mut().filter(|i| i.before == start).for_each(|i| i.before = None);
            problem.items.iter_mut().for_each(|i| (i.rank, i.run) = (0, None));
            (problem.closed, problem.table) = (true, crate::problem::Table::new(n, costs));
        }
        problem
    })
}

#[test]
fn ruin_and_recreate_costs_what_it_says_and_keeps_precedence() {
    for (problem, seed) in small_problems().zip(0..) {
        let (mut tour, near) = tour(&problem);
        let (mut queue, mut rng) = (queue::Queue::new(8), seeded(seed));
        for _ in 0..200 {
            let before = tour.cost();
            match ruin_recreate::ruin_recreate(&mut tour, &near, &mut queue, &mut rng) {
                Some(change) => assert!(tour.cost_is(before + change), "{seed}"),
                None => tour.undo(),
            }
            assert!(tour.is_feasible(), "{seed}");
            tour.commit();
        }
    }
}

#[test]
fn entries_chosen_together_are_the_best_of_all() {
    for (problem, seed) in small_problems().zip(0..) {
        let (mut tour, near) = tour(&problem);
        let (mut queue, mut rng) = (queue::Queue::new(8), seeded(seed));
        for _ in 0..5 {
            if ruin_recreate::ruin_recreate(&mut tour, &near, &mut queue, &mut rng).is_none() {
                tour.undo();
            }
            let snapshot = tour.current().clone();
            let mut least = f64::INFINITY;
            let counts: Vec<usize> =
                (0..).take(snapshot.at.len()).map(|i| tour.space.places(i).len()).collect();
            for which in 0..counts.iter().product::<usize>() {
                let mut left = which;
                let mut other = snapshot.clone();
                for (at, &count) in other.at.iter_mut().zip(&counts) {
                    *at = index::index(left % count);
                    left /= count;
                }
                tour.restore(other);
                least = least.min(tour.cost());
            }
            tour.restore(snapshot);
            let cost = tour.cost();
            let gain = entries::Layers::default().enter_best(&mut tour, cost, |_| ());
            assert!(
                tour.cost_is(least) && tour.cost_is(cost - gain),
                "{seed}: {} is not {least}",
                tour.cost()
            );
        }
    }
}

#[test]
fn recombination_leaves_no_cheaper_stretch_in_the_other_tour() {
    let mut recombined = 0;
    for (problem, seed) in small_problems().zip(0..) {
        let (mut tour, near) = tour(&problem);
        let (mut queue, mut rng) = (queue::Queue::new(8), seeded(seed));
        for _ in 0..20 {
            let other = tour.current().clone();
            for _ in 0..3 {
                if ruin_recreate::ruin_recreate(&mut tour, &near, &mut queue, &mut rng).is_none() {
                    tour.undo();
                }
                tour.commit();
            }
            let before = tour.cost();
            let passes = std::iter::from_fn(|| Some(recombine::recombine(&mut tour, &mut queue, &other)));
            let gain: f64 = passes.take_while(|&gain| gain > 0.0).sum();
            recombined += usize::from(gain > crate::solve::epsilon::EPSILON);
            assert!(tour.cost_is(before - gain), "{seed}");
            assert!(tour.is_feasible(), "{seed}");
            // Every stretch of the same items, put in the other's order with its entries.
            let (snapshot, cost) = (tour.current().clone(), tour.cost());
            let last = tour.last();
            for (from, to) in (1..=last).flat_map(|from| (from..=last).map(move |to| (from, to))) {
                let set = |order: &[u32]| {
                    let mut set = order.to_vec();
                    set.sort_unstable();
                    set
                };
                let length = to - from + 1;
                let Some(there) = (1..=last + 1 - length)
                    .find(|&k| set(&other.order[k..k + length]) == set(&snapshot.order[from..=to]))
                else {
                    continue;
                };
                let mut taken = snapshot.clone();
                taken.order[from..=to].copy_from_slice(&other.order[there..there + length]);
                taken.order[from..=to].iter().for_each(|&i| taken.at[i as usize] = other.at[i as usize]);
                tour.restore(taken);
                assert!(tour.cost() >= cost - 1e-6, "{seed}: {from} to {to}");
            }
            tour.restore(snapshot);
        }
    }
    assert!(recombined > 100, "{recombined}");
}
