//! What the search finds where cuts heat each other.

use super::{charged, heated, waiting};
use crate::testkit::searches::{searched, slices_of_any_size_find_the_same};
use crate::testkit::sheets::{Builder, XorShift, circle, line, nested_sheet, p, rectangle};
use kerfway::geometry::distance;
use kerfway::job::problem_of;
use kerfway::machine::{Heat, Levers, Lift, Profile, Tips, air_time};
use kerfway::plan::{self, Plan};
use kerfway::problem::{Item, Node, Problem};
use kerfway::sheet::Sheet;

/// Every order and every choice of entries at nodes, with waits or charges as the definition says them.
struct BruteForce<'p> {
    problem: &'p Problem,
    heat: Heat,
    /// By pair of contours: whether their lines come nearer than asked.
    near: Vec<Vec<bool>>,
    items: Vec<u32>,
    /// The contours so far with the seconds at which they ended.
    ended: Vec<(u32, f64)>,
    /// The least seconds, and the least hot pairs of any order and entries.
    least: f64,
    least_hot: u32,
}

impl<'p> BruteForce<'p> {
    fn new(sheet: &Sheet, machine: &'p Profile, problem: &'p Problem) -> Self {
        let heat = machine.levers.heat.unwrap();
        let apart = |a: usize, b: usize| {
            let (a, b) = (&sheet.contours[a].path, &sheet.contours[b].path);
            a.segments
                .iter()
                .flat_map(|s| b.segments.iter().map(|o| distance(s, o).0))
                .fold(f64::INFINITY, f64::min)
        };
        let count = sheet.contours.len();
        let near = (0..count).map(|a| (0..count).map(|b| apart(a, b) < heat.distance).collect()).collect();
        let items =
            (0..).zip(&problem.items).filter(|(_, i)| !i.nodes.is_empty()).map(|(id, _)| id).collect();
        Self { problem, heat, near, items, ended: Vec::new(), least: f64::INFINITY, least_hot: u32::MAX }
    }

    fn solve(mut self) -> (f64, u32) {
        self.go_on(self.problem.home, 0.0, 0.0, 0);
        (self.least, self.least_hot)
    }

    /// `now`: seconds on the machine; `cost`: what the search minimises so far, without what every plan pays.
    fn go_on(&mut self, head: kerfway::geometry::DVec2, now: f64, cost: f64, hot: u32) {
        let problem = self.problem;
        if self.ended.len() == self.items.len() {
            let home = if problem.closed { air_time(&problem.machine, head, problem.home) } else { 0.0 };
            self.least = self.least.min(cost + home);
            self.least_hot = self.least_hot.min(hot);
            return;
        }
        // No order and entries can make up for more than has been spent.
        if cost >= self.least && hot >= self.least_hot {
            return;
        }
        for id in self.items.clone() {
            let item: &Item = &problem.items[id as usize];
            let is_cut = |c: u32| self.ended.iter().any(|e| e.0 == c);
            let waits = |&o: &u32| {
                let other: &Item = &problem.items[o as usize];
                !is_cut(o) && (other.before == Some(id) || other.rank < item.rank)
            };
            if is_cut(id) || self.items.iter().any(waits) {
                continue;
            }
            for node in item.nodes.clone() {
                let n: &Node = &problem.nodes[node as usize];
                let air = air_time(&problem.machine, head, n.entry);
                let arrival = now + air;
                let sooner = |e: &&(u32, f64)| {
                    self.near[id as usize][e.0 as usize] && arrival - e.1 < self.heat.seconds - 1e-9
                };
                let due: Vec<f64> =
                    self.ended.iter().filter(sooner).map(|e| e.1 + self.heat.seconds - arrival).collect();
                let pairs = u32::try_from(due.len()).unwrap();
                let wait = due.iter().fold(0.0, |a: f64, b| a.max(*b));
                let (wait, charge) = self.heat.charge.map_or((wait, wait), |c| (0.0, c * f64::from(pairs)));
                let extra = item.extra(node, n.along);
                let end = arrival + wait + item.fixed + extra;
                self.ended.push((id, end));
                self.go_on(n.exit, end, cost + air + extra + charge, hot + pairs);
                self.ended.pop();
            }
        }
    }
}

/// Some contours close together and others far away, of few entries: slits, and circles.
fn few(seed: u32) -> Sheet {
    let mut rng = XorShift::new(u64::from(seed) + 100);
    let mut b = Builder::new();
    for k in 0..4 + seed % 3 {
        let at = p(rng.between(30.0, 230.0), rng.between(30.0, 130.0));
        let to = at + p(rng.between(5.0, 20.0), rng.between(-15.0, 15.0));
        if k == 0 && seed.is_multiple_of(2) {
            let frame = b.cut(rectangle(p(20.0, 10.0), p(70.0, 60.0)), None);
            b.cut(line(p(40.0, 30.0), p(60.0, 30.0)), Some(frame));
            continue;
        }
        b.cut(line(at, to), None);
    }
    b.sheet
}

