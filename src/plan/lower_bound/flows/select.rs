//! The legs that matter at a temperature: all others are too expensive by far.

use super::FlowBound;

/// Legs that are too expensive by more temperatures than this do not matter: e^-40 is below the precision of a number.
const CUTOFF: f64 = 40.0;

/// Legs from one knot of an item, in whatever state, to knots of a state of another.
#[derive(Clone, Copy, Debug)]
pub(super) struct Slot {
    /// The step of the net.
    pub(super) step: u32,
    pub(super) knot: u32,
    /// Where its legs start, and the parts of the states left.
    pub(super) legs: u32,
    pub(super) parts: u32,
}

/// A leg to a knot of a state.
#[derive(Clone, Copy, Debug)]
pub(super) struct Leg {
    /// The place of the knot in a row of numbers.
    pub(super) to: u32,
    pub(super) seconds: f64,
}

/// All legs between two items without a table.
#[derive(Clone, Copy, Debug)]
pub(super) struct Far {
    pub(super) from: usize,
    pub(super) to: usize,
    pub(super) seconds: f64,
}

/// The legs that matter, and how much the smooth solution uses them.
#[derive(Clone, Debug, Default)]
pub(super) struct Legs {
    /// The last one only ends the lists of the one before.
    pub(super) slots: Vec<Slot>,
    pub(super) legs: Vec<Leg>,
    /// How much each leg is used, up to a factor for each item that it leads to.
    pub(super) uses: Vec<f64>,
    /// The part of each state left in what leaves a knot.
    pub(super) parts: Vec<f64>,
    pub(super) far: Vec<Far>,
}

impl Legs {
    /// Work of a step: exponentials take about as long as four numbers.
    pub(super) fn work(&self) -> u64 {
        6 * (1 + self.legs.len() + self.parts.len()) as u64
    }

    /// Each slot with its legs and its parts.
    pub(super) fn each(&self) -> impl Iterator<Item = (Slot, std::ops::Range<usize>)> + '_ {
        self.slots.windows(2).map(|w| (w[0], w[0].legs as usize..w[1].legs as usize))
    }
}

impl FlowBound {
    /// Selects the legs that matter at this temperature.
    pub(super) fn select(&mut self) {
        let count = self.ground.items.len();
        let most = CUTOFF * self.temperature;
        let Legs { mut slots, mut legs, mut parts, mut uses, mut far } = std::mem::take(&mut self.legs);
        slots.clear();
        legs.clear();
        let whole = |x: usize| u32::try_from(x).unwrap_or(u32::MAX);
        let mut of_parts = 0;
        let mut least: Vec<f64> = Vec::new();
        for (x, step) in self.net.steps.iter().enumerate() {
            let item = self.net.keys[step.to].0;
            let from = &self.ground.items[step.from];
            let (n, m) = (from.knots, self.ground.items[item].knots);
            let (table, rows_left) = self.ground.legs(step.pair);
            self.leaves(step, &mut least);
            let range = self.net.range(step.to);
            let (at, ends) = (range.start, &self.potentials[range]);
            let top = ends.iter().fold(f64::NEG_INFINITY, |m, &v| m.max(v));
            let limit = most + self.pays[item] + self.crossing[step.from * count + item];
            let floor = self.ground.pairs.list[step.pair.0].least;
            for (knot, &l) in least.iter().enumerate() {
                if l + floor - top >= limit {
                    continue;
                }
                let left = if from.paired { knot ^ 1 } else { knot };
                let start = legs.len();
                for (k, end) in ends.iter().enumerate() {
                    let seconds = if rows_left { table[left * m + k] } else { table[k * n + left] };
                    if l + seconds - end < limit {
                        legs.push(Leg { to: whole(at + k), seconds });
                    }
                }
                if legs.len() > start {
                    slots.push(Slot {
                        step: whole(x),
                        knot: whole(knot),
                        legs: whole(start),
                        parts: whole(of_parts),
                    });
                    of_parts += step.sources.len();
                }
            }
        }
        slots.push(Slot { step: 0, knot: 0, legs: whole(legs.len()), parts: whole(of_parts) });
        parts.clear();
        parts.resize(of_parts, 0.0);
        uses.clear();
        uses.resize(legs.len(), 0.0);
        far.clear();
        let (low, high) = self.extremes();
        for (to, list) in self.net.far.iter().enumerate() {
            for &(from, seconds) in list {
                let limit = most + self.pays[to] + self.crossing[from * count + to];
                if low[from] + seconds - high[to] < limit {
                    far.push(Far { from, to, seconds });
                }
            }
        }
        self.legs = Legs { slots, legs, uses, parts, far };
    }
}
