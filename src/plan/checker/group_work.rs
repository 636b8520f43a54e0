//! The state of a pierce group as its cuts are followed: which of its elements are cut, and which of its areas are still held.

use super::tolerance::SAME;
use crate::geometry::{Aabb, BoxIndex, DVec2, Path, Segment, winding_number};
use crate::sheet::PierceGroup;

/// An element that a run follows begins or ends nearer to it than this, mm: far more than [`SAME`] and any rounding.
pub(super) const NEAR: f64 = 1.0;

/// The state of a group.
pub(super) struct Work<'s> {
    pub(super) group: &'s PierceGroup,
    pub(super) paths: Vec<Path>,
    /// The ends of the elements: those of the first one, those of the second one, and so on.
    ends: BoxIndex,
    /// For each area, the elements beside it.
    pub(super) beside: Vec<Vec<usize>>,
    pub(super) cut: Vec<bool>,
    /// Pre-cuts made, as contour and node.
    pub(super) ahead: Vec<(u32, u32)>,
    /// For each area, the move that cut it free.
    pub(super) free: Vec<Option<usize>>,
}

/// For each area of a group, the elements that have it on one side or on both, in order.
fn beside(group: &PierceGroup) -> Vec<Vec<usize>> {
    let mut beside = vec![Vec::new(); group.faces as usize];
    for (e, element) in group.elements.iter().enumerate() {
        let [left, right] = element.faces.map(|f| f as usize);
        beside[left].push(e);
        if left != right {
            beside[right].push(e);
        }
    }
    beside
}

impl<'s> Work<'s> {
    /// A group of which nothing is cut.
    pub(super) fn new(group: &'s PierceGroup) -> Self {
        let paths: Vec<Path> = group.elements.iter().map(|e| group.path(e)).collect();
        let ends = paths.iter().flat_map(|path| [path.start(), path.end()]);
        Self {
            group,
            ends: BoxIndex::new(ends.map(|end| end.map_or(Aabb::EMPTY, Aabb::of))),
            paths,
            beside: beside(group),
            cut: vec![false; group.elements.len()],
            ahead: Vec::new(),
            free: vec![None; group.faces as usize],
        }
    }

    /// The elements with an end no farther than this from a place, in order.
    pub(super) fn ending_near(&self, at: DVec2, far: f64) -> Vec<usize> {
        let mut near = self.ends.query(Aabb::of(at).grown(far));
        near.iter_mut().for_each(|end| *end /= 2);
        near.dedup();
        let is_near = |end: Option<DVec2>| end.is_some_and(|end| end.distance(at) <= far);
        near.retain(|&e| is_near(self.paths[e].start()) || is_near(self.paths[e].end()));
        near
    }

    /// The node at a place.
    pub(super) fn node(&self, at: DVec2) -> Option<u32> {
        let nodes = self.ending_near(at, NEAR).into_iter().flat_map(|e| self.group.elements[e].ends);
        let is_here = |n: &u32| self.group.nodes.get(*n as usize).is_some_and(|n| n.distance(at) <= SAME);
        nodes.filter(is_here).min()
    }

    /// The uncut element that a run follows within `same` mm from the position `gone` on, and the nodes from which and to which it
    /// leads. Where several elements lie on each other, it is that of the contour which the run names first.
    pub(super) fn next(&self, run: &Path, gone: f64, same: f64, named: &[u32]) -> Option<(usize, u32, u32)> {
        let at = run.at(gone)?;
        // Few elements end where the run is, which is found out before the whole run is walked through for each.
        let near = self.ending_near(at, NEAR).into_iter().filter(|&e| !self.cut[e]);
        let followed = near.filter_map(|e| self.follows(run, gone, same, e).map(|n| (e, n[0], n[1])));
        let place = |e: usize| named.iter().position(|c| *c == self.group.elements[e].contour);
        followed.min_by_key(|&(e, ..)| place(e).unwrap_or(usize::MAX))
    }

    /// Whether a run follows an element that is cut already.
    pub(super) fn repeats(&self, run: &Path, gone: f64, same: f64) -> bool {
        (0..self.paths.len()).any(|e| self.cut[e] && self.follows(run, gone, same, e).is_some())
    }

