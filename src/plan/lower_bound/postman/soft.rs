//! A step of the smooth problem: how often items stop at their knots, how often legs are used, and the potentials and prices that bring
//! both together.

use super::super::powers::{exp, ln};
use super::cut::Leg;
use super::{StopBound, Stops};

/// Legs that are too expensive by more temperatures than this do not matter.
const CUTOFF: f64 = 30.0;
/// A leg or a further stop is used this often at most, as a logarithm: so that a bad start does not overflow.
const MOST_USED: f64 = 3.0;
/// Exponents are not above this: more overflows, and is as good as certain.
const FAR: f64 = 200.0;
/// Length of a step: a leg has two potentials, and a stop has two legs.
const STEP: f64 = 0.25;
/// Length of a step of a price, divided by the root of the number of cuts that its legs cross.
const CUT_STEP: f64 = 0.25;
/// Most temperatures by which a number moves in a step, before its length.
const MOST: f64 = 4.0;
/// The least number whose logarithm is taken.
const LEAST: f64 = 1e-200;
/// The least number of stops in parts whose logarithm is taken.
const FEW: f64 = 1e-3;

impl StopBound {
    /// Selects the legs that are cheap enough to matter at this temperature, and which cuts they cross.
    /// Returns the work done.
    pub(super) fn select(&mut self) -> u64 {
        let (cost, work) = self.adjusted(|s| s);
        self.active.clear();
        self.starts.clear();
        let most = CUTOFF * self.temperature;
        let mut at = 0;
        for pair in &self.pairs.list {
            self.starts.push(self.active.len());
            let [n, m] = pair.items.map(|k| self.members[k].item.knots);
            let [a, b] = pair.items.map(|k| self.base[k]);
            let table = self.pairs.table(pair, n * m);
            for i in 0..n {
                for j in 0..m {
                    if cost[at] - self.potential[a + i] - self.potential[b + j] < most {
                        #[expect(clippy::cast_possible_truncation, reason = "knots of all items")]
                        self.active
                            .push(Leg { ends: [(a + i) as u32, (b + j) as u32], seconds: table[i * m + j] });
                    }
                    at += 1;
                }
            }
        }
        self.starts.push(self.active.len());
        let mut part = vec![0_u32; self.potential.len()];
        for cut in &mut self.cuts {
            for (k, parts) in &cut.held {
                part[self.base[*k]..self.base[*k] + parts.len()].copy_from_slice(parts);
            }
            cut.crossing.clear();
            let mut look = |e: usize| {
                for l in self.starts[e]..self.starts[e + 1] {
                    let [i, j] = self.active[l].ends.map(|v| part[v as usize]);
                    if i != j {
                        cut.crossing.push(u32::try_from(l).unwrap_or(u32::MAX));
                    }
                }
            };
            for (k, _) in &cut.held {
                for &(e, side) in &self.pairs.of[*k] {
                    let other = self.pairs.list[e].items[1 - side];
                    // A pair of which both items are listed is looked at once.
                    if other >= *k || cut.held.binary_search_by(|h| h.0.cmp(&other)).is_err() {
                        look(e);
                    }
                }
            }
            for (k, parts) in &cut.held {
                part[self.base[*k]..self.base[*k] + parts.len()].fill(0);
            }
        }
        work
    }

    /// Moves all potentials and all prices once.
    pub(super) fn step(&mut self) {
        self.credit.clear();
        self.credit.resize(self.active.len(), 0.0);
        self.crossed.clear();
        self.crossed.resize(self.active.len(), 0.0);
        for cut in &self.cuts {
            let price = cut.price * cut.of_leg();
            for &l in &cut.crossing {
                self.credit[l as usize] += price;
                self.crossed[l as usize] += 1.0;
            }
        }
        self.price_stops();
        self.smooth = self.cuts.iter().map(|c| c.price * c.whole()).sum();
        self.want();
        self.offer();
        let by = STEP * self.temperature;
        for ((u, &wanted), &offered) in self.potential.iter_mut().zip(&self.wanted).zip(&self.offered) {
            *u += by * (ln(wanted.max(LEAST)) - ln(offered.max(LEAST))).clamp(-MOST, MOST);
        }
        let by = CUT_STEP * self.temperature;
        for cut in &mut self.cuts {
            let (mut legs, mut crossed) = (0.0, 0.0);
            for &l in &cut.crossing {
                legs += self.uses[l as usize];
                crossed += self.uses[l as usize] * self.crossed[l as usize];
            }
            cut.there = cut.of_leg() * legs + cut.divided().map(|k| self.again[k]).sum::<f64>();
            cut.asked = cut.whole() + cut.counted().map(|(k, v)| self.stay[self.base[k] + v]).sum::<f64>();
            let fault = ln(cut.asked.max(FEW)) - ln(cut.there.max(FEW));
            let by = by * (legs.max(FEW) / crossed.max(FEW)).min(1.0).sqrt();
            cut.price = (cut.price + by * fault.clamp(-MOST, MOST)).max(0.0);
        }
    }

