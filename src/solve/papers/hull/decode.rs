//! From a chromosome to its length and its path.
//!
//! Fitness is 1/TL, eq. (4). Where nothing needs to come before anything else, as in the paper, TL is the length of the
//! chromosome itself, and the plan is its nested form (`nested.rs`), which is as long or shorter. Where holes or ranks
//! demand an order, the nested form is repaired rank by rank (`holes.rs`), and the fitness is that of the repaired path.
//! This is a deviation, as the paper has no holes. The cost of leaving contours is part of the plan but not of the fitness.
//!
//! With groups, pairs or a table of costs no contour is left unfinished, and [`Repair`] makes the order of the contours
//! feasible.

use super::super::legs::{Legs, Measure};
use super::super::repair::{Repair, ranks};
use super::holes::finished_inside_first;
use super::model::{Gene, Model, Visit};
use super::nested::nested;
use crate::order::sort_by;
use crate::problem::Problem;
use crate::solve::traits::{Solution, Stop};

/// Prices and decodes the chromosomes of a problem.
pub(super) struct Decoder<'p> {
    pub(super) model: Model<'p>,
    /// Makes orders feasible; `None` if every order is.
    ordered: Option<Ordered>,
}

enum Ordered {
    /// Contours that lie inside others, outer ones first, and all ranks in ascending order.
    Nesting { inwards: Vec<u32>, ranks: Vec<u32> },
    /// Whole contours, with all kinds of precedence.
    Whole(Repair),
}

impl<'p> Decoder<'p> {
    pub(super) fn new(problem: &'p Problem, measure: Measure) -> Self {
        let whole = !problem.groups.is_empty() || !problem.pairs.is_empty() || problem.table().is_some();
        let inside = problem.items.iter().any(|i| i.before.is_some());
        let ranks = ranks(problem);
        let ordered = match (whole, inside || ranks.len() > 1) {
            (true, _) => Some(Ordered::Whole(Repair::new(problem))),
            (false, true) => Some(Ordered::Nesting { inwards: inwards(problem), ranks }),
            (false, false) => None,
        };
        Self { model: Model::new(Legs::new(problem, measure), whole), ordered }
    }

    /// TL of a chromosome, and the visits whose length it is: its own, or those of the repaired path.
    pub(super) fn price(&self, genes: &[Gene]) -> (f64, Vec<Visit>) {
        let visits = self.model.visits(genes);
        let visits = if self.ordered.is_some() { self.path(visits) } else { visits };
        (self.model.travel(&visits), visits)
    }

    /// The solution for the visits that [`Decoder::price`] returned.
    pub(super) fn solution(&self, visits: Vec<Visit>) -> Solution {
        let problem = self.model.problem();
        let along = |n: u32| problem.nodes[n as usize].along;
        let stop = |v: Visit| Stop { node: v.enter, along: along(v.enter), until: along(v.leave) };
        let path = if self.ordered.is_some() { visits } else { self.path(visits) };
        Solution::new(problem, path.into_iter().map(stop).collect())
    }

    /// Converts visits to a path that nests and is feasible.
    fn path(&self, visits: Vec<Visit>) -> Vec<Visit> {
        let model = &self.model;
        match &self.ordered {
            None => nested(model, &visits),
            Some(Ordered::Nesting { inwards, ranks }) => {
                let rank = |v: &Visit| model.problem().items[model.item(v.enter) as usize].rank;
                let mut by_rank = vec![Vec::new(); ranks.len()];
                visits.iter().for_each(|v| by_rank[ranks.partition_point(|&r| r < rank(v))].push(*v));
                let mut path = Vec::with_capacity(visits.len());
                for of_rank in by_rank {
                    let start = path.len();
                    path.extend(nested(model, &of_rank));
                    path = finished_inside_first(model, inwards, &path, start);
                }
                path
            }
            Some(Ordered::Whole(repair)) => {
                let mut by_item = vec![None; model.problem().items.len()];
                let order: Vec<u32> = visits.iter().map(|v| model.item(v.enter)).collect();
                order.iter().zip(&visits).for_each(|(&i, &v)| by_item[i as usize] = Some(v));
                repair.apply(&order).into_iter().filter_map(|i| by_item[i as usize]).collect()
            }
        }
    }
}

/// Contours that lie inside others, those inside the fewest first.
fn inwards(problem: &Problem) -> Vec<u32> {
    let outer = |i: u32| problem.items.get(i as usize).and_then(|i| i.before);
    let most = problem.items.len();
    let mut all: Vec<(usize, u32)> = (0..)
        .zip(&problem.items)
        .map(|(id, _)| (std::iter::successors(outer(id), |&o| outer(o)).take(most).count(), id))
        .filter(|c| c.0 > 0)
        .collect();
    sort_by(&mut all, |c| [c.0 as u64, 0, 0]);
    all.into_iter().map(|c| c.1).collect()
}
