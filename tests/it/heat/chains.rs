//! Chains and starts on kerfs where cuts heat each other: what the search finds beside every order, entry and beginning, and what the checker says.

use super::{charged, waiting};
use crate::chains::{chain_seconds, chaining, squares, starting};
use crate::testkit::leads::oriented;
use crate::testkit::searches::{searched, slices_of_any_size_find_the_same};
use crate::testkit::sheets::{Builder, XorShift, circle, p, rectangle};
use kerfway::geometry::{DVec2, distance};
use kerfway::job::problem_of;
use kerfway::machine::dialect::{DialectChoice, dialects};
use kerfway::machine::{AirTime, Heat, Profile, Start};
use kerfway::output::{self, SheetFacts};
use kerfway::plan::{self, Move, Plan, Violation};
use kerfway::problem::Problem;
use kerfway::sheet::Sheet;

/// A machine with chains that minds heat.
fn heated(mut machine: Profile, heat: Heat) -> Profile {
    machine.levers.heat = Some(heat);
    machine.validate().unwrap();
    machine
}

/// A cut through waste: the contour on whose kerf it begins, where it does, and its seconds.
type Through = (u32, DVec2, f64);

/// Every order, every choice of nodes, and every way to begin each cut, with waits or charges as the definition says them.
struct Brute<'p> {
    problem: &'p Problem,
    machine: &'p Profile,
    heat: Heat,
    air: AirTime,
    /// By pair of contours: whether their lines come nearer than asked.
    near: Vec<Vec<bool>>,
    /// By node: the cuts through waste that lead to it.
    through: Vec<Vec<Through>>,
    /// By contour: the seconds of its cut from its cheapest entry.
    cuts: Vec<f64>,
    /// Whether each cut is begun as is best by itself; otherwise in every way.
    by_itself: bool,
    /// The contours so far with the seconds at which they ended.
    ended: Vec<(u32, f64)>,
    best: f64,
}

impl Brute<'_> {
    /// What is due before a cut that begins at `begins` s: the wait, and the charge.
    fn due(&self, contour: u32, begins: f64) -> (f64, f64) {
        let sooner = |e: &&(u32, f64)| {
            self.near[contour as usize][e.0 as usize] && begins - e.1 < self.heat.seconds - 1e-7
        };
        let due: Vec<f64> =
            self.ended.iter().filter(sooner).map(|e| e.1 + self.heat.seconds - begins).collect();
        match self.heat.charge {
            Some(charge) => (0.0, charge * due.len() as f64),
            None => (due.iter().fold(0.0, |a, b| a.max(*b)), 0.0),
        }
    }

    /// `now`: seconds on the machine; `cost`: what the search minimises so far.
    fn go_on(&mut self, last: Option<(u32, DVec2)>, now: f64, cost: f64) {
        let is_cut = |c: u32| self.ended.iter().any(|e| e.0 == c);
        let left = (0..).zip(&self.cuts).filter(|c| !is_cut(c.0)).map(|c| *c.1).sum::<f64>();
        if cost + left >= self.best {
            return;
        }
        let (problem, machine) = (self.problem, self.machine);
        let head = last.map_or(problem.home, |l| l.1);
        if self.ended.len() == problem.items.len() {
            self.best = self.best.min(cost + self.air.seconds(head, problem.home));
            return;
        }
        let delays = machine.beam_on_delay + machine.beam_off_delay;
        for n in 0..problem.nodes.len() {
            let node = &problem.nodes[n];
            let id = node.item;
            let is_cut = |c: u32| self.ended.iter().any(|e| e.0 == c);
            let inner = (0..).zip(&problem.items).any(|(k, i)| i.before == Some(id) && !is_cut(k));
            if is_cut(id) || inner {
                continue;
            }
            let item = &problem.items[id as usize];
            // The seconds of an item contain its piercing.
            let cut =
                item.fixed + item.extra(u32::try_from(n).unwrap(), node.along) - machine.pierce_time - delays;
            // Seconds until the cut begins, and from then on, and whether the head may wait before it.
            let mut ways =
                vec![(self.air.seconds(head, node.entry), machine.pierce_time + delays + cut, true)];
            for &(kerf, from, seconds) in &self.through[n] {
                if last == Some((kerf, from)) {
                    ways.push((0.0, seconds + cut, false));
                }
                if machine.levers.chains.unwrap().edge_starts && is_cut(kerf) {
                    ways.push((self.air.seconds(head, from), delays + seconds + cut, true));
                }
            }
            let mut found: Vec<(f64, f64)> = Vec::new();
            for (until, after, may_wait) in ways {
                let (wait, charge) = self.due(id, now + until);
                if may_wait || wait == 0.0 {
                    let seconds = until + wait + after;
                    found.push((seconds, seconds + charge));
                }
            }
            if self.by_itself {
                found.sort_by(|a, b| a.1.total_cmp(&b.1));
                found.truncate(1);
            }
            for (seconds, price) in found {
                self.ended.push((id, now + seconds));
                self.go_on(Some((id, node.exit)), now + seconds, cost + price);
                self.ended.pop();
            }
        }
    }
}

