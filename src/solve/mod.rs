//! Solvers behind two traits, and the registry that names them.

mod traits;

pub use traits::{Search, Solution, Solver, SolverInfo, Status, Step, Stop, Telemetry};
