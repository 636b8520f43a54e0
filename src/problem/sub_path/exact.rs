//! Every order of a small group: the cheapest from each node to each other one, by dynamic programming over the
//! elements cut so far and the last one. What is visited and what is loose depends on these alone.

use super::net::{Net, Order, State, Step};
use rustc_hash::FxHashMap;

/// Elements of a group at most: 2^10 sets with 20 last steps each.
pub(super) const MOST: usize = 10;

/// A best order so far: seconds, what was done, the step before the last.
struct Best {
    seconds: f64,
    state: State,
    before: Step,
}

const NONE: Step = Step::MAX;

/// The cheapest order from each of these nodes to each of them.
pub(super) fn all(net: &Net, ends: &[u32]) -> Vec<Order> {
    ends.iter().flat_map(|&start| from(net, start, ends)).collect()
}

fn from(net: &Net, start: u32, ends: &[u32]) -> Vec<Order> {
    let steps = net.steps().end;
    let full = (1_u32 << net.len()) - 1;
    let mut best: FxHashMap<(u32, Step), Best> = FxHashMap::default();
    let mut layer: Vec<(u32, Step)> = Vec::new();
    let price = |state: &State, step: Step| {
        let mut state = state.clone();
        (state.next(net, step).seconds, state)
    };
    for step in (0..steps).filter(|&s| net.step(s)[0] == start) {
        let (seconds, state) = price(&State::new(net), step);
        best.insert((1 << (step / 2), step), Best { seconds, state, before: NONE });
        layer.push((1 << (step / 2), step));
    }
    for _ in 1..net.len() {
        let mut next = Vec::new();
        for key in layer {
            let Some(Best { seconds, state, .. }) = best.get(&key) else { continue };
            let (seconds, state) = (*seconds, state.clone());
            for step in (0..steps).filter(|s| key.0 >> (s / 2) & 1 == 0) {
                let (more, after) = price(&state, step);
                let (to, total) = ((key.0 | 1 << (step / 2), step), seconds + more);
                let known = best.get(&to).map(|b| b.seconds);
                if known.is_none() {
                    next.push(to);
                }
                if known.is_none_or(|k| total < k) && net.may_follow(key.0, full, step) {
                    best.insert(to, Best { seconds: total, state: after, before: key.1 });
                }
            }
        }
        layer = next;
        crate::order::sort_by(&mut layer, |k| [u64::from(k.0), u64::from(k.1), 0]);
        layer.dedup();
    }
    let order = |last: Step| {
        let (mut set, mut step, mut order) = (full, last, Vec::new());
        while step != NONE {
            order.push(step);
            let before = best.get(&(set, step))?.before;
            (set, step) = (set & !(1 << (step / 2)), before);
        }
        order.reverse();
        Some(order)
    };
    let last = |end: u32| {
        let seconds = |s: Step| best.get(&(full, s)).map_or(f64::INFINITY, |b| b.seconds);
        let steps = (0..steps).filter(|&s| net.step(s)[1] == end && seconds(s) < f64::INFINITY);
        steps.reduce(|a, b| if seconds(b) < seconds(a) { b } else { a })
    };
    ends.iter().filter_map(|&end| order(last(end)?)).collect()
}

impl Net<'_> {
    /// Whether an element still hangs on the sheet when those of a set are cut: whether one of its areas is joined to the
    /// one around the group by elements not yet cut.
    fn may_follow(&self, cut: u32, full: u32, step: Step) -> bool {
        let left = full & !cut;
        let mut held = self.held();
        loop {
            let mut grew = false;
            for e in self.elements().filter(|e| left >> e & 1 == 1) {
                let [a, b] = self.group.elements[e as usize].faces.map(|f| f as usize);
                if held[a] != held[b] {
                    (held[a], held[b], grew) = (true, true, true);
                }
            }
            if !grew {
                return self.faces(step).iter().any(|&f| held[f as usize]);
            }
        }
    }
}
