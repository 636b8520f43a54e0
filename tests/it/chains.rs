//! Chains (`levers.chains`): what they save, where they may be, and what the checker says of plans that do it wrongly.
#![allow(clippy::unwrap_used, clippy::panic, reason = "tests stop where they cannot go on")]

use crate::testkit::dialects::read_back;
use crate::testkit::exact::search_of_exact_cost;
use crate::testkit::gcode;
use crate::testkit::leads::{leads, oriented, with_leads};
use crate::testkit::sheets::{Builder, Dice, circle, line, machine, p, polygon, rectangle};
use kerfway::geometry::{DVec2, Segment};
use kerfway::job::problem_of;
use kerfway::machine::dialect::{DialectChoice, dialects};
use kerfway::machine::{AirTime, Chains, LeadKind, Levers, Profile, Start, cut_time};
use kerfway::output::{self, SheetFacts};
use kerfway::plan::{self, Leads, Move, Plan, Violation};
use kerfway::problem::Problem;
use kerfway::sheet::{Ignored, Sheet};

pub(super) fn chaining(reach: f64, clearance: f64) -> Profile {
    let levers =
        Levers { chains: Some(Chains { reach, clearance, edge_starts: false }), ..Levers::default() };
    Profile { levers, ..machine("fibre-6kw-thick") }
}

/// The same, with cuts through waste that begin on a kerf.
pub(super) fn starting(reach: f64, clearance: f64) -> Profile {
    let levers = Levers { chains: Some(Chains { reach, clearance, edge_starts: true }), ..Levers::default() };
    Profile { levers, ..machine("fibre-6kw-thick") }
}

/// Squares with a side of 20 mm in columns and rows, this far apart.
pub(super) fn squares(columns: u32, rows: u32, gap: f64) -> Builder {
    let mut b = Builder::new();
    for k in 0..columns * rows {
        let at = p(f64::from(k % columns), f64::from(k / columns)) * (20.0 + gap) + p(10.0, 10.0);
        b.cut(rectangle(at, p(20.0, 20.0)), None);
    }
    b
}

pub(super) fn searched(b: Builder, machine: &Profile) -> (Sheet, Plan) {
    let sheet = oriented(b.sheet);
    let (_, _, plan) = search_of_exact_cost(&sheet, machine, 1);
    (sheet, plan)
}

/// The chains of a plan, each with the contours before and after it.
fn chains(plan: &Plan) -> Vec<(u32, Segment, u32)> {
    let three = |w: &[Move]| match w {
        [Move::Cut { contour: a, .. }, Move::Chain { path }, Move::Cut { contour: b, .. }] => {
            Some((*a, path[0], *b))
        }
        _ => None,
    };
    plan.moves.windows(3).filter_map(three).collect()
}

/// The sheet with contours that start where the plan enters them.
fn starting_where_entered(sheet: &Sheet, plan: &Plan) -> Sheet {
    let mut sheet = sheet.clone();
    for step in &plan.moves {
        if let Move::Cut { contour, path, .. } = step {
            let whole = &mut sheet.contours[*contour as usize].path;
            *whole = whole.starting_at(whole.nearest(path[0].start()).unwrap().0);
        }
    }
    sheet
}

#[track_caller]
fn near(a: f64, b: f64) {
    assert!((a - b).abs() <= 1e-9, "{a} is not {b}");
}

#[test]
fn four_corners_that_face_each_other_are_pierced_once() {
    let machine = chaining(30.0, 1.0);
    let (_, plan) = searched(squares(2, 2, 8.0), &machine);
    let s = &plan.summary;
    assert_eq!((s.chains, s.pierces), (3, 1));
    near(s.chain_length, 24.0);
    near(s.cut_length, 4.0 * 80.0 + 24.0);
    let found = chains(&plan);
    assert_eq!(found.len(), 3);
    // Each takes 8 mm from rest to rest in place of the delays, the move and the piercing.
    let chained: f64 = found.iter().map(|c| cut_time(&machine, &machine.cut, &[c.1])).sum();
    let square = cut_time(&machine, &machine.cut, &rectangle(p(0.0, 0.0), p(20.0, 20.0)).segments);
    near(s.cut_time, 4.0 * square + chained);
    near(s.pierce_time, machine.pierce_time + machine.beam_on_delay + machine.beam_off_delay);
    let (_, without) = searched(squares(2, 2, 8.0), &crate::testkit::sheets::machine("fibre-6kw-thick"));
    assert_eq!((without.summary.chains, without.summary.pierces), (0, 4));
    let saved = without.summary.total_time - s.total_time;
    assert!(saved > 3.0 * (1.1 - 8.0 / 33.0 - 0.02), "{saved} s");
}

#[test]
fn a_contour_is_entered_and_left_at_one_place() {
    // So of a row, every second part is pierced.
    let (_, plan) = searched(squares(4, 1, 8.0), &chaining(30.0, 1.0));
    assert_eq!((plan.summary.chains, plan.summary.pierces), (2, 2));
}

