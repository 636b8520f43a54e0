//! The bound by stops, for contours that may be left and for pierce groups: against exact optima of small problems, against the
//! published optima of partial cutting, and against every plan that a search finds; and its certificates.
#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

use crate::groups_left;
use crate::solve_partial::{at_corners, hull};
use crate::testkit::sheets::{XorShift, machine, nested_sheet, p};
use kerfway::geometry::DVec2;
use kerfway::job::problem_of;
use kerfway::machine::{AirTime, Profile};
use kerfway::plan::{self, CertificateFault, Certified, StopBound};
use kerfway::problem::{Item, Node, NodeId, Problem};
use kerfway::solve;
use std::cmp::Reverse;
use std::collections::{BinaryHeap, HashMap};

/// The bound after so much work; its certificate is what it says.
fn bound(problem: &Problem, work: u32) -> StopBound {
    let mut bound = StopBound::new(problem).unwrap();
    let (mut last, mut left) = (bound.value(), work);
    while left > 0 && bound.improve(left.min(1_000_000)) {
        assert!(bound.value() >= last, "it only rises");
        (last, left) = (bound.value(), left.saturating_sub(1_000_000));
    }
    match bound.certificate() {
        Some(proof) => assert_eq!(proof.check(problem).map(f64::to_bits), Ok(bound.value().to_bits())),
        None => assert!(bound.value() == 0.0),
    }
    bound
}

/// Scattered contours of a few nodes, most of which may be left, and open ones.
fn scattered(rng: &mut XorShift, k: u64) -> Problem {
    let names = ["length", "length-chebyshev", "co2-100w", "fibre-3kw-thin"];
    let mut machine = machine(names[usize::try_from(k).unwrap() % names.len()]);
    machine.return_home = k.is_multiple_of(2);
    let (mut items, mut nodes) = (Vec::new(), Vec::<Node>::new());
    for item in 0..1 + u32::try_from(k % 3).unwrap() {
        let first = NodeId::try_from(nodes.len()).unwrap();
        let corner = p(rng.below(300) as f64, rng.below(200) as f64);
        let open = k % 7 == 3 && item == 0;
        let count = if open { 2 } else { 2 + u32::try_from(rng.below(4)).unwrap() };
        let size = [20, 150, 400][usize::try_from(k / 3 % 3).unwrap()];
        let places: Vec<DVec2> =
            (0..count).map(|_| corner + p(rng.below(size) as f64, rng.below(size) as f64)).collect();
        for (place, id) in places.iter().zip(first..) {
            let exit = if open { places[usize::from(id == first)] } else { *place };
            let twin = if open { first + 1 - (id - first) } else { id };
            let along = f64::from(id - first) * 10.0;
            nodes.push(Node { item, entry: *place, exit, along, reversed: open && id > first, twin });
        }
        // Seconds, or mm where a second is a mm.
        let leave = [0.0, 0.02, 10.0][usize::try_from(k / 9 % 3).unwrap()];
        items.push(Item {
            nodes: first..NodeId::try_from(nodes.len()).unwrap(),
            leave: (!open && k % 11 != 5).then_some(leave),
            ..Item::default()
        });
    }
    if items.iter().all(|i| i.leave.is_none()) {
        items.push(Item { nodes: 0..0, leave: Some(0.0), ..Item::default() });
    }
    Problem { items, nodes, home: DVec2::ZERO, closed: machine.return_home, ..Problem::empty(machine) }
}

