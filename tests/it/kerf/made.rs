//! Drawings whose outlines are offset, machines with a kerf, and checks of the resulting jobs.

use crate::testkit::outlines::drawing;
use crate::testkit::plates::{self, rectangle};
use kerfway::finding::{Code, Finding};
use kerfway::geometry::{DVec2, Path};
use kerfway::job::{Job, LoadOptions, MachineChoice, PlanOptions};
use kerfway::machine::{Profile, preset};
use std::f64::consts::PI;

pub(crate) const KERF: f64 = 0.4;

pub(crate) fn machine(kerf_width: f64) -> Profile {
    Profile { kerf_width, ..preset("co2-100w").unwrap() }
}

pub(crate) fn thick(kerf_width: f64) -> Profile {
    Profile { kerf_width, ..plates::thick() }
}

pub(crate) fn started(bytes: Vec<u8>, machine: Profile) -> Job {
    let mut job = Job::load(bytes, "kerf.dxf", &LoadOptions::default()).unwrap();
    let machine = MachineChoice::Profile(Box::new(machine));
    job.start(&PlanOptions { machine, allow_off_bed: true, seed: 1, ..PlanOptions::default() }).unwrap();
    job.run_mut().unwrap().step(2_000);
    // Checked.
    job.plan().unwrap();
    job
}

pub(crate) fn kerfed(outlines: &[Vec<DVec2>]) -> Job {
    started(drawing(outlines), machine(KERF))
}

/// Polylines of x, y and bulge, and circles of x, y and radius, as a drawing.
pub(crate) fn bulged(polylines: &[&[[f64; 3]]], circles: &[[f64; 3]]) -> Vec<u8> {
    let mut text =
        String::from("0\nSECTION\n2\nHEADER\n9\n$INSUNITS\n70\n4\n0\nENDSEC\n0\nSECTION\n2\nENTITIES\n");
    for line in polylines {
        text += &format!("0\nLWPOLYLINE\n8\n0\n90\n{}\n70\n1\n", line.len());
        for [x, y, b] in *line {
            text += &format!("10\n{x}\n20\n{y}\n42\n{b}\n");
        }
    }
    for [x, y, r] in circles {
        text += &format!("0\nCIRCLE\n8\n0\n10\n{x}\n20\n{y}\n40\n{r}\n");
    }
    (text + "0\nENDSEC\n0\nEOF\n").into_bytes()
}

/// A rectangle with rounded corners by its lower left corner, size and radius.
pub(crate) fn rounded([x, y, w, h, r]: [f64; 5]) -> Vec<[f64; 3]> {
    let b = (PI / 8.0).tan();
    vec![
        [x + r, y, 0.0],
        [x + w - r, y, b],
        [x + w, y + r, 0.0],
        [x + w, y + h - r, b],
        [x + w - r, y + h, 0.0],
        [x + r, y + h, b],
        [x, y + h - r, 0.0],
        [x, y + r, b],
    ]
}

/// m by n rectangles of 20 by 10 that far apart.
pub(crate) fn spaced(m: usize, n: usize, gap: f64) -> Vec<Vec<DVec2>> {
    let cell = |k: usize| {
        let (x, y) = ((k % m) as f64, (k / m) as f64);
        rectangle([100.0 + (20.0 + gap) * x, 100.0 + (10.0 + gap) * y, 20.0, 10.0])
    };
    (0..m * n).map(cell).collect()
}

pub(crate) fn points(path: &Path) -> Vec<[f64; 2]> {
    let mut all: Vec<[f64; 2]> =
        path.segments.iter().map(|s| s.start().to_array().map(|v| (v * 1e6).round() / 1e6)).collect();
    all.sort_by(|a, b| a.partial_cmp(b).unwrap());
    all
}

pub(crate) fn told(job: &Job) -> Vec<&Finding> {
    job.run().unwrap().findings.iter().filter(|f| f.code == Code::KerfNotApplied).collect()
}

pub(crate) fn close(a: f64, b: f64) -> bool {
    (a - b).abs() < 1e-9
}
