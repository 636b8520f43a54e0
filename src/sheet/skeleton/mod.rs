//! Skeleton cuts: straight cuts through the waste, and what remains of the sheet.
//!
//! 1. **The sheet** ([`outline`]): the smallest closed outline that is drawn around everything and not cut, otherwise the bed.
//! 2. **The remainder** ([`remainder`]): if a strip is to be kept, the largest one at an edge of the sheet that no part reaches
//!    is cut off in one piece, and the other cuts end there.
//! 3. **The grid** ([`grid`]): lines divide the rest evenly. Each is cut where it keeps its distance from everything else that
//!    is worked ([`blocked`]), and long stretches leave joints.
//!
//! Every stretch becomes an open contour after all others, on a layer of its own that is cut last.

mod blocked;
mod fault;
mod grid;
mod outline;
mod remainder;

use super::model::{Contour, LayerUse, Operation, Pin, Sheet};
use crate::geometry::{Aabb, Path, Segment};
use crate::letters::same_letters;
use crate::machine::{Profile, Settings, Skeleton};
use fault::SkeletonFault;
use grid::Grid;

/// The colour of the layer of skeleton cuts: AutoCAD's grey.
const GREY: i16 = 8;
/// Name of their layer. If the drawing has such a layer, a number is added.
const LAYER: &str = "SKELETON";

impl Sheet {
    /// The sheet with the skeleton cuts that a machine asks for; `None` if it asks for none. `machine` is in the coordinates of
    /// the sheet.
    pub(crate) fn with_skeleton(&self, machine: &Profile) -> Result<Option<Self>, SkeletonFault> {
        let Some(skeleton) = &machine.skeleton else { return Ok(None) };
        let layer = u32::try_from(self.layers.len()).unwrap_or(u32::MAX);
        let cuts = self.skeleton_cuts(skeleton, machine)?;
        let mut sheet = self.clone();
        sheet.layers.push(LayerUse {
            name: self.free_layer_name(),
            color: GREY,
            operation: Operation::Cut,
            suggestion: None,
            settings: Settings::NONE,
            rank: 1 + self.layers.iter().map(|l| l.rank).max().unwrap_or(0),
            contours: u32::try_from(cuts.len()).unwrap_or(u32::MAX),
        });
        for path in cuts {
            let bounds = path.bounds();
            sheet.bounds = sheet.bounds.union(bounds);
            sheet.contours.push(Contour { length: path.length(), bounds, path, ..contour(layer) });
        }
        Ok(Some(sheet))
    }

    /// The edge of the sheet: the smallest closed outline that is drawn around everything and not cut; `None` if there is none. A bed may be
    /// larger than the sheet on it.
    pub(crate) fn edge(&self) -> Option<&Path> {
        outline::drawn(self)
    }

    /// The stretches that are cut, without an order.
    fn skeleton_cuts(&self, skeleton: &Skeleton, machine: &Profile) -> Result<Vec<Path>, SkeletonFault> {
        let outline = outline::of(self, machine)?;
        let strip = skeleton.remainder.and_then(|least| remainder::strip(self, &outline, skeleton, least));
        let grid = Grid::new(self, &outline, skeleton, machine.kerf_width);
        let room = outline.bounds();
        let (room, cut) = strip.map_or((room, None), |s| (s.rest, Some(s.cut)));
        let mut lines = grid.lines(room)?;
        lines.extend(cut);
        let cuts = lines.iter().flat_map(|line| {
            let over = if Some(*line) == cut { outline.bounds() } else { room };
            grid.stretches(*line, over, &lines)
        });
        Ok(cuts.map(|(a, b)| Path::new(vec![Segment::line(a, b)], false)).collect())
    }

    /// The outline of what is left of the sheet for another job: the strip that is cut off, or the outline of the sheet and the
    /// lines along which parts are cut out of it. `machine` is in the coordinates of the sheet.
    pub(crate) fn remainder(&self, machine: &Profile) -> Result<Vec<Path>, SkeletonFault> {
        let outline = outline::of(self, machine)?;
        let strip = machine.skeleton.as_ref().and_then(|skeleton| {
            remainder::strip(self, &outline, skeleton, skeleton.remainder?).map(|strip| strip.path)
        });
        Ok(match strip {
            Some(strip) => vec![strip],
            None => std::iter::once(outline).chain(blocked::outermost(self).cloned()).collect(),
        })
    }

    fn free_layer_name(&self) -> String {
        let taken = |name: &str| self.layers.iter().any(|l| same_letters(&l.name, name));
        let mut name = LAYER.to_owned();
        // There are fewer layers than numbers.
        for number in 2..u32::MAX {
            if !taken(&name) {
                break;
            }
            name = format!("{LAYER} {number}");
        }
        name
    }
}

/// A skeleton cut without its geometry.
fn contour(layer: u32) -> Contour {
    Contour {
        path: Path::new(Vec::new(), false),
        outline: None,
        drawn: None,
        layer,
        operation: Operation::Cut,
        inside: None,
        depth: 0,
        length: 0.0,
        area: 0.0,
        bounds: Aabb::EMPTY,
        pass: 0,
        next_pass: None,
        pin: Pin::Last,
        turn: None,
        together: None,
        self_crossing: false,
        first_shape: u32::MAX,
        rest_of: None,
        skeleton: true,
        bridged: None,
    }
}
