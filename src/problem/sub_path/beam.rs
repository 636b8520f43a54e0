//! Orders of larger groups: from the last element to the first, several at a time, the cheapest so far kept (beam search).
//!
//! Backwards, an element may be put back where an area beside it hangs on the sheet already, and one can always be; and it is
//! known whether anything has come loose where it ends. What is not known is whether the beam stops at a node in time for a
//! pre-cut: a stop is charged, and given back when a trail ends there before. (A trail is what is cut between two air
//! moves.) Orders of as many elements are compared by their seconds and those of the trails still needed: where an odd number
//! of elements is left, a trail begins or ends.

use super::mixed;
use super::net::{Net, Order, Step};
use crate::order::{real, sort_by};
use rustc_hash::FxHashSet;

/// Orders kept, for groups of up to so many elements in all of them; and the least and the most.
const KEPT: usize = 14_000;
const LEAST: usize = 16;
const MOST: usize = 64;
/// Nodes looked at as the end of the trail before: so many of those with one element left, and of others, the nearest;
/// rather where an odd number of elements is left.
const JUMPS: usize = 3;

/// What has been put back.
#[derive(Clone)]
struct State {
    /// The node where the next one is to end, and the step that follows it; none before the first.
    here: u32,
    after: Option<Step>,
    used: Vec<bool>,
    held: Vec<bool>,
    /// Elements left at each node.
    left: Vec<u8>,
    counts: Counts,
    /// By node: a stop for pre-cuts is charged.
    stops: Vec<bool>,
    seconds: f64,
    /// Tells sets of elements apart.
    key: u64,
    /// Its place in the list of steps.
    made: usize,
}

/// Nodes at which trails must begin or end.
#[derive(Clone, Copy, Default)]
struct Counts {
    /// With an odd number of elements left.
    odd: i32,
    /// With one left: a trail that begins there is pierced.
    single: i32,
}

impl Counts {
    fn change(&mut self, left: u8, by: i32) {
        self.odd += by * i32::from(left % 2);
        self.single += by * i32::from(left == 1);
    }
}

/// A step that may be put back next.
struct Next {
    score: f64,
    seconds: f64,
    state: usize,
    step: Step,
    key: u64,
    counts: Counts,
    /// By a jump from the node where the state is.
    jumps: bool,
    stops: bool,
}

/// Steps put back, with those after them.
type Made = Vec<(Step, usize)>;

struct Search<'n> {
    net: &'n Net<'n>,
    /// Steps that end at each node, and areas there.
    arriving: Vec<Vec<Step>>,
    around: Vec<Vec<u32>>,
    /// Seconds of a further trail, air left out, and how many more if it is pierced.
    trail: f64,
    pierced: f64,
}

/// Orders that end at a node, each from another node, the cheapest first.
pub(super) fn orders(net: &Net, to: u32) -> Vec<Order> {
    let width = (KEPT / net.len().max(1)).clamp(LEAST, MOST);
    let search = Search::new(net);
    let mut made: Made = Vec::new();
    let mut states = vec![search.first(to)];
    for _ in 0..net.len() {
        let mut next: Vec<Next> = Vec::new();
        for k in 0..states.len() {
            search.steps(&states, k, &mut next);
        }
        sort_by(&mut next, |n| [real(n.score), n.state as u64, n.step.into()]);
        let mut seen = FxHashSet::default();
        next.retain(|n| seen.insert(n.key));
        next.truncate(width);
        states = next.iter().map(|n| search.put_back(&states[n.state], n, &mut made)).collect();
    }
    let mut found: Vec<(f64, Order)> = Vec::new();
    for state in &states {
        let (mut at, mut order) = (state.made, Order::with_capacity(net.len()));
        while let Some(&(step, before)) = made.get(at) {
            order.push(step);
            at = before;
        }
        if !found.iter().any(|f| net.ends(&f.1) == net.ends(&order)) {
            found.push((net.cost(&order), order));
        }
    }
    sort_by(&mut found, |f| [real(f.0), 0, 0]);
    found.into_iter().map(|f| f.1).collect()
}

impl<'n> Search<'n> {
    fn new(net: &'n Net<'n>) -> Self {
        let nodes = net.nodes().count();
        let (mut arriving, mut around) = (vec![Vec::new(); nodes], vec![Vec::new(); nodes]);
        for step in net.steps() {
            let node = net.step(step)[1] as usize;
            arriving[node].push(step);
            for f in net.faces(step) {
                if !around[node].contains(&f) {
                    around[node].push(f);
                }
            }
        }
        let ready = net.machine.pierce_time.min(net.pre_cut() + net.start());
        let (trail, pierced) = (net.start() + ready, net.machine.pierce_time - ready);
        Self { net, arriving, around, trail, pierced }
    }

