//! A lower bound of the seconds of every plan, computed while the search runs.
//!
//! # The strong bound: walks
//!
//! A **walk** starts at home, makes as many stops as there are items, and ends at home (or anywhere, if the path is open),
//! but it may stop at an item again and skip another. Every tour is a walk, so that the cheapest walk costs no more than the
//! best tour. Charge each item `pi` for every stop and refund each charge once: the cost of a tour does not change, so that
//! for **any** charges
//!
//! > L(pi) = (least over walks of travel + charges of its stops) - (sum of all charges) <= travel of the best tour
//!
//! This is Lagrangian duality, and dynamic programming over (stops made, item, place) finds the cheapest walk exactly.
//! Charges rise where a walk stops too often and fall where it does not stop (subgradient steps). Rounding, bad steps or an
//! early end make the bound weaker, but never false. A walk enters and leaves an item at the same place, which a tree over
//! items does not: on Qu & Du's 43 contours trees prove 1,294 mm of 2,819, walks prove all of it.
//!
//! Walks carry a memory, which keeps them from going in circles and makes them respect precedence as far as they remember
//! (`space.rs`). Both exclude only walks that are no tours. Legs between items far apart on large sheets are priced by the
//! items' boxes, which is less than they cost.
//!
//! # Entries anywhere
//!
//! Contours are divided into pieces, and the least cost of a walk is computed only for the ends of pieces, the knots.
//! `minorant.rs` makes a table of numbers m(i, j) between knots such that the seconds from any point s to any point t are at
//! least the weighted mean of the m between the knots around s and t, where a nearer knot has more weight. Let F be the
//! values at the knots and F' the values one stop later: F'(j) <= F(i) + m(i, j) + pi for all i and j, so this holds for the
//! weighted means too. By induction the mean of the F around a point is at most the cost of any walk to that point. Pieces
//! are halved where the cheapest walks go; the loss shrinks with the square of their length.
//!
//! # Proven optimal
//!
//! When walks prove all but some per cent of the known path, every order of the items that may still be better is looked at
//! (`orders`). Either none is left, or those that are left give the bound and show which pieces of contours to halve next.
//! So the optimum of some 60 contours is proven in seconds, with entries anywhere up to a ten-millionth.
//!
//! # Hundreds of contours: flows
//!
//! A proof beside the search has a bound for hundreds of contours (`flows`): walks with memory, but without the number of stops.
//!
//! # The cheap bound: trees
//!
//! It serves problems with more than [`STRONG`] items. A tour without home is a path over the items, so it is a tree, and
//! home has two legs. Each item charges the legs that end at it, which are two in a tour (Held & Karp, 1970). Legs are priced
//! by the least seconds between any two places of their items. The final tree is over *all* pairs (`tree.rs`), so that the
//! bound stays valid although the ascent leaves out most pairs.
//!
//! # Contours left and resumed
//!
//! A contour that may be left can be passed several times, so that walks and trees with two legs for each item prove
//! nothing. But every item still has at least two legs, all items are connected without home, and home has its two legs. If
//! charges are rebates (`pi <= 0`), legs beyond the second only cost more: travel = (legs priced with charges) - (charges
//! times legs at each item) >= (legs priced with charges) - 2 (sum of charges). No rebate exceeds half the leg to the nearest
//! other item, so that no leg has a negative price, and the legs cost at least the minimum tree and the two cheapest legs of
//! home. The seconds for leaving and resuming are left out, which is safe. A proof beside the search has a far stronger bound for these problems,
//! and one for pierce groups (`postman`).
//!
//! # The bound of the whole job
//!
//! It is the bound of travel plus what every plan pays: [`crate::problem::Item::fixed`]. The extra seconds of entries (`extras.rs`) are part of the
//! legs to and from a stop; those of contours that may be left are left out, as are those of groups: they could only raise the bound.
//!
//! Sources: Houck, Picard, Queyranne & Vemuganti (1980) for walks; Christofides, Mingozzi & Toth (1981) for the state
//! spaces; Baldacci, Mingozzi & Roberti (2011) for the memory, Roberti & Mingozzi (2014) for letting it grow. Entries
//! anywhere, contours left unfinished: worked out here.

