//! A pierce group: contours that share cuts, as a planar graph.

use crate::geometry::{DVec2, Path, Segment};

/// Contours that share cuts.
#[derive(Clone, Debug, PartialEq)]
pub struct PierceGroup {
    /// Contour ids, ascending; the first one represents the group.
    pub contours: Vec<u32>,
    /// Their paths in the group. They equal those of the sheet except for a vertex at each node, which is moved by at
    /// most the copy tolerance. The contours themselves stay unchanged for machines that cut them one by one.
    pub paths: Vec<Path>,
    /// Points where elements end, mm.
    pub nodes: Vec<DVec2>,
    /// Stretches of its contours between nodes.
    pub elements: Vec<GroupElement>,
    /// Number of faces; face 0 is the outer one.
    pub faces: u32,
    /// Contours inside the bounded faces of the group, at any depth.
    pub inside: Vec<u32>,
}

/// A stretch of a contour between two nodes of its group.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GroupElement {
    /// Id of the contour.
    pub contour: u32,
    /// Arc lengths on the contour's path in the group where the stretch begins and ends, mm. If `to` is less than
    /// `from`, it passes the contour's start; if they are equal, it is the whole contour.
    pub from: f64,
    /// See `from`.
    pub to: f64,
    /// Nodes at its beginning and end.
    pub ends: [u32; 2],
    /// Faces to its left and right.
    pub faces: [u32; 2],
}

impl PierceGroup {
    /// The path of one of its contours.
    pub fn path_of(&self, contour: u32) -> Option<&Path> {
        self.contours.binary_search(&contour).ok().and_then(|k| self.paths.get(k))
    }

    /// Elements between two bounded faces, which are cut once for both.
    pub fn between_parts(&self) -> impl Iterator<Item = &GroupElement> {
        self.elements.iter().filter(|e| !e.faces.contains(&0))
    }

    /// The elements around each area, with the area on their left and in no particular order: enough for winding numbers.
    pub fn outlines(&self) -> Vec<Vec<Segment>> {
        let mut outlines = vec![Vec::new(); self.faces as usize];
        for element in &self.elements {
            let [left, right] = element.faces.map(|f| f as usize);
            if left == right {
                continue;
            }
            let path = self.path(element);
            outlines[right].extend(path.reversed().segments);
            outlines[left].extend(path.segments);
        }
        outlines
    }

    /// The geometry of an element, from beginning to end.
    pub fn path(&self, element: &GroupElement) -> Path {
        let Some(contour) = self.path_of(element.contour) else { return Path::default() };
        let whole = element.from.total_cmp(&element.to).is_eq();
        let segments = match (whole, contour.closed) {
            (true, true) => contour.starting_at(element.from).segments,
            (true, false) => contour.segments.clone(),
            _ => contour.between(element.from, element.to),
        };
        Path::new(segments, false)
    }
}