#[test]
fn nothing_is_joined_that_is_too_far_away_or_has_no_room() {
    let joined = |b: Builder, machine: &Profile| searched(b, machine).1.summary.chains;
    let two = || squares(2, 1, 8.0);
    assert_eq!(joined(two(), &chaining(30.0, 1.0)), 1);
    assert_eq!(joined(two(), &chaining(8.0, 1.0)), 1);
    assert_eq!(joined(two(), &chaining(7.9, 1.0)), 0);
    // Where piercing takes no time, a chain is slower than a move.
    let quick = Profile { pierce_time: 0.0, beam_on_delay: 0.0, beam_off_delay: 0.0, ..chaining(30.0, 1.0) };
    assert_eq!(joined(two(), &quick), 0);
    // A wall of a thin part, and of an open cut, between the two.
    let mut b = two();
    b.cut(rectangle(p(33.0, -20.0), p(1.0, 80.0)), None);
    let (_, plan) = searched(b, &chaining(100.0, 1.0));
    assert!(chains(&plan).iter().all(|&(a, _, b)| a == 2 || b == 2), "{:?}", chains(&plan));
    let mut b = two();
    b.cut(line(p(34.0, -20.0), p(34.0, 60.0)), None);
    assert_eq!(joined(b, &chaining(100.0, 1.0)), 0);
    // A mark is no obstacle.
    let mut b = two();
    b.mark(line(p(34.0, -20.0), p(34.0, 60.0)), None);
    assert_eq!(joined(b, &chaining(30.0, 1.0)), 1);
    // 8 mm are too narrow for a clearance of 9 mm from a third part, but not the 20 mm to the side of it.
    let mut b = two();
    b.cut(rectangle(p(10.0, 38.0), p(48.0, 10.0)), None);
    let (_, plan) = searched(b, &chaining(8.5, 9.0));
    assert!(plan.summary.chains > 0);
    for (a, chain, b) in chains(&plan) {
        assert!((a, b) == (2, 0) || a + b > 1 || chain.start().y <= 29.0, "{a} {b} {chain:?}");
    }
}

#[test]
fn chains_stay_in_their_piece_of_waste() {
    // A frame with a large hole, two parts within it, and a part beside the frame.
    let mut b = Builder::new();
    let frame = b.cut(rectangle(p(0.0, 0.0), p(100.0, 60.0)), None);
    let hole = b.cut(rectangle(p(10.0, 10.0), p(80.0, 40.0)), Some(frame));
    b.cut(rectangle(p(15.0, 15.0), p(20.0, 20.0)), Some(hole));
    b.cut(circle(p(50.0, 30.0), 9.0), Some(hole));
    b.cut(rectangle(p(105.0, 0.0), p(20.0, 20.0)), None);
    let (_, plan) = searched(b, &chaining(40.0, 1.0));
    let found = chains(&plan);
    let joined = |a, b| found.iter().any(|c| (c.0, c.2) == (a, b) || (c.0, c.2) == (b, a));
    assert!(found.len() >= 2, "{found:?}");
    // Parts in the hole with each other and with the hole, which comes after them; what is beside the frame with the frame.
    for &(a, _, b) in &found {
        let within = |c: u32| (1..=3).contains(&c);
        assert_eq!(within(a), within(b), "{a} {b}");
        assert_ne!(a, hole, "the hole is the last to be cut in it");
    }
    assert!(joined(0, 4));
    // Holes of one part are never joined, whatever the reach.
    let mut b = Builder::new();
    let plate = b.cut(rectangle(p(0.0, 0.0), p(100.0, 60.0)), None);
    for k in 0..4 {
        b.cut(circle(p(20.0 + 20.0 * f64::from(k), 30.0), 6.0), Some(plate));
    }
    assert_eq!(searched(b, &chaining(1000.0, 0.5)).1.summary.chains, 0);
}

#[test]
fn leads_are_joined_from_tip_to_tip() {
    let machine = with_leads(chaining(30.0, 1.0), leads(LeadKind::Line, 1.0, 0.0));
    let (_, plan) = searched(squares(2, 2, 12.0), &machine);
    assert!(plan.summary.chains >= 2, "{:?}", plan.summary);
    assert!(plan.summary.lead_length > 0.0);
}

/// What a test's own formulas say of a chain between two places: its seconds beside those of the move and the piercing that it
/// stands for, `None` if it has no room. `slope`: how steeply it has to leave its contours.
pub(super) fn chain_seconds(
    sheet: &Sheet,
    machine: &Profile,
    [a, b]: [u32; 2],
    from: DVec2,
    to: DVec2,
    slope: f64,
) -> Option<f64> {
    let lever = machine.levers.chains?;
    let length = from.distance(to);
    if length > lever.reach || a == b {
        return None;
    }
    for k in 0..=1000 {
        let gone = length * f64::from(k) / 1000.0;
        let at = from.lerp(to, f64::from(k) / 1000.0);
        for (id, c) in (0..).zip(&sheet.contours) {
            let off = c.path.segments.iter().map(|s| s.nearest(at).1).fold(f64::INFINITY, f64::min).sqrt();
            let inside = kerfway::geometry::winding(&c.path, at).is_inside();
            let from_end = if id == a { gone } else { length - gone };
            let least =
                if id == a || id == b { lever.clearance.min(slope * from_end) } else { lever.clearance };
            if off < least - 1e-9 || (inside && off > 1e-9) {
                return None;
            }
        }
    }
    let (v, a) = (machine.cut.speed, machine.cut.accel.unwrap());
    Some(if length < v * v / a { 2.0 * (length / a).sqrt() } else { length / v + v / a })
}

