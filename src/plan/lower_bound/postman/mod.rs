//! The bound by stops, for contours that may be left and resumed and for pierce groups.
//!
//! # The relaxation
//!
//! Contours that may be left make the problem a rural postman problem: contours are edges that must be cut, and the air moves
//! connect them. A **stop** is a place where a contour is entered or left (`stops.rs`); two legs end at it, because a contour is
//! resumed where it was left and finished where it was begun. An item has a stop, and more of them if it is left. So a plan is a
//! graph of legs with two legs for each stop, which is connected if the stops of one item count as joined.
//!
//! Let each knot have a **potential** u, such that a leg between two knots takes at least the sum of theirs. Then a stop is worth the
//! two potentials of its legs, and
//!
//! > the sum over all items of their cheapest stop <= travel of the best plan
//!
//! provided that no further stop is worth less than nothing.
//!
//! # Connectivity
//!
//! Divide all places into parts (`cut.rs`). The legs between parts and the items with stops in several parts must connect all parts
//! in which there are stops. A connected graph of legs with two at each stop that touches m parts has at least m legs between them, so it
//! joins m - 1 parts at a price of m legs. An item joins as many parts as it has stops in different parts, less one. Hence for p parts,
//! one of which holds home,
//!
//! > (p - 1) / p * (legs between parts) + (further stops of items that lie in several parts) >= (parts with stops, without that of home)
//!
//! A part has stops if an item lies in it whole; otherwise the stops of one of its items there are counted, which is no more, because
//! a second stop of an item in one part joins nothing. With two parts and whole items this is the usual connectivity cut: two
//! legs at least. With parts that are narrow gaps between large contours it says what a cut of whole items cannot: whoever goes there and
//! back through gaps pays each gap twice.
//!
//! The best potentials and prices are the dual solution of a linear programme, and found like the shares (`shares/mod.rs`): the minima are
//! replaced by smooth ones at a temperature that falls (`soft.rs`), cuts are added where the smooth solution is torn
//! (`separate.rs`), and pieces of contours are halved. No part of this needs to be exact: what counts is the [`StopCertificate`] of
//! the repaired numbers (`repair.rs`), added up in whole numbers.
//!
//! Sources: Corberan, Letchford & Sanchis (2001) for the polyhedron of the problem; Ghiani & Laporte (2000) for contracting what is connected.
//! The parts with further stops: worked out here.

mod cut;
mod groups;
mod halve;
mod proof;
mod repair;
mod separate;
mod soft;
mod stops;
mod tables;

use super::certificate::unit;
use super::net::Item;
use super::pairs::Pairs;
use super::prices::Prices;
use super::scale::average_leg;
use super::stop_certificate::StopCertificate;
use crate::problem::Problem;
use cut::{Leg, Partition};
pub(super) use stops::{Member, Stop, Stops, applies, members};

/// The temperatures as shares of an average leg, as in `shares/mod.rs`: the first one, the last of the first round, and the last of all.
const HOT: f64 = 0.05;
const WARM: f64 = 0.02;
const COLD: f64 = 0.001;
const COOLER: f64 = 0.5;
/// By what the temperature is raised after pieces were halved: it moves potentials to where the new knots need them.
const WARMER: f64 = 4.0;
/// Factor between the last temperatures of two rounds: more knots have more legs at hand, each of which is used a little. While pieces are
/// long, it is soon more worth to halve them.
const COOLER_ROUND: f64 = 0.6;
const COOLER_ROUGH: f64 = 0.8;
/// Steps between two evaluations.
const STEPS: usize = 50;
/// Evaluations after which the gain is looked at, and the share of the value that is worth more steps at this temperature.
const EVALUATIONS: usize = 4;
const WORTH: f64 = 0.003;
const WORTH_ROUGH: f64 = 0.02;
/// Rounds with pieces that are still long: they end at temperatures that fall slowly, and are over sooner.
const ROUGH: usize = 4;
/// Gain for which a certificate is written and checked.
const WORTH_PROVING: f64 = 0.005;
/// Most numbers in the tables of legs: 64 MB.
const MOST_NUMBERS: usize = 8_000_000;
/// Pieces are halved while more than this share of the bound is lost between knots.
const LOST: f64 = 0.001;

/// The bound by stops. It is valid at any moment and rises with work.
#[derive(Debug)]
pub struct StopBound {
    problem: Problem,
    members: Vec<Member>,
    first: usize,
    prices: Prices,
    pairs: Pairs,
    /// Where the knots of each item start in the lists by knot.
    base: Vec<usize>,
    /// By knot: the first knot of its place.
    place: Vec<usize>,
    /// By knot: its potential, what a stop there pays to cuts, how often the smooth solution stops there, how many legs these stops ask for,
    /// and how many there are.
    potential: Vec<f64>,
    pay: Vec<f64>,
    stay: Vec<f64>,
    wanted: Vec<f64>,
    offered: Vec<f64>,
    /// By item: what each further stop gets back from cuts, and how many of them there are.
    refund: Vec<f64>,
    again: Vec<f64>,
    cuts: Vec<Partition>,
    /// Legs that are not much too expensive, pair by pair, and where those of each pair start.
    active: Vec<Leg>,
    starts: Vec<usize>,
    /// For each of them the prices of the cuts it crosses, their number, and how much it is used.
    credit: Vec<f64>,
    crossed: Vec<f64>,
    uses: Vec<f64>,
    /// The average leg, s.
    mean: f64,
    temperature: f64,
    steps: usize,
    evaluations: usize,
    /// Work of the last look at repaired numbers, and of the steps since then.
    look_work: u64,
    since_look: u64,
    rounds: usize,
    /// The value of the smooth problem, which rises at each temperature, and what it was before the last steps.
    smooth: f64,
    before: f64,
    done: bool,
    left: i64,
    proof: Option<StopCertificate>,
    best: f64,
}