/// Least seconds of all ways to cut the contours of a problem from node to node, leaving and resuming any of them at any time: the
/// shortest way through all states.
fn shortest(problem: &Problem) -> f64 {
    #[derive(Clone, PartialEq, Eq, Hash, PartialOrd, Ord)]
    struct State {
        /// By item: untouched, or entered at one node and cut to another, or done.
        items: Vec<Option<(u32, u32, bool)>>,
        /// The node of whose exit the head is, or home.
        head: Option<u32>,
    }
    let air = AirTime::new(&problem.machine);
    let seconds = |a: DVec2, b: DVec2| air.seconds(a, b);
    let start = State { items: vec![None; problem.items.len()], head: None };
    let mut least = HashMap::from([(start.clone(), 0.0)]);
    let mut queue = BinaryHeap::from([(Reverse(0_u64), start)]);
    let mut best = f64::INFINITY;
    while let Some((Reverse(bits), state)) = queue.pop() {
        let so_far = f64::from_bits(bits);
        if least[&state] < so_far || so_far >= best {
            continue;
        }
        let here = state.head.map_or(problem.home, |n| problem.nodes[n as usize].exit);
        let done = |(i, s): (&Item, &Option<(u32, u32, bool)>)| i.nodes.is_empty() || s.is_some_and(|s| s.2);
        if problem.items.iter().zip(&state.items).all(done) {
            best = best.min(so_far + if problem.closed { seconds(here, problem.home) } else { 0.0 });
            continue;
        }
        for (k, item) in problem.items.iter().enumerate() {
            // Where it may be arrived at, with the node of its first entry, and what resuming costs.
            let arrivals: Vec<(u32, u32, f64)> = match state.items[k] {
                None => item.nodes.clone().map(|n| (n, n, 0.0)).collect(),
                Some((_, _, true)) => Vec::new(),
                Some((entry, at, false)) => vec![(at, entry, item.leave.unwrap())],
            };
            for (at, entry, resumed) in arrivals {
                let there = so_far + seconds(here, problem.nodes[at as usize].entry) + resumed;
                let mut offer = |to: u32, done: bool| {
                    let mut next = State { head: Some(to), ..state.clone() };
                    next.items[k] = Some((entry, to, done));
                    let known = least.entry(next.clone()).or_insert(f64::INFINITY);
                    if there < *known {
                        *known = there;
                        queue.push((Reverse(there.to_bits()), next));
                    }
                };
                let mut to = at;
                loop {
                    to = if to + 1 < item.nodes.end { to + 1 } else { item.nodes.start };
                    if to == entry || item.leave.is_none() {
                        offer(entry, true);
                        break;
                    }
                    offer(to, false);
                }
            }
        }
    }
    best
}

/// Never above the optimum over all ways, and near it.
#[test]
fn contours_that_may_be_left_at_their_nodes() {
    let mut rng = XorShift::new(30);
    let (mut sum, mut sum_least) = (0.0, 0.0);
    for k in 0..900 {
        let problem = scattered(&mut rng, k);
        let least = shortest(&problem);
        let found = bound(&problem, 400_000).value();
        assert!(found <= least * (1.0 + 1e-12) + 1e-12, "{k}: {found} above {least}");
        if least > 0.0 {
            (sum, sum_least) = (sum + found / least, sum_least + 1.0);
        }
    }
    assert!(sum >= 0.9 * sum_least, "{sum} of {sum_least} proven");
}

/// The exact optima of partial cutting of 20 sheets, with entries at corners.
#[test]
fn published_optima_of_partial_cutting() {
    let machine = machine("length-partial");
    for (name, enough) in [("hull-5-20", 0.95), ("hull-10-45", 0.85)] {
        let mut sum = 0.0;
        for (sheet, optimum) in hull(name) {
            let found = bound(&at_corners(&sheet, &machine), 20_000_000).value();
            assert!(found <= optimum + 1e-6, "{name}: {found} above {optimum}");
            sum += 0.1 * found / optimum;
        }
        assert!(sum >= enough, "{name}: {sum} proven");
    }
}

