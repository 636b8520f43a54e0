//! A flock of random keys: what `hull-pso`, `ofa` and `woa` have in common.
//!
//! These methods move points, so a chromosome is written as keys in [0, 1]: one a segment for its turn, one for its way
//! (`chromosome.rs`). The paper says no more than that they solve the same model from the same first population. Keys
//! may leave the range: only their order counts, and on which side of a half they are. Two pieces a member: it moves and is decoded; it is priced and takes its new place.

use super::chromosome::{genes, keys};
use super::decode::Decoder;
use super::flock::Flock;
use super::model::Gene;
use super::rules::Rule;
use super::settings::HullSettings;
use crate::problem::Problem;
use crate::solve::papers::lead::{Lead, Pieces, Running};
use crate::solve::rng::{Rng, seeded};
use crate::solve::{Curve, Insight, Search};

/// Keys in memory at most, 128 MB. A rule holds three of each member's at most: on 10,000 contours of 8 nodes, a flock of
/// 200 is cut to 69.
const MOST_KEYS: usize = 1 << 25;

/// A flock under a rule.
pub(super) struct Swarm<'p, R> {
    decoder: Decoder<'p>,
    rule: R,
    flock: Flock,
    population: usize,
    generations: u32,
    generation: u32,
    /// Who is next.
    member: usize,
    /// Where a member goes, and what that stands for.
    trial: Option<(Vec<f32>, Vec<Gene>)>,
    rng: Rng,
    lead: Lead,
}

impl<'p, R: Rule + 'p> Swarm<'p, R> {
    /// Starts a search by a rule.
    pub(super) fn start(
        problem: &'p Problem,
        rule: R,
        settings: HullSettings,
        seed: u64,
    ) -> Box<dyn Search + 'p> {
        let decoder = Decoder::new(problem, settings.measure);
        Box::new(Running(Self::new(decoder, rule, settings, seed)))
    }
}

impl<'p, R: Rule> Swarm<'p, R> {
    fn new(decoder: Decoder<'p>, rule: R, settings: HullSettings, seed: u64) -> Self {
        let HullSettings { population, generations, .. } = settings;
        let segments = decoder.model.segments();
        let fitting = MOST_KEYS / (6 * segments).max(1);
        let mut rng = seeded(seed);
        let first = keys(&decoder.model, &mut rng);
        let codes = genes(&decoder.model, &first);
        let (length, visits) = decoder.price(&codes);
        let lead = Lead::new(decoder.solution(visits), length);
        let flock = Flock { best: first.clone(), keys: vec![first], lengths: vec![length], shortest: length };
        let population = (population as usize).min(fitting).max(2);
        let (generation, member, trial) = (0, 0, None);
        Self { decoder, rule, flock, population, generations, generation, member, trial, rng, lead }
    }

    /// Prices a trial, and takes it to the best if it is.
    fn price(&mut self, keys: &[f32], codes: &[Gene]) -> f64 {
        let (length, visits) = self.decoder.price(codes);
        if length < self.flock.shortest {
            self.flock.shortest = length;
            self.flock.best.copy_from_slice(keys);
            self.lead.take(length, || self.decoder.solution(visits));
        }
        length
    }
}

impl<R: Rule> Pieces for Swarm<'_, R> {
    fn lead(&self) -> &Lead {
        &self.lead
    }

    fn lead_mut(&mut self) -> &mut Lead {
        &mut self.lead
    }

    fn piece(&mut self) -> Option<u64> {
        let segments = self.decoder.model.segments();
        if segments == 0 || self.generation >= self.generations {
            return None;
        }
        let founding = self.flock.keys.len() < self.population;
        let round = f64::from(self.generation) + 1.0;
        let Some((trial, codes)) = self.trial.take() else {
            let trial = if founding {
                keys(&self.decoder.model, &mut self.rng)
            } else {
                if self.member == 0 {
                    self.rule.begin(&self.flock);
                }
                let done = f64::from(self.generation) / f64::from(self.generations);
                self.rule.trial(&self.flock, self.member, done, &mut self.rng)
            };
            let codes = genes(&self.decoder.model, &trial);
            self.trial = Some((trial, codes));
            return Some(segments as u64);
        };
        let length = self.price(&trial, &codes);
        if founding {
            self.flock.keys.push(trial);
            self.flock.lengths.push(length);
            return Some(segments as u64);
        }
        let member = self.member;
        if self.rule.takes(self.flock.lengths[member], length, round, &mut self.rng) {
            self.flock.keys[member] = trial;
            self.flock.lengths[member] = length;
        }
        self.member = (member + 1) % self.population;
        self.generation += u32::from(self.member == 0);
        Some(segments as u64)
    }

    fn insight(&self) -> Insight {
        let lengths = &self.flock.lengths;
        let mean = lengths.iter().sum::<f64>() / lengths.len() as f64;
        let curve = |name, value| Curve { name, value };
        let curves =
            vec![curve("shortest empty travel TL", self.lead.length), curve("mean empty travel TL", mean)];
        Insight { round: self.generation.into(), curves, ..Insight::default() }
    }
}
