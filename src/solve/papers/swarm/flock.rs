//! A swarm: particles with their keys, velocities and bests, and the rules (14) and (15) by which they move, as they are
//! meant: the printed v^{t+1} on the right of (14) is v^t, the second attraction is to the best of all, and (15) gives
//! x^{t+1}.

use super::super::left::Left;
use super::settings::Weights;
use super::worth::Worth;
use crate::problem::NodeId;
use crate::solve::rng::{Draw, Rng};
use std::ops::Range;

/// A particle.
#[derive(Clone, Default)]
pub(super) struct Particle {
    /// Position.
    pub(super) keys: Vec<f64>,
    pub(super) velocity: Vec<f64>,
    /// Length of its tour now.
    pub(super) value: f64,
    /// Its tour now.
    pub(super) tour: Vec<NodeId>,
    /// Its own best position, and how long that tour is.
    pub(super) best: Vec<f64>,
    pub(super) best_value: f64,
}

/// A swarm on a problem.
pub(super) struct Flock<'p> {
    pub(super) worth: Worth<'p>,
    /// All nodes, to walk among.
    pub(super) all: Left,
    pub(super) rng: Rng,
    pub(super) particles: Vec<Particle>,
    /// The particle whose best is the best of all.
    pub(super) leader: usize,
    /// Iterations done and to do.
    pub(super) round: u32,
    pub(super) rounds: u32,
    /// Largest velocity.
    pub(super) fastest: f64,
    /// A path that is worth a look before the swarm is sown.
    pub(super) found: Option<Vec<NodeId>>,
}

impl Flock<'_> {
    /// Share of the iterations done, t/tmax.
    pub(super) fn share(&self) -> f64 {
        f64::from(self.round) / f64::from(self.rounds.max(1))
    }

    /// Draws a particle's velocity anew, and its position too when there is no tour to stand for.
    pub(super) fn draw(&mut self, i: usize, tour: Option<&[NodeId]>) {
        let count = self.worth.keys.count();
        let Self { particles, rng, fastest, worth, .. } = self;
        let particle = &mut particles[i];
        particle.velocity = (0..count).map(|_| *fastest * (2.0 * rng.uniform() - 1.0)).collect();
        match tour {
            Some(tour) => {
                particle.keys.resize(count, 0.5);
                worth.keys.set(tour, &mut particle.keys);
            }
            None => particle.keys = (0..count).map(|_| rng.uniform()).collect(),
        }
    }

    /// Eqs (14) and (15) for some keys of a particle. `pull` gives the weights, key by key.
    pub(super) fn pull(&mut self, i: usize, range: Range<usize>, mut pull: impl FnMut(&mut Rng) -> Weights) {
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

    /// Keeps what is better than a particle's best by `better` (new, old), and finds the leader.
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

    /// Mean length of the tours now.
    pub(super) fn mean(&self) -> f64 {
        self.particles.iter().map(|p| p.value).sum::<f64>() / self.particles.len().max(1) as f64
    }
}
