//! Feasible numbers near those of the smooth problem, and their value.

use super::super::certificate::unit;
use super::super::net::Item;
use super::super::pairs::box_seconds;
use super::cut::{in_several, whole};
use super::{StopBound, Stops};

/// Rounds of lowering prices until no leg is paid more than it takes. In the last one there are no prices left.
const ROUNDS: usize = 24;
/// What prices are multiplied by where potentials alone cannot be lowered, in the first half of the rounds.
const LOWER: f64 = 0.9;
/// Rounds of adding pairs that are not listed but would be used.
const TRIES: usize = 3;

/// A leg that is still paid more than it takes.
struct BadLeg {
    items: [usize; 2],
    knots: [usize; 2],
}

impl StopBound {
    /// Writes down what the numbers prove after they are repaired, if it is more than before, and adds pairs that would be used.
    /// Returns the work done.
    pub(super) fn look(&mut self) -> u64 {
        let kept = (self.potential.clone(), self.cuts.iter().map(|c| c.price).collect::<Vec<_>>());
        let mut work = 0;
        for _ in 0..TRIES {
            work += self.repair();
            let value = self.worth();
            let missing = self.missing();
            if missing.is_empty() {
                if value > self.best * (1.0 + super::WORTH_PROVING) {
                    work += self.prove();
                }
                break;
            }
            let items: Vec<Item> = self.members.iter().map(|m| m.item.clone()).collect();
            for ends in missing {
                self.pairs.add(&items, &self.prices, ends, true);
            }
        }
        self.potential = kept.0;
        self.cuts.iter_mut().zip(kept.1).for_each(|(c, price)| c.price = price);
        work
    }

    /// Lowers potentials, and prices where that is not enough, until no leg is paid more than it takes and no further stop
    /// is worth less than nothing. Everything is a whole number of units from then on, so that sums are exact. Returns the work done.
    fn repair(&mut self) -> u64 {
        let items: Vec<Item> = self.members.iter().map(|m| m.item.clone()).collect();
        let (power, guard) = unit(&items, &self.prices, &self.problem);
        let takes = |seconds: f64| whole(seconds - guard, power).max(0.0);
        let wished: Vec<f64> = self.potential.iter().map(|&u| whole(u, power)).collect();
        self.cuts.iter_mut().for_each(|c| c.round(power));
        let starts = self.table_starts();
        let (mut cost, mut work) = self.adjusted(takes);
        for round in 0..=ROUNDS {
            self.price_stops();
            let floor = self.floors(power);
            self.potential.clone_from(&wished);
            self.potential.iter_mut().zip(&floor).for_each(|(u, f)| *u = u.max(*f));
            let spared = self.spared();
            work += cost.len() as u64;
            let (mut at, mut bad) = (0, Vec::new());
            for pair in &self.pairs.list {
                let [n, m] = pair.items.map(|k| self.members[k].item.knots);
                let [a, b] = pair.items.map(|k| self.base[k]);
                for i in a..a + n {
                    for j in b..b + m {
                        let over = self.potential[i] + self.potential[j] - cost[at];
                        at += 1;
                        if over <= 0.0 {
                            continue;
                        }
                        // Home pays first, because all items have legs to home; then knots where no stop is made, as far as that costs nothing.
                        let free = [i, j]
                            .map(|v| whole((self.potential[v] - floor[v].max(spared[v])).max(0.0), power));
                        let of_i = if pair.items[0] < self.first { over } else { over.min(free[0]) };
                        let of_j = (over - of_i).min(free[1]);
                        let rest = over - of_i - of_j;
                        let left = [(i, of_i), (j, of_j)]
                            .map(|(v, by)| (self.potential[v] - by - floor[v]).max(0.0));
                        let more = whole(0.5 * rest, power).max(rest - left[1]).min(left[0]);
                        let (of_i, of_j) = (of_i + more, of_j + (rest - more).min(left[1]));
                        self.potential[i] -= of_i;
                        self.potential[j] -= of_j;
                        if over - of_i - of_j > 0.0 {
                            bad.push(BadLeg { items: pair.items, knots: [i - a, j - b] });
                        }
                    }
                }
            }
            if bad.is_empty() {
                break;
            }
            let lower = if round < ROUNDS / 2 { LOWER } else { LOWER * LOWER * LOWER };
            let mut bad_of: Vec<Vec<&BadLeg>> = vec![Vec::new(); self.members.len()];
            bad.iter().for_each(|leg| leg.items.iter().for_each(|&k| bad_of[k].push(leg)));
            let mut cuts = std::mem::take(&mut self.cuts);
            for cut in cuts.iter_mut().filter(|c| c.price > 0.0) {
                let crosses = |leg: &BadLeg| {
                    let [p, q] =
                        [0, 1].map(|end| cut.of(leg.items[end]).map_or(0, |parts| parts[leg.knots[end]]));
                    p != q
                };
                let hurts = cut.held.iter().any(|(k, parts)| {
                    let bad = &bad_of[*k];
                    !bad.is_empty() && (in_several(parts) || bad.iter().any(|leg| crosses(leg)))
                });
                if hurts {
                    let before = cut.leg_price();
                    cut.price *= if round + 1 >= ROUNDS { 0.0 } else { lower };
                    cut.round(power);
                    work += self.charge(&mut cost, &starts, cut, before - cut.leg_price());
                }
            }
            self.cuts = cuts;
        }
        work
    }

