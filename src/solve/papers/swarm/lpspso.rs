//! LPSPSO: P. Qu, F. Du, "Improved Particle Swarm Optimization for Laser Cutting Path Planning", IEEE Access 11 (2023), doi
//! 10.1109/ACCESS.2023.3236006.
//!
//! The improved proximity method initialises the swarm (`proximity.rs`), and the prospect-regret value compares its paths
//! (`prospect.rs`). In each iteration the particles move by (19) and (20), with the inertia (16), the learning factors (17)
//! and the chaotic number (18); or they make Levy flights (21)-(24) if the threshold (25)-(27) is passed (`rules.rs`).

use super::particles::Swarm;
use super::prospect::{Outcomes, Prospect};
use super::proximity::Proximity;
use super::rules::{Levy, Spread, add_distances, inertia, kappa, learning, singer, tau};
use super::run::{Guide, Run};
use super::settings::{Draws, SwarmSettings, Weights};
use crate::problem::{NodeId, Problem};
use crate::solve::Curve;
use crate::solve::rng::Draw;
use crate::solve::{Search, Solution, Solver, SolverInfo};
use serde::{Deserialize, Serialize};
use std::ops::Range;

/// Whose spread is compared with the threshold of eqs (26) and (27).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Kappa {
    /// One value for the swarm, from the mean distances of all particles, as the text of section IV.E has it: either all
    /// particles fly or none.
    #[default]
    Swarm,
    /// One value a particle, from its distances to the others: step 5 prints them with an index of the particle.
    Particle,
}

/// What a Levy flight, eq. (21), moves.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Flights {
    /// Every key by a step of its own.
    #[default]
    Keys,
    /// One random item, which is inserted some positions further on or back.
    Insertion,
}

/// What step 7 does when the swarm stagnates.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Stagnation {
    /// The chaotic number is drawn once more.
    #[default]
    Chaos,
    /// The method goes back to step 4, as printed: within the same iteration all particles move by (19) and (20) with a new
    /// chaotic number, and are evaluated.
    Step4,
}

/// The method with its parameters.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Lpspso {
    /// Parameters of every swarm method.
    #[serde(flatten)]
    pub settings: SwarmSettings,
    /// Largest number of steps of all tours that the proximity method constructs. The paper starts a tour at every feature
    /// point, which takes hours on large sheets; here evenly spaced points are used if there are too many.
    pub proximity_steps: u64,
    /// Largest inertia, eq. (16).
    pub inertia_most: f64,
    /// Smallest inertia, eq. (16).
    pub inertia_least: f64,
    /// Base of the power in eq. (16); the paper does not give it.
    pub inertia_base: f64,
    /// a of the learning factors, eq. (17).
    pub learning_a: f64,
    /// Sum of the learning factors, eq. (17): printed 2.5. The range that the text quotes for c2, 0.75 to 1.75, follows from
    /// 3.0.
    pub c_sum: f64,
    /// mu of the Singer map, eq. (18).
    pub singer_mu: f64,
    /// First value of the Singer map.
    pub singer_start: f64,
    /// Exponent beta of Levy steps, eqs (23) and (24).
    pub levy_beta: f64,
    /// Size alpha of Levy steps, eq. (21), in positions of the order. The paper does not give it. With 0.4, a tenth of the
    /// keys move by a position or more; for flights that insert one item, 10 of 43 positions gave the shortest paths.
    pub levy_step: f64,
    /// Whether a flight that ends at a longer path is undone. The paper does not say; without this, flights are a random
    /// walk.
    pub flights_must_gain: bool,
    /// Whose spread decides on flights.
    pub kappa: Kappa,
    /// What a flight moves.
    pub flights: Flights,
    /// What happens when the swarm stagnates, step 7.
    pub stagnation: Stagnation,
    /// Number of iterations without a better path after which the swarm stagnates, step 7.
    pub patience: u32,
    /// Exponent of gains, eq. (5).
    pub alpha: f64,
    /// Exponent of losses, eq. (5).
    pub beta: f64,
    /// Factor by which losses count more than gains, eq. (5).
    pub gamma: f64,
    /// Exponent of the weight of gains, eq. (6).
    pub delta: f64,
    /// Exponent of the weight of losses, eq. (7).
    pub phi: f64,
    /// Regret avoidance, eqs (11) and (12); the paper uses the symbol of eq. (7) for it.
    pub avoidance: f64,
}

