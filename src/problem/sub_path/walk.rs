//! Orders of larger groups: walks backwards, then exchanges.
//!
//! Backwards, an element may be put back where an area beside it hangs on the sheet already, so a walk that only takes such
//! elements is possible by construction, and one is always left. Places where an odd number of elements meets are paired,
//! as a run has to begin or end there anyway, and the walk jumps between them: then all is one walk, as long as it never
//! cuts off what is left (Fleury). It jumps when an even number is left: a run that begins there then begins where the
//! head has been, and needs a pre-cut instead of a piercing.
//! Of several walks, each with other preferences, the best is annealed.

use super::net::{Net, Order, Step};

/// Walks tried for a pair of ends, and elements in all of them at most: a walk looks at all elements at each of them, a
/// quarter of a millisecond for 220.
const WALKS: u64 = 24;
const WALKED: usize = 1_000;
/// Elements in all orders that are looked at to anneal one, and how many orders that may be: a few milliseconds.
const WORK: u64 = 200_000;
const LEAST_TURNS: u64 = 300;
const MOST_TURNS: u64 = 6000;
/// Seconds that a change may cost at first, in pre-cuts.
const WARMTH: f64 = 1.0;
/// A jump to where an even number of elements is left makes two places odd: as dear as so many pre-cuts.
const EVEN: f64 = 4.0;
/// Of the jumps from where it could go on, this part is not made: other walks.
const ON: f64 = 0.15;

/// An order from node to node; `None` if none was found.
pub(super) fn order(net: &Net, from: u32, to: u32) -> Option<Order> {
    let walks = WALKS.min((WALKED / net.len().max(1)) as u64).max(2);
    let hops = hops(net, from, to);
    let found = (0..walks).filter_map(|seed| walk(net, from, to, &hops, seed));
    found.map(|o| (net.cost(&o), o)).reduce(|a, b| if b.0 < a.0 { b } else { a }).map(|b| b.1)
}

/// An order from some node to some other one: the first walk, wherever it ends.
pub(super) fn any(net: &Net) -> Option<Order> {
    let to = net.nodes().next()?;
    walk(net, u32::MAX, to, &vec![None; net.nodes().count()], 1)
}

/// Evenly spread numbers, from 0 to 1: which of several ways is preferred.
fn whim(seed: u64, k: u64) -> f64 {
    // splitmix64.
    let mut z = (seed << 48 ^ k).wrapping_mul(0x9E37_79B9_7F4A_7C15);
    z = (z ^ z >> 30).wrapping_mul(0xBF58_476D_1CE4_E5B9);
    z = (z ^ z >> 27).wrapping_mul(0x94D0_49BB_1331_11EB);
    ((z ^ z >> 31) >> 11) as f64 / (1_u64 << 53) as f64
}

struct Walk<'n> {
    net: &'n Net<'n>,
    /// Steps that end at each node.
    arriving: Vec<Vec<Step>>,
    /// The node that each is to be jumped to from, at most once.
    hop: Vec<Option<u32>>,
    used: Vec<bool>,
    held: Vec<bool>,
    /// Elements left at each node, and in all.
    left: Vec<u32>,
    rest: usize,
}

impl<'n> Walk<'n> {
    fn new(net: &'n Net<'n>, hop: Vec<Option<u32>>) -> Self {
        let mut arriving = vec![Vec::new(); net.nodes().count()];
        let mut left = vec![0; arriving.len()];
        for step in net.steps() {
            let node = net.step(step)[1] as usize;
            arriving[node].push(step);
            left[node] += 1;
        }
        Self { net, arriving, hop, used: vec![false; net.len()], held: net.held(), left, rest: net.len() }
    }

    /// Steps that may be put back from a node now; the last one at `from` only at the end.
    fn open(&self, node: u32, from: u32) -> impl Iterator<Item = Step> {
        self.arriving[node as usize].iter().copied().filter(move |&s| {
            let kept =
                self.left.get(from as usize) == Some(&1) && self.net.step(s).contains(&from) && self.rest > 1;
            !kept && !self.used[s as usize / 2] && self.net.faces(s).iter().any(|&f| self.held[f as usize])
        })
    }

    fn take(&mut self, step: Step) -> u32 {
        self.used[step as usize / 2] = true;
        self.rest -= 1;
        self.net.put_back(&mut self.held, step);
        let [from, to] = self.net.step(step);
        self.left[from as usize] -= 1;
        self.left[to as usize] -= 1;
        from
    }

