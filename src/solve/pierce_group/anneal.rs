//! Orders of larger groups: exchanges, by simulated annealing.

use super::follow::State;
use super::mixed::mixed;
use super::net::{Net, Order, Step};

/// Elements in all orders that are looked at to anneal one, and how many orders that may be: a few milliseconds.
const WORK: u64 = 200_000;
const LEAST_TURNS: u64 = 300;
const MOST_TURNS: u64 = 6000;
/// Seconds that a change may cost at first, in pre-cuts.
const WARMTH: f64 = 1.0;

/// Evenly spread numbers, from 0 to 1: which of several ways is preferred.
fn whim(seed: u64, k: u64) -> f64 {
    (mixed(seed << 48 ^ k) >> 11) as f64 / (1_u64 << 53) as f64
}

/// An order with stretches turned round, as long as that takes less, or a little more to begin with: simulated annealing.
/// A stretch that comes back to its node may be turned without an air move more; others are turned at air moves.
pub(super) fn annealed(net: &Net, order: Order) -> Order {
    let n = order.len();
    let turns = (WORK / n.max(1) as u64).clamp(LEAST_TURNS, MOST_TURNS);
    let mut cost = net.cost(&order);
    let (mut best, mut now) = ((cost, order.clone()), order);
    let (mut state, mut held) = (State::new(net), net.held());
    let mut joints = Joints::default();
    joints.look(net, &now);
    for turn in 0..turns {
        let dice = |k: u64| whim(turn + 1, k);
        let Some((from, to)) = joints.stretch(&dice) else { continue };
        let reverse = |order: &mut [Step]| {
            order[from..to].reverse();
            order[from..to].iter_mut().for_each(|s| *s ^= 1);
        };
        reverse(&mut now);
        let warmth = WARMTH * net.pre_cut() * (1.0 - turn as f64 / turns as f64);
        let after = net.cost_within(&mut state, &now, cost + warmth * dice(3));
        if let Some(after) = after.filter(|_| net.is_possible_from(&mut held, &now)) {
            cost = after;
            if cost < best.0 - 1e-9 {
                best.0 = cost;
                best.1.clone_from(&now);
            }
            joints.look(net, &now);
        } else {
            reverse(&mut now);
        }
    }
    best.1
}

/// What follows what in an order.
#[derive(Default)]
struct Joints {
    /// Where each step starts.
    starts: Vec<u32>,
    /// There is an air move before it.
    loose: Vec<bool>,
    /// Room for the ends of a stretch.
    ends: Vec<usize>,
}

impl Joints {
    fn look(&mut self, net: &Net, order: &[Step]) {
        self.starts.clear();
        self.starts.extend(order.iter().map(|&s| net.step(s)[0]));
        self.loose.clear();
        self.loose.push(false);
        self.loose
            .extend(order.iter().zip(self.starts.iter().skip(1)).map(|(&s, &next)| net.step(s)[1] != next));
    }

    /// Steps to be turned round, both ends of the order kept.
    fn stretch(&mut self, dice: &impl Fn(u64) -> f64) -> Option<(usize, usize)> {
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "from 0 to below the count"
        )]
        let below = |k: u64, count: usize| (dice(k) * count as f64) as usize;
        let Self { starts, loose, ends } = self;
        let n = starts.len();
        let one = 1 + below(0, n.checked_sub(2)?.max(1));
        let fits = |k: &usize| *k != one && (starts[*k] == starts[one] || loose[one] || loose[*k]);
        ends.clear();
        ends.extend((1..n).filter(fits));
        let other = *ends.get(below(1, ends.len()))?;
        Some((one.min(other), one.max(other)))
    }
}
