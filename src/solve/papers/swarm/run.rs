//! The search that all swarm methods share, in pieces of work. A [`Guide`] defines what differs: how the swarm is
//! initialised and how it moves.

use super::super::piecewise::{Piecewise, PiecewiseSearch, Progress, solution};
use super::evaluator::Evaluation;
use super::particles::Swarm;
use super::settings::SwarmSettings;
use crate::problem::{NodeId, Problem};
use crate::solve::Search;
use crate::solve::insight::charts;
use crate::solve::{Curve, Insight};
use std::ops::Range;

/// Number of keys moved in one piece: half a millisecond, with two normal random numbers for each.
const KEYS: usize = 4096;

/// The rules of a swarm method. Functions that return an `Option` do one piece of work and return its cost in moves.
pub(super) trait Guide {
    /// Whether near items are needed even without local search.
    fn needs_neighbours(&self) -> bool {
        false
    }
    /// Initialises the swarm; `None` when every particle has its keys.
    fn initialise(&mut self, swarm: &mut Swarm) -> Option<u64>;
    /// Updates the best positions, when all particles are evaluated.
    fn update_bests(&mut self, swarm: &mut Swarm) {
        swarm.remember(|new, old| new < old);
    }
    /// Whether the bests that were just updated send the method back within the same iteration.
    fn goes_back(&self) -> bool {
        false
    }
    /// Prepares the moves of a round; `None` when everything is prepared.
    fn prepare_round(&mut self, _swarm: &mut Swarm) -> Option<u64> {
        None
    }
    /// Moves some keys of a particle.
    fn move_keys(&mut self, swarm: &mut Swarm, particle: usize, keys: Range<usize>);
    /// Values for charts.
    fn curves(&self) -> Vec<Curve> {
        Vec::new()
    }
}

enum Stage {
    Near,
    Initialise,
    /// Evaluates a particle; the flag says whether its evaluation has begun.
    Value(usize, bool),
    UpdateBests,
    Prepare,
    /// Moves a particle, from this key on.
    MoveKeys(usize, usize),
    Over,
}

/// The search of a swarm method.
pub(super) struct Run<'p, G> {
    swarm: Swarm<'p>,
    guide: G,
    stage: Stage,
    progress: Progress,
    /// Length of the initial path, which is reported until the method finds one.
    first: f64,
}

impl<'p, G: Guide + 'p> Run<'p, G> {
    /// Starts a search.
    pub(super) fn start(
        problem: &'p Problem,
        seed: u64,
        settings: &SwarmSettings,
        guide: G,
    ) -> Box<dyn Search + 'p> {
        let near = settings.local_search || guide.needs_neighbours();
        let swarm = Swarm::new(problem, seed, settings);
        let stage = if swarm.particles.is_empty() {
            Stage::Over
        } else if near {
            Stage::Near
        } else {
            Stage::Initialise
        };
        // Until the method finds a path, the best is the order in which items are numbered, each entered at its middle
        // node. It is not a result of the method, so any path that the method finds replaces it.
        let (evaluator, middle) = (&swarm.evaluator, vec![0.5; swarm.evaluator.keys.count()]);
        let tour = evaluator.allowed(&evaluator.keys.tour(&evaluator.space.legs, &middle));
        let progress = Progress::new(solution(problem, &tour), f64::INFINITY);
        let first = swarm.evaluator.space.legs.tour_length(&tour);
        Box::new(PiecewiseSearch(Self { swarm, guide, stage, progress, first }))
    }

    /// Offers a feasible tour as the best.
    fn see(&mut self, tour: &[NodeId], length: f64) {
        let problem = self.swarm.evaluator.space.legs.problem();
        self.progress.take(length, || solution(problem, tour));
    }

    /// Stores the result of evaluating a particle.
    fn evaluated(&mut self, i: usize, evaluation: Evaluation) {
        self.see(&evaluation.allowed, evaluation.value);
        let particle = &mut self.swarm.particles[i];
        self.swarm.evaluator.keep(&evaluation.tour, &mut particle.keys);
        (particle.value, particle.tour) = (evaluation.value, evaluation.tour);
        self.stage =
            if i + 1 < self.swarm.particles.len() { Stage::Value(i + 1, false) } else { Stage::UpdateBests };
    }
}

impl<'p, G: Guide + 'p> Piecewise for Run<'p, G> {
    fn progress(&self) -> &Progress {
        &self.progress
    }

    fn progress_mut(&mut self) -> &mut Progress {
        &mut self.progress
    }

    fn piece(&mut self) -> Option<u64> {
        match self.stage {
            Stage::Near => {
                let space = &mut self.swarm.evaluator.space;
                let priced = space.near.piece(&space.legs, &self.swarm.all);
                if priced.is_none() {
                    self.stage = Stage::Initialise;
                }
                Some(priced.unwrap_or(1))
            }
            Stage::Initialise => {
                let priced = self.guide.initialise(&mut self.swarm);
                if priced.is_none() {
                    self.stage = Stage::Value(0, false);
                }
                if let Some(path) = self.swarm.found.take() {
                    let allowed = self.swarm.evaluator.allowed(&path);
                    let value = self.swarm.evaluator.space.legs.tour_length(&allowed);
                    self.see(&allowed, value);
                }
                Some(priced.unwrap_or(1))
            }
            Stage::Value(i, begun) => {
                let Swarm { evaluator, particles, .. } = &mut self.swarm;
                let (priced, evaluation) = if begun {
                    evaluator.piece()
                } else {
                    evaluator.begin(&particles[i].keys, &particles[i].tour)
                };
                self.stage = Stage::Value(i, true);
                if let Some(evaluation) = evaluation {
                    self.evaluated(i, evaluation);
                }
                Some(priced)
            }
            Stage::UpdateBests => {
                self.guide.update_bests(&mut self.swarm);
                self.swarm.round += u32::from(!self.guide.goes_back());
                let over = self.swarm.round > self.swarm.rounds;
                self.stage = if over { Stage::Over } else { Stage::Prepare };
                Some(self.swarm.particles.len() as u64)
            }
            Stage::Prepare => {
                let priced = self.guide.prepare_round(&mut self.swarm);
                if priced.is_none() {
                    self.stage = Stage::MoveKeys(0, 0);
                }
                Some(priced.unwrap_or(1))
            }
            Stage::MoveKeys(i, from) => {
                let count = self.swarm.evaluator.keys.count();
                let to = count.min(from + KEYS);
                self.guide.move_keys(&mut self.swarm, i, from..to);
                self.stage = if to < count {
                    Stage::MoveKeys(i, to)
                } else if i + 1 < self.swarm.particles.len() {
                    Stage::MoveKeys(i + 1, 0)
                } else {
                    Stage::Value(0, false)
                };
                Some((to - from) as u64)
            }
            Stage::Over => None,
        }
    }

    fn insight(&self) -> Insight {
        let shortest = if self.progress.length.is_finite() { self.progress.length } else { self.first };
        let length = |name, value| Curve { name, value, chart: charts::LENGTH };
        let mut curves =
            vec![length("shortest (G)", shortest), length("mean of the swarm", self.swarm.mean())];
        curves.extend(self.guide.curves());
        Insight { round: self.swarm.round.into(), curves, ..Insight::default() }
    }
}
