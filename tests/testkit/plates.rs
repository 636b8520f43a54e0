//! Drawings of parts that share cuts, and the machine that cuts them.

use crate::testkit::outlines::drawing;
use kerfway::geometry::DVec2;
use kerfway::job::{Job, LoadOptions, MachineChoice, PlanOptions, WarmPath};
use kerfway::machine::{Levers, Profile, SharedCuts, preset};
use kerfway::sheet::CommonCuts;

/// By its lower left corner, width and height.
pub(crate) fn rectangle([x, y, w, h]: [f64; 4]) -> Vec<DVec2> {
    [(0.0, 0.0), (w, 0.0), (w, h), (0.0, h)].map(|(dx, dy)| DVec2::new(x + dx, y + dy)).to_vec()
}

/// m by n rectangles of 20 by 10 with shared sides, the first at 100, 100.
pub(crate) fn grid(m: usize, n: usize) -> Vec<Vec<DVec2>> {
    let cell =
        |k: usize| rectangle([100.0 + 20.0 * (k % m) as f64, 100.0 + 10.0 * (k / m) as f64, 20.0, 10.0]);
    (0..m * n).map(cell).collect()
}

/// Four oblong parts around an island of 10 by 10, with a small part in it.
pub(crate) fn pinwheel() -> Vec<Vec<DVec2>> {
    let around =
        [[0.0, 0.0, 30.0, 20.0], [30.0, 0.0, 20.0, 30.0], [20.0, 30.0, 30.0, 20.0], [0.0, 20.0, 20.0, 30.0]];
    around
        .into_iter()
        .chain([[22.0, 22.0, 5.0, 4.0]])
        .map(|r| rectangle([r[0] + 60.0, r[1] + 40.0, r[2], r[3]]))
        .collect()
}

/// Thick plate: piercing 1 s, pre-cuts 0.3 s.
pub(crate) fn thick() -> Profile {
    Profile { pre_cut_time: Some(0.3), pierce_time: 1.0, ..preset("fibre-6kw-thick").unwrap() }
}

/// The same without pre-cuts: what shares cuts is cut as one by `levers.common_cuts`.
pub(crate) fn together() -> Profile {
    let levers = Levers { common_cuts: Some(SharedCuts::default()), ..Levers::default() };
    Profile { pre_cut_time: None, levers, ..thick() }
}

/// A drawing with its search begun.
pub(crate) fn job(
    outlines: &[Vec<DVec2>],
    common_cuts: CommonCuts,
    machine: Profile,
    warm: Option<WarmPath>,
) -> Job {
    let load = LoadOptions { common_cuts, ..LoadOptions::default() };
    let mut job = Job::load(drawing(outlines), "grid.dxf", &load).unwrap();
    let machine = MachineChoice::Profile(Box::new(machine));
    job.start(&PlanOptions { machine, allow_off_bed: true, seed: 1, warm, ..PlanOptions::default() })
        .unwrap();
    job
}
