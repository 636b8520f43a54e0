//! What a quote reads of a plan document.

use crate::dxf::{Unit, UnitsSource};
use crate::finding::{Code, Severity};
use crate::sheet::Operation;
use serde::de::IgnoredAny;
use serde::{Deserialize, Serialize};

/// What is read of a plan document besides its moves.
#[derive(Deserialize)]
pub(super) struct Head {
    pub(super) method: String,
    pub(super) parameters: Option<String>,
    pub(super) seed: u64,
    pub(super) budget: Budget,
    pub(super) input: Input,
    pub(super) machine: serde_json::Value,
    pub(super) options: serde_json::Value,
    pub(super) summary: Summary,
    pub(super) contours: Vec<Contour>,
    pub(super) findings: Vec<Found>,
}

#[derive(Deserialize)]
pub(super) struct Budget {
    pub(super) done: u64,
    pub(super) workers: Option<u32>,
}

/// The drawing.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Input {
    /// SHA-256 of its bytes.
    pub sha256: String,
    /// Its name.
    pub name: String,
    /// Units it is read in.
    pub units: Unit,
    /// Where they come from.
    pub units_source: UnitsSource,
}

#[derive(Deserialize)]
pub(super) struct Summary {
    pub(super) pierces: u32,
    pub(super) pre_cuts: u32,
    pub(super) cut_length: f64,
    pub(super) air_length: f64,
    pub(super) cut_time: f64,
    pub(super) air_time: f64,
    pub(super) pierce_time: f64,
    pub(super) pre_cut_time: f64,
    pub(super) macro_time: f64,
    pub(super) total_time: f64,
    pub(super) bounds: [f64; 4],
}

/// A contour of the document.
#[derive(Deserialize)]
pub(super) struct Contour {
    pub(super) closed: bool,
    pub(super) layer: String,
    pub(super) operation: Operation,
    pub(super) inside: Option<u32>,
    pub(super) length: f64,
    pub(super) area: f64,
    /// There where the line cut is not the outline.
    pub(super) drawn: Option<IgnoredAny>,
}

impl Contour {
    /// Whether it bounds a part or a hole; of one that is cut in pieces, those of others among them, one stands for it.
    pub(super) fn bounds_area(&self) -> bool {
        let drawn = self.drawn.is_some() && self.area > 0.0;
        drawn || (self.closed && self.operation == Operation::Cut)
    }

    /// Whether it frees no part.
    pub(super) fn is_open(&self) -> bool {
        !self.closed && self.drawn.is_none()
    }
}

#[derive(Deserialize)]
pub(super) struct Found {
    pub(super) code: Code,
    pub(super) severity: Severity,
    pub(super) count: u32,
}
