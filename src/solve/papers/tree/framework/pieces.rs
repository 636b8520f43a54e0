//! The framework in pieces of work, and what it shows while it runs.

use super::super::drawn_partitions::partitions;
use super::super::entries;
use super::super::gtsp::Gtsp;
use super::super::parameters::FinalEntries;
use super::super::repair::repair;
use super::super::repartition;
use super::super::stage::{After, STEPS, Stage};
use super::super::visits::for_each_visit;
use super::Framework;
use crate::problem::ItemId;
use crate::solve::insight::charts;
use crate::solve::papers::piecewise::{Piecewise, Progress};
use crate::solve::{Curve, Insight};

impl Piecewise for Framework<'_> {
    fn progress(&self) -> &Progress {
        &self.progress
    }

    fn progress_mut(&mut self) -> &mut Progress {
        &mut self.progress
    }

    fn piece(&mut self) -> Option<u64> {
        let step = self.stage.step();
        let (cost, next) = match std::mem::replace(&mut self.stage, Stage::End) {
            Stage::Near => match self.g.list_near() {
                Some(priced) => (priced, Stage::Near),
                None => (1, self.begin()),
            },
            Stage::Construct(mut pfr) => match pfr.piece(&self.g) {
                Some(priced) => (priced, Stage::Construct(pfr)),
                None => {
                    self.forest = pfr.forest;
                    self.take();
                    (1, if self.only_construction { Stage::End } else { self.gtsp(After::Initial) })
                }
            },
            Stage::Gtsp { routes, now, then } => self.gtsp_piece(routes, now, then),
            Stage::Repartition { next, idle, then } => self.repartition_piece(next, idle, then),
            Stage::Connect { mut routes, mut found } => match routes.pop() {
                Some(route) => {
                    let priced = found.look(&self.g, &self.forest, route);
                    (priced, Stage::Connect { routes, found })
                }
                None => {
                    let work = self.resolve(&found);
                    (work, self.gtsp(After::Round))
                }
            },
            Stage::Repair => {
                if let Some((_, best)) = &self.best {
                    self.forest.clone_from(best);
                }
                let (moved, work) = repair(&self.g, &mut self.forest);
                self.moved = moved;
                self.repaired = Some(self.forest.seconds(&self.g));
                self.take();
                (work, self.entries(After::Final))
            }
            Stage::Entries { mut routes, then } => match routes.pop() {
                Some(route) => {
                    let only_moved = then == After::Final && self.parameters.entries == FinalEntries::Moved;
                    let only = only_moved.then_some(self.moved.as_slice());
                    let (_, work) = entries::improve(&self.g, &mut self.forest, route, true, only);
                    (work, Stage::Entries { routes, then })
                }
                None => (1, Self::repartition(then)),
            },
            Stage::End => return None,
        };
        self.stage = next;
        self.work[step] += cost;
        Some(cost)
    }

    fn insight(&self) -> Insight {
        let now = self.forest.seconds(&self.g);
        let free = self.best.as_ref().map_or(now, |b| b.0);
        let mut pre_cuts = 0_u32;
        for_each_visit(&self.g, &self.forest, |v| pre_cuts += u32::from(!v.closes));
        let depth = self.forest.used().map(|r| self.forest.depth(&self.g, r)).max().unwrap_or(0);
        let value = |name, value| Curve { name, value, chart: charts::SECONDS };
        let number = |name, value| Curve { name, value, chart: charts::COUNTS };
        let count = u32::try_from(self.forest.used().count()).unwrap_or(u32::MAX);
        let mut curves = vec![
            value("time now, s", now),
            value("best with precedence left out, s", free),
            value("repaired, s", self.repaired.unwrap_or(now)),
            value("repaired and improved, s", self.ended.unwrap_or(now)),
            number("partitions", count.into()),
            number("depth", depth.into()),
            number("pre-cuts", pre_cuts.into()),
        ];
        // Figure 9 of the paper, by work instead of time.
        let all = self.work.iter().sum::<u64>().max(1) as f64;
        let share = |(name, &work): (_, &u64)| Curve { name, value: work as f64 / all, chart: charts::WORK };
        curves.extend(STEPS.into_iter().zip(&self.work).map(share));
        let partitions = Some(partitions(self.g.problem, self.progress.solution()));
        Insight { round: self.round.into(), curves, grid: None, partitions }
    }
}

impl Framework<'_> {
    /// Goes on with the GTSP of a partition, or begins that of the next one.
    fn gtsp_piece(&mut self, mut routes: Vec<u32>, now: Option<Box<Gtsp>>, then: After) -> (u64, Stage) {
        if let Some(mut now) = now {
            if let Some(moves) = now.piece() {
                return (moves, Stage::Gtsp { routes, now: Some(now), then });
            }
            let route = now.route();
            now.take(&self.g, &mut self.forest);
            self.solved.insert(self.key(route));
            return (1, Stage::Gtsp { routes, now: None, then });
        }
        match routes.pop() {
            Some(route) if self.solved.contains(&self.key(route)) => {
                (1, Stage::Gtsp { routes, now: None, then })
            }
            Some(route) => {
                let mut moves = 1;
                self.seed = self.seed.wrapping_add(1);
                let budget = (self.seed, self.parameters.gtsp_moves);
                let now = Gtsp::new(&self.g, &mut self.forest, route, budget, &mut moves).map(Box::new);
                (moves, Stage::Gtsp { routes, now, then })
            }
            None => (1, self.after(then, false)),
        }
    }

    /// Looks for a move of the next contour.
    fn repartition_piece(&mut self, next: usize, idle: usize, then: After) -> (u64, Stage) {
        let count = self.g.problem.items.len();
        if idle >= count {
            return (1, self.after(then, true));
        }
        if self.g.problem.items[next].nodes.is_empty() {
            return (1, Stage::Repartition { next: (next + 1) % count, idle: idle + 1, then });
        }
        let item = ItemId::try_from(next).unwrap_or(ItemId::MAX);
        let sets = (self.parameters.repartition, self.parameters.reattach);
        let keep = then != After::Round;
        let (gained, priced) = repartition::improve(&self.g, &mut self.forest, item, sets, keep);
        let (next, idle) = if gained { (next, 0) } else { ((next + 1) % count, idle + 1) };
        (priced, Stage::Repartition { next, idle, then })
    }
}
