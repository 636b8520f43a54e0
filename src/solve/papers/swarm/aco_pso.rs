//! `aco-pso`: a particle swarm that is initialised by ants. Qu & Du compare with this method (their reference 42, Lei, Zhao
//! & Jiang 2020) but do not describe it, so this is its plainest form. The particles start from tours of an ant system and
//! move like the standard swarm. After every `again` rounds the worse half of them starts again from new tours of the ants.
//! In every round each particle deposits pheromone on its tour.
//!
//! An ant moves to one of the near items not yet visited, with probability in proportion to trail^a (1/length)^b, and
//! enters it at its nearest node. Where no near item is left it moves to the nearest item (Dorigo & Stützle, Ant Colony
//! Optimization, 2004, section 3.7).

use super::super::unvisited::NearestNeighbour;
use super::particles::Swarm;
use super::proximity::Initial;
use super::pso::{Pso, StandardGuide};
use super::run::{Guide, Run};
use super::settings::{SwarmSettings, Weights};
use crate::geometry::math;
use crate::order::{real, sort_by};
use crate::problem::{NodeId, Problem};
use crate::solve::rng::Draw;
use crate::solve::{Search, Solution, Solver, SolverInfo};
use serde::{Deserialize, Serialize};
use std::ops::Range;

/// The method with its parameters.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct AcoPso {
    /// Parameters of every swarm method.
    #[serde(flatten)]
    pub settings: SwarmSettings,
    /// Constant weights.
    #[serde(flatten)]
    pub weights: Weights,
    /// Number of rounds after which the worse half starts again from tours of the ants.
    pub again: u32,
    /// Exponent of the pheromone.
    pub trail: f64,
    /// Exponent of the inverse length.
    pub nearness: f64,
    /// Fraction of the pheromone that evaporates in a round.
    pub evaporation: f64,
}

impl Default for AcoPso {
    fn default() -> Self {
        let Pso { settings, weights, .. } = Pso::default();
        // Exponents of the ant system (Dorigo & Stützle 2004, box 3.1). The rate is that of the rank-based one in this box: with
        // the 0.5 of the plain one the mean on the 43 contours is 1.0 % longer from the fixed start and 0.8 % shorter from a
        // random one (docs/papers/qu-du-2023.md).
        let (again, trail, nearness, evaporation) = (10, 1.0, 3.0, 0.1);
        Self { settings, weights, again, trail, nearness, evaporation }
    }
}

impl Solver for AcoPso {
    fn info(&self) -> SolverInfo {
        SolverInfo {
            name: "aco-pso",
            title: "ACO-PSO",
            about: "Particle swarm that starts, and starts again, from tours of ants; what LPSPSO is compared with.",
            source: Some(
                "As compared with by P. Qu, F. Du, IEEE Access 11 (2023), doi 10.1109/ACCESS.2023.3236006, in the plainest \
                 form: the paper names but does not give it",
            ),
        }
    }

    fn start<'p>(&self, problem: &'p Problem, seed: u64, _warm: Option<&Solution>) -> Box<dyn Search + 'p> {
        let colony = AntColony {
            by: self.clone(),
            plain: StandardGuide::new(self.weights, self.settings.draws, Initial::Random),
            trails: Vec::new(),
            sent: Vec::new(),
            fresh: Vec::new(),
            marked: 0,
            ant: None,
        };
        Run::start(problem, seed, &self.settings, colony)
    }
}

/// The ants and their swarm.
struct AntColony {
    by: AcoPso,
    plain: StandardGuide,
    /// Pheromone from each item to its near items.
    trails: Vec<Vec<f64>>,
    /// Particles that wait for an ant's tour.
    sent: Vec<usize>,
    /// For each particle, whether it has just received an ant's tour.
    fresh: Vec<bool>,
    /// Number of particles that have deposited pheromone in this round.
    marked: usize,
    /// The tour of the current ant.
    ant: Option<NearestNeighbour>,
}

impl AntColony {
    /// One step of the current ant; `None` when no particle waits for a tour.
    fn walk(&mut self, swarm: &mut Swarm) -> Option<u64> {
        let i = *self.sent.last()?;
        let evaluator = &swarm.evaluator;
        let legs = &evaluator.space.legs;
        let problem = legs.problem();
        let Some(walk) = &mut self.ant else {
            let items = evaluator.keys.items();
            let any = items[if evaluator.keys.led { 0 } else { swarm.rng.below(items.len()) }];
            let nodes = problem.items[any as usize].nodes.clone();
            let drawn = nodes.clone().nth(swarm.rng.below(nodes.len())).unwrap_or(nodes.start);
            let node = evaluator.keys.pinned.unwrap_or(drawn);
            self.ant = Some(NearestNeighbour::new(swarm.all.clone(), problem, &[node]));
            return Some(problem.nodes.len() as u64);
        };
        let Some(&here) = walk.tour.last() else { return Some(1) };
        let item = problem.nodes[here as usize].item;
        let mut priced = 1;
        let mut choices: Vec<(f64, NodeId)> = Vec::new();
        let mut sum = 0.0;
        for (&(_, near), trail) in evaluator.space.near.of(item).iter().zip(&self.trails[item as usize]) {
            if !walk.is_left(near) {
                continue;
            }
            let nodes = problem.items[near as usize].nodes.clone();
            priced += nodes.len() as u64;
            let ways = nodes.map(|n| (legs.leg(here, n), n));
            let Some((way, node)) = ways.min_by(|a, b| a.0.total_cmp(&b.0)) else { continue };
            // The inverse of a length of 0 must stay finite.
            let nearness = 1.0 / way.max(f64::MIN_POSITIVE.sqrt());
            sum += (math::pow(*trail, self.by.trail) * math::pow(nearness, self.by.nearness)).min(1e100);
            choices.push((sum, node));
        }
        let drawn = swarm.rng.uniform() * sum;
        if let Some(&(_, node)) = choices.iter().find(|c| c.0 > drawn) {
            walk.go(problem, node);
            return Some(priced);
        }
        if let Some(more) = walk.step(legs) {
            return Some(priced + more);
        }
        let tour = std::mem::take(&mut walk.tour);
        self.ant = None;
        self.sent.pop();
        self.fresh[i] = true;
        swarm.draw(i, Some(&tour));
        Some(tour.len() as u64)
    }

