//! Multipliers, the value they prove, and steps towards better ones.

use super::net::Item;
use super::pairs::Pairs;
use super::tree;
use crate::geometry::math::exp;

/// Multipliers and the state of their improvement.
#[derive(Clone, Debug, Default)]
pub(super) struct Ascent {
    /// What each item pays for a leg that ends at it, s.
    pub(super) pay: Vec<f64>,
    /// What is paid besides at a knot for a leg to one other item, s; see [`super::pairs::Pair::at`].
    pub(super) extra: Vec<f64>,
    pay_way: Vec<f64>,
    extra_way: Vec<f64>,
    /// Cost of each pair at these multipliers.
    pub(super) cost: Vec<f64>,
    pub(super) knobs: [f64; 8],
}

/// What one look at the multipliers found.
pub(super) struct Look {
    pub(super) value: f64,
    /// What items get back in all, and what home's legs cost.
    pub(super) back: f64,
    pub(super) home: f64,
    pub(super) size: f64,
    pub(super) legs: Vec<usize>,
}

impl Ascent {
    pub(super) fn new(items: usize) -> Self {
        Self { pay: vec![0.0; items], pay_way: vec![0.0; items], ..Self::default() }
    }

    pub(super) fn grow(&mut self, pairs: &Pairs) {
        self.extra.resize(pairs.multipliers, 0.0);
        self.extra_way.resize(pairs.multipliers, 0.0);
        self.cost.resize(pairs.list.len(), 0.0);
    }

    /// Prices all pairs, finds the least tree and legs, and moves towards `target`.
    pub(super) fn step(&mut self, items: &[Item], first: usize, pairs: &Pairs, flat: bool, target: f64, go: bool) -> Look {
        let [keep, share, soft_leg, soft_star, scale, ..] = self.knobs;
        for e in 0..pairs.list.len() {
            self.cost[e] = self.price(items, pairs, e, flat);
        }
        let mut legs = tree::over_pairs(pairs, first, &self.cost);
        let tree: f64 = legs.iter().map(|&e| self.cost[e]).sum();
        let mut size: f64 = legs.iter().map(|&e| self.cost[e].abs()).sum();
        let home_legs = home_legs(pairs, first, &self.cost);
        let home: f64 = home_legs.iter().map(|&e| self.cost[e]).sum();
        legs.extend(home_legs);

        self.pay_way.iter_mut().for_each(|w| *w *= keep);
        let mut way_pay = vec![0.0; items.len()];
        let mut way = vec![0.0; self.extra.len()];
        let mut back = 0.0;
        for (i, item) in items.iter().enumerate().skip(first) {
            let star = if flat { 0.0 } else { self.star(item, i, items.len(), pairs, soft_star, &mut way) };
            back += 2.0 * self.pay[i] + star;
            size += (2.0 * self.pay[i]).abs() + star.abs();
            way_pay[i] = -2.0;
        }
        for &e in &legs {
            for i in pairs.list[e].items {
                if i >= first {
                    way_pay[i] += 1.0;
                }
            }
            if !flat {
                self.leg(items, first, pairs, e, soft_leg, &mut way);
            }
        }
        let value = tree + home - back;
        if go {
            let mut norm = 0.0;
            for (w, g) in self.pay_way.iter_mut().zip(&way_pay) {
                *w += g;
                norm += *w * *w;
            }
            if !flat {
                for (w, g) in self.extra_way.iter_mut().zip(&way) {
                    *w = *w * keep + g;
                    norm += scale * *w * *w;
                }
            }
            if norm > 0.0 {
                let by = if self.knobs[5] > 0.0 { self.knobs[5] } else { share * (target - value).max(0.0) / norm };
                for (p, w) in self.pay.iter_mut().zip(&self.pay_way) {
                    *p += by * w;
                }
                if !flat {
                    for (p, w) in self.extra.iter_mut().zip(&self.extra_way) {
                        *p += by * scale * w;
                    }
                }
            }
        }
        Look { value, back, home, size, legs }
    }

    fn price(&self, items: &[Item], pairs: &Pairs, e: usize, flat: bool) -> f64 {
        let pair = &pairs.list[e];
        let [a, b] = pair.items;
        let base = self.pay[a] + self.pay[b];
        if flat {
            return base + pair.least;
        }
        let columns = items[b].knots;
        let (ea, eb) = (&self.extra[pair.at[0]..pair.at[0] + items[a].knots], &self.extra[pair.at[1]..pair.at[1] + columns]);
        let mut least = f64::INFINITY;
        for (row, &x) in pairs.rows(pair, columns).zip(ea) {
            let in_row = row.iter().zip(eb).fold(f64::INFINITY, |m, (&s, &y)| m.min(f64::from(s) + y));
            least = least.min(in_row + x);
        }
        base + least
    }

    /// Spreads one leg over the knots of its pair, the more the nearer to the least.
    fn leg(&self, items: &[Item], first: usize, pairs: &Pairs, e: usize, soft: f64, way: &mut [f64]) {
        let pair = &pairs.list[e];
        let [a, b] = pair.items;
        let columns = items[b].knots;
        let least = self.cost[e] - self.pay[a] - self.pay[b];
        let mut sum = 0.0;
        let mut shares = vec![0.0; items[a].knots + columns];
        for (i, row) in pairs.rows(pair, columns).take(items[a].knots).enumerate() {
            for (j, &s) in row.iter().enumerate() {
                let over = f64::from(s) + self.extra[pair.at[0] + i] + self.extra[pair.at[1] + j] - least;
                if over < 20.0 * soft {
                    let w = exp(-over / soft);
                    sum += w;
                    shares[i] += w;
                    shares[items[a].knots + j] += w;
                }
            }
        }
        if sum > 0.0 {
            for (k, w) in shares.iter().enumerate() {
                if k >= items[a].knots || a >= first {
                    way[pair.at[0] + k] += w / sum;
                }
            }
        }
    }

