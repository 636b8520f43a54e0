//! The segmented genetic algorithm (section 4.5): `rlsga` with an agent that learns, `sga` with one that does not.
//!
//! A generation: n chromosomes drawn by roulette, with fitness 1/TL, form a subpopulation; pairs of them are crossed with
//! probability pC by the operator the agent chose; each then mutates with pMu and migrates with pMi; the n best of parents
//! and subpopulation go on. It works in pieces: one chromosome founded, one crossover begun, some blanks filled, one
//! chromosome priced, one selection.

use super::agent::{Agent, Learning, Sums};
use super::chromosome::{Chromosome, genes, keys};
use super::crossover::{OPERATORS, cross};
use super::decode::Decoder;
use super::filling::Filling;
use super::settings::{HullSettings, OperatorRates};
use crate::order::{real, sort_by};
use crate::solve::papers::lead::{Lead, Pieces};
use crate::solve::papers::roulette::Roulette;
use crate::solve::rng::{Draw, Rng, seeded};
use crate::solve::{Curve, Grid, Insight};

/// Genes in memory at most, parents and children: 128 MB. On 10,000 contours of 8 nodes, 200 chromosomes are within it.
const MOST_GENES: usize = 1 << 25;

/// How children come from parents.
#[derive(Clone, Copy, Debug)]
pub(super) struct Breeding {
    pub(super) rates: OperatorRates,
    /// Whether eq. (6) takes fitness divided by its mean.
    pub(super) scaled_fitness: bool,
}

/// The algorithm at work.
pub(super) struct Genetic<'p> {
    decoder: Decoder<'p>,
    breeding: Breeding,
    generations: u32,
    population: usize,
    rng: Rng,
    agent: Agent,
    parents: Vec<Chromosome>,
    /// The subpopulation drawn, by index of parent; the last are next.
    drawn: Vec<usize>,
    children: Vec<Chromosome>,
    /// Children whose blanks are filled; the last is in work.
    fillings: Vec<Filling>,
    /// What is to be priced: a founder, or a child that may mutate first.
    raw: Vec<Chromosome>,
    generation: u32,
    lead: Lead,
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
        let lead = Lead::new(decoder.solution(visits), length);
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
            lead,
        }
    }

    /// Gives a chromosome its length, and compares it with the best.
    fn price(&mut self, chromosome: &mut Chromosome) {
        let (length, visits) = self.decoder.price(&chromosome.genes);
        chromosome.length = length;
        self.lead.take(length, || self.decoder.solution(visits));
    }

    /// Lengths of the parents as fitness, eq. (4).
    fn fitness(&self) -> Vec<f64> {
        self.parents.iter().map(|p| fitness(p.length)).collect()
    }

    /// The roulette, and whether there was a population to learn from.
    fn draw(&mut self) {
        let roulette = Roulette::new(self.fitness());
        self.drawn = (0..self.population).map(|_| roulette.spin(&mut self.rng)).collect();
    }

    /// Crosses the next pair, or takes it as it is.
    fn breed(&mut self) {
        let (Some(a), b) = (self.drawn.pop(), self.drawn.pop()) else { return };
        let Some(b) = b.filter(|_| self.rng.uniform() < self.breeding.rates.crossover) else {
            self.raw.extend([Some(a), b].into_iter().flatten().map(|i| self.parents[i].clone()));
            return;
        };
        let operator = OPERATORS[self.agent.action];
        let parents = [&self.parents[a], &self.parents[b]];
        let torn = cross(operator, parents, &self.decoder.model.sizes, &mut self.rng);
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

    /// The n best of parents and children.
    fn survive(&mut self) {
        self.parents.append(&mut self.children);
        sort_by(&mut self.parents, |c| [real(c.length), 0, 0]);
        self.parents.truncate(self.population);
        self.generation += 1;
        let (sums, diversity) = self.look();
        self.agent.learn(sums, diversity, &mut self.rng);
        self.draw();
    }

    fn look(&self) -> (Sums, f64) {
        let sums = Sums::new(self.fitness());
        let done = f64::from(self.generation) / f64::from(self.generations.max(1));
        (sums, sums.diversity(done, self.breeding.scaled_fitness))
    }
}

/// A random chromosome, not yet priced.
fn random(decoder: &Decoder, rng: &mut Rng) -> Chromosome {
    let model = &decoder.model;
    Chromosome::new(genes(model, &keys(model, rng)), &model.sizes)
}

/// Eq. (4); a path without travel counts as one of a nanometre.
fn fitness(length: f64) -> f64 {
    1.0 / length.max(1e-6)
}

impl Pieces for Genetic<'_> {
    fn lead(&self) -> &Lead {
        &self.lead
    }

    fn lead_mut(&mut self) -> &mut Lead {
        &mut self.lead
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
                let (sums, diversity) = self.look();
                self.agent.begin(sums, diversity, &mut self.rng);
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
        let curve = |name, value| Curve { name, value };
        Insight {
            round: self.generation.into(),
            curves: vec![
                curve("shortest empty travel TL", self.lead.length),
                curve("diversity coefficient div", agent.diversity),
                curve("reward R", agent.reward),
                curve("share of PSX", share(0)),
                curve("share of RSX", share(1)),
                curve("share of ISX", share(2)),
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
