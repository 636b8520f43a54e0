//! Following an order: what comes before each step, which pre-cuts it needs, and what that costs.

use super::net::{Net, ROUNDING, Step};

impl Net<'_> {
    /// The seconds of an order beyond those of cutting its elements one by one: air moves, piercings, pre-cuts and starts,
    /// minus what is saved where the beam goes on. Exact if every element is long enough to reach full speed.
    pub(super) fn cost(&self, order: &[Step]) -> f64 {
        let mut sum = 0.0;
        self.follow(order, |at| sum += at.seconds);
        sum
    }

    /// [`Net::cost`], if it is at most `limit`.
    pub(super) fn cost_within(&self, state: &mut State, order: &[Step], limit: f64) -> Option<f64> {
        state.begin(self);
        // Only the gains of the remaining elements can lower the sum.
        let mut left: f64 = self.most.iter().sum::<f64>() + ROUNDING;
        let mut sum = 0.0;
        for &step in order {
            sum += state.next(self, step).seconds;
            left -= self.most[step as usize / 2];
            if sum - left > limit {
                return None;
            }
        }
        (sum <= limit).then_some(sum)
    }

    /// Calls `visit` with each step of an order: what comes before it, and which pre-cuts it needs.
    pub(super) fn follow(&self, order: &[Step], mut visit: impl FnMut(&At)) {
        let mut state = State::new(self);
        for &step in order {
            visit(&state.next(self, step));
        }
    }
}

/// A step of an order, with what it needs there.
pub(super) struct At {
    pub(super) step: Step,
    /// The beam is switched on for it.
    pub(super) begins: bool,
    /// It is pierced, because nothing was cut at its start before.
    pub(super) pierced: bool,
    /// Something at its start has come loose before it.
    pub(super) loose: bool,
    /// Seconds that it adds to [`Net::cost`].
    pub(super) seconds: f64,
    /// The pre-cuts that it needs at its start and at its end, each as the number of steps done when it is made.
    pub(super) ahead: [Option<u32>; 2],
}

/// What an order has done so far.
pub(super) struct State {
    done: u32,
    last: Option<Step>,
    visited: Vec<bool>,
    /// By node: a part around it is finished, so that a later cut to here needs a pre-cut.
    loose: Vec<bool>,
    sides: Vec<u32>,
    /// By node: the cheapest stop of the beam for a pre-cut, as its seconds and the number of steps done.
    stops: Vec<(f64, u32)>,
}

impl State {
    pub(super) fn new(net: &Net) -> Self {
        let nodes = net.group.nodes.len();
        Self {
            done: 0,
            last: None,
            visited: vec![false; nodes],
            loose: vec![false; nodes],
            sides: net.sides.clone(),
            stops: vec![(f64::INFINITY, 0); nodes],
        }
    }

    /// Resets the state to before the first step.
    fn begin(&mut self, net: &Net) {
        (self.done, self.last) = (0, None);
        self.visited.fill(false);
        self.loose.fill(false);
        self.sides.copy_from_slice(&net.sides);
        self.stops.fill((f64::INFINITY, 0));
    }

    /// Does the next step. A pre-cut is made when the beam stops at its node anyway, if that is before anything there is
    /// finished; otherwise a run is interrupted for it.
    fn next(&mut self, net: &Net, step: Step) -> At {
        let [from, to] = net.step(step);
        let head = self.last.map(|last| net.step(last)[1]);
        let begins = head != Some(from);
        let pierced = begins && !self.visited[from as usize];
        let mut seconds = 0.0;
        if begins {
            if let Some(head) = head {
                seconds += net.way(head, from);
                self.may_stop(head, 0.0);
            }
            seconds += net.start();
            if pierced {
                seconds += net.machine.pierce_time;
                self.may_stop(from, 0.0);
            }
        } else if let Some(last) = self.last {
            let gain = net.gain(last, step);
            seconds -= gain;
            self.may_stop(from, net.stop(last, step));
        }
        let mut pre_cut = |node: u32| {
            if net.starts_on_kerfs() {
                return None;
            }
            let stop = &mut self.stops[node as usize];
            seconds += net.pre_cut() + std::mem::replace(&mut stop.0, 0.0);
            Some(stop.1)
        };
        let loose = self.loose[from as usize];
        let before = if begins && !pierced { pre_cut(from) } else { None };
        let ahead = [before, if self.loose[to as usize] { pre_cut(to) } else { None }];
        self.done += 1;
        self.last = Some(step);
        self.visited[from as usize] = true;
        self.visited[to as usize] = true;
        for f in net.faces(step) {
            let left = &mut self.sides[f as usize];
            *left -= 1;
            if *left == 0 && f != 0 {
                net.around[f as usize].iter().for_each(|&n| self.loose[n as usize] = true);
            }
        }
        At { step, begins, pierced, loose, seconds, ahead }
    }

    /// Notes that the beam stops at a node now, or could stop there for this many seconds.
    fn may_stop(&mut self, node: u32, seconds: f64) {
        let stop = &mut self.stops[node as usize];
        if seconds < stop.0 && !self.loose[node as usize] {
            *stop = (seconds, self.done);
        }
    }
}
