//! Every dialect over every drawing: a beam machine that knows only the controllers' rules follows the programs, and the
//! preflight passes them.
#![allow(
    clippy::unwrap_used,
    clippy::panic,
    clippy::float_cmp,
    clippy::disallowed_methods,
    reason = "tests stop where they cannot go on, compare what must be equal, and share no arithmetic with the product"
)]

mod ends;
mod own;
mod refused;
mod resolution;

use crate::testkit::beam_machine::{Controller, Run, Step, run};
use crate::testkit::leads::{leads, with_leads};
use crate::testkit::paths::{Element, assert_same_path};
use crate::testkit::{files, fixtures, name, plans};
use kerfway::geometry::Segment;
use kerfway::job::{Job, LoadOptions, MachineChoice, PlanOptions};
use kerfway::machine::dialect::{Dialect, DialectChoice, FileUnit, dialects};
use kerfway::machine::{Heat, JointKind, JointRule, Joints, LeadKind, Levers, MovingPierce, Profile, Start};
use kerfway::output;
use kerfway::plan::{Move, Plan};
use kerfway::sheet::Sheet;
use std::path::{Path, PathBuf};

/// Largest distance between a motion and the element it stands for, mm.
const DEVIATION: f64 = 0.002;

/// The drawings: real ones, the sheets of 100 and 500 contours, and the samples of the page.
fn drawings() -> Vec<PathBuf> {
    let top = Path::new(env!("CARGO_MANIFEST_DIR"));
    let mut all = files(&fixtures().join("dxf-dev"), "dxf");
    all.extend(files(&top.join("www/app/public/samples"), "dxf"));
    // More of them, for looking further.
    if let Some(folder) = std::env::var_os("KERFWAY_DRAWINGS") {
        all.extend(files(Path::new(&folder), "dxf"));
    }
    all
}

/// A machine that pierces, waits after cuts and marks; the waits are long enough to be written by every dialect.
pub(super) fn machine() -> Profile {
    Profile { pierce_time: 0.25, beam_on_delay: 0.004, beam_off_delay: 0.002, ..plans::machine() }
}

/// The best plan after a few moves, with the sheet that it cuts.
fn planned(file: &Path, machine: &Profile) -> Option<(Job, Plan)> {
    let bytes = std::fs::read(file).unwrap();
    let mut job = Job::load(bytes, &name(file), &LoadOptions::default()).ok()?;
    let machine = MachineChoice::Profile(Box::new(machine.clone()));
    job.start(&PlanOptions { machine, seed: 1, moves: Some(50), ..PlanOptions::default() }).ok()?;
    job.run_mut().unwrap().step(50);
    let plan = job.plan().unwrap();
    Some((job, plan))
}

pub(super) fn with(machine: &Profile, dialect: DialectChoice) -> Profile {
    Profile { dialect, ..machine.clone() }
}

/// What is cut between two announcements of contours.
fn stretches(run: &Run) -> Vec<Vec<Element>> {
    let mut all = Vec::new();
    for step in &run.steps {
        match step {
            Step::Contour => all.push(Vec::new()),
            Step::Move { rapid: false, path, beam, .. } if *beam > 0.0 => all.last_mut().unwrap().push(*path),
            _ => {}
        }
    }
    // The comment of a joint announces no cut.
    all.retain(|elements| !elements.is_empty());
    all
}

