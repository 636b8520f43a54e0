//! Certificates of the bound by stops (`postman`), and their check in whole numbers. As with [`super::Certificate`], how the numbers were
//! found does not matter; the check shares the division of contours, the seconds between pieces and the stops of items with the search.

use super::certificate::{Certified, unit, units};
use super::effort::Effort;
use super::fault::CertificateFault;
use super::net::{Item, homes};
use super::pairs::{Pairs, box_seconds};
use super::postman::{Member, Stop, Stops, applies, members};
use super::priced_cuts::{MOST_HELD, Part};
use super::prices::Prices;
use crate::problem::Problem;
use serde::{Deserialize, Serialize};

/// One of the parts into which a cut divides all places.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct CutPart {
    /// The items that it holds whole, in ascending order.
    pub members: Vec<usize>,
    /// The items of which it holds some knots, in ascending order.
    pub some: Vec<Part>,
    /// The item of `some` whose stops here are counted; without one, the part holds an item whole, and so a stop.
    pub visited: Option<usize>,
}

/// Parts that are joined by every plan, with the price of joining one to the others.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct PricedParts {
    /// The parts without that of home, which holds all places that are not listed.
    pub parts: Vec<CutPart>,
    /// In units, not negative: with n parts beside that of home, a leg between two parts pays n times this, and each joined part
    /// n + 1 times.
    pub price: i64,
}

/// Numbers that prove a bound of travel with contours that may be left, or with pierce groups.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct StopCertificate {
    /// The unit is 2 to this power, in seconds.
    pub unit: i32,
    /// Arc length of the knots along each item that may be entered anywhere, mm; empty for other items. Home is item 0 and the end of an
    /// open path item 1; contours that are cut with others are left out.
    pub knots: Vec<Vec<f64>>,
    /// The potential of each knot, in units: no leg takes less than those of its two ends and what it pays to cuts.
    pub potentials: Vec<Vec<i64>>,
    /// The cuts with prices.
    pub cuts: Vec<PricedParts>,
    /// The bound that follows, in units.
    pub bound: i64,
}

impl Certified for StopCertificate {
    fn stated(&self) -> (i64, i32) {
        (self.bound, self.unit)
    }

    fn adds_up_to(&self, problem: &Problem) -> Result<i128, CertificateFault> {
        if !applies(problem) {
            return Err(CertificateFault::Problem);
        }
        let first = homes(problem);
        let mut effort = Effort::after(self.cuts.len(), self.knots.iter().map(Vec::len).sum())?;
        let mut members = members(problem);
        if self.knots.len() != members.len() || self.potentials.len() != members.len() {
            return Err(CertificateFault::Shape("knots"));
        }
        for (member, along) in members.iter_mut().zip(&self.knots) {
            member.item = member.item.with_knots(along).ok_or(CertificateFault::Shape("knots"))?;
        }
        if self.potentials.iter().zip(&members).any(|(u, m)| u.len() != m.item.knots) {
            return Err(CertificateFault::Shape("potentials"));
        }
        let items: Vec<Item> = members.iter().map(|m| m.item.clone()).collect();
        let prices = Prices::new(problem);
        let (power, guard) = unit(&items, &prices, problem);
        let prices = prices.none_below(guard);
        if power != self.unit {
            return Err(CertificateFault::Shape("units"));
        }
        let cuts = Cuts::read(&self.cuts, &members, first).ok_or(CertificateFault::Shape("cuts"))?;
        self.legs_are_paid(&items, &prices, (power, guard), first, (&cuts, &mut effort))?;
        let mut sum = cuts.joined;
        for (k, member) in members.iter().enumerate() {
            sum += self.cheapest(k, member, power, &cuts).ok_or(CertificateFault::Overpaid("stop"))?;
        }
        Ok(sum)
    }
}

