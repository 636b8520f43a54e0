//! Small sheets for the tests of the published methods.

use crate::geometry::DVec2;
use crate::machine;
use crate::problem::{Item, Node, NodeId, Problem};

/// Closed contours with these corners as nodes, on the preset machine of that name. The head starts at (0, 0) and returns
/// there. `leave` is the cost of leaving a contour unfinished, in seconds; `None` forbids it.
pub(super) fn sheet(contours: &[&[[f64; 2]]], leave: Option<f64>, machine: &str) -> Problem {
    let (mut items, mut nodes) = (Vec::new(), Vec::new());
    for (corners, item) in contours.iter().zip(0..) {
        let first = NodeId::try_from(nodes.len()).unwrap();
        for (corner, along) in corners.iter().zip(0..) {
            let entry = DVec2::from(*corner);
            let twin = NodeId::try_from(nodes.len()).unwrap();
            nodes.push(Node { item, entry, exit: entry, along: along.into(), reversed: false, twin });
        }
        let nodes = first..NodeId::try_from(nodes.len()).unwrap();
        items.push(Item { nodes, leave, ..Item::default() });
    }
    let machine = machine::preset(machine).unwrap();
    Problem { items, nodes, home: DVec2::ZERO, closed: true, ..Problem::empty(machine) }
}
