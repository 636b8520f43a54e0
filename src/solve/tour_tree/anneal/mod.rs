//! Simulated annealing over one tour: kicks, local search, and a falling temperature, in cycles that grow.
//!
//! A kick exchanges two neighbouring stretches of the tour (a segment double bridge: it keeps most precedences, and no
//! single local move undoes it). The local search improves what the kick changed. The result stays if it costs no more,
//! or with a probability that falls with the extra cost and the temperature (Metropolis). Otherwise the journal takes
//! everything back. The price of a kick does not depend on the size of the sheet, only on the lengths of the stretches.
//!
//! * [`cycles`]: lengths, temperatures and ends of cycles. [`kick`]: one kick.

mod cycles;
mod kick;

use super::entries::Layers;
use super::improve::improve;
use super::long_legs::percentage_of_kicks;
use super::neighbours::{MOVES_PER_ITEM, Neighbours};
use super::queue::Queue;
use super::recombine::Elites;
use super::rows::Rows;
use super::small_instances::is_small;
use super::snapshot::TourSnapshot;
use super::tour::Tour;
use crate::solve::epsilon::EPSILON;
use crate::solve::rng::Rng;

/// The best tour of a part of a cycle.
struct PartBest {
    cost: f64,
    snapshot: TourSnapshot,
    /// The current tour is the best, and `snapshot` is older.
    unsaved: bool,
}

/// What the search does next.
enum Stage {
    /// Builds the neighbour lists.
    Listing,
    /// Improves the whole tour locally.
    Settling,
    /// Tries tours along rows; holds the cheapest so far with its seconds, if it costs less than the best tour.
    TryingRows(Rows, Option<(f64, TourSnapshot)>),
    /// Makes kicks.
    Kicking,
    /// Recombines the result with the partner of this number; the second is the cost before the first partner.
    Recombining(usize, f64),
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
    /// Cost of the current tour, s.
    cost: f64,
    part_best: PartBest,
    /// The best feasible tour, with its cost in seconds.
    best: (f64, TourSnapshot),
    cycle: u32,
    kicks: u64,
    kicks_wanted: u64,
    /// Mean leg of the first locally optimal tour, s.
    mean_leg: Option<f64>,
    temperature: f64,
    /// Percentage of the kicks that cut long legs.
    long_legs_percent: usize,
    /// Percentage of the kicks of this part that ruin and recreate.
    ruin_percent: usize,
    /// The problem is small: see `small_instances.rs`.
    is_small: bool,
}

impl<'p> Annealing<'p> {
    /// Starts from a feasible tour.
    pub(super) fn new(mut tour: Tour<'p>, rng: Rng) -> Self {
        let near = Neighbours::new(&tour.space);
        let queue = Queue::new(tour.space.home as usize + 1);
        let (cost, snapshot) = (tour.cost(), tour.current().clone());
        tour.ignores_nesting = false;
        let space = &tour.space;
        let is_small = is_small(space, tour.last());
        Self {
            tour,
            near,
            queue,
            layers: Layers::default(),
            elites: Elites::default(),
            rng,
            stage: Stage::Listing,
            cost,
            part_best: PartBest { cost, snapshot: snapshot.clone(), unsaved: false },
            best: (cost, snapshot),
            cycle: 0,
            kicks: 0,
            kicks_wanted: 0,
            mean_leg: None,
            temperature: 0.0,
            long_legs_percent: 0,
            ruin_percent: 0,
            is_small,
        }
    }

    /// Moves priced so far.
    pub(super) fn priced(&self) -> u64 {
        self.tour.priced
    }

