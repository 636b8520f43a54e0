//! Steps 3 to 7 of LPSPSO: what changes from iteration to iteration, and how the particles move.

use super::super::particles::Swarm;
use super::super::prospect::Outcomes;
use super::super::proximity::Initialisation;
use super::super::rules::{Spread, add_distances, inertia, kappa, learning, singer, tau};
use super::super::run::Guide;
use super::super::settings::{Draws, Weights};
use super::flights::{Flight, Origin};
use super::parameters::{Kappa, Lpspso, Stagnation, Step4};
use crate::solve::Curve;
use crate::solve::insight::charts;
use crate::solve::rng::Draw;
use std::ops::Range;

/// The rules of the method and their current values.
pub(super) struct LpspsoGuide {
    by: Lpspso,
    initialisation: Initialisation,
    flight: Flight,
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
    /// Whether the next move is that of step 4: by (19) and (20), whatever the threshold says.
    step_4: bool,
    /// Whether that move, or the one of step 6 after it, belongs to the iteration under way.
    back: bool,
    /// Weights of the particle that is being moved.
    pull: Weights,
    learning: (f64, f64),
    /// Number of rounds without a better path.
    idle: u32,
    /// Prospect-regret value of the best path.
    z: f64,
}

impl LpspsoGuide {
    /// The rules for an order with this number of items.
    pub(super) fn new(by: Lpspso, items: usize) -> Self {
        Self {
            initialisation: Initialisation::new(by.initial, by.proximity_steps, by.shortest),
            flight: Flight::new(&by, items),
            chaos: by.singer_start,
            distances: Vec::new(),
            row: 0,
            kappa: 0.0,
            tau: 1.0,
            flies: Vec::new(),
            before: Vec::new(),
            step_4: false,
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
}

impl Guide for LpspsoGuide {
    fn initialise(&mut self, swarm: &mut Swarm) -> Option<u64> {
        self.initialisation.piece(swarm)
    }

    /// Step 3: compares paths by the prospect-regret value.
    fn update_bests(&mut self, swarm: &mut Swarm) {
        for origin in self.before.drain(..) {
            origin.return_unless_shorter(swarm);
        }
        let now: Vec<f64> = swarm.particles.iter().map(|p| p.value).collect();
        let begun = swarm.round > 0;
        let kept: Vec<f64> = swarm.particles.iter().filter(|_| begun).map(|p| p.best_value).collect();
        let outcomes = Outcomes::new(self.by.prospect(), &now, &kept);
        let led = swarm.particles[swarm.leader].best_value;
        swarm.remember(|new, old| outcomes.value(new) > outcomes.value(old));
        let leads = swarm.particles[swarm.leader].best_value;
        let separate = self.by.step_4 == Step4::Separate;
        let was_step_4 = separate && self.step_4;
        // Step 7 counts iterations, not evaluations.
        self.idle = if begun && leads >= led { self.idle + u32::from(!was_step_4) } else { 0 };
        self.z = outcomes.value(leads);
        let stagnates = self.stagnates(Stagnation::Step4);
        self.step_4 = stagnates || separate && !was_step_4;
        self.back = stagnates || was_step_4;
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
        self.flies = kappas.iter().map(|&kappa| !self.step_4 && kappa > self.tau).collect();
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
                self.before.push(Origin::of(swarm, i));
            }
        }
        if self.flies[i] {
            return self.flight.fly(swarm, i, keys);
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
        let curve = |chart| move |name, value| Curve { name, value, chart };
        let (weight, flight) = (curve(charts::WEIGHTS), curve(charts::FLIGHTS));
        let flying = self.flies.iter().filter(|f| **f).count() as f64 / self.flies.len().max(1) as f64;
        vec![
            curve(charts::PROSPECT)("prospect-regret value of the shortest (Z)", self.z),
            weight("inertia (ω)", self.pull.inertia),
            weight("own learning (c1)", self.learning.0),
            weight("swarm learning (c2)", self.learning.1),
            curve(charts::SINGER)("Singer map (r2)", self.chaos),
            flight("spread (κ)", self.kappa),
            flight("threshold (τ)", self.tau),
            flight("share of particles that fly", flying),
        ]
    }
}

#[cfg(test)]
mod tests {
    use super::super::super::super::test_sheet::sheet;
    use super::super::super::settings::SwarmSettings;
    use super::*;
    use crate::problem::Problem;
    use crate::solve::Solver;

    fn points() -> Problem {
        sheet(&[&[[0.0, 0.0]], &[[1.0, 0.0]], &[[2.0, 0.0]], &[[3.0, 0.0]]], None, "length")
    }

    #[test]
    fn step_7_by_hand() {
        let stagnates = |stagnation, idle, kappa| {
            let mut guide = LpspsoGuide::new(Lpspso { stagnation, ..Lpspso::default() }, 4);
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
    fn step_4_as_a_move_of_its_own_doubles_the_evaluations_of_an_iteration() {
        let problem = points();
        let run = |step_4| {
            let settings =
                SwarmSettings { particles: 8, rounds: 40, local_search: false, ..Lpspso::default().settings };
            let by = Lpspso { settings, step_4, patience: 1000, ..Lpspso::default() };
            let mut search = by.start(&problem, 3, None);
            while search.step(1000).status != crate::solve::Status::Exhausted {}
            (search.insight().map(|i| i.round), search.telemetry().moves as f64)
        };
        let (merged, separate) = (run(Step4::Merged), run(Step4::Separate));
        assert_eq!(merged.0, separate.0, "as many iterations");
        assert!((1.8..2.2).contains(&(separate.1 / merged.1)), "{separate:?} {merged:?}");
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