    /// Jumps from a node; where to.
    fn jump(&mut self, node: u32) -> Option<u32> {
        let to = self.hop[node as usize].take()?;
        self.hop[to as usize] = None;
        Some(to)
    }

    /// Whether all that is left hangs together with a node when an element is put back, or (`None`) a jump made.
    fn stays_whole(&self, here: u32, step: Option<Step>) -> bool {
        let start = match step {
            Some(s) => self.net.step(s)[0],
            None => match self.hop[here as usize] {
                Some(to) => to,
                None => return false,
            },
        };
        let gone = step.map(|s| s as usize / 2);
        let mut seen = vec![false; self.left.len()];
        seen[start as usize] = true;
        let (mut queue, mut ends) = (vec![start], 0);
        while let Some(n) = queue.pop() {
            let mut reach = |to: u32| {
                if !std::mem::replace(&mut seen[to as usize], true) {
                    queue.push(to);
                }
            };
            for &s in &self.arriving[n as usize] {
                if !self.used[s as usize / 2] && gone != Some(s as usize / 2) {
                    ends += 1;
                    reach(self.net.step(s)[0]);
                }
            }
            if let Some(to) = self.hop[n as usize].filter(|&to| gone.is_some() || (n != here && to != here)) {
                reach(to);
            }
        }
        ends == 2 * (self.rest - gone.iter().count())
    }
}

/// A walk from the last node back to the first; without a first one, to anywhere.
fn walk(net: &Net, from: u32, to: u32, hops: &[Option<u32>], seed: u64) -> Option<Order> {
    let mut w = Walk::new(net, hops.to_vec());
    let mut order = Order::with_capacity(net.len());
    let mut here = to;
    for k in 0..net.len() as u64 {
        let left = w.left[here as usize];
        // A run that begins where elements are left begins where the head has been.
        let leaves = k > 0 && left > 0 && left.is_multiple_of(2) && whim(seed, k << 16 | 0xFFFF) > ON;
        if (leaves || w.open(here, from).next().is_none()) && w.stays_whole(here, None) {
            here = w.jump(here)?;
        }
        if w.open(here, from).next().is_none() {
            let odd = |n: u32| w.left[n as usize] % 2 == 1;
            let price =
                |n: u32| net.way(here, n) + if odd(n) { 0.0 } else { EVEN * (net.pre_cut() + net.start()) };
            let nodes = net.nodes().filter(|&n| n != here && w.open(n, from).next().is_some());
            here = nodes.map(|n| (price(n), n)).reduce(|a, b| if b.0 < a.0 { b } else { a })?.1;
        }
        let price = |s: Step| {
            whim(seed, k << 16 | u64::from(s)) + if w.stays_whole(here, Some(s)) { 0.0 } else { 2.0 }
        };
        let step = w.open(here, from).map(|s| (price(s), s)).reduce(|a, b| if b.0 < a.0 { b } else { a })?.1;
        here = w.take(step);
        order.push(step);
    }
    order.reverse();
    (from == u32::MAX || net.ends(&order) == [from, to]).then_some(order)
}

/// Which nodes are jumped between: all at which an odd number of elements meets but the ends, in pairs, as near to each
/// other as exchanges of partners make them.
fn hops(net: &Net, from: u32, to: u32) -> Vec<Option<u32>> {
    let mut odd: Vec<u32> =
        net.nodes().filter(|&n| net.is_odd(n) && ((n != from && n != to) || from == to)).collect();
    // Neighbours first.
    for k in (1..odd.len()).step_by(2) {
        let way = |j: usize| net.way(odd[k - 1], odd[j]);
        let nearest = (k..odd.len()).fold(k, |best, j| if way(j) < way(best) { j } else { best });
        odd.swap(k, nearest);
    }
    let mut better = true;
    while better {
        better = false;
        for i in (1..odd.len()).step_by(2) {
            for j in (i + 2..odd.len()).step_by(2) {
                for other in [j - 1, j] {
                    let way = |a: usize, b: usize| net.way(odd[a], odd[b]);
                    let rest = if other == j { j - 1 } else { j };
                    if way(i - 1, other) + way(i, rest) < way(i - 1, i) + way(j - 1, j) - 1e-9 {
                        odd.swap(i, other);
                        better = true;
                    }
                }
            }
        }
    }
    let mut hops = vec![None; net.nodes().count()];
    for pair in odd.chunks_exact(2) {
        hops[pair[0] as usize] = Some(pair[1]);
        hops[pair[1] as usize] = Some(pair[0]);
    }
    hops
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
