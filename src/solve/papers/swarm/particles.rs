//! A swarm of particles with their keys, velocities and best positions, and the equations (14) and (15) by which they move.
//! The equations are misprinted and used as they are meant: v^{t+1} on the right of (14) is v^t, the second term attracts
//! to the best position of the swarm, and (15) gives x^{t+1}.

use super::super::keys::Keys;
use super::super::legs::Legs;
use super::super::local::NearItems;
use super::super::unvisited::Unvisited;
use super::evaluator::Evaluator;
use super::settings::{SwarmSettings, Weights};
use crate::problem::{NodeId, Problem};
use crate::solve::rng::{Draw, Rng, seeded};
use std::ops::Range;

/// A particle.
#[derive(Clone, Default)]
pub(super) struct Particle {
    /// Current position.
    pub(super) keys: Vec<f64>,
    pub(super) velocity: Vec<f64>,
    /// Velocity of a permutation: the exchanges it made last.
    pub(super) exchanges: Vec<(u32, u32)>,
    /// Length of its current tour.
    pub(super) value: f64,
    /// Its current tour.
    pub(super) tour: Vec<NodeId>,
    /// Its own best position, and the length of that tour.
    pub(super) best: Vec<f64>,
    pub(super) best_value: f64,
}

/// A swarm that searches a problem.
pub(super) struct Swarm<'p> {
    pub(super) evaluator: Evaluator<'p>,
    /// All nodes, for constructing tours.
    pub(super) all: Unvisited,
    pub(super) rng: Rng,
    pub(super) particles: Vec<Particle>,
    /// Index of the particle with the best position of the swarm.
    pub(super) leader: usize,
    /// Number of the current iteration, and of all iterations.
    pub(super) round: u32,
    pub(super) rounds: u32,
    /// Largest velocity.
    pub(super) fastest: f64,
    /// A path found during the initialisation that may be the best so far.
    pub(super) found: Option<Vec<NodeId>>,
}

impl<'p> Swarm<'p> {
    /// A swarm whose particles have no keys yet; without items it has no particles.
    pub(super) fn new(problem: &'p Problem, seed: u64, settings: &SwarmSettings) -> Self {
        let keys = Keys::new(problem, settings.first, settings.decode);
        let near = NearItems::new(settings.neighbours);
        let evaluator =
            Evaluator::new(Legs::new(problem, settings.measure), keys, near, settings.local_search);
        let count = if evaluator.keys.items().is_empty() { 0 } else { settings.particles.max(1) as usize };
        Self {
            all: Unvisited::all(problem),
            rng: seeded(seed),
            particles: vec![Particle::default(); count],
            leader: 0,
            round: 0,
            rounds: settings.rounds,
            fastest: settings.fastest,
            found: None,
            evaluator,
        }
    }

    /// Fraction of the iterations done, t/tmax.
    pub(super) fn share(&self) -> f64 {
        f64::from(self.round) / f64::from(self.rounds.max(1))
    }

    /// Gives a particle a random velocity, and the position of a tour, or a random position if there is none.
    pub(super) fn draw(&mut self, i: usize, tour: Option<&[NodeId]>) {
        let count = self.evaluator.keys.count();
        let Self { particles, rng, fastest, evaluator, .. } = self;
        let particle = &mut particles[i];
        particle.velocity = (0..count).map(|_| *fastest * (2.0 * rng.uniform() - 1.0)).collect();
        match tour {
            Some(tour) => {
                particle.keys.resize(count, 0.5);
                evaluator.keys.set(tour, &mut particle.keys);
            }
            None => particle.keys = (0..count).map(|_| rng.uniform()).collect(),
        }
        if evaluator.keys.permutes() {
            evaluator.keys.rank(&mut particle.keys);
            particle.exchanges.clear();
        }
    }

