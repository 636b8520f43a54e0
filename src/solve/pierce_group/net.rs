//! The elements of a group, which orders of them are possible, and about what an order costs.

use crate::geometry::{DVec2, Segment};
use crate::machine::{AirTime, Profile, process_time};
use crate::problem::GroupProblem;

/// An element and the way it is cut: twice its index, one more against its direction.
pub(super) type Step = u32;
/// All elements of a group once.
pub(super) type Order = Vec<Step>;

/// Nodes at most for all ways to be priced once: half a megabyte.
const IN_ROWS: usize = 256;

/// Seconds that sums may be off by, and mm that places may be.
pub(super) const ROUNDING: f64 = 1e-6;

/// A group with its geometry and the machine.
pub(super) struct Net<'s> {
    pub(super) group: &'s GroupProblem,
    pub(super) machine: &'s Profile,
    pub(super) air: AirTime,
    /// Nothing else is cut: the head comes from home, and goes back there.
    pub(super) is_all: bool,
    /// By step: the node at which it begins, and at which it ends.
    ends: Vec<[u32; 2]>,
    /// By element: the areas beside it.
    beside: Vec<[u32; 2]>,
    /// Seconds from node to node, row by row; empty where nodes are too many.
    ways: Vec<f64>,
    /// By step: what may follow without a stop of the beam, and [`Net::gain`] of that.
    pub(super) gains: Vec<Vec<(Step, f64)>>,
    /// By element: the most that may be gained behind it.
    pub(super) most: Vec<f64>,
    /// Elements at each node.
    degree: Vec<u32>,
    /// Nodes of each face, and how many elements it has.
    pub(super) around: Vec<Vec<u32>>,
    pub(super) sides: Vec<u32>,
}

impl<'s> Net<'s> {
    pub(super) fn new(group: &'s GroupProblem, machine: &'s Profile, is_all: bool) -> Self {
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
        let air = AirTime::new(machine);
        let ends = group.elements.iter().flat_map(|e| [e.ends, [e.ends[1], e.ends[0]]]).collect();
        let beside = group.elements.iter().map(|e| e.faces).collect();
        let places = if group.nodes.len() <= IN_ROWS { group.nodes.as_slice() } else { &[] };
        let ways = places.iter().flat_map(|&a| places.iter().map(move |&b| air.seconds(a, b))).collect();
        let (gains, most) = (Vec::new(), Vec::new());
        let mut net =
            Self { group, machine, air, is_all, ends, beside, ways, gains, most, degree, around, sides };
        net.gains = net.steps().map(|step| net.gains_after(step)).collect();
        let most = |e: usize| {
            [2 * e, 2 * e + 1].iter().flat_map(|&s| &net.gains[s]).fold(0.0_f64, |m, g| m.max(g.1))
        };
        net.most = (0..net.len()).map(most).collect();
        net
    }

    /// Whether the same orders are possible in another group, and cost the same but for rounding: the same elements in
    /// the same places, all of them moved by as much.
    pub(super) fn is_like(&self, other: &Net) -> bool {
        let near = |a: f64, b: f64| (a - b).abs() < ROUNDING;
        let from = |net: &Net, k: usize| net.group.nodes[k] - net.group.nodes[0];
        self.ends == other.ends
            && self.beside == other.beside
            && self.group.nodes.len() == other.group.nodes.len()
            && (0..self.group.nodes.len()).all(|k| from(self, k).abs_diff_eq(from(other, k), ROUNDING))
            && self.gains.iter().flatten().zip(other.gains.iter().flatten()).all(|(a, b)| near(a.1, b.1))
    }

    fn gains_after(&self, step: Step) -> Vec<(Step, f64)> {
        let seconds = |path: &[Segment]| process_time(self.machine, false, path);
        let own = self.travelled(step);
        let from = self.step(step)[1];
        let next = self.steps().filter(|&s| s / 2 != step / 2 && self.step(s)[0] == from);
        let gain = |s: Step| {
            let (other, both) = (self.travelled(s), [own.clone(), self.travelled(s)].concat());
            seconds(&own) + seconds(&other) - seconds(&both)
        };
        next.map(|s| (s, gain(s))).collect()
    }

    /// Geometry of a step in the direction of travel.
    pub(super) fn travelled(&self, step: Step) -> Vec<Segment> {
        let path = &self.group.elements[step as usize / 2].path;
        if step.is_multiple_of(2) { path.segments.clone() } else { path.reversed().segments }
    }

    /// Seconds of cutting that are saved when a step follows another one without a stop of the beam in between; less than
    /// none in a sharp corner.
    pub(super) fn gain(&self, step: Step, next: Step) -> f64 {
        self.gains[step as usize].iter().find(|g| g.0 == next).map_or(0.0, |g| g.1)
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
        self.ends[step as usize]
    }

    /// Seconds that a stop for pre-cuts takes between a step and the next.
    pub(super) fn stop(&self, step: Step, next: Step) -> f64 {
        (self.start() + self.gain(step, next)).max(0.0)
    }

    /// Areas beside an element.
    pub(super) fn faces(&self, step: Step) -> [u32; 2] {
        self.beside[step as usize / 2]
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
        let way = self.ways.get(from as usize * self.group.nodes.len() + to as usize);
        way.copied().unwrap_or_else(|| self.air.seconds(self.place(from), self.place(to)))
    }

    /// Seconds between home and an end of an order, where the group is all there is; elsewhere it is not known from where
    /// the head comes.
    pub(super) fn leg(&self, end: DVec2) -> f64 {
        if self.is_all { self.air.seconds(self.machine.home(), end) } else { 0.0 }
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
        self.is_possible_from(&mut self.held(), order)
    }

    /// The same; `held` is room for as many areas as there are.
    pub(super) fn is_possible_from(&self, held: &mut [bool], order: &[Step]) -> bool {
        held.fill(false);
        held[0] = true;
        order.iter().rev().all(|&s| self.put_back(held, s))
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
}
