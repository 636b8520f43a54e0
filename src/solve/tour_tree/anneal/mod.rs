//! The search itself: local kicks, accepted by a falling temperature, in cycles that grow.
//!
//! A kick exchanges two neighbouring stretches of the tour (a segment double-bridge: feasible with precedence, and no
//! local move undoes it at once), the local search mends what was touched, and the result is kept if it is no worse,
//! or worse by less than a random amount that the temperature allows (Metropolis); otherwise the journal takes it
//! back. Nothing depends on the size of the sheet but the lengths of the stretches.
//!
//! * [`cycles`]: how long they are, how warm, and what they end in. [`kick`]: one kick.

mod cycles;
mod kick;

use super::crossing::Elites;
use super::entries::Layers;
use super::few::is_few;
use super::improve::improve;
use super::kept::Kept;
use super::neighbours::Neighbours;
use super::queue::Queue;
use super::tour::Tour;
use crate::solve::epsilon::EPSILON;
use crate::solve::rng::Rng;

/// The best of a part of a cycle; `unsaved` while the tour itself is the best.
struct Top {
    cost: f64,
    kept: Kept,
    unsaved: bool,
}

/// What comes next.
enum Stage {
    /// Neighbours are listed.
    Listing,
    /// The whole tour is improved locally.
    Settling,
    /// Kicks.
    Kicking,
    /// What they ended in is crossed with the tour of this number; the seconds it cost before the first.
    Crossing(usize, f64),
}

/// The search over one tour.
pub(super) struct Annealing<'p> {
    tour: Tour<'p>,
    near: Neighbours,
    queue: Queue,
    layers: Layers,
    elites: Elites,
    rng: Rng,
    stage: Stage,
    /// Seconds of the tour as it is.
    cost: f64,
    top: Top,
    /// Best feasible one.
    best: (f64, Kept),
    cycle: u32,
    kicks: u64,
    kicks_wanted: u64,
    /// Mean way between neighbours, s; known after the first settling.
    mean: Option<f64>,
    temperature: f64,
    /// Kicks of this part that rebuild, percent.
    rebuilds: usize,
    /// Few items, none of them entered just anywhere: see `few.rs`.
    few: bool,
}

impl<'p> Annealing<'p> {
    /// From a feasible tour.
    pub(super) fn new(mut tour: Tour<'p>, rng: Rng) -> Self {
        let near = Neighbours::new(&tour.space);
        let queue = Queue::new(tour.space.home as usize + 1);
        let (cost, kept) = (tour.cost(), tour.now().clone());
        tour.free = false;
        let space = &tour.space;
        let few = is_few(space, tour.last());
        Self {
            tour,
            near,
            queue,
            layers: Layers::default(),
            elites: Elites::default(),
            rng,
            stage: Stage::Listing,
            cost,
            top: Top { cost, kept: kept.clone(), unsaved: false },
            best: (cost, kept),
            cycle: 0,
            kicks: 0,
            kicks_wanted: 0,
            mean: None,
            temperature: 0.0,
            rebuilds: 0,
            few,
        }
    }

    /// Moves priced so far.
    pub(super) fn priced(&self) -> u64 {
        self.tour.priced
    }

    /// The tour, for its space.
    pub(super) fn tour(&self) -> &Tour<'p> {
        &self.tour
    }

    /// What is near what.
    pub(super) fn near(&self) -> &Neighbours {
        &self.near
    }

    /// The best feasible tour so far.
    pub(super) fn best(&self) -> (f64, &Kept) {
        (self.best.0, &self.best.1)
    }

    /// Whether the tour was locally best once.
    pub(super) fn has_settled(&self) -> bool {
        self.mean.is_some()
    }

    /// Whether a cycle has ended.
    pub(super) fn has_cycled(&self) -> bool {
        self.cycle > 0
    }

    /// The best feasible tour, the same whether it was taken over yet or not.
    pub(super) fn least(&self) -> (f64, &Kept) {
        let Self { tour, top, best, .. } = self;
        if tour.free || top.cost >= best.0 - EPSILON {
            return (best.0, &best.1);
        }
        (top.cost, if top.unsaved { tour.now() } else { &top.kept })
    }

    /// With one item or none there is no order to search: one cycle is enough.
    pub(super) fn is_finished(&self) -> bool {
        let items = self.tour.last();
        items == 0 || (items == 1 && self.cycle > 0)
    }

    /// The smallest piece of work there is; true when a cycle ended with it.
    pub(super) fn advance(&mut self) -> bool {
        match self.stage {
            Stage::Listing => {
                // Listing an item looks at about as many candidates as a hundred moves do.
                self.tour.priced += 100;
                if !self.near.extend(&self.tour.space) {
                    self.settle();
                }
                false
            }
            Stage::Settling => {
                match self.queue.pop() {
                    Some(item) => {
                        self.cost -= improve(&mut self.tour, &self.near, &mut self.queue, item);
                    }
                    None => self.settled(),
                }
                false
            }
            Stage::Kicking => {
                if self.kicks < self.kicks_wanted {
                    self.kick();
                    return false;
                }
                self.part_ended();
                false
            }
            Stage::Crossing(number, cost) => self.cross(number, cost),
        }
    }

    /// Takes the tour over as the best, if it is: called between slices, it changes nothing of what follows.
    pub(super) fn save(&mut self) {
        if !self.tour.free {
            if self.top.unsaved {
                self.save_top();
            }
            if self.top.cost < self.best.0 - EPSILON {
                self.best = (self.top.cost, self.top.kept.clone());
            }
        }
    }

    /// Goes on from another feasible tour, if it is better.
    pub(super) fn offer(&mut self, cost: f64, kept: Kept) {
        if cost < self.best.0 - EPSILON {
            self.best = (cost, kept);
        }
    }

    fn settle(&mut self) {
        self.stage = Stage::Settling;
        (0..=self.tour.last()).for_each(|p| self.queue.push(self.tour.item(p)));
    }

    /// The tour is locally best: a part of a cycle may begin.
    fn settled(&mut self) {
        if self.few {
            let Self { tour, queue, layers, .. } = self;
            let gain = layers.enter_best(tour, self.cost, |i| queue.push(i));
            self.cost -= gain;
            if gain > EPSILON {
                return;
            }
        }
        self.tour.commit();
        debug_assert!(self.tour.cost_is(self.cost), "a priced gain is not the gain");
        debug_assert!(self.tour.is_feasible(), "a move broke precedence");
        self.start_top();
        self.save();
        if self.mean.is_none() {
            self.mean = Some(self.cost / self.tour.last().max(1) as f64);
            self.begin_cycle();
        } else {
            self.begin_second_part();
        }
    }

    /// The tour as it is is the first, so the best, of a part.
    fn start_top(&mut self) {
        self.cost = self.tour.cost();
        self.top = Top { cost: self.cost, kept: self.tour.now().clone(), unsaved: false };
    }

    fn save_top(&mut self) {
        self.top.kept = self.tour.now().clone();
        self.top.unsaved = false;
    }
}
