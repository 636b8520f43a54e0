//! The segmented genetic algorithm (section 4.5): `rlsga` with an agent that learns, `sga` with one that does not.
//!
//! In each generation n chromosomes are selected by roulette, with fitness 1/TL. Pairs of them are crossed with probability
//! pC by the operator that the agent chose. Each child mutates with pMu and migrates with pMi. The n best of parents and
//! children survive. One piece of work creates a chromosome, starts a crossover, fills some blanks, prices a chromosome, or
//! selects.

use super::agent::{Agent, Learning, Statistics};
use super::chromosome::{Chromosome, genes, keys};
use super::crossover::{OPERATORS, ReversedRun, cross};
use super::decode::Decoder;
use super::filling::Filling;
use super::settings::{HullSettings, OperatorRates};
use crate::order::{real, sort_by};
use crate::solve::insight::charts;
use crate::solve::papers::piecewise::{Piecewise, Progress};
use crate::solve::papers::roulette::Roulette;
use crate::solve::rng::{Draw, Rng, seeded};
use crate::solve::{Curve, Grid, Insight};

/// Largest number of genes in memory, of parents and children: 128 MB. 200 chromosomes for 10,000 contours of 8 nodes fit.
const MOST_GENES: usize = 1 << 25;

/// Parameters of the operators that make children.
#[derive(Clone, Copy, Debug)]
pub(super) struct Breeding {
    pub(super) rates: OperatorRates,
    /// Whether eq. (6) uses fitness divided by its mean.
    pub(super) scaled_fitness: bool,
    /// What RSX reverses.
    pub(super) reversed_run: ReversedRun,
}

/// The search.
pub(super) struct Genetic<'p> {
    decoder: Decoder<'p>,
    breeding: Breeding,
    generations: u32,
    population: usize,
    rng: Rng,
    agent: Agent,
    parents: Vec<Chromosome>,
    /// Indices of the selected parents; the last are next.
    drawn: Vec<usize>,
    children: Vec<Chromosome>,
    /// Children whose blanks are being filled; the last is current.
    fillings: Vec<Filling>,
    /// Chromosomes that are not priced yet: a member of the first population, or a child that may still mutate.
    raw: Vec<Chromosome>,
    generation: u32,
    progress: Progress,
}

impl<'p> Genetic<'p> {
    pub(super) fn new(
        decoder: Decoder<'p>,
        settings: HullSettings,
        breeding: Breeding,
        learning: Option<Learning>,
        seed: u64,
    ) -> Self {
        let segments = decoder.model.segments();
        let fitting = MOST_GENES / (2 * segments).max(1);
        let population = (settings.population as usize).min(fitting).max(2);
        let mut rng = seeded(seed);
        let mut first = random(&decoder, &mut rng);
        let (length, visits) = decoder.price(&first.genes);
        first.length = length;
        let progress = Progress::new(decoder.solution(visits), length);
        Self {
            decoder,
            breeding,
            generations: settings.generations,
            population,
            rng,
            agent: Agent::new(learning),
            parents: vec![first],
            drawn: Vec::new(),
            children: Vec::new(),
            fillings: Vec::new(),
            raw: Vec::new(),
            generation: 0,
            progress,
        }
    }

    /// Computes the length of a chromosome and compares it with the best.
    fn price(&mut self, chromosome: &mut Chromosome) {
        let (length, visits) = self.decoder.price(&chromosome.genes);
        chromosome.length = length;
        self.progress.take(length, || self.decoder.solution(visits));
    }

    /// Fitness of the parents, eq. (4).
    fn fitness(&self) -> Vec<f64> {
        self.parents.iter().map(|p| fitness(p.length)).collect()
    }

    /// Selects parents for the next generation.
    fn draw(&mut self) {
        let roulette = Roulette::new(self.fitness());
        self.drawn = (0..self.population).map(|_| roulette.spin(&mut self.rng)).collect();
    }

    /// Crosses the next pair, or copies it.
    fn breed(&mut self) {
        let (Some(a), b) = (self.drawn.pop(), self.drawn.pop()) else { return };
        let Some(b) = b.filter(|_| self.rng.uniform() < self.breeding.rates.crossover) else {
            self.raw.extend([Some(a), b].into_iter().flatten().map(|i| self.parents[i].clone()));
            return;
        };
        let operator = OPERATORS[self.agent.action];
        let parents = [&self.parents[a], &self.parents[b]];
        let torn =
            cross((operator, self.breeding.reversed_run), parents, &self.decoder.model.sizes, &mut self.rng);
        self.fillings.extend(torn.map(|t| Filling::new(&self.decoder.model, t, &mut self.rng)));
    }

    /// Mutates, migrates and prices a child.
    fn finish(&mut self, mut child: Chromosome) {
        if self.rng.uniform() < self.breeding.rates.mutation {
            child.mutate(&mut self.rng);
        }
        if self.rng.uniform() < self.breeding.rates.migration {
            child.migrate(&mut self.rng);
        }
        self.price(&mut child);
        self.children.push(child);
    }

    /// Keeps the n best of parents and children.
    fn survive(&mut self) {
        self.parents.append(&mut self.children);
        sort_by(&mut self.parents, |c| [real(c.length), 0, 0]);
        self.parents.truncate(self.population);
        self.generation += 1;
        let (statistics, diversity) = self.look();
        self.agent.learn(statistics, diversity, &mut self.rng);
        self.draw();
    }

