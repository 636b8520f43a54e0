//! Loops and rounded corners against every order, entry and choice of corners.

use super::{LOOPS, plate, thin, wedge};
use crate::testkit::exact::search_of_exact_cost;
use crate::testkit::leads::oriented;
use crate::testkit::sheets::{Builder, XorShift, p, polygon};
use kerfway::geometry::{Arc, DVec2, Segment, math};
use kerfway::machine::{AirTime, CornerKind, Corners, Levers, Profile, process_time};
use kerfway::problem::Problem;
use kerfway::sheet::Sheet;

/// A test's own elements of a corner: a loop, or an arc with what it leaves out of both sides.
fn made(machine: &Profile, kind: CornerKind, a: &Segment, b: &Segment) -> Option<(Vec<Segment>, f64)> {
    let lever = machine.levers.corners?;
    let (at, u, w) = (a.end(), a.tangent(1.0), b.tangent(0.0));
    let turn = math::turn(u, w);
    if kind == CornerKind::Loop {
        let (r, ahead) = (lever.loop_radius, lever.loop_radius * math::tan(0.5 * turn));
        let out = at + u * ahead;
        let center = out - u.perp() * r;
        let arc = Arc::new(out, at - w * ahead, center, false);
        return (turn > 0.36)
            .then(|| (vec![Segment::line(at, out), Segment::Arc(arc), Segment::line(arc.end, at)], 0.0));
    }
    let half = 0.5 * turn.abs();
    let most = lever.deviation / (1.0 / math::cos(half) - 1.0);
    let sides = 0.5 * a.length().min(b.length()) / math::tan(half);
    let r = lever.round_radius.min(most).min(sides);
    let trim = r * math::tan(half);
    let center = at - u * trim + u.perp() * r * turn.signum();
    let arc = Arc::new(at - u * trim, at + w * trim, center, turn > 0.0);
    Some((vec![Segment::Arc(arc)], trim))
}

/// The least seconds of a cut around a contour from one of its places over all choices of corners with room.
fn least_from(
    machine: &Profile,
    sheet: &Sheet,
    id: u32,
    along: f64,
    kind: CornerKind,
    blocked: &[DVec2],
) -> f64 {
    let path = sheet.contours[id as usize].path.starting_at(along).segments;
    let corners: Vec<_> = path
        .windows(2)
        .enumerate()
        .filter(|(_, w)| math::turn(w[0].tangent(1.0), w[1].tangent(0.0)).abs() > 0.36)
        .filter(|(_, w)| blocked.iter().all(|b| b.distance(w[0].end()) > 1e-6))
        .filter_map(|(k, w)| Some((k, made(machine, kind, &w[0], &w[1])?)))
        .collect();
    let seconds = |set: u32| {
        let mut out: Vec<Segment> = Vec::new();
        let mut cut_off = 0.0;
        for (k, s) in path.iter().enumerate() {
            let here = corners.iter().enumerate().find(|(c, (at, _))| *at == k && set >> c & 1 == 1);
            let (from, to) = (cut_off, here.map_or(0.0, |(_, (_, (_, trim)))| *trim));
            let length = s.length();
            if length - from - to <= 1e-3 {
                return f64::INFINITY;
            }
            out.push(s.piece(from / length, 1.0 - to / length));
            out.extend(here.iter().flat_map(|(_, (_, (elements, _)))| elements));
            cut_off = to;
        }
        process_time(machine, &machine.cut, false, &out)
    };
    (0..1_u32 << corners.len()).map(seconds).fold(f64::INFINITY, f64::min)
}

