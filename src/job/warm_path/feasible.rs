//! Whether a path may be cut as it is.

use crate::problem::{Problem, SubPath};
use crate::solve::Stop;

/// An unfinished item: where it was begun, where it was left, and the path through it if it is a pierce group.
struct Open<'p> {
    item: usize,
    start: f64,
    left: f64,
    path: Option<&'p SubPath>,
}

/// Whether a path is feasible: every item that can be visited is visited, once around; nothing is finished before what lies
/// inside it or before what a sequence puts before it, or begun before a lower rank; only contours that may be left are, they
/// are resumed where they were left, and visits nest.
#[expect(clippy::float_cmp, reason = "visits of a contour join bit for bit")]
pub(in crate::job) fn is_feasible(stops: &[Stop], problem: &Problem) -> bool {
    let mut finished = vec![None; problem.items.len()];
    let mut open: Vec<Open> = Vec::new();
    let mut rank = 0;
    for (k, stop) in stops.iter().enumerate() {
        let Some(item) = problem.nodes.get(stop.node as usize).map(|n| n.item as usize) else { return false };
        let path = problem.items[item].path(stop.node);
        let resumed = open.pop_if(|o| o.item == item);
        let start = resumed.as_ref().map_or(stop.along, |o| o.start);
        let joined = resumed.is_none_or(|o| o.left == stop.along) && !open.iter().any(|o| o.item == item);
        if !joined || finished[item].is_some() || problem.items[item].rank < rank {
            return false;
        }
        rank = problem.items[item].rank;
        if stop.until == start {
            finished[item] = Some(k);
            // Where a group was left for an item in one of its areas, the area must still hold.
            let inside = open.iter().filter(|o| problem.items[item].before == u32::try_from(o.item).ok());
            let due = |o: &Open| o.path.map_or(f64::INFINITY, |path| path.due(problem.items[item].area));
            if inside.into_iter().any(|o| o.left >= due(o)) {
                return false;
            }
        } else {
            // Orders places by their position on a round from the start.
            let order = |place: f64| (place < start, place);
            let may_be_left = match path {
                Some(path) => path.leave_point(stop.until).is_some(),
                None => problem.items[item].leave.is_some(),
            };
            if !may_be_left || order(stop.until) <= order(stop.along) {
                return false;
            }
            open.push(Open { item, start, left: stop.until, path });
        }
    }
    let order = stops.iter().map(|s| problem.nodes[s.node as usize].item);
    let in_turn = |&(first, then): &(u32, u32)| finished[first as usize] <= finished[then as usize];
    open.is_empty()
        && problem.pairs.iter().all(in_turn)
        && problem.groups.are_together(order, |i| problem.items[i as usize].rank)
        && problem.items.iter().zip(&finished).all(|(item, at)| match at {
            None => item.nodes.is_empty(),
            Some(_) => item.before.is_none_or(|outer| finished[outer as usize].is_none_or(|o| Some(o) > *at)),
        })
}
