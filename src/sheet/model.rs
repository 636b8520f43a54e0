//! What the sheet stage hands on: contours, their nesting, parts, layers with operations, findings.

use super::groups::PierceGroup;
use crate::finding::Finding;
use crate::geometry::{Aabb, Path};
use crate::order::sort_by;
use serde::{Deserialize, Serialize};

/// What is done with a layer.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Operation {
    /// Cut through.
    Cut,
    /// Engrave a line: before the cuts, at marking speed and power.
    Mark,
    /// Leave out.
    Ignore,
}

/// What is done with cuts that contours share.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum CommonCuts {
    /// Contours that share cuts are pierced once and cut as a whole, on the best way through them that is found.
    #[default]
    Best,
    /// The same, on the way that the element insertion heuristic of Dewil et al. finds.
    Insertion,
    /// Every contour by itself; what two share is cut with one of them.
    Off,
}

/// How to build a sheet.
#[derive(Clone, Debug, PartialEq)]
pub struct SheetOptions {
    /// Ends nearer than this are joined, mm.
    pub join_tolerance: f64,
    /// Elements nearer than this everywhere are copies of each other, mm.
    pub copy_tolerance: f64,
    /// Operations given by the person, by layer name; the order given is the order by layer when `order_by_layer`.
    pub layers: Vec<(String, Operation)>,
    /// Work layer after layer, in the order of `layers`, then of the file.
    pub order_by_layer: bool,
    /// Leave out the lone border around everything.
    pub ignore_outline: bool,
    /// Work a part wholly, with all that lies in its holes, before the next one.
    pub part_by_part: bool,
    /// Whether contours that share cuts are cut as one.
    pub common_cuts: CommonCuts,
    /// Contours worked before all others, by id; what lies inside them, too.
    pub first: Vec<u32>,
    /// Contours worked after all others, by id; what lies around them, too.
    pub last: Vec<u32>,
    /// Contours left out, by id; see [`Sheet::contours`]. What lies inside one of them is no hole any more but a part of
    /// its own, and a side that one of them shared with another contour is cut with that one.
    pub exclude: Vec<u32>,
}

impl Default for SheetOptions {
    fn default() -> Self {
        Self {
            join_tolerance: 0.05,
            copy_tolerance: 0.01,
            layers: Vec::new(),
            order_by_layer: false,
            ignore_outline: false,
            part_by_part: false,
            common_cuts: CommonCuts::default(),
            first: Vec::new(),
            last: Vec::new(),
            exclude: Vec::new(),
        }
    }
}

/// Whether a contour is worked before or after all that is not pinned.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Default)]
pub enum Pin {
    /// Before.
    First,
    /// Wherever it is best.
    #[default]
    None,
    /// After.
    Last,
}

/// One contour: a closed or open chain that is cut (or marked) in one go.
#[derive(Clone, Debug, PartialEq)]
pub struct Contour {
    /// Geometry in mm. Closed ones are counter-clockwise when outer (even depth) and clockwise when holes.
    pub path: Path,
    /// The closed outline that an open contour is the rest of, when another contour cuts the side they share. It
    /// bounds a part or a hole as a closed contour does.
    pub outline: Option<Path>,
    /// The outline of what is made, as drawn, where `path` lies half a kerf beside it; see [`Sheet`].
    pub drawn: Option<Path>,
    /// Index into [`Sheet::layers`]: the layer most of its length is on.
    pub layer: u32,
    /// Cut or mark; [`Operation::Ignore`]: left out by itself.
    pub operation: Operation,
    /// The smallest cut contour around it that bounds an area.
    pub inside: Option<u32>,
    /// How many such contours lie around it.
    pub depth: u32,
    /// Length, mm.
    pub length: f64,
    /// Unsigned area of a closed one or of its outline, as drawn, mm2; 0 for other open ones.
    pub area: f64,
    /// The smallest box around it.
    pub bounds: Aabb,
    /// Worked first or last.
    pub pin: Pin,
    /// Crosses itself: its inside is in doubt.
    pub self_crossing: bool,
    /// Smallest index of the shapes it was made of: drawing order.
    pub first_shape: u32,
}