#[test]
fn up_to_six_contours_are_as_good_as_every_order_and_entry() {
    let (mut waits, mut cold, mut hot) = (0, 0, 0);
    for seed in 0..24_u32 {
        let sheet = few(seed);
        for heat in
            [waiting(60.0, 0.3), waiting(40.0, 2.0), charged(60.0, 0.4, 5.0), charged(40.0, 1.0, 0.05)]
        {
            let machine = heated(heat);
            let problem = problem_of(&sheet, &machine);
            let (least, least_hot) = BruteForce::new(&sheet, &machine, &problem).solve();
            let (found, plan) = searched(&sheet, &machine, 300_000, 1);
            assert!(found.cost <= least + 1e-9, "seed {seed}, {heat:?}: {} s, not {least} s", found.cost);
            let fixed: f64 = problem.items.iter().map(|i| i.fixed).sum();
            let sums = &plan.summary;
            let charge = heat.charge.unwrap_or(0.0) * f64::from(sums.hot_pairs);
            // What the search minimises is what the plan says.
            let total = sums.total_time + charge - fixed;
            assert!((total - found.cost).abs() < 1e-6, "seed {seed}: {total} s, {} s", found.cost);
            waits += sums.waits;
            if heat.charge.is_none() {
                assert_eq!(sums.hot_pairs, 0);
            } else if heat.charge > Some(1.0) {
                // A charge that is worth any way leaves no pair where there is an order without.
                assert_eq!(sums.hot_pairs, least_hot, "seed {seed}, {heat:?}");
                cold += u32::from(least_hot == 0);
                hot += u32::from(least_hot > 0);
            }
        }
    }
    assert!(
        waits > 10 && cold > 5 && hot > 2,
        "{waits} waits; {cold} sheets without hot pairs, {hot} with some"
    );
}

/// A grid of small holes, whose neighbours heat each other.
fn grid(side: u32) -> Sheet {
    let mut b = Builder::new();
    for k in 0..side * side {
        b.cut(circle(p(30.0 + 15.0 * f64::from(k % side), 30.0 + 15.0 * f64::from(k / side)), 3.0), None);
    }
    b.sheet
}

#[test]
fn an_order_that_knows_of_heat_is_shorter_than_waiting_afterwards() {
    for (sheet, heat) in [
        (grid(7), waiting(10.0, 3.0)),
        (grid(7), waiting(25.0, 2.0)),
        (nested_sheet(40, 1), waiting(20.0, 3.0)),
        (nested_sheet(40, 2), waiting(60.0, 1.0)),
    ] {
        let machine = heated(heat);
        let plain = Profile { levers: Levers::default(), ..machine.clone() };
        let (path, ignoring) = searched(&sheet, &plain, 300_000, 1);
        let after = plan::from_solution(&sheet, &problem_of(&sheet, &machine), &path);
        assert_eq!(plan::check(&sheet, &machine, &after), Ok(()));
        let (_, knowing) = searched(&sheet, &machine, 300_000, 1);
        let total = |plan: &Plan| plan.summary.total_time;
        assert!(total(&knowing) < 0.9 * total(&after), "{} s, {} s", total(&knowing), total(&after));
        assert!(total(&knowing) >= total(&ignoring) - 0.01 * total(&ignoring));
        assert_eq!(knowing.summary.hot_pairs, 0);
        // With a charge that is worth any way, fewer pairs are left than by a path that does not know of them.
        let dear = heated(Heat { charge: Some(100.0), ..heat });
        let (_, charged) = searched(&sheet, &dear, 300_000, 1);
        let unknowing = plan::from_solution(&sheet, &problem_of(&sheet, &dear), &path);
        assert!(2 * charged.summary.hot_pairs < unknowing.summary.hot_pairs);
        assert_eq!((charged.summary.waits, charged.summary.wait_time), (0, 0.0));
    }
}

#[test]
fn slices_of_any_size_give_the_same_plan() {
    for heat in [waiting(20.0, 2.0), charged(20.0, 2.0, 0.5)] {
        let sheet = nested_sheet(30, 5);
        slices_of_any_size_find_the_same(&problem_of(&sheet, &heated(heat)));
    }
}

#[test]
fn heat_and_tipped_pieces_are_minded_together() {
    let sheet = nested_sheet(30, 3);
    let heat = heated(waiting(20.0, 1.0));
    let lift = Lift { height: 10.0, stay_down: 0.0, at_rest: true };
    let tips = Tips { drops_below: Some(0.0), ..Tips::default() };
    let levers = Levers { lift: Some(lift), tips: Some(tips), ..heat.levers };
    let machine = Profile { levers, z_speed: Some(50.0), ..heat };
    let (found, plan) = searched(&sheet, &machine, 200_000, 1);
    assert_eq!((plan.summary.crossings, plan.summary.hot_pairs), (0, 0));
    assert!(plan.summary.lifts + plan.summary.detours > 0);
    let fixed: f64 = problem_of(&sheet, &machine).items.iter().map(|i| i.fixed).sum();
    assert!((plan.summary.total_time - fixed - found.cost).abs() < 1e-6);
}

#[test]
fn heat_that_reaches_nothing_changes_nothing() {
    let sheet = nested_sheet(30, 2);
    let plain = Profile { levers: Levers::default(), ..heated(waiting(0.0, 1.0)) };
    let same = searched(&sheet, &plain, 50_000, 3);
    for heat in [waiting(0.0, 5.0), waiting(20.0, 0.0)] {
        assert_eq!(searched(&sheet, &heated(heat), 50_000, 3), same);
    }
}
