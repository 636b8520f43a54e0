//! What the planner of joints finds for a contour.

use super::stretches::Joint;
use crate::geometry::DVec2;
use crate::machine::JointKind;

/// The joints of one contour.
#[derive(Clone, Debug, PartialEq)]
pub struct ContourJoints {
    /// The joints, in order along the contour.
    pub joints: Vec<Joint>,
    /// Whether the head stops at them.
    pub kind: JointKind,
    /// What does not fit.
    pub outcome: Outcome,
}

/// How well the joints of a contour fit.
#[derive(Clone, Debug, PartialEq, Default)]
pub struct Outcome {
    /// Number of joints asked for.
    pub wanted: u32,
    /// Number of joints found.
    pub found: u32,
    /// The longest stretch without a joint and the longest allowed, mm, if it is longer.
    pub too_long: Option<[f64; 2]>,
    /// Joints placed by hand that had to be moved: where they were wanted, and by how much, mm.
    pub moved: Vec<(DVec2, f64)>,
    /// Joints placed by hand for which there is no room.
    pub left_out: Vec<DVec2>,
    /// A place on the contour, mm.
    pub at: DVec2,
}

/// Why a contour that should have joints has none.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Refusal {
    /// It is cut in several passes.
    Passes,
    /// It is cut together with others that share cuts with it.
    Group,
    /// It is open, or the open rest of a shape that shares cuts.
    Open,
    /// It crosses itself.
    CrossesItself,
}
