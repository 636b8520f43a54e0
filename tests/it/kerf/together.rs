//! Parts one kerf apart are cut together (`levers.common_cuts`): pierced once, and begun again on their kerfs.

use super::made::{KERF, bulged, rounded, spaced, started};
use crate::testkit::leads::{leads, with_leads};
use crate::testkit::outlines::drawing;
use crate::testkit::plates::rectangle;
use crate::testkit::rng::seeded;
use kerfway::finding::Code;
use kerfway::geometry::{DVec2, Segment};
use kerfway::job::{Job, JobError, LoadOptions, MachineChoice, OutputKind, PlanOptions};
use kerfway::machine::dialect::{DialectChoice, dialects};
use kerfway::machine::{Chains, Fly, LeadKind, Levers, Profile, SharedCuts, Tips, preset, presets};
use kerfway::output::{self, SheetFacts};
use kerfway::plan::{self, Move, Plan, Violation};
use kerfway::sheet::{CommonCuts, Sheet};
use rand::RngExt;

/// A preset with a kerf, and what shares cuts cut together.
pub(super) fn together(name: &str) -> Profile {
    let levers = Levers { common_cuts: Some(SharedCuts::default()), ..Levers::default() };
    Profile { kerf_width: KERF, pre_cut_time: None, levers, ..preset(name).unwrap() }
}

fn one_by_one(machine: &Profile) -> Profile {
    let levers = Levers { common_cuts: None, ..machine.levers };
    Profile { levers, ..machine.clone() }
}

fn of(job: &Job) -> (Sheet, Plan) {
    (job.beam_sheet().clone(), job.plan().unwrap())
}

/// Cuts that begin without piercing after a move with the beam off.
fn on_kerfs(plan: &Plan) -> usize {
    plan.moves.windows(2).filter(|w| matches!(w, [Move::Air { .. }, Move::Cut { mark: false, .. }])).count()
}

#[test]
fn a_grid_one_kerf_apart_is_pierced_once_on_every_preset() {
    let mut pierced_once = 0;
    for preset in presets().iter().filter(|p| p.cut.passes == 1 && p.cut.accel.is_some()) {
        let machine = together(&preset.name);
        for (m, n) in [(2, 1), (3, 2), (4, 3)] {
            let (w, h) = (20.0 + KERF, 10.0 + KERF);
            let union = (n + 1) as f64 * w * m as f64 + (m + 1) as f64 * h * n as f64;
            let bytes = drawing(&spaced(m, n, KERF));
            let plan = started(bytes.clone(), machine.clone()).plan().unwrap();
            let alone = started(bytes, one_by_one(&machine)).plan().unwrap();
            assert!((plan.summary.cut_length - union).abs() < 1e-6, "{}: {m} x {n}", preset.name);
            assert!((alone.summary.cut_length - union).abs() < 1e-6, "{}: {m} x {n}", preset.name);
            let (now, before) = (plan.summary.total_time, alone.summary.total_time);
            assert!(now <= before + 1e-9, "{}: {m} x {n}: {now} {before}", preset.name);
            if plan.summary.pierces == 1 {
                pierced_once += 1;
            }
        }
    }
    assert!(pierced_once >= 15, "{pierced_once}");
    // In a grid of 4 x 3, trails begin at every second T, all of them but the first on kerfs.
    let plan = started(drawing(&spaced(4, 3, KERF)), together("fibre-6kw-thick")).plan().unwrap();
    assert_eq!((plan.summary.pierces, on_kerfs(&plan)), (1, 4));
    let saved = "12 contours share cuts and are cut as one";
    let job = started(drawing(&spaced(4, 3, KERF)), together("fibre-6kw-thick"));
    let found = &job.run().unwrap().findings;
    assert!(found.iter().any(|f| f.code == Code::CommonCut && f.message.starts_with(saved)), "{found:?}");
}

#[test]
fn what_lies_in_a_part_comes_before_it_falls_and_arcs_are_shared_too() {
    // The checker follows what is held, element by element.
    let mut outlines = spaced(3, 3, KERF);
    let holes: Vec<_> = outlines.iter().map(|o| rectangle([o[0].x + 5.0, o[0].y + 3.0, 6.0, 4.0])).collect();
    outlines.extend(holes);
    let (sheet, plan) = of(&started(drawing(&outlines), together("fibre-3kw-thin")));
    assert_eq!((sheet.groups.len(), plan.summary.pierces, plan.summary.parts), (1, 10, 9));
    // Rounded parts in a row, and a disc in the hole of a plate.
    let row: Vec<Vec<[f64; 3]>> =
        [0.0, 30.0 + KERF, 60.0 + 2.0 * KERF].map(|x| rounded([x, 0.0, 30.0, 20.0, 4.0])).to_vec();
    let lines: Vec<&[[f64; 3]]> = row.iter().map(Vec::as_slice).collect();
    let plan = started(bulged(&lines, &[[15.0, 10.0, 5.0]]), together("fibre-6kw-thick")).plan().unwrap();
    assert_eq!(plan.summary.pierces, 2, "three parts as one, and a hole");
}

