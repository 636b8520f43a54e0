//! A swarm method under way: the rows of pieces that all of them share. What differs is a [`Guide`]'s: where the swarm is
//! sown, and how it moves.

use super::super::insight::{Curve, Insight};
use super::super::keys::Keys;
use super::super::left::Left;
use super::super::legs::{Legs, Measure};
use super::super::pace::{Pace, Pieces, work_on};
use super::flock::{Flock, Particle};
use super::worth::{Valued, Worth};
use crate::problem::{NodeId, Problem};
use crate::solve::dice::Dice;
use crate::solve::{Search, Solution, Step, Stop, Telemetry};
use std::ops::Range;

/// Keys moved in one piece: with two normal numbers for each, half a millisecond.
const KEYS: usize = 4096;

/// What every swarm method may be told.
pub(super) struct Settings {
    pub(super) particles: u32,
    pub(super) rounds: u32,
    pub(super) measure: Measure,
    pub(super) local_search: bool,
    pub(super) first: Option<NodeId>,
    pub(super) fastest: f64,
}

/// What makes a method of a swarm. Every function works one piece and tells its price.
pub(super) trait Guide {
    /// Whether it asks for near items also without local search.
    fn looks_around(&self) -> bool {
        false
    }
    /// Sows the swarm; nothing when every particle has its keys.
    fn sow(&mut self, flock: &mut Flock) -> Option<u64>;
    /// All particles are valued: their bests are to be remembered.
    fn judge(&mut self, flock: &mut Flock) {
        flock.remember(|new, old| new < old);
    }
    /// Before a round's moves; nothing when all is prepared.
    fn prepare(&mut self, _flock: &mut Flock) -> Option<u64> {
        None
    }
    /// Moves some keys of a particle.
    fn drive(&mut self, flock: &mut Flock, particle: usize, keys: Range<usize>);
    /// Numbers for charts.
    fn curves(&self) -> Vec<Curve> {
        Vec::new()
    }
}

enum Stage {
    Near,
    Sow,
    /// A particle's value, begun or not.
    Value(usize, bool),
    Judge,
    Prepare,
    /// A particle, from a key on.
    Drive(usize, usize),
    Over,
}

/// A swarm method under way.
pub(super) struct Run<'p, G> {
    flock: Flock<'p>,
    guide: G,
    stage: Stage,
    pace: Pace,
    best: Solution,
    /// Its length by the measure.
    value: f64,
    best_at: u64,
    improved: bool,
}

impl<'p, G: Guide> Run<'p, G> {
    pub(super) fn new(problem: &'p Problem, seed: u64, settings: &Settings, guide: G) -> Self {
        let keys = Keys::new(problem, settings.first);
        let worth = Worth::new(Legs::new(problem, settings.measure), keys, settings.local_search);
        let near = settings.local_search || guide.looks_around();
        let count = if worth.keys.items().is_empty() { 0 } else { settings.particles.max(1) as usize };
        let flock = Flock {
            all: Left::all(problem),
            dice: Dice::new(seed),
            particles: vec![Particle::default(); count],
            leader: 0,
            round: 0,
            rounds: settings.rounds,
            fastest: settings.fastest,
            found: None,
            worth,
        };
        let stage = if count == 0 {
            Stage::Over
        } else if near {
            Stage::Near
        } else {
            Stage::Sow
        };
        // Until the first path is found: items as they are numbered, each at its first node.
        let first = vec![0.5; flock.worth.keys.count()];
        let mut run = Self {
            flock,
            guide,
            stage,
            pace: Pace::default(),
            best: Solution::default(),
            value: f64::INFINITY,
            best_at: 0,
            improved: false,
        };
        let tour = run.flock.worth.allowed(&run.flock.worth.keys.tour(&first));
        run.take(&tour, f64::INFINITY);
        run.value = run.flock.worth.ground.legs.around(&tour);
        run
    }

