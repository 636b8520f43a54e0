//! A plan under way: the problem, the search that works on it, its budget and what it has found.

use super::options::{Budget, PlanOptions};
use super::{Baselines, JobError, Warm, problem_of, shared, warm};
use crate::finding::Finding;
use crate::machine::Profile;
use crate::plan::{self, LowerBound, Plan};
use crate::problem::{Item, Problem};
use crate::sheet::Sheet;
use crate::solve::{self, Insight, Running, Solution, Status, Telemetry};

/// Moves before the lower bound is begun: the first paths come first. A second of search on large sheets; on small ones
/// the best path is found by then and only the proof is left.
const BOUND_FROM: u64 = 1_000_000;
/// Moves between two slices of work on it, and that work: a fifth or so of the time, and no slice long enough to be felt.
/// Counted in moves, so that a budget in moves gives the same bound however it is sliced. Once half of all moves have
/// found nothing better the rest is proof: more of the time is the bound's.
const BOUND_EVERY: u64 = 100_000;
const BOUND_WORK: [u32; 2] = [4_000_000, 16_000_000];

/// Why a slice ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum SliceEnd {
    /// Its work is done; more may help.
    Running,
    /// All the moves of the budget are done.
    Budget,
    /// The method can gain nothing more.
    Exhausted,
}

/// What came of a slice of work.
#[derive(Clone, Copy, Debug, PartialEq, serde::Serialize)]
pub struct Slice {
    /// Moves done in it.
    pub done: u64,
    /// The best plan changed in it.
    pub improved: bool,
    /// Why it ended.
    pub end: SliceEnd,
    /// Seconds that no plan takes less than, as in [`Run::bound`].
    pub bound: f64,
}

/// A plan under way or done.
pub struct Run {
    /// The machine it is for.
    pub machine: Profile,
    /// Name of the method at work.
    pub method: String,
    /// Its parameters, as they were given.
    pub parameters: Option<String>,
    /// What decides its random choices.
    pub seed: u64,
    /// When it stops.
    pub budget: Budget,
    /// Searches side by side, this one among them.
    pub workers: u32,
    /// How the job would run without it.
    pub baselines: Baselines,
    /// What is worth knowing of the sheet on this machine.
    pub findings: Vec<Finding>,
    /// Moves worked off so far, as the search counts what it was given: its telemetry may run ahead by the last move's
    /// candidates.
    pub moves: u64,
    running: Running,
    /// Works on a lower bound of what the search minimises; `None` until it is first due.
    prover: Option<LowerBound>,
    /// Whether this search works on the bound: one search of several is enough.
    proves: bool,
    /// Moves at which work on it goes on.
    bound_at: u64,
}

impl Run {
    pub(super) fn start(sheet: &Sheet, machine: Profile, options: &PlanOptions) -> Result<Self, JobError> {
        let name = options.method.as_deref().unwrap_or(solve::methods()[0].info().name);
        let parameters = options.parameters.as_deref().unwrap_or_default();
        let method = solve::named(name, parameters).map_err(JobError::Options)?;
        let problem = problem_of(sheet, &machine);
        let summary = |s: &Solution| plan::from_solution(sheet, &problem, s).summary;
        let findings = shared::findings(sheet, &problem);
        let greedy = solve::greedy(&problem);
        let baselines = Baselines {
            drawing: summary(&solve::in_order(&problem, sheet.drawing_order())),
            greedy: summary(&greedy),
        };
        let (workers, stream) = (options.workers()?, options.stream());
        let warm = options.warm.as_ref().map(|w| warm::solution(w, &problem)).transpose()?;
        // A published method builds its first path itself.
        let first = if method.is_published() { warm } else { Some(warm.unwrap_or(greedy)) };
        let running = Running::new(problem, |p| method.start(p, stream, first.as_ref()));
        Ok(Self {
            machine,
            method: name.to_owned(),
            parameters: options.parameters.clone(),
            seed: options.seed,
            budget: options.budget(),
            workers,
            baselines,
            findings,
            moves: 0,
            running,
            prover: None,
            proves: options.member == 0,
            bound_at: BOUND_FROM,
        })
    }

    /// Works for at most `work` moves, and never past the budget.
    pub fn step(&mut self, work: u64) -> Slice {
        let left = self.budget.moves.map_or(u64::MAX, |all| all.saturating_sub(self.moves));
        if left == 0 {
            return Slice { done: 0, improved: false, end: SliceEnd::Budget, bound: self.bound() };
        }
        // Never past the moves at which the bound is due, so that slices of any size prove the same.
        let work = work.min(left).min(self.bound_at.saturating_sub(self.moves).max(1));
        let step = self.running.with_dependent_mut(|_, search| search.step(work));
        self.moves = self.moves.saturating_add(step.done);
        if self.moves >= self.bound_at {
            self.bound_at += BOUND_EVERY;
            self.prove();
        }
        let end = match step.status {
            Status::Exhausted => SliceEnd::Exhausted,
            Status::Running if step.done >= left => SliceEnd::Budget,
            Status::Running => SliceEnd::Running,
        };
        Slice { done: step.done, improved: step.improved, end, bound: self.bound() }
    }

    /// Works on the bound, harder while the search finds nothing better.
    fn prove(&mut self) {
        if !self.proves {
            return;
        }
        let Telemetry { best, best_at, .. } = self.telemetry();
        let work = BOUND_WORK[usize::from(best_at < self.moves / 2)];
        let problem = self.running.borrow_owner();
        self.prover.get_or_insert_with(|| LowerBound::new(problem)).improve(work, best);
    }

    /// Takes over a path found by another search, if it is better: true when it did.
    pub fn offer(&mut self, path: &Warm) -> Result<bool, JobError> {
        let found = warm::solution(path, self.problem())?;
        self.running.with_dependent_mut(|_, search| search.offer(&found));
        Ok(self.best().cost.total_cmp(&found.cost).is_eq())
    }

    /// Grants another budget on top of what is done.
    pub fn extend(&mut self, more: Budget) {
        let moves = more.moves.map(|m| self.moves.saturating_add(m));
        self.budget = Budget { seconds: more.seconds, moves };
    }

    /// Numbers of the search.
    pub fn telemetry(&self) -> Telemetry {
        self.running.borrow_dependent().telemetry()
    }

    /// What makes a published method special, as it stands now; `None` for other methods.
    pub fn insight(&self) -> Option<Insight> {
        self.running.borrow_dependent().insight()
    }

    /// The problem the search works on.
    pub fn problem(&self) -> &Problem {
        self.running.borrow_owner()
    }

    /// The best solution so far.
    pub fn best(&self) -> &Solution {
        self.running.borrow_dependent().best()
    }

    /// The best solution so far as moves of the head, with times.
    pub fn plan(&self, sheet: &Sheet) -> Plan {
        let mut plan = plan::from_solution(sheet, self.problem(), self.best());
        plan.summary.set_bound(self.bound());
        plan
    }

    /// Seconds that no plan takes less than: what is proven of travel, and what every plan pays; 0 before anything is.
    /// The proof knows no sharp corners: where it takes less to leave a contour in one than to wait there, every one of them
    /// may save that.
    pub fn bound(&self) -> f64 {
        let saved =
            |i: &Item| i.run.as_ref().map_or(0.0, |run| run.sharp_corners() as f64) * (-i.resume()).max(0.0);
        let least = |i: &Item| i.fixed - if i.leave.is_some() { saved(i) } else { 0.0 };
        let all = |prover: &LowerBound| self.problem().items.iter().map(least).sum::<f64>() + prover.value();
        self.prover.as_ref().map_or(0.0, all)
    }
}
