//! The search of `dual-coding-ga`, and its parameters.

use super::code::{Code, cross, mutate};
use super::fitness::fitness;
use crate::problem::{ItemId, NodeId, Problem};
use crate::solve::insight::charts;
use crate::solve::papers::piecewise::{Piecewise, PiecewiseSearch, Progress, solution};
use crate::solve::papers::roulette::Roulette;
use crate::solve::papers::{Legs, Measure, Repair};
use crate::solve::rng::{Draw, Rng, seeded};
use crate::solve::{Curve, Insight};
use crate::solve::{Search, Solution, Solver, SolverInfo};
use serde::{Deserialize, Serialize};

/// Largest number of genes in memory, in both rows of parents and children: 128 MB.
const MOST_GENES: usize = 1 << 25;

/// Yang's genetic algorithm. It starts from random codes, whatever path it is given.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct DualCodingGa {
    /// Number of codes in the population.
    pub population: u32,
    /// Number of generations, after which the method ends. The paper does not give it, but shows the 200th.
    pub generations: u32,
    /// Probability that a pair is crossed.
    pub crossover: f64,
    /// Probability that a child mutates.
    pub mutation: f64,
    /// Scaling of the fitness in the first generation, lambda of eq. (2).
    pub lambda: f64,
    /// Factor by which the scaling grows in each generation, alpha of eq. (2).
    pub alpha: f64,
    /// How travel is measured, eq. (1).
    pub measure: Measure,
    /// Whether the legs from home and back to it count. Eq. (1) sums the legs between contours only; with home it is what a
    /// machine travels.
    pub home_legs: bool,
}

impl Default for DualCodingGa {
    fn default() -> Self {
        Self {
            population: 50,
            generations: 2000,
            crossover: 0.8,
            mutation: 0.05,
            lambda: 0.1,
            alpha: 1.02,
            measure: Measure::Chebyshev,
            home_legs: true,
        }
    }
}

impl Solver for DualCodingGa {
    fn info(&self) -> SolverInfo {
        SolverInfo {
            name: "dual-coding-ga",
            title: "Dual coding GA",
            about: "A genetic algorithm over the order of contours and the starting point of each, for the least travel \
                    time.",
            source: Some(
                "Yang: Application of Improved Dual Coding Genetic Algorithm for Contour Path Planning in Laser \
                 Processing. Information Technology Journal (2013)",
            ),
        }
    }

    fn start<'p>(&self, problem: &'p Problem, seed: u64, _warm: Option<&Solution>) -> Box<dyn Search + 'p> {
        Box::new(PiecewiseSearch(Generations::new(problem, *self, seed)))
    }
}

/// The search.
struct Generations<'p> {
    legs: Legs<'p>,
    /// Repairs the order; `None` if every order is feasible.
    repair: Option<Repair>,
    contours: Vec<ItemId>,
    rates: DualCodingGa,
    population: usize,
    rng: Rng,
    parents: Vec<Code>,
    lengths: Vec<f64>,
    /// Selects parents by their fitness in this generation.
    roulette: Roulette,
    children: Vec<Code>,
    child_lengths: Vec<f64>,
    /// Children that are not priced yet.
    raw: Vec<Code>,
    generation: u32,
    progress: Progress,
}

impl<'p> Generations<'p> {
    fn new(problem: &'p Problem, rates: DualCodingGa, seed: u64) -> Self {
        let contours: Vec<ItemId> =
            (0..).zip(&problem.items).filter(|(_, i)| !i.nodes.is_empty()).map(|(id, _)| id).collect();
        let table = problem.table().map(|_| Repair::new(problem));
        let repair = table.or_else(|| Repair::needed(problem));
        let mut rng = seeded(seed);
        let first = Code::random(problem, &contours, &mut rng);
        let legs = Legs::new(problem, rates.measure);
        let nodes = nodes(problem, repair.as_ref(), &first);
        let length = length(&legs, &nodes, rates.home_legs);
        let progress = Progress::new(solution(problem, &nodes), length);
        let fitting = MOST_GENES / (4 * contours.len()).max(1);
        Self {
            legs,
            repair,
            contours,
            rates,
            population: (rates.population as usize).min(fitting).max(2),
            rng,
            parents: vec![first],
            lengths: vec![length],
            roulette: Roulette::default(),
            children: Vec::new(),
            child_lengths: Vec::new(),
            raw: Vec::new(),
            generation: 0,
            progress,
        }
    }

