//! Levy flights of particles, eqs (21) and (22), and how a flight is undone.

use super::super::particles::Swarm;
use super::super::rules::Levy;
use super::parameters::{Flights, Lpspso};
use crate::problem::NodeId;
use crate::solve::rng::Draw;
use std::ops::Range;

/// How particles fly.
pub(super) struct Flight {
    kind: Flights,
    levy: Levy,
    /// Size of a step, in positions of the order.
    positions: f64,
    /// Size of a step, as a fraction of the range of a key.
    fraction: f64,
}

impl Flight {
    /// Flights over an order with this number of items.
    pub(super) fn new(by: &Lpspso, items: usize) -> Self {
        let positions = by.levy_step;
        let fraction = positions / items.max(1) as f64;
        Self { kind: by.flights, levy: Levy::new(by.levy_beta), positions, fraction }
    }

    /// Moves some keys of a particle by a Levy flight, eq. (21).
    pub(super) fn fly(&self, swarm: &mut Swarm, i: usize, range: Range<usize>) {
        let Swarm { evaluator, particles, rng, .. } = swarm;
        let (keys, own) = (&evaluator.keys, &mut particles[i].keys);
        match self.kind {
            Flights::Keys => {
                let end = range.end;
                for key in &mut own[range] {
                    *key = (*key + self.fraction * self.levy.step(rng)).clamp(0.0, 1.0);
                }
                if keys.permutes() && end == keys.count() {
                    keys.rank(own);
                }
            }
            Flights::Insertion if range.start == 0 => {
                let step = self.positions * self.levy.step(rng);
                // An insertion goes to another position, or it would be no flight.
                let step = if step.abs() < 1.0 { step.signum() } else { step };
                let k = rng.below(keys.items().len());
                keys.insert(own, k, step);
            }
            Flights::Insertion => {}
        }
    }
}

/// State of a particle before a flight.
pub(super) struct Origin {
    particle: usize,
    keys: Vec<f64>,
    value: f64,
    tour: Vec<NodeId>,
}

impl Origin {
    /// The current state of a particle.
    pub(super) fn of(swarm: &Swarm, particle: usize) -> Self {
        let p = &swarm.particles[particle];
        Self { particle, keys: p.keys.clone(), value: p.value, tour: p.tour.clone() }
    }

    /// Undoes the flight if it ended at a longer path.
    pub(super) fn return_unless_shorter(self, swarm: &mut Swarm) {
        let p = &mut swarm.particles[self.particle];
        if p.value > self.value {
            (p.keys, p.value, p.tour) = (self.keys, self.value, self.tour);
        }
    }
}

#[cfg(test)]
#[allow(clippy::float_cmp, reason = "the numbers of the examples are exact")]
mod tests {
    use super::super::super::super::keys::Decode;
    use super::super::super::super::test_sheet::sheet;
    use super::super::super::settings::SwarmSettings;
    use super::*;
    use crate::solve::rng::seeded;

    #[test]
    fn equations_21_and_22_by_hand() {
        let problem = sheet(&[&[[0.0, 0.0]], &[[1.0, 0.0]], &[[2.0, 0.0]], &[[3.0, 0.0]]], None, "length");
        let fly = |decode, flights| {
            let by = Lpspso { flights, levy_step: 1.0, ..Lpspso::default() };
            let settings = SwarmSettings { particles: 1, decode, ..by.settings };
            let mut swarm = Swarm::new(&problem, 4, &settings);
            swarm.particles[0].keys = vec![0.125, 0.375, 0.625, 0.875];
            Flight::new(&by, 4).fly(&mut swarm, 0, 0..4);
            swarm.particles.remove(0).keys
        };
        // Each key moves by alpha times a Levy step of its own, and stays between 0 and 1.
        let (levy, mut rng) = (Levy::new(1.5), seeded(4));
        let moved =
            [0.125, 0.375, 0.625, 0.875].map(|x: f64| (x + 0.25 * levy.step(&mut rng)).clamp(0.0, 1.0));
        assert_eq!(fly(Decode::Keys, Flights::Keys), moved);
        // A permutation takes the order of these keys.
        let ranked = fly(Decode::Permutation, Flights::Keys);
        let below = |a: usize, b: usize| moved[a] < moved[b];
        assert!(
            (0..4).all(|a| (0..4).all(|b| !below(a, b) || ranked[a] < ranked[b])),
            "{moved:?} {ranked:?}"
        );
        // An insertion: one step, then the item, as drawn.
        let mut rng = seeded(4);
        let step = levy.step(&mut rng);
        let k = rng.below(4);
        let to = (k as f64 + if step.abs() < 1.0 { step.signum() } else { step }).round().clamp(0.0, 3.0);
        let inserted = fly(Decode::Permutation, Flights::Insertion);
        assert_eq!(inserted[k], (to + 0.5) / 4.0, "{inserted:?}");
    }

    #[test]
    fn a_flight_to_a_longer_path_is_undone() {
        let problem = sheet(&[&[[0.0, 0.0]], &[[1.0, 0.0]]], None, "length");
        let mut swarm =
            Swarm::new(&problem, 1, &SwarmSettings { particles: 1, ..Lpspso::default().settings });
        let mut after = |value: f64| {
            (swarm.particles[0].keys, swarm.particles[0].value) = (vec![0.25, 0.75], 5.0);
            let origin = Origin::of(&swarm, 0);
            (swarm.particles[0].keys, swarm.particles[0].value) = (vec![0.75, 0.25], value);
            origin.return_unless_shorter(&mut swarm);
            swarm.particles[0].keys.clone()
        };
        assert_eq!((after(6.0), after(4.0)), (vec![0.25, 0.75], vec![0.75, 0.25]));
    }
}
