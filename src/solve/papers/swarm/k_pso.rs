//! `k-pso`: a swarm sown by groups. The method Qu & Du compare with (their reference 43, Feng 2021) is not given in their
//! paper, so this is its plainest form: items are put in k groups as k-means does, the groups are ordered by going always
//! to the nearest, each is toured inside by going always to the nearest, and the swarm moves on from there as the
//! standard one does. Every particle begins with another group.
//!
//! The centre of a group is that of its items from which the ways to the others are shortest, as a table of costs has no
//! places of which there would be a mean; an item stands for its first node. k is the root of the number of items.

use super::flock::Flock;
use super::pso::{Plain, Pso};
use super::run::{Guide, Run};
use super::settings::{SwarmSettings, Weights};
use crate::problem::{ItemId, NodeId, Problem};
use crate::solve::rng::Draw;
use crate::solve::{Search, Solution, Solver, SolverInfo};
use serde::{Deserialize, Serialize};
use std::ops::Range;

/// The method with its parameters.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct KPso {
    /// Parameters of every swarm method.
    #[serde(flatten)]
    pub settings: SwarmSettings,
    /// Constant weights.
    #[serde(flatten)]
    pub weights: Weights,
    /// Times that items are put to the nearest centre and centres found anew, at most.
    pub grouping: u32,
}

impl Default for KPso {
    fn default() -> Self {
        let Pso { settings, weights } = Pso::default();
        // Groups of points in a plane hardly change after that many.
        let grouping = 20;
        Self { settings, weights, grouping }
    }
}

impl Solver for KPso {
    fn info(&self) -> SolverInfo {
        SolverInfo {
            name: "k-pso",
            title: "K-PSO",
            about: "Particle swarm that starts from k-means groups toured one by one; what LPSPSO is compared with.",
            source: Some(
                "As compared with by P. Qu, F. Du, IEEE Access 11 (2023), doi 10.1109/ACCESS.2023.3236006, in the plainest \
                 form: the paper names but does not give it",
            ),
        }
    }

    fn start<'p>(&self, problem: &'p Problem, seed: u64, _warm: Option<&Solution>) -> Box<dyn Search + 'p> {
        let plain = Plain::new(self.weights);
        let groups = Groups { left: self.grouping, ..Groups::default() };
        Run::start(
            problem,
            seed,
            &self.settings,
            Grouped {
                plain,
                groups,
                particle: 0,
                begun: false,
                tour: Vec::new(),
                order: Vec::new(),
                left: Vec::new(),
            },
        )
    }
}

/// The groups, and the swarm at work.
struct Grouped {
    plain: Plain,
    groups: Groups,
    /// The particle being sown, whether it was begun with, its tour so far and the groups still to come, the next last.
    particle: usize,
    begun: bool,
    tour: Vec<NodeId>,
    order: Vec<usize>,
    /// Items of the group being toured.
    left: Vec<ItemId>,
}

/// Items in groups.
#[derive(Default)]
struct Groups {
    centres: Vec<ItemId>,
    members: Vec<Vec<ItemId>>,
    /// By place among the items: its group, as far as they are put to groups.
    group: Vec<usize>,
    /// By group: the item with the shortest ways to the others so far.
    middle: Vec<(f64, ItemId)>,
    /// The next item whose ways to the others of its group are summed.
    next: usize,
    /// Rounds left.
    left: u32,
}

impl Groups {
    /// Way between items, by their first nodes.
    fn way(flock: &Flock, a: ItemId, b: ItemId) -> f64 {
        let legs = &flock.worth.ground.legs;
        let first = |i: ItemId| legs.problem().items[i as usize].nodes.start;
        legs.leg(first(a), first(b))
    }