#[test]
fn programs_of_every_dialect_begin_on_kerfs_without_a_wait() {
    for dialect in dialects().iter().filter(|d| d.pierce.is_some()) {
        let choice = DialectChoice::named(&dialect.name);
        let machine = Profile { dialect: choice, ..together("fibre-3kw-thin") };
        let (sheet, plan) = of(&started(drawing(&spaced(4, 3, KERF)), machine.clone()));
        assert!(on_kerfs(&plan) >= 4, "{}", dialect.name);
        let facts = SheetFacts::of(&sheet);
        let start = kerfway::machine::Start::Absolute;
        let Ok(text) = output::gcode(&plan, &facts, &machine, "grid.dxf", start) else { continue };
        for check in [output::check_against(&text, &machine, &plan), output::check(&text, &machine)] {
            let check = check.unwrap();
            assert!(check.passed, "{}: {:?}", dialect.name, check.problems);
        }
    }
    let job = started(drawing(&spaced(4, 3, KERF)), together("fibre-3kw-thin"));
    for kind in [OutputKind::Dxf, OutputKind::Svg, OutputKind::Lbrn2, OutputKind::Json] {
        job.output(kind).unwrap();
    }
}

#[test]
fn where_it_saves_nothing_they_are_cut_one_by_one() {
    let mut machine = together("fibre-3kw-thin");
    (machine.beam_on_delay, machine.beam_off_delay, machine.pierce_time) = (0.0, 0.0, 0.0);
    // Nor are corners fewer in one trail.
    machine.cut.accel = None;
    let (_, plan) = of(&started(drawing(&spaced(6, 5, KERF)), machine));
    let whole = plan.moves.iter().all(|m| !matches!(m, Move::Cut { with, .. } if !with.is_empty()));
    assert!(whole, "{:?}", plan.summary);
}

#[test]
fn rows_on_the_run_and_chains_go_with_it() {
    let mut outlines = spaced(3, 2, KERF);
    for o in spaced(3, 2, KERF) {
        outlines
            .extend((0..4).map(|k| rectangle([o[0].x + 2.0 + 4.0 * f64::from(k), o[0].y + 4.0, 2.0, 2.0])));
    }
    let mut machine = together("fibre-3kw-thin");
    machine.levers.fly = Some(Fly { reach: 20.0, overcut: 0.0 });
    let (sheet, plan) = of(&started(drawing(&outlines), machine));
    assert!(plan.summary.fly_cuts > 0 && sheet.groups.len() == 1);
    assert_eq!(plan.moves.iter().filter(|m| matches!(m, Move::Pierce)).count(), 1);
    let mut outlines = spaced(3, 2, KERF);
    outlines.extend(spaced(1, 2, 8.0).iter().map(|o| o.iter().map(|p| *p + DVec2::X * 100.0).collect()));
    let mut machine = together("fibre-6kw-thick");
    machine.levers.chains = Some(Chains { reach: 30.0, clearance: 1.0, edge_starts: false });
    let (_, plan) = of(&started(drawing(&outlines), machine));
    assert_eq!((plan.summary.chains, plan.summary.pierces), (1, 2));
}

/// The lead-ins of cuts that are pierced, each with where it is pierced.
fn leads_in(plan: &Plan) -> Vec<Option<DVec2>> {
    let of = |w: &[Move]| match w {
        [Move::Pierce, Move::Cut { path, leads, .. }] => {
            Some(path.first().filter(|_| leads.lead_in > 0).map(Segment::start))
        }
        _ => None,
    };
    plan.moves.windows(2).filter_map(of).collect()
}