/// The least seconds of all orders, all places of entry and all choices between a chain, a start on the kerf of the last contour
/// and a piercing.
pub(super) fn brute(sheet: &Sheet, machine: &Profile, problem: &Problem, slope: f64) -> f64 {
    let pierce = machine.pierce_time + machine.beam_on_delay + machine.beam_off_delay;
    brute_with(sheet, machine, problem, slope, pierce)
}

/// A cut through waste from a kerf or the edge of the sheet to a node: the contour of the kerf, the place, and its seconds.
type OnKerf = (Option<u32>, DVec2, f64);

/// What a search through all orders needs.
struct Brute<'p> {
    problem: &'p Problem,
    air: AirTime,
    /// Seconds of the way from a node to another one, with a piercing if there is one.
    leg: Vec<Vec<f64>>,
    /// By node: the cuts to it that begin on kerfs.
    on_kerfs: Vec<Vec<OnKerf>>,
    /// Nodes at which contours are pierced.
    pierced: Vec<usize>,
    pierce: f64,
    delays: f64,
}

impl Brute<'_> {
    fn go(&self, left: u32, last: Option<usize>, so_far: f64, best: &mut f64) {
        let Self { problem, air, .. } = self;
        if so_far >= *best {
            return;
        }
        let head = last.map_or(problem.home, |n| problem.nodes[n].exit);
        if left == 0 {
            *best = best.min(so_far + air.seconds(head, problem.home));
            return;
        }
        // What lies in a contour comes first.
        let waits =
            |k: u32| problem.items.iter().zip(0..).any(|(i, n)| left >> n & 1 == 1 && i.before == Some(k));
        for &n in &self.pierced {
            let node = &problem.nodes[n];
            let item = &problem.items[node.item as usize];
            if left >> node.item & 1 == 0 || waits(node.item) {
                continue;
            }
            let mut way =
                last.map_or_else(|| air.seconds(head, node.entry) + self.pierce, |last| self.leg[last][n]);
            for &(kerf, place, seconds) in &self.on_kerfs[n] {
                if kerf.is_none_or(|kerf| left >> kerf & 1 == 0) {
                    way = way.min(air.seconds(head, place) + self.delays + seconds);
                }
            }
            let id = u32::try_from(n).unwrap();
            // The seconds of an item contain its piercing.
            let cut = item.fixed + item.extra(id, node.along) - self.pierce;
            self.go(left & !(1 << node.item), Some(n), so_far + way + cut, best);
        }
    }
}

/// The same, where the beginning of a cut takes `pierce` seconds unless it is joined.
fn brute_with(sheet: &Sheet, machine: &Profile, problem: &Problem, slope: f64, pierce: f64) -> f64 {
    let air = AirTime::new(machine);
    let nodes = &problem.nodes;
    let approach = |n: usize| {
        let item = &problem.items[nodes[n].item as usize];
        item.lead(u32::try_from(n).unwrap()).and_then(|lead| lead.0.approach)
    };
    let pierced: Vec<usize> = (0..nodes.len()).filter(|&n| approach(n).is_none()).collect();
    // Every cut through waste from a place on a contour to a node of another one: from its nodes, and from where it is nearest.
    let edges = machine.levers.chains.is_some_and(|chains| chains.edge_starts);
    let mut cuts: Vec<(u32, DVec2, usize, f64)> = Vec::new();
    for (id, contour) in (0..).zip(&sheet.contours) {
        let own = pierced.iter().map(|&n| &nodes[n]).filter(|n| n.item == id).map(|n| n.exit);
        for (k, to) in pierced.iter().map(|&n| (n, &nodes[n])).filter(|(_, to)| to.item != id) {
            let near = contour.path.segments.iter().map(|s| (s.nearest(to.entry), s));
            let near = near.min_by(|a, b| a.0.1.total_cmp(&b.0.1)).map(|((t, _), s)| s.at(t));
            for place in own.clone().chain(near.filter(|_| edges)) {
                let chain = chain_seconds(sheet, machine, [id, to.item], place, to.entry, slope);
                cuts.extend(chain.map(|seconds| (id, place, k, seconds)));
            }
        }
    }
    let delays = pierce - machine.pierce_time;
    let leg = |from: &kerfway::problem::Node| {
        let mut prices: Vec<f64> = nodes.iter().map(|to| air.seconds(from.exit, to.entry) + pierce).collect();
        for &(_, place, to, seconds) in cuts.iter().filter(|c| c.0 == from.item) {
            let price = if place == from.exit {
                seconds
            } else if edges {
                air.seconds(from.exit, place) + delays + seconds
            } else {
                continue;
            };
            prices[to] = prices[to].min(price);
        }
        prices
    };
    let on = |place: DVec2| {
        let is_on = |c: &kerfway::sheet::Contour| c.path.segments.iter().any(|s| s.nearest(place).1 < 1e-16);
        (0..).zip(&sheet.contours).find(|(_, c)| is_on(c)).map(|c| c.0)
    };
    let mut on_kerfs: Vec<Vec<OnKerf>> = vec![Vec::new(); nodes.len()];
    for (n, cut) in (0..nodes.len()).filter_map(|n| Some((n, approach(n)?))) {
        let seconds = cut_time(machine, &machine.cut, &[cut]);
        let alike =
            pierced.iter().filter(|&&k| nodes[k].item == nodes[n].item && nodes[k].entry == cut.end());
        alike.for_each(|&k| on_kerfs[k].push((None, cut.start(), seconds)));
    }
    for &n in &pierced {
        for start in problem.starts.of(u32::try_from(n).unwrap()) {
            let kerf = on(start.from).unwrap();
            let seconds =
                chain_seconds(sheet, machine, [kerf, nodes[n].item], start.from, nodes[n].entry, slope);
            on_kerfs[n].extend(seconds.map(|s| (Some(kerf), start.from, s)));
        }
    }
    let leg = nodes.iter().map(leg).collect();
    let brute = Brute { problem, air, leg, on_kerfs, pierced, pierce, delays };
    let mut best = f64::INFINITY;
    brute.go((1 << problem.items.len()) - 1, None, 0.0, &mut best);
    best
}

