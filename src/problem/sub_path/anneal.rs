//! Orders of larger groups: exchanges, by simulated annealing.

use super::mixed;
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
    for turn in 0..turns {
        let dice = |k: u64| whim(turn + 1, k);
        let Some((from, to)) = stretch(net, &now, &dice) else { continue };
        let reverse = |order: &mut [Step]| {
            order[from..to].reverse();
            order[from..to].iter_mut().for_each(|s| *s ^= 1);
        };
        reverse(&mut now);
        let after = if net.is_possible(&now) { net.cost(&now) } else { f64::INFINITY };
        let warmth = WARMTH * net.pre_cut() * (1.0 - turn as f64 / turns as f64);
        if after <= cost + warmth * dice(3) {
            cost = after;
            if cost < best.0 - 1e-9 {
                best = (cost, now.clone());
            }
        } else {
            reverse(&mut now);
        }
    }
    best.1
}

/// Steps to be turned round, both ends of the order kept.
fn stretch(net: &Net, order: &[Step], dice: &impl Fn(u64) -> f64) -> Option<(usize, usize)> {
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "from 0 to below the count")]
    let below = |k: u64, count: usize| (dice(k) * count as f64) as usize;
    let n = order.len();
    let start = |k: usize| net.step(order[k])[0];
    let one = 1 + below(0, n.checked_sub(2)?.max(1));
    let fits = |k: usize| {
        let loose = |k: usize| net.step(order[k - 1])[1] != start(k);
        k != one && (start(k) == start(one) || loose(one) || loose(k))
    };
    let ends: Vec<usize> = (1..n).filter(|&k| fits(k)).collect();
    let other = *ends.get(below(1, ends.len()))?;
    Some((one.min(other), one.max(other)))
}
