//! The last step of a crossover, (d): blanks are filled.
//!
//! "All the segments not on the chromosome are first filled with appropriate empty slots. Then, the remaining empty slots are
//! filled with the remaining segments in a random order according to the principle of minimal increments" (section 4.3). A
//! segment is appropriate for a blank if it continues from the gene before the blank, or leads to the gene after it, without
//! an air move. Each remaining segment is put, in the direction and at the blank, where it adds the least travel. Adjacent
//! blanks add the same, so only the first of them is considered. The neighbours of a blank are the nearest genes that are
//! not blank.

use super::chromosome::Chromosome;
use super::crossover::Torn;
use super::model::{BLANK, Gene, Model};
use crate::problem::NodeId;
use crate::solve::rng::{Draw, Rng};

/// Number of legs priced in one piece: a fraction of a millisecond.
const CHUNK: u64 = 20_000;

/// A chromosome whose blanks are being filled.
pub(super) struct Filling {
    chromosome: Chromosome,
    /// Segments that have no place yet; the last is next.
    missing: Vec<u32>,
    /// Ranges of blanks.
    blanks: Vec<std::ops::Range<usize>>,
}

impl Filling {
    /// Places the appropriate segments and shuffles the others.
    pub(super) fn new(model: &Model, torn: Torn, rng: &mut Rng) -> Self {
        let Torn { mut chromosome, mut missing } = torn;
        let genes = &mut chromosome.genes;
        let mut lacks = vec![false; model.segments()];
        missing.iter().for_each(|&s| lacks[s as usize] = true);
        let mut take = |gene: Option<Gene>| gene.filter(|&g| std::mem::take(&mut lacks[g as usize / 2]));
        for k in 1..genes.len() {
            if genes[k] == BLANK && genes[k - 1] != BLANK {
                genes[k] = take(model.goes_on(genes[k - 1])).unwrap_or(BLANK);
            }
        }
        for k in (1..genes.len()).rev() {
            if genes[k - 1] == BLANK && genes[k] != BLANK {
                genes[k - 1] = take(model.goes_on(genes[k] ^ 1)).map_or(BLANK, |g| g ^ 1);
            }
        }
        missing.retain(|&s| lacks[s as usize]);
        for k in (1..missing.len()).rev() {
            missing.swap(k, rng.below(k + 1));
        }
        let mut blanks: Vec<std::ops::Range<usize>> = Vec::new();
        for (k, _) in chromosome.genes.iter().enumerate().filter(|g| *g.1 == BLANK) {
            match blanks.last_mut().filter(|b| b.end == k) {
                Some(stretch) => stretch.end = k + 1,
                None => blanks.push(k..k + 1),
            }
        }
        Self { chromosome, missing, blanks }
    }

    /// Places some segments. Returns the number of legs priced.
    pub(super) fn work(&mut self, model: &Model) -> u64 {
        let mut priced = 0;
        while priced < CHUNK {
            let Some(segment) = self.missing.pop() else { break };
            priced += self.place(model, segment);
        }
        priced
    }

    /// The chromosome, when no segment is missing.
    pub(super) fn full(&mut self) -> Option<Chromosome> {
        let empty = Chromosome { genes: Vec::new(), ends: Vec::new(), length: f64::INFINITY };
        self.missing.is_empty().then(|| std::mem::replace(&mut self.chromosome, empty))
    }

    fn place(&mut self, model: &Model, segment: u32) -> u64 {
        let genes = &self.chromosome.genes;
        let mut best: Option<(f64, usize, Gene)> = None;
        for (which, blanks) in self.blanks.iter().enumerate() {
            let before: Option<NodeId> = blanks.start.checked_sub(1).map(|k| model.cut(genes[k]).leave);
            let behind: Option<NodeId> = genes.get(blanks.end).map(|&g| model.cut(g).enter);
            let closed = model.gap(before, behind);
            for gene in [2 * segment, 2 * segment + 1] {
                let cut = model.cut(gene);
                let more = model.gap(before, Some(cut.enter)) + model.gap(Some(cut.leave), behind) - closed;
                if best.is_none_or(|b| more < b.0) {
                    best = Some((more, which, gene));
                }
            }
        }
        let Some((_, which, gene)) = best else { return 1 };
        let priced = 5 * self.blanks.len() as u64;
        let blanks = &mut self.blanks[which];
        self.chromosome.genes[blanks.start] = gene;
        blanks.start += 1;
        if blanks.start == blanks.end {
            self.blanks.swap_remove(which);
        }
        priced
    }
}
