//! Contours too narrow for a beam: slots and holes in which no circle as wide as the beam fits.
//!
//! The width of a contour is the diameter of the largest circle inside it, so a narrow neck of a large contour does not
//! count. The search has two steps, because nearly all contours are far wider than a beam:
//!
//! 1. **A bound from area and perimeter.** The inradius r of a simple closed curve satisfies A + pi r^2 <= P r
//!    (Bonnesen; R. Osserman, "Bonnesen-style isoperimetric inequalities", Amer. Math. Monthly 86, 1979, theorem 1), so it is at
//!    least (P - sqrt(P^2 - 4 pi A)) / 2 pi. Circles and straight slots with round ends reach this bound.
//! 2. **Tangent circles.** Contours below the bound are sampled: at each place, the largest circle that touches the
//!    line from within is reduced until it crosses no element.

use super::budget::Budget;
use super::findings;
use super::model::{Contour, Operation};
use crate::drawing::Drawing;
use crate::finding::{Code, Finding, Findings, Severity};
use crate::geometry::{Aabb, BoxIndex, DVec2, Path};
use crate::number::fixed;
use std::f64::consts::PI;

/// Width below which a contour is reported while no machine is known, mm: about the kerf of the finest common cutting lasers.
pub(super) const FINEST_BEAM: f64 = 0.1;
/// Widths are compared up to this, mm, so that a slot drawn exactly as wide as the beam is not reported for rounding.
const ROUNDING: f64 = 1e-6;
/// Number of samples along each element. A circle that touches the middle of a long side is found from any sample;
/// between the samples on a triangle's side the width changes by less than a tenth.
const SAMPLES: u32 = 8;
/// Largest number of steps in which a circle is reduced; most need two.
const MAX_SHRINKS: u32 = 24;
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
        if let Some((width, at)) = width_below(path, limit.width(), &mut budget) {
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

/// Width of a closed path and the middle of its widest place, where that is less than `limit`. Counts `budget` down.
fn width_below(path: &Path, limit: f64, budget: &mut Budget) -> Option<(f64, DVec2)> {
    let side = path.area().signum();
    let index = BoxIndex::new(path.segments.iter().map(|s| s.bounds()));
    let cap = 0.5 * limit;
    let bounds = path.bounds();
    // No circle inside is larger: a straight slot along an axis is measured by its first sample.
    let most = 0.5 * (bounds.max - bounds.min).min_element();
    let mut widest: Option<(f64, DVec2)> = None;
    for segment in &path.segments {
        for k in 0..SAMPLES {
            let f = (f64::from(k) + 0.5) / f64::from(SAMPLES);
            let (from, inward) = (segment.at(f), segment.tangent(f).perp() * side);
            let radius = tangent_circle(path, &index, (from, inward), cap, budget);
            if radius >= cap - 0.5 * ROUNDING || budget.is_spent() {
                return None;
            }
            if widest.is_none_or(|(width, _)| 2.0 * radius > width) {
                widest = Some((2.0 * radius, from + inward * radius));
            }
            if radius >= most - 0.5 * ROUNDING {
                return widest;
            }
        }
    }
    widest
}

/// Radius of the largest circle, up to `cap`, that touches the path at a place from the side of `inward` and crosses no
/// element.
fn tangent_circle(
    path: &Path,
    index: &BoxIndex,
    (from, inward): (DVec2, DVec2),
    cap: f64,
    budget: &mut Budget,
) -> f64 {
    let mut radius = cap;
    for _ in 0..MAX_SHRINKS {
        let center = from + inward * radius;
        let within = (radius - 0.5 * ROUNDING).max(0.0);
        let mut nearest = within * within;
        let mut touched = None;
        index.visit(Aabb::of(center).grown(radius), |k| {
            let goes_on = budget.take();
            if let Some(segment) = path.segments.get(k) {
                let (f, d2) = segment.nearest(center);
                if d2 < nearest {
                    (nearest, touched) = (d2, Some(segment.at(f)));
                }
            }
            goes_on
        });
        // The circle through this point that touches the path at the same place.
        let Some(away) = touched.map(|p| p - from) else { break };
        let along = away.dot(inward);
        if along <= 0.0 {
            break;
        }
        radius = radius.min(0.5 * away.length_squared() / along);
    }
    radius
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::{Arc, Segment};

    fn polygon(corners: &[(f64, f64)]) -> Path {
        let at = |k: usize| DVec2::from(corners[k % corners.len()]);
        Path::new((0..corners.len()).map(|k| Segment::line(at(k), at(k + 1))).collect(), true)
    }

    fn width(path: &Path, limit: f64) -> Option<f64> {
        width_below(path, limit, &mut Budget::new(1_000_000)).map(|(width, _)| width)
    }

    #[test]
    fn width_is_the_diameter_of_the_largest_inner_circle() {
        let slot = polygon(&[(0.0, 0.0), (5.0, 0.0), (5.0, 0.05), (0.0, 0.05)]);
        for path in [&slot, &slot.reversed()] {
            assert!((width(path, 0.1).unwrap() - 0.05).abs() < 1e-6);
            assert_eq!(width(path, 0.05), None);
        }
        let hole = Path::new(vec![Segment::Arc(Arc::circle(DVec2::new(300.0, 70.0), 0.05))], true);
        assert!((width(&hole, 0.3).unwrap() - 0.1).abs() < 1e-6);
        assert_eq!(width(&hole, 0.1), None);
        // A right triangle of sides 0.3, 0.4 and 0.5 holds a circle of radius 0.1.
        let triangle = width(&polygon(&[(0.0, 0.0), (0.4, 0.0), (0.0, 0.3)]), 0.3).unwrap();
        assert!(triangle <= 0.2 + 1e-9 && triangle > 0.18, "{triangle}");
    }

    #[test]
    fn a_bent_slot_is_narrow_and_a_neck_of_a_large_contour_is_not() {
        let bent = polygon(&[(0.0, 0.0), (5.0, 0.0), (5.0, 5.0), (4.95, 5.0), (4.95, 0.05), (0.0, 0.05)]);
        // In the corner a circle reaches a little into both legs: its diameter is 2 (2 - sqrt 2) times the width at most.
        let bent = width(&bent, 0.2).unwrap();
        assert!((0.05..=0.05859).contains(&bent), "{bent}");
        let dumbbell = polygon(&[
            (0.0, 0.0),
            (5.0, 0.0),
            (5.0, 2.48),
            (9.0, 2.48),
            (9.0, 0.0),
            (14.0, 0.0),
            (14.0, 5.0),
            (9.0, 5.0),
            (9.0, 2.52),
            (5.0, 2.52),
            (5.0, 5.0),
            (0.0, 5.0),
        ]);
        assert_eq!(width(&dumbbell, 0.3), None);
    }
}
