//! The search over all routes, where contours may be left unfinished: a route may hang from any place of a contour.
//!
//! Where leaving is free of charge this is a rural postman problem (every contour is met once or more, and air moves meet
//! every place an even number of times); with a charge each child route is a pre-cut (Dewil et al., 2014, "the partition
//! tree"). Both are searched as they are: routes that hang from contours (`tree.rs`), stops and whole
//! routes moving between them (`moves.rs`), kicks accepted by a falling temperature as over the root alone (`anneal`).
//! Nothing is ever infeasible: an item is finished after all that hangs from it, which is all that precedence asks.
//!
//! There are two ends from which to come: the root route with everything in it, and a tree in which everything hangs from
//! what is nearest to it (`hang.rs`). Which is nearer to the best is a matter of the charge; both are improved locally, and
//! the better goes on. What both gain over the root alone is in `docs/internals/tuning.md`.
//!
//! Root and routes take turns from the moment at which the root route is locally best; how much either works is a matter
//! of which is ahead. A cycle starts from the better of the best routes so far and the best root route, locally improved,
//! and is half as long again as the one before.

mod allowed;
mod bridges;
mod change;
mod closing;
mod flip;
mod hang;
mod kick;
mod moves;
mod polish;
mod shift;
#[cfg(test)]
mod tests;
mod tree;
mod turn;
mod visits;

use super::anneal::Annealing;
use super::kept::Kept;
use super::polish::unpolished;
use super::queue::Queue;
use super::space::Space;
use crate::solve::Solution;
use crate::solve::epsilon::EPSILON;
use crate::solve::rng::Rng;
use bridges::Bridges;
use hang::hang;
use moves::improve;
use shift::Ground;
use tree::Tree;

/// Temperature at the start of a cycle, in mean legs between neighbours, as over the root alone.
const HEAT: f64 = 0.3;
/// The same in every other long cycle: routes that are locally the best are left only when hot.
const HOT: f64 = 2.5;
/// Moves per item from which a cycle is long: shorter ones would forget their start and find nothing better.
const LONG: u64 = 10_000;

/// Below this share of the root's best cost, the work of the routes for each piece of the root's work: the one that is ahead gets more.
const SHARES: [(f64, f64); 3] = [(0.98, 3.0), (0.999, 1.0), (f64::INFINITY, 1.0 / 3.0)];
/// The same until the root's first cycle has ended: more delays the root, none begins too late.
const SHARE_AT_FIRST: f64 = 1.0 / 3.0;
/// A turn takes this many times a share, so that turns are not too short.
const TURN: f64 = 1.25;

/// What comes next.
enum Stage {
    /// Bridges between neighbours are found.
    Listing,
    /// All routes are improved locally.
    Settling,
    /// Everything is hung from what is nearest to it, this stop next.
    Hanging(u32),
    /// Kicks.
    Kicking,
}

/// The search over routes.
pub(super) struct Children {
    bridges: Bridges,
    tree: Tree,
    queue: Queue,
    rng: Rng,
    stage: Stage,
    /// Seconds of the routes as they are.
    cost: f64,
    /// The best so far, entered at places; `unsaved` while it is the routes as they are.
    best: Solution,
    unsaved: bool,
    /// Seconds of it when it was found: sums made anew would be off by their rounding, by when it was saved.
    least: f64,
    /// The routes are a new root route, as yet without children.
    fresh: bool,
    hot: bool,
    /// Seconds of the root route that the last cycle was offered.
    offered: f64,
    /// Work done when this cycle began, and when it ends; none is under way between the two.
    began: u64,
    ends: Option<u64>,
    /// Work of the last cycle, and for each piece of the root's.
    work: u64,
    share: f64,
}

/// Whether anything of a space may be left unfinished. Where items are to follow each other with nothing in between,
/// nothing is.
pub(super) fn may_leave(space: &Space) -> bool {
    let problem = space.problem;
    problem.items.iter().any(|i| i.leave.is_some()) && problem.groups.is_empty() && !space.travel.by_table()
}

/// A solution as one route: items in the order in which they are finished.
pub(super) fn flattened(space: &Space, solution: &Solution) -> Kept {
    let tree = Tree::new(space, solution);
    let order =
        std::iter::successors(Some(space.home), |&i| Some(tree.closing.next(i)).filter(|&n| n != space.home));
    Kept { order: order.collect(), at: (0..=space.home).map(|i| tree.at(i)).collect() }
}

impl Children {
    /// From any solution.
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

    /// The best so far, entered at places.
    pub(super) fn best(&self) -> &Solution {
        &self.best
    }

    /// The best so far, entered and left where it costs least.
    pub(super) fn polished(&self, space: &Space) -> Solution {
        polish::polished(space, &Tree::new(space, &self.best))
    }

    /// Whether it works next, and not the root; `goes_on`: it did just now.
    pub(super) fn is_next(&self, root: &Annealing, goes_on: bool) -> bool {
        let share = if root.has_cycled() { self.share } else { SHARE_AT_FIRST };
        let most = share * root.priced() as f64 * if goes_on { TURN } else { 1.0 };
        root.has_settled() && self.priced() as f64 <= most
    }

