//! Which arcs GRBL takes, and runs as they are meant, whatever its 32-bit numbers make of the text.
//!
//! GRBL 1.1 (`gcode.c`, error 33) compares the distance from the centre to the target with that to the position. It
//! refuses an arc where they differ by more than 0.005 mm and by more than 0.1 % of the radius, or by more than 0.5 mm.
//! It computes with 32-bit floats: of the position in machine coordinates, of the target, and of the offset to the
//! centre. Where these are coarse the radii differ although the text is right. A chord no longer than their error may
//! also turn the wrong way round, which makes a full circle of a short arc.
//!
//! The exact floats depend on how the controller turns text into a number and on its work offset, which the program does
//! not know. So the rule is applied to the worst case: each coordinate is taken to be off by [`READING`] spacings of the
//! floats there, all in the direction that hurts. Up to 8 m from the origin no arc is affected.

use crate::geometry::DVec2;
use crate::machine::spacing_at;
use std::f64::consts::SQRT_2;

/// Largest error of a coordinate as the controller reads it, in spacings of its floats: half of one each for the digits,
/// for two multiplications by powers of ten and for the sum with the work offset, and half of one as a margin.
const READING: f64 = 2.5;
/// Difference of the radii that is always taken, mm.
const ALWAYS: f64 = 0.005;
/// Difference of the radii that is never taken, mm, and the fraction of the radius that is taken between both.
const NEVER: f64 = 0.5;
const FRACTION: f64 = 0.001;
/// Coarsest spacing of the floats at the centre, mm: GRBL computes the places along an arc from the centre, to within
/// its arc tolerance of 0.002 mm. Reached where the centre is 33 m from the origin.
const CENTER_SPACING: f64 = 0.002;

/// Whether the controller runs the arc from `from` to `to` about `from + offset`, of at most half a turn, as it is.
pub(super) fn is_safe(from: DVec2, to: DVec2, offset: DVec2) -> bool {
    let center = from + offset;
    let coarsest = spacing_at(from).max(spacing_at(to)).max(spacing_at(center));
    // Two coordinates make a distance, and both places of a chord are off.
    let error = 2.0 * SQRT_2 * READING * coarsest;
    let radius = offset.length();
    let difference = (to.distance(center) - radius).abs() + error;
    let agree = difference <= ALWAYS || difference <= NEVER.min(FRACTION * radius);
    agree && from.distance(to) > 2.0 * error && spacing_at(center) <= CENTER_SPACING
}

#[cfg(test)]
mod tests {
    use super::is_safe;
    use crate::geometry::DVec2;

    #[test]
    fn only_arcs_that_the_controller_runs_as_they_are_meant_are_safe() {
        let half_turn = |at: f64, radius: f64| {
            let from = DVec2::new(at, 0.0);
            is_safe(from, from + DVec2::X * 2.0 * radius, DVec2::X * radius)
        };
        assert!(half_turn(0.0, 0.05) && half_turn(8000.0, 0.05));
        // The floats are 0.001 mm apart: 0.1 % of a large radius is more than their error, that of a small one less.
        assert!(half_turn(9000.0, 50.0) && !half_turn(9000.0, 5.0));
        // A centre 40 m away, and radii that the text itself gives wrong.
        assert!(!is_safe(DVec2::ZERO, DVec2::X, DVec2::new(0.5, 4e4)));
        assert!(!is_safe(DVec2::ZERO, DVec2::X, DVec2::new(0.51, 0.0)));
        // Shorter than the error of the floats.
        assert!(!is_safe(DVec2::new(4000.0, 0.0), DVec2::new(4000.001, 0.0), DVec2::new(0.0005, 0.1)));
    }
}
