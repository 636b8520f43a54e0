//! The stops of a plan at each item: where its legs may end, and what a stop costs.
//!
//! A contour that is cut in one go has one stop, which two legs reach from the same place. One that may be left has a stop wherever it is
//! entered or left: it is resumed where it was left, and finished where it was begun, so that each of these places has two legs. So it is
//! with a pierce group, but there the two legs of a stop end at different places: at the two ends of the path through it, or of a leave
//! point.

use super::super::net::{self, Item, homes, items};
use crate::geometry::DVec2;
use crate::problem::{self, Problem, Stroke, SubPath};

/// A stop: the knots where its legs end, and its seconds beyond those that every plan pays.
#[derive(Clone, Debug, PartialEq)]
pub(in super::super) struct Stop {
    pub(in super::super) ends: [usize; 2],
    pub(in super::super) seconds: f64,
}

/// A path through a pierce group: the stop that it is, and the stops at its leave points, each of which is made once at most.
#[derive(Clone, Debug, PartialEq)]
pub(in super::super) struct Choice {
    pub(in super::super) stop: Stop,
    pub(in super::super) more: Vec<Stop>,
}

/// Which stops a plan makes at an item.
#[derive(Clone, Debug, PartialEq)]
pub(in super::super) enum Stops {
    /// One leg, at its only knot: an end of an open path.
    End,
    /// A stop at one knot. If the item may be left, there may be more of them, at any knots; the number is the seconds that each takes.
    Anywhere(Option<f64>),
    /// A stop with one leg at each of the two knots of a pair.
    Pairs,
    /// One of these paths through a pierce group.
    Paths(Vec<Choice>),
}

/// An item with its stops.
#[derive(Clone, Debug)]
pub(in super::super) struct Member {
    pub(in super::super) item: Item,
    pub(in super::super) stops: Stops,
}

impl Member {
    /// For each knot the first knot of its place. Knots that a stop joins are one place.
    pub(in super::super) fn places(&self) -> Vec<usize> {
        let mut place: Vec<usize> = (0..self.item.knots).collect();
        match &self.stops {
            Stops::End | Stops::Anywhere(_) => {}
            Stops::Pairs => place.iter_mut().for_each(|v| *v -= *v % 2),
            Stops::Paths(choices) => {
                for stop in choices.iter().flat_map(|c| std::iter::once(&c.stop).chain(&c.more)) {
                    let [a, b] = stop.ends.map(|v| place[v]);
                    let (low, high) = (a.min(b), a.max(b));
                    place.iter_mut().filter(|p| **p == high).for_each(|p| *p = low);
                }
            }
        }
        place
    }
}

/// Whether the bound by stops applies: travel is not given by a table, and some contour may be left or is a pierce group.
pub(in super::super) fn applies(problem: &Problem) -> bool {
    let special = |i: &problem::Item| i.leave.is_some() || i.is_pierce_group();
    problem.table().is_none() && problem.items.iter().any(special)
}

/// Home, for an open path its end, and all items with a place.
pub(in super::super) fn members(problem: &Problem) -> Vec<Member> {
    let first = homes(problem);
    let mut all = Vec::new();
    for (k, item) in items(problem).into_iter().enumerate() {
        let Some(of) = k.checked_sub(first).map(|i| &problem.items[i]) else {
            let stops = if first == 2 { Stops::End } else { Stops::Anywhere(None) };
            all.push(Member { item, stops });
            continue;
        };
        if of.nodes.is_empty() {
            continue;
        }
        if of.is_pierce_group() {
            all.push(pierce_group(problem, of));
            continue;
        }
        let stops = if item.paired { Stops::Pairs } else { Stops::Anywhere(again(of)) };
        all.push(Member { item, stops });
    }
    all
}

/// Least seconds of one more stop, beside what [`problem::Item::least`] gives back for sharp corners. How much the head
/// is slowed down is left out: stops near each other share some of it.
fn again(item: &problem::Item) -> Option<f64> {
    let saved = item.run.as_ref().map_or(0.0, |run| run.stop().min(0.0));
    item.leave.map(|leave| (leave + saved).max(0.0))
}

fn pierce_group(problem: &Problem, item: &problem::Item) -> Member {
    let mut places: Vec<DVec2> = Vec::new();
    let mut knot = |at: DVec2| {
        places.iter().position(|p| *p == at).unwrap_or_else(|| {
            places.push(at);
            places.len() - 1
        })
    };
    // With a pre-cut the head slows down too, and runs that are left twice share some of that.
    let pre_cut = problem.machine.pre_cut_time.unwrap_or(0.0);
    let mut choice = |path: &SubPath| {
        let stop = Stop { ends: path.ends.map(&mut knot), seconds: path.seconds - item.least() };
        let more = path.leave_points.iter().map(|p| {
            let least = p.pre_cut.as_ref().map_or(p.seconds, |_: &Stroke| p.seconds.min(pre_cut));
            Stop { ends: p.ends.map(&mut knot), seconds: least }
        });
        Choice { more: more.collect(), stop }
    };
    let choices = item.paths.iter().map(&mut choice).collect();
    Member { item: net::points(&places, false), stops: Stops::Paths(choices) }
}