impl Contour {
    /// Whether it is worked, not left out.
    pub fn is_worked(&self) -> bool {
        self.operation != Operation::Ignore
    }

    /// What bounds an area: the path of a closed contour, or the outline that an open one is the rest of.
    pub fn boundary(&self) -> Option<&Path> {
        if self.path.closed { Some(&self.path) } else { self.outline.as_ref() }
    }

    /// The outline of what is made, where the line that is cut is not that: half a kerf beside it, or the rest of it.
    pub fn made(&self) -> Option<&Path> {
        let rest_of = self.outline.as_ref().filter(|_| self.operation == Operation::Cut);
        self.drawn.as_ref().or(rest_of)
    }

    /// Whether it bounds a part or a hole: a cut around an area.
    pub fn bounds_area(&self) -> bool {
        self.operation == Operation::Cut && self.boundary().is_some()
    }
}

/// A part: an outer contour with its holes (contours at depth + 1 inside it) and what is marked on it.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Part {
    /// Contour index of the outer contour.
    pub outer: u32,
    /// Contour indices of its holes, and of open cuts and marks on it.
    pub holes: Vec<u32>,
    /// Index of the part in whose hole this part lies.
    pub inside: Option<u32>,
}

/// A layer and what is done with it.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct LayerUse {
    /// Name.
    pub name: String,
    /// AutoCAD colour index.
    pub color: i16,
    /// What is done with it.
    pub operation: Operation,
    /// What its name suggests, where that differs.
    pub suggestion: Option<Operation>,
    /// Place in the order by layer; equal for all when not ordered.
    pub rank: u32,
    /// Contours on it.
    pub contours: u32,
}

/// Geometry that is shown but not cut.
#[derive(Clone, Debug, PartialEq)]
pub struct Ignored {
    /// Geometry, mm.
    pub path: Path,
    /// Index into [`Sheet::layers`].
    pub layer: u32,
}

/// Contours with their nesting, ready to be planned.
///
/// As built, contours are the lines drawn. For a machine with a kerf width they are the lines of the beam, and [`Contour::drawn`]
/// are the outlines of parts and holes; nesting, parts and areas are of these.
#[derive(Clone, Debug)]
pub struct Sheet {
    /// Contours to cut and mark; the index is the contour's id everywhere. In drawing order. Those left out one by one
    /// ([`SheetOptions::exclude`], the border) stay among them, to be ignored, so that the others keep their ids.
    pub contours: Vec<Contour>,
    /// Parts, in drawing order of their outer contours.
    pub parts: Vec<Part>,
    /// Layers.
    pub layers: Vec<LayerUse>,
    /// Shown, not cut: what lies on ignored layers, then the contours left out.
    pub ignored: Vec<Ignored>,
    /// The contour that looks like the sheet's border, when there is one and it is not ignored yet.
    pub outline: Option<u32>,
    /// A part is worked wholly before the next one.
    pub part_by_part: bool,
    /// Contours that share cuts; none when they are cut by themselves.
    pub groups: Vec<PierceGroup>,
    /// How ways through groups are found.
    pub common_cuts: CommonCuts,
    /// Box around all contours that are cut and marked.
    pub bounds: Aabb,
    /// Everything worth knowing.
    pub findings: Vec<Finding>,
}

impl Sheet {
    /// Contours that share cuts.
    pub fn pierce_groups(&self) -> &[PierceGroup] {
        &self.groups
    }

    /// The contours by id, in the order in which the file draws them.
    pub fn drawing_order(&self) -> Vec<u32> {
        let mut order: Vec<u32> = (0..).take(self.contours.len()).collect();
        sort_by(&mut order, |&c| [self.contours[c as usize].first_shape.into(), 0, 0]);
        order
    }

    /// Those that are cut as one: all of them by a machine that makes pre-cuts, none by others, which cut every contour by
    /// itself.
    pub fn cut_as_one(&self, makes_pre_cuts: bool) -> &[PierceGroup] {
        if makes_pre_cuts { self.pierce_groups() } else { &[] }
    }
}
