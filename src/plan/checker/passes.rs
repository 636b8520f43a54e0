//! Checks the passes of deep cuts: the head has the height of the pass at every cut, it is raised for air moves, and passes
//! that are contours of their own come in their order.
//!
//! The number of the pass is found from the length that was cut of a contour so far, not from the moves that announce it.

use super::tolerance::{SAME, rounding};
use super::violation::Violation;
use super::visits::Visits;
use crate::geometry::Segment;
use crate::machine::Profile;
use crate::plan::model::{Move, Plan};
use crate::sheet::Sheet;

pub(super) fn check(
    sheet: &Sheet,
    machine: &Profile,
    plan: &Plan,
    visits: &Visits,
    found: &mut Vec<Violation>,
) {
    let mut height = 0.0;
    let mut cut = vec![0.0_f64; sheet.contours.len()];
    for (step, m) in plan.moves.iter().enumerate() {
        let asked = match m {
            Move::Height { z } => {
                height = *z;
                continue;
            }
            Move::Air { .. } => 0.0,
            Move::Cut { contour, path, .. } => {
                let (Some(known), Some(cut)) =
                    (sheet.contours.get(*contour as usize), cut.get_mut(*contour as usize))
                else {
                    continue;
                };
                let slack = SAME + known.path.segments.iter().map(rounding).sum::<f64>();
                let round = ((*cut + slack) / known.path.length().max(slack)).floor();
                // After the last pass, an overcut begins a round that is not finished.
                let round = round.min(f64::from(sheet.passes_at_once(known, machine)) - 1.0);
                *cut += path.iter().map(Segment::length).sum::<f64>();
                let z_step = sheet.process_of(known, machine).z_step;
                if z_step > 0.0 { -(f64::from(known.pass) + round) * z_step } else { 0.0 }
            }
            _ => continue,
        };
        let fits = (height - asked).abs() <= SAME;
        if !fits {
            found.push(Violation::Height { step, z: height, asked });
        }
    }
    if height != 0.0 {
        found.push(Violation::Height { step: plan.moves.len(), z: height, asked: 0.0 });
    }
    for (pass, contour) in (0..).zip(&sheet.contours) {
        let Some(next) = contour.next_pass else { continue };
        if let (Some(end), Some(begin)) = (visits.ends(pass), visits.begins(next))
            && begin < end
        {
            found.push(Violation::Passes { contour: next, what: "is cut before its earlier pass" });
        }
    }
}
