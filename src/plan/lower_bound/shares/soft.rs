//! A step of the smooth problem: how often items want their legs, how often legs want to be used, and the shares that bring
//! both together.

use super::super::places::Held;
use super::super::powers::{exp, ln};
use super::cut::Leg;
use super::{Kind, ShareBound};

/// Legs that are too expensive by more temperatures than this do not matter: e^-40 is below the precision of a number.
const CUTOFF: f64 = 40.0;
/// Length of a step: a quarter never overshoots, because a choice of an item and a leg have two shares each.
const STEP: f64 = 0.25;
/// Length of a step of a cut's price, divided by the root of the number of cuts that its legs cross: they all move the same legs.
/// Divided by that number itself, no price overshoots, but 53gil262 takes twice as long.
const CUT_STEP: f64 = 0.25;
/// Most temperatures by which a share moves in a step, before [`STEP`].
const MOST: f64 = 4.0;
/// The least probability whose logarithm is taken.
const LEAST: f64 = 1e-200;
/// The least number of legs across a cut, or in it, whose logarithm is taken.
const FEW: f64 = 1e-3;

impl ShareBound {
    /// Selects the knots between which legs are cheap enough to matter at this temperature, and the cuts that they cross.
    pub(super) fn select(&mut self) {
        self.adjust();
        self.active.clear();
        self.starts.clear();
        for (e, pair) in self.pairs.list.iter().enumerate() {
            self.starts.push(self.active.len());
            let [n, m] = pair.items.map(|k| self.items[k].knots);
            let table = self.pairs.table(pair, n * m);
            let cost = &self.cost[self.cost_at[e]..self.cost_at[e] + n * m];
            let [a, b] = self.at[e];
            let most = CUTOFF * self.temperature;
            for (i, row) in cost.chunks_exact(m).enumerate() {
                let most = most + self.shares[a + i];
                for (j, (cost, share)) in row.iter().zip(&self.shares[b..b + m]).enumerate() {
                    if cost - share < most {
                        #[expect(clippy::cast_possible_truncation, reason = "knots of one contour")]
                        self.active.push(Leg { i: i as u32, j: j as u32, seconds: table[i * m + j] });
                    }
                }
            }
        }
        self.starts.push(self.active.len());
        self.uses.clear();
        self.uses.resize(self.active.len(), 0.0);
        for cut in &mut self.cuts {
            let (mut whole, mut crossing) =
                (std::mem::take(&mut cut.pairs), std::mem::take(&mut cut.crossing));
            whole.clear();
            crossing.clear();
            for &(k, _) in &cut.places.held {
                for &(e, side) in &self.pairs.of[k] {
                    let ends = self.pairs.list[e].items;
                    let other = ends[1 - side];
                    // A pair of which both items are held is looked at once.
                    let twice = other < k && cut.places.held.binary_search_by(|h| h.0.cmp(&other)).is_ok();
                    if twice || !cut.places.may_cross(ends) {
                        continue;
                    }
                    let [x, y] = ends.map(|k| cut.places.of(k));
                    if matches!((x, y), (Held::All, Held::None) | (Held::None, Held::All)) {
                        whole.push(u32::try_from(e).unwrap_or(u32::MAX));
                        continue;
                    }
                    for l in self.starts[e]..self.starts[e + 1] {
                        let leg = &self.active[l];
                        if x.holds(leg.i as usize) != y.holds(leg.j as usize) {
                            crossing.push(u32::try_from(l).unwrap_or(u32::MAX));
                        }
                    }
                }
            }
            (cut.pairs, cut.crossing) = (whole, crossing);
        }
    }

