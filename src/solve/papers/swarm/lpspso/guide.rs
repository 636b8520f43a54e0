//! The rules of LPSPSO with their current values: how the swarm starts, what a round computes, and how particles move.

use super::super::particles::Swarm;
use super::super::prospect::{Outcomes, Prospect};
use super::super::proximity::Proximity;
use super::super::rules::{Levy, Spread, add_distances, inertia, kappa, learning, singer, tau};
use super::super::run::Guide;
use super::super::settings::{Draws, Weights};
use super::parameters::{Flights, Kappa, Lpspso, Stagnation};
use crate::problem::NodeId;
use crate::solve::Curve;
use crate::solve::rng::Draw;
use std::ops::Range;

/// The rules of the method and their current values.
pub(super) struct LpspsoGuide {
    by: Lpspso,
    proximity: Option<Proximity>,
    /// Number of particles that have their keys.
    initialised: usize,
    levy: Levy,
    /// Size of a Levy step, as a fraction of the range of a key.
    pub(super) alpha: f64,
    chaos: f64,
    /// Sums of the distances in eq. (25), as far as they are computed.
    distances: Vec<Spread>,
    row: usize,
    /// kappa of the swarm, or the mean of those of its particles.
    pub(super) kappa: f64,
    pub(super) tau: f64,
    /// Which particles fly in this round, and where they came from.
    flies: Vec<bool>,
    before: Vec<Origin>,
    /// Whether step 7 goes back to step 4.
    back: bool,
    /// Weights of the particle that is being moved.
    pull: Weights,
    learning: (f64, f64),
    /// Number of rounds without a better path.
    pub(super) idle: u32,
    /// Prospect-regret value of the best path.
    z: f64,
}

/// State of a particle before a flight.
struct Origin {
    particle: usize,
    keys: Vec<f64>,
    value: f64,
    tour: Vec<NodeId>,
}

impl LpspsoGuide {
    pub(super) fn new(by: Lpspso) -> Self {
        Self {
            proximity: None,
            initialised: 0,
            levy: Levy::new(by.levy_beta),
            alpha: 0.0,
            chaos: by.singer_start,
            distances: Vec::new(),
            row: 0,
            kappa: 0.0,
            tau: 1.0,
            flies: Vec::new(),
            before: Vec::new(),
            back: false,
            pull: Weights::default(),
            learning: (0.0, 0.0),
            idle: 0,
            z: 0.0,
            by,
        }
    }

    /// Whether the swarm stagnates, step 7. Then the iterations without a gain are counted again.
    pub(super) fn stagnates(&mut self, stagnation: Stagnation) -> bool {
        let stagnates =
            self.by.stagnation == stagnation && self.idle >= self.by.patience && self.kappa < self.tau;
        if stagnates {
            self.idle = 0;
        }
        stagnates
    }

    /// Moves a particle by a Levy flight, eq. (21).
    pub(super) fn fly(&mut self, swarm: &mut Swarm, i: usize, range: Range<usize>) {
        let Swarm { evaluator, particles, rng, .. } = swarm;
        let (keys, own) = (&evaluator.keys, &mut particles[i].keys);
        match self.by.flights {
            Flights::Keys => {
                let end = range.end;
                for key in &mut own[range] {
                    *key = (*key + self.alpha * self.levy.step(rng)).clamp(0.0, 1.0);
                }
                if keys.permutes() && end == keys.count() {
                    keys.rank(own);
                }
            }
            Flights::Insertion if range.start == 0 => {
                let step = self.by.levy_step * self.levy.step(rng);
                // An insertion goes to another position, or it would be no flight.
                let step = if step.abs() < 1.0 { step.signum() } else { step };
                let k = rng.below(keys.items().len());
                keys.insert(own, k, step);
            }
            Flights::Insertion => {}
        }
    }
}

impl Guide for LpspsoGuide {
    fn initialise(&mut self, swarm: &mut Swarm) -> Option<u64> {
        let count = swarm.particles.len();
        let evaluator = &swarm.evaluator;
        let (legs, keys) = (&evaluator.space.legs, &evaluator.keys);
        let most = self.by.proximity_steps;
        let proximity = self.proximity.get_or_insert_with(|| Proximity::new(legs, keys, count, most));
        if let Some(priced) = proximity.piece(legs, keys, &swarm.all) {
            if let Some(path) = proximity.shorter() {
                swarm.found = Some(path);
            }
            return Some(priced);
        }
        // If there are fewer paths than particles, several particles get the same path and differ by their velocities.
        if self.initialised < count {
            let path = std::mem::take(&mut proximity.paths[0]);
            swarm.draw(self.initialised, Some(&path.1));
            proximity.paths.rotate_left(1);
            if let Some(last) = proximity.paths.last_mut() {
                *last = path;
            }
            self.initialised += 1;
            return Some(swarm.evaluator.keys.count() as u64);
        }
        self.proximity = None;
        self.alpha = self.by.levy_step / swarm.evaluator.keys.items().len() as f64;
        None
    }

