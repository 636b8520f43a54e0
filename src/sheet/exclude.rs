//! Contours that a person leaves out one by one. They keep their places among the contours, so that the others keep their
//! ids, and lie around nothing: what was a hole in one is a part of its own.

use super::about::{count, plural};
use super::model::{Contour, Operation};
use crate::finding::{Code, Finding, Findings, Severity};
use crate::geometry::{DVec2, Path, Segment};

/// Places looked at on each side of an outline: a shared stretch is at least this part of a side.
const PLACES: u32 = 16;

/// Leaves out those of these ids, and what was told of each of them alone. `tolerance` in mm: what is nearer lies on top of
/// each other.
pub(super) fn leave_out(contours: &mut [Contour], ids: &[u32], tolerance: f64, findings: &mut Findings) {
    let mut left = 0;
    let mut at = DVec2::ZERO;
    for &id in ids {
        let Some(c) = contours.get_mut(id as usize).filter(|c| c.is_worked()) else { continue };
        let operation = std::mem::replace(&mut c.operation, Operation::Ignore);
        let path = std::mem::take(&mut c.path);
        let shape = c.first_shape;
        at = path.start().unwrap_or(at);
        left += 1;
        findings.withdraw(|f| f.at == Some(at) && matches!(f.code, Code::OpenContour | Code::SeveralLayers));
        give_back(contours, &path, (operation, shape), tolerance);
        contours[id as usize].path = path;
    }
    if left > 0 {
        let message = format!("{} left out by choice.", plural(left, "contour", "contours"));
        let finding = Finding::new(Code::ContourExcluded, Severity::Info, message);
        findings.push(finding.at(at).times(count(left)));
    }
}

/// Gives contours the outline back of which the one that is gone held a side, as nobody else cuts that side now; a side
/// that they share with a third one is then cut with both.
fn give_back(contours: &mut [Contour], gone: &Path, of: (Operation, u32), tolerance: f64) {
    for i in 0..contours.len() {
        let c = &mut contours[i];
        let shape = c.first_shape;
        // What one shape was parted into gives itself nothing back.
        if c.operation != of.0 || shape == of.1 {
            continue;
        }
        let Some(whole) = c.outline.take_if(|outline| shares(outline, gone, tolerance)) else { continue };
        (c.length, c.bounds, c.path) = (whole.length(), whole.bounds(), whole);
        // Other rests of the same shape are part of it again.
        for rest in contours.iter_mut().filter(|r| r.first_shape == shape && !r.path.closed) {
            rest.operation = Operation::Ignore;
        }
    }
}

/// Whether a stretch of an outline lies on a path.
fn shares(outline: &Path, path: &Path, tolerance: f64) -> bool {
    let near = path.bounds().grown(tolerance);
    outline.segments.iter().any(|side| {
        (0..PLACES).any(|k| {
            let p = side.at((f64::from(k) + 0.5) / f64::from(PLACES));
            let on = |s: &Segment| s.nearest(p).1 <= tolerance * tolerance;
            near.contains(p) && path.segments.iter().any(on)
        })
    })
}
