//! The document itself, with the facts about its input, search and options.

use super::super::model::{Summary, no_bridges};
use super::contour::Contour;
use super::moves::Move;
use crate::drawing::{ReadOptions, Unit, UnitsSource};
use crate::finding::Finding;
use crate::letters::same_letters;
use crate::machine::{Process, Profile, Settings, Start};
use crate::sheet::{
    CommonCuts, ContourChoice, Group, HandJoint, Operation, PassOrder, SheetOptions, Strip, usual_operation,
};
use serde::{Deserialize, Serialize};

/// The name and version of the format.
pub const SCHEMA: &str = "kerfway.plan/1";

/// A plan with everything it came from.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Document {
    /// Name and version of the format: [`SCHEMA`].
    pub schema: String,
    /// Unit of every length in the document: millimetres, whatever the drawing was in.
    pub units: Unit,
    /// Name of the search method.
    pub method: String,
    /// Parameters of a method from a paper that differ from its defaults, as a JSON object in text; `None`: all are the
    /// defaults.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub parameters: Option<String>,
    /// Decided every random choice.
    pub seed: u64,
    /// What the search was given and what it used.
    pub budget: Budget,
    /// The drawing.
    pub input: Input,
    /// The machine, with a material on it.
    pub machine: Profile,
    /// The setting of the machine's library that was used; `None`: the machine's own.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub material: Option<String>,
    /// How the drawing was read and arranged.
    pub options: Options,
    /// Where the job lies on the bed; `None`: where it was drawn.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub placement: Option<Placement>,
    /// What the plan adds up to.
    pub summary: Summary,
    /// The contours of the sheet, each at the index that is its id.
    pub contours: Vec<Contour>,
    /// Strips of material that connect parts.
    #[serde(default, skip_serializing_if = "no_bridges")]
    pub bridges: Vec<Strip>,
    /// What the head does, in order. Each move starts where the last one ended, the first at the machine's home.
    pub moves: Vec<Move>,
    /// Findings of the reader, then of the sheet, then of the plan.
    pub findings: Vec<Finding>,
}

/// What the search was given, and what it used.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Budget {
    /// Moves of the search asked for; `None`: not limited by moves.
    pub moves: Option<u64>,
    /// Seconds asked for; `None`: not limited by time.
    pub seconds: Option<f64>,
    /// Moves of the search done.
    pub done: u64,
    /// Searches side by side, each with this budget; `None`: one.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub workers: Option<u32>,
    /// The search began with a path that it was given, or the plan took over one: without it, seed and moves do not give the plan again.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub from_path: bool,
}

/// The drawing that a plan is for.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(rename = "QuoteInput"))]
pub struct Input {
    /// SHA-256 of the file's bytes, in lower-case hexadecimal.
    pub sha256: String,
    /// Name of the file, for people.
    pub name: String,
    /// Unit the drawing was taken to be in.
    pub units: Unit,
    /// Where that unit came from.
    pub units_source: UnitsSource,
    /// Pixels per inch, if the unit is a pixel.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[cfg_attr(test, ts(optional))]
    pub dpi: Option<f64>,
    /// Why the unit may be wrong, in one sentence; missing if nothing speaks against it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[cfg_attr(test, ts(optional))]
    pub units_doubt: Option<String>,
}

/// Where the job lies on the bed. Every coordinate of the document is that of the machine, shifted already.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Placement {
    /// From the coordinates of the drawing, after its turn, to those of the machine, mm.
    pub shift: [f64; 2],
    /// What the coordinates of a program mean.
    pub start: Start,
}

/// How the drawing was read and arranged.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Options {
    /// Unit given by a person; `None`: taken from the file.
    pub units: Option<Unit>,
    /// Degrees by which the drawing was turned around its origin, counter-clockwise.
    #[serde(default, skip_serializing_if = "is_zero")]
    pub turn: u32,
    /// Pixels per inch given by a person.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub dpi: Option<f64>,
    /// Largest distance between a spline or ellipse and its lines and arcs, mm.
    pub tolerance: f64,
    /// Whether entities that were read through a break in the file were kept.
    pub keep_damaged: bool,
    /// Ends nearer than this were joined, mm.
    pub join_tolerance: f64,
    /// Elements nearer than this everywhere were taken for copies, mm.
    pub copy_tolerance: f64,
    /// What a person said is done with layers; their order is the order by layer.
    pub layers: Vec<LayerOperation>,
    /// Whether layers were worked one after the other.
    pub order_by_layer: bool,
    /// How contours with several passes were run.
    #[serde(default, skip_serializing_if = "PassOrder::is_by_contour")]
    pub pass_order: PassOrder,
    /// Whether a lone border around everything was left out even if it may be a cut.
    pub ignore_outline: bool,
    /// Whether a lone border around everything was cut even if it clearly shows the sheet.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub keep_border: bool,
    /// What a person said is done with groups of contours.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub groups: Vec<GroupOperation>,
    /// Whether a part was worked wholly before the next one.
    pub part_by_part: bool,
    /// What was done with cuts that contours share.
    pub common_cuts: CommonCuts,
    /// Contours worked before all others, by id.
    pub first: Vec<u32>,
    /// Contours worked after all others, by id.
    pub last: Vec<u32>,
    /// Contours that were marked instead of cut, by id.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub mark: Vec<u32>,
    /// Sequences of contours that were worked in their order, by id.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub sequences: Vec<Vec<u32>>,
    /// Contours left out, by id.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub exclude: Vec<u32>,
    /// Groups of contours that were worked without any other in between, by id.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub together: Vec<Vec<u32>>,
    /// Micro-joints that a person placed.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub joints: Vec<HandJoint>,
    /// What a person decided for single contours.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub contours: Vec<ContourChoice>,
}

