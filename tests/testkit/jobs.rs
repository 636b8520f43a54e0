//! Jobs with whole drawings.

use super::name;
use kerfway::job::{Job, LoadOptions, MachineChoice, PlanOptions};
use kerfway::machine::Profile;
use kerfway::plan::Plan;
use std::path::PathBuf;

/// Plans drawings with the default method, each with a machine by its number, and calls `check` with the name, the job and its
/// plan, which has passed the checker. Drawings without anything to cut are left out.
pub fn each_planned(
    paths: &[PathBuf],
    machine: impl Fn(usize) -> Profile,
    mut check: impl FnMut(&str, &Job, &Plan),
) {
    for (k, path) in paths.iter().enumerate() {
        let name = name(path);
        let Ok(mut job) = Job::load(std::fs::read(path).unwrap(), &name, &LoadOptions::default()) else {
            continue;
        };
        let options = PlanOptions {
            machine: MachineChoice::Profile(Box::new(machine(k))),
            moves: Some(2_000),
            allow_off_bed: true,
            ..PlanOptions::default()
        };
        if job.start(&options).is_err() {
            continue;
        }
        job.run_mut().unwrap().step(2_000);
        let plan = job.plan().unwrap_or_else(|e| panic!("{name}: {e}"));
        check(&name, &job, &plan);
    }
}