impl StopBound {
    /// Starts with a weak bound; `None` if this bound does not apply: no contour may be left and there are no pierce groups, or travel is
    /// given by a table.
    pub fn new(problem: &Problem) -> Option<Self> {
        if !applies(problem) {
            return None;
        }
        let (members, first) = (members(problem), super::net::homes(problem));
        let prices = Prices::new(problem);
        let items: Vec<Item> = members.iter().map(|m| m.item.clone()).collect();
        let guard = unit(&items, &prices, problem).1;
        let prices = prices.none_below(guard);
        let count = members.len();
        let mut bound = Self {
            problem: problem.clone(),
            members,
            first,
            prices,
            pairs: Pairs::new(count),
            base: Vec::new(),
            place: Vec::new(),
            potential: Vec::new(),
            pay: Vec::new(),
            stay: Vec::new(),
            wanted: Vec::new(),
            offered: Vec::new(),
            refund: vec![0.0; count],
            again: vec![0.0; count],
            cuts: Vec::new(),
            active: Vec::new(),
            starts: Vec::new(),
            credit: Vec::new(),
            crossed: Vec::new(),
            uses: Vec::new(),
            mean: 1.0,
            temperature: 1.0,
            steps: 0,
            evaluations: 0,
            look_work: 0,
            since_look: 0,
            rounds: 0,
            smooth: 0.0,
            before: f64::NEG_INFINITY,
            done: count <= first,
            left: 0,
            proof: None,
            best: 0.0,
        };
        if bound.done {
            return Some(bound);
        }
        bound.pairs = Pairs::first(&items, first, &bound.prices);
        bound.lay_out();
        bound.potential = bound.half_legs();
        bound.look_work = bound.look();
        bound.mean = average_leg(bound.best / count as f64, &items, &bound.pairs, &bound.prices);
        bound.temperature = HOT * bound.mean;
        bound.select();
        Some(bound)
    }

    /// The bound of travel, s: of all that a plan takes beyond [`Problem::paid`].
    pub fn value(&self) -> f64 {
        self.best
    }

    /// The numbers that prove the bound; `None` until there are any.
    pub fn certificate(&self) -> Option<&StopCertificate> {
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
        if self.steps >= STEPS {
            return self.evaluate();
        }
        let work = self.one_step();
        self.since_look += work;
        work
    }

    fn one_step(&mut self) -> u64 {
        self.step();
        self.steps += 1;
        let selecting = if self.steps == STEPS / 2 { self.select() } else { 0 };
        let crossing: usize = self.cuts.iter().map(|c| c.crossing.len()).sum();
        selecting + (4 * (self.active.len() + self.potential.len()) + 2 * crossing) as u64
    }

    /// Adds cuts and lowers the temperature where the smooth value rises slowly. Repaired numbers are looked at before that, and when the steps
    /// since the last look took as long as it did.
    fn evaluate(&mut self) -> u64 {
        self.steps = 0;
        self.evaluations += 1;
        let mut cooler = false;
        if self.evaluations.is_multiple_of(EVALUATIONS) {
            let gained = self.smooth - self.before;
            self.before = self.smooth;
            let worth = if self.rounds < ROUGH { WORTH_ROUGH } else { WORTH };
            cooler = gained < worth * self.best.max(self.mean);
        }
        let mut work = 0;
        if cooler || self.since_look >= self.look_work {
            work += self.look();
            (self.look_work, self.since_look) = (work, 0);
        }
        if self.evaluations.is_multiple_of(2) {
            self.separate();
        }
        if cooler {
            self.cool();
        }
        work + self.select()
    }

    /// Lowers the temperature; at the last one, halves pieces and starts a round again.
    fn cool(&mut self) {
        self.before = f64::NEG_INFINITY;
        let cooler = |round: usize| if round < ROUGH { COOLER_ROUGH } else { COOLER_ROUND };
        let last = (0..self.rounds).fold(WARM, |t, round| t * cooler(round)).max(COLD) * self.mean;
        if self.temperature > last * 1.001 {
            self.temperature = (self.temperature * COOLER).max(last);
            return;
        }
        if self.numbers() < MOST_NUMBERS && self.refine() {
            self.temperature *= WARMER;
        } else if self.temperature <= 1.001 * COLD * self.mean {
            self.done = true;
        }
        self.rounds += 1;
    }
}