/// The least seconds of all orders, entries and choices of corners: what was cut and where the head is say what the rest takes.
fn brute(machine: &Profile, sheet: &Sheet, problem: &Problem, kind: CornerKind) -> f64 {
    let air = AirTime::new(machine);
    let pierce = machine.pierce_time + machine.beam_on_delay + machine.beam_off_delay;
    let n = problem.items.len();
    let blocked = |id: u32| -> Vec<DVec2> {
        let leads = problem.items[id as usize].leads.as_ref();
        leads.map_or_else(Vec::new, |l| l.corners.without_room.iter().map(|b| b.1).collect())
    };
    let nodes = &problem.nodes;
    let price: Vec<f64> = nodes
        .iter()
        .map(|node| pierce + least_from(machine, sheet, node.item, node.along, kind, &blocked(node.item)))
        .collect();
    let mut best = vec![f64::INFINITY; (1 << n) * nodes.len()];
    for set in 1_usize..1 << n {
        for (k, node) in nodes.iter().enumerate().filter(|(_, node)| set >> node.item & 1 == 1) {
            let before = set & !(1 << node.item);
            let from = |(j, last): (usize, &kerfway::problem::Node)| {
                best[before * nodes.len() + j] + air.seconds(last.exit, node.entry)
            };
            let way = if before == 0 {
                air.seconds(problem.home, node.entry)
            } else {
                nodes.iter().enumerate().map(from).fold(f64::INFINITY, f64::min)
            };
            best[set * nodes.len() + k] = way + price[k];
        }
    }
    let last = &best[((1 << n) - 1) * nodes.len()..];
    let home =
        |(seconds, node): (&f64, &kerfway::problem::Node)| seconds + air.seconds(node.exit, problem.home);
    last.iter().zip(nodes).map(home).fold(f64::INFINITY, f64::min)
}

/// Parts without holes whose corners are near enough to each other to matter: wedges, chamfered plates, combs.
pub(super) fn parts(rng: &mut XorShift, count: u32) -> Builder {
    let mut b = Builder::new();
    for k in 0..count {
        let at = p(f64::from(k % 3) * 50.0 + 20.0, f64::from(k / 3) * 50.0 + 20.0);
        let chamfer = rng.between(0.3, 4.0);
        b.cut(
            match rng.below(3) {
                0 => wedge(at, rng.between(15.0, 30.0), rng.between(0.5, 1.4)),
                1 => polygon(&[
                    at,
                    at + p(25.0 - chamfer, 0.0),
                    at + p(25.0, chamfer),
                    at + p(25.0, 15.0),
                    at + p(chamfer, 15.0),
                ]),
                _ => polygon(&[
                    at,
                    at + p(20.0, 0.0),
                    at + p(20.0 - chamfer, 12.0),
                    at + p(10.0, rng.between(3.0, 9.0)),
                    at + p(0.0, 12.0),
                ]),
            },
            None,
        );
    }
    b
}

#[test]
fn the_search_chooses_as_well_as_every_order_entry_and_choice_of_corners() {
    let (mut loops, mut rounded) = (0, 0);
    for seed in 0..16_u64 {
        let mut rng = XorShift::new(seed);
        let sheet = oriented(parts(&mut rng, if seed < 12 { 4 } else { 6 }).sheet);
        let kind = if seed % 2 == 0 { CornerKind::Loop } else { CornerKind::Round };
        let base = if seed % 4 < 2 { plate(LOOPS) } else { thin(LOOPS) };
        let corners = Corners {
            outer: kind,
            loop_radius: rng.between(0.2, 2.0),
            round_radius: rng.between(0.3, 3.0),
            deviation: rng.between(0.02, 0.5),
            ..LOOPS
        };
        let machine = Profile { levers: Levers { corners: Some(corners), ..Levers::default() }, ..base };
        let (problem, least, plan) = search_of_exact_cost(&sheet, &machine, seed);
        let brute = brute(&machine, &sheet, &problem, kind);
        let exact = least + problem.items.iter().map(|i| i.fixed).sum::<f64>();
        let found = plan.summary.total_time;
        // The exact solver on the problem's nodes is as good as everything tried; contours without a better corner may be entered
        // between their nodes as well.
        assert!((exact - brute).abs() < 1e-6, "seed {seed}: {exact} {brute}");
        assert!(found <= brute + 1e-6, "seed {seed}: {found} {brute}");
        loops += plan.summary.loops;
        rounded += plan.summary.rounded_corners;
    }
    assert!(loops > 20 && rounded > 40, "{loops} {rounded}");
}
