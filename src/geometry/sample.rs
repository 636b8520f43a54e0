//! A sample of a curve, against which fits are measured.

use glam::DVec2;

/// A point on the curve and the unit direction of travel there.
#[derive(Clone, Copy, Debug)]
pub(super) struct Sample {
    pub(super) point: DVec2,
    pub(super) tangent: DVec2,
}