    fn take(&mut self, tour: &[NodeId], value: f64) {
        let problem = self.flock.worth.ground.legs.problem();
        self.best = Solution::new(problem, tour.iter().map(|&n| Stop::at(problem, n)).collect());
        (self.value, self.best_at, self.improved) = (value, self.pace.spent, true);
    }

    /// What a particle turned out to be worth.
    fn valued(&mut self, i: usize, valued: Valued) {
        if valued.value < self.value {
            self.take(&valued.allowed, valued.value);
        }
        let particle = &mut self.flock.particles[i];
        self.flock.worth.keep(&valued.tour, &mut particle.keys);
        (particle.value, particle.tour) = (valued.value, valued.tour);
        self.stage =
            if i + 1 < self.flock.particles.len() { Stage::Value(i + 1, false) } else { Stage::Judge };
    }
}

impl<G: Guide> Pieces for Run<'_, G> {
    fn pace(&mut self) -> &mut Pace {
        &mut self.pace
    }

    fn piece(&mut self) -> Option<u64> {
        match self.stage {
            Stage::Near => {
                let ground = &mut self.flock.worth.ground;
                let priced = ground.near.piece(&ground.legs, &self.flock.all);
                if priced.is_none() {
                    self.stage = Stage::Sow;
                }
                Some(priced.unwrap_or(1))
            }
            Stage::Sow => {
                let priced = self.guide.sow(&mut self.flock);
                if priced.is_none() {
                    self.stage = Stage::Value(0, false);
                }
                if let Some(path) = self.flock.found.take() {
                    let allowed = self.flock.worth.allowed(&path);
                    let value = self.flock.worth.ground.legs.around(&allowed);
                    if value < self.value {
                        self.take(&allowed, value);
                    }
                }
                Some(priced.unwrap_or(1))
            }
            Stage::Value(i, begun) => {
                let Flock { worth, particles, .. } = &mut self.flock;
                let (priced, valued) =
                    if begun { worth.piece() } else { worth.begin(&particles[i].keys, &particles[i].tour) };
                self.stage = Stage::Value(i, true);
                if let Some(valued) = valued {
                    self.valued(i, valued);
                }
                Some(priced)
            }
            Stage::Judge => {
                self.guide.judge(&mut self.flock);
                self.flock.round += 1;
                let over = self.flock.round > self.flock.rounds;
                self.stage = if over { Stage::Over } else { Stage::Prepare };
                Some(self.flock.particles.len() as u64)
            }
            Stage::Prepare => {
                let priced = self.guide.prepare(&mut self.flock);
                if priced.is_none() {
                    self.stage = Stage::Drive(0, 0);
                }
                Some(priced.unwrap_or(1))
            }
            Stage::Drive(i, from) => {
                let count = self.flock.worth.keys.count();
                let to = count.min(from + KEYS);
                self.guide.drive(&mut self.flock, i, from..to);
                self.stage = if to < count {
                    Stage::Drive(i, to)
                } else if i + 1 < self.flock.particles.len() {
                    Stage::Drive(i + 1, 0)
                } else {
                    Stage::Value(0, false)
                };
                Some((to - from) as u64)
            }
            Stage::Over => None,
        }
    }
}

impl<G: Guide> Search for Run<'_, G> {
    fn step(&mut self, work: u64) -> Step {
        self.improved = false;
        let (done, status) = work_on(self, work);
        Step { status, done, improved: self.improved }
    }

    fn best(&self) -> &Solution {
        &self.best
    }

    fn telemetry(&self) -> Telemetry {
        Telemetry { moves: self.pace.done(), best_at: self.best_at, best: self.best.cost }
    }

    fn insight(&self) -> Insight {
        let mut curves = vec![
            Curve { name: "shortest (G)", value: self.value },
            Curve { name: "mean of the swarm", value: self.flock.mean() },
        ];
        curves.extend(self.guide.curves());
        Insight { round: u64::from(self.flock.round), curves, grid: None }
    }
}