/// No lit rapid, no dark cut, no dark piercing; the path, the powers and the waits of the plan.
fn assert_right(
    text: &str,
    plan: &Plan,
    profile: &Profile,
    dialect: &Dialect,
    controller: Controller,
    what: &str,
    known: &mut Vec<Vec<Element>>,
) {
    let run = run(text, controller).unwrap_or_else(|e| panic!("{what}: {e}"));
    assert!(!run.armed, "{what}: the beam is on at the end");
    let full = dialect.power.full.unwrap_or(profile.max_s);
    let rounding = 0.51 * 10_f64.powi(-(dialect.power.decimals as i32));
    let powers = [profile.cut.power * full, profile.mark.power * full];
    let creeps = dialect.pierce.as_ref().is_some_and(|p| p.length.is_some());
    let (mut lit, mut waited, mut dark, mut cooled) = (0, 0.0, 0.0, 0.0);
    for step in &run.steps {
        match step {
            Step::Move { rapid: true, beam, asked, feed, line, .. } => {
                assert!(
                    *beam == 0.0 && *asked == 0.0,
                    "{what}, line {line}: beam {beam}, power {asked} on a rapid"
                );
                assert!(
                    *feed >= profile.rapid.speed[0] * 60.0 - 1.0,
                    "{what}, line {line}: a rapid at {feed} mm/min"
                );
            }
            // Dark at the speed of a cut: a joint without a stop.
            Step::Move { beam: 0.0, path, .. } => dark += path.length(),
            Step::Move { beam, line, .. } => {
                assert!(
                    powers.iter().any(|p| (p - beam).abs() <= rounding),
                    "{what}, line {line}: {beam} at a cut"
                );
            }
            Step::Wait { seconds, beam, line } => {
                if profile.levers.heat.is_some() && *beam <= 0.0 && *seconds >= 0.01 {
                    cooled += seconds;
                    continue;
                }
                let pierces = (seconds - profile.pierce_time).abs() < 0.1;
                assert!(!pierces || *beam > 0.0, "{what}, line {line}: a dark piercing");
                assert!(pierces || *seconds < 0.01, "{what}, line {line}: waits {seconds} s");
                lit += u32::from(pierces);
                waited += seconds;
            }
            Step::Contour => {}
        }
    }
    let asked = plan.summary.wait_time;
    assert!(
        (cooled - asked).abs() <= 0.011 * f64::from(plan.summary.waits),
        "{what}: cools {cooled} s, not {asked}"
    );
    let flying = |m: &Move| match m {
        Move::Joint { path, flying: true, .. } | Move::Fly { path } => path.iter().map(Segment::length).sum(),
        _ => 0.0,
    };
    let joints: f64 = plan.moves.iter().map(flying).sum();
    assert!(
        (dark - joints).abs() <= 1e-3 * (1.0 + plan.moves.len() as f64),
        "{what}: {dark} mm dark, not {joints}"
    );
    let stretches = stretches(&run);
    let cuts: Vec<&[Segment]> = plan
        .moves
        .iter()
        .filter_map(|m| if let Move::Cut { path, .. } = m { Some(path.as_slice()) } else { None })
        .collect();
    assert_eq!(stretches.len(), cuts.len(), "{what}");
    let deviation = dialect.chords.unwrap_or(DEVIATION);
    // Most dialects write the same coordinates, which are compared with the plan once.
    if *known != stretches {
        for (elements, path) in stretches.iter().zip(&cuts) {
            assert_same_path(elements, path, deviation);
        }
        *known = stretches;
    }
    if !creeps {
        assert_eq!(lit, plan.summary.pierces, "{what}: piercings");
        let planned = plan.summary.pierce_time;
        let each = 0.51 * 10_f64.powi(-(dialect.dwell.as_ref().unwrap().decimals as i32))
            / dialect.dwell.as_ref().unwrap().unit.per_second();
        assert!(
            (waited - planned).abs()
                <= each * 3.0 * f64::from(plan.summary.contours + plan.summary.pierces) + 1e-9,
            "{what}: waits {waited}, not {planned}"
        );
    }
}

fn assert_all(file: &Path, machine: &Profile, dialects: &[(DialectChoice, Dialect, Controller)]) {
    let Some((job, plan)) = planned(file, machine) else { return };
    let sheet: &Sheet = job.beam_sheet();
    let mut known = Vec::new();
    for (choice, dialect, controller) in dialects {
        let what = format!("{} in {}", name(file), dialect.name);
        let profile = with(machine, choice.clone());
        let text = output::gcode(
            &plan,
            &output::SheetFacts::of(sheet),
            &profile,
            name(file).as_str(),
            Start::Absolute,
        )
        .unwrap_or_else(|e| panic!("{what}: {e}"));
        assert_right(&text, &plan, &profile, dialect, *controller, &what, &mut known);
        let check = output::check_against(&text, &profile, &plan).unwrap();
        assert!(check.passed, "{what}: {:?}", check.problems);
        assert!(check.dark_rapids && check.passes == 1 || check.contours == 0, "{what}: {check:?}");
        // The file alone, against its own header.
        let alone = output::check(&text, &profile).unwrap();
        assert!(alone.passed, "{what}, alone: {:?}", alone.problems);
    }
}

fn shipped() -> Vec<(DialectChoice, Dialect, Controller)> {
    let own = |d: Dialect| (DialectChoice::named(&d.name), d.clone(), Controller::of(&d.name));
    dialects().into_iter().map(own).collect()
}

