//! Index of axis-parallel boxes (a packed Hilbert R-tree), for overlaps, containment and crossings among many segments.

use super::aabb::Aabb;
use crate::order::sort_by;
use static_aabb2d_index::{Control, StaticAABB2DIndex, StaticAABB2DIndexBuilder};

/// An index of boxes that is built once and queried often.
#[derive(Debug)]
pub struct BoxIndex {
    /// `None` when there are no boxes.
    tree: Option<StaticAABB2DIndex<f64>>,
    /// For each box in the tree, its index in the caller's order. Empty and non-finite boxes are not in the tree.
    ids: Vec<usize>,
}

impl BoxIndex {
    /// Builds an index; the id of a box is its index in the iteration.
    pub fn new(boxes: impl IntoIterator<Item = Aabb>) -> Self {
        Self::of(boxes.into_iter().collect())
    }

    /// The same for all kinds of iterations, so that its code is there once.
    fn of(boxes: Vec<Aabb>) -> Self {
        let (ids, kept): (Vec<usize>, Vec<Aabb>) = boxes
            .into_iter()
            .enumerate()
            .filter(|(_, b)| !b.is_empty() && b.min.is_finite() && b.max.is_finite())
            .unzip();
        let mut builder = StaticAABB2DIndexBuilder::new(kept.len());
        for b in &kept {
            builder.add(b.min.x, b.min.y, b.max.x, b.max.y);
        }
        Self { tree: builder.build().ok().filter(|_| !kept.is_empty()), ids }
    }

    /// Ids of the boxes that share a point with `area`, in ascending order.
    pub fn query(&self, area: Aabb) -> Vec<usize> {
        let mut out = Vec::new();
        self.visit(area, |i| {
            out.push(i);
            true
        });
        sort_by(&mut out, |&i| [i as u64, 0, 0]);
        out
    }

    /// Calls `visit` with the id of every box that shares a point with `area` until it returns `false`. The order is
    /// unspecified but always the same.
    pub fn visit(&self, area: Aabb, mut visit: impl FnMut(usize) -> bool) {
        let Some(tree) = &self.tree else { return };
        let mut each = |place: usize| match self.ids.get(place) {
            Some(id) if !visit(*id) => Control::Break(()),
            _ => Control::Continue,
        };
        let _: Control<()> = tree.visit_query(area.min.x, area.min.y, area.max.x, area.max.y, &mut each);
    }
}