    /// What a stop at each knot pays to cuts, and what each further stop of an item gets back.
    pub(super) fn price_stops(&mut self) {
        self.pay.fill(0.0);
        self.refund.fill(0.0);
        for cut in self.cuts.iter().filter(|c| c.price > 0.0) {
            cut.counted().for_each(|(k, v)| self.pay[self.base[k] + v] += cut.price);
            cut.divided().for_each(|k| self.refund[k] += cut.price);
        }
    }

    /// How often each item stops at each of its knots.
    fn want(&mut self) {
        self.wanted.fill(0.0);
        self.stay.fill(0.0);
        self.again.fill(0.0);
        let colder = 1.0 / self.temperature;
        let often = |x: f64| exp((-x * colder).min(MOST_USED));
        for (k, member) in self.members.iter().enumerate() {
            let (base, n) = (self.base[k], member.item.knots);
            let potential = &self.potential[base..base + n];
            let pay = &self.pay[base..base + n];
            let (wanted, stay) = (&mut self.wanted[base..base + n], &mut self.stay[base..base + n]);
            match &member.stops {
                Stops::End => {
                    self.smooth += potential[0];
                    (wanted[0], stay[0]) = (1.0, 1.0);
                }
                Stops::Anywhere(again) => {
                    let worth = |v: usize| 2.0 * potential[v] + pay[v];
                    let low = (0..n).map(worth).fold(f64::INFINITY, f64::min);
                    let total: f64 = (0..n).map(|v| exp((low - worth(v)) * colder)).sum();
                    self.smooth += low - self.temperature * ln(total);
                    for v in 0..n {
                        let mut stops = exp((low - worth(v)) * colder) / total;
                        if let Some(again) = again {
                            let more = often(again + worth(v) - self.refund[k]);
                            self.again[k] += more;
                            self.smooth -= self.temperature * more;
                            stops += more;
                        }
                        (wanted[v], stay[v]) = (2.0 * stops, stops);
                    }
                }
                Stops::Pairs => {
                    let worth = |v: usize| potential[v] + potential[v + 1] + pay[v];
                    let low = (0..n).step_by(2).map(worth).fold(f64::INFINITY, f64::min);
                    let total: f64 = (0..n).step_by(2).map(|v| exp((low - worth(v)) * colder)).sum();
                    self.smooth += low - self.temperature * ln(total);
                    for v in (0..n).step_by(2) {
                        let stops = exp((low - worth(v)) * colder) / total;
                        (wanted[v], wanted[v + 1], stay[v]) = (stops, stops, stops);
                    }
                }
                Stops::Paths(choices) => {
                    let worth = |s: &super::Stop| {
                        s.seconds + potential[s.ends[0]] + potential[s.ends[1]] + pay[s.ends[0]]
                    };
                    let refund = self.refund[k];
                    // Each leave point is used or not.
                    let soft = |c: &super::stops::Choice| {
                        let more =
                            c.more.iter().map(|s| ln(1.0 + exp(((refund - worth(s)) * colder).min(FAR))));
                        worth(&c.stop) - self.temperature * more.sum::<f64>()
                    };
                    let all: Vec<f64> = choices.iter().map(soft).collect();
                    let low = all.iter().fold(f64::INFINITY, |m, &w| m.min(w));
                    let total: f64 = all.iter().map(|w| exp((low - w) * colder)).sum();
                    self.smooth += low - self.temperature * ln(total);
                    for (choice, w) in choices.iter().zip(&all) {
                        let chosen = exp((low - w) * colder) / total;
                        let mut add = |s: &super::Stop, stops: f64| {
                            wanted[s.ends[0]] += stops;
                            wanted[s.ends[1]] += stops;
                            stay[s.ends[0]] += stops;
                        };
                        add(&choice.stop, chosen);
                        for s in &choice.more {
                            let used = chosen / (1.0 + exp(((worth(s) - refund) * colder).min(FAR)));
                            self.again[k] += used;
                            add(s, used);
                        }
                    }
                }
            }
        }
    }

    /// How often each active leg is used.
    fn offer(&mut self) {
        self.offered.fill(0.0);
        self.uses.clear();
        let colder = 1.0 / self.temperature;
        for (leg, credit) in self.active.iter().zip(&self.credit) {
            let [i, j] = leg.ends.map(|v| v as usize);
            let left = leg.seconds - credit - self.potential[i] - self.potential[j];
            let uses = exp((-left * colder).min(MOST_USED));
            self.offered[i] += uses;
            self.offered[j] += uses;
            self.uses.push(uses);
        }
        self.smooth -= self.temperature * self.uses.iter().sum::<f64>();
    }
}