    fn look(&self) -> (Statistics, f64) {
        let statistics = Statistics::new(self.fitness());
        let done = f64::from(self.generation) / f64::from(self.generations.max(1));
        (statistics, statistics.diversity(done, self.breeding.scaled_fitness))
    }
}

/// A random chromosome that is not priced yet.
fn random(decoder: &Decoder, rng: &mut Rng) -> Chromosome {
    let model = &decoder.model;
    Chromosome::new(genes(model, &keys(model, rng)), &model.sizes)
}

/// Fitness, eq. (4). A path without travel counts as one of a nanometre, so that the fitness is finite.
fn fitness(length: f64) -> f64 {
    1.0 / length.max(1e-6)
}

impl Piecewise for Genetic<'_> {
    fn progress(&self) -> &Progress {
        &self.progress
    }

    fn progress_mut(&mut self) -> &mut Progress {
        &mut self.progress
    }

    fn piece(&mut self) -> Option<u64> {
        let segments = self.decoder.model.segments() as u64;
        if segments == 0 || self.generation >= self.generations {
            return None;
        }
        if self.parents.len() < self.population {
            let Some(mut chromosome) = self.raw.pop() else {
                self.raw.push(random(&self.decoder, &mut self.rng));
                return Some(segments);
            };
            self.price(&mut chromosome);
            self.parents.push(chromosome);
            if self.parents.len() == self.population {
                let (statistics, diversity) = self.look();
                self.agent.begin(statistics, diversity, &mut self.rng);
                self.draw();
            }
            return Some(segments);
        }
        if let Some(child) = self.raw.pop() {
            self.finish(child);
            return Some(segments);
        }
        if let Some(filling) = self.fillings.last_mut() {
            let priced = filling.work(&self.decoder.model);
            if let Some(child) = filling.full() {
                self.fillings.pop();
                self.raw.push(child);
            }
            return Some(priced);
        }
        if self.drawn.is_empty() {
            self.survive();
            return Some(self.population as u64);
        }
        self.breed();
        Some(segments)
    }

    fn insight(&self) -> Insight {
        let agent = &self.agent;
        let chosen = agent.chosen.iter().sum::<u64>().max(1) as f64;
        let share = |a: usize| agent.chosen[a] as f64 / chosen;
        let visited = agent.visited.iter().sum::<u64>().max(1) as f64;
        let state = |s: usize| agent.visited[s] as f64 / visited;
        let mean = self.parents.iter().map(|p| p.length).sum::<f64>() / self.parents.len() as f64;
        let curve = |chart| move |name, value| Curve { name, value, chart };
        let (length, reward) = (curve(charts::LENGTH), curve(charts::REWARD));
        let (operator, states) = (curve(charts::OPERATORS), curve(charts::STATES));
        Insight {
            round: self.generation.into(),
            curves: vec![
                length("shortest empty travel TL", self.progress.length),
                length("mean empty travel TL", mean),
                reward("diversity coefficient div", agent.diversity),
                reward("reward R", agent.reward),
                operator("share of PSX", share(0)),
                operator("share of RSX", share(1)),
                operator("share of ISX", share(2)),
                states("share of div < 0.25", state(0)),
                states("share of 0.25 to 0.75", state(1)),
                states("share of div > 0.75", state(2)),
            ],
            grid: Some(Grid {
                name: "Q-table: accumulated reward of each crossover in each state",
                rows: vec!["div < 0.25", "0.25 to 0.75", "div > 0.75"],
                columns: vec!["PSX", "RSX", "ISX"],
                values: agent.table.as_flattened().to_vec(),
                at: Some(3 * agent.state + agent.action),
            }),
            ..Insight::default()
        }
    }
}

#[cfg(test)]
#[allow(clippy::float_cmp, reason = "the numbers of the examples are exact")]
mod tests {
    use super::*;
    use crate::solve::papers::Measure;
    use crate::solve::papers::test_sheet::sheet;

    #[test]
    fn the_best_of_parents_and_children_survive() {
        let problem = sheet(
            &[&[[0.0, 0.0], [1.0, 0.0], [1.0, 1.0]], &[[5.0, 0.0], [6.0, 0.0]]],
            Some(0.0),
            "length-partial",
        );
        let settings = HullSettings { population: 3, ..HullSettings::default() };
        let breeding = Breeding {
            rates: OperatorRates::default(),
            scaled_fitness: true,
            reversed_run: ReversedRun::default(),
        };
        let decoder = Decoder::new(&problem, Measure::Euclidean);
        let mut genetic = Genetic::new(decoder, settings, breeding, None, 1);
        let of = |length: f64| Chromosome { length, ..genetic.parents[0].clone() };
        let (parents, children) = ([5.0, 3.0, 9.0].map(of), [4.0, 3.5, 10.0].map(of));
        (genetic.parents, genetic.children) = (parents.into(), children.into());
        genetic.survive();
        let lengths: Vec<f64> = genetic.parents.iter().map(|p| p.length).collect();
        assert_eq!(lengths, [3.0, 3.5, 4.0]);
        // Their fitness (4), and as many parents drawn for the next generation.
        assert_eq!(genetic.fitness(), [1.0 / 3.0, 1.0 / 3.5, 0.25]);
        assert_eq!((genetic.drawn.len(), genetic.generation, genetic.children.len()), (3, 1, 0));
    }
}
