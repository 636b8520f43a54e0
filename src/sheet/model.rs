//! The result of the sheet stage: contours, their nesting, parts, layers with operations, findings.

use super::groups::PierceGroup;
use crate::finding::Finding;
use crate::geometry::{Aabb, DVec2, Path};
use crate::machine::{CornerKind, LeadKind, PLANS_ALL_LEVERS, Settings};
use crate::order::sort_by;
use serde::{Deserialize, Serialize};
use std::sync::Arc;

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
    /// Operations chosen by the person, by layer name. With `order_by_layer`, their order is the order of layers.
    pub layers: Vec<(String, Operation)>,
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
    /// Ids of contours that are excluded; see [`Sheet::contours`]. A hole in an excluded contour becomes a part of its
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

/// Whether a contour is processed before or after all contours that are not pinned.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Default)]
pub enum Pin {
    /// Before the others.
    First,
    /// In the order that the search chooses.
    #[default]
    None,
    /// After the others.
    Last,
}

/// A closed or open chain of elements that is cut or marked in one go.
#[derive(Clone, Debug, PartialEq)]
pub struct Contour {
    /// Geometry in mm. A closed path is counter-clockwise for outer contours (even depth) and clockwise for holes.
    pub path: Path,
    /// If it is the open rest of a closed shape because another contour cuts the side they share: the outline of that
    /// shape. It bounds a part or a hole like a closed contour.
    pub outline: Option<Path>,
    /// The outline as drawn, if `path` is offset from it by half the kerf; see [`Sheet`].
    pub drawn: Option<Path>,
    /// Index into [`Sheet::layers`] of the layer that most of its length is on.
    pub layer: u32,
    /// Cut or mark; [`Operation::Ignore`] if it is excluded individually.
    pub operation: Operation,
    /// The smallest cut contour around it that bounds an area.
    pub inside: Option<u32>,
    /// Number of such contours around it.
    pub depth: u32,
    /// Length, mm.
    pub length: f64,
    /// Unsigned area of a closed contour or of its outline, as drawn, mm2; 0 for other open contours.
    pub area: f64,
    /// The smallest box around it.
    pub bounds: Aabb,
    /// Number of its pass, from 0; it counts the passes of the contour that come before it as contours of their own.
    pub pass: u32,
    /// The contour that is the next pass over the same line, if passes are run sheet by sheet and this is not the last.
    pub next_pass: Option<u32>,
    /// Whether it is pinned to be processed first or last.
    pub pin: Pin,
    /// The sequence that it belongs to, and its place in it; see [`SheetOptions::sequences`].
    pub turn: Option<(u32, u32)>,
    /// The group that it belongs to, itself or inside another contour; see [`SheetOptions::together`].
    pub together: Option<u32>,
    /// Whether it crosses itself, so that its interior is in doubt.
    pub self_crossing: bool,
    /// Smallest index of the shapes it consists of, which gives the drawing order.
    pub first_shape: u32,
    /// If it is the open rest of a closed shape: a number that all rests of that shape share.
    pub rest_of: Option<u32>,
    /// Whether it is a skeleton cut: a straight cut through the waste, after everything else, that nobody drew.
    pub skeleton: bool,
    /// The contour with which this outline is cut, because bridges connect their parts, or itself; see [`Bridged`]. Of an open cut the
    /// outline that it completes ([`Contour::completes`]).
    pub bridged: Option<u32>,
}

/// Parts that bridges connect. The path of one contour goes around all of them; the contours of the others stay in the list with
/// [`Operation::Ignore`] and name that one.
#[derive(Clone, Debug, PartialEq)]
pub struct Bridged {
    /// The contour that goes around the parts and the strips between them: the one of least id.
    pub contour: u32,
    /// The outlines of the parts as drawn, with their contours, by id.
    pub outlines: Vec<(u32, Path)>,
    /// The strips between them, one fewer than there are parts.
    pub strips: Vec<Strip>,
    /// The contours directly inside these outlines, each with its outline. As [`Contour::inside`] they have the one that goes around all.
    pub within: Vec<(u32, u32)>,
    /// Where the machine cuts the bridges later and minds what drops and what tips: the contours of the parts that do not stay by themselves, each
    /// with the strip that holds it until last, as its place in the list.
    pub holders: Vec<(u32, usize)>,
    /// The cuts through the bridges, if the machine makes them.
    pub cuts: Vec<BridgeCut>,
}

/// A cut across one end of a strip.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct BridgeCut {
    /// Its contour.
    pub contour: u32,
    /// The contour of the part whose outline it completes.
    pub outline: u32,
    /// The strip, as its place in the list.
    pub strip: usize,
}

/// A bridge: a straight strip of material through the waste, which keeps two parts connected.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Strip {
    /// The contours of the two parts.
    pub contours: [u32; 2],
    /// Its two sides, mm: the first from where the outline of the first part is opened to where that of the second part goes on, the second
    /// back.
    pub sides: [[DVec2; 2]; 2],
}

impl Contour {
    /// Whether it is marked, not cut.
    pub fn is_mark(&self) -> bool {
        self.operation == Operation::Mark
    }

    /// Whether it is cut or marked.
    pub fn is_processed(&self) -> bool {
        self.operation != Operation::Ignore
    }