    /// Moves all shares and all prices of cuts once.
    pub(super) fn step(&mut self) {
        self.credit.clear();
        self.credit.resize(self.active.len(), 0.0);
        self.crossed.clear();
        self.crossed.resize(self.active.len(), 0.0);
        self.of_pairs.clear();
        self.of_pairs.resize(self.pairs.list.len(), (0.0, 0.0));
        for cut in &self.cuts {
            for &e in &cut.pairs {
                let (credit, crossed) = &mut self.of_pairs[e as usize];
                *credit += cut.price;
                *crossed += 1.0;
            }
            for &l in &cut.crossing {
                self.credit[l as usize] += cut.price;
                self.crossed[l as usize] += 1.0;
            }
        }
        self.price_stops();
        for k in 0..self.items.len() {
            match self.kinds[k] {
                Kind::End => self.want_one(k),
                Kind::Closed => self.want_from_a_knot(k),
                Kind::Paired => self.want_from_ends(k),
            }
        }
        for e in 0..self.pairs.list.len() {
            self.offer(e);
        }
        let by = STEP * self.temperature;
        for ((share, &wanted), &offered) in self.shares.iter_mut().zip(&self.wanted).zip(&self.offered) {
            if wanted > LEAST || offered > LEAST {
                *share += by * (ln(wanted.max(LEAST)) - ln(offered.max(LEAST))).clamp(-MOST, MOST);
            }
        }
        let by = CUT_STEP * self.temperature;
        for cut in &mut self.cuts {
            let (mut legs, mut crossed) = (0.0, 0.0);
            for e in cut.pairs.iter().map(|&e| e as usize) {
                legs += self.usage[e];
                crossed += self.usage[e] * self.of_pairs[e].1;
            }
            for l in cut.crossing.iter().map(|&l| l as usize) {
                legs += self.uses[l];
                crossed += self.uses[l] * self.crossed[l];
            }
            cut.legs = legs;
            if cut.places.visited.is_some() {
                cut.target =
                    2.0 * cut.places.visited_knots().map(|(k, v)| self.stay[self.base[k] + v]).sum::<f64>();
            }
            let fault = ln(cut.target.max(FEW)) - ln(cut.legs.max(FEW));
            let by = by * (legs.max(FEW) / crossed.max(FEW)).min(1.0).sqrt();
            cut.price = (cut.price + by * fault.clamp(-MOST, MOST)).max(0.0);
        }
    }

    /// What a stop at each knot pays for the cuts that it is in.
    pub(super) fn price_stops(&mut self) {
        self.pay.fill(0.0);
        for cut in self.cuts.iter().filter(|c| c.price > 0.0) {
            cut.places.visited_knots().for_each(|(k, v)| self.pay[self.base[k] + v] += 2.0 * cut.price);
        }
    }

    /// How often a pair's leg is used, and between which knots: its probability falls with what it costs beyond the shares.
    fn offer(&mut self, e: usize) {
        let [a, b] = self.at[e];
        let [n, m] = self.pairs.list[e].items.map(|k| self.items[k].knots);
        self.offered[a..a + n].fill(0.0);
        self.offered[b..b + m].fill(0.0);
        self.usage[e] = 0.0;
        let legs = self.starts[e]..self.starts[e + 1];
        let credit = self.of_pairs[e].0;
        let mut low: f64 = 0.0;
        for l in legs.clone() {
            let leg = &self.active[l];
            let left = leg.seconds
                - (credit + self.credit[l])
                - self.shares[a + leg.i as usize]
                - self.shares[b + leg.j as usize];
            self.uses[l] = left;
            low = low.min(left);
        }
        let colder = 1.0 / self.temperature;
        let mut total = 0.0;
        for l in legs.clone() {
            self.uses[l] = exp((low - self.uses[l]) * colder);
            total += self.uses[l];
        }
        let all = total + exp(low * colder);
        self.usage[e] = total / all;
        for l in legs {
            let uses = self.uses[l] / all;
            self.uses[l] = uses;
            self.offered[a + self.active[l].i as usize] += uses;
            self.offered[b + self.active[l].j as usize] += uses;
        }
    }

    /// The share of each leg of an item, as places in the list of shares: for each leg where those of its knots start.
    pub(super) fn legs_of(&self, k: usize) -> Vec<usize> {
        self.pairs.of[k].iter().map(|&(e, side)| self.at[e][side]).collect()
    }

    /// One leg, from any knot.
    fn want_one(&mut self, k: usize) {
        let (legs, n) = (self.legs_of(k), self.items[k].knots);
        let all = || legs.iter().flat_map(|&at| at..at + n);
        let low = all().map(|s| self.shares[s]).fold(f64::INFINITY, f64::min);
        let mut total = 0.0;
        for s in all() {
            self.wanted[s] = exp((low - self.shares[s]) / self.temperature);
            total += self.wanted[s];
        }
        all().for_each(|s| self.wanted[s] /= total);
    }