#[test]
fn the_search_chooses_as_well_as_every_order_entry_and_chain() {
    let mut joined = 0;
    for seed in 0..12_u64 {
        let mut dice = Dice::new(seed);
        let mut b = Builder::new();
        for k in 0..4 {
            let at = p(f64::from(k % 2), f64::from(k / 2)) * 30.0
                + p(10.0 + dice.between(0.0, 6.0), 10.0 + dice.between(0.0, 6.0));
            if dice.below(2) == 0 {
                b.cut(circle(at + p(9.0, 9.0), dice.between(5.0, 9.0)), None);
            } else {
                b.cut(rectangle(at, p(dice.between(10.0, 18.0), dice.between(10.0, 18.0))), None);
            }
        }
        let machine = chaining(25.0, dice.between(0.2, 2.0));
        let sheet = oriented(b.sheet);
        let (problem, _, plan) = search_of_exact_cost(&sheet, &machine, seed);
        let least = brute(&sheet, &machine, &problem, 0.25);
        let most = brute(&sheet, &machine, &problem, 0.375);
        let found = plan.summary.total_time;
        // The planner leaves contours a little more steeply than the checker demands.
        assert!(least <= found + 1e-6 && found <= most + 1e-6, "seed {seed}: {least} {found} {most}");
        joined += plan.summary.chains;
    }
    assert!(joined > 18, "{joined}");
}

#[test]
fn a_row_of_parts_is_pierced_once_with_starts_on_kerfs() {
    let machine = starting(30.0, 1.0);
    let (_, plan) = searched(squares(4, 1, 8.0), &machine);
    let s = &plan.summary;
    // The first two face each other; from there on, each begins on the right of the one before it.
    assert_eq!((s.chains, s.edge_starts, s.pierces), (3, 2, 1));
    // The beam goes off and on for each run, and is pierced once.
    near(s.pierce_time, machine.pierce_time + 3.0 * (machine.beam_on_delay + machine.beam_off_delay));
    let at = plan.moves.iter().position(|m| matches!(m, Move::Chain { .. })).unwrap();
    let chains: Vec<usize> =
        (at..plan.moves.len()).filter(|&k| matches!(plan.moves[k], Move::Chain { .. })).collect();
    let starts: Vec<_> =
        chains.into_iter().filter(|&k| matches!(plan.moves[k - 1], Move::Air { .. })).collect();
    assert_eq!(starts.len(), 2);
    let without = searched(squares(4, 1, 8.0), &chaining(30.0, 1.0)).1.summary.total_time;
    assert!(without - s.total_time > 0.2, "{without} {}", s.total_time);
}

#[test]
fn chains_beside_moving_pierce_are_as_good_as_every_choice() {
    let (mut joined, mut moving) = (0, 0);
    for seed in 0..10_u64 {
        let mut dice = Dice::new(500 + seed);
        let mut b = Builder::new();
        for k in 0..4 {
            let at = p(f64::from(k % 2), f64::from(k / 2)) * 26.0
                + p(10.0 + dice.between(0.0, 4.0), 10.0 + dice.between(0.0, 4.0));
            b.cut(rectangle(at, p(dice.between(12.0, 18.0), dice.between(12.0, 18.0))), None);
        }
        let mut machine = chaining(25.0, dice.between(0.2, 2.0));
        machine.levers.moving_pierce = Some(kerfway::machine::MovingPierce { overcut: 0.0 });
        // A beam that takes long to go off, in thin sheet that is cut fast: then even a contour that is not pierced is joined.
        machine.beam_off_delay = dice.between(0.0, 0.6);
        let sheet = oriented(b.sheet);
        let (problem, _, plan) = search_of_exact_cost(&sheet, &machine, seed);
        let start = machine.beam_off_delay;
        // An entry that nothing joins slides between its nodes, which are all that brute force knows: so it gets those of the plan, too.
        let entered = starting_where_entered(&sheet, &plan);
        let of_plan = problem_of(&entered, &machine);
        let least = brute_with(&sheet, &machine, &problem, 0.25, start)
            .min(brute_with(&entered, &machine, &of_plan, 0.25, start));
        let most = brute_with(&sheet, &machine, &problem, 0.375, start);
        let found = plan.summary.total_time;
        assert!(least <= found + 1e-6 && found <= most + 1e-6, "seed {seed}: {least} {found} {most}");
        assert_eq!(plan.summary.pierces, 0);
        assert_eq!(plan.summary.moving_starts + plan.summary.chains, 4);
        joined += plan.summary.chains;
        moving += plan.summary.moving_starts;
    }
    assert!(joined > 5 && moving > 10, "{joined} {moving}");
}

