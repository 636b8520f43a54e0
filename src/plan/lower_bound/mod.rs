//! A number of seconds that no plan can be under, found while the search runs.
//!
//! # Strong: walks
//!
//! A **walk** sets out from home, makes as many stops as there are items, and ends at home (or anywhere, when the path
//! is open), but may stop at an item again and leave another out. Every tour is a walk, so the least walk costs no more
//! than the best tour. Charge each item `pi` for every stop and give all charges back once: for a tour nothing changes,
//! so for **any** charges
//!
//! > L(pi) = (least over walks of travel + charges of its stops) - (sum of all charges) <= travel of the best tour
//!
//! which is Lagrangian duality, and dynamic programming over (stops made, item, place) finds the least walk exactly.
//! Charges move up where a walk stops too often and down where it does not (subgradient steps); rounding, bad steps or
//! an early end cost strength, never truth. A walk enters and leaves an item at one and the same place, which a tree
//! over items does not ask: on Qu & Du's 43 contours a tree proves 1,294 mm of 2,819, walks all of it.
//!
//! Walks are kept from going round in circles by what they remember, and honour what must come before what as far as
//! they remember it (`space.rs`); both only take away walks that are no tours. Legs between items far apart on large
//! sheets are priced by their boxes: less than they cost.
//!
//! # Entries anywhere
//!
//! Contours are divided into pieces, and a walk's least cost is kept for their ends only, the knots. `minorant.rs`
//! makes a table of numbers m(i, j) between knots such that the seconds from any place s to any place t are at least
//! the mean of the m between the knots around s and t, weighted by how near each knot is along its piece. Let F be the
//! values at knots, F' the values one stop further: F'(j) <= F(i) + m(i, j) + pi for all i and j, and so for the
//! weighted means. By induction the mean of the F around a place is no more than the cost of any walk to that place.
//! Pieces are halved where the least walks go; the loss shrinks with the square of their length, and only there does
//! it matter.
//!
//! # Cheap: trees
//!
//! Beyond [`STRONG`] items: a tour without home is a path over the items, so a tree; home has two legs. Each item
//! charges the legs that end at it, two for a tour (Held & Karp, 1970). Legs are priced by the least seconds between any
//! two places of their items. The tree is over *all* pairs (`tree.rs`), so that leaving most pairs out of the ascent
//! costs nothing in truth.
//!
//! # Contours left and resumed
//!
//! Then a contour may be passed several times, and walks and trees of two legs an item say nothing. What holds: every
//! item has two legs or more, all items hang together without home, and home has its two legs. With charges that are
//! rebates (`pi <= 0`) legs beyond the second only cost more: travel = (legs at their prices with charges) - (charges
//! times legs at each item) >= (legs at their prices with charges) - 2 (sum of charges). No rebate is more than half the
//! way to the nearest other item, so that no leg has a price below 0, and the legs cost at least the least tree and
//! the least two of home. Seconds for leaving and resuming come on top; leaving them out is safe.
//!
//! # What the whole job takes at least
//!
//! The bound of travel and what every plan pays: [`crate::problem::Item::fixed`]. What entries cost on top is never less
//! than 0 and left out, as are groups: both would only add.
//!
//! Sources: Houck, Picard, Queyranne & Vemuganti (1980) for walks; Christofides, Mingozzi & Toth (1981) for the state
//! spaces; Baldacci, Mingozzi & Roberti (2011) for the memory, Roberti & Mingozzi (2014) for letting it grow. Entries
//! anywhere, contours left unfinished: worked out here.

mod cheap;
mod minorant;
mod net;
mod order;
mod pairs;
mod prices;
mod rounds;
mod space;
mod tree;
mod walks;

use crate::problem::{Item, Problem};
use cheap::Cheap;
use rounds::Strong;

/// Most items that get the strong bound: beyond, one look at all walks takes about a second.
const STRONG: usize = 220;

/// A lower bound under way: of [`crate::solve::Solution::cost`], in seconds. Better with every slice of work, valid
/// after each.
#[derive(Debug)]
pub struct LowerBound {
    method: Method,
    /// Work granted and not yet done; below 0 after a piece larger than that.
    left: i64,
}

#[derive(Debug)]
enum Method {
    Cheap(Box<Cheap>),
    Strong(Box<Strong>),
    Done(f64),
}

impl LowerBound {
    /// Nothing is proven yet: 0.
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
        Self { method, left: 0 }
    }

    /// Works for about `work` more numbers looked at, some nanoseconds each. `upper` is the cost of a known solution:
    /// the length of steps depends on it, the truth of the bound does not. Says whether more may help.
    pub fn improve(&mut self, work: u32, upper: f64) -> bool {
        self.left += i64::from(work);
        while self.left > 0 {
            let done = match &mut self.method {
                Method::Cheap(cheap) => cheap.once(),
                Method::Strong(strong) => strong.once(upper),
                Method::Done(_) => 0,
            };
            if done == 0 {
                self.method = Method::Done(self.value());
                return false;
            }
            self.left = self.left.saturating_sub_unsigned(done);
        }
        true
    }

    /// Seconds that no solution costs less than.
    pub fn value(&self) -> f64 {
        match &self.method {
            Method::Cheap(cheap) => cheap.value(),
            Method::Strong(strong) => strong.value(),
            Method::Done(value) => *value,
        }
    }
}