    /// Travel of a code, eq. (1).
    fn price(&mut self, code: &Code) -> f64 {
        let problem = self.legs.problem();
        let nodes = nodes(problem, self.repair.as_ref(), code);
        let length = length(&self.legs, &nodes, self.rates.home_legs);
        self.progress.take(length, || solution(problem, &nodes));
        length
    }

    /// Prepares the selection of the generation that begins, eq. (2).
    fn draw_up(&mut self) {
        let Self { lengths, rates, generation, .. } = self;
        self.roulette = Roulette::new(fitness(lengths, rates.lambda, rates.alpha, *generation + 1));
    }

    /// Makes the children of the next pair.
    fn breed(&mut self) {
        let pair = [(); 2].map(|()| &self.parents[self.roulette.spin(&mut self.rng)]);
        let problem = self.legs.problem();
        self.raw = if self.rng.uniform() < self.rates.crossover {
            cross(problem, pair, &mut self.rng).into()
        } else {
            pair.map(Clone::clone).into()
        };
        for child in &mut self.raw {
            if self.rng.uniform() < self.rates.mutation {
                mutate(problem, child, &mut self.rng);
            }
        }
    }
}

/// Length of a tour, with the legs from and to home or without. The cycle of a table of costs has no home.
fn length(legs: &Legs, nodes: &[NodeId], home_legs: bool) -> f64 {
    if home_legs || legs.problem().table().is_some() {
        return legs.tour_length(nodes);
    }
    nodes.windows(2).map(|w| legs.leg(w[0], w[1])).sum()
}

/// The nodes of a code in a feasible order.
fn nodes(problem: &Problem, repair: Option<&Repair>, code: &Code) -> Vec<NodeId> {
    let node = |item: ItemId, point: u32| problem.items[item as usize].nodes.start + point;
    let tour: Vec<NodeId> = code.order.iter().zip(&code.points).map(|(&i, &p)| node(i, p)).collect();
    match repair {
        Some(repair) => repair.tour(problem, &tour),
        None => tour,
    }
}

impl Piecewise for Generations<'_> {
    fn progress(&self) -> &Progress {
        &self.progress
    }

    fn progress_mut(&mut self) -> &mut Progress {
        &mut self.progress
    }

    fn piece(&mut self) -> Option<u64> {
        let contours = self.contours.len() as u64;
        if contours == 0 || self.generation >= self.rates.generations {
            return None;
        }
        if self.parents.len() < self.population {
            let code = Code::random(self.legs.problem(), &self.contours, &mut self.rng);
            let length = self.price(&code);
            self.lengths.push(length);
            self.parents.push(code);
        } else if let Some(child) = self.raw.pop() {
            let length = self.price(&child);
            self.child_lengths.push(length);
            self.children.push(child);
        } else if self.children.len() < self.population {
            if self.children.is_empty() {
                self.draw_up();
            }
            self.breed();
        } else {
            self.parents.clear();
            self.lengths.clear();
            let count = self.population;
            self.parents.extend(self.children.drain(..).take(count));
            self.lengths.extend(self.child_lengths.drain(..).take(count));
            self.generation += 1;
        }
        Some(contours)
    }

    fn insight(&self) -> Insight {
        let length = |name, value| Curve { name, value, chart: charts::LENGTH };
        let least = self.lengths.iter().copied().fold(f64::INFINITY, f64::min);
        let mean = self.lengths.iter().sum::<f64>() / self.lengths.len() as f64;
        let even = fitness(&[0.0, 1.0], self.rates.lambda, self.rates.alpha, self.generation + 1);
        Insight {
            round: self.generation.into(),
            curves: vec![
                length("shortest spare travel f", self.progress.length),
                length("shortest of the generation", least),
                length("mean of the generation", mean),
                Curve { name: "F min / F max of eq. (2)", value: even[1] / even[0], chart: charts::FITNESS },
            ],
            ..Insight::default()
        }
    }
}

#[cfg(test)]
#[allow(clippy::float_cmp, reason = "the numbers of the examples are exact")]
mod tests {
    use super::*;
    use crate::solve::papers::test_sheet::sheet;

    #[test]
    fn equation_1_with_and_without_the_legs_of_home_by_hand() {
        let problem = sheet(&[&[[3.0, 1.0]], &[[4.0, 6.0]], &[[10.0, 5.0]]], None, "length");
        let legs = Legs::new(&problem, Measure::Chebyshev);
        // Between contours: max(1, 5) + max(6, 1). From home 3, and back to it 10.
        assert_eq!(length(&legs, &[0, 1, 2], false), 5.0 + 6.0);
        assert_eq!(length(&legs, &[0, 1, 2], true), 3.0 + 5.0 + 6.0 + 10.0);
    }
}