#[test]
fn what_cannot_begin_moving_is_joined_and_what_is_cut_again_stays_so() {
    // A gap makes every cut begin at rest, so chains save what they save without moving pierce.
    let pierce = |machine: Profile| {
        let levers =
            Levers { moving_pierce: Some(kerfway::machine::MovingPierce { overcut: 0.5 }), ..machine.levers };
        Profile { levers, ..machine }
    };
    let gap = with_leads(chaining(30.0, 1.0), leads(LeadKind::Line, 1.0, -0.4));
    let (at_rest, moving) =
        (searched(squares(2, 2, 12.0), &gap).1, searched(squares(2, 2, 12.0), &pierce(gap)).1);
    assert!(moving.summary.chains >= 2 && moving.summary.moving_starts == 0, "{:?}", moving.summary);
    assert_eq!(at_rest.summary, moving.summary);
    // Where the beam takes long to go off, contours that begin moving are joined, too; each is still cut again by 0.5 mm.
    let slow = Profile { beam_off_delay: 0.6, ..pierce(chaining(30.0, 1.0)) };
    let (_, plan) = searched(squares(2, 2, 8.0), &slow);
    assert!(plan.summary.chains >= 2, "{:?}", plan.summary);
    near(plan.summary.lead_length, 4.0 * 0.5);
}

#[test]
fn six_contours_reach_the_exact_optimum() {
    for seed in 0..8_u64 {
        let mut dice = Dice::new(100 + seed);
        let mut b = Builder::new();
        for k in 0..5 {
            let at = p(f64::from(k % 3), f64::from(k / 3)) * 32.0
                + p(10.0 + dice.between(0.0, 8.0), 10.0 + dice.between(0.0, 8.0));
            let outer = b.cut(rectangle(at, p(dice.between(12.0, 20.0), dice.between(12.0, 20.0))), None);
            if k == 2 {
                b.cut(circle(at + p(6.0, 6.0), 3.0), Some(outer));
            }
        }
        let plan = searched(b, &chaining(25.0, 0.5)).1;
        assert!(plan.summary.chains >= 2, "seed {seed}");
    }
}

/// What the checker says of a plan after a change to its moves.
fn after(checked: &Profile, change: impl FnOnce(&mut Vec<Move>)) -> Vec<Violation> {
    let (sheet, mut plan) = searched(squares(2, 2, 8.0), &chaining(30.0, 1.0));
    change(&mut plan.moves);
    let parts = plan.summary.parts;
    plan.summary = plan::evaluate(&plan.moves, &sheet, checked);
    plan.summary.parts = parts;
    plan::check(&sheet, checked, &plan).err().unwrap_or_default()
}

pub(super) fn says(found: &[Violation], wanted: &str) -> bool {
    let said = |v: &Violation| match v {
        Violation::Chain { what, .. } | Violation::Beam { what, .. } => *what == wanted,
        _ => false,
    };
    found.iter().any(said)
}

#[test]
fn the_checker_finds_wrong_chains() {
    let machine = chaining(30.0, 1.0);
    assert!(after(&machine, |_| ()).is_empty());
    let without = Profile { levers: Levers::default(), ..machine.clone() };
    assert!(says(&after(&without, |_| ()), "is one that the machine does not cut"));
    assert!(says(&after(&chaining(7.0, 1.0), |_| ()), "is longer than the machine allows"));
    assert!(says(&after(&chaining(30.0, 9.0), |_| ()), "is too near to another cut"));
    let chain = |moves: &[Move]| moves.iter().position(|m| matches!(m, Move::Chain { .. })).unwrap();
    // The beam goes off and on instead, without piercing.
    let found = after(&machine, |moves| {
        let at = chain(moves);
        let to = moves[at].end().unwrap();
        moves[at] = Move::air(to);
    });
    assert!(says(&found, "cuts without piercing"), "{found:?}");
    // Pierced again after the chain; no cut after it; no cut before it.
    let found = after(&machine, |moves| moves.insert(chain(moves) + 1, Move::Pierce));
    assert!(says(&found, "cuts through waste without a cut after it"), "{found:?}");
    let found = after(&machine, |moves| moves.insert(chain(moves), Move::Pierce));
    assert!(says(&found, "cuts through waste without a cut before it"), "{found:?}");
    // Bent through a part.
    let found = after(&machine, |moves| {
        let at = chain(moves);
        let Move::Chain { path } = &mut moves[at] else { panic!() };
        let (from, to) = (path[0].start(), path[0].end());
        *path = vec![Segment::line(from, p(20.0, 20.0)), Segment::line(p(20.0, 20.0), to)];
    });
    assert!(says(&found, "is not straight"), "{found:?}");
    // Not where the head is.
    let found = after(&machine, |moves| {
        let at = chain(moves);
        let Move::Chain { path } = &mut moves[at] else { panic!() };
        path[0] = Segment::line(path[0].start() + p(0.1, 0.0), path[0].end());
    });
    assert!(found.iter().any(|v| matches!(v, Violation::NotJoined { .. })), "{found:?}");
}

