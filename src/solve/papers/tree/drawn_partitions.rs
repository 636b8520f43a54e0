//! The partitions of a path, for drawing them.

use crate::problem::{Problem, SubPath};
use crate::solve::{Parent, Partitions};
use crate::solve::{Solution, Stop};

/// The partitions of a path: where a contour is left, everything cut until it is resumed is a partition.
pub(super) fn partitions(problem: &Problem, path: &Solution) -> Partitions {
    let mut of = vec![-1; problem.items.len()];
    let mut parents: Vec<Parent> = Vec::new();
    // Unfinished contours, each with the place where it was begun.
    let mut open: Vec<(u32, f64)> = Vec::new();
    let mut route = 0;
    for stop in &path.stops {
        let Some(node) = problem.nodes.get(stop.node as usize) else { continue };
        let (item, begun) = open.pop_if(|o| o.0 == node.item).unwrap_or_else(|| {
            of[node.item as usize] = route;
            // All contours of a pierce group are in its partition.
            let path = problem.items.get(node.item as usize).and_then(|i| i.path(stop.node));
            for span in path.into_iter().flat_map(SubPath::spans) {
                if let Some(own) = of.get_mut(span.contour as usize) {
                    *own = route;
                }
            }
            (node.item, stop.along)
        });
        route = of[item as usize];
        if !ends(stop, begun) {
            open.push((item, begun));
            let at = stop.ends(problem).map_or([0.0; 2], |(_, leave)| leave.to_array());
            parents.push(Parent { contour: item, at });
            route = i32::try_from(parents.len()).unwrap_or(i32::MAX);
        }
    }
    Partitions { of, parents }
}

/// Whether a visit is the last one of a contour that was begun at that place.
#[expect(clippy::float_cmp, reason = "visits of a contour join bit for bit")]
fn ends(stop: &Stop, begun: f64) -> bool {
    stop.until == begun
}