    /// The current tour.
    pub(super) fn tour(&self) -> &Tour<'p> {
        &self.tour
    }

    /// The neighbour lists.
    pub(super) fn near(&self) -> &Neighbours {
        &self.near
    }

    /// The best feasible tour so far.
    pub(super) fn best(&self) -> (f64, &TourSnapshot) {
        (self.best.0, &self.best.1)
    }

    /// The tour while the first local search improves it, with its seconds: it is feasible unless nesting is ignored.
    pub(super) fn settling(&self) -> Option<(f64, &TourSnapshot)> {
        let settles = matches!(self.stage, Stage::Settling) && !self.tour.ignores_nesting;
        settles.then(|| (self.tour.cost(), self.tour.current()))
    }

    /// Whether the first local search has ended.
    pub(super) fn has_settled(&self) -> bool {
        self.mean_leg.is_some()
    }

    /// Whether a cycle has ended.
    pub(super) fn has_cycled(&self) -> bool {
        self.cycle > 0
    }

    /// The best feasible tour, whether [`Annealing::save`] has taken it over or not.
    pub(super) fn least(&self) -> (f64, &TourSnapshot) {
        let Self { tour, part_best, best, .. } = self;
        if tour.ignores_nesting || part_best.cost >= best.0 - EPSILON {
            return (best.0, &best.1);
        }
        (part_best.cost, if part_best.unsaved { tour.current() } else { &part_best.snapshot })
    }

    /// Whether nothing is left to search: with one item there is no order, so that one cycle is enough.
    pub(super) fn is_finished(&self) -> bool {
        let items = self.tour.last();
        items == 0 || (items == 1 && self.cycle > 0)
    }

    /// Does the smallest piece of work there is; true when a cycle ends with it.
    pub(super) fn advance(&mut self) -> bool {
        match self.stage {
            Stage::Listing => {
                let listed = self.near.extend(&self.tour.space);
                self.tour.priced += listed.unwrap_or(MOVES_PER_ITEM);
                if listed.is_none() {
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
            Stage::TryingRows(..) => {
                self.try_rows();
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
            Stage::Recombining(number, cost) => self.recombine(number, cost),
        }
    }

    /// Takes over the best tour of the part if it is the best of all. Called between slices, it does not change what
    /// follows.
    pub(super) fn save(&mut self) {
        if !self.tour.ignores_nesting {
            if self.part_best.unsaved {
                self.save_part();
            }
            if self.part_best.cost < self.best.0 - EPSILON {
                self.best = (self.part_best.cost, self.part_best.snapshot.clone());
            }
        }
    }

    /// Takes over a feasible tour if it costs less than the best: the next cycle starts from it.
    pub(super) fn offer(&mut self, cost: f64, snapshot: TourSnapshot) {
        if cost < self.best.0 - EPSILON {
            self.best = (cost, snapshot);
        }
    }

    /// Queues all items for the local search.
    fn settle(&mut self) {
        self.stage = Stage::Settling;
        (0..=self.tour.last()).for_each(|p| self.queue.push(self.tour.item(p)));
    }

    /// The local search has ended: begins the next part.
    fn settled(&mut self) {
        if self.is_small {
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
        self.start_part();
        self.save();
        if self.kicks_wanted > 0 {
            self.begin_second_part();
            return;
        }
        let first = self.mean_leg.is_none();
        let mean_leg = self.tour.mean_leg(self.cost);
        self.mean_leg = Some(mean_leg);
        if !self.is_small {
            self.long_legs_percent = percentage_of_kicks(&self.tour, mean_leg);
        }
        match Rows::new(&self.tour.space, self.tour.current()).filter(|_| first) {
            Some(rows) => self.stage = Stage::TryingRows(rows, None),
            None => self.begin_cycle(),
        }
    }

    /// Tries one tour along the rows. After the last of them the search goes on from the cheapest, if it costs less than
    /// the first locally best tour.
    fn try_rows(&mut self) {
        let Stage::TryingRows(rows, found) = &mut self.stage else { return };
        if rows.try_next(&mut self.tour, &mut self.queue) {
            let cost = self.tour.cost();
            if cost < found.as_ref().map_or(self.best.0, |f| f.0) - EPSILON {
                *found = Some((cost, self.tour.current().clone()));
            }
            return;
        }
        let Some((_, snapshot)) = found.take() else {
            self.begin_cycle();
            return;
        };
        self.tour.restore(snapshot);
        self.start_part();
        self.settle();
    }

    /// Makes the current tour the first, and so the best, of a part.
    fn start_part(&mut self) {
        self.cost = self.tour.cost();
        self.part_best = PartBest { cost: self.cost, snapshot: self.tour.current().clone(), unsaved: false };
    }

    fn save_part(&mut self) {
        self.part_best.snapshot = self.tour.current().clone();
        self.part_best.unsaved = false;
    }
}
