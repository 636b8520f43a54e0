//! Parameters that several swarm methods share. Each method holds them in a field that serde flattens, so callers see one
//! flat object.

use super::super::keys::Decode;
use super::super::legs::Measure;
use crate::problem::NodeId;
use serde::{Deserialize, Serialize};

/// When the random numbers of eqs (14) and (19) are drawn.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Draws {
    /// The first number once a particle and the second once an iteration, for all dimensions alike: the equations print
    /// them without an index of the dimension, and figure 2 has one number an iteration.
    Equation,
    /// Both for each key.
    #[default]
    Key,
}

/// Parameters of every swarm method.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct SwarmSettings {
    /// Number of particles (N).
    pub particles: u32,
    /// Number of iterations (tmax), after which the method ends.
    pub rounds: u32,
    /// How distances are measured, eq. (1).
    pub measure: Measure,
    /// Whether 2-opt, Or-opt and the choice of the best entries improve each particle's tour before it is measured. This
    /// is not in the paper, but random keys alone do not come near its results.
    pub local_search: bool,
    /// The node that every path starts with ("fixed start"); `None` lets every node be the first ("random start").
    pub first: Option<NodeId>,
    /// Largest velocity, as a fraction of the range of a key.
    pub fastest: f64,
    /// How a particle becomes a tour.
    pub decode: Decode,
    /// When the random numbers of eqs (14) and (19) are drawn.
    pub draws: Draws,
    /// Number of near contours of each that local search and ants consider. As many as there are contours, or more, switches
    /// the lists off. Ten are enough for 2-opt on uniform instances (Johnson & McGeoch 1997, section 3.3).
    pub neighbours: u32,
}

impl SwarmSettings {
    /// The settings of the paper, with local search. The largest velocity and the decoding are not in the paper.
    pub(super) const fn with(fastest: f64, draws: Draws) -> Self {
        let (measure, decode) = (Measure::Euclidean, Decode::Keys);
        let (particles, rounds, local_search, neighbours) = (50, 600, true, 10);
        Self { particles, rounds, measure, local_search, first: None, fastest, decode, draws, neighbours }
    }
}

/// Constant weights of the standard swarm, eq. (14).
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Weights {
    /// Inertia weight.
    pub inertia: f64,
    /// Learning factor towards the particle's own best position.
    pub own: f64,
    /// Learning factor towards the best position of the swarm.
    pub swarm: f64,
}

impl Weights {
    /// The constricted swarm of Clerc & Kennedy (2002).
    pub(super) const CONSTRICTED: Self = Self { inertia: 0.7298, own: 1.496_18, swarm: 1.496_18 };
}