#[test]
fn with_leads_they_are_pierced_in_the_waste() {
    for kind in [LeadKind::Line, LeadKind::Arc] {
        for (m, n) in [(2, 1), (3, 2), (4, 3)] {
            let mut outlines = spaced(m, n, KERF);
            let holes: Vec<_> =
                outlines.iter().map(|o| rectangle([o[0].x + 5.0, o[0].y + 3.0, 8.0, 4.0])).collect();
            outlines.extend(holes);
            let machine = with_leads(together("fibre-6kw-thick"), leads(kind, 2.0, 0.0));
            let job = started(drawing(&outlines), machine.clone());
            let (sheet, plan) = of(&job);
            let places = leads_in(&plan);
            assert_eq!(places.len(), m * n + 1, "{m} x {n}");
            // Each hole and the group have one.
            assert!(places.iter().all(Option::is_some), "{m} x {n}: {:?}", plan.summary);
            let on = |o: &[DVec2], p: DVec2| {
                (0..o.len())
                    .map(|k| Segment::line(o[k], o[(k + 1) % o.len()]).nearest(p).1.sqrt())
                    .fold(f64::INFINITY, f64::min)
            };
            for p in places.into_iter().flatten() {
                assert!(outlines.iter().all(|o| on(o, p) > 0.5 * KERF + 0.5), "{p}");
            }
            let said = format!(
                "{} contours that share cuts have one straight lead-in",
                sheet.groups[0].contours.len()
            );
            let findings = &job.run().unwrap().findings;
            assert!(findings.iter().any(|f| f.message.starts_with(&said)), "{findings:?}");
            let text = job.output(OutputKind::Gcode).unwrap();
            let check = output::check_against(&text, &machine, &plan).unwrap();
            assert!(check.passed, "{:?}", check.problems);
            // Pierced elsewhere, the lead runs through a part or beside it.
            let grouped = |m: &Move| matches!(m, Move::Cut { with, leads, .. } if !with.is_empty() && leads.lead_in > 0);
            let at = plan.moves.iter().position(grouped).unwrap();
            for away in
                [DVec2::new(3.0, 0.5), DVec2::new(-3.0, 0.5), DVec2::new(0.5, 3.0), DVec2::new(0.5, -3.0)]
            {
                let mut plan = plan.clone();
                let Move::Cut { path, .. } = &mut plan.moves[at] else { unreachable!() };
                let node = path[0].end();
                path[0] = Segment::line(node + away, node);
                let Move::Air { to, .. } = &mut plan.moves[at - 2] else { unreachable!() };
                *to = node + away;
                let inside = outlines.iter().take(m * n).any(|o| {
                    let (low, high) = (o[0] - 0.5 * KERF, o[2] + 0.5 * KERF);
                    (node + away).cmpgt(low).all() && (node + away).cmplt(high).all()
                });
                let found = plan::check(&sheet, &machine, &plan).unwrap_err();
                let lead = found.iter().any(|v| matches!(v, Violation::Lead { .. }));
                assert!(lead || !inside, "{m} x {n}: {away} {found:?}");
            }
        }
    }
}

/// Divides one of some rectangles, unless it is small, leaving a gap between the two. `below`: a random number below another.
pub(super) fn divide(all: &mut Vec<[f64; 4]>, gap: f64, below: &mut impl FnMut(i32) -> i32) {
    let k = below(all.len() as i32) as usize;
    let [x, y, w, h] = all[k];
    let share = 0.3 + 0.1 * f64::from(below(5));
    if w > h && w > 16.0 {
        let part = (share * w).round();
        all[k] = [x, y, part, h];
        all.push([x + part + gap, y, w - part - gap, h]);
    } else if h > 16.0 {
        let part = (share * h).round();
        all[k] = [x, y, w, part];
        all.push([x, y + part + gap, w, h - part - gap]);
    }
}

/// A rectangle cut in two again and again, the parts some way apart, some left out and some with a hole.
pub(super) fn random(seed: u64, gap: f64) -> Vec<Vec<DVec2>> {
    let mut rng = seeded(seed);
    let mut below = |n: i32| rng.random_range(0..n);
    let mut all = vec![[100.0, 100.0, 90.0, 70.0]];
    for _ in 0..2 + below(9) {
        divide(&mut all, gap, &mut below);
    }
    if all.len() > 3 && below(2) == 0 {
        all.remove(below(all.len() as i32) as usize);
    }
    let hole = |[x, y, w, h]: [f64; 4]| rectangle([x + 0.3 * w, y + 0.3 * h, 0.4 * w, 0.4 * h]);
    let holes: Vec<_> = all.iter().filter(|_| below(3) == 0).map(|r| hole(*r)).collect();
    all.iter().map(|r| rectangle(*r)).chain(holes).collect()
}

