//! The methods `hull-pso`, `ofa` and `woa` and their parameters (section 5.2).

use super::key_search::KeySearch;
use super::permutations::{SwapForagers, SwapParticles, SwapWhales};
use super::rlsga::SOURCE;
use super::rules::{Foragers, Particles, Whales};
use super::settings::{Encoding, HullSettings};
use crate::problem::Problem;
use crate::solve::{Search, Solution, Solver, SolverInfo};
use serde::{Deserialize, Serialize};

/// Particle swarm optimisation over the segments.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct HullPso {
    /// Parameters of every method for hull parts.
    #[serde(flatten)]
    pub settings: HullSettings,
    /// How a path is represented.
    pub encoding: Encoding,
    /// Inertia weight omega.
    pub inertia: f64,
    /// Acceleration c1 towards the particle's own best.
    pub own: f64,
    /// Acceleration c2 towards the best of all.
    pub all: f64,
}

impl Default for HullPso {
    fn default() -> Self {
        let (inertia, own, all) = (0.3, 0.5, 0.5);
        Self { settings: HullSettings::default(), encoding: Encoding::Keys, inertia, own, all }
    }
}

impl Solver for HullPso {
    fn info(&self) -> SolverInfo {
        SolverInfo {
            name: "hull-pso",
            title: "PSO (hull parts)",
            about: "Particle swarm optimisation over the segments of contours, as RLSGA was compared with.",
            source: Some(SOURCE),
        }
    }

    fn start<'p>(&self, problem: &'p Problem, seed: u64, _warm: Option<&Solution>) -> Box<dyn Search + 'p> {
        let &Self { settings, inertia, own, all, .. } = self;
        match self.encoding {
            Encoding::Keys => KeySearch::start(problem, Particles::new(inertia, own, all), settings, seed),
            Encoding::Permutation => {
                KeySearch::start(problem, SwapParticles::new(inertia, own, all), settings, seed)
            }
        }
    }
}

/// The optimal foraging algorithm over the segments.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Ofa {
    /// Parameters of every method for hull parts.
    #[serde(flatten)]
    pub settings: HullSettings,
    /// How a path is represented.
    pub encoding: Encoding,
    /// The scaling factor k at the start.
    pub k: f64,
    /// Amount by which k falls until the end.
    pub k_fall: f64,
}

impl Default for Ofa {
    fn default() -> Self {
        Self { settings: HullSettings::default(), encoding: Encoding::Keys, k: 0.9, k_fall: 0.5 }
    }
}

impl Solver for Ofa {
    fn info(&self) -> SolverInfo {
        SolverInfo {
            name: "ofa",
            title: "OFA",
            about: "Optimal foraging over the segments of contours, as RLSGA was compared with.",
            source: Some(SOURCE),
        }
    }

    fn start<'p>(&self, problem: &'p Problem, seed: u64, _warm: Option<&Solution>) -> Box<dyn Search + 'p> {
        let rule = Foragers::new(self.k, self.k_fall);
        match self.encoding {
            Encoding::Keys => KeySearch::start(problem, rule, self.settings, seed),
            Encoding::Permutation => KeySearch::start(problem, SwapForagers(rule), self.settings, seed),
        }
    }
}

/// The whale optimisation algorithm over the segments.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Woa {
    /// Parameters of every method for hull parts.
    #[serde(flatten)]
    pub settings: HullSettings,
    /// How a path is represented.
    pub encoding: Encoding,
    /// The coefficient A at the start.
    pub a: f64,
    /// The coefficient A at the end, A_min.
    pub a_min: f64,
    /// Weight C of the prey.
    pub c: f64,
    /// Shape b of the spiral.
    pub b: f64,
}

impl Default for Woa {
    fn default() -> Self {
        Self {
            settings: HullSettings::default(),
            encoding: Encoding::Keys,
            a: 2.0,
            a_min: 0.0,
            c: 1.0,
            b: 1.0,
        }
    }
}

impl Solver for Woa {
    fn info(&self) -> SolverInfo {
        SolverInfo {
            name: "woa",
            title: "WOA",
            about: "Whale optimisation over the segments of contours, as RLSGA was compared with.",
            source: Some(SOURCE),
        }
    }

    fn start<'p>(&self, problem: &'p Problem, seed: u64, _warm: Option<&Solution>) -> Box<dyn Search + 'p> {
        let rule = Whales { reach: self.a, least: self.a_min, weight: self.c, spiral: self.b };
        match self.encoding {
            Encoding::Keys => KeySearch::start(problem, rule, self.settings, seed),
            Encoding::Permutation => KeySearch::start(problem, SwapWhales(rule), self.settings, seed),
        }
    }
}