/// A plan by hand: two contours joined from one place to another.
fn joined_at(b: Builder, machine: &Profile, [from, to]: [f64; 2]) -> Vec<Violation> {
    let sheet = oriented(b.sheet);
    let cut = |id: u32, along: f64| {
        let path = sheet.contours[id as usize].path.starting_at(along).segments;
        Move::Cut { contour: id, with: Vec::new(), path, mark: false, leads: Leads::default(), turns: vec![] }
    };
    let place = |id: usize, along: f64| sheet.contours[id].path.at(along).unwrap();
    let (start, end) = (place(0, from), place(1, to));
    let mut moves = vec![Move::air(start), Move::Pierce, cut(0, from)];
    moves.extend([Move::Chain { path: vec![Segment::line(start, end)] }, cut(1, to)]);
    for id in 2..sheet.contours.len() {
        moves.extend([Move::air(place(id, 0.0)), Move::Pierce, cut(u32::try_from(id).unwrap(), 0.0)]);
    }
    moves.push(Move::air(machine.home()));
    let mut summary = plan::evaluate(&moves, &sheet, machine);
    summary.parts = u32::try_from(sheet.parts.len()).unwrap();
    plan::check(&sheet, machine, &Plan { moves, summary, bridges: Vec::new() }).err().unwrap_or_default()
}

#[test]
fn the_checker_finds_chains_through_parts_and_along_edges() {
    let machine = chaining(100.0, 1.0);
    let two = || squares(2, 1, 8.0);
    // From the right side of the first to the left side of the second: sides begin at 0, 20, 40 and 60 mm.
    assert_eq!(joined_at(two(), &machine, [30.0, 70.0]), []);
    // From the left side of the first, through the part.
    let found = joined_at(two(), &machine, [70.0, 70.0]);
    assert!(
        says(&found, "cuts into a part") || says(&found, "runs along a contour that it joins"),
        "{found:?}"
    );
    // Along the tops of both.
    assert!(says(&joined_at(two(), &machine, [50.0, 50.0]), "runs along a contour that it joins"));
    // Through a part between them, which is not cut yet.
    let mut b = two();
    b.cut(rectangle(p(33.0, 15.0), p(2.0, 10.0)), None);
    assert!(says(&joined_at(b, &machine, [30.0, 70.0]), "is too near to another cut"));
    // Through a hole that lies around a part, where every place is inside an even number of outlines or crosses one.
    let mut b = Builder::new();
    let frame = b.cut(rectangle(p(0.0, 0.0), p(100.0, 60.0)), None);
    b.cut(rectangle(p(10.0, 10.0), p(80.0, 40.0)), Some(frame));
    let found = joined_at(b, &machine, [0.0, 0.0]);
    assert!(says(&found, "cuts into a part"), "{found:?}");
}

#[test]
fn every_dialect_keeps_the_beam_on() {
    let machine = Profile { beam_off_delay: 0.0, ..chaining(30.0, 1.0) };
    let (sheet, plan) = searched(squares(2, 2, 8.0), &machine);
    let planned = |machine: &Profile| searched(squares(2, 2, 8.0), machine);
    read_back(&machine, planned, 4, |dialect, plan, text| {
        assert_eq!(plan.summary.chains, 3, "{dialect}");
        let chains = |text: &str| text.matches("through waste for 8.000 mm to contour").count();
        assert!(text.is_none_or(|text| chains(text) == 3), "{dialect}");
    });
    // Starts on kerfs wait for the beam, and do not pierce.
    for dialect in dialects().iter().filter(|d| d.pierce.is_some() && d.dwell.is_some()) {
        let profile = Profile { dialect: DialectChoice::named(&dialect.name), ..starting(30.0, 1.0) };
        let (sheet, plan) = searched(squares(4, 1, 8.0), &profile);
        let facts = SheetFacts::of(&sheet);
        let Ok(text) = output::gcode(&plan, &facts, &profile, "squares.dxf", Start::Absolute) else {
            continue;
        };
        let check = output::check_against(&text, &profile, &plan).unwrap();
        assert!(check.passed, "{}: {:?}", dialect.name, check.problems);
        assert_eq!(text.matches("from a kerf or an edge through waste for ").count(), 2, "{}", dialect.name);
    }
    // In GRBL's program the beam is on from the first cut to the last.
    let text =
        output::gcode(&plan, &SheetFacts::of(&sheet), &machine, "squares.dxf", Start::Absolute).unwrap();
    let program = gcode::run(&text).unwrap();
    let lit: f64 = program.motions().filter(|m| m.beam > 0.0).map(|m| m.path.length()).sum();
    assert!((lit - 344.0).abs() < 0.01, "{lit}");
    let runs: Vec<bool> = program.motions().map(|m| m.beam > 0.0).collect();
    assert_eq!(runs.windows(2).filter(|w| w[0] && !w[1]).count(), 1);
}

