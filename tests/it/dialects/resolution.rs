//! Coarse numbers and coarse chords: programs that are as exact as their dialect allows are handed out, and wrong ones are not.

use super::{machine, planned, shipped, with};
use crate::testkit::{files, fixtures, name, plans};
use kerfway::geometry::{Arc, Path, Segment};
use kerfway::machine::dialect::{Dialect, DialectChoice, FileUnit};
use kerfway::machine::{Profile, Start};
use kerfway::output::{self, Check};
use kerfway::plan::Plan;
use kerfway::sheet::{Operation, Sheet};

/// The machine with each dialect that writes G2 and G3 on lines with their power, after a change.
fn own(change: impl Fn(&mut Dialect)) -> Vec<Profile> {
    let named =
        shipped().into_iter().filter(|(_, d, _)| ["linuxcnc-m67", "grbl-m4"].contains(&d.name.as_str()));
    let changed = named.map(|(_, mut dialect, _)| {
        change(&mut dialect);
        with(&machine(), DialectChoice::Document(Box::new(dialect)))
    });
    changed.collect()
}

fn inches(dialect: &mut Dialect) {
    dialect.units = FileUnit::Inch;
    (dialect.decimals.xy, dialect.decimals.ij, dialect.decimals.feed) = (3, 4, 3);
    for line in &mut dialect.header {
        *line = line.replace("G21", "G20");
    }
}

/// What the check says of a program against its plan and alone.
fn checks(sheet: &Sheet, plan: &Plan, profile: &Profile) -> [Check; 2] {
    let facts = output::SheetFacts::of(sheet);
    let text = output::gcode(plan, &facts, profile, "a.dxf", Start::Absolute).unwrap();
    [output::check_against(&text, profile, plan).unwrap(), output::check(&text, profile).unwrap()]
}

/// Five circles with radii of 0.4 to 3 mm.
fn circles(profile: &Profile) -> (Sheet, Plan) {
    circles_of([0.4, 0.7, 1.0, 2.0, 3.0], profile)
}

fn circles_of(radii: [f64; 5], profile: &Profile) -> (Sheet, Plan) {
    let stop = |k: u32| {
        let (r, at) = (radii[k as usize], glam::DVec2::new(20.0 * f64::from(k), 50.0));
        let path = Path::new(vec![Segment::Arc(Arc::circle(at, r))], true);
        plans::Stop { layer: 0, operation: Operation::Cut, path }
    };
    let (sheet, mut plan) = plans::plan_of((0..5).map(stop).collect(), &[("0", 7)], profile);
    plan.summary = kerfway::plan::evaluate(&plan.moves, &sheet, profile);
    (sheet, plan)
}

#[test]
fn chords_of_any_tolerance_pass_on_small_circles() {
    for chords in [0.02, 0.08, 0.2, 0.5] {
        for profile in own(|d| d.chords = Some(chords)) {
            let (sheet, plan) = circles(&profile);
            for check in checks(&sheet, &plan, &profile) {
                assert!(check.passed, "{chords} in {}: {:?}", check.dialect, check.problems);
                assert_eq!(check.contours, 5, "{chords} in {}", check.dialect);
                // Whole turns of chords, each shorter than its circle by at most 1.2 times their tolerance.
                assert!(plan.summary.cut_length - check.cut_length < 5.0 * 1.2 * chords);
            }
        }
    }
}

#[test]
fn a_length_that_chords_do_not_explain_is_refused() {
    for profile in own(|d| d.chords = Some(0.1)) {
        let (sheet, mut plan) = circles(&profile);
        plan.summary.cut_length += 2.0;
        let [check, _] = checks(&sheet, &plan, &profile);
        assert!(
            check.problems.iter().any(|p| p.message.starts_with("The program cuts ")),
            "{:?}",
            check.problems
        );
    }
}

/// A controller refuses an arc whose radii differ by more than 0.005 mm and by more than 0.1 %.
#[test]
fn arcs_that_few_decimals_of_their_centre_distort_are_chords() {
    let radii = [0.4137, 0.7132, 1.0464, 2.0336, 30.0041];
    for ij in [2, 3] {
        for profile in own(|d| d.decimals.ij = ij) {
            let (sheet, plan) = circles_of(radii, &profile);
            for check in checks(&sheet, &plan, &profile) {
                assert!(check.passed, "{ij} in {}: {:?}", check.dialect, check.problems);
                assert_eq!(check.contours, 5, "{ij} in {}", check.dialect);
            }
            let facts = output::SheetFacts::of(&sheet);
            let text = output::gcode(&plan, &facts, &profile, "a.dxf", Start::Absolute).unwrap();
            let arcs = text.lines().filter(|line| line.starts_with("G2 ") || line.starts_with("G3 ")).count();
            // With three decimals all are arcs of half a turn; with two only the large circle.
            assert_eq!(arcs, if ij == 3 { 10 } else { 2 }, "{ij} in {}", profile.dialect.name());
        }
    }
}

#[test]
fn inches_with_three_decimals_pass_on_every_drawing() {
    for profile in own(inches) {
        for file in files(&fixtures().join("dxf-dev"), "dxf").iter().take(8) {
            let Some((job, plan)) = planned(file, &profile) else { continue };
            for check in checks(job.beam_sheet(), &plan, &profile) {
                assert!(check.passed, "{} in {}: {:?}", name(file), check.dialect, check.problems);
            }
        }
    }
}

#[test]
fn a_box_that_the_decimals_do_not_explain_is_refused() {
    for (profile, off) in
        own(inches).into_iter().map(|p| (p, 0.04)).chain(own(|_| {}).into_iter().map(|p| (p, 0.012)))
    {
        let (sheet, mut plan) = circles(&profile);
        let [right, _] = checks(&sheet, &plan, &profile);
        assert!(right.passed, "{:?}", right.problems);
        plan.summary.bounds[2] += off;
        let [check, _] = checks(&sheet, &plan, &profile);
        assert!(
            check.problems.iter().any(|p| p.message.starts_with("The program reaches ")),
            "{off}: {:?}",
            check.problems
        );
    }
}
