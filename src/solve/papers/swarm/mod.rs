//! LPSPSO of Qu & Du and the three swarms it is compared with.

mod aco_pso;
mod flock;
mod k_pso;
mod lpspso;
mod prospect;
mod proximity;
mod pso;
mod rules;
mod run;
mod settings;
mod worth;

pub use aco_pso::AcoPso;
pub use k_pso::KPso;
pub use lpspso::Lpspso;
pub use pso::Pso;
pub use settings::{SwarmSettings, Weights};
