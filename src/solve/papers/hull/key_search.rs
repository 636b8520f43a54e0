//! The search on random keys that `hull-pso`, `ofa` and `woa` share.
//!
//! These methods move points, so a chromosome is represented by keys in [0, 1]: one for the turn of each segment and one
//! for its direction (`chromosome.rs`). The paper only says that they solve the same model from the same first population.
//! Keys may leave the range, because only their order counts, and whether they are at least a half. Each member takes two
//! pieces of work: in the first it moves and is decoded, in the second it is priced and accepted or not.

use super::chromosome::{genes, keys};
use super::decode::Decoder;
use super::members::Members;
use super::model::Gene;
use super::rules::MoveRule;
use super::settings::HullSettings;
use crate::problem::Problem;
use crate::solve::insight::charts;
use crate::solve::papers::piecewise::{Piecewise, PiecewiseSearch, Progress};
use crate::solve::rng::{Rng, seeded};
use crate::solve::{Curve, Insight, Search};

/// Largest number of keys in memory: 128 MB. A rule stores at most three sets of keys for each member; for 10,000 contours
/// of 8 nodes a population of 200 is reduced to 69.
const MOST_KEYS: usize = 1 << 25;

/// A population that moves by a rule.
pub(super) struct KeySearch<'p, R> {
    decoder: Decoder<'p>,
    rule: R,
    members: Members,
    population: usize,
    generations: u32,
    generation: u32,
    /// Index of the next member.
    member: usize,
    /// The keys that a member may move to, and the genes they represent.
    trial: Option<(Vec<f32>, Vec<Gene>)>,
    rng: Rng,
    progress: Progress,
}

impl<'p, R: MoveRule + 'p> KeySearch<'p, R> {
    /// Starts a search by a rule.
    pub(super) fn start(
        problem: &'p Problem,
        rule: R,
        settings: HullSettings,
        seed: u64,
    ) -> Box<dyn Search + 'p> {
        let decoder = Decoder::new(problem, settings.measure);
        Box::new(PiecewiseSearch(Self::new(decoder, rule, settings, seed)))
    }
}

impl<'p, R: MoveRule> KeySearch<'p, R> {
    fn new(decoder: Decoder<'p>, rule: R, settings: HullSettings, seed: u64) -> Self {
        let HullSettings { population, generations, .. } = settings;
        let segments = decoder.model.segments();
        let fitting = MOST_KEYS / (6 * segments).max(1);
        let mut rng = seeded(seed);
        let first = keys(&decoder.model, &mut rng);
        let codes = genes(&decoder.model, &first);
        let (length, visits) = decoder.price(&codes);
        let progress = Progress::new(decoder.solution(visits), length);
        let members =
            Members { best: first.clone(), keys: vec![first], lengths: vec![length], shortest: length };
        let population = (population as usize).min(fitting).max(2);
        let (generation, member, trial) = (0, 0, None);
        Self { decoder, rule, members, population, generations, generation, member, trial, rng, progress }
    }

    /// Prices a trial, and updates the best.
    fn price(&mut self, keys: &[f32], codes: &[Gene]) -> f64 {
        let (length, visits) = self.decoder.price(codes);
        if length < self.members.shortest {
            self.members.shortest = length;
            self.members.best.copy_from_slice(keys);
            self.progress.take(length, || self.decoder.solution(visits));
        }
        length
    }
}

impl<R: MoveRule> Piecewise for KeySearch<'_, R> {
    fn progress(&self) -> &Progress {
        &self.progress
    }

    fn progress_mut(&mut self) -> &mut Progress {
        &mut self.progress
    }

    fn piece(&mut self) -> Option<u64> {
        let segments = self.decoder.model.segments();
        if segments == 0 || self.generation >= self.generations {
            return None;
        }
        let founding = self.members.keys.len() < self.population;
        let round = f64::from(self.generation) + 1.0;
        let Some((trial, codes)) = self.trial.take() else {
            let trial = if founding {
                keys(&self.decoder.model, &mut self.rng)
            } else {
                if self.member == 0 {
                    self.rule.begin(&self.members);
                }
                let done = f64::from(self.generation) / f64::from(self.generations);
                self.rule.trial(&self.members, self.member, done, &mut self.rng)
            };
            let codes = genes(&self.decoder.model, &trial);
            self.trial = Some((trial, codes));
            return Some(segments as u64);
        };
        let length = self.price(&trial, &codes);
        if founding {
            self.members.keys.push(trial);
            self.members.lengths.push(length);
            return Some(segments as u64);
        }
        let member = self.member;
        if self.rule.accepts(self.members.lengths[member], length, round, &mut self.rng) {
            self.members.keys[member] = trial;
            self.members.lengths[member] = length;
        }
        self.member = (member + 1) % self.population;
        self.generation += u32::from(self.member == 0);
        Some(segments as u64)
    }

    fn insight(&self) -> Insight {
        let lengths = &self.members.lengths;
        let mean = lengths.iter().sum::<f64>() / lengths.len() as f64;
        let curve = |name, value| Curve { name, value, chart: charts::LENGTH };
        let curves = vec![
            curve("shortest empty travel TL", self.progress.length),
            curve("mean empty travel TL", mean),
        ];
        Insight { round: self.generation.into(), curves, ..Insight::default() }
    }
}
