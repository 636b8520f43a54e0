//! Heat (`levers.heat`): which cuts are near each other, what the search finds where they have to keep apart, and what the checker says.
#![allow(clippy::unwrap_used, clippy::indexing_slicing, reason = "tests stop where they cannot go on")]

mod chains;
mod checker;
mod order;
mod search;

use crate::testkit::sheets::machine;
use kerfway::machine::{Heat, Levers, Profile};

/// A fibre laser that minds heat.
pub(super) fn heated(heat: Heat) -> Profile {
    let levers = Levers { heat: Some(heat), ..Levers::default() };
    let machine = Profile { levers, ..machine("fibre-3kw-thin") };
    machine.validate().unwrap();
    machine
}

/// The head waits until cuts nearer than `distance` mm have cooled for some seconds.
pub(super) fn waiting(distance: f64, seconds: f64) -> Heat {
    Heat { distance, seconds, charge: None, small_holes: None }
}

/// A pair of cuts that follow each other sooner has a charge.
pub(super) fn charged(distance: f64, seconds: f64, charge: f64) -> Heat {
    Heat { charge: Some(charge), ..waiting(distance, seconds) }
}
