//! How the members of a population move: particle swarm, optimal foraging, and whales.
//!
//! Section 5.2 names the methods but does not describe them; these are their plain forms.

use super::members::Members;
use crate::geometry::math;
use crate::order::{real, sort_by};
use crate::solve::rng::{Draw, Rng};
use std::f64::consts::TAU;

/// A rule by which members move.
pub(super) trait MoveRule {
    /// Prepares a generation.
    fn begin(&mut self, _members: &Members) {}
    /// The keys that a member may move to. `done` is the fraction of the generations that are done.
    fn trial(&mut self, members: &Members, member: usize, done: f64, rng: &mut Rng) -> Vec<f32>;
    /// Whether the member moves there, given its lengths before and after. Generations are counted from 1.
    fn accepts(&mut self, _before: f64, _after: f64, _generation: f64, _rng: &mut Rng) -> bool {
        true
    }
}

#[expect(clippy::cast_possible_truncation, reason = "keys have fewer digits")]
fn key(x: f64) -> f32 {
    x as f32
}

/// Particle swarm optimisation: the velocity combines inertia, the member's own best and the best of all.
pub(super) struct Particles {
    inertia: f64,
    own: f64,
    all: f64,
    velocities: Vec<Vec<f32>>,
    /// The best keys of each member, and their lengths.
    bests: Vec<Vec<f32>>,
    lengths: Vec<f64>,
}

impl Particles {
    pub(super) fn new(inertia: f64, own: f64, all: f64) -> Self {
        Self { inertia, own, all, velocities: Vec::new(), bests: Vec::new(), lengths: Vec::new() }
    }
}

impl MoveRule for Particles {
    fn trial(&mut self, members: &Members, member: usize, _done: f64, rng: &mut Rng) -> Vec<f32> {
        let here = &members.keys[member];
        if self.bests.len() == member {
            self.velocities.push(vec![0.0; here.len()]);
            self.bests.push(here.clone());
            self.lengths.push(members.lengths[member]);
        } else if members.lengths[member] < self.lengths[member] {
            self.lengths[member] = members.lengths[member];
            self.bests[member].copy_from_slice(here);
        }
        let pulls = self.bests[member].iter().zip(&members.best);
        let moved = self.velocities[member].iter_mut().zip(here).zip(pulls).map(|((v, &x), (&own, &all))| {
            let [to_own, to_all] = [own, all].map(|p| f64::from(p) - f64::from(x));
            let pull = self.own * rng.uniform() * to_own + self.all * rng.uniform() * to_all;
            *v = key(self.inertia * f64::from(*v) + pull);
            x + *v
        });
        moved.collect()
    }
}

/// Optimal foraging (Zhu & Zhang, Applied Soft Computing 51 (2017)). Each member moves along its difference to a better
/// one, and the best along its difference to the worst, by k times the difference of two random numbers. The rule of prey
/// choice accepts the result; it accepts longer paths less often in later generations.
pub(super) struct Foragers {
    /// k = from - fall t / t_max.
    from: f64,
    fall: f64,
    /// Members in ascending order of length, and the position of each member in that order.
    order: Vec<usize>,
    places: Vec<usize>,
}

impl Foragers {
    pub(super) fn new(from: f64, fall: f64) -> Self {
        Self { from, fall, order: Vec::new(), places: Vec::new() }
    }

    /// A random better member, or the worst for the best of all.
    pub(super) fn other(&self, member: usize, rng: &mut Rng) -> usize {
        let place = self.places[member];
        self.order[if place == 0 { self.order.len() - 1 } else { rng.below(place) }]
    }

    /// The scaling factor k.
    pub(super) fn factor(&self, done: f64) -> f64 {
        self.from - self.fall * done
    }
}

impl MoveRule for Foragers {
    fn begin(&mut self, members: &Members) {
        self.order = (0..members.keys.len()).collect();
        sort_by(&mut self.order, |&m| [real(members.lengths[m]), 0, 0]);
        self.places = vec![0; self.order.len()];
        self.order.iter().enumerate().for_each(|(place, &m)| self.places[m] = place);
    }

    fn trial(&mut self, members: &Members, member: usize, done: f64, rng: &mut Rng) -> Vec<f32> {
        let other = &members.keys[self.other(member, rng)];
        let k = self.factor(done);
        let moved = members.keys[member].iter().zip(other).map(|(&x, &o)| {
            let change = f64::from(o) - f64::from(x);
            let back = rng.uniform();
            key(f64::from(x) - k * back * change + k * rng.uniform() * change)
        });
        moved.collect()
    }

    fn accepts(&mut self, before: f64, after: f64, generation: f64, rng: &mut Rng) -> bool {
        let prey = rng.uniform();
        prey * after / (1.0 + (generation + 1.0) * prey) < before / generation
    }
}

/// Whale optimisation (Mirjalili & Lewis, Advances in Engineering Software 95 (2016)). Half of the moves are a spiral
/// around the best; the others lead towards the best, or around a random member while |A| is at least 1.
pub(super) struct Whales {
    /// A falls from `reach` to `least`.
    pub(super) reach: f64,
    pub(super) least: f64,
    /// Weight C of the prey. Mirjalili draws it from [0, 2] each time; the paper uses 1.
    pub(super) weight: f64,
    /// Shape b of the spiral.
    pub(super) spiral: f64,
}

