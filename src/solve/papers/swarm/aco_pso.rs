//! `aco-pso`: a swarm that ants help. The method Qu & Du compare with (their reference 42, Lei, Zhao & Jiang 2020) is not
//! given in their paper, so this is its plainest form: the particles start from tours of an ant system and move as the
//! standard swarm does; every so many rounds the worse half of them starts again from new tours of the ants. Particles
//! leave pheromone on the tours they stand for, in every round.
//!
//! An ant goes on to one of the near items not yet visited, with a chance of trail^a (1/way)^b, entering it at its nearest
//! node; where none is left it goes to the nearest of all (Dorigo & Stützle, Ant Colony Optimization, 2004, section 3.7).

use super::super::left::Walk;
use super::flock::Flock;
use super::pso::{Plain, Pso};
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
    /// Rounds between two times that the worse half starts again from tours of the ants.
    pub again: u32,
    /// Exponent of the pheromone.
    pub trail: f64,
    /// Exponent of the nearness.
    pub nearness: f64,
    /// Share of the pheromone that evaporates in a round.
    pub evaporation: f64,
}

impl Default for AcoPso {
    fn default() -> Self {
        let Pso { settings, weights } = Pso::default();
        // Exponents and evaporation of the ant system (Dorigo & Stützle 2004, box 3.1).
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
        let colony = Colony {
            by: self.clone(),
            plain: Plain::new(self.weights),
            trails: Vec::new(),
            sent: Vec::new(),
            fresh: Vec::new(),
            marked: 0,
            ant: None,
        };
        Run::start(problem, seed, &self.settings, colony)
    }
}

/// The ants and the swarm at work.
struct Colony {
    by: AcoPso,
    plain: Plain,
    /// Pheromone from each item to its near ones.
    trails: Vec<Vec<f64>>,
    /// Particles that wait for an ant's tour.
    sent: Vec<usize>,
    /// Particles that have just got one.
    fresh: Vec<bool>,
    /// Particles that have left their pheromone in this round.
    marked: usize,
    /// The ant under way.
    ant: Option<Walk>,
}

impl Colony {
    /// One step of an ant; nothing when no particle waits for one.
    fn walk(&mut self, flock: &mut Flock) -> Option<u64> {
        let i = *self.sent.last()?;
        let worth = &flock.worth;
        let legs = &worth.ground.legs;
        let problem = legs.problem();
        let Some(walk) = &mut self.ant else {
            let items = worth.keys.items();
            let any = items[if worth.keys.led { 0 } else { flock.rng.below(items.len()) }];
            let nodes = problem.items[any as usize].nodes.clone();
            let drawn = nodes.clone().nth(flock.rng.below(nodes.len())).unwrap_or(nodes.start);
            let node = worth.keys.pinned.unwrap_or(drawn);
            self.ant = Some(Walk::new(flock.all.clone(), problem, &[node]));
            return Some(problem.nodes.len() as u64);
        };
        let Some(&here) = walk.tour.last() else { return Some(1) };
        let item = problem.nodes[here as usize].item;
        let mut priced = 1;
        let mut choices: Vec<(f64, NodeId)> = Vec::new();
        let mut sum = 0.0;
        for (&(_, near), trail) in worth.ground.near.of(item).iter().zip(&self.trails[item as usize]) {
            if !walk.is_left(near) {
                continue;
            }
            let nodes = problem.items[near as usize].nodes.clone();
            priced += nodes.len() as u64;
            let ways = nodes.map(|n| (legs.leg(here, n), n));
            let Some((way, node)) = ways.min_by(|a, b| a.0.total_cmp(&b.0)) else { continue };
            // Ways of nothing are as near as can be.
            let nearness = 1.0 / way.max(f64::MIN_POSITIVE.sqrt());
            sum += (math::pow(*trail, self.by.trail) * math::pow(nearness, self.by.nearness)).min(1e100);
            choices.push((sum, node));
        }
        let drawn = flock.rng.uniform() * sum;
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
        flock.draw(i, Some(&tour));
        Some(tour.len() as u64)
    }

    /// A particle leaves pheromone on its tour, as much more as that is shorter; nothing when all have. The first one
    /// finds what was left evaporated.
    fn mark(&mut self, flock: &Flock) -> Option<u64> {
        let p = flock.particles.get(self.marked)?;
        if self.marked == 0 {
            self.trails.iter_mut().flatten().for_each(|trail| *trail *= 1.0 - self.by.evaporation);
        }
        self.marked += 1;
        let problem = flock.worth.ground.legs.problem();
        let shortest = flock.particles[flock.leader].best_value;
        let share = if p.value > 0.0 { shortest / p.value } else { 1.0 } / flock.particles.len() as f64;
        let items = || p.tour.iter().map(|&n| problem.nodes[n as usize].item);
        for (a, b) in items().zip(items().skip(1)) {
            for (from, to) in [(a, b), (b, a)] {
                if let Some(k) = flock.worth.ground.near.of(from).iter().position(|n| n.1 == to) {
                    self.trails[from as usize][k] += share;
                }
            }
        }
        Some(2 * p.tour.len() as u64)
    }
}

impl Guide for Colony {
    fn looks_around(&self) -> bool {
        true
    }

    fn sow(&mut self, flock: &mut Flock) -> Option<u64> {
        if self.trails.is_empty() {
            let near = &flock.worth.ground.near;
            let items = flock.worth.ground.legs.problem().items.len();
            self.trails = (0..).take(items).map(|i| vec![1.0; near.of(i).len()]).collect();
            self.sent = (0..flock.particles.len()).rev().collect();
            self.fresh = vec![false; flock.particles.len()];
        }
        self.walk(flock)
    }

    fn judge(&mut self, flock: &mut Flock) {
        flock.remember(|new, old| new < old);
        self.fresh.fill(false);
        self.marked = 0;
        if flock.round > 0 && flock.round.is_multiple_of(self.by.again.max(1)) {
            let mut worst: Vec<usize> = (0..flock.particles.len()).collect();
            sort_by(&mut worst, |&i| [u64::MAX - real(flock.particles[i].value), 0, 0]);
            worst.truncate(flock.particles.len() / 2);
            self.sent = worst;
        }
    }

    fn prepare(&mut self, flock: &mut Flock) -> Option<u64> {
        self.mark(flock).or_else(|| self.walk(flock))
    }

    fn drive(&mut self, flock: &mut Flock, particle: usize, keys: Range<usize>) {
        if !self.fresh[particle] {
            self.plain.drive(flock, particle, keys);
        }
    }
}
