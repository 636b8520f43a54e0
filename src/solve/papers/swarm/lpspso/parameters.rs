//! The parameters of LPSPSO, with the readings of what the paper leaves open.

use super::super::prospect::{Prospect, Regret};
use super::super::proximity::{Initial, PROXIMITY_STEPS, Shortest};
use super::super::settings::{Draws, SwarmSettings};
use serde::{Deserialize, Serialize};

/// Whose spread is compared with the threshold of eqs (26) and (27).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Kappa {
    /// One value for the swarm, from the mean distances of all particles, as the text of section IV.E has it: either all
    /// particles fly or none.
    #[default]
    Swarm,
    /// One value a particle, from its distances to the others: step 5 prints them with an index of the particle. Step 7
    /// needs one value for the swarm and takes their mean.
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
    /// The method goes back to step 4: within the same iteration all particles move by (19) and (20) with a new chaotic
    /// number, and are evaluated. The paper does not say whether that counts as an iteration.
    Step4,
}

/// Whether step 4 moves the particles before step 6 does.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Step4 {
    /// Steps 4 and 6 are one move: particles move by (19) and (20), or they fly.
    #[default]
    Merged,
    /// Word for word: in each iteration all particles move by (19) and (20) and are evaluated (step 4); then they fly, or move
    /// again (step 6).
    Separate,
}

/// The method with its parameters.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Lpspso {
    /// Parameters of every swarm method.
    #[serde(flatten)]
    pub settings: SwarmSettings,
    /// Where the particles begin.
    pub initial: Initial,
    /// Largest number of steps of all tours that the proximity method constructs. The paper starts a tour at every feature
    /// point, which takes hours on large sheets; here evenly spaced points are used if there are too many.
    pub proximity_steps: u64,
    /// What the proximity method compares.
    pub shortest: Shortest,
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
    /// Whether step 4 moves the particles too.
    pub step_4: Step4,
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
    /// Whose value (11) and (12) take.
    pub regret: Regret,
}

impl Default for Lpspso {
    fn default() -> Self {
        Self {
            settings: SwarmSettings::with(0.05, Draws::Equation),
            initial: Initial::Proximity,
            proximity_steps: PROXIMITY_STEPS,
            shortest: Shortest::Whole,
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
            step_4: Step4::Merged,
            stagnation: Stagnation::Chaos,
            patience: 10,
            alpha: 0.85,
            beta: 0.85,
            gamma: 2.25,
            delta: 0.61,
            phi: 0.69,
            avoidance: 0.69,
            regret: Regret::Own,
        }
    }
}

impl Lpspso {
    /// The parameters of the prospect-regret value.
    pub(super) fn prospect(&self) -> Prospect {
        let &Self { alpha, beta, gamma, delta, phi, avoidance, regret, .. } = self;
        Prospect { alpha, beta, gamma, delta, phi, avoidance, regret }
    }
}
