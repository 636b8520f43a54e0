//! Resolution of the controller's 32-bit floating-point coordinates.
//!
//! GRBL and related controllers compute with floats of 24 binary digits. Up to a few metres from the origin these are
//! far finer than a motor step. Farther out the spacing between neighbouring floats doubles with the distance: 0.001 mm
//! at 16 m, 0.008 mm from 66 m, 0.016 mm from 131 m. There a contour is cut with visible steps, and the controller
//! refuses arcs in the middle of the job (error 33) because their two radii no longer agree.

use crate::geometry::{Aabb, DVec2};

/// Coarsest spacing of the controller's numbers that is accepted, mm: a tenth of a laser's kerf, about one motor step.
/// It is reached at 131,072 mm from the origin.
const COARSEST: f64 = 0.01;

/// Distance between neighbouring 32-bit floats at a coordinate, mm.
pub(crate) fn spacing(coordinate: f64) -> f64 {
    // The exponent of a double alone is the largest power of two not above it.
    let power = f64::from_bits(coordinate.abs().to_bits() & (0x7FF << 52));
    power * f64::from(f32::EPSILON)
}

/// The larger of the spacings at the two coordinates of a place, mm.
pub(crate) fn spacing_at(place: DVec2) -> f64 {
    spacing(place.abs().max_element())
}

/// A place where the controller's numbers are too coarse for cutting.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct FarOut {
    /// The place, mm.
    pub(crate) at: DVec2,
    /// Distance between neighbouring floats there, mm.
    pub(crate) spacing: f64,
}

/// The corner of a box that is farthest from the origin, if the controller's numbers are too coarse there.
pub(crate) fn far_out(bounds: &Aabb) -> Option<FarOut> {
    if bounds.is_empty() {
        return None;
    }
    let farther = |min: f64, max: f64| if min.abs() > max.abs() { min } else { max };
    let at = DVec2::new(farther(bounds.min.x, bounds.max.x), farther(bounds.min.y, bounds.max.y));
    let spacing = spacing_at(at);
    (spacing > COARSEST).then_some(FarOut { at, spacing })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn spacing_is_the_distance_to_the_next_float() {
        for v in [1.0_f32, 999.999, 4096.0, 131_071.99, 131_072.0, 1e6] {
            let next = f32::from_bits(v.to_bits() + 1) - v;
            assert!((spacing(f64::from(v)) - f64::from(next)).abs() < 1e-12, "{v}");
            assert!((spacing(f64::from(-v)) - f64::from(next)).abs() < 1e-12, "{v}");
        }
        assert!(spacing(0.0).abs() < 1e-300);
    }

    #[test]
    fn too_far_begins_at_131_metres_in_any_direction() {
        let boxed = |x: f64, y: f64| Aabb::of(DVec2::ZERO).with(DVec2::new(x, y));
        assert_eq!(far_out(&boxed(131_071.0, -131_071.0)), None);
        assert_eq!(far_out(&Aabb::EMPTY), None);
        let far = far_out(&boxed(5.0, -131_073.0)).unwrap();
        assert_eq!((far.at, far.spacing), (DVec2::new(5.0, -131_073.0), 0.015_625));
    }
}