#[test]
fn drawings_have_chains_as_one_path_with_their_contours() {
    let machine = chaining(30.0, 1.0);
    let (sheet, plan) = searched(squares(2, 2, 8.0), &machine);
    let facts = SheetFacts::of(&sheet);
    let dxf = output::dxf(&plan, &facts);
    assert_eq!(dxf.matches("LWPOLYLINE").count(), 1, "one path with three chains");
    let project = output::lbrn2(&plan, &facts, &machine).unwrap();
    assert_eq!(project.matches("<Shape").count(), 1);
    let svg = output::svg(&plan, &facts, &machine);
    assert_eq!(svg.matches("class=\"cut\"").count(), 4);
    assert_eq!(svg.matches("Cuts through waste").count(), 1);
    // A start on a kerf begins another path.
    let (sheet, plan) = searched(squares(4, 1, 8.0), &starting(30.0, 1.0));
    assert_eq!(output::dxf(&plan, &SheetFacts::of(&sheet)).matches("LWPOLYLINE").count(), 3);
}

#[test]
fn machines_that_cannot_are_refused() {
    let with = |change: &dyn Fn(&mut Profile)| {
        let mut profile = chaining(30.0, 1.0);
        change(&mut profile);
        profile.validate().unwrap_err().to_string()
    };
    assert!(
        with(&|p| p.pre_cut_time = Some(1.0)).starts_with("The machine has levers.chains and pre_cut_time.")
    );
    let corner = Some(kerfway::machine::SharpCorner { angle: 1.0, time: 1.0 });
    assert!(with(&|p| p.sharp_corner = corner).contains("levers.chains and sharp_corner"));
    assert!(
        with(&|p| p.levers.chains = Some(Chains { reach: 0.0, clearance: 1.0, edge_starts: false }))
            .contains("levers.chains.reach")
    );
}

#[test]
fn a_turned_sheet_has_the_same_chains() {
    let machine = Profile { rapid: chaining(1.0, 1.0).rapid, ..chaining(30.0, 1.0) };
    let total = |turn: f64| {
        let u = kerfway::geometry::math::unit(turn);
        let mut b = Builder::new();
        for k in 0..4 {
            let at = p(f64::from(k % 2), f64::from(k / 2)) * 28.0 + p(100.0, 10.0);
            let corners = [p(0.0, 0.0), p(20.0, 0.0), p(20.0, 20.0), p(0.0, 20.0)];
            b.cut(polygon(&corners.map(|c| u.rotate(at + c))), None);
        }
        let plan = searched(b, &machine).1;
        (plan.summary.chains, plan.summary.chain_length)
    };
    for turn in [0.3, 1.2, -0.8] {
        let (chains, length) = total(turn);
        assert_eq!(chains, 3);
        assert!((length - 24.0).abs() < 1e-6, "{length}");
    }
}

/// Squares beside the left edge of a sheet of 300 x 200 mm that is drawn around them and not cut.
fn beside_the_edge(count: u32, from_edge: f64) -> Sheet {
    let mut b = Builder::new();
    for k in 0..count {
        b.cut(rectangle(p(from_edge, 40.0 + 50.0 * f64::from(k)), p(20.0, 20.0)), None);
    }
    let mut sheet = oriented(b.sheet);
    sheet.ignored.push(Ignored { path: rectangle(p(0.0, 0.0), p(300.0, 200.0)), layer: 0 });
    sheet
}

