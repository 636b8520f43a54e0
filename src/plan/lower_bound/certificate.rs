//! Certificates of the bound by shares, and their check in whole numbers.
//!
//! A certificate lists numbers that anyone can add up again; how they were found does not matter. All of them are whole
//! multiples of a unit, a power of two of about a million-millionth of the longest leg, so that the check adds without
//! rounding. Only the least seconds between two pieces and the extra seconds of stops come from floating-point numbers: they are lowered by
//! [`GUARD`], which is far more than rounding can have raised them, and rounded down.
//!
//! The check shares the division of contours (`net.rs`) and the seconds between pieces (`prices.rs`) with the search for the
//! bound, and nothing else.

use super::effort::Effort;
use super::extras::counts_extras;
use super::fault::CertificateFault;
use super::net::{Item, homes, items};
use super::pairs::{Pairs, box_seconds};
use super::priced_cuts::{Cuts, PricedCut};
use super::prices::Prices;
use crate::problem::{self, Problem};
use serde::{Deserialize, Serialize};
use std::collections::BTreeSet;

/// Lowers least seconds between pieces, as a share of the seconds across everything: 2^-36. They come from about twenty
/// operations, each of which is off by at most 2^-53 of that.
const GUARD: f64 = 1.0 / (1_u64 << 36) as f64;
/// How many times longer than across everything a contour may take before it decides: its extra seconds are off by a few times 2^-53 of it.
const SLOWER: f64 = 1024.0;
/// The seconds across everything are at most this power of two of the unit, so that no sum of shares exceeds 64 bits.
const BITS: i32 = 40;

/// The shares of the legs between two items that each of them pays.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct SharedLegs {
    /// The two items, the lower number first. Home is 0; the end of an open path is 1.
    pub items: [usize; 2],
    /// What each of them pays for a leg that ends at each of its knots, in units.
    pub shares: [Vec<i64>; 2],
}

/// Numbers that prove a bound of travel.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Certificate {
    /// The unit is 2 to this power, in seconds (or in the unit of the table of costs).
    pub unit: i32,
    /// Arc length of the knots along each item that may be entered anywhere, mm; empty for other items.
    pub knots: Vec<Vec<f64>>,
    /// The pairs of items with shares.
    pub legs: Vec<SharedLegs>,
    /// What each item pays for a leg to an item with which it has no shares, in units.
    pub far: Vec<i64>,
    /// The cuts with prices.
    pub cuts: Vec<PricedCut>,
    /// The bound that follows, in units.
    pub bound: i64,
}

/// What all certificates of a bound of travel are.
pub trait Certified {
    /// The bound that it states, in units, and the unit: 2 to this power, in seconds (or in the unit of the table of costs).
    fn stated(&self) -> (i64, i32);

    /// The bound that its numbers prove, in units.
    ///
    /// # Errors
    /// What does not fit the problem, a leg or a stop that costs less than it pays, or what would take too long to check.
    fn adds_up_to(&self, problem: &Problem) -> Result<i128, CertificateFault>;

    /// The bound that it states, s.
    fn seconds(&self) -> f64 {
        let (bound, unit) = self.stated();
        below(unit, bound.into())
    }

    /// Adds the numbers up again, in whole numbers, and returns the bound of travel of every plan of the problem, s.
    ///
    /// # Errors
    /// What does not fit, or which bound the numbers prove instead.
    fn check(&self, problem: &Problem) -> Result<f64, CertificateFault> {
        let (proven, stated) = (self.adds_up_to(problem)?, self.stated().0);
        if proven == i128::from(stated) {
            Ok(self.seconds())
        } else {
            Err(CertificateFault::Bound { stated, proven })
        }
    }
}

/// Whether the bound by shares applies: legs cost the same both ways, no item is left unfinished, there are no pierce groups,
/// and every item has two different neighbours in every tour.
pub(super) fn applies(problem: &Problem) -> bool {
    let item = |i: &problem::Item| i.leave.is_none() && !i.is_pierce_group();
    let least = if problem.table().is_some() { 3 } else { 2 };
    problem.items.len() >= least
        && problem.items.iter().all(item)
        && problem.table().is_none_or(problem::Table::is_symmetric)
}

