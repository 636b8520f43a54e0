//! Contours too narrow for a beam: slots and holes in which no circle as wide as the beam fits.
//!
//! The width of a contour is the diameter of the largest circle inside it, so a narrow neck of a large contour does not
//! count. The search has two steps, because nearly all contours are far wider than a beam:
//!
//! 1. **A bound from area and perimeter.** The inradius r of a simple closed curve satisfies A + pi r^2 <= P r
//!    (Bonnesen; R. Osserman, "Bonnesen-style isoperimetric inequalities", Amer. Math. Monthly 86, 1979, theorem 1), so it is at
//!    least (P - sqrt(P^2 - 4 pi A)) / 2 pi. Circles and straight slots with round ends reach this bound.
//! 2. **Tangent circles.** Contours below the bound are measured by [`inscribed`].

use super::findings;
use super::model::{Contour, Operation};
use crate::drawing::Drawing;
use crate::finding::{Code, Finding, Findings, Severity};
use crate::geometry::{Budget, Path, inscribed};
use crate::number::fixed;
use std::f64::consts::PI;

/// Width below which a contour is reported while no machine is known, mm: about the kerf of the finest common cutting lasers.
pub(super) const FINEST_BEAM: f64 = 0.1;
/// Widths are compared up to this, mm, so that a slot drawn exactly as wide as the beam is not reported for rounding.
const ROUNDING: f64 = 1e-6;
/// Number of samples along each element. A circle that touches the middle of a long side is found from any sample.
const SAMPLES: u32 = 8;
/// Elements compared for each element of narrow contours on average, and at least in all. A slot of four lines needs
/// about 80 for each; an outline crumpled into less than a beam would need thousands.
const COMPARISONS_PER_ELEMENT: usize = 400;
const MIN_COMPARISONS: usize = 2_000_000;

/// Reports the closed cut contours that are narrower than `limit`.
pub(super) fn find(drawing: &Drawing, contours: &[Contour], limit: Limit, findings: &mut Findings) {
    let narrow: Vec<(&Contour, &Path)> = contours
        .iter()
        .filter_map(|c| Some((c, c.boundary()?)))
        .filter(|(c, p)| may_be_narrow(c, p, limit.width()))
        .collect();
    let elements: usize = narrow.iter().map(|(_, path)| path.segments.len()).sum();
    let mut budget = Budget::new(elements.saturating_mul(COMPARISONS_PER_ELEMENT).max(MIN_COMPARISONS));
    for (contour, path) in narrow {
        if let Some((width, at)) = inscribed(path, [limit.width(), ROUNDING], SAMPLES, &mut budget) {
            let message = limit.message(width);
            let code = Code::FeatureTooSmall;
            findings.push(findings::shape(
                drawing,
                contour.first_shape,
                code,
                Severity::Warning,
                message,
                Some(at),
            ));
        }
        if budget.is_spent() {
            let message =
                "So many short lines lie in narrow contours that not all were measured against the beam.";
            findings.push(Finding::new(Code::NotAllChecked, Severity::Warning, message));
            return;
        }
    }
}

/// What widths are measured against, mm.
#[derive(Clone, Copy, Debug)]
pub(super) enum Limit {
    /// No machine is known, or it states no kerf width.
    FinestBeam,
    /// The kerf width of the machine.
    Kerf(f64),
}

impl Limit {
    fn width(self) -> f64 {
        match self {
            Self::FinestBeam => FINEST_BEAM,
            Self::Kerf(width) => width,
        }
    }

    fn message(self, width: f64) -> String {
        let limit = match self {
            Self::FinestBeam => {
                format!("less than {FINEST_BEAM} mm: it is too small for any common laser beam")
            }
            Self::Kerf(kerf) => format!("less than the kerf of {kerf} mm: it is too small for this beam"),
        };
        format!(
            "This contour is {} mm wide at its widest place, {limit}. Widen it, or remove it from the cut.",
            fixed(width, 3)
        )
    }
}

/// Whether the contour may be narrower than `limit` according to the bound from area and perimeter.
fn may_be_narrow(contour: &Contour, path: &Path, limit: f64) -> bool {
    let perimeter = if contour.path.closed { contour.length } else { path.length() };
    let rest = (perimeter * perimeter - 4.0 * PI * contour.area).max(0.0);
    let least = (perimeter - rest.sqrt()) / PI;
    contour.operation == Operation::Cut && !contour.self_crossing && least < limit - ROUNDING
}
