//! From the last level to the first: what the sets that are left take to the end, the knots in use, and the best orders.

use super::super::walks::{Ground, Visit};
use super::{Key, Left, Orders};

impl Orders {
    /// A piece of the look at all levels from the last to the first.
    pub(super) fn look_back(&mut self, ground: &Ground) -> (u64, Option<Left>) {
        if let Some((key, at)) = self.queue.pop() {
            return (self.complete(ground, key, at), None);
        }
        if self.back == ground.count() {
            self.end(ground);
        } else {
            // The levels before it do not look at it any more.
            self.levels[self.back].rest = Vec::new();
        }
        self.back -= 1;
        if let Some(level) = self.back.checked_sub(1).map(|l| &self.levels[l]) {
            self.queue = level.sets();
            return (1 + self.queue.len() as u64, None);
        }
        self.levels.clear();
        self.numbers = 0;
        self.start += 1;
        if self.start < ground.items[0].knots {
            return (1, None);
        }
        let better = std::mem::take(&mut self.better);
        let left = if better.walks.is_empty() { Left::Nothing } else { Left::Orders(better) };
        (1, Some(left))
    }

    /// The least seconds from a set to the end, and which knots of its last item are in use. Returns the work done.
    fn complete(&mut self, ground: &Ground, (visited, item): Key, at: usize) -> u64 {
        let from = &ground.items[item];
        let mut work = 1;
        let mut rest = vec![f64::INFINITY; from.knots];
        if self.back == ground.count() {
            let home = if ground.first == 1 { (0, self.start) } else { (1, 0) };
            for (left, rest) in rest.iter_mut().enumerate() {
                *rest = self.seconds(ground, (item, left), home) + self.charges.of_leg(item, home.0);
            }
        } else {
            let after = &self.levels[self.back];
            for next in ground.first..ground.items.len() {
                let bit = 1 << (next - ground.first);
                if visited & bit != 0 {
                    continue;
                }
                let Some(&at) = after.at.get(&(visited | bit, next)) else { continue };
                let knots = ground.items[next].knots;
                for (left, rest) in rest.iter_mut().enumerate() {
                    for (knot, r) in after.rest[at..at + knots].iter().enumerate() {
                        let value = self.seconds(ground, (item, left), (next, knot))
                            + self.charges.of_leg(item, next)
                            + r;
                        *rest = if value < *rest { value } else { *rest };
                    }
                }
                work += (from.knots * knots) as u64;
            }
        }
        if from.paired {
            rest.chunks_exact_mut(2).for_each(|ends| ends.swap(0, 1));
        }
        let level = &mut self.levels[self.back - 1];
        level.rest.resize(level.values.len(), f64::INFINITY);
        for (knot, rest) in rest.into_iter().enumerate() {
            self.better.in_use[item][knot] |= level.values[at + knot] + rest <= self.limit;
            level.rest[at + knot] = rest;
        }
        work
    }

    /// The best path for each last item.
    fn end(&mut self, ground: &Ground) {
        let Some(last) = self.levels.last() else { return };
        for ((visited, item), at) in last.sets() {
            let closed = |knot: usize| last.values[at + knot] + last.rest[at + knot];
            let knots = 0..ground.items[item].knots;
            let best = knots.map(|k| (closed(k), k)).min_by(|a, b| a.0.total_cmp(&b.0));
            if let Some((seconds, knot)) = best
                && seconds <= self.limit
            {
                self.better.seconds = self.better.seconds.min(seconds - self.charges.back());
                self.better.walks.push(self.trace(ground, (visited, item), knot));
            }
        }
    }

    /// The best order of a set that ends at a knot of its last item.
    fn trace(&self, ground: &Ground, (mut visited, mut item): Key, mut knot: usize) -> Vec<Visit> {
        let mut walk = vec![Visit { item, knot }];
        for level in self.levels.iter().rev().skip(1) {
            visited &= !(1 << (item - ground.first));
            let mut best = (f64::INFINITY, 0, 0);
            for past in ground.first..ground.items.len() {
                let Some(&at) = level.at.get(&(visited, past)) else { continue };
                let from = &ground.items[past];
                for k in 0..from.knots {
                    let left = if from.paired { k ^ 1 } else { k };
                    let value = level.values[at + k] + self.seconds(ground, (past, left), (item, knot));
                    if value < best.0 {
                        best = (value, past, k);
                    }
                }
            }
            (_, item, knot) = best;
            walk.push(Visit { item, knot });
        }
        walk.reverse();
        walk
    }
}
