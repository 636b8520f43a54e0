//! A pierce group: contours that share cuts, as a planar net.

use crate::geometry::{DVec2, Path};

/// Contours that share cuts.
#[derive(Clone, Debug, PartialEq)]
pub struct PierceGroup {
    /// Contour ids, ascending; the first stands for the group.
    pub contours: Vec<u32>,
    /// Their paths in the group: as those of the sheet, but with a vertex at each node, which they are moved onto within the
    /// copy tolerance. The contours themselves stay as they are for machines that cut them one by one.
    pub paths: Vec<Path>,
    /// Where elements end, mm.
    pub nodes: Vec<DVec2>,
    /// Stretches of its contours between nodes.
    pub elements: Vec<GroupElement>,
    /// How many areas its elements part; 0 is the one around the group.
    pub faces: u32,
    /// Contours that lie in what the group closes in, at any depth.
    pub inside: Vec<u32>,
}

/// A stretch of a contour between two nodes of its group.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GroupElement {
    /// Whose it is.
    pub contour: u32,
    /// Arc length on the contour's path in the group where it begins and ends, mm; over the contour's end where it ends before it begins,
    /// and once round where both are one.
    pub from: f64,
    /// See `from`.
    pub to: f64,
    /// Nodes at which it begins and ends.
    pub ends: [u32; 2],
    /// Areas to its left and right.
    pub faces: [u32; 2],
}

impl PierceGroup {
    /// The path of one of its contours.
    pub fn path_of(&self, contour: u32) -> Option<&Path> {
        self.contours.iter().position(|&c| c == contour).and_then(|k| self.paths.get(k))
    }

    /// Elements between two areas that the group closes in: cut once for both.
    pub fn between_parts(&self) -> impl Iterator<Item = &GroupElement> {
        self.elements.iter().filter(|e| !e.faces.contains(&0))
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
