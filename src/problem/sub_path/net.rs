//! The elements of a group, which orders of them are possible, and about what an order costs.

use crate::geometry::{DVec2, Path, Segment};
use crate::machine::{AirTime, Profile};
use crate::sheet::{PierceGroup, Sheet};

/// An element and the way it is cut: twice its index, one more against its direction.
pub(super) type Step = u32;
/// All elements of a group once.
pub(super) type Order = Vec<Step>;

/// A group with its geometry and the machine.
pub(super) struct Net<'s> {
    pub(super) group: &'s PierceGroup,
    pub(super) machine: &'s Profile,
    /// Geometry of each element.
    pub(super) paths: Vec<Path>,
    pub(super) air: AirTime,
    /// Elements at each node.
    degree: Vec<u32>,
    /// Nodes of each face, and how many elements it has.
    around: Vec<Vec<u32>>,
    sides: Vec<u32>,
}

impl<'s> Net<'s> {
    pub(super) fn new(sheet: &Sheet, group: &'s PierceGroup, machine: &'s Profile) -> Self {
        let paths = group.elements.iter().map(|e| e.path(&sheet.contours));
        let mut degree = vec![0; group.nodes.len()];
        let mut around = vec![Vec::new(); group.faces as usize];
        let mut sides = vec![0; group.faces as usize];
        for e in &group.elements {
            e.ends.iter().for_each(|&n| degree[n as usize] += 1);
            for &f in &e.faces {
                sides[f as usize] += 1;
                around[f as usize].extend(e.ends);
            }
        }
        Self { group, machine, paths: paths.collect(), air: AirTime::new(machine), degree, around, sides }
    }

    /// How many elements there are.
    pub(super) fn len(&self) -> usize {
        self.group.elements.len()
    }

    /// Their numbers.
    pub(super) fn elements(&self) -> std::ops::Range<u32> {
        0..u32::try_from(self.len()).unwrap_or(0)
    }

    /// Both ways along each of them.
    pub(super) fn steps(&self) -> std::ops::Range<Step> {
        0..2 * self.elements().end
    }

    pub(super) fn nodes(&self) -> impl Iterator<Item = u32> {
        (0..).take(self.group.nodes.len())
    }

    pub(super) fn place(&self, node: u32) -> DVec2 {
        self.group.nodes[node as usize]
    }

    pub(super) fn is_odd(&self, node: u32) -> bool {
        self.degree[node as usize] % 2 == 1
    }

    /// A path may come back to where it began without an air move.
    pub(super) fn is_even(&self) -> bool {
        self.nodes().all(|n| !self.is_odd(n))
    }

    /// Node at which a step begins, and at which it ends.
    pub(super) fn step(&self, step: Step) -> [u32; 2] {
        let [a, b] = self.group.elements[step as usize / 2].ends;
        if step.is_multiple_of(2) { [a, b] } else { [b, a] }
    }

    /// Directions, of length 1, in which a step begins and ends.
    pub(super) fn directions(&self, step: Step) -> [DVec2; 2] {
        let path = &self.paths[step as usize / 2].segments;
        let way = |at: f64, s: Option<&Segment>| s.map_or(DVec2::ZERO, |s| s.tangent(at));
        let [first, last] = [way(0.0, path.first()), way(1.0, path.last())];
        if step.is_multiple_of(2) { [first, last] } else { [-last, -first] }
    }

    /// Areas beside an element.
    pub(super) fn faces(&self, step: Step) -> [u32; 2] {
        self.group.elements[step as usize / 2].faces
    }

    /// Node at which an order begins, and at which it ends.
    pub(super) fn ends(&self, order: &[Step]) -> [u32; 2] {
        match order {
            [first, .., last] => [self.step(*first)[0], self.step(*last)[1]],
            [only] => self.step(*only),
            [] => [0; 2],
        }
    }

    /// Seconds from node to node.
    pub(super) fn way(&self, from: u32, to: u32) -> f64 {
        self.air.seconds(self.place(from), self.place(to))
    }

    /// Seconds that every start of the beam takes.
    pub(super) fn start(&self) -> f64 {
        self.machine.beam_delays()
    }

