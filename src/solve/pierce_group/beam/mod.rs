//! Beam search for the orders of larger groups, from the last element to the first.
//!
//! The search goes backwards and puts elements back. An element may be put back if an area beside it already hangs on the
//! sheet, so that there is always one, and it is known whether anything has come loose where it ends. It is not known whether
//! the beam stops at a node in time for a pre-cut: a stop is charged, and refunded if a trail ends there earlier. (A trail is
//! what is cut between two air moves.)
//!
//! A step puts back one element or, in larger groups, a run: straight on through nodes where an odd number of elements is
//! left, because a trail goes on there anyway. So a line through a grid is one decision. Partial orders with the same number
//! of elements are compared by their seconds and those of the trails they still need: a trail begins or ends at every node
//! where an odd number of elements is left.
//!
//! * [`state`]: what has been put back, and its cost. [`next`]: what may be put back next. [`places`]: what is at each node.

mod next;
mod places;
mod state;

use super::net::{Net, Order, Step};
use crate::order::{real, sort_by};
use places::Places;
use rustc_hash::FxHashSet;
use state::{State, Undo};
use std::rc::Rc;

/// Width of the beam: a smaller one gives slower paths, a larger one takes longer and gains nothing.
const WIDTH: usize = 16;
/// Elements of a group up to which the beam has its full width. The beam of a larger group is narrower, so that a search takes
/// seconds: its time grows with the width and nearly the square of this number. Half the width is as good on grids of 1,900 to
/// 20,200 elements, and a quarter of it took 1 % longer to cut.
const FULL_WIDTH: usize = 10_000;
/// Width of the beam for the largest groups. A grid of 20,200 took 5 % longer to cut with half of it.
const LEAST_WIDTH: usize = 4;
/// Most elements of a group that is put back element by element. In larger groups runs are put back, and future trails are
/// charged an average air move to a near node.
const FEW: usize = 24;
/// Width of the beam for such a group.
const WIDTH_OF_FEW: usize = 64;
/// Candidates are reduced to the width of the beam when there are this many times more: it bounds the memory.
const ROOM: usize = 8;

/// A candidate for the next state: what is put back after another one.
struct Next {
    before: Rc<State>,
    way: Way,
}

/// What may be put back after a state.
struct Way {
    score: f64,
    step: Step,
    /// The step does not end where the state is: there is an air move between them.
    jumps: bool,
    /// The elements straight on are put back with it.
    runs: bool,
    key: u64,
}

/// Steps that were put back, each with the index of the step after it.
type Made = Vec<(Step, usize)>;

/// A search for the orders of a group.
pub(super) struct Search<'n> {
    net: &'n Net<'n>,
    places: Places,
    is_small: bool,
    /// Least seconds of a further trail.
    trail: f64,
    /// Extra seconds if it is pierced.
    pierced: f64,
}

impl<'n> Search<'n> {
    pub(super) fn new(net: &'n Net<'n>) -> Self {
        let stop = if net.starts_on_kerfs() { 0.0 } else { net.pre_cut() + net.start() };
        let ready = net.machine.pierce_time.min(stop);
        let is_small = net.len() <= FEW;
        let places = Places::new(net);
        Self {
            net,
            is_small,
            trail: net.start() + ready + if is_small { 0.0 } else { places.average_way(net) },
            places,
            pierced: net.machine.pierce_time - ready,
        }
    }

    /// Orders that end at one of some nodes, each from another node, the cheapest first.
    pub(super) fn orders(&self, to: &[u32]) -> Vec<Order> {
        let len = self.net.len();
        let width = if self.is_small { WIDTH_OF_FEW * to.len() } else { width_for(len) };
        let mut made = Made::new();
        // Candidates by the number of elements put back.
        let mut next: Vec<Vec<Next>> = std::iter::repeat_with(Vec::new).take(len + 1).collect();
        let mut states: Vec<State> = to.iter().map(|&n| State::new(self.net, n)).collect();
        for count in 0..=len {
            for n in best(std::mem::take(&mut next[count]), width) {
                let (mut state, way) = (Rc::unwrap_or_clone(n.before), n.way);
                let mut put = |state: &mut State, step, jumps| {
                    state.put_back(self.net, &self.places, step, jumps);
                    made.push((step, state.at.made));
                    state.at.made = made.len() - 1;
                };
                put(&mut state, way.step, way.jumps);
                while let Some(step) = self.goes_on(&state).filter(|_| way.runs) {
                    put(&mut state, step, false);
                }
                states.push(state);
            }
            if count < len {
                states.drain(..).for_each(|s| self.look_further(s, width, &mut next[count..]));
            }
        }
        self.cheapest(&states, &made)
    }

