//! Outlines that cross as drawn, and of which one would lie inside the other with the kerf.

use super::made::{KERF, machine, started, told};
use crate::testkit::outlines::drawing;
use crate::testkit::plates::rectangle;
use kerfway::plan::check;

/// A hole that is wider than the strip it crosses by less than a kerf: offset inwards, it would lie in the strip, which keeps its line
/// because the part around the hole crosses it.
#[test]
fn a_hole_that_would_come_to_lie_in_a_strip_keeps_its_drawn_line() {
    let wider = 0.6 * KERF;
    let strip = rectangle([0.0, 0.0, 2.0, 12.0]);
    let around = rectangle([-3.0, 1.0, 8.0, 4.0]);
    let hole = rectangle([-0.5 * wider, 2.0, 2.0 + wider, 2.0]);
    let far = rectangle([40.0, 0.0, 5.0, 5.0]);
    let job = started(drawing(&[strip, around, hole, far]), machine(KERF));
    let sheet = job.beam_sheet();
    let moved: Vec<bool> = sheet.contours.iter().map(|c| c.drawn.is_some()).collect();
    assert_eq!(moved, [false, false, false, true], "strip, what is around the hole, hole, and one far away");
    assert_eq!(told(&job).len(), 3);
    assert_eq!(check(sheet, &machine(KERF), &job.plan().unwrap()), Ok(()));
}