    /// The least potential of each knot with which a further stop there is worth no less than nothing.
    fn floors(&self, power: i32) -> Vec<f64> {
        let mut floor = vec![f64::NEG_INFINITY; self.potential.len()];
        for (k, member) in self.members.iter().enumerate() {
            if let Stops::Anywhere(Some(again)) = member.stops {
                let knots = self.base[k]..self.base[k] + member.item.knots;
                for (floor, pay) in floor[knots.clone()].iter_mut().zip(&self.pay[knots]) {
                    *floor = -whole(0.5 * (whole(again, power) + pay - self.refund[k]), power);
                }
            }
        }
        floor
    }

    /// For each knot the potential down to which a stop there is no cheaper than the item's cheapest one.
    fn spared(&self) -> Vec<f64> {
        let mut spared = vec![f64::INFINITY; self.potential.len()];
        for (k, member) in self.members.iter().enumerate() {
            let knots = self.base[k]..self.base[k] + member.item.knots;
            let least = self.cheapest(k);
            let (u, pay) = (&self.potential[knots.clone()], &self.pay[knots.clone()]);
            for (v, spared) in spared[knots].iter_mut().enumerate() {
                match member.stops {
                    Stops::Anywhere(_) => *spared = 0.5 * (least - pay[v]),
                    Stops::Pairs => {
                        let first = v - v % 2;
                        *spared = u[v] - 0.5 * (u[first] + u[first + 1] + pay[first] - least);
                    }
                    Stops::End | Stops::Paths(_) => {}
                }
            }
        }
        spared
    }

    /// The value of the numbers, if they are feasible.
    fn worth(&self) -> f64 {
        let cuts: f64 = self.cuts.iter().map(|c| c.price * c.whole()).sum();
        cuts + (0..self.members.len()).map(|k| self.cheapest(k)).sum::<f64>()
    }

    /// The least that an item pays for its stops.
    fn cheapest(&self, k: usize) -> f64 {
        let knots = self.base[k]..self.base[k] + self.members[k].item.knots;
        let (u, pay) = (&self.potential[knots.clone()], &self.pay[knots]);
        let least = |values: &mut dyn Iterator<Item = f64>| values.fold(f64::INFINITY, f64::min);
        match &self.members[k].stops {
            Stops::End => u[0],
            Stops::Anywhere(_) => least(&mut u.iter().zip(pay).map(|(u, pay)| 2.0 * u + pay)),
            Stops::Pairs => least(&mut (0..u.len()).step_by(2).map(|v| u[v] + u[v + 1] + pay[v])),
            Stops::Paths(choices) => {
                let worth = |s: &super::Stop| s.seconds + u[s.ends[0]] + u[s.ends[1]] + pay[s.ends[0]];
                let more = |s: &super::Stop| (worth(s) - self.refund[k]).min(0.0);
                least(&mut choices.iter().map(|c| worth(&c.stop) + c.more.iter().map(more).sum::<f64>()))
            }
        }
    }

    /// Pairs that are not listed and might take less than is paid for them.
    fn missing(&self) -> Vec<[usize; 2]> {
        let count = self.members.len();
        let most: Vec<f64> = (0..count)
            .map(|k| {
                let knots = self.base[k]..self.base[k] + self.members[k].item.knots;
                self.potential[knots].iter().fold(f64::NEG_INFINITY, |m, &u| m.max(u))
            })
            .collect();
        // A leg crosses no cut that holds neither of its items.
        let mut credit = vec![0.0; count];
        for cut in &self.cuts {
            cut.held.iter().for_each(|(k, _)| credit[*k] += cut.leg_price());
        }
        let (mut missing, mut known) = (Vec::new(), vec![usize::MAX; count]);
        for a in self.first..count {
            for &(e, side) in &self.pairs.of[a] {
                known[self.pairs.list[e].items[1 - side]] = a;
            }
            let p = self.members[a].item.around;
            for b in (a + 1..count).filter(|&b| known[b] != a) {
                let q = self.members[b].item.around;
                // The room for rounding is small beside the factor.
                let seconds = box_seconds(&self.prices, p.min, p.max, q.min, q.max) * (1.0 - 1e-9) - 1e-9;
                if seconds >= most[a] + most[b] + credit[a] + credit[b] {
                    continue;
                }
                let crossed = self.cuts.iter().filter(|c| c.price > 0.0 && c.may_cross([a, b]));
                if seconds < most[a] + most[b] + crossed.map(|c| c.leg_price()).sum::<f64>() {
                    missing.push([a, b]);
                }
            }
        }
        missing
    }
}