#[test]
fn every_dialect_cuts_every_drawing_with_the_beam_on_where_it_should_be() {
    let all = drawings();
    assert!(all.len() >= 24, "{} drawings", all.len());
    let dialects = shipped();
    assert_eq!(dialects.len(), 11);
    for file in all {
        assert_all(&file, &machine(), &dialects);
    }
}

#[test]
fn every_dialect_begins_cuts_and_marks_moving_without_a_wait() {
    let levers = Levers { moving_pierce: Some(MovingPierce { overcut: 0.4 }), ..Levers::default() };
    let moving = Profile { levers, ..machine() };
    let mut starts = 0;
    for file in files(&fixtures().join("dxf-dev"), "dxf").iter().take(6) {
        let Some((_, plan)) = planned(file, &moving) else { continue };
        starts += plan.summary.moving_starts;
        assert_all(file, &moving, &shipped());
    }
    assert!(starts > 100, "{starts} moving starts");
}

/// Dialects that switch the beam only at rest refuse joints without a stop; all others leave them dark.
#[test]
fn every_dialect_leaves_joints_dark() {
    for kind in [JointKind::Stop, JointKind::Flying] {
        let rule = JointRule { kind, spacing: Some(100.0), ..JointRule::default() };
        let with_joints = Profile { joints: Some(Joints { rules: vec![rule] }), ..machine() };
        let (mut joints, mut refused) = (0, Vec::new());
        for file in files(&fixtures().join("dxf-dev"), "dxf").iter().take(6) {
            let Some((job, plan)) = planned(file, &with_joints) else { continue };
            joints += plan.summary.joints;
            let mut able = shipped();
            able.retain(|(choice, dialect, _)| {
                let profile = with(&with_joints, choice.clone());
                let written = output::gcode(
                    &plan,
                    &output::SheetFacts::of(job.beam_sheet()),
                    &profile,
                    "a.dxf",
                    Start::Absolute,
                );
                let refuses = written.is_err_and(|e| e.to_string().contains("cannot leave flying joints"));
                refused.extend(refuses.then(|| dialect.name.clone()));
                !refuses
            });
            assert_all(file, &with_joints, &able);
        }
        refused.sort();
        refused.dedup();
        assert!(joints > 50, "{joints} joints");
        let at_rest = ["linuxcnc-spindle", "marlin-fan", "template"];
        assert_eq!(refused, if kind == JointKind::Flying { &at_rest[..] } else { &[] });
    }
}

#[test]
fn every_dialect_waits_in_the_dark_until_it_has_cooled() {
    let heat = Heat { distance: 200.0, seconds: 20.0, charge: None, small_holes: None };
    let heated = Profile { levers: Levers { heat: Some(heat), ..Levers::default() }, ..machine() };
    let mut waits = 0;
    for file in files(&fixtures().join("dxf-dev"), "dxf").iter().take(6) {
        let Some((job, plan)) = planned(file, &heated) else { continue };
        waits += plan.summary.waits;
        assert_all(file, &heated, &shipped());
        let facts = output::SheetFacts::of(job.beam_sheet());
        if plan.summary.waits > 0 {
            assert!(output::rd(&plan, &facts, &heated).is_err_and(|e| e.to_string().contains("no waits")));
        }
        // A dialect that cannot dwell.
        let mut dialect = dialects().into_iter().find(|d| d.name == "smoothie").unwrap();
        dialect.dwell = None;
        let still = with(
            &Profile { beam_off_delay: 0.0, ..heated.clone() },
            DialectChoice::Document(Box::new(dialect)),
        );
        let written = output::gcode(&plan, &facts, &still, "a.dxf", Start::Absolute);
        assert_eq!(written.is_err_and(|e| e.to_string().contains("levers.heat")), plan.summary.waits > 0);
    }
    assert!(waits > 20, "{waits} waits");
}

#[test]
fn every_dialect_writes_leads_with_every_cut() {
    let machine = with_leads(machine(), leads(LeadKind::Arc, 1.0, 0.5));
    let (mut both, mut into, mut overcuts) = (0, 0, 0);
    for file in files(&fixtures().join("dxf-dev"), "dxf").iter().take(6) {
        let Some((_, plan)) = planned(file, &machine) else { continue };
        for cut in &plan.moves {
            let Move::Cut { leads, .. } = cut else { continue };
            both += u32::from(leads.lead_in > 0 && leads.lead_out > 0);
            into += u32::from(leads.lead_in > 0 && leads.lead_out == 0);
            overcuts += u32::from(leads.overcut > 0);
        }
        assert_all(file, &machine, &shipped());
    }
    assert!(
        both > 10 && into > 100 && overcuts > 100,
        "{both} in and out, {into} in only, {overcuts} overcuts"
    );
}

