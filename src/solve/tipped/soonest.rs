//! A path that goes always to where a cut can begin soonest: a hot neighbour may take longer than a cool cut farther away.

use super::super::greedy::Candidates;
use crate::heat::Cooling;
use crate::machine::AirTime;
use crate::problem::{ItemId, Problem};
use crate::solve::traits::Stop;

/// Most items: at each step all that are hot are looked at, which takes about a second for as many.
const MOST: usize = 20_000;

/// The stops of the path; `None` for larger problems, and for costs by a table.
pub(super) fn soonest(problem: &Problem, cooling: &Cooling) -> Option<Vec<Stop>> {
    if problem.items.len() > MOST || problem.table().is_some() {
        return None;
    }
    let air = AirTime::new(&problem.machine);
    let mut open = Candidates::new(problem);
    let mut stops: Vec<Stop> = Vec::with_capacity(problem.items.len());
    let mut done: Vec<(ItemId, f64)> = Vec::new();
    let (mut last, mut now, mut head) = (None, 0.0, problem.home);
    // By item: the step at which its due was last asked for, what it was, and how long the move to it took.
    let mut asked: Vec<(usize, f64)> = vec![(0, 0.0); problem.items.len()];
    loop {
        let step = stops.len() + 1;
        // What is due depends little on which of its nodes an item is entered by.
        let due = |item: ItemId, seconds: f64| {
            let Some(known) = asked.get_mut(item as usize).filter(|k| k.0 != step) else {
                return asked.get(item as usize).map_or(0.0, |k| k.1);
            };
            let cost = cooling.cost(cooling.due(item, now + seconds, done.iter().rev().copied()));
            *known = (step, cost);
            cost
        };
        let Some(node) = open.soonest(&air, last, due) else { return Some(stops) };
        let (known, stop) = (problem.nodes.get(node as usize)?, Stop::at(problem, node));
        let item = problem.items.get(known.item as usize)?;
        let arrival = now + air.seconds(head, known.entry);
        let due = cooling.due(known.item, arrival, done.iter().rev().copied());
        now = arrival + due.wait + item.fixed + item.extra(node, known.along);
        (last, head) = (Some(node), known.exit);
        done.push((known.item, now));
        stops.push(stop);
        open.done(known.item);
    }
}
