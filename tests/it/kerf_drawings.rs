//! The lines of the beam on real drawings, place by place, with arithmetic that is not the product's.
#![allow(clippy::unwrap_used, clippy::panic, clippy::float_cmp, reason = "a test fails by panicking")]
#![allow(clippy::disallowed_methods, reason = "the product's arithmetic is not to judge itself")]

use crate::testkit::paths::Element;
use cavalier_contours::polyline::{PlineSource, PlineSourceMut, Polyline};
use glam::DVec2;
use kerfway::finding::{Code, Severity};
use kerfway::geometry::{Aabb, Arc, BoxIndex, Path, Segment};
use kerfway::job::{Job, LoadOptions, MachineChoice, PlanOptions};
use kerfway::machine::{Profile, preset};
use kerfway::sheet::{Contour, Operation, Sheet};
use std::f64::consts::TAU;

fn element(s: &Segment) -> Element {
    match s {
        Segment::Line(l) => Element::line(l.start, l.end),
        Segment::Arc(a) => Element { from: a.start, to: a.end, arc: Some((a.center, a.sweep)) },
    }
}

/// An outline that is asked for distances.
struct Outline {
    elements: Vec<Element>,
    index: BoxIndex,
}

impl Outline {
    fn of(path: &Path) -> Self {
        let elements = path.segments.iter().map(element).collect();
        Self { elements, index: BoxIndex::new(path.segments.iter().map(Segment::bounds)) }
    }

    /// Distance of a place, if that is below `reach`.
    fn distance(&self, p: DVec2, reach: f64) -> f64 {
        let near = self.index.query(Aabb::of(p).grown(reach));
        near.into_iter().map(|k| self.elements[k].distance(p)).fold(reach, f64::min)
    }

    /// How often it runs around a place, from short chords.
    fn winding(&self, p: DVec2) -> f64 {
        let mut angle = 0.0;
        for e in &self.elements {
            let steps = if e.arc.is_some() { 64 } else { 1 };
            for k in 0..steps {
                let at = |k: i32| e.at(f64::from(k) / f64::from(steps)) - p;
                let (a, b) = (at(k), at(k + 1));
                angle += f64::atan2(a.perp_dot(b), a.dot(b));
            }
        }
        (angle / TAU).round()
    }
}

/// What became of the closed cuts of a sheet.
#[derive(Debug, Default, PartialEq)]
struct Tally {
    moved: usize,
    kept: usize,
    corners: usize,
}

/// Every point of an offset contour is half a kerf from its outline, on the side of the waste; only at a corner it may be farther.
fn check(contour: &Contour, drawn: &Path, half: f64, what: &str) -> usize {
    let outline = Outline::of(drawn);
    let line = contour.boundary().unwrap_or(&contour.path);
    assert!(line.largest_gap() <= 0.0, "{what}: elements that do not join");
    let corners: Vec<DVec2> = drawn.segments.iter().map(Segment::start).collect();
    let near_corners = BoxIndex::new(corners.iter().map(|p| Aabb::of(*p)));
    let mut farther = 0;
    for (k, s) in line.segments.iter().map(element).enumerate() {
        for f in [0.0, 0.21, 0.5, 0.83] {
            let p = s.at(f);
            let off = outline.distance(p, 4.0 * half + 1e-5);
            assert!(off >= half - 1e-6, "{what}: {p} is {off} mm from the outline");
            if off > half + 1e-6 {
                farther += 1;
                assert!(off <= 4.0 * half + 1e-6, "{what}: {p} is {off} mm from the outline");
                let corner = near_corners.query(Aabb::of(p).grown(off + 1e-6));
                assert!(corner.iter().any(|c| (corners[*c].distance(p) - off).abs() < 1e-6), "{what}: {p}");
            }
            // Far from everything else one place is enough.
            if f == 0.5 && k % (1 + line.segments.len() / 16) == 0 {
                assert_eq!(outline.winding(p) != 0.0, drawn.area() < 0.0, "{what}: {p} is on the wrong side");
            }
        }
    }
    farther
}

fn examine(sheet: &Sheet, kerf: f64, name: &str) -> Tally {
    let mut tally = Tally::default();
    for (id, c) in sheet.contours.iter().enumerate().filter(|(_, c)| c.operation == Operation::Cut) {
        match (&c.drawn, c.boundary()) {
            (Some(drawn), Some(_)) => {
                tally.moved += 1;
                tally.corners += check(c, drawn, 0.5 * kerf, &format!("{name}, {kerf} mm, contour {id}"));
            }
            (None, Some(_)) => tally.kept += 1,
            _ => {}
        }
    }
    tally
}

