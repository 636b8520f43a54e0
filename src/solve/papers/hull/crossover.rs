//! The three segmented crossovers, which are the agent's actions (section 4.3), and their first three steps.
//!
//! (a) In every path, a run of genes is exchanged with a run of the other chromosome: at the same places (PSX), reversed
//! (RSX), or at any places of the longer path (ISX). The paper reverses runs but does not say whether the cutting
//! directions are reversed too: `reversed_run` says so. By default they are, so that the air moves within a run stay the same.
//! (b) Outside the runs, genes that occur twice are blanked.
//! (c) Paths that migrations made shorter than their contour get blanks from longer paths, at random, as long as those have
//! any.
//!
//! Step (d) fills the blanks: `filling.rs`.

use super::chromosome::{Chromosome, run};
use super::model::{BLANK, Gene};
use crate::solve::rng::{Draw, Rng};
use serde::{Deserialize, Serialize};

/// A segmented crossover.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub(super) enum Operator {
    /// PSX, the positive crossover.
    Positive,
    /// RSX, the reverse crossover.
    Reverse,
    /// ISX, the intersect crossover.
    Intersect,
}

/// What RSX reverses.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum ReversedRun {
    /// The order of the run and the cutting direction of each of its segments: the run is cut backwards.
    #[default]
    Turned,
    /// The order of the run only, as the sentence of the paper has it, word for word.
    OrderOnly,
}

/// The crossovers in the order of the columns of the Q-table.
pub(super) const OPERATORS: [Operator; 3] = [Operator::Positive, Operator::Reverse, Operator::Intersect];

/// A chromosome with blanks, and the segments that it lacks.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Torn {
    pub(super) chromosome: Chromosome,
    /// As many segments as there are blanks.
    pub(super) missing: Vec<u32>,
}

/// The first places of a run in both chromosomes, and its length.
#[derive(Clone, Copy, Debug)]
struct Exchange {
    places: [usize; 2],
    length: usize,
}

/// Steps (a) to (c) for two chromosomes. `sizes` is the number of segments of each contour.
pub(super) fn cross(
    (by, reversed): (Operator, ReversedRun),
    parents: [&Chromosome; 2],
    sizes: &[u32],
    rng: &mut Rng,
) -> [Torn; 2] {
    let runs: Vec<Exchange> = (0..sizes.len()).filter_map(|m| exchange(by, parents, m, rng)).collect();
    [0, 1].map(|side| {
        let mut torn = receive((by, reversed), parents, side, &runs);
        complete(&mut torn.chromosome, sizes, rng);
        torn
    })
}

/// The runs of a path that are exchanged; `None` where a path is empty.
fn exchange(by: Operator, parents: [&Chromosome; 2], path: usize, rng: &mut Rng) -> Option<Exchange> {
    let paths = parents.map(|p| p.path(path));
    let shorter = usize::from(paths[1].len() < paths[0].len());
    if paths[shorter].is_empty() {
        return None;
    }
    let run = run(paths[shorter].len(), rng);
    let mut places = [run.start; 2];
    if by == Operator::Intersect {
        places[1 - shorter] = rng.below(paths[1 - shorter].len() - run.len() + 1);
    }
    Some(Exchange { places: [0, 1].map(|p| paths[p].start + places[p]), length: run.len() })
}

/// One of the chromosomes with the runs of the other one. Genes that then occur twice are blanked.
fn receive(
    (by, reversed): (Operator, ReversedRun),
    parents: [&Chromosome; 2],
    side: usize,
    runs: &[Exchange],
) -> Torn {
    let mut chromosome = parents[side].clone();
    let mut held = vec![false; chromosome.genes.len()];
    let mut fixed = vec![false; chromosome.genes.len()];
    for run in runs {
        let given = &parents[1 - side].genes[run.places[1 - side]..][..run.length];
        let place = run.places[side];
        fixed[place..place + run.length].fill(true);
        let own = &mut chromosome.genes[place..place + run.length];
        if by == Operator::Reverse {
            let turned = u32::from(reversed == ReversedRun::Turned);
            own.iter_mut().zip(given.iter().rev()).for_each(|(o, g)| *o = g ^ turned);
        } else {
            own.copy_from_slice(given);
        }
        own.iter().for_each(|&g| held[segment(g)] = true);
    }
    for (gene, _) in chromosome.genes.iter_mut().zip(&fixed).filter(|g| !g.1) {
        if std::mem::replace(&mut held[segment(*gene)], true) {
            *gene = BLANK;
        }
    }
    let missing = (0..).zip(&held).filter(|h| !h.1).map(|h| h.0).collect();
    Torn { chromosome, missing }
}

fn segment(gene: Gene) -> usize {
    gene as usize / 2
}

/// Moves blanks from paths that are longer than their contours to shorter ones.
fn complete(chromosome: &mut Chromosome, sizes: &[u32], rng: &mut Rng) {
    let lengths: Vec<usize> = (0..sizes.len()).map(|m| chromosome.path(m).len()).collect();
    let size = |m: usize| sizes[m] as usize;
    if (0..sizes.len()).all(|m| lengths[m] == size(m)) {
        return;
    }
    // For each longer path, the number of blanks that it can give.
    let mut over: Vec<(usize, usize)> = (0..sizes.len())
        .map(|m| {
            let blanks = chromosome.genes[chromosome.path(m)].iter().filter(|&&g| g == BLANK).count();
            (m, blanks.min(lengths[m].saturating_sub(size(m))))
        })
        .filter(|o| o.1 > 0)
        .collect();
    let mut change = vec![0_isize; sizes.len()];
    for m in 0..sizes.len() {
        for _ in lengths[m]..size(m) {
            if over.is_empty() {
                break;
            }
            let which = rng.below(over.len());
            let from = &mut over[which];
            change[from.0] -= 1;
            change[m] += 1;
            from.1 -= 1;
            if from.1 == 0 {
                over.swap_remove(which);
            }
        }
    }
    let mut genes = Vec::with_capacity(chromosome.genes.len());
    let mut ends = Vec::with_capacity(sizes.len());
    for (m, change) in change.into_iter().enumerate() {
        let mut drop = usize::try_from(-change).unwrap_or(0);
        let start = genes.len();
        genes.extend(chromosome.genes[chromosome.path(m)].iter().filter(|&&g| {
            let gone = g == BLANK && drop > 0;
            drop -= usize::from(gone);
            !gone
        }));
        for _ in 0..usize::try_from(change).unwrap_or(0) {
            let place = start + rng.below(genes.len() - start + 1);
            genes.insert(place, BLANK);
        }
        ends.push(u32::try_from(genes.len()).unwrap_or(u32::MAX));
    }
    (chromosome.genes, chromosome.ends) = (genes, ends);
}
