//! The bound by flows, for hundreds of contours.
//!
//! # The idea
//!
//! A tour visits each item in some **state**: where it stops, and which items it must not visit any more, as far as it remembers
//! (`net.rs`). Give each state at each knot a **potential**. A leg costs its seconds, more by the potential of the state that it leaves and
//! less by that of the state it leads to. Around a tour the potentials cancel, so that it takes what its legs cost. It visits each item once, so that
//!
//! > the sum over all items of the cheapest leg to a state of the item <= travel of the best tour
//!
//! whatever the potentials are. Cuts make it stronger: for a set of items without home, every tour has two legs or more between the set and the
//! rest. Each such leg pays the price of the cut too, and twice the price is added to the sum.
//!
//! The best potentials and prices are the dual solution of a linear programme: a circulation through the states that enters each item once in all,
//! and enters and leaves sets of items. So it is the relaxation of walks (`rounds`), but without the number of stops, which would
//! take as many rows of numbers as there are items: one look at all legs takes milliseconds for 500 contours, where one at all walks takes seconds.
//!
//! Entries anywhere need no more than knots, for the same reason as with walks: potentials between two knots are interpolated, legs between pieces are
//! priced by straight functions (`minorant.rs`), and the least of their sum is at knots.
//!
//! # How the potentials are found
//!
//! The minima are replaced by smooth ones at a temperature, so that each item prefers cheap legs by degrees. A
//! potential moves by the logarithm of the flow that leaves the state, compared with the flow that enters it: generalised iterative scaling (Darroch & Ratcliff,
//! 1972), or the balancing of matrices (Osborne, 1960), which never overshoots (`soft.rs`). Only legs that matter take part, which are selected
//! again and again (`select.rs`). When the temperature has fallen, a round ends (`grow.rs`): walks that follow the flow show
//! which circles must be remembered, and pieces are halved where the flow uses legs that are priced below their real seconds.
//!
//! No part of this needs to be exact: the value of some potentials is worked out over all legs (`exact.rs`), and a certificate of it is added up
//! in whole numbers (`walk_certificate/flows.rs`).
//!
//! Sources: Baldacci, Mingozzi & Roberti (2011) for the memory; Christofides, Mingozzi & Toth (1981) for bounds over state spaces. Potentials of
//! states in place of walks, and their smooth ascent: worked out here.

mod before;
mod cut;
mod cuts;
mod exact;
mod flow;
mod follow;
mod grow;
mod legs;
mod net;
mod reach;
mod record;
mod select;
mod soft;
mod start;

use super::net::{homes, items};
use super::order::Order;
use super::pairs::Pairs;
use super::prices::Prices;
use super::scale::average_leg;
use super::walk_certificate::{FlowCertificate, applies};
use super::walks::Ground;
use crate::problem::Problem;
use before::Before;
use cut::Cut;
use flow::Flow;
use legs::Legs;
use net::Net;
use record::Record;

/// The temperatures as shares of an average leg: the first one, the first of a later round, the last, and the last of all. Below the last one the smooth
/// minimum is nearly the real one, and potentials move slowly.
const HOT: f64 = 0.2;
const WARM: f64 = 0.04;
const COLD: f64 = 0.02;
const COLDEST: f64 = 0.005;
const COOLER: f64 = 0.5;
/// Steps between two evaluations, and between two selections of the legs that matter, which take about as long as five steps.
const STEPS: usize = 50;
const SELECTED: usize = 25;
/// Gain of an evaluation, as a share of the value, that is worth more steps at this temperature; and in the last round.
const WORTH: f64 = 0.01;
const WORTH_LAST: f64 = 0.001;
/// Most items: far legs between all of them are looked at in every evaluation.
const MOST_ITEMS: usize = 2_200;

/// The next piece of work.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Task {
    /// The table of a wanted pair.
    Table(usize),
    Step,
    Nothing,
}

/// The bound by flows. It is valid at any moment and rises with work.
#[derive(Debug)]
pub struct FlowBound {
    problem: Problem,
    ground: Ground,
    net: Net,
    /// The potential of each state and knot, s.
    potentials: Vec<f64>,
    /// For each item what a leg to it costs at least, s.
    pays: Vec<f64>,
    cuts: Vec<Cut>,
    /// For each two items the prices of the cuts between them.
    crossing: Vec<f64>,
    legs: Legs,
    flow: Flow,
    /// Pairs that have tables or shall have them.
    wanted: Vec<[usize; 2]>,
    /// Pairs without tables that hold the value back.
    missing: Vec<[usize; 2]>,
    /// The states before the round, to take over their potentials.
    before: Option<Before>,
    /// The average leg, s.
    mean: f64,
    temperature: f64,
    steps: usize,
    looks: usize,
    /// The smooth value at the evaluation before.
    smooth: f64,
    /// Nothing is left to remember or to halve.
    is_last: bool,
    task: Task,
    left: i64,
    best: f64,
    record: Option<Box<Record>>,
}