#[cfg(feature = "research")]
mod certificate;
mod charges;
mod cheap;
#[cfg(feature = "research")]
mod effort;
mod extras;
#[cfg(feature = "research")]
mod fault;
#[cfg(feature = "research")]
mod flows;
mod gather;
#[cfg(feature = "research")]
mod halving;
#[cfg(feature = "research")]
mod known_path;
#[cfg(feature = "research")]
mod level;
mod limits;
mod meet;
mod minorant;
#[cfg(feature = "research")]
mod mixtures;
mod net;
mod order;
mod orders;
mod pairs;
#[cfg_attr(not(feature = "research"), expect(dead_code, reason = "the bound by shares uses the rest of it"))]
mod places;
#[cfg(feature = "research")]
mod postman;
#[cfg(feature = "research")]
mod powers;
#[cfg(feature = "research")]
mod priced_cuts;
mod prices;
mod rounds;
#[cfg(feature = "research")]
mod scale;
#[cfg(feature = "research")]
mod shares;
mod space;
#[cfg(feature = "research")]
mod stop_certificate;
mod track;
mod tree;
#[cfg(feature = "research")]
mod walk_certificate;
mod walks;

use crate::problem::{Item, Problem};
#[cfg(feature = "research")]
use crate::solve::Solution;
#[cfg(feature = "research")]
pub use certificate::{Certificate, Certified, SharedLegs, with_paid};
use cheap::Cheap;
#[cfg(feature = "research")]
pub use fault::CertificateFault;
#[cfg(feature = "research")]
pub use flows::FlowBound;
#[cfg(feature = "research")]
use known_path::{Entry, KnownPath};
#[cfg(feature = "research")]
pub use mixtures::MixedLegs;
#[cfg(feature = "research")]
pub use postman::StopBound;
#[cfg(feature = "research")]
pub use priced_cuts::{Part, PricedCut};
#[cfg(feature = "research")]
use rounds::Record;
use rounds::Strong;
#[cfg(feature = "research")]
pub use shares::ShareBound;
#[cfg(feature = "research")]
pub use stop_certificate::{CutPart, PricedParts, StopCertificate};
#[cfg(feature = "research")]
pub use walk_certificate::{FlowCertificate, WalkCertificate};

/// Most items for the strong bound: with more, one pass over all walks takes about a second.
const STRONG: usize = 220;

/// A lower bound of [`crate::solve::Solution::cost`], in seconds. It is valid at any moment and rises with every slice of
/// work.
#[derive(Debug)]
pub struct LowerBound {
    method: Method,
    /// No plan saves more by links and starts than this, s: the travel of a path is no more than its cost and this.
    saved: f64,
    /// Work that is granted and not yet done; negative after a piece of work that exceeded the grant.
    left: i64,
    /// The best walks, when nothing is left to do.
    #[cfg(feature = "research")]
    record: Option<Box<Record>>,
    /// The best path it knew then.
    #[cfg(feature = "research")]
    known: KnownPath,
    /// The same bound before it began, if it uses what is known from the start (`rounds/known.rs`): it takes over if that comes to no end.
    #[cfg(feature = "research")]
    spare: Option<Box<Strong>>,
}

#[derive(Debug)]
enum Method {
    Cheap(Box<Cheap>),
    Strong(Box<Strong>),
    Done(f64),
}

impl LowerBound {
    /// Most contours whose bound is by walks.
    #[cfg(feature = "research")]
    pub(crate) const MOST_BY_WALKS: usize = STRONG;

    /// Starts with the bound 0.
    pub fn new(problem: &Problem) -> Self {
        let count = problem.items.len() - usize::from(problem.start().is_some());
        let resumes = problem.items.iter().any(|i| i.leave.is_some());
        let method = if count == 0 || problem.items.iter().any(Item::is_pierce_group) {
            Method::Done(0.0)
        } else if count > STRONG || resumes {
            Method::Cheap(Box::new(Cheap::new(problem, resumes)))
        } else {
            Method::Strong(Box::new(Strong::new(problem)))
        };
        Self {
            method,
            saved: problem.most_saved(),
            left: 0,
            #[cfg(feature = "research")]
            record: None,
            #[cfg(feature = "research")]
            known: KnownPath::default(),
            #[cfg(feature = "research")]
            spare: None,
        }
    }