#[test]
fn inches_and_chords_stay_within_their_tolerance() {
    let mut own = Vec::new();
    for mut dialect in dialects().into_iter().filter(|d| d.name == "linuxcnc-m67" || d.name == "smoothie") {
        let controller = Controller::of(&dialect.name);
        dialect.chords = Some(0.02);
        own.push((DialectChoice::Document(Box::new(dialect.clone())), dialect.clone(), controller));
        dialect.chords = None;
        dialect.units = FileUnit::Inch;
        (dialect.decimals.xy, dialect.decimals.ij, dialect.decimals.feed) = (5, 6, 4);
        for line in &mut dialect.header {
            *line = line.replace("G21", "G20");
        }
        own.push((DialectChoice::Document(Box::new(dialect.clone())), dialect, controller));
    }
    for file in files(&fixtures().join("dxf-dev"), "dxf").iter().take(6) {
        assert_all(file, &machine(), &own);
    }
}

#[test]
fn the_header_tells_time_size_bounds_machine_material_and_hash_on_lines_of_their_own() {
    let (sheet, plan) = plans::small();
    let hash = "0123456789abcdef".repeat(4);
    for dialect in dialects().into_iter().filter(|d| d.name != "grbl-m4") {
        let profile = with(&machine(), DialectChoice::named(&dialect.name));
        let facts =
            output::JobFacts { name: "plate.dxf", hash: Some(&hash), material: Some("3 mm birch ply") };
        let text =
            output::gcode(&plan, &output::SheetFacts::of(&sheet), &profile, facts, Start::Absolute).unwrap();
        let comments = run(&text, Controller::of(&dialect.name)).unwrap().comments;
        let has = |line: &str| {
            assert!(comments.iter().any(|c| c == line), "{}: no {line:?} in {comments:#?}", dialect.name)
        };
        has("machine test");
        has("material 3 mm birch ply");
        has("size 40 x 30 mm");
        has("x 10 to 50, y 10 to 40 mm");
        assert!(comments.iter().any(|c| c.starts_with("time: about ") && c.ends_with(" s")));
        assert!(comments.iter().any(|c| c.ends_with(&hash)), "{}: {comments:#?}", dialect.name);
        assert!(text.lines().all(|l| l.len() <= dialect.line_length as usize));
    }
}

/// Between passes the head goes down where it is. The beam is off then, also on machines that wait nowhere, and the move takes its time.
#[test]
fn every_dialect_lowers_the_head_in_the_dark() {
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("www/app/public/samples/sheet_100.dxf");
    for (pierce_time, z_speed) in [(0.0, 20.0), (0.2, 8.0)] {
        let mut machine = Profile { pierce_time, z_speed: Some(z_speed), ..machine() };
        (machine.beam_on_delay, machine.beam_off_delay) = (0.0, 0.0);
        (machine.cut.passes, machine.cut.z_step) = (3, 0.5);
        let (job, plan) = planned(&file, &machine).unwrap();
        for (choice, dialect, _) in shipped().into_iter().filter(|d| d.1.z) {
            let (profile, facts) = (with(&machine, choice), output::SheetFacts::of(job.beam_sheet()));
            let text = output::gcode(&plan, &facts, &profile, "passes", Start::Absolute).unwrap();
            let check = output::check_against(&text, &profile, &plan).unwrap();
            assert!(check.passed && check.passes == 3, "{}: {:?}", dialect.name, check.problems);
            let off = (check.seconds - plan.summary.total_time).abs();
            assert!(off < 0.002 * plan.summary.total_time, "{}: {off} s", dialect.name);
        }
    }
    // As it was written before: the spot burnt while the head went down.
    let machine = with(&machine(), DialectChoice::named("linuxcnc-spindle"));
    let lit = "G21\nG90\nM5\nG0 X0 Y0\nM3 S800\nG1 X10 Y0 F600\nG0 Z-0.5\nG1 X0 Y0\nM5\nM2\n";
    let problems = output::check(lit, &machine).unwrap().problems;
    let found = problems.iter().find(|p| p.message.contains("rapid to another height")).unwrap();
    assert_eq!(found.message, "Line 7 is a rapid to another height with the beam on, at power 800.");
}