    /// Applies eqs (14) and (15) to some keys of a particle. `pull` gives the weights for each key. A permutation moves as
    /// a whole, with its first keys.
    pub(super) fn pull(&mut self, i: usize, range: Range<usize>, mut pull: impl FnMut(&mut Rng) -> Weights) {
        if self.evaluator.keys.permutes() {
            if range.start == 0 {
                self.exchange(i, pull);
            }
            return;
        }
        for k in range {
            let by = pull(&mut self.rng);
            let leader = self.particles[self.leader].best[k];
            let p = &mut self.particles[i];
            let x = p.keys[k];
            let v = by.inertia * p.velocity[k] + by.own * (p.best[k] - x) + by.swarm * (leader - x);
            p.velocity[k] = v.clamp(-self.fastest, self.fastest);
            p.keys[k] = (x + p.velocity[k]).clamp(0.0, 1.0);
        }
    }

    /// Eqs (14) and (15) for permutations (Wang et al., International Conference on Machine Learning and Cybernetics, 2003):
    /// a velocity is a list of exchanges, a weight is the probability that an exchange is made, and a difference is the
    /// list of exchanges that leads from one permutation to the other. The largest velocity is a fraction of the items:
    /// of a longer list, exchanges are left out at random.
    fn exchange(&mut self, i: usize, mut pull: impl FnMut(&mut Rng) -> Weights) {
        let leader = &self.particles[self.leader].best;
        let (p, keys) = (&self.particles[i], &self.evaluator.keys);
        let own = keys.exchanges(&p.keys, &p.best);
        let swarm = keys.exchanges(&p.keys, leader);
        let rng = &mut self.rng;
        let mut velocity = Vec::new();
        let mut take = |swaps: &[(u32, u32)], weight: fn(Weights) -> f64| {
            for &swap in swaps {
                let chance = weight(pull(rng));
                if rng.uniform() < chance {
                    velocity.push(swap);
                }
            }
        };
        take(&p.exchanges, |w| w.inertia);
        take(&own, |w| w.own);
        take(&swarm, |w| w.swarm);
        let most = (self.fastest * keys.items().len() as f64).max(1.0);
        let kept = most / velocity.len().max(1) as f64;
        if kept < 1.0 {
            velocity.retain(|_| rng.uniform() < kept);
        }
        let p = &mut self.particles[i];
        for &(a, b) in &velocity {
            p.keys.swap(a as usize, b as usize);
        }
        p.exchanges = velocity;
    }

    /// Updates the best position of each particle, and the leader. `better` compares a new length with an old one.
    pub(super) fn remember(&mut self, better: impl Fn(f64, f64) -> bool) {
        for p in &mut self.particles {
            if p.best.is_empty() || better(p.value, p.best_value) {
                p.best.clone_from(&p.keys);
                p.best_value = p.value;
            }
        }
        for i in 0..self.particles.len() {
            if better(self.particles[i].best_value, self.particles[self.leader].best_value) {
                self.leader = i;
            }
        }
    }

    /// Mean length of the current tours.
    pub(super) fn mean(&self) -> f64 {
        self.particles.iter().map(|p| p.value).sum::<f64>() / self.particles.len().max(1) as f64
    }
}

#[cfg(test)]
#[allow(clippy::float_cmp, reason = "the numbers of the examples are exact")]
mod tests {
    use super::super::super::keys::Decode;
    use super::super::super::test_sheet::sheet;
    use super::super::settings::Draws;
    use super::*;

    /// Points at 0, 1, 2 and 3 mm.
    fn points() -> Problem {
        sheet(&[&[[0.0, 0.0]], &[[1.0, 0.0]], &[[2.0, 0.0]], &[[3.0, 0.0]]], None, "length")
    }

