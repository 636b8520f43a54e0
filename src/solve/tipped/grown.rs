//! An order that grows from kerf to kerf: a contour that can begin on no kerf yet is put off until one beside it is cut.
//!
//! The method's order enters a field of contours wherever the way is short, so that several of them are pierced. Here only the first one of
//! those that are connected by starts on kerfs is, and the others come in the method's order as far as they can begin. Each is entered where
//! the way to it, its cut, and the way to the next one take the fewest seconds.

use super::begin::{Head, Ways, begin, cold, straight};
use crate::geometry::Union;
use crate::machine::AirTime;
use crate::problem::{ItemId, NodeId, Problem};
use crate::solve::traits::Stop;

/// The order that grows from that of `stops`; `None` if nothing begins on a kerf.
pub(super) fn grown(problem: &Problem, stops: &[Stop]) -> Option<Vec<Stop>> {
    if problem.starts.is_empty() {
        return None;
    }
    let air = straight(problem);
    let count = problem.items.len();
    let mut new = Growth {
        problem,
        air: &air,
        kerfs: problem.items.iter().map(|i| kerfs(problem, i.nodes.clone())).collect(),
        cut: vec![false; count],
        stops: Vec::with_capacity(stops.len()),
        head: Head { at: problem.home, left: None },
    };
    let fields = fields(&new.kerfs);
    let mut begun = vec![false; count];
    let mut waiting: Vec<(ItemId, Stop)> = Vec::new();
    for (k, stop) in stops.iter().enumerate() {
        let item = problem.nodes.get(stop.node as usize)?.item;
        let field = begun.get_mut(*fields.get(item as usize)? as usize)?;
        if std::mem::replace(field, true) && !new.may_begin(item) {
            waiting.push((item, *stop));
            continue;
        }
        new.visit(item, *stop, stops.get(k + 1));
        while let Some(ready) = waiting.iter().position(|w| new.may_begin(w.0)) {
            let (item, stop) = waiting.remove(ready);
            new.visit(item, stop, stops.get(k + 1));
        }
    }
    new.stops.extend(waiting.into_iter().map(|w| w.1));
    Some(new.stops)
}

/// The items on whose kerfs the cuts of nodes may begin.
fn kerfs(problem: &Problem, nodes: std::ops::Range<NodeId>) -> Vec<ItemId> {
    let mut all: Vec<ItemId> = nodes.flat_map(|n| problem.starts.of(n)).filter_map(|s| s.kerf).collect();
    all.sort_unstable();
    all.dedup();
    all
}

/// By item: the number of the field that it is in. Items are in one field if a chain of starts on kerfs connects them.
fn fields(kerfs: &[Vec<ItemId>]) -> Vec<u32> {
    let mut fields = Union::new(kerfs.len());
    for (item, beside) in (0..).zip(kerfs) {
        for &other in beside {
            fields.join(item, other);
        }
    }
    fields.numbered()
}

/// The order so far.
struct Growth<'p> {
    problem: &'p Problem,
    air: &'p AirTime,
    /// By item: the items on whose kerfs it may begin.
    kerfs: Vec<Vec<ItemId>>,
    /// By item: whether it is cut.
    cut: Vec<bool>,
    stops: Vec<Stop>,
    head: Head,
}

impl Growth<'_> {
    fn is_cut(&self, item: ItemId) -> bool {
        self.cut.get(item as usize).is_some_and(|c| *c)
    }

    /// Whether an item may begin on a kerf, or never begins on one.
    fn may_begin(&self, item: ItemId) -> bool {
        let kerfs = self.kerfs.get(item as usize).map_or(&[][..], Vec::as_slice);
        kerfs.is_empty() || kerfs.iter().any(|&k| self.is_cut(k))
    }

    /// Visits an item, before `next`.
    fn visit(&mut self, item: ItemId, stop: Stop, next: Option<&Stop>) {
        let problem = self.problem;
        let nodes = problem
            .items
            .get(item as usize)
            .filter(|_| self.kerfs.get(item as usize).is_some_and(|k| !k.is_empty()));
        let goal = next.and_then(|n| n.ends(problem)).map_or(problem.home, |e| e.0);
        let ways = Ways { air: self.air, zones: problem.avoided() };
        let price = |node: NodeId| {
            let (known, item) = (problem.nodes.get(node as usize)?, problem.items.get(item as usize)?);
            let way = begin(problem, ways, self.head, (node, known.entry), |i| self.is_cut(i), cold).seconds;
            Some((node, way + item.extra(node, known.along) + self.air.seconds(known.exit, goal)))
        };
        let ways = nodes.into_iter().flat_map(|i| i.nodes.clone()).filter_map(price);
        let best = ways.min_by(|a, b| a.1.total_cmp(&b.1).then(a.0.cmp(&b.0)));
        let stop = best.map_or(stop, |(node, _)| Stop::at(problem, node));
        if let Some((_, exit)) = stop.ends(problem) {
            self.head = Head { at: exit, left: Some(stop.node) };
        }
        if let Some(cut) = self.cut.get_mut(item as usize) {
            *cut = true;
        }
        self.stops.push(stop);
    }
}
