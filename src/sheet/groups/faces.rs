//! The planar graph of a group: elements between nodes, and the faces they bound.
//!
//! Every element is traversed twice, once in each direction, with the face on its left. At a node the traversal
//! continues with the element that turns least to the left from where it came, which is the next one clockwise. Cycles
//! around a bounded face run counter-clockwise. The graph is connected, so exactly one cycle runs clockwise, and it
//! bounds the outer face.

use super::contacts::Set;
use super::group::{GroupElement, PierceGroup};
use crate::geometry::{DVec2, Path};
use crate::sheet::half_edges::link;

/// Where the directions of the elements at a node are compared, as a fraction of the length of the shortest of them.
const AHEAD: f64 = 0.05;

/// The group of a set of contours; `None` when its elements form no planar graph, for example because they cross
/// elsewhere.
pub(super) fn group(set: &Set, paths: Vec<Path>) -> Option<PierceGroup> {
    let nodes = set.node.iter().max().map_or(0, |n| *n as usize + 1);
    let mut at = vec![DVec2::ZERO; nodes];
    for (b, &n) in set.breaks.iter().zip(&set.node) {
        let own = set.contours.binary_search(&b.contour).ok()?;
        at[n as usize] = paths[own].at(b.along)?;
    }
    let mut elements = Vec::new();
    for (&id, path) in set.contours.iter().zip(&paths) {
        let first = set.breaks.partition_point(|b| b.contour < id);
        let own = (first..).zip(set.breaks.get(first..)?).take_while(|(_, b)| b.contour == id);
        let breaks: Vec<usize> = own.map(|(k, _)| k).collect();
        let last = if path.closed { breaks.first().copied() } else { None };
        let next = breaks.iter().skip(1).copied().chain(last);
        for (&a, b) in breaks.iter().zip(next) {
            let (from, to) = (set.breaks[a].along, set.breaks[b].along);
            let ends = [set.node[a], set.node[b]];
            elements.push(GroupElement { contour: id, from, to, ends, faces: [0; 2] });
        }
    }
    let contours = set.contours.clone();
    let mut group = PierceGroup { contours, paths, nodes: at, elements, faces: 0, inside: Vec::new() };
    let paths: Vec<Path> = group.elements.iter().map(|e| group.path(e)).collect();
    if paths.iter().any(|p| p.segments.is_empty()) {
        return None;
    }
    group.faces = trace(&mut group.elements, &paths, nodes)?;
    Some(group)
}

/// Assigns faces to every element; returns the number of faces.
fn trace(elements: &mut [GroupElement], paths: &[Path], nodes: usize) -> Option<u32> {
    // Half-edge 2 e leaves the start of element e, half-edge 2 e + 1 its end.
    let mut leaving: Vec<Vec<usize>> = vec![Vec::new(); nodes];
    for (e, element) in elements.iter().enumerate() {
        leaving[element.ends[0] as usize].push(2 * e);
        leaving[element.ends[1] as usize].push(2 * e + 1);
    }
    let mut after = vec![0; 2 * elements.len()];
    for halves in &mut leaving {
        let leaves = |h: usize, ahead| direction(&paths[h / 2], h % 2 == 1, ahead);
        link(halves, &mut after, AHEAD, |h| paths[h / 2].length(), leaves);
    }
    let mut face = vec![u32::MAX; after.len()];
    let (mut inner, mut around) = (1, 0);
    for start in 0..after.len() {
        if face[start] != u32::MAX {
            continue;
        }
        let mut round = Vec::new();
        let mut h = start;
        while face[h] == u32::MAX {
            face[h] = inner;
            round.push(h);
            h = after[h];
        }
        let area: f64 = round.iter().map(|&h| doubled_area(&paths[h / 2], h % 2 == 1)).sum();
        if area > 0.0 {
            inner += 1;
        } else {
            around += 1;
            round.iter().for_each(|&h| face[h] = 0);
        }
    }
    for (e, element) in elements.iter_mut().enumerate() {
        element.faces = [face[2 * e], face[2 * e + 1]];
    }
    (around == 1).then_some(inner)
}

/// The direction from a node to a place `ahead` mm along an element.
fn direction(path: &Path, from_end: bool, ahead: f64) -> DVec2 {
    let length = path.length();
    let (at, there) = if from_end { (length, length - ahead) } else { (0.0, ahead) };
    path.at(there).unwrap_or_default() - path.at(at).unwrap_or_default()
}

fn doubled_area(path: &Path, reversed: bool) -> f64 {
    let sum: f64 = path.segments.iter().map(|s| s.doubled_area()).sum();
    if reversed { -sum } else { sum }
}
