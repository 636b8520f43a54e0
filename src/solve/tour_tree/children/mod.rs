//! The search over all routes, where contours may be left unfinished: a child route may start at any place of a contour,
//! or where the path through a pierce group may be left (`groups.rs`).
//!
//! If leaving is free of charge, this is a rural postman problem: every contour is met at least once, and air moves meet
//! every place an even number of times. With a charge each child route is a pre-cut (Dewil et al., 2014, "the partition
//! tree"). Both are searched in the same way: routes that hang from contours (`tree.rs`), local moves of stops and whole
//! routes between them (`moves.rs`), and annealed kicks as over the root route alone (`anneal`). Every tree is feasible,
//! because an item is finished after everything that hangs from it, which is all that precedence asks.
//!
//! There are two starts: the root route with everything in it, and a tree in which everything hangs from its nearest item
//! (`hang.rs`). Which is nearer to the optimum depends on the charge. Both are improved locally, and the better goes on.
//!
//! Root and routes take turns from the moment when the root route is locally optimal; the one that is ahead gets more of
//! the work. A cycle starts from the better of the best routes so far and the best root route, locally improved, and is half
//! as long again as the one before.

mod allowed;
mod bridges;
mod chain_move;
mod change;
mod finish_order;
mod groups;
mod hang;
mod kick;
mod moves;
mod polish;
mod swap_with_host;
#[cfg(test)]
mod tests;
mod tree;
mod two_opt;
mod visits;

use super::anneal::Annealing;
use super::config::CONFIG;
use super::polish::unpolished;
use super::queue::Queue;
use super::snapshot::TourSnapshot;
use super::space::Space;
use crate::problem::Item;
use crate::solve::Solution;
use crate::solve::epsilon::EPSILON;
use crate::solve::rng::Rng;
use bridges::Bridges;
use chain_move::Context;
use hang::hang;
use moves::improve;
use tree::Tree;

/// What the search does next.
enum Stage {
    /// Finds the bridges between neighbours.
    Listing,
    /// Improves all routes locally.
    Settling,
    /// Hangs every stop from its nearest item; this stop is next.
    Hanging(u32),
    /// Makes kicks.
    Kicking,
}

/// The search over routes.
pub(super) struct ChildRoutes {
    bridges: Bridges,
    tree: Tree,
    queue: Queue,
    rng: Rng,
    stage: Stage,
    /// Cost of the current routes, s.
    cost: f64,
    /// The best solution so far, with entries at places.
    best: Solution,
    /// The current routes are the best, and `best` is older.
    unsaved: bool,
    /// Cost of the best when it was found, s. A new sum would differ in its rounding, depending on when it is made.
    least: f64,
    /// The current routes are a new root route without child routes.
    fresh: bool,
    /// The current cycle is a hot one.
    hot: bool,
    /// Cost of the root route that the last cycle was offered, s.
    offered: f64,
    /// Moves when this cycle began, and when it ends; `None` between two cycles.
    began: u64,
    ends: Option<u64>,
    /// Moves of the last cycle.
    work: u64,
    /// Work for each piece of the root's work.
    share: f64,
}

/// Whether any item may be left unfinished: never where groups must be cut without interruption.
pub(super) fn may_leave(space: &Space) -> bool {
    let problem = space.problem;
    problem.items.iter().any(Item::may_be_left) && problem.groups.is_empty() && !space.travel.by_table()
}

/// A solution as a tour: the items in the order in which they are finished.
pub(super) fn flattened(space: &Space, solution: &Solution) -> TourSnapshot {
    let tree = Tree::new(space, solution);
    let order = std::iter::successors(Some(space.home), |&i| {
        Some(tree.finish_order.next(i)).filter(|&n| n != space.home)
    });
    TourSnapshot { order: order.collect(), at: (0..=space.home).map(|i| tree.at(i)).collect() }
}

impl ChildRoutes {
    /// Starts from any solution.
    pub(super) fn new(space: &Space, from: &Solution, rng: Rng) -> Self {
        let tree = Tree::new(space, from);
        let cost = tree.cost(space);
        let best = at_places(space, &tree);
        Self {
            bridges: Bridges::default(),
            tree,
            queue: Queue::new(2 * space.home as usize + 1),
            rng,
            stage: Stage::Listing,
            cost,
            least: best.cost,
            best,
            unsaved: false,
            fresh: false,
            hot: false,
            offered: f64::INFINITY,
            began: 0,
            ends: None,
            work: 0,
            share: 1.0,
        }
    }

    /// Moves priced so far.
    pub(super) fn priced(&self) -> u64 {
        self.tree.priced
    }

    /// The best solution so far, with entries at places.
    pub(super) fn best(&self) -> &Solution {
        &self.best
    }

    /// The best solution so far, with exact entries.
    pub(super) fn polished(&self, space: &Space) -> Solution {
        polish::polished(space, &Tree::new(space, &self.best))
    }

    /// Whether this search works next, and not the root's; `goes_on`: it did the last piece of work.
    pub(super) fn is_next(&self, root: &Annealing, goes_on: bool) -> bool {
        let share = if root.has_cycled() { self.share } else { CONFIG.children.first_work_share };
        let most = share * root.priced() as f64 * if goes_on { CONFIG.children.turn } else { 1.0 };
        root.has_settled() && self.priced() as f64 <= most
    }

