//! The cheap bound: a minimum tree over the items with one more leg, priced by the least seconds between items.
//!
//! This is Held & Karp's ascent (1970): each item charges the legs that end at it, until the minimum tree with two legs of
//! home has nearly two legs at each item. The steps use the pairs with known prices. From time to time a tree over all pairs
//! shows what is proven and which pairs are missing.

use super::net::{Item, homes, items};
use super::pairs::{Pairs, Scan};
use super::prices::Prices;
use super::tree::{Whole, home_legs, over_pairs};
use crate::problem::Problem;

/// Steps between two trees over all pairs: more gain little, because the step length shrinks.
const STEPS: usize = 120;
/// Trees over all pairs: the first shows that all items are connected, and after the fourth little is gained.
const LOOKS: usize = 4;
/// First step of a charge, as a share of the average leg: longer overshoots, shorter takes more steps.
const STRIDE: f64 = 0.1;
/// Factor by which a step shrinks: over [`STEPS`] to a fiftieth, which no longer matters.
const SHRINK: f64 = 0.968;
/// Share of the last direction that is kept in the next (Volgenant & Jonker, 1982).
const KEEP: f64 = 0.7;

#[derive(Debug)]
enum Task {
    Scan(Box<Scan>),
    Price(Vec<[usize; 2]>),
    Step(usize),
    Whole(Box<Whole>),
    Nothing,
}

/// The computation of the cheap bound.
#[derive(Debug)]
pub(super) struct Cheap {
    items: Vec<Item>,
    first: usize,
    prices: Prices,
    pairs: Pairs,
    /// Contours may be left and resumed: charges must not be rebates, see [`super`].
    resumes: bool,
    /// Least seconds from each item to any other.
    nearest: Vec<f64>,
    task: Task,
    pay: Vec<f64>,
    way: Vec<f64>,
    best_pay: Vec<f64>,
    round_best: f64,
    stride: f64,
    looks: usize,
    best: f64,
}

impl Cheap {
    pub(super) fn new(problem: &Problem, resumes: bool) -> Self {
        let items = items(problem);
        let count = items.len();
        let first = homes(problem);
        let prices = Prices::new(problem);
        Self {
            pairs: Pairs::new(count),
            task: Task::Scan(Box::new(Scan::new(&items, first))),
            items,
            first,
            prices,
            resumes,
            nearest: Vec::new(),
            pay: vec![0.0; count],
            way: vec![0.0; count],
            best_pay: vec![0.0; count],
            round_best: f64::NEG_INFINITY,
            stride: 0.0,
            looks: 0,
            best: 0.0,
        }
    }

    pub(super) fn value(&self) -> f64 {
        self.best
    }

    /// Does one piece of work and returns its size; 0 if nothing is left to do.
    pub(super) fn once(&mut self) -> u64 {
        let task = std::mem::replace(&mut self.task, Task::Nothing);
        let (task, work) = match task {
            Task::Scan(mut scan) => match scan.next(&self.items, self.first, &self.prices) {
                Some(work) => (Task::Scan(scan), work),
                None => {
                    self.nearest = std::mem::take(&mut scan.nearest);
                    (Task::Price(scan.wanted(self.first, self.items.len())), 1)
                }
            },
            Task::Price(mut wanted) => match wanted.pop() {
                Some(ends) => {
                    self.pairs.add(&self.items, &self.prices, ends, false);
                    (Task::Price(wanted), 16 * (self.items[ends[0]].knots * self.items[ends[1]].knots) as u64)
                }
                None if self.looks == 0 => {
                    (Task::Whole(Box::new(Whole::new(self.first, self.items.len()))), 1)
                }
                None => (Task::Step(0), 1),
            },
            Task::Step(done) => {
                self.step(done);
                let whole = || Task::Whole(Box::new(Whole::new(self.first, self.items.len())));
                (
                    if done + 1 < STEPS { Task::Step(done + 1) } else { whole() },
                    16 * self.pairs.list.len() as u64,
                )
            }
            Task::Whole(mut whole) => {
                let costs = self.costs(&self.best_pay);
                let mut work = costs.len() as u64;
                // Many rows at a time, because they share the costs.
                for _ in 0..64 {
                    work += 4 * self.items.len() as u64;
                    if whole.row(&self.items, &self.prices, &self.pairs, &costs, &self.best_pay) {
                        let next = self.prove(&whole, &costs);
                        self.task = next;
                        return work;
                    }
                }
                (Task::Whole(whole), work)
            }
            Task::Nothing => (Task::Nothing, 0),
        };
        self.task = task;
        work
    }

    fn costs(&self, pay: &[f64]) -> Vec<f64> {
        self.pairs.list.iter().map(|p| p.least + pay[p.items[0]] + pay[p.items[1]]).collect()
    }

    /// A step of the ascent.
    fn step(&mut self, done: usize) {
        let costs = self.costs(&self.pay);
        let mut legs = over_pairs(&self.pairs, self.first, &costs);
        legs.extend(home_legs(&self.pairs, self.first, &costs, self.resumes));
        let seconds: f64 = legs.iter().map(|&e| costs[e]).sum();
        let value = seconds - 2.0 * self.pay.iter().sum::<f64>();
        if done == 0 {
            let count = self.items.len() as f64;
            self.stride = STRIDE * legs.iter().map(|&e| self.pairs.list[e].least).sum::<f64>() / count;
            self.round_best = f64::NEG_INFINITY;
            self.way.fill(0.0);
        }
        if value > self.round_best {
            self.round_best = value;
            self.best_pay.clone_from(&self.pay);
        }
        self.way.iter_mut().for_each(|w| *w = *w * KEEP - 2.0);
        for &e in &legs {
            for item in self.pairs.list[e].items {
                self.way[item] += 1.0;
            }
        }
        for ((p, w), near) in self.pay.iter_mut().zip(&self.way).zip(&self.nearest).skip(self.first) {
            *p += self.stride * w;
            if self.resumes {
                *p = p.clamp(-0.5 * near, 0.0);
            }
        }
        self.stride *= SHRINK;
    }

    /// Takes over what the tree over all pairs proves; returns the next task.
    fn prove(&mut self, whole: &Whole, costs: &[f64]) -> Task {
        let home = home_legs(&self.pairs, self.first, costs, self.resumes);
        let charges: f64 = self.best_pay.iter().sum();
        let value = whole.cost + home.iter().map(|&e| costs[e]).sum::<f64>() - 2.0 * charges;
        let largest = self.best_pay.iter().fold(0.0_f64, |m, p| m.max(p.abs()));
        let count = self.items.len() as f64;
        self.best = self.best.max(value - 4.0 * count * f64::EPSILON * (count * largest + value.abs()));
        self.looks += 1;
        if self.looks >= LOOKS {
            return Task::Nothing;
        }
        self.pay.clone_from(&self.best_pay);
        Task::Price(whole.missing.iter().map(|&(a, b)| [a.min(b), a.max(b)]).collect())
    }
}
