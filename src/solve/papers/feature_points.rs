//! Feature points as Qu & Du define them (section II.B), for reproducing their paper from a drawing.
//!
//! A polygon has its corners. A circle or an ellipse has its centre and eight points that divide its rim into equal
//! lengths ("9 points"). An arc below 45 degrees has its two ends, its middle and its centre ("four points"). The paper says
//! nothing about longer arcs in a contour; all of those in its table 4 have their middle, so they have it here. It numbers a
//! centre that two contours share only once; here each round contour has its own (the ellipse L34 of table 4 has 9 points here
//! and 8 in print).
//!
//! A cut cannot start at a centre. Therefore these points make a problem for measuring air moves by the paper's rule, and
//! never a plan: the nodes of every other problem lie on the contour.

use crate::geometry::{DVec2, Path, Segment};
use crate::problem::{Item, Node, NodeId, Problem};

/// Below this angle the centre of an arc is a feature point, rad.
const SHORT_ARC: f64 = std::f64::consts::FRAC_PI_4;
/// Number of feature points on the rim of a circle or an ellipse.
const RIM: u32 = 8;
/// Tolerance for recognising an ellipse, which the reader replaces by arcs, as a fraction of its size.
const SYMMETRY: f64 = 1e-3;

/// The feature points of a contour in the order of its path, the centre of a circle or an ellipse first.
pub fn feature_points(path: &Path) -> Vec<DVec2> {
    if let Some(center) = round_center(path) {
        let lowest = lowest(path);
        let length = path.length();
        let rim =
            (0..RIM).filter_map(|k| path.at((lowest + length * f64::from(k) / f64::from(RIM)) % length));
        return std::iter::once(center).chain(rim).collect();
    }
    let mut points = Vec::new();
    for segment in &path.segments {
        points.push(segment.start());
        if let Segment::Arc(arc) = segment {
            points.push(segment.at(0.5));
            if arc.sweep.abs() < SHORT_ARC {
                points.push(arc.center);
            }
        }
    }
    if !path.closed {
        points.extend(path.end());
    }
    points
}

/// A problem with the feature points of the paper in place of its nodes, where the track of an item is known: closed contours
/// of a drawing. Contours are never left, and open contours keep their two ends.
pub fn with_feature_points(problem: &Problem) -> Problem {
    let mut nodes: Vec<Node> = Vec::new();
    let mut items = Vec::with_capacity(problem.items.len());
    let count = |nodes: &Vec<Node>| NodeId::try_from(nodes.len()).unwrap_or(NodeId::MAX);
    for (old, item) in problem.items.iter().zip(0..) {
        let first = count(&nodes);
        if let Some(track) = old.track.as_ref().filter(|_| !old.nodes.is_empty()) {
            for (entry, along) in feature_points(track).into_iter().zip(0_u32..) {
                let twin = count(&nodes);
                nodes.push(Node { item, entry, exit: entry, along: along.into(), reversed: false, twin });
            }
        } else {
            let own = old.nodes.clone().filter_map(|n| problem.nodes.get(n as usize));
            let shift = |twin: NodeId| first + twin.saturating_sub(old.nodes.start);
            nodes.extend(own.map(|n| Node { twin: shift(n.twin), ..*n }));
        }
        items.push(Item { nodes: first..count(&nodes), leave: None, track: None, ..old.clone() });
    }
    Problem { items, nodes, ..problem.clone() }
}

/// The centre of a circle or an ellipse: of a smooth closed path of arcs that is symmetric about the middle of its box.
fn round_center(path: &Path) -> Option<DVec2> {
    let arcs = path.segments.iter().all(|s| matches!(s, Segment::Arc(_)));
    if !path.closed || !arcs {
        return None;
    }
    let bounds = path.bounds();
    let (center, length) = (bounds.center(), path.length());
    let tolerance = SYMMETRY * length;
    let smooth = path
        .segments
        .iter()
        .zip(path.segments.iter().cycle().skip(1))
        .all(|(a, b)| a.tangent(1.0).dot(b.tangent(0.0)) > 1.0 - SYMMETRY);
    let symmetric = (0..RIM).all(|k| {
        let along = length * f64::from(k) / f64::from(2 * RIM);
        let (here, opposite) = (path.at(along), path.at(along + length / 2.0));
        here.zip(opposite).is_some_and(|(a, b)| (a + b - 2.0 * center).length() < tolerance)
    });
    (smooth && symmetric).then_some(center)
}

/// Where the lowest point of a round path is, mm along it.
fn lowest(path: &Path) -> f64 {
    let mut along = 0.0;
    let mut best = (f64::INFINITY, 0.0);
    for segment in &path.segments {
        let Segment::Arc(arc) = segment else { continue };
        let fraction = arc.fraction_of(DVec2::NEG_Y).unwrap_or(0.0);
        let height = segment.at(fraction).y;
        if height < best.0 {
            best = (height, along + fraction * segment.length());
        }
        along += segment.length();
    }
    best.1
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn feature_points_by_hand() {
        let corner = DVec2::new;
        let circle = Path::new(vec![Segment::Arc(crate::geometry::Arc::circle(corner(5.0, 5.0), 2.0))], true);
        let points = feature_points(&circle);
        assert_eq!(points.len(), 9);
        let root = 2.0 * std::f64::consts::FRAC_1_SQRT_2;
        let wanted = [(5.0, 5.0), (5.0, 3.0), (5.0 + root, 5.0 - root), (7.0, 5.0)];
        for (found, (x, y)) in points.iter().zip(wanted) {
            assert!(found.distance(corner(x, y)) < 1e-9, "{points:?}");
        }
    }
}
