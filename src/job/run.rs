//! A plan and the search for it: the problem, the search, its budget and its result.

use super::plan_options::{Budget, PlanOptions};
use super::{Baselines, JobError, Placed, WarmPath, conflicts, findings, problem_of, warm_path};
use crate::finding::Finding;
use crate::machine::Profile;
use crate::plan::{self, LowerBound, Plan};
use crate::problem::Problem;
use crate::sheet::Sheet;
use crate::solve::{self, Insight, Running, Solution, Status, Telemetry};

/// Number of moves before work on the lower bound starts, so that the first paths come first. On large sheets this is about
/// a second of search; on small ones the best path is usually found by then and only the proof is missing.
const BOUND_FROM: u64 = 1_000_000;
/// Number of moves between two slices of work on the bound, and the work of a slice: about a fifth of the time, in slices
/// too short to be felt. It is counted in moves, so that a budget in moves gives the same bound however it is sliced. When
/// the second half of all moves has found nothing better, the larger amount is used.
const BOUND_EVERY: u64 = 100_000;
const BOUND_WORK: [u32; 2] = [4_000_000, 16_000_000];

/// Why a slice ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Serialize)]
#[serde(rename_all = "kebab-case")]
#[cfg_attr(test, derive(ts_rs::TS))]
pub enum SliceEnd {
    /// The requested moves are done; more may help.
    Running,
    /// All moves of the budget are done.
    Budget,
    /// The method cannot improve the plan any more.
    Exhausted,
}

/// The result of a slice of work.
#[derive(Clone, Copy, Debug, PartialEq, serde::Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct Slice {
    /// Number of moves done.
    pub done: u64,
    /// Whether the best plan changed.
    pub improved: bool,
    /// Why it ended.
    pub end: SliceEnd,
    /// Lower bound of the total time of every plan in seconds, as in [`Run::bound`].
    pub bound: f64,
}

/// A plan and the search for it.
pub struct Run {
    /// Where the job lies on the bed of its machine.
    pub placed: Placed,
    /// The machine in the coordinates of the drawing, in which the search works.
    pub machine: Profile,
    /// Name of the material setting that is used.
    pub material: Option<String>,
    /// Name of the method.
    pub method: String,
    /// Its parameters, as given.
    pub parameters: Option<String>,
    /// Seed of its random choices.
    pub seed: u64,
    /// When it stops.
    pub budget: Budget,
    /// Number of parallel searches, including this one.
    pub workers: u32,
    /// The job without a search.
    pub baselines: Baselines,
    /// Findings on this sheet and machine.
    pub findings: Vec<Finding>,
    /// Whether the search began with a given path, or took one over: then seed and moves do not give the plan again.
    pub from_path: bool,
    /// Moves done so far, as requested from the search. Its telemetry may count a few more, because the last move may price
    /// several candidates.
    pub moves: u64,
    running: Running,
    /// What every plan pays, s: added up once, because every slice asks for the bound.
    paid: f64,
    /// Computes a lower bound of what the search minimises; `None` until it starts.
    prover: Option<LowerBound>,
    /// Whether this search works on the bound. Of parallel searches only one does.
    proves: bool,
    /// Number of moves at which work on the bound continues.
    bound_at: u64,
    /// A bound of the whole job that was proven elsewhere, s.
    proven: f64,
}