    /// Looks at about `work` more numbers, a few nanoseconds each. `upper` is the cost of a known solution: it sets the
    /// length of steps but does not affect the validity of the bound. Returns whether more work may help.
    pub fn improve(&mut self, work: u32, upper: f64) -> bool {
        let upper = upper + self.saved;
        self.left += i64::from(work);
        while self.left > 0 {
            let done = match &mut self.method {
                Method::Cheap(cheap) => cheap.once(),
                Method::Strong(strong) => strong.once(upper),
                Method::Done(_) => 0,
            };
            if done == 0 {
                #[cfg(feature = "research")]
                if self.begin_again(upper) {
                    continue;
                }
                #[cfg(feature = "research")]
                if let Method::Strong(strong) = &mut self.method {
                    self.record = strong.record.take();
                    self.known = strong.known().clone();
                }
                self.method = Method::Done(self.value());
                return false;
            }
            self.left = self.left.saturating_sub_unsigned(done);
        }
        true
    }

    /// Whether it depends on known paths how much it proves: see [`LowerBound::knows`].
    #[cfg(feature = "research")]
    pub fn learns_of_paths(&self) -> bool {
        matches!(&self.method, Method::Strong(strong) if strong.learns_of_paths())
    }

    /// Tells the bound by walks of a known path. It does not affect the validity of the bound either, but on machines whose axes have limits of their own
    /// its legs show how those of all paths are best priced.
    #[cfg(feature = "research")]
    pub fn knows(&mut self, problem: &Problem, path: &Solution) {
        if let Method::Strong(strong) = &mut self.method {
            let entries: Option<Vec<_>> = path.stops.iter().map(|stop| Entry::of(stop, problem)).collect();
            if entries.is_some_and(|entries| strong.knows(&entries)) {
                self.spare = Some(Box::new(Strong::new(problem)));
            }
        }
    }

    /// Lets the spare bound take over from one that came to no end. Returns whether there is one.
    #[cfg(feature = "research")]
    fn begin_again(&mut self, upper: f64) -> bool {
        let (Some(mut next), Method::Strong(first)) = (self.spare.take(), &mut self.method) else {
            return false;
        };
        if first.has_proven(upper) {
            return false;
        }
        next.take_over(first);
        self.method = Method::Strong(next);
        true
    }

    /// The travel of the best path that it knows with its best entries, s, which it may have found itself; infinite where it knows none. If the bound is as
    /// much but for a ten-millionth, that path is optimal.
    #[cfg(feature = "research")]
    pub fn known(&self) -> f64 {
        self.known_path().seconds
    }

    /// This path, if it takes less than `seconds`.
    #[cfg(feature = "research")]
    pub fn better_than(&self, seconds: f64, problem: &Problem) -> Option<Solution> {
        let known = self.known_path();
        // A skipped contour is at home, as the bound sees it, and has no stop.
        let is_cut = |e: &&Entry| problem.items.get(e.contour).is_some_and(|item| !item.nodes.is_empty());
        let stops = known.entries.iter().filter(is_cut).map(|entry| entry.stop(problem));
        (known.seconds < seconds).then(|| Some(Solution::new(problem, stops.collect::<Option<_>>()?)))?
    }

    #[cfg(feature = "research")]
    fn known_path(&self) -> &KnownPath {
        match &self.method {
            Method::Strong(strong) => strong.known(),
            Method::Cheap(_) | Method::Done(_) => &self.known,
        }
    }

    /// The bound of the travel, s: a cost is no less than this less what links and starts may save ([`Problem::most_saved`]).
    pub fn value(&self) -> f64 {
        match &self.method {
            Method::Cheap(cheap) => cheap.value(),
            Method::Strong(strong) => strong.value(),
            Method::Done(value) => *value,
        }
    }

    /// The certificate of the best bound by walks or by all orders, if it proves more than `above`, s. Its check takes as long as some looks at all walks.
    #[cfg(feature = "research")]
    pub fn certificate(&self, problem: &Problem, above: f64) -> Option<WalkCertificate> {
        let record = match &self.method {
            Method::Strong(strong) => strong.record.as_ref(),
            Method::Cheap(_) | Method::Done(_) => self.record.as_ref(),
        };
        record.filter(|record| record.value > above)?.certificate(problem)
    }
}