#[test]
fn cuts_begin_at_the_edge_of_the_sheet_without_piercing() {
    // Too far from each other for chains.
    let machine = starting(15.0, 1.0);
    let sheet = beside_the_edge(3, 10.0);
    let (_, least, plan) = search_of_exact_cost(&sheet, &machine, 1);
    let s = &plan.summary;
    assert_eq!((s.chains, s.edge_starts, s.pierces), (3, 3, 0));
    near(s.chain_length, 30.0);
    // As far as each square is pierced at a corner, and entered there from the edge.
    let first = plan.moves.iter().position(|m| matches!(m, Move::Chain { .. })).unwrap();
    let Move::Air { to, .. } = &plan.moves[first - 1] else { panic!("{:?}", plan.moves) };
    near(to.x, 0.0);
    let cut = cut_time(&machine, &machine.cut, &[Segment::line(p(0.0, 0.0), p(10.0, 0.0))]);
    near(s.pierce_time, 3.0 * (machine.beam_on_delay + machine.beam_off_delay));
    assert!(cut < machine.pierce_time && least.is_finite());
    // Every order, entry, and choice between a piercing and the edge.
    for seed in 0..6_u64 {
        let mut dice = Dice::new(seed);
        let mut b = Builder::new();
        for k in 0..3 {
            let at = p(dice.between(3.0, 40.0), 30.0 + 50.0 * f64::from(k));
            b.cut(rectangle(at, p(dice.between(12.0, 20.0), dice.between(12.0, 20.0))), None);
        }
        let mut sheet = oriented(b.sheet);
        sheet.ignored.push(Ignored { path: rectangle(p(0.0, 0.0), p(300.0, 200.0)), layer: 0 });
        let (problem, _, plan) = search_of_exact_cost(&sheet, &machine, seed);
        let air = AirTime::new(&machine);
        let delays = machine.beam_on_delay + machine.beam_off_delay;
        let mut least = f64::INFINITY;
        for order in [[0, 1, 2], [0, 2, 1], [1, 0, 2], [1, 2, 0], [2, 0, 1], [2, 1, 0]] {
            // Least seconds to each place where the head is after a contour.
            let mut heads = vec![(problem.home, 0.0)];
            for contour in order {
                let path = &sheet.contours[contour].path;
                let own = problem.nodes.iter().filter(|n| n.item as usize == contour);
                let mut next: Vec<(DVec2, f64)> = Vec::new();
                for along in own.map(|n| n.along) {
                    let entry = path.at(along).unwrap();
                    let cut = cut_time(&machine, &machine.cut, &path.starting_at(along).segments) + delays;
                    // Straight from the left; the other edges are out of reach.
                    let edge = p(0.0, entry.y);
                    let steps = 1..200;
                    let free = steps.clone().all(|k| {
                        let at = edge.lerp(entry, f64::from(k) / 200.0);
                        (0..3).all(|c| {
                            let line = &sheet.contours[c].path;
                            let off = line
                                .segments
                                .iter()
                                .map(|s| s.nearest(at).1)
                                .fold(f64::INFINITY, f64::min)
                                .sqrt();
                            let least = if c == contour { 0.25 * at.distance(entry).min(4.0) } else { 1.0 };
                            off >= least - 1e-9 && !kerfway::geometry::winding(line, at).is_inside()
                        })
                    });
                    let lead = cut_time(&machine, &machine.cut, &[Segment::line(edge, entry)]);
                    for &(head, so_far) in &heads {
                        let mut seconds = so_far + air.seconds(head, entry) + machine.pierce_time + cut;
                        if free && edge.distance(entry) <= 15.0 {
                            seconds = seconds.min(so_far + air.seconds(head, edge) + lead + cut);
                        }
                        next.push((entry, seconds));
                    }
                }
                heads = next;
            }
            let home = |&(head, seconds): &(DVec2, f64)| seconds + air.seconds(head, problem.home);
            least = heads.iter().map(home).fold(least, f64::min);
        }
        let found = plan.summary.total_time;
        // Contours that are not near the edge are entered anywhere.
        assert!(found <= least + 1e-6, "seed {seed}: {found} {least}");
        if plan.summary.edge_starts == 3 {
            assert!((found - least).abs() < 1e-6, "seed {seed}: {found} {least}");
        }
    }
}

#[test]
fn starts_away_from_the_edge_or_through_parts_are_found() {
    let machine = starting(15.0, 1.0);
    let sheet = beside_the_edge(2, 10.0);
    let plan = search_of_exact_cost(&sheet, &machine, 1).2;
    let after = |from: &dyn Fn(DVec2) -> DVec2| {
        let mut plan = plan.clone();
        let at = plan.moves.iter().position(|m| matches!(m, Move::Chain { .. })).unwrap();
        let Move::Chain { path } = &mut plan.moves[at] else { unreachable!() };
        let start = from(path[0].end());
        path[0] = Segment::line(start, path[0].end());
        plan.moves[at - 1] = Move::air(start);
        plan.summary = plan::evaluate(&plan.moves, &sheet, &machine);
        plan::check(&sheet, &machine, &plan)
    };
    let found = |from: &dyn Fn(DVec2) -> DVec2| {
        let violations = after(from).unwrap_err();
        violations.iter().any(|v| matches!(v, Violation::Chain { .. }))
    };
    assert!(found(&|entry| p(1.0, entry.y)), "in the waste");
    assert!(found(&|entry| p(0.0, entry.y + 14.0)), "longer than the reach");
    // Without the lever, with marks, or where no sheet is known, there are none.
    let pierces =
        |sheet: &Sheet, machine: &Profile| search_of_exact_cost(sheet, machine, 1).2.summary.pierces;
    assert_eq!(pierces(&sheet, &chaining(15.0, 1.0)), 2);
    let mut unknown = sheet.clone();
    unknown.ignored.clear();
    assert_eq!(pierces(&unknown, &Profile { bed: None, ..machine.clone() }), 2);
    // A bed may be larger than the sheet on it.
    assert_eq!(pierces(&unknown, &Profile { bed: Some([0.0, 0.0, 400.0, 300.0]), ..machine.clone() }), 2);
}

#[test]
fn programs_that_begin_at_the_edge_pass_their_check() {
    for dialect in dialects().iter().filter(|d| d.pierce.is_some() && d.dwell.is_some()) {
        let profile = Profile { dialect: DialectChoice::named(&dialect.name), ..starting(15.0, 1.0) };
        let sheet = beside_the_edge(3, 10.0);
        let plan = search_of_exact_cost(&sheet, &profile, 1).2;
        let facts = SheetFacts::of(&sheet);
        let Ok(text) = output::gcode(&plan, &facts, &profile, "edge.dxf", Start::Absolute) else { continue };
        let check = output::check_against(&text, &profile, &plan).unwrap();
        assert!(check.passed, "{}: {:?}", dialect.name, check.problems);
        assert_eq!(text.matches("from a kerf or an edge through waste for ").count(), 3, "{}", dialect.name);
    }
}
