//! Calibration: machines whose values are known are found again from the seconds of their jobs.

use crate::testkit::fixtures;
use kerfway::calibration::{Calibration, Measured, calibrate};
use kerfway::job::{Job, LoadOptions, MachineChoice, PlanOptions};
use kerfway::machine::{Profile, preset};
use kerfway::plan::document::Document;

/// The plan of a drawing on a machine.
fn planned(file: &str, machine: &Profile) -> Document {
    let bytes = std::fs::read(fixtures().join(file)).unwrap();
    let mut job = Job::load(bytes, file, &LoadOptions::default()).unwrap();
    let choice = MachineChoice::Profile(Box::new(machine.clone()));
    job.start(&PlanOptions { machine: choice, seed: 1, moves: Some(500), ..PlanOptions::default() }).unwrap();
    job.run_mut().unwrap().step(500);
    job.document().unwrap()
}

/// The seconds that the moves of a plan take on another machine, by planning's own sums.
fn on(machine: &Profile, plan: &Document) -> f64 {
    let same = Measured { plan: plan.clone(), seconds: plan.summary.total_time };
    calibrate(machine, &[same]).unwrap().jobs[0].before
}

const JOBS: [&str; 2] = ["sheets/sheet_100.dxf", "dxf-dev/mozman_ezdxf__forms.dxf"];

fn calibrated(true_machine: &Profile, machine: &Profile, jobs: &[&str]) -> Calibration {
    let measured: Vec<Measured> = jobs
        .iter()
        .map(|file| {
            let plan = planned(file, machine);
            let seconds = on(true_machine, &plan);
            Measured { plan, seconds }
        })
        .collect();
    calibrate(machine, &measured).unwrap()
}

#[test]
fn the_seconds_of_a_plan_are_those_of_its_summary() {
    let machine = preset("co2-100w").unwrap();
    for file in JOBS {
        let plan = planned(file, &machine);
        let off = on(&machine, &plan) / plan.summary.total_time - 1.0;
        assert!(off.abs() < 1e-9, "{file}: {off}");
    }
}

#[test]
fn a_machine_that_pierces_longer_and_accelerates_less_is_found_from_two_jobs() {
    let machine = preset("co2-100w").unwrap();
    let mut slow = Profile { pierce_time: 0.35, ..machine.clone() };
    slow.cut.accel = Some(900.0);
    slow.mark.accel = Some(900.0);
    let found = calibrated(&slow, &machine, &JOBS);
    for job in &found.jobs {
        let (before, after) = (job.before / job.measured - 1.0, job.after / job.measured - 1.0);
        assert!(before.abs() > 0.01 && after.abs() < 0.002, "{}: {before} before, {after} after", job.name);
    }
    assert!((found.machine.pierce_time - 0.35).abs() < 0.05, "{}", found.machine.pierce_time);
    assert!(found.machine.cut.accel.unwrap() < 2000.0);
}

#[test]
fn one_job_is_enough_to_meet_its_time() {
    let machine = preset("diode-hobby").unwrap();
    let slow = Profile { pierce_time: 0.2, ..machine.clone() };
    let found = calibrated(&slow, &machine, &JOBS[..1]);
    let after = found.jobs[0].after / found.jobs[0].measured - 1.0;
    assert!(after.abs() < 0.002, "{after}");
}

#[test]
fn a_machine_that_is_right_stays_as_it_is() {
    let machine = preset("co2-100w").unwrap();
    let found = calibrated(&machine, &machine, &JOBS);
    let off =
        (found.machine.cut.accel.unwrap() / 2000.0 - 1.0).abs() + (found.machine.pierce_time - 0.1).abs();
    assert!(off < 1e-6, "{off}");
}

#[test]
fn times_that_cannot_be_are_refused_in_a_sentence() {
    let machine = preset("co2-100w").unwrap();
    let plan = planned(JOBS[1], &machine);
    for seconds in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        let refused = calibrate(&machine, &[Measured { plan: plan.clone(), seconds }]).unwrap_err();
        assert!(refused.contains("which is no time that a job takes"), "{refused}");
    }
    assert!(calibrate(&machine, &[]).unwrap_err().starts_with("There is no job to calibrate with."));
}

#[test]
fn the_page_and_the_package_fitted_machines_to_seconds_that_no_machine_near_takes() {
    let machine = preset("co2-100w").unwrap();
    let plan = planned(JOBS[1], &machine);
    let planned_time = plan.summary.total_time;
    for seconds in [1e-3, 0.01 * planned_time, 1e3 * planned_time] {
        let refused = calibrate(&machine, &[Measured { plan: plan.clone(), seconds }]).unwrap_err();
        let begins = format!(
            "{} took {seconds} s, and {planned_time:.1} s are planned: no acceleration",
            plan.input.name
        );
        assert!(refused.starts_with(&begins) && refused.contains("explain the difference."), "{refused}");
    }
    // Each of two times may be explained alone, but no machine takes both for the same plan.
    let both = [0.95, 1.6].map(|share| Measured { plan: plan.clone(), seconds: share * planned_time });
    let alone = both.iter().map(|one| calibrate(&machine, std::slice::from_ref(one)).is_ok());
    assert_eq!(alone.collect::<Vec<_>>(), [true, true]);
    let refused = calibrate(&machine, &both).unwrap_err();
    assert!(refused.contains("explain the times of all jobs together."), "{refused}");
}
