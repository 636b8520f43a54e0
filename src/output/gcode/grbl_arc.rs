//! Decides which arcs GRBL accepts and runs correctly in spite of its 32-bit numbers.
//!
//! GRBL 1.1 (`gcode.c`, error 33) compares the distances from the centre to the target and to the current position. It
//! refuses an arc where they differ by more than 0.005 mm and by more than 0.1 % of the radius, or by more than 0.5 mm.
//! It stores the position in machine coordinates, the target, and the offset to the centre as 32-bit floats. Where
//! these are coarse, the radii differ although the text is right. A chord no longer than their error may also turn the
//! wrong way round, which makes a full circle of a short arc.
//!
//! The exact floats depend on how the controller converts text to numbers and on its work offset, which the program
//! does not know. The rule is therefore applied to the worst case: each coordinate may be off by [`COORDINATE_ERROR`] spacings
//! of the floats there, in the worst direction. Up to 8 m from the origin no arc is affected.

use crate::geometry::DVec2;
use crate::machine::spacing_at;
use std::f64::consts::SQRT_2;

/// Largest error of a coordinate in the controller, in spacings of its floats: half a spacing each for the digits, for
/// two multiplications by powers of ten and for the sum with the work offset, and another half as a margin.
const COORDINATE_ERROR: f64 = 2.5;
/// Difference of the radii that the controller always accepts, mm.
const ALWAYS_ACCEPTED: f64 = 0.005;
/// Difference of the radii that it never accepts, mm; in between, it accepts [`ACCEPTED_FRACTION`] of the radius.
const NEVER_ACCEPTED: f64 = 0.5;
const ACCEPTED_FRACTION: f64 = 0.001;
/// Coarsest spacing of the floats at the centre, mm. GRBL computes the places along an arc from the centre, within its
/// arc tolerance of 0.002 mm. It is reached where the centre is 33 m from the origin.
const CENTER_SPACING: f64 = 0.002;

/// Whether the controller runs the arc from `from` to `to` around `from + offset` correctly. The arc has at most half a
/// turn.
pub(super) fn is_safe(from: DVec2, to: DVec2, offset: DVec2) -> bool {
    let center = from + offset;
    let coarsest = spacing_at(from).max(spacing_at(to)).max(spacing_at(center));
    // Two coordinates make a distance, and both ends of a chord have errors.
    let error = 2.0 * SQRT_2 * COORDINATE_ERROR * coarsest;
    let radius = offset.length();
    let difference = (to.distance(center) - radius).abs() + error;
    let agree = difference <= ALWAYS_ACCEPTED || difference <= NEVER_ACCEPTED.min(ACCEPTED_FRACTION * radius);
    agree && from.distance(to) > 2.0 * error && spacing_at(center) <= CENTER_SPACING
}

#[cfg(test)]
mod tests {
    use super::is_safe;
    use crate::geometry::DVec2;

    #[test]
    fn only_arcs_that_the_controller_runs_correctly_are_safe() {
        let half_turn = |at: f64, radius: f64| {
            let from = DVec2::new(at, 0.0);
            is_safe(from, from + DVec2::X * 2.0 * radius, DVec2::X * radius)
        };
        assert!(half_turn(0.0, 0.05) && half_turn(8000.0, 0.05));
        // The floats are 0.001 mm apart. That error is less than 0.1 % of the large radius but more than 0.1 % of the
        // small one.
        assert!(half_turn(9000.0, 50.0) && !half_turn(9000.0, 5.0));
        // A centre 40 m away, and radii that differ in the text itself.
        assert!(!is_safe(DVec2::ZERO, DVec2::X, DVec2::new(0.5, 4e4)));
        assert!(!is_safe(DVec2::ZERO, DVec2::X, DVec2::new(0.51, 0.0)));
        // The arc is shorter than the error of the floats.
        assert!(!is_safe(DVec2::new(4000.0, 0.0), DVec2::new(4000.001, 0.0), DVec2::new(0.0005, 0.1)));
    }
}
