//! The search itself: local kicks, accepted by a falling temperature, in cycles that grow.
//!
//! A kick exchanges two neighbouring stretches of the tour (a segment double-bridge: feasible with precedence, and no
//! local move undoes it at once), the local search mends what was touched, and the result is kept if it is no worse,
//! or worse by less than a random amount that the temperature allows (Metropolis); otherwise the journal takes it
//! back. Nothing depends on the size of the sheet but the lengths of the stretches.
//!
//! A cycle has two parts. The first heeds no nesting, because the large structure of a good tour is found only
//! where outer contours do not pin it; its result is repaired (`repair.rs`), and the second part goes on with every
//! precedence kept. Each cycle starts from the best path so far and is half as long again as the one before, so that
//! the search is good at any moment and needs no budget in advance (twice as long ends 0.3 and 0.5 % higher on 10,000
//! contours after 120 and 150 million moves, a third as long again 0.1 and 0.3 %; on 500 and 2,000 after 60 million all are
//! within 0.1 %). Without nesting there is one part. Problems with few places have cycles that double every second
//! time, or hardly grow (`few.rs`).

use super::super::dice::Dice;
use super::crossing::{Elites, cross};
use super::entries::Layers;
use super::exchange::exchange;
use super::few::{ENTER_ANEW, Small, Turn, is_few};
use super::improve::{EPSILON, Queue, improve};
use super::neighbours::Neighbours;
use super::rebuild::rebuild;
use super::repair::repaired;
use super::tour::{Kept, Tour};