    /// Step 3: compares paths by the prospect-regret value.
    fn update_bests(&mut self, swarm: &mut Swarm) {
        for before in self.before.drain(..) {
            let p = &mut swarm.particles[before.particle];
            if p.value > before.value {
                (p.keys, p.value, p.tour) = (before.keys, before.value, before.tour);
            }
        }
        let now: Vec<f64> = swarm.particles.iter().map(|p| p.value).collect();
        let begun = swarm.round > 0;
        let kept: Vec<f64> = swarm.particles.iter().filter(|_| begun).map(|p| p.best_value).collect();
        let by = &self.by;
        let prospect = Prospect {
            alpha: by.alpha,
            beta: by.beta,
            gamma: by.gamma,
            delta: by.delta,
            phi: by.phi,
            avoidance: by.avoidance,
        };
        let outcomes = Outcomes::new(prospect, &now, &kept);
        let led = swarm.particles[swarm.leader].best_value;
        swarm.remember(|new, old| outcomes.value(new) > outcomes.value(old));
        let leads = swarm.particles[swarm.leader].best_value;
        self.idle = if begun && leads >= led { self.idle + 1 } else { 0 };
        self.z = outcomes.value(leads);
        self.back = self.stagnates(Stagnation::Step4);
    }

    fn goes_back(&self) -> bool {
        self.back
    }

    /// Steps 4 and 5: the parameters, and the distances between particles, one row of them at a time.
    fn prepare_round(&mut self, swarm: &mut Swarm) -> Option<u64> {
        let count = swarm.particles.len();
        if self.row == 0 {
            self.distances = vec![Spread::NONE; count];
        }
        if self.row + 1 < count {
            let (here, others) = swarm.particles[self.row..].split_first()?;
            add_distances(
                &mut self.distances,
                self.row,
                &here.keys,
                others.iter().map(|o| o.keys.as_slice()),
            );
            self.row += 1;
            // Comparing 16 keys takes about as long as pricing a leg.
            return Some((others.len() * here.keys.len() / 16) as u64);
        }
        self.row = 0;
        let share = swarm.share();
        let kappas: Vec<f64> = match self.by.kappa {
            Kappa::Swarm => vec![kappa(&self.distances); count],
            Kappa::Particle => self.distances.iter().map(Spread::kappa).collect(),
        };
        self.tau = tau(share);
        // Step 4 moves by (19) and (20) whatever the threshold says.
        self.flies = kappas.iter().map(|&kappa| !self.back && kappa > self.tau).collect();
        self.kappa = match self.by.kappa {
            Kappa::Swarm => kappas.first().copied().unwrap_or(0.0),
            Kappa::Particle => kappas.iter().sum::<f64>() / count as f64,
        };
        // All parameters of step 4 except the chaotic number are functions of t, so only that number changes.
        if self.stagnates(Stagnation::Chaos) {
            self.chaos = singer(self.chaos, self.by.singer_mu);
        }
        self.chaos = singer(self.chaos, self.by.singer_mu);
        self.learning = learning(share, self.by.learning_a, self.by.c_sum);
        let (least, most) = (self.by.inertia_least, self.by.inertia_most);
        self.pull.inertia = inertia(share, self.by.inertia_base, least, most);
        self.pull.swarm = self.learning.1 * self.chaos;
        None
    }

    /// Step 6: moves the particles.
    fn move_keys(&mut self, swarm: &mut Swarm, i: usize, keys: Range<usize>) {
        if keys.start == 0 {
            self.pull.own = self.learning.0 * swarm.rng.uniform();
            if self.flies[i] && self.by.flights_must_gain {
                let p = &swarm.particles[i];
                let (keys, tour) = (p.keys.clone(), p.tour.clone());
                self.before.push(Origin { particle: i, keys, value: p.value, tour });
            }
        }
        if self.flies[i] {
            return self.fly(swarm, i, keys);
        }
        let pull = self.pull;
        if self.by.settings.draws == Draws::Equation {
            return swarm.pull(i, keys, |_| pull);
        }
        let (chaos, learning, mu) = (&mut self.chaos, self.learning, self.by.singer_mu);
        swarm.pull(i, keys, |rng| {
            *chaos = singer(*chaos, mu);
            Weights { own: learning.0 * rng.uniform(), swarm: learning.1 * *chaos, ..pull }
        });
    }

    fn curves(&self) -> Vec<Curve> {
        let curve = |name, value| Curve { name, value };
        vec![
            curve("prospect-regret value of the shortest (Z)", self.z),
            curve("inertia (ω)", self.pull.inertia),
            curve("own learning (c1)", self.learning.0),
            curve("swarm learning (c2)", self.learning.1),
            curve("Singer map (r2)", self.chaos),
            curve("spread (κ)", self.kappa),
            curve("threshold (τ)", self.tau),
            curve(
                "Levy flight",
                self.flies.iter().filter(|f| **f).count() as f64 / self.flies.len().max(1) as f64,
            ),
        ]
    }
}