    /// Begins a cycle, which ends when so much work is done.
    fn begin(&mut self, root: &Annealing) -> u64 {
        self.began = self.tree.priced;
        self.work = if self.work == 0 { root.priced() } else { self.work + self.work.div_ceil(2) };
        let space = &root.tour().space;
        self.hot = !self.hot && self.work > LONG * u64::from(space.home);
        let (seconds, kept) = root.least();
        let better = seconds < self.offered - EPSILON;
        self.offered = seconds;
        self.put(space, better.then(|| unpolished(root.tour(), kept)).as_ref());
        self.fresh = better;
        if better && matches!(self.stage, Stage::Kicking) {
            self.settle(space);
        }
        self.began + self.work
    }

    /// Goes on from another solution, if it is better.
    pub(super) fn offer(&mut self, other: &Solution) {
        if other.cost < self.least - EPSILON {
            self.unsaved = false;
            self.least = other.cost;
            self.best = other.clone();
        }
    }

    /// Takes over the routes of a solution; none: of the best.
    fn put(&mut self, space: &Space, solution: Option<&Solution>) {
        let priced = self.tree.priced;
        self.tree = Tree::new(space, solution.unwrap_or(&self.best));
        self.tree.priced = priced;
        self.cost = self.tree.cost(space);
    }

    fn settle(&mut self, space: &Space) {
        self.stage = Stage::Settling;
        (0..=2 * space.home).for_each(|t| self.queue.push(t));
    }

    /// The smallest piece of work there is; true when a cycle ended with it.
    pub(super) fn advance(&mut self, root: &Annealing) -> bool {
        if self.ends.is_none() {
            self.ends = Some(self.begin(root));
        }
        let (space, near) = (&root.tour().space, root.near());
        match self.stage {
            Stage::Listing => {
                // Ten neighbours, each some three hundred ways looked at.
                self.tree.priced += 100;
                if !self.bridges.extend(space, near) {
                    self.settle(space);
                }
            }
            Stage::Settling => {
                let g = Ground { space, near, bridges: &self.bridges };
                match self.queue.pop() {
                    Some(touch) => self.cost -= improve(g, &mut self.tree, &mut self.queue, touch),
                    None if self.fresh => {
                        self.settled(space);
                        self.fresh = false;
                        self.stage = Stage::Hanging(0);
                    }
                    None => {
                        self.settled(space);
                        self.put(space, None);
                        self.stage = Stage::Kicking;
                    }
                }
            }
            Stage::Hanging(stop) if stop < space.home => {
                let g = Ground { space, near, bridges: &self.bridges };
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
                    let mean = self.cost / f64::from(space.home.max(1));
                    let heat = if self.hot { HOT } else { HEAT } * mean * (1.0 - progress) * (1.0 - progress);
                    self.kick(space, near, heat);
                    return false;
                }
                self.save(space);
                let of_root = self.least / root.least().0;
                self.share = SHARES.iter().find(|s| of_root < s.0).map_or(1.0, |s| s.1);
                self.ends = None;
                return true;
            }
        }
        false
    }

    /// The routes are locally best.
    fn settled(&mut self, space: &Space) {
        self.tree.commit();
        self.check(space);
        self.keep_least(space);
        self.save(space);
    }

    /// The routes as they are are the best from now on, if they are better. What they gain as visits is told at once: it
    /// must not depend on when they are saved.
    fn keep_least(&mut self, space: &Space) {
        if self.cost < self.least - EPSILON {
            self.least = self.cost;
            self.unsaved = true;
            if self.tree.is_doubled() {
                self.save(space);
                self.least = self.best.cost;
            }
        }
    }

    /// Takes the routes over as the best, if they are: called between slices, it changes nothing of what follows.
    pub(super) fn save(&mut self, space: &Space) {
        if std::mem::take(&mut self.unsaved) {
            self.best = at_places(space, &self.tree);
        }
    }

    /// The best was left with the changes in the journal.
    fn save_before(&mut self, space: &Space) {
        if std::mem::take(&mut self.unsaved) {
            let mut tree = self.tree.clone();
            tree.undo(space, 0);
            self.best = at_places(space, &tree);
        }
    }

    /// For debug assertions: gains are what they were priced at, and the routes are feasible.
    fn check(&self, space: &Space) {
        debug_assert!({
            let cost = self.tree.cost(space);
            (cost - self.cost).abs() <= 1e-6 * cost.max(1.0)
        });
        debug_assert!(self.tree.is_sound(space), "a move broke precedence or the order of finishing");
    }
}

fn at_places(space: &Space, tree: &Tree) -> Solution {
    let along = |t: u32| if t == space.home { 0.0 } else { space.stop(tree.item(t), tree.at(t)).along };
    Solution::new(space.problem, tree.stops(space, along))
}
