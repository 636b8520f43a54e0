//! The options of a caller for a drawing: how it is read and arranged. Those for planning it are in `plan_options.rs`.
//!
//! The structs mirror `www/sdk/protocol.ts`, where names are in camel case. Missing options take their defaults.
//! `option_fields.rs` lists the fields and `ranges.rs` the ranges of their numbers.

use super::JobError;
use super::ranges::{COPY_TOLERANCE, DPI, JOIN_TOLERANCE, SHARE, TOLERANCE, TURN, within};
use crate::drawing::{ReadOptions, TextDecoder, Unit};
use crate::fields::{Fault, FieldError};
use crate::machine::Settings;
use crate::sheet::{CommonCuts, ContourChoice, Group, HandJoint, Operation, PassOrder, SheetOptions};
use serde::{Deserialize, Serialize};

/// The operation for one layer, and what it is worked with. What is not set is as the machine or the material says.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "camelCase", deny_unknown_fields)]
#[cfg_attr(test, derive(ts_rs::TS), ts(optional_fields = nullable))]
pub struct LayerChoice {
    /// Name of the layer.
    pub name: String,
    /// Cut, mark or ignore; without a choice, as for other layers, and what the layer's name suggests stays a question.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub operation: Option<Operation>,
    /// Speed along its contours, mm/s.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub speed: Option<f64>,
    /// Power as a fraction of full power, 0 to 1.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub power: Option<f64>,
    /// Least power, where the head is slow, as a fraction of full power.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub min_power: Option<f64>,
    /// Number of passes.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub passes: Option<u32>,
    /// By how much the head is lowered for each further pass, mm.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub z_step: Option<f64>,
    /// Whether the air assist is on.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub air: Option<bool>,
}

impl LayerChoice {
    /// An operation with the settings of machine and material.
    pub fn new(name: impl Into<String>, operation: Operation) -> Self {
        let (name, operation) = (name.into(), Some(operation));
        let (speed, power, min_power, passes, z_step, air) = (None, None, None, None, None, None);
        Self { name, operation, speed, power, min_power, passes, z_step, air }
    }

    /// What is set for the layer.
    fn settings(&self) -> Settings {
        let Self { speed, power, min_power, passes, z_step, air, .. } = *self;
        Settings { speed, power, min_power, passes, z_step, air }
    }
}

/// The operation for a group of contours.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct GroupChoice {
    /// The group.
    pub name: Group,
    /// Cut, mark or ignore.
    pub operation: Operation,
}

/// How a drawing is read and arranged.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "camelCase", default, deny_unknown_fields)]
#[cfg_attr(test, derive(ts_rs::TS), ts(optional_fields))]
pub struct LoadOptions {
    /// The unit of the drawing. Default: the unit that the file states, or a guess.
    pub units: Option<Unit>,
    /// Pixels per inch, for a drawing in pixels: 96 in browsers and Inkscape, 90 in Inkscape before 0.92, 72 in Illustrator.
    pub dpi: Option<f64>,
    /// Largest distance between a spline or ellipse and the lines and arcs that replace it, mm. Default 0.005.
    pub tolerance: f64,
    /// Whether entities are kept that were read across a defect in the file. Default false.
    pub keep_damaged: bool,
    /// By how many degrees the drawing is turned around its origin, counter-clockwise: 0, 90, 180 or 270. Default 0.
    pub turn: u32,
    /// Largest distance between ends that are joined, mm. Default 0.05.
    pub join_tolerance: f64,
    /// Largest distance between lines that are copies of each other, mm. Default 0.01.
    pub copy_tolerance: f64,
    /// The operation of each layer, by name. The order of the list is the order by layer.
    pub layers: Vec<LayerChoice>,
    /// Whether layers are processed one after the other. Default false.
    pub order_by_layer: bool,
    /// How contours with several passes are run: `contour`, all passes of one before the next, or `sheet`, the first pass of
    /// all, then the second. Default `contour`.
    pub pass_order: PassOrder,
    /// Whether the single border around everything is ignored even if it may be a cut. If it clearly shows the sheet, it is
    /// ignored in any case. Default false.
    pub ignore_outline: bool,
    /// Whether the border around everything is cut even if it clearly shows the sheet. Default false.
    pub keep_border: bool,
    /// The operation of groups of contours that are recognised by their look. Default: they are cut.
    pub groups: Vec<GroupChoice>,
    /// Whether a part is finished, with everything inside its holes, before the next one. Default false.
    pub part_by_part: bool,
    /// How contours that share cuts are cut on machines that make pre-cuts. Default `best`.
    pub common_cuts: CommonCuts,
    /// Contours that are processed before all others, with everything inside them, by id.
    pub first: Vec<u32>,
    /// Contours that are processed after all others, with the contours around them, by id.
    pub last: Vec<u32>,
    /// Contours to mark instead of cutting them, by id. A mark bounds no part: a hole in it becomes a part of its own.
    pub mark: Vec<u32>,
    /// Sequences of contours, by id: each contour is finished, with everything inside it, before the next one of its sequence
    /// begins. Others may be processed in between, where that is faster. A contour that is listed itself does not count as inside
    /// another one of the same sequence.
    pub sequences: Vec<Vec<u32>>,
    /// Contours to skip, by id. They stay in the list of contours with the operation `ignore`, so that the others keep their
    /// ids. A hole in a skipped contour becomes a part of its own. A side that a skipped contour shares with another
    /// contour is cut with the other one.
    pub exclude: Vec<u32>,
    /// Groups of contours, by id: all contours of a group are processed, with everything inside them, without any other in
    /// between, in the order that is fastest. A contour is in one group at most.
    pub together: Vec<Vec<u32>>,
    /// Micro-joints that are placed by hand. A contour that has such ones has no others.
    pub joints: Vec<HandJoint>,
    /// What is decided for single contours instead of the rules of the machine: the number of micro-joints, the lead.
    pub contours: Vec<ContourChoice>,
    /// Decodes text in multi-byte code pages. It is not an option of the caller; the bindings set it.
    #[serde(skip)]
    pub decoder: TextDecoder,
}

