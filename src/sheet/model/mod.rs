//! The result of the sheet stage: contours, their nesting, parts, layers with operations, findings.

mod bridged;
mod contour;
mod options;

use super::groups::PierceGroup;
use crate::finding::Finding;
use crate::geometry::{Aabb, Path};
use crate::machine::Settings;
use crate::order::sort_by;
pub use bridged::{BridgeCut, Bridged, Strip};
pub use contour::{Contour, Pin};
pub use options::{CommonCuts, ContourChoice, Group, HandJoint, Operation, PassOrder, SheetOptions};
use serde::Serialize;
use std::sync::Arc;

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
    /// The largest distance by which ends were moved onto each other, mm ([`SheetOptions::join_tolerance`]).
    pub joined_within: f64,
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

    /// By contour: whether the machine may cut it as one with others.
    pub fn may_be_cut_as_one(&self, cuts_as_one: bool) -> Vec<bool> {
        let mut grouped = vec![false; self.contours.len()];
        for &id in self.cut_as_one(cuts_as_one).iter().flat_map(|group| &group.contours) {
            if let Some(grouped) = grouped.get_mut(id as usize) {
                *grouped = true;
            }
        }
        grouped
    }

    /// The name of a contour's layer; empty when the sheet does not know the contour.
    pub fn layer_name(&self, contour: u32) -> &str {
        let layer = self.contours.get(contour as usize).and_then(|c| self.layers.get(c.layer as usize));
        layer.map_or("", |l| l.name.as_str())
    }
}