/// Entries and leaves anywhere, on machines where they cost seconds or nothing: no plan of a search is below the bound.
#[test]
fn no_plan_is_below_the_bound() {
    let (mut sum, mut worst) = (0.0, f64::INFINITY);
    for seed in 0..60 {
        let names = ["length-partial", "co2-100w", "fibre-3kw-thin"];
        let mut machine = machine(names[usize::try_from(seed).unwrap() % names.len()]);
        machine.return_home = seed % 4 != 0;
        machine.pre_cut_time = Some([0.0, 0.05, 2.0][usize::try_from(seed / 3).unwrap() % 3]);
        let sheet = nested_sheet(2 + usize::try_from(seed).unwrap() % 12, seed);
        let problem = problem_of(&sheet, &machine);
        let found = bound(&problem, 16_000_000).value();
        let mut search = solve::methods()[0].start(&problem, seed, None);
        for _ in 0..10 {
            search.step(10_000);
            let plan = plan::from_solution(&sheet, &problem, search.best());
            plan::check(&sheet, &machine, &plan).unwrap();
            assert!(plan.summary.total_time >= problem.paid() + found, "{seed}");
            assert!(search.best().cost >= found, "{seed}");
        }
        let proven = found / search.best().cost;
        (sum, worst) = (sum + proven, proven.min(worst));
    }
    assert!(sum > 0.5 * 60.0 && worst > 0.2, "{sum} of 60, {worst} at worst");
}

/// Least seconds beyond what every plan pays, over all paths of one group, all of its leave points, and all orders of slits.
fn shortest_with_a_group(problem: &Problem) -> f64 {
    let group = problem.items.iter().position(|i| i.is_pierce_group() && !i.nodes.is_empty()).unwrap();
    let item = &problem.items[group];
    let slits: Vec<&Item> =
        problem.items.iter().filter(|i| !i.is_pierce_group() && !i.nodes.is_empty()).collect();
    let air = AirTime::new(&problem.machine);
    let mut best = f64::INFINITY;
    for path in &item.paths {
        // Places: ends of slits, what follows each leave point, and where the path ends; the last two with the leave points passed.
        let count = path.leave_points.len();
        let mut layer: HashMap<(usize, usize, u64), f64> = HashMap::new();
        let mut queue = BinaryHeap::from([(Reverse(0_u64), 0_usize, 0_usize, 0_u64)]);
        // Stage 0: not begun; 1 + k: left at leave point k; count + 1: done. `at`: 0 home, 1 the group, 2 + node of a slit.
        layer.insert((0, 0, 0), 0.0);
        while let Some((Reverse(bits), stage, mask, at)) = queue.pop() {
            let so_far = f64::from_bits(bits);
            if layer[&(stage, mask, at)] < so_far || so_far >= best {
                continue;
            }
            let here = match at {
                0 => problem.home,
                1 if stage == count + 1 => path.ends[1],
                1 => path.leave_points[stage - 1].ends[0],
                node => problem.nodes[usize::try_from(node).unwrap() - 2].exit,
            };
            let mut offer = |stage: usize, mask: usize, at: u64, seconds: f64| {
                // Leave points that save an air move are given before it is made: costs stay above 0 by this.
                let known = layer.entry((stage, mask, at)).or_insert(f64::INFINITY);
                if seconds < *known {
                    *known = seconds;
                    queue.push((Reverse(seconds.max(0.0).to_bits()), stage, mask, at));
                }
            };
            if stage == count + 1 && mask + 1 == 1 << slits.len() {
                let back = if problem.closed { air.seconds(here, problem.home) } else { 0.0 };
                best = best.min(so_far + back);
            }
            for (s, slit) in slits.iter().enumerate().filter(|s| mask >> s.0 & 1 == 0) {
                for node in slit.nodes.clone() {
                    let there = air.seconds(here, problem.nodes[node as usize].entry);
                    offer(stage, mask | 1 << s, u64::from(node) + 2, so_far + there);
                }
            }
            if stage <= count && at != 1 {
                let (from, paid) = match stage {
                    0 => (path.ends[0], path.seconds - item.least()),
                    k => (path.leave_points[k - 1].ends[1], 0.0),
                };
                let there = so_far + air.seconds(here, from) + paid;
                for next in stage + 1..=count {
                    offer(next, mask, 1, there + path.leave_points[next - 1].seconds);
                }
                offer(count + 1, mask, 1, there);
            }
        }
    }
    best
}

