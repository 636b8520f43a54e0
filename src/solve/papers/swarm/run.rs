//! A swarm method under way: the rows of pieces that all of them share. What differs is a [`Guide`]'s: where the swarm is
//! sown, and how it moves.

use super::super::keys::Keys;
use super::super::lead::{Lead, Pieces, Running, solution};
use super::super::left::Left;
use super::super::legs::Legs;
use super::flock::{Flock, Particle};
use super::settings::SwarmSettings;
use super::worth::{Valued, Worth};
use crate::problem::{NodeId, Problem};
use crate::solve::Search;
use crate::solve::rng::seeded;
use crate::solve::{Curve, Insight};
use std::ops::Range;

/// Keys moved in one piece: with two normal numbers for each, half a millisecond.
const KEYS: usize = 4096;

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
    lead: Lead,
    /// Length of what stands until the first path is found.
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
        let keys = Keys::new(problem, settings.first);
        let worth = Worth::new(Legs::new(problem, settings.measure), keys, settings.local_search);
        let near = settings.local_search || guide.looks_around();
        let count = if worth.keys.items().is_empty() { 0 } else { settings.particles.max(1) as usize };
        let flock = Flock {
            all: Left::all(problem),
            rng: seeded(seed),
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
        // Until the first path is found: items as they are numbered, each at its middle node. It is not the method's, so
        // whatever the method finds replaces it.
        let tour = flock.worth.allowed(&flock.worth.keys.tour(&vec![0.5; flock.worth.keys.count()]));
        let lead = Lead::new(solution(problem, &tour), f64::INFINITY);
        let first = flock.worth.ground.legs.around(&tour);
        Box::new(Running(Self { flock, guide, stage, lead, first }))
    }

    /// Looks at an allowed tour.
    fn see(&mut self, tour: &[NodeId], length: f64) {
        let problem = self.flock.worth.ground.legs.problem();
        self.lead.take(length, || solution(problem, tour));
    }

    /// What a particle turned out to be worth.
    fn valued(&mut self, i: usize, valued: Valued) {
        self.see(&valued.allowed, valued.value);
        let particle = &mut self.flock.particles[i];
        self.flock.worth.keep(&valued.tour, &mut particle.keys);
        (particle.value, particle.tour) = (valued.value, valued.tour);
        self.stage =
            if i + 1 < self.flock.particles.len() { Stage::Value(i + 1, false) } else { Stage::Judge };
    }
}

impl<'p, G: Guide + 'p> Pieces for Run<'p, G> {
    fn lead(&self) -> &Lead {
        &self.lead
    }

    fn lead_mut(&mut self) -> &mut Lead {
        &mut self.lead
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
                    self.see(&allowed, value);
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

    fn insight(&self) -> Insight {
        let mut curves = vec![
            Curve {
                name: "shortest (G)",
                value: if self.lead.length.is_finite() { self.lead.length } else { self.first },
            },
            Curve { name: "mean of the swarm", value: self.flock.mean() },
        ];
        curves.extend(self.guide.curves());
        Insight { round: self.flock.round.into(), curves, ..Insight::default() }
    }
}
