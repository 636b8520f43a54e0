//! Simulated annealing of the orders of larger groups: a move reverses a stretch of the order.

use super::follow::State;
use super::mixed::mixed;
use super::net::{Net, Order, Step};

/// Elements in all orders that one annealing looks at: a few milliseconds. More improves little.
const WORK: u64 = 200_000;
/// Fewest orders that are looked at, however long they are.
const LEAST_STEPS: u64 = 300;
/// Most orders that are looked at, however short they are.
const MOST_STEPS: u64 = 6000;
/// Temperature at the start: the most that a move may cost, in pre-cuts, or in trails where there are none.
const TEMPERATURE: f64 = 1.0;

/// The k-th uniform number of a seed, in [0, 1).
fn uniform(seed: u64, k: u64) -> f64 {
    (mixed(seed << 48 ^ k) >> 11) as f64 / (1_u64 << 53) as f64
}

/// Anneals an order: a reversed stretch stays if it costs less, or a little more at first. A stretch that returns to its
/// node is reversed without another air move; other stretches are reversed between air moves.
pub(super) fn annealed(net: &Net, order: Order) -> Order {
    let n = order.len();
    let steps = (WORK / n.max(1) as u64).clamp(LEAST_STEPS, MOST_STEPS);
    let mut cost = net.cost(&order);
    let (mut best, mut now) = ((cost, order.clone()), order);
    let (mut state, mut held) = (State::new(net), net.held());
    let scale = if net.starts_on_kerfs() { net.start() + net.average_way() } else { net.pre_cut() };
    let mut joints = Joints::default();
    joints.look(net, &now);
    for step in 0..steps {
        let draw = |k: u64| uniform(step + 1, k);
        let Some((from, to)) = joints.stretch(&draw) else { continue };
        let reverse = |order: &mut [Step]| {
            order[from..to].reverse();
            order[from..to].iter_mut().for_each(|s| *s ^= 1);
        };
        reverse(&mut now);
        let temperature = TEMPERATURE * scale * (1.0 - step as f64 / steps as f64);
        let after = net.cost_within(&mut state, &now, cost + temperature * draw(3));
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

/// Where the steps of an order start, and where it has air moves.
#[derive(Default)]
struct Joints {
    /// The node where each step starts.
    starts: Vec<u32>,
    /// Whether there is an air move before a step.
    loose: Vec<bool>,
    /// A buffer for the possible ends of a stretch.
    ends: Vec<usize>,
}

impl Joints {
    /// Reads an order.
    fn look(&mut self, net: &Net, order: &[Step]) {
        self.starts.clear();
        self.starts.extend(order.iter().map(|&s| net.step(s)[0]));
        self.loose.clear();
        self.loose.push(false);
        self.loose
            .extend(order.iter().zip(self.starts.iter().skip(1)).map(|(&s, &next)| net.step(s)[1] != next));
    }

    /// Draws a stretch to be reversed; both ends of the order stay.
    fn stretch(&mut self, draw: &impl Fn(u64) -> f64) -> Option<(usize, usize)> {
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "from 0 to below the count"
        )]
        let below = |k: u64, count: usize| (draw(k) * count as f64) as usize;
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
