//! Converts any chromosome to visits that nest, which a plan with partial cutting needs.
//!
//! In a plan, a contour that is left is resumed where it was left, in its stored direction, and everything cut in between
//! is finished in between. The paper's model has no such rule: it cuts segments in any order and direction. However, the
//! air moves and segments of a chromosome form a closed walk, and every contour is a loop, so every node is the end of an
//! even number of air moves. Any walk over the same moves and segments has the same length (Hierholzer, Math. Annalen 6
//! (1873)).
//!
//! The head therefore follows the air moves. When it first reaches a contour it cuts around it, and at each node with
//! unused air moves it follows those first, until they return to the node. When it reaches a contour that it has already
//! begun, it passes on directly, so that the travel is that of the chromosome or less.
//!
//! Contours that are cut whole are attached to the air moves between the others ("beads"). The walk starts with the first
//! air move of the chromosome and so ends with the last one, which may be the return home that is not travelled.

use super::model::{Model, Visit};
use crate::problem::NodeId;

/// The same walk as visits that nest. It starts and ends where the given visits do.
pub(super) fn nested(model: &Model, visits: &[Visit]) -> Vec<Visit> {
    EulerWalk::new(model, visits).visits()
}

/// An air move between two vertices, with the contours that are cut whole on the way.
struct AirMove {
    ends: [u32; 2],
    beads: std::ops::Range<usize>,
    used: bool,
}

/// What the head is doing; frames are stacked.
enum StackFrame {
    /// Following air moves that return to where they began: a range of [`EulerWalk::trails`].
    Trail(std::ops::Range<usize>),
    /// Cutting around a contour.
    Round {
        /// The node where it was entered.
        entry: NodeId,
        /// The node where the current visit began.
        from: NodeId,
        /// Number of nodes passed since the entry.
        gone: u32,
        /// Number of visits before the contour was left for others.
        left: Option<usize>,
    },
}

struct EulerWalk<'m, 'p> {
    model: &'m Model<'p>,
    /// Contours that are cut whole, in the order of the chromosome.
    beads: Vec<Visit>,
    moves: Vec<AirMove>,
    /// Air moves by vertex; the vertices are the nodes, then home.
    at: Vec<u32>,
    /// For each vertex, the first unused move in `at`, and the end of its moves.
    next: Vec<u32>,
    end: Vec<u32>,
    /// Sequences of air moves, each with whether it is followed backwards.
    trails: Vec<(u32, bool)>,
    begun: Vec<bool>,
    out: Vec<Visit>,
}

impl<'m, 'p> EulerWalk<'m, 'p> {
    fn new(model: &'m Model<'p>, visits: &[Visit]) -> Self {
        let problem = model.problem();
        let home = u32::try_from(problem.nodes.len()).unwrap_or(u32::MAX);
        let (mut beads, mut moves) = (Vec::new(), Vec::new());
        let (mut here, mut first) = (home, 0);
        for &visit in visits {
            if !model.splits(model.item(visit.enter)) {
                beads.push(visit);
                continue;
            }
            if here != visit.enter || beads.len() > first {
                moves.push(AirMove { ends: [here, visit.enter], beads: first..beads.len(), used: false });
                first = beads.len();
            }
            here = visit.leave;
        }
        moves.push(AirMove { ends: [here, home], beads: first..beads.len(), used: false });
        let mut end = vec![0; problem.nodes.len() + 1];
        for m in &moves {
            m.ends.iter().for_each(|&v| end[v as usize] += 1);
        }
        let mut sum = 0;
        for count in &mut end {
            sum += *count;
            *count = sum;
        }
        // Filled from the back, so that the moves of a vertex are in their original order.
        let (mut next, mut at) = (end.clone(), vec![0; 2 * moves.len()]);
        let mut id = u32::try_from(moves.len()).unwrap_or(u32::MAX);
        for m in moves.iter().rev() {
            id -= 1;
            for &v in m.ends.iter().rev() {
                next[v as usize] -= 1;
                at[next[v as usize] as usize] = id;
            }
        }
        let begun = vec![false; problem.items.len()];
        Self { model, beads, moves, at, next, end, trails: Vec::new(), begun, out: Vec::new() }
    }

