//! Real drawings on a machine for thick plate: pierce groups, pre-cuts, pauses, every plan checked.
#![allow(
    clippy::unwrap_used,
    clippy::panic,
    clippy::disallowed_methods,
    reason = "a test fails by panicking"
)]

use kerfway::job::{Job, LoadOptions, MachineChoice, PlanOptions};

/// The job's own output checks the plan; what the search counts is what the plan takes.
#[test]
fn every_real_drawing_is_planned_soundly() {
    let (mut planned, mut groups, mut pre_cuts) = (0, 0, 0);
    let fixtures = crate::testkit::fixtures();
    let mut files = crate::testkit::files(&fixtures.join("dxf-dev"), "dxf");
    files.extend(crate::testkit::files(&fixtures.join("regressions"), "dxf"));
    for file in files {
        let name = crate::testkit::name(&file);
        let Ok(mut job) = Job::load(std::fs::read(&file).unwrap(), &name, &LoadOptions::default()) else {
            continue;
        };
        let machine = MachineChoice::Preset("fibre-6kw-plate".into());
        if job.start(&PlanOptions { machine, seed: 1, ..PlanOptions::default() }).is_err() {
            continue;
        }
        job.run_mut().unwrap().step(20_000);
        let plan = job.plan().unwrap_or_else(|e| panic!("{name}: {e}"));
        let run = job.run().unwrap();
        let fixed: f64 = run.problem().items.iter().map(|i| i.fixed).sum();
        let (sum, total) = (fixed + run.best().cost, plan.summary.total_time);
        assert!((sum - total).abs() < 1e-9 * total, "{name}: {sum}, not {total}");
        planned += 1;
        groups += job.sheet().groups.len();
        pre_cuts += plan.summary.pre_cuts;
    }
    assert!(planned >= 20 && pre_cuts > 20, "{planned} planned, {groups} groups, {pre_cuts} pre-cuts");
}
