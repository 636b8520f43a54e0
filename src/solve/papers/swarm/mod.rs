//! LPSPSO of Qu & Du, and the three swarms that they compare it with.

mod aco_pso;
mod evaluator;
mod k_pso;
mod lpspso;
mod particles;
mod prospect;
mod proximity;
mod pso;
mod rules;
mod run;
mod settings;

pub use aco_pso::AcoPso;
pub use k_pso::KPso;
pub use lpspso::{Flights, Kappa, Lpspso, Stagnation, Step4};
pub use prospect::Regret;
pub use proximity::{Initial, Shortest};
pub use pso::Pso;
pub use settings::{Draws, SwarmSettings, Weights};