    /// Begins a cycle and returns the number of moves at which it ends.
    fn begin(&mut self, root: &Annealing) -> u64 {
        self.began = self.tree.priced;
        self.work = if self.work == 0 {
            root.priced()
        } else {
            self.work + self.work.div_ceil(CONFIG.cycle.growth_divisor)
        };
        let space = &root.tour().space;
        self.hot = !self.hot && self.work > CONFIG.children.long_cycle * u64::from(space.home);
        let (seconds, snapshot) = root.least();
        let better = seconds < self.offered - EPSILON;
        self.offered = seconds;
        self.restore(space, better.then(|| unpolished(root.tour(), snapshot)).as_ref());
        self.fresh = better;
        if better && matches!(self.stage, Stage::Kicking) {
            self.settle(space);
        }
        self.began + self.work
    }

    /// Takes over a solution if it costs less than the best: the next cycle starts from it.
    pub(super) fn offer(&mut self, other: &Solution) {
        if other.cost < self.least - EPSILON {
            self.unsaved = false;
            self.least = other.cost;
            self.best = other.clone();
        }
    }

    /// Restores the routes of a solution, or those of the best.
    fn restore(&mut self, space: &Space, solution: Option<&Solution>) {
        let priced = self.tree.priced;
        self.tree = Tree::new(space, solution.unwrap_or(&self.best));
        self.tree.priced = priced;
        self.cost = self.tree.cost(space);
    }

    /// Queues all touches for the local search.
    fn settle(&mut self, space: &Space) {
        self.stage = Stage::Settling;
        (0..=2 * space.home).for_each(|t| self.queue.push(t));
    }

    /// Does the smallest piece of work there is; true when a cycle ends with it.
    pub(super) fn advance(&mut self, root: &Annealing) -> bool {
        if self.ends.is_none() {
            self.ends = Some(self.begin(root));
        }
        let (space, near) = (&root.tour().space, root.near());
        match self.stage {
            Stage::Listing => {
                // Ten bridges, each of which looks at about three hundred legs.
                self.tree.priced += 100;
                if !self.bridges.extend(space, near) {
                    self.settle(space);
                }
            }
            Stage::Settling => {
                let g = Context { space, near, bridges: &self.bridges };
                match self.queue.pop() {
                    Some(touch) => self.cost -= improve(g, &mut self.tree, &mut self.queue, touch),
                    None if self.fresh => {
                        self.settled(space);
                        self.fresh = false;
                        self.stage = Stage::Hanging(0);
                    }
                    None => {
                        self.settled(space);
                        self.restore(space, None);
                        self.stage = Stage::Kicking;
                    }
                }
            }
            Stage::Hanging(stop) if stop < space.home => {
                let g = Context { space, near, bridges: &self.bridges };
                hang(g, &mut self.tree, stop);
                self.stage = Stage::Hanging(stop + 1);
            }
            Stage::Hanging(_) => {
                self.cost = self.tree.cost(space);
                self.settle(space);
            }
            Stage::Kicking => {
                if self.ends.is_some_and(|ends| self.tree.priced < ends) {
                    let progress = (self.tree.priced - self.began) as f64 / self.work as f64;
                    let config = CONFIG.children;
                    let mean_leg = self.cost / f64::from(space.home.max(1));
                    let temperature = if self.hot { config.hot_temperature } else { config.temperature }
                        * mean_leg
                        * (1.0 - progress)
                        * (1.0 - progress);
                    self.kick(space, near, temperature);
                    return false;
                }
                self.save(space);
                let of_root = self.least / root.least().0;
                self.share = CONFIG.children.work_shares.iter().find(|s| of_root < s.0).map_or(1.0, |s| s.1);
                self.ends = None;
                return true;
            }
        }
        false
    }

    /// The local search has ended: keeps the routes if they are the best.
    fn settled(&mut self, space: &Space) {
        self.tree.commit();
        self.check(space);
        self.keep_least(space);
        self.save(space);
    }

    /// Remembers the current routes as the best if they cost less. If they cost less still as visits, that is found out
    /// at once, because it must not depend on when they are saved.
    fn keep_least(&mut self, space: &Space) {
        if self.cost < self.least - EPSILON {
            self.least = self.cost;
            self.unsaved = true;
            if self.tree.is_doubled(space) {
                self.save(space);
                self.least = self.best.cost;
            }
        }
    }

    /// Converts the current routes if they are the best. Called between slices, it does not change what follows.
    pub(super) fn save(&mut self, space: &Space) {
        if std::mem::take(&mut self.unsaved) {
            self.best = at_places(space, &self.tree);
            debug_assert!(
                self.tree.is_doubled(space)
                    || (self.best.cost - self.least).abs() <= 1e-6 * self.least.abs().max(1.0),
                "the best costs other than it was priced"
            );
        }
    }

    /// Saves the best, which is the routes before the changes in the journal.
    fn save_before(&mut self, space: &Space) {
        if std::mem::take(&mut self.unsaved) {
            let mut tree = self.tree.clone();
            tree.undo(space, 0);
            self.best = at_places(space, &tree);
        }
    }

    /// Asserts in debug builds that the priced gains are the real ones and that the routes are feasible.
    fn check(&self, space: &Space) {
        debug_assert!({
            let cost = self.tree.cost(space);
            (cost - self.cost).abs() <= 1e-6 * cost.max(1.0)
        });
        debug_assert!(self.tree.is_sound(space), "a move broke precedence or the order of finishing");
    }
}

/// The solution of the routes, with entries at places.
fn at_places(space: &Space, tree: &Tree) -> Solution {
    let along = |t: u32| match tree.leave_place(space, t) {
        Some(place) => place.along,
        None if t == space.home => 0.0,
        None => space.stop(tree.item(t), tree.at(t)).along,
    };
    Solution::new(space.problem, tree.stops(space, along))
}