/// Pierce groups that may be left: never above the optimum over the paths through them, and no longer nothing.
#[test]
fn pierce_groups() {
    let (mut sum, mut count) = (0.0, 0.0);
    for seed in 0..120 {
        let (parts, slits) = groups_left::random(seed);
        let job = groups_left::load(&parts, &slits[..slits.len().min(4)]);
        let machine = Profile { return_home: seed % 2 == 0, ..groups_left::plate() };
        let mut problem = problem_of(job.sheet(), &machine);
        let groups = problem.items.iter().filter(|i| i.is_pierce_group() && !i.nodes.is_empty()).count();
        if groups != 1 {
            continue;
        }
        if seed % 3 == 1 {
            problem = groups_left::in_one_go(&problem);
        }
        let least = shortest_with_a_group(&problem);
        let found = bound(&problem, 2_000_000).value();
        assert!(found <= least + 1e-9, "{seed}: {found} above {least}");
        let mut search = solve::methods()[0].start(&problem, 1, None);
        search.step(20_000);
        let paid: f64 = problem.items.iter().map(|i| i.least() - i.fixed).sum();
        assert!(search.best().cost >= paid + found - 1e-9, "{seed}");
        (sum, count) = (sum + found / least, count + 1.0);
    }
    assert!(count >= 60.0 && sum >= 0.7 * count, "{sum} of {count} proven");
}

#[test]
fn it_does_not_apply_where_contours_are_cut_in_one_go() {
    let problem = problem_of(&nested_sheet(5, 1), &machine("length"));
    assert!(StopBound::new(&problem).is_none());
}

/// Whatever the slices, the bytes are the same.
#[test]
fn however_it_is_sliced() {
    let problem = problem_of(&nested_sheet(9, 4), &machine("length-partial"));
    let [a, b] = [3_150_000, 70_000].map(|slice: u32| {
        let mut bound = StopBound::new(&problem).unwrap();
        (0..12_600_000 / slice).for_each(|_| {
            bound.improve(slice);
        });
        bound.value()
    });
    assert_eq!(a.to_bits(), b.to_bits());
}

/// Whoever changes a number gets no more than the numbers prove, or a refusal.
#[test]
fn a_changed_number_proves_no_more() {
    let problem = problem_of(&nested_sheet(6, 2), &machine("length-partial"));
    let bound = bound(&problem, 4_000_000);
    let proof = bound.certificate().unwrap();
    assert!(!proof.cuts.is_empty());
    let mut refused = 0;
    for k in 0..proof.potentials.len() {
        for by in [-1_000_000_000, 1_000_000_000] {
            let mut changed = proof.clone();
            changed.potentials[k][0] += by;
            match changed.check(&problem) {
                Ok(seconds) => assert_eq!(seconds.to_bits(), bound.value().to_bits()),
                Err(CertificateFault::Bound { .. } | CertificateFault::Overpaid(_)) => refused += 1,
                Err(other) => unreachable!("{other}"),
            }
        }
    }
    assert!(refused > proof.potentials.len(), "{refused}");
    let mut above = proof.clone();
    above.bound += 1;
    assert!(matches!(above.check(&problem), Err(CertificateFault::Bound { .. })));
    for c in 0..proof.cuts.len() {
        let mut changed = proof.clone();
        changed.cuts[c].price += 1_000_000_000_000;
        assert!(changed.check(&problem).is_err());
        let mut changed = proof.clone();
        changed.cuts[c].price = -1;
        assert_eq!(changed.check(&problem), Err(CertificateFault::Shape("cuts")));
        // A place in two parts, and home in one.
        let mut changed = proof.clone();
        let again = changed.cuts[c].parts[0].clone();
        changed.cuts[c].parts.push(again);
        assert_eq!(changed.check(&problem), Err(CertificateFault::Shape("cuts")));
        let mut changed = proof.clone();
        changed.cuts[c].parts[0].members.insert(0, 0);
        assert_eq!(changed.check(&problem), Err(CertificateFault::Shape("cuts")));
    }
    let mut changed = proof.clone();
    changed.knots[1][0] += 0.5;
    assert!(changed.check(&problem).is_err());
    let mut changed = proof.clone();
    changed.unit += 1;
    assert_eq!(changed.check(&problem), Err(CertificateFault::Shape("units")));
}
