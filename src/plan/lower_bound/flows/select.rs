//! The legs that matter at a temperature: all others are too expensive by far.

use super::FlowBound;
use super::legs::{Far, Leg, Legs, Slot};

/// Legs that are too expensive by more temperatures than this do not matter: e^-40 is below the precision of a number.
const CUTOFF: f64 = 40.0;

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
