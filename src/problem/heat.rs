//! Which cuts of a sheet heat each other, and which holes are small.

use crate::geometry::Path;
use crate::heat::Cooling;
use crate::machine::{PLANS_ALL_LEVERS, Profile};
use crate::sheet::{Contour, Operation, Sheet};
use std::sync::Arc;

/// The cuts that heat each other on a machine with `levers.heat`: marks heat too little, and skeleton cuts heat waste, after
/// everything else.
pub(super) fn cooling(sheet: &Sheet, machine: &Profile) -> Option<Arc<Cooling>> {
    let heat = machine.levers.heat.filter(|_| PLANS_ALL_LEVERS)?;
    let line = |c: &Contour| c.operation == Operation::Cut && !c.skeleton;
    let lines: Vec<Option<&Path>> = sheet.contours.iter().map(|c| line(c).then_some(&c.path)).collect();
    Cooling::new(&heat, &lines).map(Arc::new)
}

/// Whether a contour is a hole that comes before all other cuts, because it is small for the thickness of the plate.
pub(super) fn is_small_hole(contour: &Contour, machine: &Profile) -> bool {
    let small = machine.levers.heat.filter(|_| PLANS_ALL_LEVERS).and_then(|heat| heat.small_holes);
    let is_hole = contour.operation == Operation::Cut && contour.path.closed && contour.depth % 2 == 1;
    is_hole && small.is_some_and(|small| small.holds(contour.path.bounds().size().max_element()))
}