/// The unit for a problem, as a power of two, and by how many seconds least seconds are lowered.
pub(super) fn unit(items: &[Item], prices: &Prices, problem: &Problem) -> (i32, f64) {
    let (scale, guard) = match problem.table() {
        Some(table) => (table.costs().iter().fold(1.0, |m: f64, c| m.max(c.abs())), 0.0),
        None => {
            let all = items.iter().fold(items[0].around, |b, i| b.union(i.around));
            // Coordinates are rounded too, so the distance to the origin counts.
            let reach = all.min.abs().max(all.max.abs());
            let air = prices.minorant.air();
            let scale = 2.0 * air.seconds(-reach, reach) + f64::MIN_POSITIVE;
            // Extra seconds of stops are differences of the seconds of a whole contour.
            let uneven = problem.items.iter().filter(|i| counts_extras(i) && i.is_uneven());
            let slowest = uneven.fold(0.0, |m: f64, i| m.max(i.fixed));
            (scale, GUARD * scale.max(slowest / SLOWER))
        }
    };
    // The exponent of the power of two above the scale.
    (libm::frexp(scale).1 - BITS, guard)
}

/// The items of a problem with these knots, see [`Certificate::knots`].
pub(super) fn divided(problem: &Problem, knots: &[Vec<f64>]) -> Result<Vec<Item>, CertificateFault> {
    let items = items(problem);
    let fitting = if knots.len() == items.len() { Some(items.iter().zip(knots)) } else { None };
    let divided = fitting.and_then(|f| f.map(|(item, along)| item.with_knots(along)).collect());
    divided.ok_or(CertificateFault::Shape("knots"))
}

/// Seconds in units, rounded down.
pub(super) fn units(seconds: f64, power: i32) -> i64 {
    #[expect(clippy::cast_possible_truncation, reason = "whole, and infinity saturates")]
    let whole = libm::ldexp(seconds, -power).floor() as i64;
    whole.clamp(-(1 << 50), 1 << 50)
}

/// Seconds below this many units, which are this power of two.
pub(super) fn below(power: i32, whole: i128) -> f64 {
    // Rounded to the nearest: one unit less is below it, unless numbers of this size are farther apart than units.
    let near = (whole - 1) as f64;
    #[expect(clippy::cast_possible_truncation, reason = "whole")]
    let is_above = near as i128 > whole;
    libm::ldexp(if is_above { near.next_down() } else { near }, power)
}

/// A proven travel in units, and the seconds that every plan pays besides: their sum, s, rounded down.
pub fn with_paid(power: i32, proven: i128, paid: impl Iterator<Item = f64>) -> f64 {
    #[expect(clippy::cast_possible_truncation, reason = "whole")]
    let whole = |seconds: f64| libm::ldexp(seconds, -power).floor() as i128;
    below(power, proven + paid.map(whole).sum::<i128>())
}

impl Certified for Certificate {
    fn stated(&self) -> (i64, i32) {
        (self.bound, self.unit)
    }