impl Run {
    pub(super) fn start(sheet: &Sheet, placed: Placed, options: &PlanOptions) -> Result<Self, JobError> {
        let name = options.method.as_deref().unwrap_or(solve::methods()[0].info().name);
        let parameters = options.parameters.as_deref().unwrap_or_default();
        let method = solve::named(name, parameters)?;
        let machine = placed.seen_from_drawing();
        if method.is_published() {
            conflicts::published_method(&machine)?;
        }
        let problem = problem_of(sheet, &machine);
        let summary = |s: &Solution| plan::from_solution(sheet, &problem, s).summary;
        let findings = findings::of_problem(sheet, &machine, &problem);
        let greedy = solve::greedy(&problem);
        let baselines = Baselines {
            drawing: summary(&solve::in_order(&problem, sheet.drawing_order())),
            greedy: summary(&greedy),
        };
        let (workers, stream) = (options.workers()?, options.stream());
        let warm = options.warm.as_ref().map(|w| warm_path::solution(w, &problem)).transpose()?;
        // A published method builds its first path itself.
        let first = if method.is_published() { warm } else { Some(warm.unwrap_or(greedy)) };
        let running = Running::new(problem, |p| solve::start(&*method, p, stream, first.as_ref()));
        Ok(Self {
            placed,
            machine,
            material: options.material.clone(),
            method: name.to_owned(),
            parameters: options.parameters.clone(),
            seed: options.seed,
            budget: options.budget(),
            workers,
            baselines,
            findings,
            from_path: options.warm.is_some(),
            moves: 0,
            paid: running.borrow_owner().paid(),
            running,
            prover: None,
            proves: options.member == 0,
            bound_at: BOUND_FROM,
            proven: 0.0,
        })
    }

    /// Does at most `work` moves, and never more than the budget.
    pub fn step(&mut self, work: u64) -> Slice {
        let left = self.budget.moves.map_or(u64::MAX, |all| all.saturating_sub(self.moves));
        if left == 0 {
            return Slice { done: 0, improved: false, end: SliceEnd::Budget, bound: self.bound() };
        }
        // Stops where work on the bound is due, so that slices of any size give the same bound.
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

    /// Works on the bound, with more effort while the search finds nothing better.
    fn prove(&mut self) {
        if !self.proves {
            return;
        }
        let Telemetry { best, best_at, .. } = self.telemetry();
        let work = BOUND_WORK[usize::from(best_at < self.moves / 2)];
        let problem = self.running.borrow_owner();
        self.prover.get_or_insert_with(|| LowerBound::new(problem)).improve(work, best);
    }

    /// Takes over a path of another search that belongs to the same plan, if it is better. Returns whether it did.
    pub fn offer(&mut self, path: &WarmPath) -> Result<bool, JobError> {
        let found = self.priced(path)?;
        self.running.with_dependent_mut(|_, search| search.offer(&found));
        Ok(self.best().cost.total_cmp(&found.cost).is_eq())
    }

    /// Takes over a path from elsewhere if it is better. Returns whether it did.
    pub fn take_over(&mut self, path: &WarmPath) -> Result<bool, JobError> {
        let found = self.priced(path)?;
        let better = warm_path::is_better(found.cost, self.best().cost);
        if better {
            self.running.with_dependent_mut(|_, search| search.offer(&found));
            self.from_path = true;
        }
        Ok(better)
    }

    fn priced(&self, path: &WarmPath) -> Result<Solution, JobError> {
        Ok(solve::priced(self.problem(), warm_path::solution(path, self.problem())?))
    }

    /// Grants another budget in addition to what is done.
    pub fn extend(&mut self, more: Budget) {
        let moves = more.moves.map(|m| self.moves.saturating_add(m));
        self.budget = Budget { seconds: more.seconds, moves };
    }

    /// Statistics of the search.
    pub fn telemetry(&self) -> Telemetry {
        self.running.borrow_dependent().telemetry()
    }

    /// Insight into a published method; `None` for other methods.
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

    /// The best solution so far as a plan.
    pub fn plan(&self, sheet: &Sheet) -> Plan {
        let mut plan = plan::from_solution(sheet, self.problem(), self.best());
        plan.summary.set_bound(self.bound());
        plan
    }

    /// Lower bound of the total time of every plan in seconds: the bound of the search plus the fixed times; 0 until there
    /// is one. The bound ignores sharp corners; what leaving contours and pierce groups may save is subtracted.
    pub fn bound(&self) -> f64 {
        let least = |prover: &LowerBound| self.paid + prover.value();
        self.prover.as_ref().map_or(0.0, least).max(self.proven)
    }

    /// Takes over a lower bound of the total time of every plan in seconds, which was proven elsewhere. The search does not
    /// depend on it.
    pub fn raise_bound(&mut self, seconds: f64) {
        self.proven = self.proven.max(seconds);
    }
}