    /// Adds all candidates after a state, with the elements straight on and without them.
    fn look_further(&self, mut state: State, width: usize, next: &mut [Vec<Next>]) {
        let (at, mut undo): (_, Vec<Undo>) = (state.at, Vec::new());
        let mut ways: Vec<(usize, Way)> = Vec::new();
        for (step, jumps) in self.places.steps(self.net, &state) {
            undo.push(state.put_back(self.net, &self.places, step, jumps));
            let mut runs = false;
            loop {
                let on = self.goes_on(&state);
                if !runs || on.is_none() {
                    let (score, key) = (self.score(&state), state.key());
                    ways.push((undo.len(), Way { score, step, jumps, runs, key }));
                }
                let Some(step) = on else { break };
                undo.push(state.put_back(self.net, &self.places, step, false));
                runs = true;
            }
            undo.drain(..).rev().for_each(|u| state.take_away(self.net, u));
            state.at = at;
        }
        let before = Rc::new(state);
        for (count, way) in ways {
            let found = &mut next[count];
            found.push(Next { before: Rc::clone(&before), way });
            if found.len() > ROOM * width {
                *found = best(std::mem::take(found), width);
            }
        }
    }

    /// The element straight on, if an odd number of elements is left here and it is one of them.
    fn goes_on(&self, state: &State) -> Option<Step> {
        let on = self.places.straight_on(state.at.after?).filter(|_| !self.is_small)?;
        (!state.left(state.at.here).is_multiple_of(2) && state.may_take(self.net, on)).then_some(on)
    }

    /// The seconds of a state and a lower estimate of those of the missing trails.
    fn score(&self, state: &State) -> f64 {
        let goes_on = !state.left(state.at.here).is_multiple_of(2);
        let counts = state.at.counts;
        let trails = (counts.odd / 2 - i32::from(goes_on)).max(0);
        let pierced = (counts.single - trails - 1).clamp(0, trails);
        state.at.seconds + f64::from(trails) * self.trail + f64::from(pierced) * self.pierced
    }

    /// The orders that were found, the cheapest first, one for each pair of ends.
    fn cheapest(&self, states: &[State], made: &Made) -> Vec<Order> {
        let mut found: Vec<(f64, Order)> = Vec::new();
        for state in states {
            let (mut at, mut order) = (state.at.made, Order::with_capacity(self.net.len()));
            while let Some(&(step, before)) = made.get(at) {
                order.push(step);
                at = before;
            }
            let ends = self.net.ends(&order);
            if !found.iter().any(|f| self.net.ends(&f.1) == ends) {
                let legs = ends.map(|n| self.net.leg(self.net.place(n)));
                found.push((self.net.cost(&order) + legs[0] + legs[1], order));
            }
        }
        sort_by(&mut found, |f| [real(f.0), 0, 0]);
        found.into_iter().map(|f| f.1).collect()
    }
}

/// The width of the beam for a larger group of this many elements.
fn width_for(len: usize) -> usize {
    (WIDTH * FULL_WIDTH / len).clamp(LEAST_WIDTH, WIDTH)
}

/// The best candidates, of which each has another set of elements or another end.
fn best(mut next: Vec<Next>, width: usize) -> Vec<Next> {
    sort_by(&mut next, |n| [real(n.way.score), n.before.at.made as u64, n.way.step.into()]);
    let mut seen = FxHashSet::default();
    next.retain(|n| seen.insert(n.way.key));
    next.truncate(width);
    next
}