    fn adds_up_to(&self, problem: &Problem) -> Result<i128, CertificateFault> {
        if !applies(problem) {
            return Err(CertificateFault::Problem);
        }
        let first = homes(problem);
        let mut effort = Effort::after(self.cuts.len(), self.knots.iter().map(Vec::len).sum())?;
        let items = divided(problem, &self.knots)?;
        if self.far.len() != items.len() {
            return Err(CertificateFault::Shape("knots"));
        }
        let prices = Prices::new(problem);
        let (power, guard) = unit(&items, &prices, problem);
        if power != self.unit {
            return Err(CertificateFault::Shape("units"));
        }
        let cuts = Cuts::read(&self.cuts, &items, first).ok_or(CertificateFault::Shape("cuts"))?;
        let mut sum: i128 = cuts.back;
        // A leg is paid by both its items and by the cuts. Where that is more than it costs, it is used once at most.
        let mut listed = BTreeSet::new();
        let mut of: Vec<Vec<&[i64]>> = vec![Vec::new(); items.len()];
        for legs in &self.legs {
            let [a, b] = legs.items;
            let fits = a < b && b < items.len() && b >= first && listed.insert((a, b));
            if !fits || legs.shares[0].len() != items[a].knots || legs.shares[1].len() != items[b].knots {
                return Err(CertificateFault::Shape("shares"));
            }
            effort.look_at([a, b].map(|k| items[k].knots), cuts.in_part([a, b]))?;
            let mut pairs = Pairs::new(items.len());
            pairs.add(&items, &prices, [a, b], true);
            let table = pairs.table(&pairs.list[0], items[a].knots * items[b].knots);
            let crossing = cuts.between([a, b], [items[a].knots, items[b].knots]);
            let left = |(k, &seconds): (usize, &f64)| {
                let (i, j) = (k / items[b].knots, k % items[b].knots);
                let paid = i128::from(legs.shares[0][i]) + i128::from(legs.shares[1][j]) + crossing[k];
                i128::from(units(seconds - guard, power)) - paid
            };
            sum += table.iter().enumerate().map(left).fold(0, i128::min);
            of[a].push(&legs.shares[0]);
            of[b].push(&legs.shares[1]);
        }
        for a in 0..items.len() {
            for b in (a + 1).max(first)..items.len() {
                if listed.contains(&(a, b)) {
                    continue;
                }
                if prices.given() || a < first {
                    return Err(CertificateFault::Shape("shares"));
                }
                let (p, q) = (items[a].around, items[b].around);
                let seconds = units(box_seconds(&prices, p.min, p.max, q.min, q.max) - guard, power);
                let left = i128::from(seconds) - i128::from(self.far[a]) - i128::from(self.far[b]);
                if left < cuts.touching[a] + cuts.touching[b] {
                    sum += (left - cuts.most_between([a, b])).min(0);
                }
            }
        }
        for (k, item) in items.iter().enumerate() {
            let partners = if k < first { items.len() - first } else { items.len() - 1 };
            let far = (of[k].len() < partners).then_some(self.far[k]);
            let one_leg = k < first && first == 2;
            sum += cheapest(&of[k], far, &cuts.pay[k], item, one_leg)
                .ok_or(CertificateFault::Shape("shares"))?;
        }
        Ok(sum)
    }
}

/// The least that an item pays for its legs: two to different items, from one knot or from the two ends of a pair of knots.
/// `pay`: what a stop at each knot pays besides.
fn cheapest(shares: &[&[i64]], far: Option<i64>, pay: &[i128], item: &Item, one_leg: bool) -> Option<i128> {
    // The two cheapest legs of a knot, and to whom the first goes. Far legs may go to two different items.
    let two = |knot: usize| {
        let mut best: [(i64, usize); 2] = [(i64::MAX, usize::MAX); 2];
        let listed = shares.iter().enumerate().map(|(l, s)| (s[knot], l));
        let distant = far.into_iter().flat_map(|f| [(f, shares.len()), (f, shares.len() + 1)]);
        for leg in listed.chain(distant) {
            if leg < best[0] {
                best = [leg, best[0]];
            } else if leg < best[1] {
                best[1] = leg;
            }
        }
        best
    };
    let sum = |a: (i64, usize), b: (i64, usize)| {
        (a.1 != usize::MAX && b.1 != usize::MAX).then(|| i128::from(a.0) + i128::from(b.0))
    };
    let knots = 0..item.knots;
    if one_leg {
        return least(knots.map(|k| Some(i128::from(two(k)[0].0)).filter(|_| !shares.is_empty())));
    }
    if !item.paired {
        return least(knots.map(|k| {
            let [a, b] = two(k);
            Some(sum(a, b)? + pay[k])
        }));
    }
    least(knots.step_by(2).map(|k| {
        let (a, b) = (two(k), two(k + 1));
        let legs = if a[0].1 == b[0].1 { sum(a[0], b[1])?.min(sum(a[1], b[0])?) } else { sum(a[0], b[0])? };
        Some(legs + pay[k])
    }))
}

/// The least of some sums; `None` if one of them cannot be made, or there are none.
fn least(mut values: impl Iterator<Item = Option<i128>>) -> Option<i128> {
    values.try_fold(i128::MAX, |m, v| v.map(|v| m.min(v))).filter(|&m| m != i128::MAX)
}
