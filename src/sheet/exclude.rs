//! Excludes or marks single contours at a person's request. They stay in the list of contours, so that the others keep their
//! ids, but they contain nothing: a hole in an excluded contour becomes a part of its own.

use super::findings::{count, plural};
use super::model::{Contour, Operation};
use crate::finding::{Code, Finding, Findings, Severity};
use crate::geometry::{DVec2, Path, Segment};

/// Number of places tested on each side of an outline. A shared stretch is at least this fraction of a side.
const SAMPLES_PER_SIDE: u32 = 16;

/// Excludes the contours with these ids, and withdraws the findings about each of them alone. Elements within
/// `tolerance` mm of each other lie on top of each other.
pub(super) fn exclude(contours: &mut [Contour], ids: &[u32], tolerance: f64, findings: &mut Findings) {
    let rests = rests(contours);
    let mut left = 0;
    let mut at = DVec2::ZERO;
    for &id in ids {
        let Some(c) = contours.get_mut(id as usize).filter(|c| c.is_processed()) else { continue };
        let operation = std::mem::replace(&mut c.operation, Operation::Ignore);
        let path = std::mem::take(&mut c.path);
        let shape = c.rest_of;
        at = path.start().unwrap_or(at);
        left += 1;
        findings.withdraw(|f| f.at == Some(at) && f.code == Code::SeveralLayers);
        restore_outlines(contours, &rests, &path, (operation, shape), tolerance);
        contours[id as usize].path = path;
    }
    if left > 0 {
        let message = format!("{} left out by choice.", plural(left, "contour", "contours"));
        let finding = Finding::new(Code::ContourExcluded, Severity::Info, message);
        findings.push(finding.at(at).times(count(left)));
    }
}

/// Marks the contours with these ids instead of cutting them. Like excluded ones they contain nothing, and the sides they
/// share are cut with the other contour.
pub(super) fn mark(contours: &mut [Contour], ids: &[u32], tolerance: f64) {
    let rests = rests(contours);
    for &id in ids {
        let Some(c) = contours.get_mut(id as usize).filter(|c| c.operation == Operation::Cut) else {
            continue;
        };
        c.operation = Operation::Mark;
        let (path, shape) = (std::mem::take(&mut c.path), c.rest_of);
        restore_outlines(contours, &rests, &path, (Operation::Cut, shape), tolerance);
        contours[id as usize].path = path;
    }
}

/// The indices of the contours that are what is left of an outline that shared sides with others.
fn rests(contours: &[Contour]) -> Vec<usize> {
    (0..contours.len()).filter(|&i| contours[i].rest_of.is_some()).collect()
}

/// Restores the outlines of contours that shared a side with the excluded one, because nothing else cuts that side now.
/// A side that they share with a third contour is then cut with both.
fn restore_outlines(
    contours: &mut [Contour],
    rests: &[usize],
    gone: &Path,
    of: (Operation, Option<u32>),
    tolerance: f64,
) {
    for &i in rests {
        let c = &mut contours[i];
        let shape = c.rest_of;
        // The parts of one shape restore nothing to each other.
        if c.operation != of.0 || shape.is_none() || shape == of.1 {
            continue;
        }
        let Some(whole) = c.outline.take_if(|outline| shares(outline, gone, tolerance)) else { continue };
        (c.length, c.bounds, c.path, c.rest_of) = (whole.length(), whole.bounds(), whole, None);
        // The other rests of the same shape become part of the restored outline.
        for &k in rests {
            let rest = &mut contours[k];
            if rest.rest_of == shape && rest.operation == of.0 && !rest.path.closed {
                rest.operation = Operation::Ignore;
            }
        }
    }
}

/// Whether a stretch of an outline lies on a path.
fn shares(outline: &Path, path: &Path, tolerance: f64) -> bool {
    let near = path.bounds().grown(tolerance);
    outline.segments.iter().any(|side| {
        (0..SAMPLES_PER_SIDE).any(|k| {
            let p = side.at((f64::from(k) + 0.5) / f64::from(SAMPLES_PER_SIDE));
            let on = |s: &Segment| s.nearest(p).1 <= tolerance * tolerance;
            near.contains(p) && path.segments.iter().any(on)
        })
    })
}
