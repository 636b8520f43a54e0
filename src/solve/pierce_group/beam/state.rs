//! A state of the beam search: what has been put back, and its cost.

use super::super::mixed::mixed;
use super::super::net::{Net, Step};
use super::places::Places;

/// A partial order, which ends the order of the whole group.
#[derive(Clone)]
pub(super) struct State {
    used: Vec<bool>,
    held: Vec<bool>,
    /// Elements left at each node.
    left: Vec<u8>,
    /// By node: a stop for pre-cuts is charged.
    stops: Vec<bool>,
    pub(super) at: At,
}

/// Where a state is.
#[derive(Clone, Copy)]
pub(super) struct At {
    /// The node where the next one is to end, and the step that follows it; none before the first.
    pub(super) here: u32,
    pub(super) after: Option<Step>,
    pub(super) counts: Counts,
    pub(super) seconds: f64,
    /// Hash of the set of elements.
    set: u64,
    /// Index of the first step in the list of steps.
    pub(super) made: usize,
}

/// Nodes at which trails must begin or end.
#[derive(Clone, Copy, Default)]
pub(super) struct Counts {
    /// With an odd number of elements left.
    pub(super) odd: i32,
    /// With one left: a trail that begins there is pierced.
    pub(super) single: i32,
}

impl Counts {
    fn change(&mut self, left: u8, by: i32) {
        self.odd += by * i32::from(left % 2);
        self.single += by * i32::from(left == 1);
    }
}

/// What putting an element back has overwritten, except for [`State::at`].
pub(super) struct Undo {
    step: Step,
    held: [bool; 2],
    /// At the node from which the head would come, and where it ends.
    stops: [(u32, bool); 2],
}

impl State {
    /// The empty order, which ends at a node.
    pub(super) fn new(net: &Net, to: u32) -> Self {
        let mut left = vec![0_u8; net.nodes().count()];
        for step in net.steps() {
            let l = &mut left[net.step(step)[1] as usize];
            *l = l.saturating_add(1);
        }
        let mut counts = Counts::default();
        left.iter().for_each(|&l| counts.change(l, 1));
        let at =
            At { here: to, after: None, counts, seconds: net.leg(net.place(to)), set: 0, made: usize::MAX };
        Self { used: vec![false; net.len()], held: net.held(), stops: vec![false; left.len()], left, at }
    }

    /// Elements left at a node.
    pub(super) fn left(&self, node: u32) -> u8 {
        self.left[node as usize]
    }

    /// Hash of the set of elements and the node where the state is.
    pub(super) fn key(&self) -> u64 {
        self.at.set ^ mixed(u64::from(self.at.here) << 32)
    }

    /// Whether an element may be put back: it is left, and an area beside it hangs on the sheet.
    pub(super) fn may_take(&self, net: &Net, step: Step) -> bool {
        !self.used[step as usize / 2] && net.faces(step).iter().any(|&f| self.held[f as usize])
    }

    /// Whether all areas at a node hang on the sheet.
    fn is_held(&self, places: &Places, node: u32) -> bool {
        places.areas(node).iter().all(|f| self.held[*f as usize])
    }

    /// Puts an element back; `jumps`: with an air move after it.
    pub(super) fn put_back(&mut self, net: &Net, places: &Places, step: Step, jumps: bool) -> Undo {
        let [from, to] = net.step(step);
        let here = self.at.here;
        let areas = net.faces(step).map(|f| f as usize);
        let undo = Undo {
            step,
            held: areas.map(|f| self.held[f]),
            stops: [here, to].map(|n| (n, self.stops[n as usize])),
        };
        if jumps {
            self.at.seconds += self.trail(net, here) + net.way(to, here);
            if self.stops[to as usize] && self.is_held(places, to) {
                self.at.seconds -= net.start();
                self.stops[to as usize] = false;
            }
        } else if let Some(after) = self.at.after {
            self.at.seconds -= net.gain(step, after);
        }
        net.put_back(&mut self.held, step);
        if !self.is_held(places, to) {
            self.at.seconds += self.pre_cut(net, to);
        }
        for node in [from, to] {
            let left = &mut self.left[node as usize];
            self.at.counts.change(*left, -1);
            *left -= 1;
            self.at.counts.change(*left, 1);
        }
        self.used[step as usize / 2] = true;
        self.at.set ^= mixed(u64::from(step / 2) + 1);
        (self.at.here, self.at.after) = (from, Some(step));
        undo
    }

    /// Seconds of a trail that begins at a node: with a pre-cut where something was cut before.
    fn trail(&mut self, net: &Net, node: u32) -> f64 {
        let ready = if self.left(node) == 0 { net.machine.pierce_time } else { self.pre_cut(net, node) };
        net.start() + ready
    }

    /// Seconds of a pre-cut at a node, and of the stop for it if none is charged yet.
    fn pre_cut(&mut self, net: &Net, node: u32) -> f64 {
        if net.starts_on_kerfs() {
            return 0.0;
        }
        let stops = std::mem::replace(&mut self.stops[node as usize], true);
        net.pre_cut() + if stops { 0.0 } else { net.start() }
    }

    /// Takes the last element away again; the caller restores [`State::at`].
    pub(super) fn take_away(&mut self, net: &Net, undo: Undo) {
        let areas = net.faces(undo.step).map(|f| f as usize);
        [self.held[areas[0]], self.held[areas[1]]] = undo.held;
        for (node, stops) in undo.stops {
            self.stops[node as usize] = stops;
        }
        for node in net.step(undo.step) {
            self.left[node as usize] += 1;
        }
        self.used[undo.step as usize / 2] = false;
    }
}
