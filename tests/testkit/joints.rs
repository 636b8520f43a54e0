//! Machines with micro-joints.

use kerfway::machine::{JointKind, JointRule, Joints, Profile};

/// A rule for everything: joints of 0.5 mm, `count` of them, at least 1 mm from corners.
pub fn rule(count: u32, kind: JointKind) -> JointRule {
    JointRule { count, kind, corner_clearance: 1.0, ..JointRule::default() }
}

/// The machine with these rules.
pub fn with_joints(machine: Profile, rules: Vec<JointRule>) -> Profile {
    Profile { joints: Some(Joints { rules }), ..machine }
}
