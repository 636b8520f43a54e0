//! The cheapest order of a small group from each node to each other one, by dynamic programming over the set of elements cut
//! so far and the last one.
//!
//! Which nodes are visited, which are loose and what still hangs on the sheet depends on the set alone. Where a pre-cut can
//! still be made does not: it takes a stop of the beam at its node before anything there is loose, and the order may or may
//! not have stopped there. So several orders of one set are kept: a slower order is useful if it stopped at more nodes.

use super::net::{Net, Order, Step};

/// Most elements of a group: 2^10 sets with 20 last steps each. They are connected, so that there are at most 11 nodes.
pub(super) const MOST: usize = 10;

/// A set of elements or of nodes, as bits.
type Set = u32;

/// A partial order of elements.
struct Label {
    seconds: f64,
    /// Nodes where the beam stopped before anything there was loose.
    ready: Set,
    last: Step,
    /// The order without its last step.
    before: Option<u32>,
}

/// What is left after a set of elements has been cut.
#[derive(Clone, Default)]
struct Left {
    /// Elements that may be cut.
    may: Set,
    visited: Set,
    loose: Set,
    /// Nodes where something is left to be cut.
    open: Set,
}

struct Table<'n> {
    net: &'n Net<'n>,
    /// Seconds from node to node.
    ways: Vec<Vec<f64>>,
    /// By set of elements.
    left: Vec<Left>,
    labels: Vec<Label>,
    /// By set of elements and last step: the labels that no other label dominates.
    kept: Vec<Vec<u32>>,
}

/// The cheapest order from each node to each other one, by [`Net::cost`].
pub(super) fn all(net: &Net) -> Vec<Order> {
    let left: Vec<Left> = (0..1 << net.len()).map(|cut| net.left(cut)).collect();
    let kept = vec![Vec::new(); left.len() * net.steps().len()];
    let ways = net.nodes().map(|a| net.nodes().map(|b| net.way(a, b)).collect()).collect();
    let mut table = Table { net, ways, left, labels: Vec::new(), kept };
    net.nodes().flat_map(|start| table.from(start)).collect()
}

impl Table<'_> {
    /// The cheapest orders from a node to each other one.
    fn from(&mut self, start: u32) -> Vec<Order> {
        let net = self.net;
        self.labels.clear();
        self.kept.iter_mut().for_each(Vec::clear);
        for last in net.steps().filter(|&s| net.step(s)[0] == start) {
            if self.left[0].may >> (last / 2) & 1 == 1 {
                let seconds = net.machine.pierce_time + net.start();
                self.keep(1 << (last / 2), Label { seconds, ready: 1 << start, last, before: None });
            }
        }
        for cut in 1..self.left.len() - 1 {
            for last in net.steps() {
                for k in 0..self.kept[self.place(cut, last)].len() {
                    let label = self.kept[self.place(cut, last)][k];
                    self.go_on(cut, label);
                }
            }
        }
        let full = self.left.len() - 1;
        let best = |end: u32| {
            let steps = net.steps().filter(|&s| net.step(s)[1] == end);
            let labels = steps.flat_map(|s| &self.kept[self.place(full, s)]).copied();
            let seconds = |k: u32| self.labels[k as usize].seconds;
            labels.reduce(|a, b| if seconds(b) < seconds(a) { b } else { a })
        };
        net.nodes().filter_map(best).map(|k| self.order(k)).collect()
    }

    /// Extends a label by every step that may follow.
    fn go_on(&mut self, cut: usize, label: u32) {
        let net = self.net;
        let Label { seconds, ready, last, .. } = self.labels[label as usize];
        let Left { may, visited, loose, .. } = self.left[cut];
        let head = net.step(last)[1];
        for step in net.steps().filter(|s| may >> (s / 2) & 1 == 1) {
            let [from, to] = net.step(step);
            let mut ways = [None; 2];
            if from == head {
                let seconds = seconds - net.gain(last, step);
                ways[0] = Some((seconds, ready));
                if (ready | loose) >> from & 1 == 0 {
                    ways[1] = Some((seconds + net.stop(last, step), ready | 1 << from));
                }
            } else {
                let ready = ready | (1 << head & !loose);
                let there = seconds + self.ways[head as usize][from as usize] + net.start();
                if visited >> from & 1 == 0 {
                    ways[0] = Some((there + net.machine.pierce_time, ready | 1 << from));
                } else if net.starts_on_kerfs() || ready >> from & 1 == 1 {
                    ways[0] = Some((there + net.pre_cut(), ready));
                }
            }
            for (mut seconds, ready) in ways.into_iter().flatten() {
                if loose >> to & 1 == 1 && !net.starts_on_kerfs() {
                    if ready >> to & 1 == 0 {
                        continue;
                    }
                    seconds += net.pre_cut();
                }
                self.keep(cut | 1 << (step / 2), Label { seconds, ready, last: step, before: Some(label) });
            }
        }
    }

    /// Keeps a label unless another dominates it, and drops the labels that it dominates.
    fn keep(&mut self, cut: usize, mut label: Label) {
        // Nothing has to be ready where the beam begins on any kerf.
        label.ready &= if self.net.starts_on_kerfs() { 0 } else { self.left[cut].open };
        let place = self.place(cut, label.last);
        let (labels, kept) = (&self.labels, &mut self.kept[place]);
        let dominates = |a: &Label, b: &Label| a.seconds <= b.seconds && b.ready & !a.ready == 0;
        if kept.iter().any(|&k| dominates(&labels[k as usize], &label)) {
            return;
        }
        kept.retain(|&k| !dominates(&label, &labels[k as usize]));
        kept.extend(u32::try_from(labels.len()));
        self.labels.push(label);
    }

    fn place(&self, cut: usize, last: Step) -> usize {
        cut * self.net.steps().len() + last as usize
    }

    fn order(&self, label: u32) -> Order {
        let before = |k: &u32| self.labels[*k as usize].before;
        let mut order: Order =
            std::iter::successors(Some(label), before).map(|k| self.labels[k as usize].last).collect();
        order.reverse();
        order
    }
}

impl Net<'_> {
    fn left(&self, cut: Set) -> Left {
        let mut left = Left::default();
        let mut held = self.held();
        let uncut = |e: &u32| cut >> e & 1 == 0;
        // All elements that are left hold, in whatever order they are put back.
        for _ in 0..self.group.faces {
            self.elements().filter(uncut).for_each(|e| {
                self.put_back(&mut held, 2 * e);
            });
        }
        for e in self.elements() {
            let nodes = self.step(2 * e).into_iter().fold(0, |set, n| set | 1 << n);
            let holds = self.faces(2 * e).iter().all(|&f| held[f as usize]);
            if uncut(&e) {
                left.open |= nodes;
                left.may |= u32::from(holds) << e;
            } else {
                left.visited |= nodes;
            }
            if !holds {
                left.loose |= nodes;
            }
        }
        left
    }
}