/// What brute force finds below `most` seconds. `slope`: how steeply cuts through waste leave their contours at least.
fn brute(sheet: &Sheet, machine: &Profile, slope: f64, by_itself: bool, most: f64) -> f64 {
    let problem = &problem_of(sheet, machine);
    let heat = machine.levers.heat.unwrap();
    let apart = |a: usize, b: usize| {
        let (a, b) = (&sheet.contours[a].path, &sheet.contours[b].path);
        let pairs = a.segments.iter().flat_map(|s| b.segments.iter().map(|o| distance(s, o).0));
        pairs.fold(f64::INFINITY, f64::min)
    };
    let count = sheet.contours.len();
    let near = (0..count).map(|a| (0..count).map(|b| apart(a, b) < heat.distance).collect()).collect();
    let edges = machine.levers.chains.unwrap().edge_starts;
    let mut through: Vec<Vec<Through>> = vec![Vec::new(); problem.nodes.len()];
    for (to, through) in problem.nodes.iter().zip(&mut through) {
        for (id, contour) in (0..).zip(&sheet.contours).filter(|c| c.0 != to.item) {
            let own = problem.items[id as usize].nodes.clone().map(|n| problem.nodes[n as usize].exit);
            let near = contour.path.segments.iter().map(|s| (s.nearest(to.entry), s));
            let near = near.min_by(|a, b| a.0.1.total_cmp(&b.0.1)).map(|((t, _), s)| s.at(t));
            for place in own.chain(near.filter(|_| edges)) {
                let seconds = chain_seconds(sheet, machine, [id, to.item], place, to.entry, slope);
                through.extend(seconds.map(|s| (id, place, s)));
            }
        }
    }
    let start = machine.pierce_time + machine.beam_on_delay + machine.beam_off_delay;
    let cuts = problem.items.iter().map(|i| i.fixed - start).collect();
    let (air, ended) = (AirTime::new(machine), Vec::new());
    let mut brute = Brute { problem, machine, heat, air, near, through, cuts, by_itself, ended, best: most };
    brute.go_on(None, 0.0, 0.0);
    brute.best
}

/// Some rectangles and discs side by side, of which some are near each other.
fn few(seed: u64) -> Sheet {
    let mut rng = XorShift::new(900 + seed);
    let mut b = Builder::new();
    for k in 0..3 + seed % 2 {
        let at = p((k % 2) as f64, (k / 2) as f64) * 30.0
            + p(10.0 + rng.between(0.0, 8.0), 10.0 + rng.between(0.0, 8.0));
        if rng.below(3) == 0 {
            b.cut(circle(at + p(9.0, 9.0), rng.between(5.0, 9.0)), None);
        } else {
            b.cut(rectangle(at, p(rng.between(10.0, 18.0), rng.between(10.0, 18.0))), None);
        }
    }
    oriented(b.sheet)
}

