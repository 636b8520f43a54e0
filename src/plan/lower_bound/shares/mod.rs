//! The bound by shares, for hundreds of contours.
//!
//! # The idea
//!
//! Every leg of a tour joins two items. Let each of the two pay a share of its seconds, which may depend on the knot where
//! the leg ends, such that both shares together are no more than the leg takes. Each item has exactly two legs, to two
//! different items and from one knot (or from the two ends of an open contour). So it pays at least the cheapest such pair of
//! shares, and
//!
//! > the sum over all items of the cheapest pair of shares <= travel of the best tour
//!
//! whatever the shares are. Cuts make it stronger: for a set of items that is not all of them, every tour has two legs or
//! more between the set and the rest. Each such leg pays the price of the cut too, and twice the price is added to the sum.
//!
//! The best shares and prices are the dual solution of a linear programme: the generalised travelling salesman problem with
//! `x(v : S) <= y(v)` for each knot v and item S, and generalised subtour elimination for sets of whole items (Fischetti,
//! Salazar & Toth, 1997). Entries anywhere need no more than knots, for the same reason as with walks: shares between two
//! knots are interpolated, the cheapest pair is a minimum of linear functions, and its least value is at a knot.
//!
//! # How the shares are found
//!
//! The minima are replaced by smooth ones at a temperature, so that each item prefers its cheap pairs by degrees
//! (`soft.rs`). A share moves by the logarithm of how often its item wants the leg, compared with how often the leg wants to
//! be used: generalised iterative scaling (Darroch & Ratcliff, 1972), which never overshoots. The temperature falls to
//! a small part of an average leg. Cuts are added where the smooth solution leaves sets with fewer than two legs
//! (`cuts.rs`), legs between far items where they would be used (`exact.rs`), and pieces of contours are halved where the
//! solution loses seconds between knots (`refine.rs`).
//!
//! No part of this needs to be exact: what counts is the [`Certificate`] of the final shares, added up in whole numbers.

mod cut;
mod cuts;
mod exact;
mod refine;
mod soft;

use super::certificate::{Certificate, Certified, applies};
use super::net::{Item, bases, homes, items};
use super::pairs::Pairs;
use super::prices::Prices;
use super::scale::average_leg;
use crate::problem::Problem;
use cut::{Cut, Leg};

/// The temperatures of a round, as shares of an average leg: the first, the first of a later round, and the last. Hotter
/// ones move far shares quickly; below the last one the smooth minimum is nearly the real one.
const HOT: f64 = 0.2;
const WARM: f64 = 0.01;
const COLD: f64 = 0.002;
/// Factor between two temperatures.
const COOLER: f64 = 0.5;
/// Steps between two evaluations; selecting the legs that matter takes about as long as ten steps.
const STEPS: usize = 50;
/// Evaluations after which the gain is looked at, and the share of the value that is worth more steps at this temperature.
const LOOKS: usize = 5;
const WORTH: f64 = 0.002;
/// The same while pieces are still long.
const WORTH_ROUGH: f64 = 0.02;
/// Rounds that end at the warm temperature, with pieces that are still long: their exact solution would be worth little.
const ROUGH: usize = 5;
/// Gain for which a certificate is written and checked, which takes about as long as twenty steps.
const WORTH_PROVING: f64 = 0.002;
/// Most numbers in the tables of legs: 64 MB.
const MOST_NUMBERS: usize = 8_000_000;

/// How the legs of an item are chosen.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Kind {
    /// One leg: an end of an open path.
    End,
    /// Two legs to two different items, from one knot.
    Closed,
    /// Two legs to two different items, from the two ends of a pair of knots.
    Paired,
}

/// The bound by shares. It is valid at any moment and rises with work.
#[derive(Debug)]
pub struct ShareBound {
    problem: Problem,
    items: Vec<Item>,
    first: usize,
    prices: Prices,
    kinds: Vec<Kind>,
    pairs: Pairs,
    /// For each pair where the shares of its two items start.
    at: Vec<[usize; 2]>,
    shares: Vec<f64>,
    cuts: Vec<Cut>,
    /// Where the knots of each item start in the lists by knot.
    base: Vec<usize>,
    /// For each knot what a stop there pays for cuts, and how often the smooth solution stops there.
    pay: Vec<f64>,
    stay: Vec<f64>,
    /// For each pair how much the smooth solution uses it.
    usage: Vec<f64>,
    /// The tables of all pairs less the prices of cuts, and where that of each pair starts.
    cost: Vec<f64>,
    cost_at: Vec<usize>,
    /// For each share how often its item wants the leg, and how often the leg wants to be used.
    wanted: Vec<f64>,
    offered: Vec<f64>,
    /// Legs that are not much too expensive, pair by pair, and where those of each pair start.
    active: Vec<Leg>,
    starts: Vec<usize>,
    /// For each of them the prices of the cuts it crosses, and how much the smooth solution uses it.
    credit: Vec<f64>,
    uses: Vec<f64>,
    /// How many cuts each of them crosses.
    crossed: Vec<f64>,
    /// The same for pairs of items, of cuts that all legs of a pair cross: their prices and their number.
    of_pairs: Vec<(f64, f64)>,
    /// The average leg, s.
    mean: f64,
    temperature: f64,
    steps: usize,
    looks: usize,
    /// Rounds of halving pieces so far.
    rounds: usize,
    /// The value some evaluations ago.
    before: f64,
    done: bool,
    left: i64,
    proof: Option<Certificate>,
    best: f64,
}