/// Kicks in the first cycle, for every item: enough to see an improvement within a tenth of a second. 4 ends 0.1 % lower on
/// 500 contours after 2 s, but is 1.3 % above after 0.3 s.
const FIRST_CYCLE: u64 = 2;
/// Share of a cycle, in percent, that heeds no nesting.
const FREE_SHARE: u64 = 60;
/// Temperature at the start of the first cycle, in mean ways between neighbours: on sheets of 500 and 2,000 contours
/// 0.1 stays in the first valley met, 1.0 forgets what it found.
const HEAT: f64 = 0.3;
/// Share of it in later cycles where nesting is heeded: these refine the best path. 1.0 ends 0.3 % higher on 2,000 contours, 0.1 as
/// high (20 s, 8 seeds).
const REHEAT: f64 = 0.3;
/// Share of it in later cycles where nesting is not heeded: hot enough for another way round the sheet, as which one is best shows
/// only at the end, and what it spoils elsewhere is got back by crossing. Against 0.3, paths end 0.2 % shorter in the mean on 500
/// (5 s, 12 seeds; the best 0.8 %), 2,000 (20 s, 8 seeds) and 10,000 contours (25 s, 4 seeds); 5.0 comes to as much.
const REHEAT_FREE: f64 = 2.5;

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
    dice: Dice,
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
    pub(super) fn new(mut tour: Tour<'p>, dice: Dice) -> Self {
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
            dice,
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
            self.begin_part(100 - FREE_SHARE);
        }
    }

    fn begin_cycle(&mut self) {
        self.tour.put(self.best.1.clone());
        self.start_top();
        self.tour.free = self.tour.space.precedence.nested_only && !self.few;
        self.begin_part(if self.tour.free { FREE_SHARE } else { 100 });
    }

    fn begin_part(&mut self, share: u64) {
        let items = self.tour.last() as u64;
        let first = |per_item: u64| (per_item * items * share / 100).max(1);
        let turn = if self.few {
            Turn::of(self.cycle, self.tour.space.problem, first(FIRST_CYCLE))
        } else {
            let Small { first_cycle, rebuilds } = Small::of(self.tour.space.problem, items, FIRST_CYCLE);
            // Past so many cycles no machine arrives.
            let kicks =
                (0..self.cycle.min(70)).fold(first(first_cycle), |kicks, _| kicks + kicks.div_ceil(2));
            let heat = match self.cycle {
                0 => 1.0,
                _ if self.tour.free => REHEAT_FREE,
                _ => REHEAT,
            };
            Turn { heat, rebuilds, kicks }
        };
        self.kicks_wanted = turn.kicks;
        self.kicks = 0;
        self.temperature = HEAT * self.mean.unwrap_or(0.0) * turn.heat;
        self.rebuilds = turn.rebuilds;
        self.stage = Stage::Kicking;
    }

    fn part_ended(&mut self) {
        if self.top.unsaved {
            self.save_top();
        }
        if self.tour.free {
            self.tour.free = false;
            let [ahead, back] = repaired(&self.tour.space, &self.top.kept);
            self.tour.put(ahead.clone());
            let cost = self.tour.cost();
            self.tour.put(back);
            if cost <= self.tour.cost() {
                self.tour.put(ahead);
            }
            self.start_top();
            self.settle();
            return;
        }
        self.save();
        self.tour.put(self.top.kept.clone());
        self.cost = self.tour.cost();
        // Stretches know no groups.
        let number = if self.tour.space.problem.groups.is_empty() { 0 } else { usize::MAX };
        self.stage = Stage::Crossing(number, self.cost);
    }

    /// Crosses the tour that a cycle ended in with what earlier cycles ended in and the best, one after the other,
    /// until that gains no more; true when the cycle ended with it.
    fn cross(&mut self, number: usize, before: f64) -> bool {
        let Self { tour, queue, elites, best, .. } = self;
        if let Some(other) = elites.partner(number, &best.1) {
            let gain = cross(tour, queue, other);
            // It is never taken back.
            tour.commit();
            self.cost -= gain;
            // Again with the same one, until it has nothing better.
            self.stage = Stage::Crossing(number + usize::from(gain <= 0.0), before);
            return false;
        }
        self.cost -= self.settled_anew(self.cost);
        debug_assert!(self.tour.cost_is(self.cost), "a priced gain is not the gain");
        debug_assert!(self.tour.is_feasible(), "crossing broke precedence");
        if self.cost < before - EPSILON {
            self.stage = Stage::Crossing(0, self.cost);
            return false;
        }
        self.offer(self.cost, self.tour.now().clone());
        self.elites.keep(self.top.kept.clone());
        self.cycle += 1;
        self.begin_cycle();
        true
    }

    /// All entries of a tour of this cost at once where items are few, and what the local search makes of it; gives
    /// the seconds gained.
    fn settled_anew(&mut self, cost: f64) -> f64 {
        let Self { tour, near, queue, layers, .. } = self;
        let mut gain = if self.few { layers.enter_best(tour, cost, |i| queue.push(i)) } else { 0.0 };
        while let Some(item) = queue.pop() {
            gain += improve(tour, near, queue, item);
        }
        gain
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

    fn kick(&mut self) {
        // Drawing a kick costs too, also one that precedence forbids.
        self.tour.priced += 1;
        self.kicks += 1;
        let heat = {
            let left = 1.0 - self.kicks as f64 / self.kicks_wanted as f64;
            self.temperature * left * left
        };
        let Self { tour, near, queue, dice, .. } = self;
        let change = if self.rebuilds > 0 && dice.below(100) < self.rebuilds {
            rebuild(tour, near, queue, dice)
        } else {
            exchange(tour, queue, dice)
        };
        let Some(mut change) = change else {
            while queue.pop().is_some() {}
            tour.undo();
            return;
        };
        while let Some(item) = self.queue.pop() {
            change -= improve(&mut self.tour, &self.near, &mut self.queue, item);
        }
        let most = self.top.cost + ENTER_ANEW * self.mean.unwrap_or(0.0);
        if self.few && change.abs() > EPSILON && self.cost + change < most {
            change -= self.settled_anew(self.cost + change);
        }
        if !self.dice.passes(change, heat) {
            self.tour.undo();
            return;
        }
        // Also before a change that costs nothing: which of two equal tours is kept must not depend on slices.
        if self.top.unsaved && self.cost + change >= self.top.cost - EPSILON {
            self.top.kept = self.tour.before();
            self.top.unsaved = false;
        }
        self.cost += change;
        debug_assert!(self.tour.cost_is(self.cost), "a priced gain is not the gain");
        debug_assert!(self.tour.is_feasible(), "a move broke precedence");
        self.tour.commit();
        if self.cost < self.top.cost - EPSILON {
            self.top.cost = self.cost;
            self.top.unsaved = true;
        }
    }
}
