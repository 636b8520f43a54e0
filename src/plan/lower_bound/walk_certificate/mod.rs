//! Certificates of the bound by walks (`rounds`), and their check in whole numbers.
//!
//! A certificate lists what decides which walks there are, and what they pay: how contours are divided into pieces, which items each item
//! remembers, the charge of a stop at each item, and the prices of cuts. The check makes the problem again, finds the shortest walk by a dynamic
//! programme of its own in whole numbers (`states.rs`, `shortest.rs`), and gives the charges back. How the numbers were found does not matter, and
//! none of them has to be good: whatever they are, no tour takes less than what follows.
//!
//! # Why
//!
//! A tour stops at each item somewhere between two knots. Replace each stop by one of these two knots by lot, the nearer one more often, so that
//! the mean of the two is where the stop is. The seconds between pieces (`minorant.rs`) are such that the legs between the
//! knots take no more in the mean than those of the tour. So some tour over knots takes no more than the tour. It stops once at each item, so that it pays
//! each charge once. Where it stops in a cut it enters it and leaves it, so that it is given the price twice or more, and pays it twice: either
//! as every tour does, because the cut holds an item whole, or for its stop at some knots of one. It is among the walks that the check knows, because these
//! leave out only walks that are no tours. A leg between items that are not near is priced by their boxes and forgets everything, which only lowers the
//! value.
//!
//! Walks seldom prove the last thousandth. A certificate of all orders states a bound that no order of the items takes less than: the check looks at every
//! order that walks do not rule out (`orders.rs`). If the bound is what a known path takes, that path is optimal.
//!
//! The check shares the division of contours, the seconds between pieces, the precedence of items and the reading of cuts with the other
//! certificates, and nothing with the search for the bound.

mod flows;
mod orders;
mod shortest;
mod states;

use super::certificate::{Certified, divided, unit};
use super::effort::MOST_KNOTS;
use super::fault::CertificateFault;
use super::mixtures::{MixedLegs, Mixtures};
use super::net::{Item, homes};
use super::order::Order;
use super::priced_cuts::{Cuts, PricedCut};
use super::prices::Prices;
use crate::problem::Problem;
pub use flows::FlowCertificate;
use serde::{Deserialize, Serialize};
use shortest::{Most, NONE, Walks};
use states::{MOST_ITEMS, States};

/// Largest potential, and largest sum of the prices of cuts, in units: a thousand times a leg across everything.
const LARGEST: i64 = 1 << 50;
/// Largest sum that a walk may pay or be given by charges and prices, in units. With its legs it stays far below [`NONE`], also below 0.
const MOST_PAID: i128 = 1 << 60;

/// Numbers that prove a bound of travel by walks.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct WalkCertificate {
    /// The unit is 2 to this power, in seconds (or in the unit of the table of costs).
    pub unit: i32,
    /// Arc length of the knots along each item that may be entered anywhere, mm; empty for other items.
    pub knots: Vec<Vec<f64>>,
    /// For each item those of a higher number that it is near, in ascending order: legs between them are priced from knot to knot, all others, but
    /// those of home, by boxes.
    pub near: Vec<Vec<usize>>,
    /// For each item which others walks remember there (its ng-set), in ascending order.
    #[serde(rename = "company")]
    pub ng_sets: Vec<Vec<usize>>,
    /// For each item what a stop there pays, in units; nothing at home.
    pub charges: Vec<i64>,
    /// The cuts with prices.
    pub cuts: Vec<PricedCut>,
    /// How much x counts in legs where that is not left to the check, in ascending order of the items.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub mixtures: Vec<MixedLegs>,
    /// Whether the bound follows only if all orders are looked at that may take less.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub all_orders: bool,
    /// The bound that follows, in units.
    pub bound: i64,
}

impl Certified for WalkCertificate {
    fn stated(&self) -> (i64, i32) {
        (self.bound, self.unit)
    }

    fn adds_up_to(&self, problem: &Problem) -> Result<i128, CertificateFault> {
        if !applies(problem) {
            return Err(CertificateFault::Problem);
        }
        let mut ground = read(&self.knots, [&self.near, &self.ng_sets], self.unit, problem)?;
        let mixtures = Mixtures::read(&self.mixtures, ground.items.len());
        ground.prices.mixtures = mixtures.ok_or(CertificateFault::Shape("mixtures"))?;
        self.fits(ground.items.len(), ground.first)?;
        let states = ground.states()?;
        let walks = ground.walks(&states);
        let most = if self.all_orders { Most::OF_ORDERS } else { Most::OF_WALKS };
        walks.are_few(&most, self.cuts.len(), ground.items.len())?;
        let cuts = ground.cuts(&self.cuts)?;
        self.pays_little()?;
        let costs = walks.costs((self.unit, ground.guard), &self.charges, &cuts)?;
        // What a tour pays for charges and prices beside its legs.
        let beside = self.charges.iter().copied().map(i128::from).sum::<i128>() - cuts.back;
        let least = if self.all_orders {
            let limit = i128::from(self.bound) + beside;
            let limit = i64::try_from(limit).map_err(|_| CertificateFault::Shape("bound"))?;
            walks.best_tour(&costs, &self.ng_sets, limit.min(NONE / 2))?
        } else {
            walks.shortest(&costs)?
        };
        Ok(i128::from(least) - beside)
    }
}

