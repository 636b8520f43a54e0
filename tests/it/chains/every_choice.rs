//! Chains against every order, entry and chain: a search with formulas of its own.

use super::{chaining, near, searched, squares, starting, starting_where_entered};
use crate::testkit::exact::search_of_exact_cost;
use crate::testkit::leads::{leads, oriented, with_leads};
use crate::testkit::sheets::{Builder, XorShift, circle, p, rectangle};
use kerfway::geometry::DVec2;
use kerfway::job::problem_of;
use kerfway::machine::{AirTime, LeadKind, Levers, Profile, cut_time};
use kerfway::plan::Move;
use kerfway::problem::Problem;
use kerfway::sheet::Sheet;

/// What a test's own formulas say of a chain between two places: its seconds beside those of the move and the piercing that it
/// stands for, `None` if it has no room. `slope`: how steeply it has to leave its contours.
pub(crate) fn chain_seconds(
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
pub(crate) fn brute(sheet: &Sheet, machine: &Profile, problem: &Problem, slope: f64) -> f64 {
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
        let mut rng = XorShift::new(seed);
        let mut b = Builder::new();
        for k in 0..4 {
            let at = p(f64::from(k % 2), f64::from(k / 2)) * 30.0
                + p(10.0 + rng.between(0.0, 6.0), 10.0 + rng.between(0.0, 6.0));
            if rng.below(2) == 0 {
                b.cut(circle(at + p(9.0, 9.0), rng.between(5.0, 9.0)), None);
            } else {
                b.cut(rectangle(at, p(rng.between(10.0, 18.0), rng.between(10.0, 18.0))), None);
            }
        }
        let machine = chaining(25.0, rng.between(0.2, 2.0));
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
        let mut rng = XorShift::new(500 + seed);
        let mut b = Builder::new();
        for k in 0..4 {
            let at = p(f64::from(k % 2), f64::from(k / 2)) * 26.0
                + p(10.0 + rng.between(0.0, 4.0), 10.0 + rng.between(0.0, 4.0));
            b.cut(rectangle(at, p(rng.between(12.0, 18.0), rng.between(12.0, 18.0))), None);
        }
        let mut machine = chaining(25.0, rng.between(0.2, 2.0));
        machine.levers.moving_pierce = Some(kerfway::machine::MovingPierce { overcut: 0.0 });
        // A beam that takes long to go off, in thin sheet that is cut fast: then even a contour that is not pierced is joined.
        machine.beam_off_delay = rng.between(0.0, 0.6);
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
        let mut rng = XorShift::new(100 + seed);
        let mut b = Builder::new();
        for k in 0..5 {
            let at = p(f64::from(k % 3), f64::from(k / 3)) * 32.0
                + p(10.0 + rng.between(0.0, 8.0), 10.0 + rng.between(0.0, 8.0));
            let outer = b.cut(rectangle(at, p(rng.between(12.0, 20.0), rng.between(12.0, 20.0))), None);
            if k == 2 {
                b.cut(circle(at + p(6.0, 6.0), 3.0), Some(outer));
            }
        }
        let plan = searched(b, &chaining(25.0, 0.5)).1;
        assert!(plan.summary.chains >= 2, "seed {seed}");
    }
}