    fn first(&self, to: u32) -> State {
        let left: Vec<u8> = self.arriving.iter().map(|a| u8::try_from(a.len()).unwrap_or(u8::MAX)).collect();
        let mut counts = Counts::default();
        left.iter().for_each(|&l| counts.change(l, 1));
        State {
            here: to,
            after: None,
            used: vec![false; self.net.len()],
            held: self.net.held(),
            counts,
            stops: vec![false; left.len()],
            left,
            seconds: 0.0,
            key: 0,
            made: usize::MAX,
        }
    }

    /// Steps that may be put back where a state is, or after a jump.
    fn steps(&self, states: &[State], which: usize, next: &mut Vec<Next>) {
        let state = &states[which];
        let open = |node: u32| {
            self.arriving[node as usize].iter().copied().filter(|&s| {
                !state.used[s as usize / 2] && self.net.faces(s).iter().any(|&f| state.held[f as usize])
            })
        };
        for step in open(state.here) {
            let gain = state.after.map_or(0.0, |after| self.net.gain(step, after));
            self.push(states, which, step, None, -gain, next);
        }
        if state.after.is_none() {
            return;
        }
        // The trail begins here: where something was cut before, with a pre-cut.
        let here = state.here as usize;
        let visited = state.left[here] > 0;
        let stop = visited && !state.stops[here];
        let begin = self.net.start()
            + if visited { self.net.pre_cut() } else { self.net.machine.pierce_time }
            + if stop { self.net.start() } else { 0.0 };
        let mut ends: Vec<(f64, u32)> = self
            .net
            .nodes()
            .filter(|&n| n != state.here && state.left[n as usize] > 0 && open(n).next().is_some())
            .map(|n| {
                let even = if state.left[n as usize].is_multiple_of(2) { self.trail } else { 0.0 };
                (self.net.way(n, state.here) + even, n)
            })
            .collect();
        sort_by(&mut ends, |e| [real(e.0), e.1.into(), 0]);
        let is_last = |n: u32| state.left[n as usize] == 1;
        let last = ends.iter().filter(|e| is_last(e.1)).take(JUMPS);
        for &(_, n) in last.chain(ends.iter().filter(|e| !is_last(e.1)).take(JUMPS)) {
            let free = state.stops[n as usize] && self.is_held(state, n, None);
            let way = self.net.way(n, state.here) - if free { self.net.start() } else { 0.0 };
            for step in open(n) {
                self.push(states, which, step, Some(visited), begin + way, next);
            }
        }
    }

    fn push(
        &self,
        states: &[State],
        state: usize,
        step: Step,
        jump: Option<bool>,
        more: f64,
        next: &mut Vec<Next>,
    ) {
        let s = &states[state];
        let [from, to] = self.net.step(step);
        let jumps = jump.is_some();
        let loose = !self.is_held(s, to, Some(step));
        let stops = s.stops[to as usize] && !(jumps && self.is_held(s, to, None));
        let pre_cut = if loose { self.net.pre_cut() } else { 0.0 };
        let stop = if loose && !stops { self.net.start() } else { 0.0 };
        let seconds = s.seconds + more + pre_cut + stop;
        let mut counts = s.counts;
        let mut begins = s.left[from as usize] - 1;
        if from == to {
            begins -= 1;
            counts.change(s.left[from as usize], -1);
            counts.change(begins, 1);
        } else {
            for n in [from, to] {
                counts.change(s.left[n as usize], -1);
                counts.change(s.left[n as usize] - 1, 1);
            }
        }
        let goes_on = !begins.is_multiple_of(2);
        let trails = (counts.odd / 2 - i32::from(goes_on)).max(0);
        let pierced = (counts.single - trails - 1).clamp(0, trails);
        let key = s.key ^ mixed(u64::from(step / 2) + 1);
        next.push(Next {
            score: seconds + f64::from(trails) * self.trail + f64::from(pierced) * self.pierced,
            counts,
            seconds,
            state,
            step,
            key: key ^ mixed(u64::from(from) << 32),
            jumps,
            stops: loose,
        });
    }

    /// Whether all areas at a node hang on the sheet, with a step put back.
    fn is_held(&self, state: &State, node: u32, step: Option<Step>) -> bool {
        let joined = step.map_or([u32::MAX; 2], |s| self.net.faces(s));
        self.around[node as usize].iter().all(|f| state.held[*f as usize] || joined.contains(f))
    }

    fn put_back(&self, before: &State, next: &Next, made: &mut Made) -> State {
        let mut state = before.clone();
        let [from, to] = self.net.step(next.step);
        if next.jumps {
            let here = state.here as usize;
            state.stops[here] |= state.left[here] > 0;
            if self.is_held(before, to, None) {
                state.stops[to as usize] = false;
            }
        }
        state.stops[to as usize] |= next.stops;
        state.used[next.step as usize / 2] = true;
        self.net.put_back(&mut state.held, next.step);
        for n in [from, to] {
            state.left[n as usize] -= 1;
        }
        state.counts = next.counts;
        state.key ^= mixed(u64::from(next.step / 2) + 1);
        state.seconds = next.seconds;
        state.here = from;
        state.after = Some(next.step);
        made.push((next.step, state.made));
        state.made = made.len() - 1;
        state
    }
}