    /// The most an item gets back besides what it pays: at one knot (or a pair of them), for legs to two items.
    fn star(&self, item: &Item, i: usize, count: usize, pairs: &Pairs, soft: f64, way: &mut [f64]) -> f64 {
        let of = &pairs.of[i];
        let free = (count - 1 - of.len()).min(2);
        let extra = |&(e, side): &(usize, usize), k: usize| self.extra[pairs.list[e].at[side] + k];
        let configs = if item.paired { item.knots / 2 } else { item.knots };
        let knots = |c: usize| if item.paired { (2 * c, 2 * c + 1) } else { (c, c) };
        // Hard: the best two.
        let mut values = Vec::with_capacity(configs);
        for c in 0..configs {
            let (k, l) = knots(c);
            let top = |k: usize| {
                let mut t = [(f64::NEG_INFINITY, usize::MAX); 2];
                let zeros = (0..free).map(|z| (0.0, usize::MAX - z));
                for (v, s) in of.iter().enumerate().map(|(s, p)| (extra(p, k), s)).chain(zeros) {
                    if v > t[0].0 {
                        t = [(v, s), t[0]];
                    } else if v > t[1].0 {
                        t[1] = (v, s);
                    }
                }
                t
            };
            let (x, y) = (top(k), top(l));
            let v = if x[0].1 != y[0].1 {
                x[0].0 + y[0].0
            } else {
                (x[0].0 + y[1].0).max(x[1].0 + y[0].0)
            };
            values.push(v);
        }
        let best = values.iter().fold(f64::NEG_INFINITY, |m, &v| m.max(v));
        // Soft: shares of all near the best.
        let mut sum = 0.0;
        let mut parts: Vec<(usize, f64)> = Vec::new();
        for (c, &v) in values.iter().enumerate() {
            if best - v > 20.0 * soft {
                continue;
            }
            let (k, l) = knots(c);
            let value = |k: usize, s: usize| of.get(s).map_or(0.0, |p| extra(p, k));
            let at = |k: usize, s: usize| of.get(s).map(|p| pairs.list[p.0].at[p.1] + k);
            let ends = of.len() + free;
            if k == l {
                let (mut one, mut two) = (usize::MAX, f64::NEG_INFINITY);
                let mut top = f64::NEG_INFINITY;
                for s in 0..ends {
                    let x = value(k, s);
                    if x > top {
                        (one, two, top) = (s, top, x);
                    } else {
                        two = two.max(x);
                    }
                }
                let r = exp((two - top) / soft);
                let scale = exp((v - best) / soft);
                let u: Vec<f64> = (0..ends).map(|s| if s == one { 0.0 } else { exp((value(k, s) - two) / soft) }).collect();
                let (all, squares): (f64, f64) = (u.iter().sum(), u.iter().map(|x| x * x).sum());
                sum += scale * (all + 0.5 * r * (all * all - squares));
                for (s, x) in u.iter().enumerate() {
                    let w = if s == one { all } else { x + r * x * (all - x) };
                    parts.extend(at(k, s).map(|p| (p, scale * w)));
                }
            } else {
                for s in 0..ends {
                    for t in (0..ends).filter(|&t| t != s) {
                        let under = best - value(k, s) - value(l, t);
                        if under < 20.0 * soft {
                            let w = exp(-under / soft);
                            sum += w;
                            parts.extend(at(k, s).map(|p| (p, w)));
                            parts.extend(at(l, t).map(|p| (p, w)));
                        }
                    }
                }
            }
        }
        if sum > 0.0 {
            for (at, w) in parts {
                way[at] -= w / sum;
            }
        }
        best
    }
}

/// The least legs of home: two to different items, one of each end of an open path; twice the same if there is only
/// one item.
fn home_legs(pairs: &Pairs, first: usize, cost: &[f64]) -> Vec<usize> {
    let best = |home: usize, but: Option<usize>| {
        let legs = pairs.of[home].iter().map(|l| l.0).filter(|&e| Some(pairs.list[e].items[1]) != but);
        legs.fold(None, |m: Option<usize>, e| if m.is_none_or(|b| cost[e] < cost[b]) { Some(e) } else { m })
    };
    let other = first - 1;
    let (Some(a), Some(b)) = (best(0, None), best(other, None)) else { return Vec::new() };
    let item = |e: usize| Some(pairs.list[e].items[1]);
    if item(a) != item(b) {
        return vec![a, b];
    }
    let choices = [best(other, item(a)).map(|c| [a, c]), best(0, item(b)).map(|c| [c, b])];
    let cheapest = choices.into_iter().flatten().reduce(|x, y| {
        let sum = |l: [usize; 2]| cost[l[0]] + cost[l[1]];
        if sum(y) < sum(x) { y } else { x }
    });
    cheapest.map_or(vec![a, b], |l| l.to_vec())
}