    fn swarm(problem: &Problem, decode: Decode, fastest: f64) -> Swarm<'_> {
        let settings = SwarmSettings { particles: 2, decode, ..SwarmSettings::with(fastest, Draws::Key) };
        let mut swarm = Swarm::new(problem, 1, &settings);
        for p in &mut swarm.particles {
            p.velocity = vec![0.0; 4];
        }
        swarm
    }

    #[test]
    fn equations_14_and_15_by_hand() {
        let problem = points();
        let mut swarm = swarm(&problem, Decode::Keys, 0.3);
        swarm.leader = 1;
        swarm.particles[1].best = vec![0.9, 0.5, 0.9, 0.0];
        let p = &mut swarm.particles[0];
        (p.keys, p.velocity) = (vec![0.5, 0.5, 0.2, 0.1], vec![0.1, -0.2, 0.3, -0.3]);
        p.best = vec![0.4, 0.5, 0.8, 0.1];
        swarm.pull(0, 0..4, |_| Weights { inertia: 0.5, own: 0.5, swarm: 0.25 });
        let p = &swarm.particles[0];
        // v = 0.5 v + 0.5 (p - x) + 0.25 (g - x): 0.05 - 0.05 + 0.1; -0.1; 0.15 + 0.3 + 0.175, held at 0.3; -0.15 - 0.025.
        let near = |found: &[f64], wanted: [f64; 4]| {
            assert!(found.iter().zip(wanted).all(|(f, w)| (f - w).abs() < 1e-12), "{found:?} {wanted:?}");
        };
        near(&p.velocity, [0.1, -0.1, 0.3, -0.175]);
        // x + v; the last would be below 0.
        near(&p.keys, [0.6, 0.4, 0.5, 0.0]);
    }

    #[test]
    fn equations_14_and_15_for_permutations_by_hand() {
        let problem = points();
        let straight = [0.125, 0.375, 0.625, 0.875];
        let turned = [0.875, 0.625, 0.375, 0.125];
        let moved = |inertia: f64, own: f64, all: f64, fastest: f64| {
            let mut swarm = swarm(&problem, Decode::Permutation, fastest);
            swarm.leader = 1;
            swarm.particles[1].best = turned.to_vec();
            let p = &mut swarm.particles[0];
            (p.keys, p.best) = (straight.to_vec(), straight.to_vec());
            p.exchanges = vec![(0, 1)];
            swarm.pull(0, 0..4, |_| Weights { inertia, own, swarm: all });
            (swarm.particles[0].keys.clone(), swarm.particles[0].exchanges.clone())
        };
        // Weights are probabilities: 0 keeps the particle, inertia 1 repeats its exchange, a pull of 1 reaches the best.
        assert_eq!(moved(0.0, 1.0, 0.0, 1.0), (straight.to_vec(), vec![]));
        assert_eq!(moved(1.0, 0.0, 0.0, 1.0), (vec![0.375, 0.125, 0.625, 0.875], vec![(0, 1)]));
        assert_eq!(moved(0.0, 0.0, 1.0, 1.0), (turned.to_vec(), vec![(0, 3), (1, 2)]));
        // Whatever the weights and the limit, the keys stay a permutation.
        let (mut keys, _) = moved(0.7, 0.3, 0.9, 0.25);
        keys.sort_by(f64::total_cmp);
        assert_eq!(keys, straight);
    }

    #[test]
    fn bests_and_the_leader_are_updated_by_hand() {
        let problem = points();
        let mut swarm = swarm(&problem, Decode::Keys, 0.2);
        for (p, value) in swarm.particles.iter_mut().zip([7.0, 5.0]) {
            (p.keys, p.value) = (vec![value; 4], value);
        }
        swarm.remember(|new, old| new < old);
        assert_eq!((swarm.leader, swarm.particles[0].best_value), (1, 7.0));
        // The first gets shorter than the leader; the second gets longer and keeps its best.
        for (p, value) in swarm.particles.iter_mut().zip([4.0, 9.0]) {
            (p.keys, p.value) = (vec![value; 4], value);
        }
        swarm.remember(|new, old| new < old);
        assert_eq!(
            (swarm.leader, swarm.particles[0].best_value, swarm.particles[1].best_value),
            (0, 4.0, 5.0)
        );
        assert_eq!(swarm.particles[1].best, vec![5.0; 4]);
    }
}