#[test]
fn chains_beside_heat_are_as_good_as_every_order_entry_and_beginning() {
    let (mut chains, mut edges, mut waits, mut hot, mut same, mut all) = (0, 0, 0, 0, 0, 0);
    let mut found_again = 0;
    for seed in 0..4_u64 {
        let sheet = few(seed);
        for heat in [waiting(9.0, 1.5), waiting(14.0, 4.0), charged(14.0, 2.0, 0.3), charged(30.0, 4.0, 0.05)]
        {
            for machine in [chaining(25.0, 1.0), starting(25.0, 1.0)] {
                let machine = heated(machine, heat);
                let (found, plan) = searched(&sheet, &machine, 500_000, seed);
                let problem = problem_of(&sheet, &machine);
                let cost = found.cost + problem.items.iter().map(|i| i.fixed).sum::<f64>();
                let sums = &plan.summary;
                let charge = heat.charge.unwrap_or(0.0) * f64::from(sums.hot_pairs);
                let counted = sums.total_time + charge;
                assert!((counted - cost).abs() < 1e-6, "seed {seed}, {heat:?}: {counted} s, not {cost} s");
                // The planner leaves contours a little more steeply than the checker demands.
                let most = brute(&sheet, &machine, 0.375, true, cost + 1.0);
                let least = brute(&sheet, &machine, 0.25, true, cost + 1e-6);
                // Contours that are not joined to others are entered anywhere by the search, and at their nodes here.
                let at_nodes = problem.items.iter().all(|i| i.track.is_none());
                assert!(
                    (least <= cost + 1e-8 || !at_nodes) && cost <= most + 1e-6,
                    "seed {seed}, {heat:?}: {least} {cost} {most}"
                );
                found_again += u32::from(at_nodes);
                let free = brute(&sheet, &machine, 0.375, false, cost + 1e-6);
                same += u32::from(free >= cost - 1e-6);
                all += 1;
                chains += sums.chains - sums.edge_starts;
                (edges, waits, hot) = (edges + sums.edge_starts, waits + sums.waits, hot + sums.hot_pairs);
            }
        }
    }
    assert!(chains > 60 && edges > 2 && waits > 3 && hot > 20, "{chains} {edges} {waits} {hot}");
    // Begun in any other way, some cut may let a later one begin sooner. Here none does.
    assert!(all == 32 && same == all && found_again > 28, "{same} and {found_again} of {all}");
}

/// The chains that begin where the cut before them ends, and those that begin on a kerf after a wait.
fn begun(plan: &Plan) -> (usize, usize) {
    let is = |of: fn(&[Move]) -> bool| plan.moves.windows(2).filter(|w| of(w)).count();
    (
        is(|w| matches!(w, [Move::Cut { .. }, Move::Chain { .. }])),
        is(|w| matches!(w, [Move::Wait { .. }, Move::Chain { .. }])),
    )
}

#[test]
fn chains_are_made_where_the_rule_allows_them() {
    let squares = || oriented(squares(2, 2, 8.0).sheet);
    let chained = |machine: Profile, heat: Heat| searched(&squares(), &heated(machine, heat), 100_000, 1).1;
    // What is not near is joined as without heat, and what is near only where it is paid for.
    let apart = chained(chaining(30.0, 1.0), waiting(7.9, 3.0));
    assert_eq!((begun(&apart), apart.summary.waits, apart.summary.pierces), ((3, 0), 0, 1));
    // Those across a corner are 11.3 mm apart.
    let across = chained(chaining(30.0, 1.0), waiting(8.1, 3.0));
    assert_eq!((begun(&across).0, across.summary.pierces), (2, 2), "{:?}", across.summary);
    let near = chained(chaining(30.0, 1.0), waiting(12.0, 3.0));
    assert_eq!((begun(&near), near.summary.waits, near.summary.pierces), ((0, 0), 3, 4));
    let paid = chained(chaining(30.0, 1.0), charged(12.0, 3.0, 0.1));
    assert_eq!((begun(&paid), paid.summary.pierces), ((3, 0), 1));
    assert!(paid.summary.hot_pairs > 0);
    // On a kerf the head waits, and then nothing is pierced.
    let kerfs = chained(starting(30.0, 1.0), waiting(12.0, 3.0));
    assert_eq!((begun(&kerfs), kerfs.summary.edge_starts, kerfs.summary.pierces), ((0, 3), 3, 1));
}

