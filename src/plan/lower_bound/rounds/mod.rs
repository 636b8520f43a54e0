//! The strong bound: walks, charges and cuts that drive them to visit every item once (`bundle.rs`, `cuts.rs`), and rounds after which walks
//! remember more and contours are divided more finely (`sharpen.rs`). When few orders can be better than the known path, all of them are enumerated (`close.rs`).

mod bundle;
mod close;
mod cuts;
mod enumerations;
mod excess;
#[cfg(feature = "research")]
mod known;
#[cfg(feature = "research")]
mod learn;
mod ng_sets;
#[cfg(feature = "research")]
mod record;
mod sharpen;
#[cfg(test)]
mod tests;

use super::charges::Charges;
use super::net::{homes, items};
use super::order::Order;
use super::orders::Orders;
use super::pairs::{Pairs, Scan};
use super::prices::Prices;
use super::space::Space;
use super::walks::{Ground, Pass, Visit};
use crate::problem::Problem;
use bundle::Bundle;
use enumerations::{ENUMERATES_ORDERS, Enumerations};
use excess::seconds;
#[cfg(feature = "research")]
use known::Known;
pub(super) use ng_sets::{extend_ng_set, nearest_ng_sets};
#[cfg(feature = "research")]
pub(super) use {excess::legs, record::Record};

/// Most steps of the charges in a round: none needed more than a third of them.
const MOST_LOOKS: usize = 600;
/// A round ends when the next charges promise less than this share of the gap: states multiply with each round, so that charges
/// that have settled are cheaper than memory.
const WORTH: f64 = 0.01;
/// Most numbers in the rows of a pass, and most states: about 100 MB.
const MOST_NUMBERS: usize = 12_000_000;

/// The next piece of work.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Task {
    Scan,
    Table(usize),
    Spaces,
    Row(usize),
    Meet,
    Orders,
    Nothing,
}

/// The computation of the strong bound.
#[derive(Debug)]
pub(super) struct Strong {
    ground: Ground,
    scan: Scan,
    /// Pairs to have tables.
    wanted: Vec<[usize; 2]>,
    task: Task,
    passes: [Pass; 2],
    /// The charges that walks are looked for with now.
    charges: Charges,
    bundle: Bundle,
    best: f64,
    /// What the best walks were looked for with.
    #[cfg(feature = "research")]
    pub(super) record: Option<Box<Record>>,
    looks: usize,
    walks: Vec<(f64, Vec<Visit>)>,
    /// The ng-sets in the round before.
    ng_sets_before: Vec<Vec<usize>>,
    /// The best path that is known with its best entries.
    #[cfg(feature = "research")]
    known: Known,
    /// There are no cuts any more, see [`Strong::begin_orders`].
    without_cuts: bool,
    /// Walks cannot remember more: there would be too many states.
    full: bool,
    /// The enumeration of all orders, while there is one, and what is known of enumerations.
    orders: Option<Box<Orders>>,
    enumerations: Enumerations,
    /// Work done, and the part of it that went to enumerations.
    work: u64,
    on_orders: u64,
}

impl Strong {
    pub(super) fn new(problem: &Problem) -> Self {
        let items = items(problem);
        let count = items.len();
        let first = homes(problem);
        let prices = Prices::new(problem);
        let order = Order::new(problem, first);
        let scan = Scan::new(&items, first);
        let ground = Ground {
            pairs: Pairs::new(count),
            ng_sets: vec![Vec::new(); count],
            spaces: Vec::new(),
            items,
            first,
            prices,
            order,
        };
        Self {
            ground,
            scan,
            wanted: Vec::new(),
            task: Task::Scan,
            passes: <[Pass; 2]>::default(),
            charges: Charges::none(count),
            bundle: Bundle::new(Charges::none(count), 0.0),
            best: 0.0,
            #[cfg(feature = "research")]
            record: None,
            looks: 0,
            walks: Vec::new(),
            ng_sets_before: vec![Vec::new(); count],
            #[cfg(feature = "research")]
            known: Known::default(),
            without_cuts: false,
            full: false,
            orders: None,
            enumerations: Enumerations::default(),
            work: 0,
            on_orders: 0,
        }
    }

    pub(super) fn value(&self) -> f64 {
        self.best
    }

    /// Does one piece of work and returns its size; 0 if nothing is left to do.
    pub(super) fn once(&mut self, upper: f64) -> u64 {
        #[cfg(feature = "research")]
        let upper = upper.min(self.known.path.seconds);
        let work = self.task(upper);
        self.work += work;
        work
    }

    fn task(&mut self, upper: f64) -> u64 {
        match self.task {
            Task::Scan => {
                let ground = &self.ground;
                if let Some(work) = self.scan.next(&ground.items, ground.first, &ground.prices) {
                    return work;
                }
                self.wanted = self.scan.wanted(ground.first, ground.items.len());
                if ground.prices.directed() {
                    let back: Vec<_> = self.wanted.iter().map(|&[a, b]| [b, a]).collect();
                    self.wanted.extend(back);
                }
                #[cfg(feature = "research")]
                self.take_in_round();
                self.task = Task::Table(0);
                1
            }
            Task::Table(next) => {
                let Some(&[a, b]) = self.wanted.get(next) else {
                    self.task = Task::Spaces;
                    return 1;
                };
                let ground = &mut self.ground;
                ground.pairs.add(&ground.items, &ground.prices, [a, b], true);
                self.task = Task::Table(next + 1);
                // A price takes about as long as 16 numbers of a row.
                16 * (ground.items[a].knots * ground.items[b].knots) as u64
            }
            Task::Spaces => self.new_spaces(),
            Task::Row(side) => {
                self.ground.advance(side, &mut self.passes[side], &self.charges);
                if self.passes[side].rows() >= self.ground.stops()[side] {
                    self.task =
                        if side + 1 < self.ground.spaces.len() { Task::Row(side + 1) } else { Task::Meet };
                }
                self.ground.work(side)
            }
            Task::Meet => {
                self.task = Task::Row(0);
                let work = self.look(upper);
                self.passes = <[Pass; 2]>::default();
                work
            }
            Task::Orders if ENUMERATES_ORDERS => self.enumerate_orders(upper),
            Task::Orders | Task::Nothing => 0,
        }
    }