/// What is done with a group of contours.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct GroupOperation {
    /// The group.
    pub name: Group,
    /// What is done with it.
    pub operation: Operation,
}

/// What is done with a layer.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct LayerOperation {
    /// Name of the layer.
    pub name: String,
    /// What is done with it.
    pub operation: Operation,
    /// What was set for it.
    #[serde(default, skip_serializing_if = "Settings::is_none")]
    pub settings: Settings,
}

#[allow(clippy::trivially_copy_pass_by_ref, reason = "the signature that serde asks for")]
fn is_zero(turn: &u32) -> bool {
    *turn == 0
}

impl Document {
    /// What a contour was worked with: the settings of its layer over the process of the machine. Without a contour, that of
    /// a cut.
    pub fn process_by_id(&self, contour: Option<u32>) -> Process {
        let Some(contour) = contour.and_then(|id| self.contours.get(id as usize)) else {
            return self.machine.cut;
        };
        let process = self.machine.process(contour.operation == Operation::Mark);
        let named = |l: &&LayerOperation| same_letters(&l.name, &contour.layer);
        self.options.layers.iter().rev().find(named).map_or(*process, |l| l.settings.over(process))
    }

    /// The last pass of a contour of which this may be an earlier one.
    pub fn last_pass(&self, contour: u32) -> u32 {
        let mut last = contour;
        // Passes are fewer than contours, whatever a document says.
        for _ in &self.contours {
            match self.contours.get(last as usize).and_then(|c| c.next_pass) {
                Some(next) => last = next,
                None => break,
            }
        }
        last
    }

    /// Reads a plan document.
    ///
    /// # Errors
    /// One sentence: this is no plan document, or one of another version.
    pub fn read(text: &str) -> Result<Self, String> {
        // The kind first: a document of another kind has other fields, which would hide what is wrong.
        #[derive(Deserialize)]
        struct Kind {
            schema: String,
        }
        let not_a_plan = |why: &str| format!("This is not a plan of the kind {SCHEMA}: {why}.");
        match serde_json::from_str(text) {
            Ok(Kind { schema }) if schema == SCHEMA => {}
            Ok(Kind { schema }) => {
                return Err(format!("This is a document of the kind {schema}, not {SCHEMA}."));
            }
            Err(e) if e.is_data() => return Err(not_a_plan("it has no text `schema`")),
            Err(e) => {
                return Err(not_a_plan(&format!("line {}, column {} is no JSON", e.line(), e.column())));
            }
        }
        serde_json::from_str(text)
            .map_err(|e| not_a_plan(&format!("line {}, column {} does not fit it", e.line(), e.column())))
    }
}

impl Options {
    /// The options with which a drawing was read and arranged.
    pub fn of(read: &ReadOptions, arrange: &SheetOptions) -> Self {
        let layer = |(name, operation): &(String, Option<Operation>)| LayerOperation {
            name: name.clone(),
            operation: operation.unwrap_or_else(|| usual_operation(name)),
            settings: arrange.settings.iter().rev().find(|(n, _)| n == name).map_or(Settings::NONE, |s| s.1),
        };
        Self {
            units: read.unit,
            turn: 90 * u32::from(read.quarter_turns),
            dpi: read.dpi,
            tolerance: read.tolerance,
            keep_damaged: read.keep_damaged,
            join_tolerance: arrange.join_tolerance,
            copy_tolerance: arrange.copy_tolerance,
            layers: arrange.layers.iter().map(layer).collect(),
            order_by_layer: arrange.order_by_layer,
            pass_order: arrange.pass_order,
            ignore_outline: arrange.ignore_outline,
            keep_border: arrange.keep_border,
            groups: arrange
                .groups
                .iter()
                .map(|&(name, operation)| GroupOperation { name, operation })
                .collect(),
            part_by_part: arrange.part_by_part,
            common_cuts: arrange.common_cuts,
            first: arrange.first.clone(),
            last: arrange.last.clone(),
            mark: arrange.mark.clone(),
            sequences: arrange.sequences.clone(),
            exclude: arrange.exclude.clone(),
            together: arrange.together.clone(),
            joints: arrange.joints.clone(),
            contours: arrange.contours.clone(),
        }
    }
}