    /// A piece of the grouping; nothing when the groups stand.
    fn piece(&mut self, flock: &mut Flock) -> Option<u64> {
        let items = flock.worth.keys.items();
        if self.centres.is_empty() {
            let mut left = items.to_vec();
            while self.centres.len() * self.centres.len() < items.len() {
                self.centres.push(left.swap_remove(flock.rng.below(left.len())));
            }
            self.begin();
            return Some(items.len() as u64);
        }
        if let Some(&item) = items.get(self.group.len()) {
            let ways = self.centres.iter().map(|&c| Self::way(flock, c, item)).enumerate();
            let nearest = ways.min_by(|a, b| a.1.total_cmp(&b.1)).map_or(0, |w| w.0);
            self.members[nearest].push(item);
            self.group.push(nearest);
            return Some(self.centres.len() as u64);
        }
        if self.left == 0 {
            return None;
        }
        if let Some(&item) = items.get(self.next) {
            let group = self.group[self.next];
            let sum: f64 = self.members[group].iter().map(|&m| Self::way(flock, item, m)).sum();
            if sum < self.middle[group].0 {
                self.middle[group] = (sum, item);
            }
            self.next += 1;
            return Some(self.members[group].len() as u64);
        }
        // A group may have lost all its items: its centre stays.
        let found =
            self.middle.iter().zip(&self.centres).map(|(m, &c)| if m.0.is_finite() { m.1 } else { c });
        let centres: Vec<ItemId> = found.collect();
        self.left = if centres == self.centres { 0 } else { self.left - 1 };
        if self.left > 0 {
            self.centres = centres;
            self.begin();
        }
        Some(items.len() as u64)
    }

    /// All items are to be put to groups.
    fn begin(&mut self) {
        self.members = vec![Vec::new(); self.centres.len()];
        self.middle = vec![(f64::INFINITY, 0); self.centres.len()];
        self.group.clear();
        self.next = 0;
    }

    /// The groups in order, from one on always to the nearest.
    fn order(&self, flock: &Flock, first: usize) -> Vec<usize> {
        let mut left: Vec<usize> = (0..self.centres.len()).filter(|&g| g != first).collect();
        let mut order = vec![first];
        let mut here = first;
        while !left.is_empty() {
            let ways =
                left.iter().map(|&g| Self::way(flock, self.centres[here], self.centres[g])).enumerate();
            let k = ways.min_by(|a, b| a.1.total_cmp(&b.1)).map_or(0, |w| w.0);
            here = left.swap_remove(k);
            order.push(here);
        }
        order
    }
}

impl Guide for Grouped {
    fn sow(&mut self, flock: &mut Flock) -> Option<u64> {
        if let Some(priced) = self.groups.piece(flock) {
            return Some(priced);
        }
        if self.particle == flock.particles.len() {
            return None;
        }
        let worth = &flock.worth;
        let (legs, problem) = (&worth.ground.legs, worth.ground.legs.problem());
        if !self.begun {
            self.begun = true;
            self.order = self.groups.order(flock, self.particle % self.groups.centres.len());
            self.order.reverse();
            self.tour.extend(worth.keys.pinned);
            return Some((self.order.len() * self.order.len()) as u64);
        }
        if self.left.is_empty()
            && let Some(group) = self.order.pop()
        {
            let pinned = worth.keys.pinned.map(|n| problem.nodes[n as usize].item);
            let members = self.groups.members[group].iter().copied();
            self.left = members.filter(|&i| Some(i) != pinned).collect();
            return Some(1 + self.left.len() as u64);
        }
        // Inside a group, always to the nearest node.
        let mut priced = 0;
        let mut best: Option<(f64, NodeId, usize)> = None;
        for (k, &item) in self.left.iter().enumerate() {
            for node in problem.items[item as usize].nodes.clone() {
                let way = self.tour.last().map_or_else(|| legs.out(node), |&from| legs.leg(from, node));
                priced += 1;
                if best.is_none_or(|b| way < b.0) {
                    best = Some((way, node, k));
                }
            }
        }
        if let Some((_, node, k)) = best {
            self.left.swap_remove(k);
            self.tour.push(node);
            return Some(priced);
        }
        let mut tour = std::mem::take(&mut self.tour);
        if let Some(at) = tour.iter().position(|&n| Some(problem.nodes[n as usize].item) == problem.start()) {
            tour.rotate_left(at);
        }
        flock.draw(self.particle, Some(&tour));
        self.particle += 1;
        self.begun = false;
        Some(tour.len() as u64)
    }

    fn drive(&mut self, flock: &mut Flock, particle: usize, keys: Range<usize>) {
        self.plain.drive(flock, particle, keys);
    }
}