    /// Of a cut through a bridge, which nobody drew: the outline of the part that it completes where the bridge ends on it.
    pub fn completes(&self) -> Option<u32> {
        if PLANS_ALL_LEVERS && !self.path.closed { self.bridged } else { None }
    }

    /// Whether it is a cut that nobody drew: a skeleton cut, or one through a bridge.
    pub fn is_added(&self) -> bool {
        self.skeleton || self.completes().is_some()
    }

    /// The curve that bounds its area: the path of a closed contour, or the outline that an open contour is the rest
    /// of.
    pub fn boundary(&self) -> Option<&Path> {
        if self.path.closed { Some(&self.path) } else { self.outline.as_ref() }
    }

    /// The outline of the part or hole, if it differs from the path that is cut because that is offset or only a rest.
    pub fn part_outline(&self) -> Option<&Path> {
        let rest_of = self.outline.as_ref().filter(|_| self.operation == Operation::Cut);
        self.drawn.as_ref().or(rest_of)
    }

    /// Whether it is a cut that bounds a part or a hole.
    pub fn bounds_area(&self) -> bool {
        self.operation == Operation::Cut && self.boundary().is_some()
    }
}

/// A part: an outer contour with its holes (contours at depth + 1 inside it) and the marks on it.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct Part {
    /// Id of the outer contour.
    pub outer: u32,
    /// Ids of its holes, and of the open cuts and marks on it.
    pub holes: Vec<u32>,
    /// Index of the part in whose hole this part lies.
    pub inside: Option<u32>,
}

/// A layer and its operation.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct LayerUse {
    /// Name.
    pub name: String,
    /// AutoCAD colour index.
    pub color: i16,
    /// Operation of its contours.
    pub operation: Operation,
    /// Operation that its name suggests, if different.
    pub suggestion: Option<Operation>,
    /// What is set for its contours.
    #[serde(default, skip_serializing_if = "Settings::is_none")]
    #[cfg_attr(test, ts(optional, as = "Option<Settings>"))]
    pub settings: Settings,
    /// Place in the order of layers; equal for all layers when there is no such order.
    pub rank: u32,
    /// Number of contours on it.
    pub contours: u32,
}

/// Geometry that is displayed but not cut.
#[derive(Clone, Debug, PartialEq)]
pub struct Ignored {
    /// Geometry, mm.
    pub path: Path,
    /// Index into [`Sheet::layers`].
    pub layer: u32,
}

/// Contours with their nesting, ready for planning.
///
/// As built, contours are the drawn lines. For a machine with a kerf width they are the lines of the beam, and
/// [`Contour::drawn`] holds the outlines of parts and holes. Nesting, parts and areas always refer to the drawn
/// outlines.
#[derive(Clone, Debug)]
pub struct Sheet {
    /// Contours in drawing order; the index is the contour's id everywhere. Individually excluded contours
    /// ([`SheetOptions::exclude`], the border) stay in the list with [`Operation::Ignore`], so that the others keep
    /// their ids.
    pub contours: Vec<Contour>,
    /// Parts, in drawing order of their outer contours.
    pub parts: Vec<Part>,
    /// Layers, at the indices of the drawing.
    pub layers: Vec<LayerUse>,
    /// Geometry that is displayed but not cut: shapes on ignored layers, then excluded contours.
    pub ignored: Vec<Ignored>,
    /// The contour that looks like the sheet's border, if there is one and it is not ignored yet.
    pub outline: Option<u32>,
    /// Whether each part is finished before the next one.
    pub part_by_part: bool,
    /// How contours with several passes are run.
    pub pass_order: PassOrder,
    /// Contours that share cuts; empty when they are cut by themselves.
    pub groups: Vec<PierceGroup>,
    /// How paths through groups are found.
    pub common_cuts: CommonCuts,
    /// Parts that bridges connect, in ascending order of the contours that go around them.
    pub bridged: Arc<Vec<Bridged>>,
    /// Micro-joints that a person placed.
    pub joints: Vec<HandJoint>,
    /// What a person decided for single contours, by id.
    pub choices: Vec<ContourChoice>,
    /// Box around all contours that are cut or marked.
    pub bounds: Aabb,
    /// Findings of this stage.
    pub findings: Vec<Finding>,
}

impl Sheet {
    /// Contours that share cuts.
    pub fn pierce_groups(&self) -> &[PierceGroup] {
        &self.groups
    }

    /// The ids of the contours, in the order in which the file draws them.
    pub fn drawing_order(&self) -> Vec<u32> {
        let mut order: Vec<u32> = (0..).take(self.contours.len()).collect();
        sort_by(&mut order, |&c| [self.contours[c as usize].first_shape.into(), 0, 0]);
        order
    }

    /// The groups that the machine cuts as one: all of them if it cuts any as one, otherwise none.
    pub fn cut_as_one(&self, cuts_as_one: bool) -> &[PierceGroup] {
        if cuts_as_one { self.pierce_groups() } else { &[] }
    }

    /// The name of a contour's layer; empty when the sheet does not know the contour.
    pub fn layer_name(&self, contour: u32) -> &str {
        let layer = self.contours.get(contour as usize).and_then(|c| self.layers.get(c.layer as usize));
        layer.map_or("", |l| l.name.as_str())
    }
}