#[test]
fn chains_that_begin_too_soon_are_found() {
    let sheet = oriented(squares(2, 2, 8.0).sheet);
    let not_sums = |machine: &Profile, plan: &Plan| {
        let all = plan::check(&sheet, machine, plan).err().unwrap_or_default();
        let is_sum = |v: &Violation| matches!(v, Violation::Sum { what, .. } if !what.contains("hot pairs"));
        all.into_iter().filter(|v| !is_sum(v)).collect::<Vec<_>>()
    };
    let charging = heated(chaining(30.0, 1.0), charged(12.0, 3.0, 0.1));
    let mut paid = searched(&sheet, &charging, 100_000, 1).1;
    // The same chains on a machine that waits: each begins at once.
    let mut free = paid.clone();
    free.summary.hot_pairs = 0;
    let found = not_sums(&heated(chaining(30.0, 1.0), waiting(12.0, 3.0)), &free);
    let at_once = |v: &&Violation| matches!(v, Violation::Hot { seconds, .. } if *seconds == 0.0);
    assert_eq!(found.iter().filter(at_once).count(), 3, "{found:?}");
    // One pair more than there are.
    paid.summary.hot_pairs += 1;
    assert!(matches!(not_sums(&charging, &paid)[..], [Violation::Sum { .. }]));
    // Starts on kerfs with a shorter wait, a longer one, and none.
    let machine = heated(starting(30.0, 1.0), waiting(12.0, 3.0));
    let plan = searched(&sheet, &machine, 100_000, 1).1;
    let at = plan.moves.iter().position(|m| matches!(m, Move::Wait { .. })).unwrap();
    let Move::Wait { seconds } = plan.moves[at] else { unreachable!() };
    let changed = |seconds: f64| {
        let mut other = plan.clone();
        other.moves[at] = Move::Wait { seconds };
        not_sums(&machine, &other)
    };
    assert_eq!(changed(seconds), []);
    assert!(matches!(changed(seconds - 1e-3)[..], [Violation::Hot { .. }]));
    assert!(changed(seconds + 1e-3).contains(&Violation::NeedlessWait { step: at }));
    let mut other = plan.clone();
    other.moves.remove(at);
    assert!(not_sums(&machine, &other).iter().any(|v| matches!(v, Violation::Hot { .. })));
}

#[test]
fn larger_sheets_with_chains_and_heat_pass() {
    let mut made = (0, 0);
    for (k, heat) in [waiting(6.0, 2.0), waiting(45.0, 3.0), charged(20.0, 3.0, 0.2)].into_iter().enumerate()
    {
        for machine in [chaining(30.0, 1.0), starting(30.0, 1.0)] {
            let machine = heated(machine, heat);
            let sheet = oriented(squares(5, 4, 8.0).sheet);
            let plan = searched(&sheet, &machine, 60_000, k as u64).1;
            slices_of_any_size_find_the_same(&problem_of(&sheet, &machine));
            let s = &plan.summary;
            made = (made.0 + s.chains, made.1 + s.hot_pairs);
        }
    }
    assert!(made.0 > 20 && made.1 > 5, "{made:?}");
}

#[test]
fn every_dialect_waits_on_kerfs_and_chains_at_a_charge() {
    let sheet = oriented(squares(2, 2, 8.0).sheet);
    let (mut written, mut refused) = (0, 0);
    for (heat, waits) in [(waiting(12.0, 3.0), 3), (charged(12.0, 3.0, 0.1), 0)] {
        for dialect in dialects().iter().filter(|d| d.pierce.is_some()) {
            let dialect = DialectChoice::named(&dialect.name);
            let machine = Profile { dialect, ..heated(starting(30.0, 1.0), heat) };
            let plan = searched(&sheet, &machine, 100_000, 1).1;
            assert_eq!((plan.summary.waits, plan.summary.pierces, plan.summary.chains), (waits, 1, 3));
            match output::gcode(&plan, &SheetFacts::of(&sheet), &machine, "plan.dxf", Start::Absolute) {
                Ok(text) => {
                    let check = output::check_against(&text, &machine, &plan).unwrap();
                    assert!(check.passed && check.parts == 4, "{:?}", check.problems);
                    assert_eq!(text.matches("until it has cooled").count(), waits as usize);
                    let on_kerfs = text.matches("from a kerf or an edge through waste for ").count();
                    assert_eq!(on_kerfs, waits as usize);
                    written += 1;
                }
                Err(e) => {
                    assert!(waits > 0 && e.to_string().contains("levers.heat"), "{e}");
                    refused += 1;
                }
            }
        }
    }
    // Some cannot wait where the beam goes off, because it goes off with the next motion only.
    assert!(written > 12 && (1..=6).contains(&refused), "{written} {refused}");
}
