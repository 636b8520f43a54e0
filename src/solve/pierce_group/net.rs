//! The net of a group: its elements, which orders of them are possible, and the parts of an order's cost.

use super::bridged;
use crate::geometry::{DVec2, Segment};
use crate::machine::{AirTime, PLANS_ALL_LEVERS, Profile, process_time};
use crate::problem::GroupProblem;

/// An element with a direction: twice its index, plus one if it is cut against its stored direction.
pub(super) type Step = u32;
/// An order in which all elements of a group are cut, each once.
pub(super) type Order = Vec<Step>;

/// Most nodes for which all legs are priced in advance: half a megabyte.
const IN_ROWS: usize = 256;

/// Tolerance for rounding: of sums, in seconds, and of points, in mm.
pub(super) const ROUNDING: f64 = 1e-6;

/// A group with the machine that cuts it.
#[derive(Clone)]
pub(super) struct Net<'s> {
    pub(super) group: &'s GroupProblem,
    pub(super) machine: &'s Profile,
    pub(super) air: AirTime,
    /// Nothing else is cut: the head comes from home and goes back there.
    pub(super) is_all: bool,
    /// By step: the nodes where it begins and ends.
    ends: Vec<[u32; 2]>,
    /// By element: the areas on its two sides.
    beside: Vec<[u32; 2]>,
    /// Seconds from node to node, row by row; empty if there are too many nodes.
    ways: Vec<f64>,
    /// The same where contours beside the group bridge the air moves ([`bridged::ways`]); empty if there are none.
    bridged: Vec<f64>,
    /// By step: what may follow without a stop of the beam, and [`Net::gain`] of that.
    pub(super) gains: Vec<Vec<(Step, f64)>>,
    /// By element: the largest gain of a step after it.
    pub(super) most: Vec<f64>,
    /// Number of elements at each node.
    degree: Vec<u32>,
    /// The nodes around each area.
    pub(super) around: Vec<Vec<u32>>,
    /// The number of elements around each area.
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
        let ways: Vec<f64> =
            places.iter().flat_map(|&a| places.iter().map(move |&b| air.seconds(a, b))).collect();
        let bridged = bridged::ways(group, &air, &ways);
        let (gains, most) = (Vec::new(), Vec::new());
        let mut net = Self {
            group,
            machine,
            air,
            is_all,
            ends,
            beside,
            ways,
            bridged,
            gains,
            most,
            degree,
            around,
            sides,
        };
        let mut leaving: Vec<Vec<Step>> = vec![Vec::new(); group.nodes.len()];
        net.steps().for_each(|step| leaving[net.step(step)[0] as usize].push(step));
        net.gains =
            net.steps().map(|step| net.gains_after(step, &leaving[net.step(step)[1] as usize])).collect();
        let most = |e: usize| {
            [2 * e, 2 * e + 1].iter().flat_map(|&s| &net.gains[s]).fold(0.0_f64, |m, g| m.max(g.1))
        };
        net.most = (0..net.len()).map(most).collect();
        net
    }

    /// Whether another group has the same orders at the same cost, up to rounding: the same elements, all of them moved by
    /// the same vector.
    pub(super) fn is_like(&self, other: &Net) -> bool {
        let near = |a: f64, b: f64| (a - b).abs() < ROUNDING;
        let from = |net: &Net, k: usize| net.group.nodes[k] - net.group.nodes[0];
        self.ends == other.ends
            && self.beside == other.beside
            && self.group.nodes.len() == other.group.nodes.len()
            && (0..self.group.nodes.len()).all(|k| from(self, k).abs_diff_eq(from(other, k), ROUNDING))
            && self.gains.iter().flatten().zip(other.gains.iter().flatten()).all(|(a, b)| near(a.1, b.1))
    }

    /// The same net with bridged air moves, for orders that are good where the group is left for what lies beside it; `None`
    /// if nothing bridges an air move.
    pub(super) fn bridged(&self) -> Option<Self> {
        (!self.bridged.is_empty()).then(|| Self { ways: self.bridged.clone(), ..self.clone() })
    }

    /// Whether [`Net::bridged`] is the same for another net, up to rounding.
    pub(super) fn is_bridged_like(&self, other: &Net) -> bool {
        let near = |(a, b): (&f64, &f64)| (a - b).abs() < ROUNDING;
        self.bridged.len() == other.bridged.len() && self.bridged.iter().zip(&other.bridged).all(near)
    }

    /// What may follow a step, of those that begin where it ends, and [`Net::gain`] of that.
    fn gains_after(&self, step: Step, leaving: &[Step]) -> Vec<(Step, f64)> {
        let seconds = |path: &[Segment]| process_time(self.machine, &self.machine.cut, false, path);
        let own = self.travelled(step);
        let next = leaving.iter().copied().filter(|&s| s / 2 != step / 2);
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

    /// Seconds of cutting that are saved when a step follows another without a stop of the beam; negative in a sharp corner.
    pub(super) fn gain(&self, step: Step, next: Step) -> f64 {
        self.gains[step as usize].iter().find(|g| g.0 == next).map_or(0.0, |g| g.1)
    }

    /// Number of elements.
    pub(super) fn len(&self) -> usize {
        self.group.elements.len()
    }

    /// The indices of all elements.
    pub(super) fn elements(&self) -> std::ops::Range<u32> {
        0..u32::try_from(self.len()).unwrap_or(0)
    }

    /// Both directions of each element.
    pub(super) fn steps(&self) -> std::ops::Range<Step> {
        0..2 * self.elements().end
    }

    pub(super) fn nodes(&self) -> impl Iterator<Item = u32> {
        (0..).take(self.group.nodes.len())
    }

    pub(super) fn place(&self, node: u32) -> DVec2 {
        self.group.nodes[node as usize]
    }

    /// Whether a node lies beside the area around the group.
    pub(super) fn is_outside(&self, node: u32) -> bool {
        self.around.first().is_some_and(|around| around.contains(&node))
    }

    pub(super) fn is_odd(&self, node: u32) -> bool {
        self.degree[node as usize] % 2 == 1
    }

    /// Whether a path may return to its beginning without an air move.
    pub(super) fn is_even(&self) -> bool {
        self.nodes().all(|n| !self.is_odd(n))
    }

    /// The nodes where a step begins and ends.
    pub(super) fn step(&self, step: Step) -> [u32; 2] {
        self.ends[step as usize]
    }

    /// Seconds of a stop for pre-cuts between a step and the next.
    pub(super) fn stop(&self, step: Step, next: Step) -> f64 {
        (self.start() + self.gain(step, next)).max(0.0)
    }

    /// The areas on both sides of an element.
    pub(super) fn faces(&self, step: Step) -> [u32; 2] {
        self.beside[step as usize / 2]
    }

    /// The nodes where an order begins and ends.
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

    /// Seconds between home and an end of an order if the group is the only item; otherwise 0, because it is not known
    /// where the head comes from.
    pub(super) fn leg(&self, end: DVec2) -> f64 {
        if self.is_all { self.air.seconds(self.machine.home(), end) } else { 0.0 }
    }

    /// Seconds of every start of the beam.
    pub(super) fn start(&self) -> f64 {
        self.machine.beam_delays()
    }

    /// Seconds of an average air move.
    pub(super) fn average_way(&self) -> f64 {
        let count = self.nodes().count().max(1) as f64;
        self.nodes().map(|n| self.way(n, 0)).sum::<f64>() / count
    }

    /// Whether the beam begins again on any kerf of the group, without a pre-cut: where the machine makes none.
    pub(super) fn starts_on_kerfs(&self) -> bool {
        PLANS_ALL_LEVERS && !self.machine.makes_pre_cuts()
    }

    /// Seconds of a pre-cut; 0 where the machine makes none.
    pub(super) fn pre_cut(&self) -> f64 {
        self.machine.pre_cut_time.unwrap_or(0.0)
    }

    /// Whether every element still hangs on the sheet when it is cut. The order is checked backwards: an element that is
    /// put back must border on an area that hangs on the sheet by the elements put back before it.
    pub(super) fn is_possible(&self, order: &[Step]) -> bool {
        self.is_possible_from(&mut self.held(), order)
    }

    /// The same; `held` is a buffer with one entry for each area.
    pub(super) fn is_possible_from(&self, held: &mut [bool], order: &[Step]) -> bool {
        held.fill(false);
        held[0] = true;
        order.iter().rev().all(|&s| self.put_back(held, s))
    }

    /// The areas that hang on the sheet when everything is cut: only the one around the group.
    pub(super) fn held(&self) -> Vec<bool> {
        let mut held = vec![false; self.sides.len()];
        held[0] = true;
        held
    }

    /// Puts an element back: both its areas hang on the sheet if one of them did. Returns whether one did.
    pub(super) fn put_back(&self, held: &mut [bool], step: Step) -> bool {
        let [a, b] = self.faces(step).map(|f| f as usize);
        let holds = held[a] || held[b];
        (held[a], held[b]) = (holds, holds);
        holds
    }
}