    /// Lays out the states of the walks. If there would be too many, the ng-sets of the round before are restored for good.
    fn new_spaces(&mut self) -> u64 {
        let ground = &mut self.ground;
        if ground.ng_sets.iter().all(Vec::is_empty) {
            ground.ng_sets = nearest_ng_sets(&ground.items, ground.first, &ground.pairs);
        }
        let symmetric = ground.first == 1 && ground.order.is_free() && !ground.prices.directed();
        let sides = if symmetric { 0..1 } else { 0..2 };
        let spaces: Option<Vec<Space>> = sides.map(|side| ground.space(side == 1)).collect();
        if let Some(mut spaces) = spaces {
            spaces.iter_mut().for_each(|s| s.lay_out(|i| ground.items[i].knots));
            ground.spaces = spaces;
            self.task = if self.enumerations.has_begun {
                Task::Orders
            } else {
                // Given prices stay, and home may be several points then.
                if !ground.prices.given() {
                    self.bundle.price(|walk| seconds(walk, ground));
                }
                Task::Row(0)
            };
        } else if self.full {
            self.task = Task::Nothing;
        } else {
            ground.ng_sets.clone_from(&self.ng_sets_before);
            self.full = true;
        }
        let ground = &self.ground;
        (ground.items.len() * (1 + ground.spaces.iter().map(|s| s.states.len()).sum::<usize>())) as u64
    }

    /// What rounding can add to a value: each of at most 2 n sums of a walk is off by a part in 2^53 of at most n charges or prices
    /// and all legs.
    pub(super) fn guard(&self, charges: &Charges, value: f64) -> f64 {
        let all: f64 = charges.values().iter().map(|p| p.abs()).sum();
        let stops = self.ground.count() as f64;
        2.0 * (stops + 2.0) * f64::EPSILON * (stops * all + value.abs())
    }

    /// Evaluates the walks that the passes found, and moves the charges. Returns the work done.
    fn look(&mut self, upper: f64) -> u64 {
        let found = self.ground.meet(&self.passes, &self.charges);
        let Some(least) = found.first() else {
            // There is no walk: precedence leaves no tour, and nothing can be proven.
            self.task = Task::Nothing;
            return 1;
        };
        let value = least.value - self.charges.back();
        let guard = self.guard(&self.charges, value);
        #[cfg(feature = "research")]
        if value - guard > self.best {
            self.record = Some(Box::new(Record::new(value - guard, &self.ground, &self.charges)));
        }
        self.best = self.best.max(value - guard);
        self.looks += 1;
        let mut work = self.ground.work_of_meeting(found.len());
        work += self.bundle.learn(&mut self.charges, value, &found, (self.ground.first, upper));
        if self.best >= upper * (1.0 - self.exact()) {
            self.task = Task::Nothing;
        } else if self.has_settled(upper) {
            work += self.separate(upper);
            if self.has_settled(upper) {
                self.next_round(upper);
            }
        }
        work
    }

    /// Whether other charges promise next to nothing.
    fn has_settled(&self, upper: f64) -> bool {
        self.looks >= MOST_LOOKS || self.bundle.promised() < WORTH * (upper - self.bundle.value)
    }

    /// Enumerates all orders if few may be left, and begins a round otherwise.
    fn next_round(&mut self, upper: f64) {
        #[cfg(feature = "research")]
        if self.take_in_round() {
            self.begin_round(true);
            return;
        }
        if !self.begin_orders(upper, false) {
            self.sharpen(upper);
        }
    }

    /// Begins a round with more memory where walks went in circles, and halved pieces where legs lost seconds.
    fn sharpen(&mut self, upper: f64) {
        self.ng_sets_before.clone_from(&self.ground.ng_sets);
        self.walks = self.bundle.mixture();
        let fuller = !self.full && self.remember();
        let nearer = self.give_tables();
        let finer = self.refine(upper);
        if !(fuller || finer || nearer) || self.width() * self.ground.count() / 2 > MOST_NUMBERS {
            if !self.begin_orders(upper, true) {
                self.task = Task::Nothing;
            }
            return;
        }
        self.begin_round(finer || nearer);
    }

    /// Begins a round with the best charges. `finer`: tables are made again.
    fn begin_round(&mut self, finer: bool) {
        self.charges.clone_from(&self.bundle.best);
        let ground = &self.ground;
        self.bundle.begin_round(|walk| ground.is_walk(walk));
        self.looks = 0;
        self.prepare(finer);
    }

    /// Makes the tables again if there are new knots, and then the states.
    fn prepare(&mut self, finer: bool) {
        if finer {
            self.ground.pairs = Pairs::new(self.ground.items.len());
            self.task = Task::Table(0);
        } else {
            self.task = Task::Spaces;
        }
    }

    /// Numbers in a row of walks, and legs between states.
    fn width(&self) -> usize {
        self.ground.spaces.iter().map(|s| s.width + s.steps.len()).sum()
    }
}
