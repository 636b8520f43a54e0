//! Cuts that begin at the edge of the sheet.

use super::checker::says;
use super::{chaining, near, starting};
use crate::testkit::exact::search_of_exact_cost;
use crate::testkit::leads::oriented;
use crate::testkit::sheets::{Builder, XorShift, line, p, rectangle};
use kerfway::geometry::{DVec2, Segment};
use kerfway::machine::dialect::{DialectChoice, dialects};
use kerfway::machine::{AirTime, Process, Profile, Start, cut_time};
use kerfway::output::{self, SheetFacts};
use kerfway::plan::{self, Move, Violation};
use kerfway::sheet::{Ignored, Sheet};

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
        let mut rng = XorShift::new(seed);
        let mut b = Builder::new();
        for k in 0..3 {
            let at = p(rng.between(3.0, 40.0), 30.0 + 50.0 * f64::from(k));
            b.cut(rectangle(at, p(rng.between(12.0, 20.0), rng.between(12.0, 20.0))), None);
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

/// Formats that write a start on the edge as part of a cut gave it the layer of the contour before, and its power and speed.
#[test]
fn a_start_at_the_edge_belongs_to_the_contour_that_it_leads_to() {
    let mut machine = starting(15.0, 1.0);
    machine.mark = Process { speed: 55.0, power: 0.1, ..machine.mark };
    let mut b = Builder::new();
    for k in 0..3 {
        b.cut(rectangle(p(10.0, 40.0 + 50.0 * f64::from(k)), p(20.0, 20.0)), None);
    }
    b.mark(line(p(60.0, 20.0), p(80.0, 20.0)), None);
    let mut sheet = oriented(b.sheet);
    sheet.ignored.push(Ignored { path: rectangle(p(0.0, 0.0), p(300.0, 200.0)), layer: 0 });
    let plan = search_of_exact_cost(&sheet, &machine, 1).2;
    assert_eq!(plan.summary.edge_starts, 3);
    let facts = SheetFacts::of(&sheet);
    let project = output::lbrn2(&plan, &facts, &machine).unwrap();
    let speeds: Vec<&str> = project.lines().filter(|l| l.contains("<speed ")).collect();
    assert_eq!(speeds.len(), 2, "a layer of marks and one of cuts: {speeds:?}");
    let cut_index = |shape: &str| shape.split("CutIndex=\"").nth(1).unwrap().chars().next().unwrap();
    let shapes: Vec<char> = project.lines().filter(|l| l.contains("<Shape ")).map(cut_index).collect();
    let marks = shapes.iter().filter(|c| **c == shapes[0]).count();
    assert_eq!((shapes.len(), marks), (4, 1), "{shapes:?}");
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
    // A contour in several passes is pierced in each.
    let twice = Profile { cut: Process { passes: 2, ..machine.cut }, ..machine.clone() };
    assert!(says(&plan::check(&sheet, &twice, &plan).unwrap_err(), "joins contours that are not cut alike"));
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
