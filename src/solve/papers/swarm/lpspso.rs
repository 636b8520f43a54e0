//! LPSPSO: P. Qu, F. Du, "Improved Particle Swarm Optimization for Laser Cutting Path Planning", IEEE Access 11 (2023),
//! doi 10.1109/ACCESS.2023.3236006.
//!
//! A swarm sown by the improved proximity method (`proximity.rs`), judged by the prospect-regret value (`prospect.rs`),
//! moved by (19) and (20) with inertia (16), learning factors (17) and a chaotic number (18) that change from iteration
//! to iteration, or sent on Levy flights (21)-(24) when the threshold (25)-(27) says so (`rules.rs`).

use super::flock::Flock;
use super::prospect::{Outcomes, Prospect};
use super::proximity::Proximity;
use super::rules::{Levy, add_distances, inertia, kappa, learning, singer, tau};
use super::run::{Guide, Run};
use super::settings::{SwarmSettings, Weights};
use crate::problem::{NodeId, Problem};
use crate::solve::Curve;
use crate::solve::rng::Draw;
use crate::solve::{Search, Solution, Solver, SolverInfo};
use serde::{Deserialize, Serialize};
use std::ops::Range;

/// The method with its parameters.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Lpspso {
    /// Parameters of every swarm method.
    #[serde(flatten)]
    pub settings: SwarmSettings,
    /// Steps of all walks of the proximity method together: the paper walks from every feature point; on large sheets
    /// that takes hours, so fewer are tried, evenly spread.
    pub proximity_steps: u64,
    /// Greatest inertia, eq. (16).
    pub inertia_most: f64,
    /// Least inertia, eq. (16).
    pub inertia_least: f64,
    /// Base of the power, eq. (16); not given in the paper.
    pub inertia_base: f64,
    /// a of the learning factors, eq. (17).
    pub learning_a: f64,
    /// b of the learning factors, eq. (17).
    pub learning_b: f64,
    /// mu of the Singer map, eq. (18).
    pub singer_mu: f64,
    /// Its first number.
    pub singer_start: f64,
    /// Exponent beta of Levy steps, eqs (23) and (24).
    pub levy_beta: f64,
    /// Size alpha of Levy steps, eq. (21), not given in the paper: in places of the order. With 0.4 a tenth of the keys
    /// move by a place or more.
    pub levy_step: f64,
    /// A flight that ends at a longer path is taken back. The paper does not say; without, flights are a random walk.
    pub flights_must_gain: bool,
    /// Iterations without a better path after which the chaotic number is drawn once more, step 7.
    pub patience: u32,
    /// Exponent of gains, eq. (5).
    pub alpha: f64,
    /// Exponent of losses, eq. (5).
    pub beta: f64,
    /// How much more losses count than gains, eq. (5).
    pub gamma: f64,
    /// Exponent of the weight of gains, eq. (6).
    pub delta: f64,
    /// Exponent of the weight of losses, eq. (7).
    pub phi: f64,
    /// Regret avoidance, eqs (11) and (12); the paper has the letter of eq. (7) for it.
    pub avoidance: f64,
}

impl Default for Lpspso {
    fn default() -> Self {
        Self {
            settings: SwarmSettings::with_fastest(0.05),
            proximity_steps: 1_000_000,
            inertia_most: 0.95,
            inertia_least: 0.40,
            inertia_base: std::f64::consts::E,
            learning_a: 1.25,
            learning_b: 2.5,
            singer_mu: 1.04,
            singer_start: 0.18,
            levy_beta: 1.5,
            levy_step: 0.4,
            flights_must_gain: true,
            patience: 10,
            alpha: 0.85,
            beta: 0.85,
            gamma: 2.25,
            delta: 0.61,
            phi: 0.69,
            avoidance: 0.69,
        }
    }
}

impl Solver for Lpspso {
    fn info(&self) -> SolverInfo {
        SolverInfo {
            name: "lpspso",
            title: "LPSPSO",
            about: "Particle swarm with Levy flights, a power function for its inertia and a Singer map.",
            source: Some(
                "P. Qu, F. Du, Improved Particle Swarm Optimization for Laser Cutting Path Planning, IEEE Access 11 \
                 (2023), doi 10.1109/ACCESS.2023.3236006",
            ),
        }
    }

    fn start<'p>(&self, problem: &'p Problem, seed: u64, _warm: Option<&Solution>) -> Box<dyn Search + 'p> {
        Run::start(problem, seed, &self.settings, Swarm::new(self.clone()))
    }
}

/// The method at work.
struct Swarm {
    by: Lpspso,
    proximity: Option<Proximity>,
    /// Particles that have their keys.
    sown: usize,
    levy: Levy,
    /// Size of a Levy step, in shares of the range of a key.
    alpha: f64,
    chaos: f64,
    /// Sums of the distances (25), as far as they are added up.
    distances: Vec<f64>,
    row: usize,
    kappa: f64,
    tau: f64,
    /// This round is a flight; where its particles came from.
    flight: bool,
    before: Vec<Origin>,
    /// Weights of this round for the particle being moved.
    pull: Weights,
    learning: (f64, f64),
    /// Rounds without a better path.
    idle: u32,
    /// Prospect-regret value of the best path, and of the mean.
    z: f64,
}

