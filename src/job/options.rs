//! What a caller may ask for: how a drawing is read and arranged, and how it is planned.
//!
//! The structs mirror `www/sdk/protocol.ts` (camel case there); what is left out takes the default. What their fields may
//! hold is in `shapes.rs` and `ranges.rs`.

use super::ranges::{JOIN_TOLERANCE, SECONDS, TOLERANCE, WORKERS};
use super::{JobError, Warm};
use crate::dxf::{ReadOptions, TextDecoder, Unit};
use crate::fields::{Range, no_such, out_of_range};
use crate::machine::{self, Profile};
use crate::sheet::{CommonCuts, Operation, SheetOptions};
use serde::de::value::MapAccessDeserializer;
use serde::de::{MapAccess, Visitor};
use serde::{Deserialize, Deserializer, Serialize};
use std::fmt;

/// What is done with one layer.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct LayerChoice {
    /// Its name.
    pub name: String,
    /// Cut, mark or leave out.
    pub operation: Operation,
}

/// How a drawing is read and arranged.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "camelCase", default, deny_unknown_fields)]
pub struct LoadOptions {
    /// Units given by the person; otherwise header or guess.
    pub units: Option<Unit>,
    /// Largest distance between a spline or ellipse and its lines and arcs, mm.
    pub tolerance: f64,
    /// Keep entities that were read through a break in the file.
    pub keep_damaged: bool,
    /// Ends nearer than this are joined, mm.
    pub join_tolerance: f64,
    /// What is done with each layer; the order of the list is the order by layer.
    pub layers: Vec<LayerChoice>,
    /// Work layer after layer.
    pub order_by_layer: bool,
    /// Leave out the lone border around everything.
    pub ignore_outline: bool,
    /// Work a part wholly, with all that lies in its holes, before the next one.
    pub part_by_part: bool,
    /// Whether contours that share cuts are cut as one, where the machine makes pre-cuts.
    pub common_cuts: CommonCuts,
    /// Contours worked before all others, by id.
    pub first: Vec<u32>,
    /// Contours worked after all others, by id.
    pub last: Vec<u32>,
    /// Contours left out, by id.
    pub exclude: Vec<u32>,
    /// Reads names in code pages of several bytes a character. No option of the caller: the bindings set it.
    #[serde(skip)]
    pub decoder: TextDecoder,
}

impl Default for LoadOptions {
    fn default() -> Self {
        let (read, sheet) = (ReadOptions::default(), SheetOptions::default());
        Self {
            units: read.unit,
            tolerance: read.tolerance,
            keep_damaged: read.keep_damaged,
            join_tolerance: sheet.join_tolerance,
            layers: Vec::new(),
            order_by_layer: sheet.order_by_layer,
            ignore_outline: sheet.ignore_outline,
            part_by_part: sheet.part_by_part,
            common_cuts: sheet.common_cuts,
            first: sheet.first,
            last: sheet.last,
            exclude: sheet.exclude,
            decoder: read.decoder,
        }
    }
}

impl LoadOptions {
    /// For the reader.
    pub fn read_options(&self) -> Result<ReadOptions, JobError> {
        within("tolerance", self.tolerance, &TOLERANCE)?;
        Ok(ReadOptions {
            unit: self.units,
            tolerance: self.tolerance,
            keep_damaged: self.keep_damaged,
            decoder: self.decoder,
            ..ReadOptions::default()
        })
    }

    /// For the sheet.
    pub fn sheet_options(&self) -> Result<SheetOptions, JobError> {
        within("joinTolerance", self.join_tolerance, &JOIN_TOLERANCE)?;
        Ok(SheetOptions {
            join_tolerance: self.join_tolerance,
            layers: self.layers.iter().map(|l| (l.name.clone(), l.operation)).collect(),
            order_by_layer: self.order_by_layer,
            ignore_outline: self.ignore_outline,
            part_by_part: self.part_by_part,
            common_cuts: self.common_cuts,
            first: self.first.clone(),
            last: self.last.clone(),
            exclude: self.exclude.clone(),
            ..SheetOptions::default()
        })
    }
}

fn within(name: &str, n: f64, range: &Range) -> Result<(), JobError> {
    if range.holds(n) {
        return Ok(());
    }
    Err(JobError::Options(out_of_range("The option", name, n, range)))
}

/// A preset by name, or a whole profile.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(untagged)]
pub enum MachineChoice {
    /// Name of a preset.
    Preset(String),
    /// Everything given.
    Profile(Box<Profile>),
}

// By hand: serde's own untagged enums buffer whatever comes, which is 5 kB gzip of wasm.
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
    /// The profile meant, if it can be planned with.
    pub fn profile(&self) -> Result<Profile, JobError> {
        match self {
            Self::Profile(p) => {
                p.validate()?;
                Ok((**p).clone())
            }
            Self::Preset(name) => machine::preset(name).ok_or_else(|| {
                let presets = machine::presets();
                let names: Vec<&str> = presets.iter().map(|p| p.name.as_str()).collect();
                JobError::Options(no_such("machine", name, &names))
            }),
        }
    }
}

/// When to stop. The core counts moves itself; seconds are the caller's, who has a clock, and only told on.
#[derive(Clone, Copy, Debug, PartialEq, Default, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Budget {
    /// Seconds of work.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub seconds: Option<f64>,
    /// Moves of the search: the same seed and moves give the same bytes everywhere.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub moves: Option<u64>,
}

/// How a loaded drawing is planned.
#[derive(Clone, Debug, PartialEq, Default, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct PlanOptions {
    /// The machine.
    pub machine: MachineChoice,
    /// A method's name; the first of [`crate::solve::methods`] when left out.
    pub method: Option<String>,
    /// Parameters of a method from a paper: a JSON object with those that differ from the defaults. In a build without
    /// these methods they say that its code is elsewhere: what it finds is handed over by [`super::Run::offer`].
    pub parameters: Option<String>,
    /// Decides every random choice.
    pub seed: u64,
    /// A path to start from.
    pub warm: Option<Warm>,
    /// When to stop: seconds of work.
    pub seconds: Option<f64>,
    /// When to stop: moves of the search.
    pub moves: Option<u64>,
    /// Searches side by side that hand on the best path at fixed counts of moves; `None`: one.
    pub workers: Option<u32>,
    /// Which of them this is: each draws on random numbers of its own, the first on those of the seed itself.
    pub member: u32,
}

impl PlanOptions {
    /// Whether the numbers are in their ranges: callers in Rust fill the struct themselves.
    pub(super) fn check(&self) -> Result<(), JobError> {
        self.seconds.map_or(Ok(()), |s| within("seconds", s, &SECONDS))
    }

    /// Searches side by side.
    pub fn workers(&self) -> Result<u32, JobError> {
        let workers = self.workers.unwrap_or(1);
        within("workers", workers.into(), &WORKERS).map(|()| workers)
    }

    /// What decides the random choices of this member: far apart for neighbouring seeds and members.
    pub(super) fn stream(&self) -> u64 {
        // The odd constant of Weyl sequences, 2^64 / golden ratio: multiples of it are spread evenly over 64 bits.
        self.seed ^ u64::from(self.member).wrapping_mul(0x9E37_79B9_7F4A_7C15)
    }

    /// When to stop.
    pub fn budget(&self) -> Budget {
        Budget { seconds: self.seconds, moves: self.moves }
    }
}