    fn follows(&self, run: &Path, gone: f64, same: f64, e: usize) -> Option<[u32; 2]> {
        let path = &self.paths[e];
        let length = path.length();
        let [a, b] = self.group.elements[e].ends;
        [(false, [a, b]), (true, [b, a])].into_iter().find_map(|(back, ends)| {
            let along = |t: f64| if back { (1.0 - t) * length } else { t * length };
            let fits = [0.0, 0.25, 0.5, 0.75, 1.0].into_iter().all(|t| {
                let (Some(p), Some(q)) = (run.at(gone + t * length), path.at(along(t))) else { return false };
                p.distance(q) <= same
            });
            (fits && gone + length <= run.length() + same).then_some(ends)
        })
    }

    /// Of two areas whose common element was just cut, the one that uncut elements no longer connect to the sheet, with all areas
    /// that are connected to it. The search goes on from both in turn and ends where they meet, which is mostly near by.
    fn parted(&self, areas: [u32; 2]) -> Vec<u32> {
        let mut is_second: Vec<Option<bool>> = vec![None; self.group.faces as usize];
        is_second[areas[0] as usize] = Some(false);
        is_second[areas[1] as usize] = Some(true);
        // The areas of both sides in the order in which they are found, and how many of them were left again.
        let (mut sides, mut left) = (areas.map(|area| vec![area]), [0, 0]);
        let (mut second, mut in_turn) = (false, true);
        loop {
            let side = usize::from(second);
            let Some(&area) = sides[side].get(left[side]) else {
                if is_second[0] != Some(second) {
                    return std::mem::take(&mut sides[side]);
                }
                // This side is held, so all of the other one is free.
                (second, in_turn) = (!second, false);
                continue;
            };
            left[side] += 1;
            let uncut = self.beside[area as usize].iter().filter(|&&e| !self.cut[e]);
            for next in uncut.flat_map(|&e| self.group.elements[e].faces) {
                match is_second[next as usize].replace(second) {
                    None => sides[side].push(next),
                    Some(known) if known != second => return Vec::new(),
                    Some(_) => {}
                }
            }
            second ^= in_turn;
        }
    }

    /// Whether one of the areas beside an element is still held.
    pub(super) fn is_held(&self, e: usize) -> bool {
        self.group.elements[e].faces.iter().any(|&f| self.free[f as usize].is_none())
    }

    /// Whether a stretch that ends at a node has been cut.
    pub(super) fn is_on_kerf(&self, node: u32) -> bool {
        let place = self.group.nodes.get(node as usize);
        place.is_some_and(|node| self.ending_near(*node, SAME).iter().any(|&e| self.cut[e]))
    }

    /// Whether an area at a node has been cut free.
    pub(super) fn is_loose(&self, node: u32) -> bool {
        let place = self.group.nodes.get(node as usize);
        let near = place.map_or_else(Vec::new, |place| self.ending_near(*place, NEAR));
        let mut elements = near.iter().map(|&e| &self.group.elements[e]);
        elements.any(|e| e.ends.contains(&node) && e.faces.iter().any(|&f| self.free[f as usize].is_some()))
    }

    /// Cuts an element at a move.
    pub(super) fn take(&mut self, e: usize, step: usize) {
        self.cut[e] = true;
        let [left, right] = self.group.elements[e].faces;
        // It connected nothing if it has the same area on both sides, and nothing that is still held if one of its areas is free.
        if left == right || [left, right].iter().any(|&f| self.free[f as usize].is_some()) {
            return;
        }
        for area in self.parted([left, right]) {
            self.free[area as usize] = Some(step);
        }
    }

    /// Whether a point lies inside an area and not on its outline.
    pub(super) fn holds(&self, face: usize, at: DVec2) -> bool {
        let boundary = self.boundary(face);
        winding_number(&boundary, at) != 0 && boundary.iter().all(|s| s.nearest(at).1 > SAME * SAME)
    }

    /// The elements around an area, with the area on their left, in no particular order.
    fn boundary(&self, face: usize) -> Vec<Segment> {
        let mut segments = Vec::new();
        let beside = self.beside.get(face).into_iter().flatten();
        for (e, path) in beside.map(|&e| (&self.group.elements[e], &self.paths[e])) {
            let sides = e.faces.map(|f| f as usize == face);
            if sides == [true, false] {
                segments.extend_from_slice(&path.segments);
            } else if sides == [false, true] {
                segments.extend(path.reversed().segments);
            }
        }
        segments
    }
}