impl StopCertificate {
    /// Whether no leg pays more than it takes.
    fn legs_are_paid(
        &self,
        items: &[Item],
        prices: &Prices,
        (power, guard): (i32, f64),
        first: usize,
        (cuts, effort): (&Cuts, &mut Effort),
    ) -> Result<(), CertificateFault> {
        let most: Vec<i128> =
            self.potentials.iter().map(|u| u.iter().copied().max().unwrap_or(0).into()).collect();
        for b in first..items.len() {
            for a in 0..b {
                if a >= first {
                    let (p, q) = (items[a].around, items[b].around);
                    let seconds = box_seconds(prices, p.min, p.max, q.min, q.max);
                    let room = takes(seconds, power, guard) - most[a] - most[b];
                    if room >= cuts.most[a] + cuts.most[b] || room >= cuts.most_between([a, b]) {
                        continue;
                    }
                }
                effort.look_at([a, b].map(|k| items[k].knots), cuts.crossed([a, b]).len())?;
                let mut pairs = Pairs::new(items.len());
                pairs.add(items, prices, [a, b], true);
                let [n, m] = [a, b].map(|k| items[k].knots);
                let crossing = cuts.between([a, b], [n, m]);
                for (at, (&seconds, paid)) in
                    pairs.table(&pairs.list[0], n * m).iter().zip(&crossing).enumerate()
                {
                    let both =
                        i128::from(self.potentials[a][at / m]) + i128::from(self.potentials[b][at % m]);
                    if both + paid > takes(seconds, power, guard) {
                        return Err(CertificateFault::Overpaid("leg"));
                    }
                }
            }
        }
        Ok(())
    }

    /// The least that an item pays for its stops; `None` if a further stop is worth less than nothing, so that there is no least.
    fn cheapest(&self, k: usize, member: &Member, power: i32, cuts: &Cuts) -> Option<i128> {
        let (u, pay, refund) = (&self.potentials[k], &cuts.pay[k], cuts.refund[k]);
        let at = |v: usize| i128::from(u[v]);
        let knots = 0..member.item.knots;
        match &member.stops {
            Stops::End => Some(at(0)),
            Stops::Anywhere(again) => {
                let stop = |v: usize| 2 * at(v) + pay[v];
                let again = again.map(|s| i128::from(units(s, power)) - refund);
                let overpaid = again.is_some_and(|again| knots.clone().any(|v| stop(v) + again < 0));
                knots.map(stop).min().filter(|_| !overpaid)
            }
            Stops::Pairs => knots.step_by(2).map(|v| at(v) + at(v + 1) + pay[v]).min(),
            Stops::Paths(choices) => {
                let stop = |s: &Stop| {
                    i128::from(units(s.seconds, power)) + at(s.ends[0]) + at(s.ends[1]) + pay[s.ends[0]]
                };
                let more = |s: &Stop| (stop(s) - refund).min(0);
                choices.iter().map(|c| stop(&c.stop) + c.more.iter().map(more).sum::<i128>()).min()
            }
        }
    }
}

/// What a leg takes at least, in units: no leg takes less than nothing, and numbers below the guard are exactly 0.
fn takes(seconds: f64, power: i32, guard: f64) -> i128 {
    units(seconds - guard, power).max(0).into()
}

/// The parts of an item's knots in a cut, unless all are in the part of home.
struct Held {
    cut: usize,
    /// The part of all knots, if it is the same; otherwise `parts` has that of each.
    whole: Option<usize>,
    parts: Vec<usize>,
}

/// The cuts as the check reads them.
struct Cuts {
    /// For each cut what a leg between two parts pays.
    of_leg: Vec<i128>,
    /// For each item the cuts that hold some of it, in ascending order, and what a leg pays that crosses all of these.
    held: Vec<Vec<Held>>,
    most: Vec<i128>,
    /// For each knot of each item what a stop there pays, and for each item what a further stop gets back.
    pay: Vec<Vec<i128>>,
    refund: Vec<i128>,
    /// What every plan pays because parts hold items whole.
    joined: i128,
}

