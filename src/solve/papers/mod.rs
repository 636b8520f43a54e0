//! Methods of published papers, as published, behind the common traits: to be compared with, and checked by people who
//! know the papers. They are never the best choice for a sheet; the default method is.
//!
//! Every parameter of a paper is a documented field with the paper's value as its default. Where a paper is silent or
//! its print is wrong, the module of the method says what was built and why; each deviation can be switched off.
//!
//! What a method compares is the paper's measure (`legs.rs`), not the seconds of the whole job, and its best solution is
//! its own, also where a nearest-neighbour tour is better: a comparison would be worth nothing otherwise.
//!
//! They are built with the feature `research` only: the browser fetches that wasm file when one of them is chosen.

mod dual;
mod hull;
mod keys;
mod lead;
mod left;
mod legs;
mod local;
mod parameters;
mod published;
mod repair;
mod roulette;
mod swarm;
#[cfg(test)]
mod test_sheet;
mod tree;

pub use dual::DualCodingGa;
pub use hull::{HullPso, HullSettings, Ofa, OperatorRates, Rlsga, Sga, Woa};
pub use legs::{Legs, Measure};
pub use repair::Repair;
pub use swarm::{AcoPso, KPso, Lpspso, Pso, SwarmSettings, Weights};
pub use tree::{GtspLk, InitialPartitions, InitialTours, PartitionTree, Pfr, RepartitionMoves};

use super::{Solver, SolverInfo};
use crate::fields::no_such;
use published::Published;
use serde::Serialize;
use serde::de::DeserializeOwned;

/// A method with what may be set of it, for lists.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Card {
    /// Name, citation.
    #[serde(flatten)]
    pub info: SolverInfo,
    /// Its parameters with their defaults, the paper's where it has them.
    pub parameters: serde_json::Value,
}

/// A method's default form, and how it is made from parameters.
type Entry = (fn() -> Card, Make);
type Make = fn(&str) -> Result<Box<dyn Solver>, String>;

/// Every method.
const METHODS: &[Entry] = &[
    entry::<Lpspso>(),
    entry::<Pso>(),
    entry::<AcoPso>(),
    entry::<KPso>(),
    entry::<Rlsga>(),
    entry::<Sga>(),
    entry::<HullPso>(),
    entry::<Ofa>(),
    entry::<Woa>(),
    entry::<DualCodingGa>(),
    entry::<PartitionTree>(),
    entry::<Pfr>(),
    entry::<GtspLk>(),
];

/// Every method with the defaults of its parameters.
pub fn cards() -> Vec<Card> {
    METHODS.iter().map(|(card, _)| card()).collect()
}

/// The published method of that name with parameters: a JSON object with those that differ from the defaults, or nothing.
///
/// # Errors
/// One sentence: no such method, or parameters it does not have.
pub fn method(name: &str, parameters: &str) -> Result<Box<dyn Solver>, String> {
    let Some((_, make)) = METHODS.iter().find(|(card, _)| card().info.name == name) else {
        let ours = super::methods().iter().map(|m| m.info().name);
        let names: Vec<_> = ours.chain(cards().into_iter().map(|c| c.info.name)).collect();
        return Err(no_such("method", name, &names));
    };
    let parameters = if parameters.trim().is_empty() { "{}" } else { parameters };
    Ok(Box::new(Published(make(parameters)?)))
}

/// An entry of the list for a method whose parameters are its fields.
const fn entry<M: Solver + Default + Serialize + DeserializeOwned + 'static>() -> Entry {
    (card::<M>, make::<M>)
}

fn card<M: Solver + Default + Serialize>() -> Card {
    let method = M::default();
    Card { info: method.info(), parameters: serde_json::to_value(&method).unwrap_or_default() }
}

fn make<M: Solver + Default + Serialize + DeserializeOwned + 'static>(
    parameters: &str,
) -> Result<Box<dyn Solver>, String> {
    Ok(Box::new(parameters::read::<M>(parameters)?))
}
