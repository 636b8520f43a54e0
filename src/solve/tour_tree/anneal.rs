//! The search itself: local kicks, accepted by a falling temperature, in cycles that double.
//!
//! A kick exchanges two neighbouring stretches of the tour (a segment double-bridge: feasible with precedence, and no
//! local move undoes it at once), the local search mends what was touched, and the result is kept if it is no worse,
//! or worse by less than a random amount that the temperature allows (Metropolis); otherwise the journal takes it
//! back. Nothing depends on the size of the sheet but the lengths of the stretches.
//!
//! A cycle has two parts. The first heeds no nesting, because the large structure of a good tour is found only
//! where outer contours do not pin it; its result is repaired (`repair.rs`), and the second part goes on with every
//! precedence kept. Each cycle starts from the best path so far and is twice as long as the one before, so that the
//! search is good at any moment and needs no budget in advance. Without nesting there is one part.

use super::improve::{EPSILON, Queue, improve, reenter};
use super::neighbours::Neighbours;
use super::repair::repaired;
use super::space::index;
use super::tour::{Kept, Tour};
use crate::geometry::math;
use rand_xoshiro::Xoshiro256PlusPlus;
use rand_xoshiro::rand_core::Rng;

/// Kicks in the first cycle, for every item: enough to see an improvement within a tenth of a second.
const FIRST_CYCLE: u64 = 2;
/// Share of a cycle, in percent, that heeds no nesting.
const FREE_SHARE: u64 = 60;
/// Temperature at the start of the first cycle, in mean ways between neighbours: on sheets of 500 and 2,000 contours
/// 0.1 stays in the first valley met, 1.0 forgets what it found.
const HEAT: f64 = 0.3;
/// Share of it in later cycles, which refine the best path: 0.3 found more than 0.6 and 1.0.
const REHEAT: f64 = 0.3;
/// Longest stretch a kick moves. Lengths are drawn evenly on a log scale: most kicks are small and cheap, and whole
/// parts still change places (500 contours: 10 ends 1.2 % above 300).
const LONGEST: usize = 300;

/// One kick in so many also draws an entry: without it, entries that only pay together are never found.
const DRAW_ENTRY: usize = 4;

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
}

/// The search over one tour.
pub(super) struct Annealing<'p> {
    tour: Tour<'p>,
    near: Neighbours,
    queue: Queue,
    rng: Xoshiro256PlusPlus,
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
}

impl<'p> Annealing<'p> {
    /// From a feasible tour.
    pub(super) fn new(mut tour: Tour<'p>, rng: Xoshiro256PlusPlus) -> Self {
        let near = Neighbours::new(&tour.space);
        let queue = Queue::new(tour.last() + 1);
        let (cost, kept) = (tour.cost(), tour.now().clone());
        tour.free = false;
        Self {
            tour,
            near,
            queue,
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

    /// The best feasible tour so far.
    pub(super) fn best(&self) -> (f64, &Kept) {
        (self.best.0, &self.best.1)
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
                self.part_ended()
            }
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
        self.tour.free = self.tour.space.precedence.nested_only;
        self.begin_part(if self.tour.free { FREE_SHARE } else { 100 });
    }

    fn begin_part(&mut self, share: u64) {
        let items = self.tour.last() as u64;
        // Past 40 doublings no machine arrives.
        self.kicks_wanted = (FIRST_CYCLE * items * share / 100).max(1) << self.cycle.min(40);
        self.kicks = 0;
        self.temperature = HEAT * self.mean.unwrap_or(0.0) * if self.cycle > 0 { REHEAT } else { 1.0 };
        self.stage = Stage::Kicking;
    }

    /// True when the cycle ended.
    fn part_ended(&mut self) -> bool {
        if self.top.unsaved {
            self.save_top();
        }
        if self.tour.free {
            self.tour.free = false;
            let cost = |tour: &mut Tour, kept: &Kept| {
                tour.put(kept.clone());
                tour.cost()
            };
            let [ahead, back] = repaired(&self.tour.space, &self.top.kept);
            if cost(&mut self.tour, &ahead) <= cost(&mut self.tour, &back) {
                self.tour.put(ahead);
            }
            self.start_top();
            self.settle();
            return false;
        }
        self.save();
        self.cycle += 1;
        self.begin_cycle();
        true
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
        let last = self.tour.last();
        let (one, two) = (self.stretch(), self.stretch());
        if one + two > last {
            return;
        }
        let from = 1 + self.below(last + 1 - one - two);
        let (middle, to) = (from + one - 1, from + one + two - 1);
        if !self.tour.may_exchange(from, middle, to) {
            return;
        }
        let t = &mut self.tour;
        let (a, b, c) = (t.item(from - 1), t.item(from), t.item(middle));
        let (d, e, f) = (t.item(middle + 1), t.item(to), t.item(to + 1));
        let given = t.edge(a, b) + t.edge(c, d) + t.edge(e, f);
        t.exchange(from, middle, to);
        let mut change = t.edge(a, d) + t.edge(e, b) + t.edge(c, f) - given;
        if self.below(DRAW_ENTRY) == 0 {
            change += self.draw_entry(b);
        }
        // Entries first: otherwise 2-opt takes a small kick back before they could make it pay.
        // The one with an entry drawn comes last, so that the others may settle with it.
        for item in [a, c, d, e, f].into_iter().filter(|&i| i != b).chain([b]) {
            change -= reenter(&mut self.tour, &mut self.queue, item).unwrap_or(0.0);
            self.queue.push(item);
        }
        while let Some(item) = self.queue.pop() {
            change -= improve(&mut self.tour, &self.near, &mut self.queue, item);
        }
        // -ln of an even number in (0, 1]: worse by x passes with probability e^(-x / heat).
        let allowed = if change > EPSILON { -math::ln(1.0 - self.even()) * heat } else { f64::INFINITY };
        if change >= allowed {
            self.tour.undo();
            return;
        }
        if self.top.unsaved && change > 0.0 {
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

    /// Enters an item somewhere; gives the seconds that costs.
    fn draw_entry(&mut self, item: u32) -> f64 {
        let at = self.below(self.tour.space.places(item).len());
        let t = &mut self.tour;
        let (before, after) = (t.previous(item), t.next(item));
        let given = t.edge(before, item) + t.edge(item, after) + t.extra(item);
        t.enter(item, index(at));
        self.queue.push(before);
        self.queue.push(after);
        t.edge(before, item) + t.edge(item, after) + t.extra(item) - given
    }

    /// A length of stretch.
    fn stretch(&mut self) -> usize {
        // Of two stretches one is no longer than half of all; but a large group only moves as a whole.
        let all = self.tour.last();
        let most = if self.tour.space.problem.groups.is_empty() { all / 2 } else { all };
        let longest = LONGEST.min(most).max(1);
        let length = math::exp(self.even() * math::ln(longest as f64));
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "between 1 and LONGEST")]
        (length as usize).clamp(1, longest)
    }

    /// An even number in [0, 1).
    fn even(&mut self) -> f64 {
        (self.rng.next_u64() >> 11) as f64 / (1_u64 << 53) as f64
    }

    /// An even index below `n` (n < 2^32).
    fn below(&mut self, n: usize) -> usize {
        let high = self.rng.next_u64() >> 32;
        usize::try_from((high * n as u64) >> 32).unwrap_or(0)
    }
}
