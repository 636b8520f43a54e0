//! The lists by knot, and the tables of legs with what they pay to cuts.

use super::StopBound;
use super::cut::Partition;

impl StopBound {
    /// Makes room for the numbers of all knots.
    pub(super) fn lay_out(&mut self) {
        let mut knots = 0;
        self.base.clear();
        self.place.clear();
        for member in &self.members {
            self.base.push(knots);
            self.place.extend(member.places().into_iter().map(|v| knots + v));
            knots += member.item.knots;
        }
        for list in [&mut self.pay, &mut self.stay, &mut self.wanted, &mut self.offered] {
            list.clear();
            list.resize(knots, 0.0);
        }
    }

    /// Half the cheapest leg at each knot: potentials that are feasible without cuts.
    pub(super) fn half_legs(&self) -> Vec<f64> {
        let mut least = vec![f64::INFINITY; self.stay.len()];
        self.each_table(|[a, b], m, table| {
            for (i, row) in table.chunks_exact(m).enumerate() {
                for (j, s) in row.iter().enumerate() {
                    least[a + i] = least[a + i].min(0.5 * s);
                    least[b + j] = least[b + j].min(0.5 * s);
                }
            }
        });
        least.into_iter().map(|s| if s.is_finite() { s } else { 0.0 }).collect()
    }

    /// Calls a function with the first knots of each pair, the columns of its table, and the table.
    pub(super) fn each_table(&self, mut f: impl FnMut([usize; 2], usize, &[f64])) {
        for pair in &self.pairs.list {
            let [n, m] = pair.items.map(|k| self.members[k].item.knots);
            f(pair.items.map(|k| self.base[k]), m, self.pairs.table(pair, n * m));
        }
    }

    pub(super) fn numbers(&self) -> usize {
        self.pairs
            .list
            .iter()
            .map(|p| self.members[p.items[0]].item.knots * self.members[p.items[1]].item.knots)
            .sum()
    }

    /// What each leg of all pairs takes, less the prices of the cuts that it crosses, table by table. `takes`: what it takes by its seconds.
    /// Also returns the work done.
    pub(super) fn adjusted(&self, takes: impl Fn(f64) -> f64) -> (Vec<f64>, u64) {
        let mut cost = Vec::with_capacity(self.numbers());
        self.each_table(|_, _, table| cost.extend(table.iter().map(|&s| takes(s))));
        let starts = self.table_starts();
        let mut work = cost.len() as u64;
        for cut in self.cuts.iter().filter(|c| c.price > 0.0) {
            work += self.charge(&mut cost, &starts, cut, -cut.leg_price());
        }
        (cost, work)
    }

    /// Where the table of each pair starts in the list of all costs.
    pub(super) fn table_starts(&self) -> Vec<usize> {
        let mut starts = Vec::with_capacity(self.pairs.list.len());
        let mut at = 0;
        self.each_table(|_, _, table| {
            starts.push(at);
            at += table.len();
        });
        starts
    }

    /// Adds an amount to the cost of each leg that crosses a cut. Returns the work done.
    pub(super) fn charge(&self, cost: &mut [f64], starts: &[usize], cut: &Partition, amount: f64) -> u64 {
        let mut work = 0;
        for (k, parts) in &cut.held {
            for &(e, side) in &self.pairs.of[*k] {
                let other = self.pairs.list[e].items[1 - side];
                let there = cut.of(other);
                if there.is_some() && other < *k {
                    continue;
                }
                let m = self.members[self.pairs.list[e].items[1]].item.knots;
                let knots = self.members[other].item.knots;
                work += (parts.len() * knots) as u64;
                for (v, &part) in parts.iter().enumerate() {
                    for w in 0..knots {
                        if there.map_or(0, |t| t[w]) != part {
                            let (i, j) = if side == 0 { (v, w) } else { (w, v) };
                            cost[starts[e] + i * m + j] += amount;
                        }
                    }
                }
            }
        }
        work
    }
}