/// Where a particle was before a flight.
struct Origin {
    keys: Vec<f64>,
    value: f64,
    tour: Vec<NodeId>,
}

impl Swarm {
    fn new(by: Lpspso) -> Self {
        Self {
            proximity: None,
            sown: 0,
            levy: Levy::new(by.levy_beta),
            alpha: 0.0,
            chaos: by.singer_start,
            distances: Vec::new(),
            row: 0,
            kappa: 0.0,
            tau: 1.0,
            flight: false,
            before: Vec::new(),
            pull: Weights::default(),
            learning: (0.0, 0.0),
            idle: 0,
            z: 0.0,
            by,
        }
    }

    /// Whether the swarm stands still too early, step 7. Then the parameters of step 4 are drawn anew; all but the chaotic
    /// number are functions of t, so it is that.
    fn stir(&mut self) {
        if self.idle >= self.by.patience && self.kappa < self.tau {
            self.idle = 0;
            self.chaos = singer(self.chaos, self.by.singer_mu);
        }
    }
}

impl Guide for Swarm {
    fn sow(&mut self, flock: &mut Flock) -> Option<u64> {
        let count = flock.particles.len();
        let worth = &flock.worth;
        let (legs, keys) = (&worth.ground.legs, &worth.keys);
        let most = self.by.proximity_steps;
        let proximity = self.proximity.get_or_insert_with(|| Proximity::new(legs, keys, count, most));
        if let Some(priced) = proximity.piece(legs, keys, &flock.all) {
            if let Some(path) = proximity.shorter() {
                flock.found = Some(path);
            }
            return Some(priced);
        }
        // With fewer points than particles the paths go round; velocities tell particles apart.
        if self.sown < count {
            let path = std::mem::take(&mut proximity.paths[0]);
            flock.draw(self.sown, Some(&path.1));
            proximity.paths.rotate_left(1);
            if let Some(last) = proximity.paths.last_mut() {
                *last = path;
            }
            self.sown += 1;
            return Some(flock.worth.keys.count() as u64);
        }
        self.proximity = None;
        self.alpha = self.by.levy_step / flock.worth.keys.items().len() as f64;
        None
    }

    /// Step 3: by the prospect-regret value.
    fn judge(&mut self, flock: &mut Flock) {
        for (p, before) in flock.particles.iter_mut().zip(self.before.drain(..)) {
            if p.value > before.value {
                (p.keys, p.value, p.tour) = (before.keys, before.value, before.tour);
            }
        }
        let now: Vec<f64> = flock.particles.iter().map(|p| p.value).collect();
        let begun = flock.round > 0;
        let kept: Vec<f64> = flock.particles.iter().filter(|_| begun).map(|p| p.best_value).collect();
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
        let led = flock.particles[flock.leader].best_value;
        flock.remember(|new, old| outcomes.value(new) > outcomes.value(old));
        let leads = flock.particles[flock.leader].best_value;
        self.idle = if begun && leads >= led { self.idle + 1 } else { 0 };
        self.z = outcomes.value(leads);
    }

    /// Steps 4 and 5: the parameters, and the distances between particles, a row of them at a time.
    fn prepare(&mut self, flock: &mut Flock) -> Option<u64> {
        let count = flock.particles.len();
        if self.row == 0 {
            self.distances = vec![0.0; count];
        }
        if self.row + 1 < count {
            let (here, others) = flock.particles[self.row..].split_first()?;
            add_distances(
                &mut self.distances,
                self.row,
                &here.keys,
                others.iter().map(|o| o.keys.as_slice()),
            );
            self.row += 1;
            // Sixteen keys compared cost about as much as a leg priced.
            return Some((others.len() * here.keys.len() / 16) as u64);
        }
        self.row = 0;
        let share = flock.share();
        self.kappa = kappa(&self.distances);
        self.tau = tau(share);
        self.stir();
        self.chaos = singer(self.chaos, self.by.singer_mu);
        self.learning = learning(share, self.by.learning_a, self.by.learning_b);
        let (least, most) = (self.by.inertia_least, self.by.inertia_most);
        self.pull.inertia = inertia(share, self.by.inertia_base, least, most);
        self.pull.swarm = self.learning.1 * self.chaos;
        self.flight = self.kappa > self.tau;
        None
    }

    /// Step 6.
    fn drive(&mut self, flock: &mut Flock, i: usize, keys: Range<usize>) {
        if keys.start == 0 {
            self.pull.own = self.learning.0 * flock.rng.uniform();
            if self.flight && self.by.flights_must_gain {
                let p = &flock.particles[i];
                self.before.push(Origin { keys: p.keys.clone(), value: p.value, tour: p.tour.clone() });
            }
        }
        if !self.flight {
            let pull = self.pull;
            return flock.pull(i, keys, |_| pull);
        }
        for key in &mut flock.particles[i].keys[keys] {
            *key = (*key + self.alpha * self.levy.step(&mut flock.rng)).clamp(0.0, 1.0);
        }
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
            curve("Levy flight", f64::from(u8::from(self.flight))),
        ]
    }
}
