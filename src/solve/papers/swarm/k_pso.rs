//! `k-pso`: a particle swarm that is initialised by groups. Qu & Du compare with this method (their reference 43, Feng
//! 2021) but do not describe it, so this is its plainest form. Items are divided into k groups as by k-means. The groups
//! are ordered by nearest neighbour, the items within a group as well, and from there the swarm moves like the standard
//! one. Every particle starts with a different group.
//!
//! A table of costs has no coordinates of which a mean could be taken. Therefore the centre of a group is the item from
//! which the sum of lengths to the other items is least, where the first node represents an item. k is the square root of
//! the number of items, rounded up.

use super::particles::Swarm;
use super::proximity::Initial;
use super::pso::{Pso, StandardGuide};
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
    /// Largest number of k-means rounds, in which items join the nearest centre and centres are computed again.
    pub grouping: u32,
}

impl Default for KPso {
    fn default() -> Self {
        let Pso { settings, weights, .. } = Pso::default();
        // Groups of points in a plane hardly change after 20 rounds.
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
        let plain = StandardGuide::new(self.weights, self.settings.draws, Initial::Random);
        let groups = Groups { left: self.grouping, ..Groups::default() };
        Run::start(
            problem,
            seed,
            &self.settings,
            GroupGuide {
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

/// The groups and the swarm.
struct GroupGuide {
    plain: StandardGuide,
    groups: Groups,
    /// The particle being initialised, whether its tour has been started, the tour, and the groups still to visit (the last
    /// is next).
    particle: usize,
    begun: bool,
    tour: Vec<NodeId>,
    order: Vec<usize>,
    /// Items of the current group that are not yet in the tour.
    left: Vec<ItemId>,
}

/// The division of items into groups.
#[derive(Default)]
struct Groups {
    centres: Vec<ItemId>,
    members: Vec<Vec<ItemId>>,
    /// For each position among the items, its group, as far as items are assigned.
    group: Vec<usize>,
    /// For each group, the least sum of lengths to its other items so far, and the item it belongs to.
    middle: Vec<(f64, ItemId)>,
    /// Position of the next item whose lengths to its group are summed.
    next: usize,
    /// Rounds that are left.
    left: u32,
}

impl Groups {
    /// Length between the first nodes of two items.
    fn way(swarm: &Swarm, a: ItemId, b: ItemId) -> f64 {
        let legs = &swarm.evaluator.space.legs;
        let first = |i: ItemId| legs.problem().items[i as usize].nodes.start;
        legs.leg(first(a), first(b))
    }

    /// Does a piece of the grouping; `None` when the groups are final.
    fn piece(&mut self, swarm: &mut Swarm) -> Option<u64> {
        let items = swarm.evaluator.keys.items();
        if self.centres.is_empty() {
            let mut left = items.to_vec();
            while self.centres.len() * self.centres.len() < items.len() {
                self.centres.push(left.swap_remove(swarm.rng.below(left.len())));
            }
            self.begin();
            return Some(items.len() as u64);
        }
        if let Some(&item) = items.get(self.group.len()) {
            let ways = self.centres.iter().map(|&c| Self::way(swarm, c, item)).enumerate();
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
            let sum: f64 = self.members[group].iter().map(|&m| Self::way(swarm, item, m)).sum();
            if sum < self.middle[group].0 {
                self.middle[group] = (sum, item);
            }
            self.next += 1;
            return Some(self.members[group].len() as u64);
        }
        // A group may have lost all its items; then its centre stays.
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

    /// Starts a round: no item is assigned.
    fn begin(&mut self) {
        self.members = vec![Vec::new(); self.centres.len()];
        self.middle = vec![(f64::INFINITY, 0); self.centres.len()];
        self.group.clear();
        self.next = 0;
    }

    /// The order of the groups by nearest neighbour, starting with `first`.
    fn order(&self, swarm: &Swarm, first: usize) -> Vec<usize> {
        let mut left: Vec<usize> = (0..self.centres.len()).filter(|&g| g != first).collect();
        let mut order = vec![first];
        let mut here = first;
        while !left.is_empty() {
            let ways =
                left.iter().map(|&g| Self::way(swarm, self.centres[here], self.centres[g])).enumerate();
            let k = ways.min_by(|a, b| a.1.total_cmp(&b.1)).map_or(0, |w| w.0);
            here = left.swap_remove(k);
            order.push(here);
        }
        order
    }
}

impl Guide for GroupGuide {
    fn initialise(&mut self, swarm: &mut Swarm) -> Option<u64> {
        if let Some(priced) = self.groups.piece(swarm) {
            return Some(priced);
        }
        if self.particle == swarm.particles.len() {
            return None;
        }
        let evaluator = &swarm.evaluator;
        let (legs, problem) = (&evaluator.space.legs, evaluator.space.legs.problem());
        if !self.begun {
            self.begun = true;
            self.order = self.groups.order(swarm, self.particle % self.groups.centres.len());
            self.order.reverse();
            self.tour.extend(evaluator.keys.pinned);
            return Some((self.order.len() * self.order.len()) as u64);
        }
        if self.left.is_empty()
            && let Some(group) = self.order.pop()
        {
            let pinned = evaluator.keys.pinned.map(|n| problem.nodes[n as usize].item);
            let members = self.groups.members[group].iter().copied();
            self.left = members.filter(|&i| Some(i) != pinned).collect();
            return Some(1 + self.left.len() as u64);
        }
        // Within a group, the nearest node is next.
        let mut priced = 0;
        let mut best: Option<(f64, NodeId, usize)> = None;
        for (k, &item) in self.left.iter().enumerate() {
            for node in problem.items[item as usize].nodes.clone() {
                let way = self.tour.last().map_or_else(|| legs.from_home(node), |&from| legs.leg(from, node));
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
        swarm.draw(self.particle, Some(&tour));
        self.particle += 1;
        self.begun = false;
        Some(tour.len() as u64)
    }

    fn move_keys(&mut self, swarm: &mut Swarm, particle: usize, keys: Range<usize>) {
        self.plain.move_keys(swarm, particle, keys);
    }
}

#[cfg(test)]
mod tests {
    use super::super::super::test_sheet::sheet;
    use super::*;

    #[test]
    fn one_round_of_k_means_by_hand() {
        // Points at 0, 1, 2 and 10, 11, 13; the centres begin at 0 and 2.
        let at: Vec<[[f64; 2]; 1]> = [0.0, 1.0, 2.0, 10.0, 11.0, 13.0].map(|x| [[x, 0.0]]).to_vec();
        let contours: Vec<&[[f64; 2]]> = at.iter().map(<[_; 1]>::as_slice).collect();
        let problem = sheet(&contours, None, "length");
        let mut swarm = Swarm::new(&problem, 1, &KPso::default().settings);
        let mut groups = Groups { centres: vec![0, 2], left: 9, ..Groups::default() };
        groups.begin();
        let round = |groups: &mut Groups, swarm: &mut Swarm| {
            let before = groups.left;
            while groups.left == before && groups.piece(swarm).is_some() {}
        };
        // 0 and 1 join the first (1 is as near to both), the rest the second. In it, 10 has the least sum: 8 + 1 + 3.
        let mut assigned = 0;
        while assigned < 6 {
            groups.piece(&mut swarm);
            assigned = groups.group.len();
        }
        assert_eq!(groups.members, [vec![0, 1], vec![2, 3, 4, 5]]);
        round(&mut groups, &mut swarm);
        assert_eq!((&groups.centres[..], groups.left), (&[0, 3][..], 8));
        // Then 2 joins the first group, whose middle is 1, and 11 is the middle of the second. Then nothing changes.
        round(&mut groups, &mut swarm);
        assert_eq!(groups.centres, [1, 4]);
        round(&mut groups, &mut swarm);
        assert_eq!((groups.left, &groups.members[..]), (0, &[vec![0, 1, 2], vec![3, 4, 5]][..]));
        assert_eq!(groups.piece(&mut swarm), None);
    }
}