    /// Two legs to different items from one knot. The cheapest leg of each knot is kept apart, so that no small number is
    /// the difference of two large ones.
    fn want_from_a_knot(&mut self, k: usize) {
        let (legs, n, base) = (self.legs_of(k), self.items[k].knots, self.base[k]);
        let two = cheapest_two(&self.shares, &legs, n);
        let sum = |(v, t): (usize, &Two)| t[0].0 + t[1].0 + self.pay[base + v];
        let low = two.iter().enumerate().map(sum).fold(f64::INFINITY, f64::min);
        let colder = 1.0 / self.temperature;
        let mut total = 0.0;
        for (v, &[(s1, top), (s2, _)]) in two.iter().enumerate() {
            let weight = exp((low - s1 - s2 - self.pay[base + v]) * colder);
            if weight <= 0.0 {
                legs.iter().for_each(|at| self.wanted[at + v] = 0.0);
                self.stay[base + v] = 0.0;
                continue;
            }
            let (mut sum, mut squares) = (0.0, 0.0);
            for (l, &at) in (0..).zip(&legs) {
                if l != top {
                    let x = exp((s2 - self.shares[at + v]) * colder);
                    self.wanted[at + v] = x;
                    sum += x;
                    squares += x * x;
                }
            }
            // How likely it is that the cheapest leg is not one of the two.
            let without = exp((s1 - s2) * colder);
            let all = weight * (sum + without * 0.5 * (sum * sum - squares).max(0.0));
            self.stay[base + v] = all;
            total += all;
            for (l, &at) in (0..).zip(&legs) {
                let x = &mut self.wanted[at + v];
                *x = weight * if l == top { sum } else { *x * (1.0 + without * (sum - *x)) };
            }
        }
        let part = 1.0 / total;
        for at in legs {
            self.wanted[at..at + n].iter_mut().for_each(|x| *x *= part);
        }
        self.stay[base..base + n].iter_mut().for_each(|x| *x *= part);
    }

    /// Two legs to different items from the two ends of a pair of knots.
    fn want_from_ends(&mut self, k: usize) {
        let (legs, n, base) = (self.legs_of(k), self.items[k].knots, self.base[k]);
        let low: Vec<f64> = cheapest_two(&self.shares, &legs, n).iter().map(|t| t[0].0).collect();
        let sum = |v: usize| low[v] + low[v + 1] + self.pay[base + v];
        let least = (0..n).step_by(2).map(sum).fold(f64::INFINITY, f64::min);
        let mut total = 0.0;
        for v in (0..n).step_by(2) {
            let weight = exp((least - sum(v)) / self.temperature);
            let (mut sums, mut same) = ([0.0; 2], 0.0);
            for &at in &legs {
                let ends =
                    [v, v + 1].map(|v| exp((low[v] - self.shares[at + v]) / self.temperature).max(LEAST));
                [self.wanted[at + v], self.wanted[at + v + 1]] = ends;
                sums = [sums[0] + ends[0], sums[1] + ends[1]];
                same += ends[0] * ends[1];
            }
            let all = weight * (sums[0] * sums[1] - same).max(LEAST);
            [self.stay[base + v], self.stay[base + v + 1]] = [all, 0.0];
            total += all;
            for &at in &legs {
                let [x, y] = [self.wanted[at + v], self.wanted[at + v + 1]];
                self.wanted[at + v] = weight * x * (sums[1] - y).max(0.0);
                self.wanted[at + v + 1] = weight * y * (sums[0] - x).max(0.0);
            }
        }
        let part = 1.0 / total;
        for at in legs {
            self.wanted[at..at + n].iter_mut().for_each(|q| *q *= part);
        }
        self.stay[base..base + n].iter_mut().for_each(|x| *x *= part);
    }
}

/// The two smallest shares of a knot, and the legs they belong to.
pub(super) type Two = [(f64, u32); 2];

/// For each knot of an item the two smallest shares.
pub(super) fn cheapest_two(shares: &[f64], legs: &[usize], knots: usize) -> Vec<Two> {
    let mut two = vec![[(f64::INFINITY, u32::MAX); 2]; knots];
    for (l, &at) in (0..).zip(legs) {
        for (two, &share) in two.iter_mut().zip(&shares[at..at + knots]) {
            if share < two[1].0 {
                let leg = (share, l);
                *two = if share < two[0].0 { [leg, two[0]] } else { [two[0], leg] };
            }
        }
    }
    two
}
