//! The strong bound: walks, charges that drive them to visit every item once, and rounds after which walks remember more and
//! contours are divided more finely. When few orders can be better than the known path, all of them are looked at (`close.rs`).

mod close;
mod company;
mod looks;
mod sharpen;

use super::net::{homes, items};
use super::order::Order;
use super::orders::Orders;
use super::pairs::{Pairs, Scan};
use super::prices::Prices;
use super::space::Space;
use super::walks::{Ground, Pass, Visit};
use crate::problem::Problem;
use company::nearest_company;
use looks::{LOOKS_AT_ORDERS, Looks};

/// Fewest and most steps of the charges in a round.
const LOOKS: [usize; 2] = [8, 60];
/// A round ends when this many steps gain less than this share of the gap: charges need not be exact for the next round.
const WORTH: (usize, f64) = (4, 0.1);
/// The last walks of a round that are kept: the next round learns from them.
const KEPT: usize = 12;
/// Steps without a better value after which steps get shorter.
const PATIENCE: usize = 8;
/// Factor by which steps then get shorter.
const SHORTER: f64 = 0.6;
/// Share of the last direction that is kept in the next one: it damps oscillation.
const KEEP: f64 = 0.5;
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
    /// The charge of each item for a stop, now and at the best value.
    pay: Vec<f64>,
    best_pay: Vec<f64>,
    way: Vec<f64>,
    share: f64,
    best: f64,
    round_best: f64,
    stalled: usize,
    looks: usize,
    /// The best value of the round some looks ago.
    before: f64,
    walks: Vec<Vec<Visit>>,
    /// The company of each item in the round before.
    company_before: Vec<Vec<usize>>,
    /// Walks cannot remember more: there would be too many states.
    full: bool,
    /// The look at all orders, while there is one, and what is known of such looks.
    orders: Option<Box<Orders>>,
    looked: Looks,
    /// Work done, and the part of it that went to looks at all orders.
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
            company: vec![Vec::new(); count],
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
            pay: vec![0.0; count],
            best_pay: vec![0.0; count],
            way: vec![0.0; count],
            share: 1.0,
            best: 0.0,
            round_best: f64::NEG_INFINITY,
            stalled: 0,
            looks: 0,
            before: f64::NEG_INFINITY,
            walks: Vec::new(),
            company_before: vec![Vec::new(); count],
            full: false,
            orders: None,
            looked: Looks::default(),
            work: 0,
            on_orders: 0,
        }
    }

    pub(super) fn value(&self) -> f64 {
        self.best
    }

    /// Does one piece of work and returns its size; 0 if nothing is left to do.
    pub(super) fn once(&mut self, upper: f64) -> u64 {
        let work = self.task(upper);
        self.work += work;
        work
    }

    fn task(&mut self, upper: f64) -> u64 {
        match self.task {
            Task::Scan => {
                let ground = &self.ground;
                self.scan.next(&ground.items, ground.first, &ground.prices).unwrap_or_else(|| {
                    self.wanted = self.scan.wanted(ground.first, ground.items.len());
                    if ground.prices.directed() {
                        let back: Vec<_> = self.wanted.iter().map(|&[a, b]| [b, a]).collect();
                        self.wanted.extend(back);
                    }
                    self.task = Task::Table(0);
                    1
                })
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
                self.ground.advance(side, &mut self.passes[side], &self.pay);
                if self.passes[side].rows() >= self.ground.stops()[side] {
                    self.task =
                        if side + 1 < self.ground.spaces.len() { Task::Row(side + 1) } else { Task::Meet };
                }
                self.ground.work(side)
            }
            Task::Meet => {
                self.task = Task::Row(0);
                self.look(upper);
                self.passes = <[Pass; 2]>::default();
                1
            }
            Task::Orders if LOOKS_AT_ORDERS => self.look_at_orders(upper),
            Task::Orders | Task::Nothing => 0,
        }
    }

    /// Lays out the states of the walks. If there would be too many, the company of the round before is restored for good.
    fn new_spaces(&mut self) -> u64 {
        let ground = &mut self.ground;
        if ground.company.iter().all(Vec::is_empty) {
            ground.company = nearest_company(&ground.items, ground.first, &ground.pairs);
        }
        let symmetric = ground.first == 1 && ground.order.is_free() && !ground.prices.directed();
        let sides = if symmetric { 0..1 } else { 0..2 };
        let spaces: Option<Vec<Space>> = sides.map(|side| ground.space(side == 1)).collect();
        if let Some(mut spaces) = spaces {
            spaces.iter_mut().for_each(|s| s.lay_out(|i| ground.items[i].knots));
            ground.spaces = spaces;
            self.task = if self.looked.has_begun { Task::Orders } else { Task::Row(0) };
        } else if self.full {
            self.task = Task::Nothing;
        } else {
            ground.company.clone_from(&self.company_before);
            self.full = true;
        }
        let ground = &self.ground;
        (ground.items.len() * (1 + ground.spaces.iter().map(|s| s.states.len()).sum::<usize>())) as u64
    }

    /// What rounding can add to a value: each of at most 2 n sums of a walk is off by a part in 2^53 of at most n charges and
    /// all legs.
    pub(super) fn guard(&self, pay: &[f64], value: f64) -> f64 {
        let largest = pay.iter().fold(0.0_f64, |m, p| m.max(p.abs()));
        let stops = self.ground.count() as f64;
        2.0 * (stops + 2.0) * f64::EPSILON * (stops * largest + value.abs())
    }

    /// Evaluates the walk that the passes found, and moves the charges.
    fn look(&mut self, upper: f64) {
        let Some((sum, walk)) = self.ground.meet(&self.passes, &self.pay) else {
            // There is no walk: precedence leaves no tour, and nothing can be proven.
            self.task = Task::Nothing;
            return;
        };
        let first = self.ground.first;
        let charges: f64 = self.pay[first..].iter().sum();
        let value = sum - charges;
        let guard = self.guard(&self.pay, value);
        let mut way = vec![-1.0; self.pay.len()];
        for v in &walk {
            way[v.item] += 1.0;
        }
        let tour = way[first..].iter().all(|&w| w == 0.0);
        self.best = self.best.max(value - guard);
        if value > self.round_best + 1e-6 * value.abs() {
            self.round_best = value;
            self.best_pay.clone_from(&self.pay);
            self.stalled = 0;
        } else {
            self.stalled += 1;
            if self.stalled >= PATIENCE {
                self.stalled = 0;
                self.share *= SHORTER;
                self.pay.clone_from(&self.best_pay);
                self.way.fill(0.0);
            }
        }
        self.walks.push(walk);
        if self.walks.len() > KEPT {
            self.walks.remove(0);
        }
        self.looks += 1;
        if self.best >= upper * (1.0 - self.exact()) {
            self.task = Task::Nothing;
        } else if tour || self.settled(upper) {
            self.next_round(upper);
        } else {
            let mut norm = 0.0;
            for (w, d) in self.way.iter_mut().zip(&way).skip(first) {
                *w = *w * KEEP + d;
                norm += *w * *w;
            }
            // Towards the known cost, or a little beyond the bound if the cost is not above it.
            let target = upper.max(value + 1e-3 * value.abs());
            if norm > 0.0 {
                let by = self.share * (target - value) / norm;
                for (p, w) in self.pay.iter_mut().zip(&self.way).skip(first) {
                    *p += by * w;
                }
            }
        }
    }

    /// Whether a round gains no more.
    fn settled(&mut self, upper: f64) -> bool {
        if !self.looks.is_multiple_of(WORTH.0) {
            return self.looks >= LOOKS[1];
        }
        let gained = self.round_best - self.before;
        self.before = self.round_best;
        self.looks >= LOOKS[0] && gained < WORTH.1 * (upper - self.round_best)
    }

    /// Looks at all orders if few may be left, and begins a round otherwise.
    fn next_round(&mut self, upper: f64) {
        if !self.begin_orders(upper, false) {
            self.sharpen(upper);
        }
    }

    /// Begins a round with more memory where walks went in circles, and halved pieces where legs lost seconds.
    fn sharpen(&mut self, upper: f64) {
        self.company_before.clone_from(&self.ground.company);
        let fuller = !self.full && self.remember();
        let finer = self.refine(upper);
        if !(fuller || finer) || self.width() * self.ground.count() / 2 > MOST_NUMBERS {
            if !self.begin_orders(upper, true) {
                self.task = Task::Nothing;
            }
            return;
        }
        self.pay.clone_from(&self.best_pay);
        self.way.fill(0.0);
        self.round_best = f64::NEG_INFINITY;
        (self.looks, self.stalled, self.before) = (0, 0, f64::NEG_INFINITY);
        // The charges are nearly right already: a third of the first step is enough to follow.
        self.share = 0.3;
        self.walks.clear();
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