#[test]
fn of_forty_nests_every_plan_and_program_is_sound_and_none_is_slower() {
    let (mut grouped, mut saved) = (0, 0.0);
    for seed in 0..40 {
        let bytes = drawing(&random(seed, KERF));
        let bare = together(if seed % 2 == 0 { "fibre-6kw-thick" } else { "fibre-3kw-thin" });
        let led = with_leads(bare.clone(), leads(LeadKind::Line, 1.0, 0.0));
        for machine in [bare, led] {
            let job = started(bytes.clone(), machine.clone());
            let (sheet, plan) = of(&job);
            let text = job.output(OutputKind::Gcode).unwrap();
            let check = output::check_against(&text, &machine, &plan).unwrap();
            assert!(check.passed, "seed {seed}: {:?}", check.problems);
            // Every line once: as long as the contours, with their leads.
            let all: f64 = sheet.contours.iter().filter(|c| c.is_processed()).map(|c| c.length).sum();
            let cut = plan.summary.cut_length - plan.summary.lead_length;
            assert!((cut - all).abs() < 1e-6, "seed {seed}: {cut} {all}");
            grouped += usize::from(on_kerfs(&plan) > 0 || plan.summary.pierces < plan.summary.contours);
            let alone = started(bytes.clone(), one_by_one(&machine)).plan().unwrap().summary;
            // One by one, what is left of a shared outline is open, and begins on the other one without a lead.
            if machine.leads.is_none() {
                let (now, before) = (plan.summary.total_time, alone.total_time);
                assert!(now <= before + 1e-9, "seed {seed}: {now} {before}");
                saved += 1.0 - now / before;
            }
        }
    }
    assert!(grouped >= 60 && saved > 4.0, "{grouped} {saved}");
}

/// Violations after a change to the moves of a grid, the sums brought in line.
fn after(change: impl FnOnce(&mut Vec<Move>)) -> Vec<Violation> {
    let machine = together("fibre-6kw-thick");
    let (sheet, mut plan) = of(&started(drawing(&spaced(3, 3, KERF)), machine.clone()));
    change(&mut plan.moves);
    let parts = plan.summary.parts;
    plan.summary = plan::evaluate(&plan.moves, &sheet, &machine);
    plan.summary.parts = parts;
    plan::check(&sheet, &machine, &plan).unwrap_err()
}

#[test]
fn plans_that_begin_off_a_kerf_or_cut_a_shared_line_twice_are_found() {
    let begins = |m: &Move| matches!(m, Move::Pierce);
    let found = after(|moves| moves.retain(|m| !begins(m)));
    assert!(found.iter().any(|v| matches!(v, Violation::NoPreCut { .. })), "{found:?}");
    // The second trail first: it ends on nothing, and nothing was pierced where it begins.
    let found = after(|moves| {
        let first = moves.iter().position(begins).unwrap();
        let second = (first..moves.len()).find(|&k| matches!(moves[k], Move::Air { .. })).unwrap();
        moves.remove(first);
        moves.insert(second, Move::Pierce);
    });
    assert!(found.iter().any(|v| matches!(v, Violation::NoPreCut { .. })), "{found:?}");
    let found = after(|moves| {
        let at = moves.iter().position(|m| matches!(m, Move::Cut { .. })).unwrap();
        let Move::Cut { path, .. } = &mut moves[at] else { unreachable!() };
        let (there, back) = (path[0], path[0].reversed());
        path.splice(0..0, [there, back]);
    });
    assert!(
        found.iter().any(|v| matches!(v, Violation::Again { .. } | Violation::Strays { .. })),
        "{found:?}"
    );
    let found = after(|moves| {
        let at = moves.iter().rposition(|m| matches!(m, Move::Cut { .. })).unwrap();
        moves.remove(at);
    });
    assert!(found.iter().any(|v| matches!(v, Violation::Partly { .. })), "{found:?}");
}

#[test]
fn machines_and_methods_that_cannot_are_refused() {
    let refused = |change: &dyn Fn(&mut Profile)| {
        let mut machine = together("fibre-6kw-thick");
        change(&mut machine);
        machine.validate().unwrap_err().to_string()
    };
    assert!(refused(&|m| m.pre_cut_time = Some(1.0)).contains("levers.common_cuts and pre_cut_time"));
    assert!(
        refused(&|m| m.levers.tips =
            Some(Tips { risky_moves: kerfway::machine::RiskyMoves::Ignore, ..Tips::default() }))
        .contains("levers.tips")
    );
    let mut job = Job::load(drawing(&spaced(2, 1, KERF)), "two.dxf", &LoadOptions::default()).unwrap();
    let machine = || MachineChoice::Profile(Box::new(together("fibre-6kw-thick")));
    let options = PlanOptions { machine: machine(), method: Some("pso".into()), ..PlanOptions::default() };
    assert!(
        matches!(job.start(&options), Err(JobError::Conflict { field: "method", .. }))
            || job.start(&options).is_err()
    );
    // A person decides for one by one.
    let load = LoadOptions { common_cuts: CommonCuts::Off, ..LoadOptions::default() };
    let mut job = Job::load(drawing(&spaced(2, 1, KERF)), "two.dxf", &load).unwrap();
    job.start(&PlanOptions { machine: machine(), moves: Some(1000), ..PlanOptions::default() }).unwrap();
    job.run_mut().unwrap().step(1000);
    assert_eq!(job.plan().unwrap().summary.pierces, 2);
}