    /// Seconds of a pre-cut.
    pub(super) fn pre_cut(&self) -> f64 {
        self.machine.pre_cut_time.unwrap_or(0.0)
    }

    /// Whether every element still hangs on the sheet when it is cut. Looked at backwards: an element put back must
    /// part an area that hangs on the sheet by elements put back before it.
    pub(super) fn is_possible(&self, order: &[Step]) -> bool {
        let mut held = self.held();
        order.iter().rev().all(|&s| self.put_back(&mut held, s))
    }

    /// Areas that hang on the sheet when all is cut: the one around the group.
    pub(super) fn held(&self) -> Vec<bool> {
        let mut held = vec![false; self.sides.len()];
        held[0] = true;
        held
    }

    /// Puts an element back: both its areas hang on the sheet if one of them did. Whether it did.
    pub(super) fn put_back(&self, held: &mut [bool], step: Step) -> bool {
        let [a, b] = self.faces(step).map(|f| f as usize);
        let holds = held[a] || held[b];
        (held[a], held[b]) = (holds, holds);
        holds
    }

    /// About the seconds of an order: air moves, piercings, pre-cuts, starts; the cutting itself left out.
    pub(super) fn cost(&self, order: &[Step]) -> f64 {
        let mut sum = 0.0;
        self.follow(order, |at| sum += at.seconds);
        sum
    }

    /// Follows an order: what comes before each step, and which pre-cuts it needs.
    pub(super) fn follow(&self, order: &[Step], mut visit: impl FnMut(&At)) {
        let mut state = State::new(self);
        for &step in order {
            visit(&state.next(self, step));
        }
    }
}

/// A step of an order in its place.
pub(super) struct At {
    pub(super) step: Step,
    /// The beam goes on anew.
    pub(super) begins: bool,
    /// Nothing was cut at its start before: it is pierced.
    pub(super) pierced: bool,
    /// Seconds of the way there, of piercing, of the start, of pre-cuts; of a sharp corner that is cut through.
    pub(super) seconds: f64,
    /// Pre-cuts that must have been made in it, at its start and end.
    pub(super) ahead: [bool; 2],
}

/// What an order has done so far.
#[derive(Clone)]
pub(super) struct State {
    head: Option<u32>,
    /// The way it came there.
    leaves: DVec2,
    visited: Vec<bool>,
    /// A finished contour ends here: what is cut to here later may not run into it.
    loose: Vec<bool>,
    sides: Vec<u32>,
}

impl State {
    pub(super) fn new(net: &Net) -> Self {
        let nodes = net.group.nodes.len();
        Self {
            head: None,
            leaves: DVec2::ZERO,
            visited: vec![false; nodes],
            loose: vec![false; nodes],
            sides: net.sides.clone(),
        }
    }

    pub(super) fn next(&mut self, net: &Net, step: Step) -> At {
        let [from, to] = net.step(step);
        let begins = self.head != Some(from);
        let pierced = begins && !self.visited[from as usize];
        let way = self.head.filter(|_| begins).map_or(0.0, |head| net.way(head, from));
        let pierce = if pierced { net.machine.pierce_time } else { 0.0 };
        let ahead = [begins && !pierced, self.loose[to as usize]];
        let pre_cuts = ahead.iter().filter(|a| **a).count() as f64;
        let [enters, leaves] = net.directions(step);
        let start = if begins {
            net.start()
        } else if net.machine.is_sharp(self.leaves, enters) {
            net.machine.macro_seconds()
        } else {
            0.0
        };
        let seconds = way + pierce + start + pre_cuts * net.pre_cut();
        self.leaves = leaves;
        self.head = Some(to);
        self.visited[from as usize] = true;
        self.visited[to as usize] = true;
        for f in net.faces(step) {
            let left = &mut self.sides[f as usize];
            *left -= 1;
            if *left == 0 && f != 0 {
                net.around[f as usize].iter().for_each(|&n| self.loose[n as usize] = true);
            }
        }
        At { step, begins, pierced, seconds, ahead }
    }
}
