//! Nesting: which closed cut contour lies directly around each contour.
//!
//! A contour lies inside another when the other is larger, its box is around it, and a witness, a point well inside
//! the contour itself, lies inside the other. A point on the contour would not do: contours touch. Contours that
//! cross lie in each other only when their boxes do, and are reported by [`super::cross`].
//!
//! For each contour the boxes around it are tried in order of area, smallest first ([`boxes`]), so the first that
//! holds its witness is its parent, at any depth of nesting; a contour of many elements is asked through slabs
//! ([`slabs`]), so only elements at the height of the witness are looked at. All in all O(n log n) for contours
//! whose boxes do not interlock; [`LOOKED_AT`] bounds the rest.

mod boxes;
mod slabs;

use super::model::{Contour, Operation};
use crate::geometry::{DVec2, Path, interior_point, turns};
use boxes::BoxTree;
use slabs::Slabs;

/// Boxes around a contour that do not hold it are passed by up to this many times before it counts as lying in
/// none. Parts that lock into each other overlap in a handful of boxes; a thousand C-shapes in each other is no
/// sheet, but must not take a thousand times the time.
const LOOKED_AT: usize = 256;

/// Sets `inside` and `depth` of all contours. `slack` in mm: contours that touch may stick out of each other's
/// boxes by as much as ends were moved.
pub(super) fn nest(contours: &mut [Contour], slack: f64) {
    let around: Vec<u32> = (0_u32..)
        .zip(&*contours)
        .filter(|(_, c)| c.path.closed && c.operation == Operation::Cut)
        .map(|(i, _)| i)
        .collect();
    let items = around.iter().filter_map(|&i| contours.get(i as usize).map(|c| (c.bounds, c.area, i)));
    let tree = BoxTree::new(items.collect());
    let mut slabs: Vec<Option<Slabs>> = contours.iter().map(|_| None).collect();
    let mut inside = vec![None; contours.len()];
    for (i, c) in contours.iter().enumerate() {
        let witnesses = witnesses(&c.path);
        let needed = witnesses.len() / 2 + 1;
        let mut left = LOOKED_AT;
        inside[i] = tree.smallest_around(&c.bounds.grown(-slack), c.area, |j| {
            let j = j as usize;
            let other = &contours[j];
            left = left.saturating_sub(1);
            let slabs = slabs[j].get_or_insert_with(|| Slabs::new(&other.path, other.bounds));
            let holds = |p: &&DVec2| turns(slabs.at(&other.path, p.y), **p) != 0;
            if j != i && witnesses.iter().filter(holds).count() >= needed {
                boxes::Answer::Found
            } else if left == 0 {
                boxes::Answer::Stop
            } else {
                boxes::Answer::Next
            }
        });
    }
    // Parents are larger than their children, so they come first.
    let mut by_area: Vec<usize> = (0..contours.len()).collect();
    let is_parent = |c: &Contour| c.path.closed && c.operation == Operation::Cut;
    by_area.sort_by(|&a, &b| {
        let (a, b) = (&contours[a], &contours[b]);
        is_parent(b).cmp(&is_parent(a)).then(b.area.total_cmp(&a.area))
    });
    for i in by_area {
        contours[i].depth = inside[i].map_or(0, |j: u32| contours[j as usize].depth + 1);
        contours[i].inside = inside[i];
    }
}

/// Points that stand for the contour: one well inside a closed one, three on an open one.
fn witnesses(path: &Path) -> Vec<DVec2> {
    if path.closed
        && let Some(p) = interior_point(path)
    {
        return vec![p];
    }
    let n = path.segments.len();
    // Off ends and middles, where open contours like to touch others.
    let picked = [(n / 6, 0.171), (n / 2, 0.413), (n - 1 - n / 6, 0.829)];
    picked.iter().filter_map(|&(i, f)| path.segments.get(i).map(|s| s.at(f))).collect()
}
