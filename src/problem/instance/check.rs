//! Checks a tour against its instance and computes its length, from the numbers of the file and without any code of the
//! solvers.

use super::model::Instance;
use rustc_hash::FxHashMap;

/// A fault of a tour, in the node numbers of the file.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
pub enum Fault {
    /// There is no such node.
    #[error("There is no node {0}.")]
    Unknown(u32),
    /// Two nodes of one set, or one of them twice.
    #[error("Node {0} is one too many of its set.")]
    Twice(u32),
    /// A set, named by its first node, is left out.
    #[error("No node of the set of node {0} is visited.")]
    Missing(u32),
    /// A node comes before one whose set it has to wait for.
    #[error("Node {0} comes too early: node {1} has to come before it.")]
    Early(u32, u32),
    /// An edge that every tour must take is not in this one.
    #[error("The fixed edge between {0} and {1} is not taken.")]
    Untaken(u32, u32),
    /// The tour does not start where it has to.
    #[error("The tour starts at node {0}, not at the start group.")]
    Start(u32),
}

/// The length of a closed tour given by node numbers.
///
/// # Errors
/// The first fault found.
pub fn check(instance: &Instance, tour: &[u32]) -> Result<f64, Fault> {
    let (problem, numbers) = (&instance.problem, &instance.numbers);
    let mut place: Vec<Option<usize>> = vec![None; instance.sets()];
    let mut nodes = Vec::with_capacity(tour.len());
    let by_number: FxHashMap<u32, usize> = numbers.iter().copied().zip(0..).collect();
    for (at, &number) in tour.iter().enumerate() {
        let node = *by_number.get(&number).ok_or(Fault::Unknown(number))?;
        let item = instance.set_of(node);
        if place[item].replace(at).is_some() {
            return Err(Fault::Twice(number));
        }
        nodes.push(node);
    }
    let first_of =
        |item: usize| problem.items.get(item).map_or(problem.nodes.len(), |i| i.nodes.start as usize);
    let number_of = |item: usize| numbers[first_of(item)];
    if let Some(missing) = place.iter().position(Option::is_none) {
        return Err(Fault::Missing(number_of(missing)));
    }
    if !problem.pairs.is_empty() && place[problem.items.len() - 1] != Some(0) {
        return Err(Fault::Start(tour[0]));
    }
    for &(first, then) in &problem.pairs {
        let (a, b) = (place[first as usize], place[then as usize]);
        if let (Some(a), Some(b)) = (a, b)
            && a > b
        {
            return Err(Fault::Early(tour[b], tour[a]));
        }
    }
    let mut length = 0.0;
    for (k, &from) in nodes.iter().enumerate() {
        length += instance.cost(from, nodes[(k + 1) % nodes.len()]);
    }
    for &[a, b] in &instance.fixed {
        let next_to = |k: usize, at: usize| tour[(at + k) % tour.len()];
        let taken = tour
            .iter()
            .position(|&n| n == a)
            .is_some_and(|at| next_to(1, at) == b || next_to(tour.len() - 1, at) == b);
        if !taken {
            return Err(Fault::Untaken(a, b));
        }
        length += instance.lowered;
    }
    Ok(length)
}
