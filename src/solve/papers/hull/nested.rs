//! Any chromosome as visits that nest: how a plan of partial cutting comes from the paper's model.
//!
//! In a plan, a contour that is left is resumed where it was left and in its stored direction, and what is cut in between
//! lies in between wholly. The model knows nothing of that: it cuts segments in any order and either way. But air moves and
//! segments of a chromosome are one closed walk, and every contour is a loop by itself, so every node meets an even number of
//! air moves. Any walk over the same moves and segments is as long (Hierholzer, Math. Annalen 6 (1873)): the head follows air
//! moves; when it first comes to a contour it goes round it, and at each node from which air moves are left it first follows
//! those, until they bring it back there. Where it comes to a contour already begun, it passes: the plan goes straight on
//! from there, so its travel is that of the chromosome, or less.
//!
//! Contours cut whole are beads on the air moves between the others. The walk sets out by the first air move of the
//! chromosome, and so ends by the last one, which may be one that is not travelled.

use super::model::{Model, Visit};
use crate::problem::NodeId;

/// The visits of a walk, nested. They begin and end where those given do.
pub(super) fn nested(model: &Model, visits: &[Visit]) -> Vec<Visit> {
    Walk::new(model, visits).visits()
}

/// An air move between two vertices, with the contours cut whole on the way.
struct Move {
    ends: [u32; 2],
    beads: std::ops::Range<usize>,
    used: bool,
}

/// What the head is about.
enum Frame {
    /// Air moves that come back to where they began: a stretch of [`Walk::trails`].
    Trail(std::ops::Range<usize>),
    /// Going round a contour.
    Round {
        /// Where it was entered.
        entry: NodeId,
        /// Where the visit under way began.
        from: NodeId,
        /// Nodes gone by since the entry.
        gone: u32,
        /// Visits there were before it was left for others.
        left: Option<usize>,
    },
}

struct Walk<'m, 'p> {
    model: &'m Model<'p>,
    /// Contours cut whole, in the order of the chromosome.
    beads: Vec<Visit>,
    moves: Vec<Move>,
    /// Moves by vertex: the nodes, then home.
    at: Vec<u32>,
    /// Where the unused ones of each vertex begin, and where its own end.
    next: Vec<u32>,
    end: Vec<u32>,
    /// Moves in a row, each with whether it is gone backwards.
    trails: Vec<(u32, bool)>,
    begun: Vec<bool>,
    out: Vec<Visit>,
}

impl<'m, 'p> Walk<'m, 'p> {
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
                moves.push(Move { ends: [here, visit.enter], beads: first..beads.len(), used: false });
                first = beads.len();
            }
            here = visit.leave;
        }
        moves.push(Move { ends: [here, home], beads: first..beads.len(), used: false });
        let mut end = vec![0; problem.nodes.len() + 1];
        for m in &moves {
            m.ends.iter().for_each(|&v| end[v as usize] += 1);
        }
        let mut sum = 0;
        for count in &mut end {
            sum += *count;
            *count = sum;
        }
        // Filled from behind, so that moves stand in their order.
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

    /// The next unused move at a vertex.
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

    /// Air moves from a vertex until there are none left where they come to, which is the same vertex: none if there are
    /// none at all.
    fn trail(&mut self, vertex: u32) -> Option<Frame> {
        let (first, mut here) = (self.trails.len(), vertex);
        while let Some(id) = self.unused(here) {
            let m = &mut self.moves[id as usize];
            m.used = true;
            let back = m.ends[0] != here;
            here = if back { m.ends[0] } else { m.ends[1] };
            self.trails.push((id, back));
        }
        (self.trails.len() > first).then_some(Frame::Trail(first..self.trails.len()))
    }

    fn visits(mut self) -> Vec<Visit> {
        let home = u32::try_from(self.model.problem().nodes.len()).unwrap_or(u32::MAX);
        let mut frames: Vec<Frame> = self.trail(home).into_iter().collect();
        while let Some(frame) = frames.pop() {
            match frame {
                Frame::Trail(mut rest) => {
                    if let Some(step) = rest.next() {
                        frames.push(Frame::Trail(rest));
                        let entry = self.go(self.trails[step]);
                        frames.extend(entry.map(|n| Frame::Round { entry: n, from: n, gone: 1, left: None }));
                    }
                }
                Frame::Round { entry, from, gone, left } => self.round(&mut frames, entry, from, gone, left),
            }
        }
        self.out
    }

    /// Goes along a move: the node it comes to, if that begins a contour.
    fn go(&mut self, (id, back): (u32, bool)) -> Option<NodeId> {
        let Move { ends, beads, .. } = &self.moves[id as usize];
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

    /// From the node a contour is at to the next one from which air moves are left.
    fn round(
        &mut self,
        frames: &mut Vec<Frame>,
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
            // Back where it was left: for nothing, if nothing was cut.
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
                frames.push(Frame::Round { entry, from, gone, left: Some(self.out.len()) });
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