impl Whales {
    /// The coefficient A of a move.
    pub(super) fn coefficient(&self, done: f64, rng: &mut Rng) -> f64 {
        let falling = self.reach - (self.reach - self.least) * done;
        2.0 * falling * rng.uniform() - falling
    }
}

impl MoveRule for Whales {
    fn trial(&mut self, members: &Members, member: usize, done: f64, rng: &mut Rng) -> Vec<f32> {
        let here = &members.keys[member];
        if rng.uniform() >= 0.5 {
            let l = 2.0 * rng.uniform() - 1.0;
            let turn = math::exp(self.spiral * l) * math::cos(TAU * l);
            let around =
                |(&x, &b): (&f32, &f32)| key((f64::from(b) - f64::from(x)).abs() * turn + f64::from(b));
            return here.iter().zip(&members.best).map(around).collect();
        }
        let a = self.coefficient(done, rng);
        let prey = if a.abs() < 1.0 { &members.best } else { &members.keys[rng.below(members.keys.len())] };
        let towards = |(&x, &p): (&f32, &f32)| {
            key(f64::from(p) - a * (self.weight * f64::from(p) - f64::from(x)).abs())
        };
        here.iter().zip(prey).map(towards).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::solve::rng::seeded;

    fn members() -> Members {
        let keys = vec![vec![0.2, 0.4], vec![0.6, 0.9], vec![0.5, 0.5]];
        Members { best: keys[1].clone(), keys, lengths: vec![5.0, 3.0, 4.0], shortest: 3.0 }
    }

    fn close(found: &[f32], wanted: [f64; 2]) {
        assert!(
            found.iter().zip(wanted).all(|(&f, w)| (f64::from(f) - w).abs() < 1e-6),
            "{found:?} {wanted:?}"
        );
    }

    #[test]
    fn particles_by_hand() {
        let mut rule = Particles::new(0.3, 0.5, 0.5);
        // There is no velocity yet, and the member is at its own best: only the best of all attracts it.
        let found = rule.trial(&members(), 0, 0.0, &mut seeded(9));
        let mut rng = seeded(9);
        let [_, a, _, b] = [(); 4].map(|()| rng.uniform());
        close(&found, [0.2 + 0.5 * a * 0.4, 0.4 + 0.5 * b * 0.5]);
        // Now inertia acts, and its own best attracts it, because its path became longer.
        let mut moved = members();
        (moved.keys[0], moved.lengths[0]) = (found.clone(), 6.0);
        let again = rule.trial(&moved, 0, 0.0, &mut rng);
        let mut rng = seeded(9);
        (0..4).for_each(|_| {
            rng.uniform();
        });
        let x = f64::from(found[0]);
        let (own, all) = (0.5 * rng.uniform(), 0.5 * rng.uniform());
        let wanted = x + 0.3 * (x - 0.2) + own * (0.2 - x) + all * (0.6 - x);
        assert!((f64::from(again[0]) - wanted).abs() < 1e-6);
    }

    #[test]
    fn foragers_by_hand() {
        let mut rule = Foragers::new(0.9, 0.5);
        rule.begin(&members());
        assert_eq!(rule.order, [1, 2, 0]);
        // The best moves along the difference to the worst, halfway through with k = 0.65.
        let found = rule.trial(&members(), 1, 0.5, &mut seeded(4));
        let mut rng = seeded(4);
        let [a, b, c, d] = [(); 4].map(|()| rng.uniform());
        close(&found, [0.6 + 0.65 * (b - a) * (0.2 - 0.6), 0.9 + 0.65 * (d - c) * (0.4 - 0.9)]);
        // A shorter path is always accepted; one that is longer by half hardly ever in generation 1000.
        let mut rng = seeded(5);
        assert!((0..500).all(|_| rule.accepts(2.0, 2.0, 7.0, &mut rng)));
        let taken = (0..500).filter(|_| rule.accepts(2.0, 3.0, 1000.0, &mut rng)).count();
        assert!(taken < 10, "{taken}");
    }

    #[test]
    fn whales_by_hand() {
        let mut rule = Whales { reach: 2.0, least: 0.0, weight: 1.0, spiral: 1.0 };
        let mut kinds = [0; 2];
        for seed in 0..60 {
            // At the end A is 0, so the member moves to the prey itself or spirals around it.
            let found = rule.trial(&members(), 0, 1.0, &mut seeded(seed));
            let mut rng = seeded(seed);
            let spiral = rng.uniform() >= 0.5;
            let l = 2.0 * rng.uniform() - 1.0;
            let turn = if spiral { math::exp(l) * math::cos(TAU * l) } else { 0.0 };
            close(&found, [0.6 + 0.4 * turn, 0.9 + 0.5 * turn]);
            kinds[usize::from(spiral)] += 1;
        }
        assert!(kinds.iter().all(|&k| k > 15));
    }
}
