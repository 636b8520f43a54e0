//! A stop of a sequence, with what is needed to price it.

use crate::geometry::DVec2;
use crate::problem::{ItemId, Problem};
use crate::solve::traits::Stop;

/// A stop with what is needed to price it.
#[derive(Clone, Copy, Debug)]
pub(super) struct Visit {
    pub(super) stop: Stop,
    pub(super) item: ItemId,
    pub(super) entry: DVec2,
    pub(super) exit: DVec2,
    /// Seconds that depend on the entry.
    pub(super) extra: f64,
    /// Seconds from when the head arrives to when it may leave.
    pub(super) seconds: f64,
}

impl Visit {
    /// The visit of a stop; `None` if there is no such stop.
    pub(super) fn new(problem: &Problem, stop: Stop) -> Option<Self> {
        let (entry, exit) = stop.ends(problem)?;
        let item = problem.nodes.get(stop.node as usize)?.item;
        let known = problem.items.get(item as usize)?;
        let extra = known.extra(stop.node, stop.along);
        Some(Self { stop, item, entry, exit, extra, seconds: known.fixed + extra })
    }
}
