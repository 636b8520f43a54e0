//! How a sheet is made of a drawing: what is done with layers and contours, and in which order.

use crate::machine::{CornerKind, LeadKind, Settings};
use serde::{Deserialize, Serialize};

/// What is done with the contours of a layer.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
#[cfg_attr(test, derive(ts_rs::TS))]
pub enum Operation {
    /// Cut through.
    Cut,
    /// Mark a line, before the cuts, at marking speed and power.
    Mark,
    /// Do not cut or mark.
    Ignore,
}

/// How contours that share cuts are cut on a machine that makes pre-cuts. `best`: pierced once and cut together, on the
/// best path through them that the search finds; `insertion`: on the path of the element insertion heuristic of Dewil et
/// al.; `off`: each contour separately, and a shared cut with one of its contours.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
#[cfg_attr(test, derive(ts_rs::TS))]
pub enum CommonCuts {
    /// Contours that share cuts are pierced once and cut as a whole, along the best path through them that the search
    /// finds.
    #[default]
    Best,
    /// The same, along the path that the element insertion heuristic of Dewil et al. finds.
    Insertion,
    /// Every contour is cut by itself; a stretch shared by two contours is cut with one of them.
    Off,
}

/// A group of contours that are recognised by their look, not by a layer.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
#[cfg_attr(test, derive(ts_rs::TS))]
pub enum Group {
    /// Many small open strokes close together: single-line lettering, glyph templates.
    Lettering,
    /// Open lines that lead to lettering.
    Leaders,
}

/// How contours with several passes are run.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
#[cfg_attr(test, derive(ts_rs::TS))]
pub enum PassOrder {
    /// All passes of a contour, then the next contour.
    #[default]
    Contour,
    /// The first pass of all contours, then the second of all, and so on.
    Sheet,
}

impl PassOrder {
    /// Whether all passes of a contour follow each other.
    pub fn is_by_contour(&self) -> bool {
        *self == Self::Contour
    }
}

/// Options for building a sheet.
#[derive(Clone, Debug, PartialEq)]
pub struct SheetOptions {
    /// Largest distance between ends that are joined, mm.
    pub join_tolerance: f64,
    /// Largest distance between elements that count as copies of each other, mm.
    pub copy_tolerance: f64,
    /// Operations chosen by the person, by layer name; `None` where none was. With `order_by_layer`, their order is the order of layers.
    pub layers: Vec<(String, Option<Operation>)>,
    /// Whether to process layer after layer, in the order of `layers`, then of the file.
    pub order_by_layer: bool,
    /// What a person has set for layers, by name.
    pub settings: Vec<(String, Settings)>,
    /// How contours with several passes are run.
    pub pass_order: PassOrder,
    /// Whether to ignore the single border around everything, even where it is not clear that it is one.
    pub ignore_outline: bool,
    /// Whether to cut the border around everything, however clear it is that it shows the sheet.
    pub keep_border: bool,
    /// Operations chosen for groups of contours. The last choice for a group counts.
    pub groups: Vec<(Group, Operation)>,
    /// Whether to finish each part, with everything in its holes, before the next one.
    pub part_by_part: bool,
    /// Whether contours that share cuts are cut as one.
    pub common_cuts: CommonCuts,
    /// Ids of contours that are processed before all others, together with what lies inside them.
    pub first: Vec<u32>,
    /// Ids of contours that are processed after all others, together with what lies around them.
    pub last: Vec<u32>,
    /// Ids of contours that are marked instead of cut.
    pub mark: Vec<u32>,
    /// Sequences of contours: each is finished, together with what lies inside it, before the next one of its sequence
    /// begins. Others may be processed in between.
    pub sequences: Vec<Vec<u32>>,
    /// Ids of contours that are excluded; see [`Sheet::contours`](crate::sheet::Sheet::contours). A hole in an excluded contour becomes a part of its
    /// own, and a side shared with another contour is cut with that one.
    pub exclude: Vec<u32>,
    /// Groups of contours: all of a group are processed, with everything inside them, without any other in between. A contour
    /// is in one group at most.
    pub together: Vec<Vec<u32>>,
    /// Micro-joints that a person placed.
    pub joints: Vec<HandJoint>,
    /// What a person decided for single contours, instead of the rules of the machine.
    pub contours: Vec<ContourChoice>,
}

/// What a person decided for a contour. What is not given is as the rules of the machine say.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(test, derive(ts_rs::TS), ts(optional_fields))]
pub struct ContourChoice {
    /// The contour, by id.
    pub contour: u32,
    /// Number of its micro-joints, evenly spread; 0: none. Joints that are placed on it by hand go before this.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub joints: Option<u32>,
    /// The form of its lead-in, with the sizes of the rule that fits it; `none`: neither lead-in nor lead-out.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub lead: Option<LeadKind>,
    /// What is done at its corners, with the sizes of the machine's `levers.corners`, which it has to have.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub corners: Option<CornerKind>,
}

/// A micro-joint that a person placed on a contour. The joints of a contour that has such ones are these and no others.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(test, derive(ts_rs::TS), ts(rename = "JointChoice"))]
pub struct HandJoint {
    /// The contour, by id.
    pub contour: u32,
    /// Its middle, as a fraction of the length of the drawn contour from its start: 0 to 1.
    pub at: f64,
}

impl Default for SheetOptions {
    fn default() -> Self {
        Self {
            join_tolerance: 0.05,
            copy_tolerance: 0.01,
            layers: Vec::new(),
            order_by_layer: false,
            settings: Vec::new(),
            pass_order: PassOrder::default(),
            ignore_outline: false,
            keep_border: false,
            groups: Vec::new(),
            part_by_part: false,
            common_cuts: CommonCuts::default(),
            first: Vec::new(),
            last: Vec::new(),
            mark: Vec::new(),
            sequences: Vec::new(),
            exclude: Vec::new(),
            together: Vec::new(),
            joints: Vec::new(),
            contours: Vec::new(),
        }
    }
}