    /// The next unused air move of a vertex.
    fn unused(&mut self, vertex: u32) -> Option<u32> {
        let v = vertex as usize;
        while self.next[v] < self.end[v] {
            let id = self.at[self.next[v] as usize];
            if !self.moves[id as usize].used {
                return Some(id);
            }
            self.next[v] += 1;
        }
        None
    }

    /// Follows unused air moves from a vertex until none is left, which is at the same vertex; `None` if there are none at
    /// all.
    fn trail(&mut self, vertex: u32) -> Option<StackFrame> {
        let (first, mut here) = (self.trails.len(), vertex);
        while let Some(id) = self.unused(here) {
            let m = &mut self.moves[id as usize];
            m.used = true;
            let back = m.ends[0] != here;
            here = if back { m.ends[0] } else { m.ends[1] };
            self.trails.push((id, back));
        }
        (self.trails.len() > first).then_some(StackFrame::Trail(first..self.trails.len()))
    }

    fn visits(mut self) -> Vec<Visit> {
        let home = u32::try_from(self.model.problem().nodes.len()).unwrap_or(u32::MAX);
        let mut frames: Vec<StackFrame> = self.trail(home).into_iter().collect();
        while let Some(frame) = frames.pop() {
            match frame {
                StackFrame::Trail(mut rest) => {
                    if let Some(step) = rest.next() {
                        frames.push(StackFrame::Trail(rest));
                        let entry = self.go(self.trails[step]);
                        frames.extend(entry.map(|n| StackFrame::Round {
                            entry: n,
                            from: n,
                            gone: 1,
                            left: None,
                        }));
                    }
                }
                StackFrame::Round { entry, from, gone, left } => {
                    self.round(&mut frames, entry, from, gone, left)
                }
            }
        }
        self.out
    }

    /// Follows an air move. Returns the node it leads to, if that begins a contour.
    fn go(&mut self, (id, back): (u32, bool)) -> Option<NodeId> {
        let AirMove { ends, beads, .. } = &self.moves[id as usize];
        let beads = &self.beads[beads.clone()];
        if back {
            let twin = |v: &Visit| self.model.problem().nodes[v.enter as usize].twin;
            self.out.extend(beads.iter().rev().map(|v| Visit { enter: twin(v), leave: twin(v) }));
        } else {
            self.out.extend(beads);
        }
        let to = if back { ends[0] } else { ends[1] };
        let item = self.model.problem().nodes.get(to as usize)?.item as usize;
        (!std::mem::replace(&mut self.begun[item], true)).then_some(to)
    }

    /// Cuts from the current node of a contour to the next node with unused air moves.
    fn round(
        &mut self,
        frames: &mut Vec<StackFrame>,
        entry: NodeId,
        mut from: NodeId,
        gone: u32,
        left: Option<usize>,
    ) {
        let nodes = &self.model.problem().items[self.model.item(entry) as usize].nodes;
        let (first, count) = (nodes.start, nodes.end - nodes.start);
        let node = |gone: u32| first + (entry - first + gone) % count;
        let mut gone = gone;
        if let Some(left) = left {
            // Back at the node where it was left: if nothing was cut in between, the contour was not left at all.
            if self.out.len() == left + 1 {
                self.out.pop();
            } else {
                from = node(gone);
            }
            gone += 1;
        }
        while gone < count {
            let here = node(gone);
            if let Some(trail) = self.trail(here) {
                frames.push(StackFrame::Round { entry, from, gone, left: Some(self.out.len()) });
                frames.push(trail);
                self.out.push(Visit { enter: from, leave: here });
                return;
            }
            gone += 1;
        }
        self.out.push(Visit { enter: from, leave: entry });
        frames.extend(self.trail(entry));
    }
}
