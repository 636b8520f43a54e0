//! The reading that nodes are the ends of elements. The endpoint cutting problem (ECP) says that a contour may be entered and
//! left "only at some predefined points on the boundary", and the paper's nodes lie where elements meet. The entries of our
//! problems differ from that: long elements have entries between their ends as well, and contours of more than 16 elements
//! have a choice of them.

use crate::problem::{Item, Node, NodeId, Problem};
use crate::solve::{Insight, Running, Search, Solution, Status, Step, Stop, Telemetry};

/// The same problem, in which closed contours are entered and left at the ends of their elements and nowhere else.
fn at_element_ends(problem: &Problem) -> Problem {
    let mut nodes: Vec<Node> = Vec::new();
    let count = |nodes: &Vec<Node>| NodeId::try_from(nodes.len()).unwrap_or(NodeId::MAX);
    let items = (0..).zip(&problem.items).map(|(id, item)| {
        let first = count(&nodes);
        match item.track.as_ref().filter(|t| t.closed && t.length() > 0.0) {
            Some(track) => {
                let mut along = 0.0;
                for element in track.segments.iter().filter(|s| s.length() > 0.0) {
                    let (place, twin) = (element.start(), count(&nodes));
                    nodes.push(Node { item: id, entry: place, exit: place, along, reversed: false, twin });
                    along += element.length();
                }
            }
            None => {
                let own = item.nodes.clone().filter_map(|n| problem.nodes.get(n as usize));
                nodes.extend(own.map(|n| Node { twin: first + n.twin - item.nodes.start, ..*n }));
            }
        }
        Item { nodes: first..count(&nodes), ..item.clone() }
    });
    let items = items.collect();
    Problem { items, nodes, ..problem.clone() }
}

/// A search on the ends of elements, whose solutions are those of the problem as it was given.
pub(super) struct AtElementEnds<'p> {
    given: &'p Problem,
    running: Running,
    best: Solution,
}

impl<'p> AtElementEnds<'p> {
    /// Starts a search on the problem with these nodes.
    pub(super) fn new(
        given: &'p Problem,
        start: impl for<'s> FnOnce(&'s Problem) -> Box<dyn Search + 's>,
    ) -> Self {
        let running = Running::new(at_element_ends(given), start);
        let mut search = Self { given, running, best: Solution::default() };
        search.best = search.as_given();
        search
    }

    /// The best solution by nodes of the problem as it was given: an entry at the end of an element is a place on the track.
    fn as_given(&self) -> Solution {
        let own = self.running.borrow_owner();
        let stop = |stop: &Stop| {
            let item = own.nodes[stop.node as usize].item as usize;
            let (first, given) = (own.items[item].nodes.start, &self.given.items[item]);
            let node =
                if given.track.is_some() { given.nodes.start } else { given.nodes.start + stop.node - first };
            Stop { node, ..*stop }
        };
        let stops = self.running.borrow_dependent().best().stops.iter().map(stop).collect();
        Solution::new(self.given, stops)
    }
}

impl Search for AtElementEnds<'_> {
    fn step(&mut self, work: u64) -> Step {
        let step = self.running.with_dependent_mut(|_, search| search.step(work));
        if step.improved || step.status == Status::Exhausted {
            self.best = self.as_given();
        }
        step
    }

    fn best(&self) -> &Solution {
        &self.best
    }

    fn telemetry(&self) -> Telemetry {
        self.running.borrow_dependent().telemetry()
    }

    fn insight(&self) -> Option<Insight> {
        self.running.borrow_dependent().insight()
    }

    fn offer(&mut self, other: &Solution) {
        if other.cost < self.best.cost {
            self.best = other.clone();
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::{DVec2, Path, Segment};
    use crate::solve::papers::test_sheet::sheet;

    #[test]
    fn nodes_are_the_ends_of_elements_and_solutions_those_of_the_problem() {
        let corners = [[10.0, 0.0], [20.0, 0.0], [20.0, 8.0], [10.0, 8.0]];
        let mut problem =
            sheet(&[&[corners[0], [15.0, 0.0], corners[1]], &[[40.0, 0.0]]], Some(1.0), "length");
        let places = corners.map(DVec2::from);
        let next = places.iter().cycle().skip(1);
        let lines = places.iter().zip(next).map(|(a, b)| Segment::line(*a, *b)).collect();
        problem.items[0].track = Some(Path::new(lines, true));
        let ends = at_element_ends(&problem);
        assert_eq!(ends.items.iter().map(|i| i.nodes.clone()).collect::<Vec<_>>(), [0..4, 4..5]);
        assert_eq!(ends.nodes.iter().map(|n| n.entry).collect::<Vec<_>>()[..4], places);
        assert_eq!(ends.nodes.iter().map(|n| n.along).collect::<Vec<_>>()[..4], [0.0, 10.0, 18.0, 28.0]);

        let method = super::super::parameters::PartitionTree::default();
        let mut search = AtElementEnds::new(&problem, |p| method.on_nodes(p, 1));
        while search.step(1_000).status == Status::Running {}
        // To the corner at 10, along to the one at 20, to the other contour and back, around and home: 10 + 20 + 20 + 10 mm,
        // and the second for leaving.
        let best = search.best();
        assert!((best.cost - 61.0).abs() < 1e-9, "{best:?}");
        assert_eq!(best.stops[0], Stop { node: 0, along: 0.0, until: 10.0 });
    }
}
