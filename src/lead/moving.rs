//! Which cuts and marks begin moving, with the beam on as the head starts (`levers.moving_pierce` of the machine).

use super::run::Lead;
use crate::machine::Profile;
use crate::sheet::{Contour, Operation, Sheet};

/// Rounding of an overcut, mm.
const SAME: f64 = 1e-9;

/// Whether the cut or mark of a contour by this lead begins moving: marks, and closed cuts that are cut again where the beam
/// was not through. Open contours, gaps, and contours that are worked in several passes or cut as one begin at rest.
pub fn starts_moving(sheet: &Sheet, machine: &Profile, contour: &Contour, lead: Option<&Lead>) -> bool {
    if machine.levers.moving_pierce.is_none() || sheet.process_of(contour, machine).passes > 1 {
        return false;
    }
    let again = machine.levers.cut_again(contour.length);
    let overcut = lead.map_or(0.0, |l| l.overcut);
    contour.operation == Operation::Mark || (contour.path.closed && overcut >= again - SAME)
}