impl Default for LoadOptions {
    fn default() -> Self {
        let (read, sheet) = (ReadOptions::default(), SheetOptions::default());
        Self {
            units: read.unit,
            dpi: read.dpi,
            tolerance: read.tolerance,
            keep_damaged: read.keep_damaged,
            turn: 90 * u32::from(read.quarter_turns),
            join_tolerance: sheet.join_tolerance,
            copy_tolerance: sheet.copy_tolerance,
            layers: Vec::new(),
            order_by_layer: sheet.order_by_layer,
            pass_order: sheet.pass_order,
            ignore_outline: sheet.ignore_outline,
            keep_border: sheet.keep_border,
            groups: Vec::new(),
            part_by_part: sheet.part_by_part,
            common_cuts: sheet.common_cuts,
            first: sheet.first,
            last: sheet.last,
            mark: sheet.mark,
            sequences: sheet.sequences,
            exclude: sheet.exclude,
            together: sheet.together,
            joints: sheet.joints,
            contours: sheet.contours,
            decoder: read.decoder,
        }
    }
}

impl LoadOptions {
    /// The options of the readers.
    pub fn read_options(&self) -> Result<ReadOptions, JobError> {
        self.dpi.map_or(Ok(()), |dpi| within("dpi", dpi, &DPI))?;
        if let (Some(_), Some(unit)) = (self.dpi, self.units.filter(|u| *u != Unit::Px)) {
            let sentence = format!(
                "The drawing cannot be in {} and in pixels of a resolution (dpi). Choose one of them.",
                unit.plural()
            );
            return Err(FieldError::new(Fault::Contradiction, "dpi", sentence).into());
        }
        within("tolerance", self.tolerance, &TOLERANCE)?;
        let quarters = [0, 1, 2, 3].into_iter().find(|&k| 90 * u32::from(k) == self.turn);
        let quarter_turns = quarters
            .ok_or_else(|| FieldError::out_of_range("The option", "turn", self.turn.into(), &TURN))?;
        Ok(ReadOptions {
            unit: self.units,
            dpi: self.dpi,
            tolerance: self.tolerance,
            keep_damaged: self.keep_damaged,
            quarter_turns,
            decoder: self.decoder,
            ..ReadOptions::default()
        })
    }

    /// The options of the sheet.
    pub fn sheet_options(&self) -> Result<SheetOptions, JobError> {
        within("joinTolerance", self.join_tolerance, &JOIN_TOLERANCE)?;
        within("copyTolerance", self.copy_tolerance, &COPY_TOLERANCE)?;
        self.joints.iter().try_for_each(|j| within("joints.at", j.at, &SHARE))?;
        for layer in &self.layers {
            if let Err((field, value, range)) = crate::machine::check_settings(&layer.settings()) {
                let name = format!("layers: {}: {field}", layer.name);
                return Err(FieldError::out_of_range("The option", &name, value, &range).into());
            }
        }
        Ok(SheetOptions {
            join_tolerance: self.join_tolerance,
            copy_tolerance: self.copy_tolerance,
            layers: self.layers.iter().map(|l| (l.name.clone(), l.operation)).collect(),
            settings: self
                .layers
                .iter()
                .map(|l| (l.name.clone(), l.settings()))
                .filter(|l| !l.1.is_none())
                .collect(),
            order_by_layer: self.order_by_layer,
            pass_order: self.pass_order,
            ignore_outline: self.ignore_outline,
            keep_border: self.keep_border,
            groups: self.groups.iter().map(|g| (g.name, g.operation)).collect(),
            part_by_part: self.part_by_part,
            common_cuts: self.common_cuts,
            first: self.first.clone(),
            last: self.last.clone(),
            mark: self.mark.clone(),
            sequences: self.sequences.clone(),
            exclude: self.exclude.clone(),
            together: self.together.clone(),
            joints: self.joints.clone(),
            contours: self.contours.clone(),
        })
    }
}