impl ShareBound {
    /// Starts with the bound 0; `None` if this bound does not apply: contours may be left unfinished, there are pierce
    /// groups, legs cost more one way than the other, or there are fewer than three items.
    pub fn new(problem: &Problem) -> Option<Self> {
        if !applies(problem) {
            return None;
        }
        let (items, first, prices) = (items(problem), homes(problem), Prices::new(problem));
        let pairs = Pairs::first(&items, first, &prices);
        let kind = |(k, item): (usize, &Item)| match (k < first && first == 2, item.paired) {
            (true, _) => Kind::End,
            (_, true) => Kind::Paired,
            _ => Kind::Closed,
        };
        let rounds = if items.iter().any(Item::can_halve) { 0 } else { ROUGH };
        let mut bound = Self {
            problem: problem.clone(),
            kinds: items.iter().enumerate().map(kind).collect(),
            items,
            first,
            prices,
            base: Vec::new(),
            pay: Vec::new(),
            stay: Vec::new(),
            cost: Vec::new(),
            cost_at: Vec::new(),
            usage: vec![0.0; pairs.list.len()],
            pairs,
            at: Vec::new(),
            shares: Vec::new(),
            cuts: Vec::new(),
            wanted: Vec::new(),
            offered: Vec::new(),
            active: Vec::new(),
            starts: Vec::new(),
            credit: Vec::new(),
            uses: Vec::new(),
            crossed: Vec::new(),
            of_pairs: Vec::new(),
            mean: 1.0,
            temperature: 1.0,
            steps: 0,
            looks: 0,
            // Points have no pieces.
            rounds,
            before: f64::NEG_INFINITY,
            done: false,
            left: 0,
            proof: None,
            best: 0.0,
        };
        bound.lay_out();
        for e in 0..bound.pairs.list.len() {
            bound.share_evenly(e);
        }
        let value = bound.look();
        let paid = value / bound.items.len() as f64;
        bound.mean = average_leg(paid, &bound.items, &bound.pairs, &bound.prices);
        bound.temperature = HOT * bound.mean;
        bound.select();
        bound.prove(value);
        Some(bound)
    }

    /// The bound of travel, s.
    pub fn value(&self) -> f64 {
        self.best
    }

    /// The numbers that prove the bound; `None` until there are any.
    pub fn certificate(&self) -> Option<&Certificate> {
        self.proof.as_ref()
    }

    /// Looks at about `work` more numbers, a few nanoseconds each. Returns whether more work may help.
    pub fn improve(&mut self, work: u32) -> bool {
        self.left += i64::from(work);
        while self.left > 0 && !self.done {
            let done = self.once();
            self.left = self.left.saturating_sub_unsigned(done);
        }
        !self.done
    }

    /// Does one step, or evaluates after [`STEPS`] of them. Returns the work done.
    fn once(&mut self) -> u64 {
        if self.steps < STEPS {
            self.step();
            self.steps += 1;
            if self.steps == STEPS / 2 {
                self.select();
            }
            // An exponential takes about as long as four numbers.
            return (4 * (self.active.len() + self.shares.len())) as u64;
        }
        self.steps = 0;
        self.looks += 1;
        let value = self.look();
        if self.looks.is_multiple_of(2) {
            self.separate();
        }
        if value > self.best * (1.0 + WORTH_PROVING) {
            self.prove(value);
        }
        if self.looks.is_multiple_of(LOOKS) {
            let gained = value - self.before;
            self.before = value;
            let worth = if self.rounds < ROUGH { WORTH_ROUGH } else { WORTH };
            if gained < worth * value.abs() {
                self.cool(value);
            }
        }
        self.select();
        4 * self.numbers() as u64
    }

    /// Lowers the temperature; at the last one, halves pieces and starts a round again.
    fn cool(&mut self, value: f64) {
        self.before = f64::NEG_INFINITY;
        let last = if self.rounds < ROUGH { WARM } else { COLD } * self.mean;
        if self.temperature > last * 1.001 {
            self.temperature = (self.temperature * COOLER).max(last);
            return;
        }
        self.prove(value);
        if self.numbers() < MOST_NUMBERS && self.refine() {
            self.temperature = WARM * self.mean;
            self.rounds += 1;
        } else {
            self.done = true;
        }
    }

    /// Makes room for the numbers of all knots.
    fn lay_out(&mut self) {
        let (base, knots) = bases(&self.items);
        self.base = base;
        self.pay = vec![0.0; knots];
        self.stay = vec![0.0; knots];
    }

    fn numbers(&self) -> usize {
        self.pairs.list.iter().map(|p| self.items[p.items[0]].knots * self.items[p.items[1]].knots).sum()
    }

    /// Takes over what the shares prove, if it is more than before.
    fn prove(&mut self, value: f64) {
        if value <= self.best {
            return;
        }
        let Some(proof) = self.written() else { return };
        if let Ok(seconds) = proof.check(&self.problem)
            && seconds > self.best
        {
            self.best = seconds;
            self.proof = Some(proof);
        }
    }
}
