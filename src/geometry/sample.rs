//! A sample of a curve: what fits are measured against.

use glam::DVec2;

/// A place on the curve and the unit direction of travel there.
#[derive(Clone, Copy, Debug)]
pub(super) struct Sample {
    pub(super) point: DVec2,
    pub(super) tangent: DVec2,
}