#[test]
fn real_drawings() {
    let folders = ["dxf-dev", "sheets", "qu-du-43", "plate", "hull", "regressions", "oracle"];
    let files: Vec<_> = folders
        .iter()
        .flat_map(|f| crate::testkit::files(&crate::testkit::fixtures().join(f), "dxf"))
        .collect();
    let mut all = Tally::default();
    let mut narrow: Vec<String> = Vec::new();
    for file in files {
        let name = crate::testkit::name(&file);
        let Ok(mut job) = Job::load(std::fs::read(&file).unwrap(), &name, &LoadOptions::default()) else {
            continue;
        };
        for kerf_width in [0.1, 0.3, 2.0] {
            let machine = Profile { kerf_width, ..preset("co2-100w").unwrap() };
            let machine = MachineChoice::Profile(Box::new(machine));
            if job.start(&PlanOptions { machine, ..PlanOptions::default() }).is_err() {
                continue;
            }
            // Checked.
            job.plan().unwrap_or_else(|e| panic!("{name}, {kerf_width} mm: {e}"));
            let tally = examine(job.beam_sheet(), kerf_width, &name);
            let told = &job.run().unwrap().findings;
            let kept =
                told.iter().filter(|f| f.code == Code::KerfNotApplied && f.severity == Severity::Warning);
            let more = told.iter().filter(|f| f.code == Code::More).map(|f| f.count).sum::<u32>();
            // Beyond the findings that are listed, the finding about open contours is counted with the others.
            let is_open = |c: &&Contour| c.operation == Operation::Cut && c.boundary().is_none();
            let open = job.beam_sheet().contours.iter().filter(is_open).count();
            let listed = kept.clone().count() + more as usize;
            assert!(
                listed == tally.kept || listed == tally.kept + open,
                "{name}, {kerf_width} mm: {listed} told one by one, not {} (and {open} open)",
                tally.kept
            );
            if kerf_width < 1.0 {
                narrow.extend(kept.filter(|f| f.message.contains("narrower")).map(|_| name.clone()));
                all.moved += tally.moved;
                all.kept += tally.kept;
                all.corners += tally.corners;
            }
        }
    }
    narrow.dedup();
    // Crescents between an arch and its chords, letters with counters of a tenth of a millimetre, a slit of 0.3, wedges that
    // lines cut off from crossing shapes (two of them), and a shape that is all slivers.
    let expected = [
        "mozman_ezdxf__recover01.dxf",
        "skymakerolof_dxf__issue53.dxf",
        "one-kerf-apart.dxf",
        "hole-in-two-shapes-that-share-a-side.dxf",
        "rest-beside-its-shifted-copy.dxf",
        "random-01.dxf",
    ];
    assert_eq!(narrow, expected);
    assert!(all.moved > 26_000 && all.corners > 10_000, "{all:?}");
}

/// An outline of at most half turns, as the oracle takes it.
fn polyline(path: &Path) -> Polyline<f64> {
    let mut line = Polyline::new_closed();
    for s in &path.segments {
        // Arcs of more than half a turn in two.
        let halves = if matches!(s, Segment::Arc(a) if a.sweep.abs() > 3.1) { 2 } else { 1 };
        for k in 0..halves {
            let at = s.at(f64::from(k) / f64::from(halves));
            let bulge = if let Segment::Arc(a) = s { (a.sweep / f64::from(4 * halves)).tan() } else { 0.0 };
            line.add(at.x, at.y, bulge);
        }
    }
    line
}

/// `cavalier_contours` rounds all corners: what of our lines is half a kerf from the outline is on its lines, and what of its
/// lines is not beside a corner is on ours.
#[test]
fn lines_are_the_same_as_from_another_program() {
    let fixtures = crate::testkit::fixtures();
    let (mut compared, mut places) = (0, 0);
    for file in
        ["qu-du-43/qu_du_43.dxf", "sheets/sheet_500.dxf", "dxf-dev/gdsestimating_dxf-parser__polylines.dxf"]
    {
        let mut job =
            Job::load(std::fs::read(fixtures.join(file)).unwrap(), file, &LoadOptions::default()).unwrap();
        for half in [0.1, 0.5] {
            let machine = Profile { kerf_width: 2.0 * half, ..preset("co2-100w").unwrap() };
            let machine = MachineChoice::Profile(Box::new(machine));
            job.start(&PlanOptions { machine, ..PlanOptions::default() }).unwrap();
            for c in &job.beam_sheet().contours {
                let (Some(drawn), true) = (&c.drawn, c.path.closed) else { continue };
                // To the right of the way it runs.
                let theirs = polyline(drawn).parallel_offset(-half);
                assert_eq!(theirs.len(), 1, "{file}");
                let segments = theirs[0].iter_segments().map(|(a, b)| {
                    let (from, to) = (DVec2::new(a.x, a.y), DVec2::new(b.x, b.y));
                    Arc::from_bulge(from, to, a.bulge).map_or(Segment::line(from, to), Segment::Arc)
                });
                let theirs = Path::new(segments.collect(), true);
                let (outline, ours, other) = (Outline::of(drawn), Outline::of(&c.path), Outline::of(&theirs));
                let corners: Vec<DVec2> = drawn.segments.iter().map(Segment::start).collect();
                let beside = |p: DVec2| corners.iter().any(|c| (c.distance(p) - half).abs() < 1e-4);
                for e in &ours.elements {
                    for p in [0.1, 0.5, 0.9].map(|f| e.at(f)) {
                        if outline.distance(p, 5.0 * half) < half + 1e-6 {
                            assert!(other.distance(p, half) < 1e-4, "{file}: {p}");
                            places += 1;
                        }
                    }
                }
                for e in &other.elements {
                    for p in [0.1, 0.5, 0.9].map(|f| e.at(f)) {
                        assert!(beside(p) || ours.distance(p, half) < 1e-4, "{file}: {p}");
                    }
                }
                compared += 1;
            }
        }
    }
    assert!(compared > 1_000 && places > 10_000, "{compared} {places}");
}