impl FlowBound {
    /// Starts with a weak bound; `None` if this bound does not apply: contours may be left unfinished, there are pierce
    /// groups, there are fewer than two items, or too many.
    pub fn new(problem: &Problem) -> Option<Self> {
        if !applies(problem) || problem.items.len() < 2 || problem.items.len() > MOST_ITEMS {
            return None;
        }
        let (items, first, prices) = (items(problem), homes(problem), Prices::new(problem));
        let order = Order::new(problem, first);
        let count = items.len();
        let pairs = Pairs::new(count);
        let ng_sets = vec![Vec::new(); count];
        let ground = Ground { pairs, ng_sets, spaces: Vec::new(), items, first, prices, order };
        let mut bound = Self {
            problem: problem.clone(),
            wanted: start::first_pairs(&ground),
            ground,
            net: Net::default(),
            potentials: Vec::new(),
            pays: vec![0.0; count],
            cuts: Vec::new(),
            crossing: vec![0.0; count * count],
            legs: Legs::default(),
            flow: Flow::default(),
            missing: Vec::new(),
            before: None,
            mean: 0.0,
            temperature: 0.0,
            steps: 0,
            looks: 0,
            smooth: f64::NEG_INFINITY,
            is_last: false,
            task: Task::Table(0),
            left: 0,
            best: 0.0,
            record: None,
        };
        // There is a certificate from the beginning.
        while matches!(bound.task, Task::Table(_)) {
            bound.once();
        }
        Some(bound)
    }

    /// The bound of travel, s.
    pub fn value(&self) -> f64 {
        self.best
    }

    /// The certificate of the best value so far; `None` until there is one. Making it takes as long as checking it.
    pub fn certificate(&self) -> Option<FlowCertificate> {
        self.record.as_ref()?.certificate(&self.problem)
    }

    /// Looks at about `work` more numbers, a few nanoseconds each. Returns whether more work may help.
    pub fn improve(&mut self, work: u32) -> bool {
        self.left += i64::from(work);
        while self.left > 0 && self.task != Task::Nothing {
            let done = self.once();
            self.left = self.left.saturating_sub_unsigned(done.max(1));
        }
        self.task != Task::Nothing
    }

    /// Does one piece of work and returns its size.
    fn once(&mut self) -> u64 {
        match self.task {
            Task::Table(next) => {
                let Some(&ends) = self.wanted.get(next) else { return self.begin() };
                let ground = &mut self.ground;
                ground.pairs.add(&ground.items, &ground.prices, ends, true);
                self.task = Task::Table(next + 1);
                // A price takes about as long as 16 numbers.
                16 * ends.iter().map(|&k| ground.items[k].knots as u64).product::<u64>()
            }
            Task::Step if self.steps < STEPS => {
                self.step();
                self.steps += 1;
                if self.steps == SELECTED {
                    self.select();
                }
                self.legs.work()
            }
            Task::Step => {
                self.steps = 0;
                self.evaluate();
                5 * self.legs.work()
            }
            Task::Nothing => 1,
        }
    }

    /// Begins a round, when all tables are there.
    fn begin(&mut self) -> u64 {
        self.task = Task::Step;
        if !self.lay_out() {
            self.task = Task::Nothing;
            return 1;
        }
        if self.temperature == 0.0 {
            self.reduce();
            let value = self.look();
            let Ground { items, pairs, prices, .. } = &self.ground;
            self.mean = average_leg(value / items.len() as f64, items, pairs, prices);
            self.temperature = HOT * self.mean;
        } else {
            self.look();
        }
        self.select();
        5 * self.legs.work()
    }

    /// Works the value out over all legs, and adds cuts and tables. Lowers the temperature when little is gained.
    fn evaluate(&mut self) {
        let value = self.look();
        self.separate();
        self.looks += 1;
        let gained = self.flow.value - self.smooth;
        self.smooth = self.flow.value;
        let worth = if self.is_last { WORTH_LAST } else { WORTH };
        if gained < worth * value.abs() {
            self.cool();
        }
        if self.task == Task::Step {
            self.select();
        }
    }

    /// Lowers the temperature; at the last one, begins a round.
    fn cool(&mut self) {
        self.smooth = f64::NEG_INFINITY;
        let last = if self.is_last { COLDEST } else { COLD } * self.mean;
        if self.temperature > last * 1.001 {
            self.temperature = (self.temperature * COOLER).max(last);
            self.add_tables();
        } else if self.is_last {
            self.task = Task::Nothing;
        } else if self.grow() {
            self.temperature = WARM * self.mean;
        } else {
            self.is_last = true;
        }
    }
}
