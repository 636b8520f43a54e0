//! The options of a caller for planning: the machine, the method and the budget.

use super::placement::Place;
use super::ranges::{SECONDS, WORKERS, within};
use super::{JobError, WarmPath};
use crate::fields::FieldError;
use crate::machine::{self, Profile, Start};
use serde::de::value::MapAccessDeserializer;
use serde::de::{MapAccess, Visitor};
use serde::{Deserialize, Deserializer, Serialize};
use std::fmt;

/// The name of a preset machine, or a whole profile.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(untagged)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub enum MachineChoice {
    /// Name of a preset.
    Preset(String),
    /// A profile.
    Profile(Box<Profile>),
}

// Written by hand, because serde buffers the values of untagged enums, which adds 5 kB gzip of wasm.
impl<'de> Deserialize<'de> for MachineChoice {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Choice;
        impl<'de> Visitor<'de> for Choice {
            type Value = MachineChoice;

            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("the name of a machine or a machine profile")
            }

            fn visit_str<E>(self, name: &str) -> Result<MachineChoice, E> {
                Ok(MachineChoice::Preset(name.to_owned()))
            }

            fn visit_map<A: MapAccess<'de>>(self, map: A) -> Result<MachineChoice, A::Error> {
                let profile = Profile::deserialize(MapAccessDeserializer::new(map))?;
                Ok(MachineChoice::Profile(Box::new(profile)))
            }
        }
        deserializer.deserialize_any(Choice)
    }
}

impl Default for MachineChoice {
    fn default() -> Self {
        Self::Preset("co2-100w".into())
    }
}

impl MachineChoice {
    /// The profile, if it is valid.
    pub fn profile(&self) -> Result<Profile, JobError> {
        match self {
            Self::Profile(p) => {
                p.validate()?;
                Ok((**p).clone())
            }
            Self::Preset(name) => machine::preset(name).ok_or_else(|| {
                let presets = machine::presets();
                let names: Vec<&str> = presets.iter().map(|p| p.name.as_str()).collect();
                FieldError::no_such("machine", name, &names).into()
            }),
        }
    }
}

/// When a plan ends. If both are given, the first to be reached ends it. The search counts moves itself; seconds are left
/// to the caller, who has a clock.
#[derive(Clone, Copy, Debug, PartialEq, Default, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(test, derive(ts_rs::TS), ts(optional_fields))]
pub struct Budget {
    /// Seconds of search.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub seconds: Option<f64>,
    /// Moves of the search. The same seed and moves give the same bytes everywhere.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub moves: Option<u64>,
}

/// How a loaded drawing is planned.
#[derive(Clone, Debug, PartialEq, Default, Serialize, Deserialize)]
#[serde(rename_all = "camelCase", default, deny_unknown_fields)]
#[cfg_attr(test, derive(ts_rs::TS), ts(rename = "StartOptions", optional_fields))]
pub struct PlanOptions {
    /// The name of a preset, or a profile. Default `co2-100w`.
    pub machine: MachineChoice,
    /// The name of a setting in the machine's library of materials. Default: the machine's own cutting and marking.
    pub material: Option<String>,
    /// Where the job lies on the bed. Default: as drawn.
    pub place: Option<Place>,
    /// Whether the program is in machine coordinates, or starts where the head stands. Default `absolute`.
    pub start: Start,
    /// Whether a program is written that reaches beyond the bed. Default false.
    pub allow_off_bed: bool,
    /// Name of a method. Default: the first of [`crate::solve::methods`].
    pub method: Option<String>,
    /// Parameters of a published method, as a JSON object with the values that differ from its defaults.
    pub parameters: Option<String>,
    /// Seed of all random choices.
    pub seed: u64,
    /// A path to start from.
    #[cfg_attr(test, ts(type = "WarmPath"))]
    pub warm: Option<WarmPath>,
    /// When to stop, in seconds of search.
    pub seconds: Option<f64>,
    /// When to stop, in moves of the search.
    pub moves: Option<u64>,
    /// Number of searches that run in parallel, each with its own random numbers. They exchange the best path at fixed
    /// numbers of moves, so the same number of searches gives the same bytes. A budget in moves applies to each search.
    /// Default 1.
    pub workers: Option<u32>,
    /// Index of this search among them. Each has its own stream of random numbers; the first one has the stream of the seed
    /// itself.
    pub member: u32,
}

impl PlanOptions {
    /// Checks the ranges of numbers, because callers in Rust fill the struct directly.
    pub(super) fn check(&self) -> Result<(), JobError> {
        self.seconds.map_or(Ok(()), |s| within("seconds", s, &SECONDS))
    }

    /// The machine with the material on it.
    pub(super) fn profile(&self) -> Result<Profile, JobError> {
        let profile = self.machine.profile()?;
        match &self.material {
            None => Ok(profile),
            Some(name) => Ok(profile.with_material(name)?),
        }
    }

    /// Number of parallel searches.
    pub fn workers(&self) -> Result<u32, JobError> {
        let workers = self.workers.unwrap_or(1);
        within("workers", workers.into(), &WORKERS).map(|()| workers)
    }

    /// Seed of this search. Neighbouring seeds and members give very different values.
    pub(super) fn stream(&self) -> u64 {
        // The constant of Weyl sequences, 2^64 / golden ratio, made odd: its multiples are spread evenly over 64 bits.
        self.seed ^ u64::from(self.member).wrapping_mul(0x9E37_79B9_7F4A_7C15)
    }

    /// When to stop.
    pub fn budget(&self) -> Budget {
        Budget { seconds: self.seconds, moves: self.moves }
    }
}