impl Cuts {
    /// `None` if the cuts do not fit the items.
    fn read(list: &[PricedParts], members: &[Member], first: usize) -> Option<Self> {
        let mut cuts = Self {
            of_leg: Vec::with_capacity(list.len()),
            held: members.iter().map(|_| Vec::new()).collect(),
            most: vec![0; members.len()],
            pay: members.iter().map(|m| vec![0; m.item.knots]).collect(),
            refund: vec![0; members.len()],
            joined: 0,
        };
        let mut all_held = 0;
        for cut in list {
            let count = i128::try_from(cut.parts.len()).ok()?;
            let price = i128::from(cut.price);
            if price < 0 || count == 0 {
                return None;
            }
            let mut part_of: Vec<Vec<usize>> = members.iter().map(|m| vec![0; m.item.knots]).collect();
            let mut take = |item: usize, knot: usize, part: usize| {
                // Home's part is not listed, and no knot is in two parts.
                let of = part_of.get_mut(item).filter(|_| item >= first)?.get_mut(knot)?;
                (std::mem::replace(of, part) == 0).then_some(())
            };
            for (part, number) in cut.parts.iter().zip(1..) {
                for &item in &part.members {
                    (0..members.get(item)?.item.knots).try_for_each(|v| take(item, v, number))?;
                }
                for some in &part.some {
                    some.knots.iter().try_for_each(|&v| take(some.item, v, number))?;
                }
                match part.visited {
                    None if part.members.is_empty() => return None,
                    None => cuts.joined += (count + 1) * price,
                    Some(v) => {
                        let of = part.some.iter().find(|s| s.item == v)?;
                        for &knot in &of.knots {
                            *cuts.pay.get_mut(v)?.get_mut(knot)? += (count + 1) * price;
                        }
                    }
                }
            }
            for (k, (member, parts)) in members.iter().zip(&part_of).enumerate() {
                // A place lies in one part.
                if member.places().iter().zip(parts).any(|(&place, part)| parts[place] != *part) {
                    return None;
                }
                if parts.windows(2).any(|w| w[0] != w[1]) {
                    cuts.refund[k] += (count + 1) * price;
                }
            }
            let (cut, of_leg) = (cuts.of_leg.len(), count * price);
            cuts.of_leg.push(of_leg);
            for (k, parts) in
                part_of.into_iter().enumerate().filter(|(_, parts)| parts.iter().any(|p| *p != 0))
            {
                let whole = parts.first().copied().filter(|first| parts.iter().all(|part| part == first));
                let parts = if whole.is_some() { Vec::new() } else { parts };
                all_held += parts.len();
                if all_held > MOST_HELD {
                    return None;
                }
                cuts.held[k].push(Held { cut, whole, parts });
                cuts.most[k] += of_leg;
            }
        }
        Some(cuts)
    }

    /// The cuts that a leg between two items may cross: what it pays, and the parts of both.
    fn crossed(&self, [a, b]: [usize; 2]) -> Vec<(i128, [Option<&Held>; 2])> {
        let mut held = [a, b].map(|k| self.held[k].iter().peekable());
        let mut crossed = Vec::new();
        while let Some(cut) = held.iter_mut().filter_map(|h| h.peek().map(|h| h.cut)).min() {
            let both = held.each_mut().map(|h| h.next_if(|h| h.cut == cut));
            let [p, q] = both.map(|h| h.map_or(Some(0), |h| h.whole));
            if p.is_none() || p != q {
                crossed.push((self.of_leg[cut], both));
            }
        }
        crossed
    }

    /// For each leg between two items, row by row, what it pays.
    fn between(&self, ends: [usize; 2], [n, m]: [usize; 2]) -> Vec<i128> {
        let mut crossing = vec![0; n * m];
        for (of_leg, [p, q]) in self.crossed(ends) {
            let part =
                |held: Option<&Held>, v: usize| held.map_or(0, |h| h.whole.unwrap_or_else(|| h.parts[v]));
            for (at, paid) in crossing.iter_mut().enumerate() {
                if part(p, at / m) != part(q, at % m) {
                    *paid += of_leg;
                }
            }
        }
        crossing
    }

    /// At least what any leg between two items pays.
    fn most_between(&self, ends: [usize; 2]) -> i128 {
        self.crossed(ends).iter().map(|c| c.0).sum()
    }
}