impl WalkCertificate {
    /// Whether the charges are those of the items.
    fn fits(&self, count: usize, first: usize) -> Result<(), CertificateFault> {
        let is_free = self.charges.iter().take(first).all(|&charge| charge == 0);
        if self.charges.len() != count || !is_free {
            return Err(CertificateFault::Shape("charges"));
        }
        Ok(())
    }

    /// Whether what walks pay fits into 64 bits: they make as many stops as there are items, all of them where most is paid.
    fn pays_little(&self) -> Result<(), CertificateFault> {
        let most = self.charges.iter().map(|charge| charge.unsigned_abs()).max().unwrap_or(0);
        // A stop pays the price of a cut twice at most.
        let prices: i128 = self.cuts.iter().map(|cut| i128::from(cut.price)).sum();
        let paid = self.charges.len() as i128 * (i128::from(most) + 2 * prices);
        if paid > MOST_PAID { Err(CertificateFault::Shape("charges")) } else { Ok(()) }
    }
}

/// What certificates by walks and by flows are about.
struct Ground<'c> {
    items: Vec<Item>,
    /// Index of the first contour; the items before it are home.
    first: usize,
    prices: Prices,
    order: Order,
    near: &'c [Vec<usize>],
    ng_sets: &'c [Vec<usize>],
    /// By how many seconds the least seconds of legs are lowered.
    guard: f64,
}

/// Makes the items of a problem and the lists of a certificate fit each other. The lists: what each item is near, and what is remembered there;
/// `power`: the unit of the certificate.
fn read<'c>(
    knots: &[Vec<f64>],
    [near, ng_sets]: [&'c [Vec<usize>]; 2],
    power: i32,
    problem: &Problem,
) -> Result<Ground<'c>, CertificateFault> {
    if knots.iter().map(Vec::len).sum::<usize>() > MOST_KNOTS {
        return Err(CertificateFault::TooMuch("knots"));
    }
    let items = divided(problem, knots)?;
    if items.len() > MOST_ITEMS {
        return Err(CertificateFault::TooMuch("items"));
    }
    let (first, prices) = (homes(problem), Prices::new(problem));
    let (right, guard) = unit(&items, &prices, problem);
    if power != right {
        return Err(CertificateFault::Shape("units"));
    }
    let ground = Ground { items, first, order: Order::new(problem, first), near, ng_sets, guard, prices };
    ground.fits()?;
    Ok(ground)
}

impl Ground<'_> {
    fn states(&self) -> Result<States, CertificateFault> {
        States::new((self.near, self.ng_sets), &self.order, self.first)
    }

    fn walks<'w>(&'w self, states: &'w States) -> Walks<'w> {
        let Ground { items, first, prices, order, near, .. } = self;
        Walks { items, first: *first, prices, order, near, states }
    }

    /// The cuts of a certificate.
    fn cuts<'p>(&self, list: &'p [PricedCut]) -> Result<Cuts<'p>, CertificateFault> {
        let prices: i128 = list.iter().map(|c| i128::from(c.price)).sum();
        let small = prices <= i128::from(LARGEST);
        Cuts::read(list, &self.items, self.first).filter(|_| small).ok_or(CertificateFault::Shape("cuts"))
    }

    /// Whether the lists have the right lengths and name items that are there.
    fn fits(&self) -> Result<(), CertificateFault> {
        let (count, first, all_near) = (self.items.len(), self.first, self.prices.given());
        let inside = |list: &Vec<usize>, from: usize| {
            list.is_sorted_by(|a, b| a < b) && list.iter().all(|i| (from..count).contains(i))
        };
        let near = |(item, list): (usize, &Vec<usize>)| {
            let all = !all_near || list.len() == count - item - 1;
            if item < first { list.is_empty() } else { all && inside(list, item + 1) }
        };
        if self.near.len() != count || !self.near.iter().enumerate().all(near) {
            return Err(CertificateFault::Shape("near items"));
        }
        let ng_sets =
            |(item, list): (usize, &Vec<usize>)| inside(list, first) && (item >= first || list.is_empty());
        if self.ng_sets.len() != count || !self.ng_sets.iter().enumerate().all(ng_sets) {
            return Err(CertificateFault::Shape("lists of company"));
        }
        Ok(())
    }
}

/// Whether the bounds by walks and by flows apply: there is an item, none is left unfinished, and there are no pierce groups.
pub(super) fn applies(problem: &Problem) -> bool {
    problem.items.len() > usize::from(problem.start().is_some())
        && problem.items.iter().all(|i| i.leave.is_none() && !i.is_pierce_group())
}