    /// The next particle deposits pheromone on its tour, more for a shorter tour; `None` when all have. Before the first
    /// one, the pheromone of the last round evaporates.
    fn mark(&mut self, swarm: &Swarm) -> Option<u64> {
        let p = swarm.particles.get(self.marked)?;
        if self.marked == 0 {
            self.trails.iter_mut().flatten().for_each(|trail| *trail *= 1.0 - self.by.evaporation);
        }
        self.marked += 1;
        let problem = swarm.evaluator.space.legs.problem();
        let shortest = swarm.particles[swarm.leader].best_value;
        let share = if p.value > 0.0 { shortest / p.value } else { 1.0 } / swarm.particles.len() as f64;
        let items = || p.tour.iter().map(|&n| problem.nodes[n as usize].item);
        for (a, b) in items().zip(items().skip(1)) {
            for (from, to) in [(a, b), (b, a)] {
                if let Some(k) = swarm.evaluator.space.near.of(from).iter().position(|n| n.1 == to) {
                    self.trails[from as usize][k] += share;
                }
            }
        }
        Some(2 * p.tour.len() as u64)
    }
}

impl Guide for AntColony {
    fn needs_neighbours(&self) -> bool {
        true
    }

    fn initialise(&mut self, swarm: &mut Swarm) -> Option<u64> {
        if self.trails.is_empty() {
            let near = &swarm.evaluator.space.near;
            let items = swarm.evaluator.space.legs.problem().items.len();
            self.trails = (0..).take(items).map(|i| vec![1.0; near.of(i).len()]).collect();
            self.sent = (0..swarm.particles.len()).rev().collect();
            self.fresh = vec![false; swarm.particles.len()];
        }
        self.walk(swarm)
    }

    fn update_bests(&mut self, swarm: &mut Swarm) {
        swarm.remember(|new, old| new < old);
        self.fresh.fill(false);
        self.marked = 0;
        if swarm.round > 0 && swarm.round.is_multiple_of(self.by.again.max(1)) {
            let mut worst: Vec<usize> = (0..swarm.particles.len()).collect();
            sort_by(&mut worst, |&i| [u64::MAX - real(swarm.particles[i].value), 0, 0]);
            worst.truncate(swarm.particles.len() / 2);
            self.sent = worst;
        }
    }

    fn prepare_round(&mut self, swarm: &mut Swarm) -> Option<u64> {
        self.mark(swarm).or_else(|| self.walk(swarm))
    }

    fn move_keys(&mut self, swarm: &mut Swarm, particle: usize, keys: Range<usize>) {
        if !self.fresh[particle] {
            self.plain.move_keys(swarm, particle, keys);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::super::test_sheet::sheet;
    use super::*;

    #[test]
    fn pheromone_evaporates_once_a_round_and_is_deposited_by_hand() {
        let problem = sheet(&[&[[0.0, 0.0]], &[[1.0, 0.0]], &[[3.0, 0.0]]], None, "length");
        let by = AcoPso { evaporation: 0.1, ..AcoPso::default() };
        let mut swarm = Swarm::new(&problem, 1, &SwarmSettings { particles: 2, ..by.settings });
        let Swarm { evaluator, all, .. } = &mut swarm;
        while evaluator.space.near.piece(&evaluator.space.legs, all).is_some() {}
        let mut ants = AntColony {
            plain: StandardGuide::new(by.weights, by.settings.draws, Initial::Random),
            by,
            trails: (0..3).map(|i| vec![1.0; swarm.evaluator.space.near.of(i).len()]).collect(),
            sent: vec![],
            fresh: vec![false; 2],
            marked: 0,
            ant: None,
        };
        for (p, (tour, value)) in swarm.particles.iter_mut().zip([(vec![0, 1, 2], 6.0), (vec![1, 0, 2], 8.0)])
        {
            (p.tour, p.value, p.best_value) = (tour, value, value);
        }
        while ants.mark(&swarm).is_some() {}
        // Each trail falls from 1 to 0.9. The shorter tour adds 6 / 6 / 2, the longer 6 / 8 / 2, both ways on their legs.
        let trail = |from: u32, to: u32| {
            let near = swarm.evaluator.space.near.of(from);
            near.iter().position(|n| n.1 == to).map(|k| ants.trails[from as usize][k]).unwrap()
        };
        for (a, b, wanted) in [(0, 1, 0.9 + 0.5 + 0.375), (1, 2, 0.9 + 0.5), (0, 2, 0.9 + 0.375)] {
            assert!((trail(a, b) - wanted).abs() < 1e-12 && (trail(b, a) - wanted).abs() < 1e-12, "{a} {b}");
        }
    }
}