impl Default for Lpspso {
    fn default() -> Self {
        Self {
            settings: SwarmSettings::with(0.05, Draws::Equation),
            proximity_steps: 1_000_000,
            inertia_most: 0.95,
            inertia_least: 0.40,
            inertia_base: std::f64::consts::E,
            learning_a: 1.25,
            c_sum: 2.5,
            singer_mu: 1.04,
            singer_start: 0.18,
            levy_beta: 1.5,
            levy_step: 0.4,
            flights_must_gain: true,
            kappa: Kappa::Swarm,
            flights: Flights::Keys,
            stagnation: Stagnation::Chaos,
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
        Run::start(problem, seed, &self.settings, LpspsoGuide::new(self.clone()))
    }
}

/// The rules of the method and their current values.
struct LpspsoGuide {
    by: Lpspso,
    proximity: Option<Proximity>,
    /// Number of particles that have their keys.
    initialised: usize,
    levy: Levy,
    /// Size of a Levy step, as a fraction of the range of a key.
    alpha: f64,
    chaos: f64,
    /// Sums of the distances in eq. (25), as far as they are computed.
    distances: Vec<Spread>,
    row: usize,
    /// kappa of the swarm, or the mean of those of its particles.
    kappa: f64,
    tau: f64,
    /// Which particles fly in this round, and where they came from.
    flies: Vec<bool>,
    before: Vec<Origin>,
    /// Whether step 7 goes back to step 4.
    back: bool,
    /// Weights of the particle that is being moved.
    pull: Weights,
    learning: (f64, f64),
    /// Number of rounds without a better path.
    idle: u32,
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
    fn new(by: Lpspso) -> Self {
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
    fn stagnates(&mut self, stagnation: Stagnation) -> bool {
        let stagnates =
            self.by.stagnation == stagnation && self.idle >= self.by.patience && self.kappa < self.tau;
        if stagnates {
            self.idle = 0;
        }
        stagnates
    }

    /// Moves a particle by a Levy flight, eq. (21).
    fn fly(&mut self, swarm: &mut Swarm, i: usize, range: Range<usize>) {
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

#[cfg(test)]
#[allow(clippy::float_cmp, reason = "the numbers of the examples are exact")]
mod tests {
    use super::super::super::keys::Decode;
    use super::super::super::test_sheet::sheet;
    use super::*;
    use crate::solve::rng::seeded;

    fn points() -> Problem {
        sheet(&[&[[0.0, 0.0]], &[[1.0, 0.0]], &[[2.0, 0.0]], &[[3.0, 0.0]]], None, "length")
    }

    #[test]
    fn equations_21_and_22_by_hand() {
        let problem = points();
        let fly = |decode, flights| {
            let by = Lpspso { flights, levy_step: 1.0, ..Lpspso::default() };
            let settings = SwarmSettings { particles: 1, decode, ..by.settings };
            let mut swarm = Swarm::new(&problem, 4, &settings);
            swarm.particles[0].keys = vec![0.125, 0.375, 0.625, 0.875];
            let mut guide = LpspsoGuide::new(by);
            guide.alpha = 0.25;
            guide.fly(&mut swarm, 0, 0..4);
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
    fn step_7_by_hand() {
        let stagnates = |stagnation, idle, kappa| {
            let mut guide = LpspsoGuide::new(Lpspso { stagnation, ..Lpspso::default() });
            (guide.idle, guide.kappa, guide.tau) = (idle, kappa, 0.5);
            (guide.stagnates(Stagnation::Chaos), guide.stagnates(Stagnation::Step4), guide.idle)
        };
        // After ten iterations without a gain below the threshold, and only as the reading has it.
        assert_eq!(stagnates(Stagnation::Chaos, 10, 0.4), (true, false, 0));
        assert_eq!(stagnates(Stagnation::Step4, 10, 0.4), (false, true, 0));
        assert_eq!(stagnates(Stagnation::Step4, 9, 0.4), (false, false, 9));
        assert_eq!(stagnates(Stagnation::Step4, 10, 0.6), (false, false, 10));
    }

    #[test]
    fn going_back_to_step_4_takes_a_swarm_of_evaluations_within_one_iteration() {
        // The first path is the best there is, so the swarm stagnates again and again.
        let problem = points();
        let moves = |stagnation| {
            let settings = SwarmSettings { particles: 8, rounds: 40, ..Lpspso::default().settings };
            let by = Lpspso { settings, stagnation, patience: 2, ..Lpspso::default() };
            let mut search = by.start(&problem, 3, None);
            while search.step(1000).status != crate::solve::Status::Exhausted {}
            (search.insight().map(|i| i.round), search.telemetry().moves)
        };
        let (chaos, back) = (moves(Stagnation::Chaos), moves(Stagnation::Step4));
        assert_eq!(chaos.0, back.0, "as many iterations");
        assert!(back.1 > chaos.1, "{back:?} {chaos:?}");
    }
}
