//! The machine: what it can do ([`Profile`]), and the seconds that follow from it.

mod profile;

pub use profile::{Axes, Dialect, Process, Profile, Travel};
