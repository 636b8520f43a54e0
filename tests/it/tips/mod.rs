//! What falls, what tips (`levers.tips`): which pieces may tip, ways past them, what the search finds and what the checker says.
#![allow(clippy::unwrap_used, clippy::indexing_slicing, reason = "tests stop where they cannot go on")]

mod bed;
mod chains;
mod checker;
mod fly;
mod per_axis;
mod pieces;
mod replay;
pub(crate) mod search;
mod shared;

use crate::testkit::sheets::machine;
use kerfway::machine::{Levers, Lift, Profile, RiskyMoves, Tips};

/// A fibre laser that lifts its head by 10 mm in `seconds` up and down, at rest, and knows which pieces tip.
pub(super) fn tipping(seconds: f64, tips: Tips) -> Profile {
    let lift = Lift { height: 10.0, stay_down: 0.0, at_rest: true };
    let levers = Levers { lift: Some(lift), tips: Some(tips), ..Levers::default() };
    let machine = Profile { levers, z_speed: Some(20.0 / seconds), ..machine("fibre-3kw-thin") };
    machine.validate().unwrap();
    machine
}

/// What drops is nothing, and everything below 150 mm tips.
pub(super) fn all_tip() -> Tips {
    Tips { drops_below: Some(0.0), nozzle_radius: 6.0, margin: 2.0, ..Tips::default() }
}

pub(super) fn ignored(tips: Tips) -> Tips {
    Tips { risky_moves: RiskyMoves::Ignore, ..tips }
}
