//! Seconds of the air moves of a plan, and whether the head is lifted for them.

use super::model::Way;
use crate::geometry::DVec2;
use crate::machine::{AirTime, Lift, Profile};

/// Prices the air moves of a plan on a machine.
pub(crate) struct AirMoves {
    /// As the length of a move asks for.
    by_length: AirTime,
    lifted: Option<AirTime>,
    lift: Option<Lift>,
}

impl AirMoves {
    pub(crate) fn new(machine: &Profile) -> Self {
        Self {
            by_length: AirTime::new(machine),
            lifted: AirTime::lifted_always(machine),
            lift: machine.levers.lift_by_length(),
        }
    }

    /// Seconds of a move.
    pub(crate) fn seconds(&self, from: DVec2, to: DVec2, way: Way) -> f64 {
        match (&self.lifted, way) {
            (Some(lifted), Way::Lifted) => lifted.seconds(from, to),
            _ => self.by_length.seconds(from, to),
        }
    }

    /// Whether the head is lifted for a move.
    pub(crate) fn is_lifted(&self, from: DVec2, to: DVec2, way: Way) -> bool {
        way == Way::Lifted || self.lift.is_some_and(|lift| lift.is_for(from.distance(to)))
    }
}
