//! Contours that a person leaves out one by one. They keep their places among the contours, so that the others keep their
//! ids, and lie around nothing: what was a hole in one is a part of its own.

use super::about::{count, plural};
use super::model::{Contour, Operation};
use crate::finding::{Code, Finding, Findings, Severity};
use crate::geometry::{Aabb, BoxIndex, Path, Segment};

/// Places looked at on each element of an outline: a shared stretch is at least this part of a side.
const PLACES: u32 = 16;

/// Leaves out those of these ids. A contour that had lost a side to one of them gets all of its outline back, as nobody
/// else cuts that side now; a side that it shares with a third one is then cut with both. `tolerance` in mm: what is nearer
/// lies on top of each other.
pub(super) fn leave_out(contours: &mut [Contour], ids: &[u32], tolerance: f64, findings: &mut Findings) {
    let mut gone: Vec<(Operation, Segment)> = Vec::new();
    for &id in ids {
        let Some(c) = contours.get_mut(id as usize) else { continue };
        gone.extend(c.path.segments.iter().map(|s| (c.operation, *s)));
        c.operation = Operation::Ignore;
    }
    let mut left = contours.iter().filter(|c| !c.is_worked());
    let Some(at) = left.next().and_then(|c| c.path.start()) else { return };
    let n = 1 + left.count();
    let message = format!("{} left out by choice.", plural(n, "contour", "contours"));
    findings.push(Finding::new(Code::ContourExcluded, Severity::Info, message).at(at).times(count(n)));

    let index = BoxIndex::new(gone.iter().map(|(_, s)| s.bounds().grown(tolerance)));
    let lost_to = |operation: Operation, outline: &Path| {
        outline.segments.iter().any(|side| {
            (0..PLACES).map(|k| side.at((f64::from(k) + 0.5) / f64::from(PLACES))).any(|p| {
                let near =
                    |i: usize| gone[i].0 == operation && gone[i].1.nearest(p).1 <= tolerance * tolerance;
                index.query(Aabb::EMPTY.with(p)).into_iter().any(near)
            })
        })
    };
    for i in 0..contours.len() {
        let c = &mut contours[i];
        let (operation, shape) = (c.operation, c.first_shape);
        let Some(whole) = c.outline.take_if(|outline| lost_to(operation, outline)) else { continue };
        (c.length, c.bounds, c.path) = (whole.length(), whole.bounds(), whole);
        // Other rests of the same shape are part of it again.
        let rests = contours.iter_mut().filter(|r| r.first_shape == shape && r.operation == operation);
        rests.filter(|r| !r.path.closed).for_each(|r| r.operation = Operation::Ignore);
    }
}
