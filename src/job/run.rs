//! A plan under way: the problem, the search that works on it, its budget and what it has found.

use super::hosted::Hosted;
use super::options::{Budget, PlanOptions};
use super::{Baselines, JobError, Warm, problem_of, shared, warm};
use crate::finding::Finding;
use crate::machine::Profile;
#[cfg(feature = "lab")]
use crate::plan::LowerBound;
use crate::plan::{self, Plan};
use crate::problem::{Item, Problem};
use crate::sheet::Sheet;
use crate::solve::{self, Running, Search, Solution, Solver, Status, Telemetry};

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
#[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Serialize)]
pub struct Slice {
    /// Moves done in it.
    pub done: u64,
    /// The best plan changed in it.
    pub improved: bool,
    /// Why it ended.
    pub end: SliceEnd,
    /// Work on the bound that is due, for whoever proves it: see [`Run::set_proven`].
    pub prove: u32,
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
    /// Of what the search minimises; one search of several is enough to work on it. In the planner's wasm it is worked
    /// on from outside, by a wasm file of its own.
    #[cfg(feature = "lab")]
    prover: Option<LowerBound>,
    /// Proven of what the search minimises; `None` before anything is, and where another search sees to it.
    proven: Option<f64>,
    /// Sees to it.
    proves: bool,
    /// Moves at which work on it goes on.
    bound_at: u64,
}

impl Run {
    pub(super) fn start(sheet: &Sheet, machine: Profile, options: &PlanOptions) -> Result<Self, JobError> {
        let name = options.method.as_deref().unwrap_or(solve::methods()[0].info().name);
        let method = Method::named(name, options)?;
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
        #[cfg(feature = "lab")]
        let prover = (options.member == 0).then(|| LowerBound::new(&problem));
        let running = Running::try_new(problem, |p| method.start(p, stream, warm, greedy))?;
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
            #[cfg(feature = "lab")]
            prover,
            proven: None,
            proves: options.member == 0,
            bound_at: BOUND_FROM,
        })
    }

    /// Works for at most `work` moves, and never past the budget.
    pub fn step(&mut self, work: u64) -> Slice {
        let left = self.budget.moves.map_or(u64::MAX, |all| all.saturating_sub(self.moves));
        if left == 0 {
            return Slice { done: 0, improved: false, end: SliceEnd::Budget, prove: 0 };
        }
        let work = self.grant(work);
        let mut prove = 0;
        let step = self.running.with_dependent_mut(|_, search| search.step(work));
        self.moves = self.moves.saturating_add(step.done);
        if self.moves >= self.bound_at {
            self.bound_at += BOUND_EVERY;
            prove = self.prove();
        }
        let end = match step.status {
            Status::Exhausted => SliceEnd::Exhausted,
            Status::Running if step.done >= left => SliceEnd::Budget,
            Status::Running => SliceEnd::Running,
        };
        Slice { done: step.done, improved: step.improved, end, prove }
    }

    /// As much of `work` as one step may do: within the budget, and up to where the bound is due.
    pub fn grant(&self, work: u64) -> u64 {
        let left = self.budget.moves.map_or(u64::MAX, |all| all.saturating_sub(self.moves));
        work.min(left).min(self.bound_at.saturating_sub(self.moves).max(1))
    }

    /// Works on the bound; gives the work that is left to others.
    #[cfg(feature = "lab")]
    fn prove(&mut self) -> u32 {
        let (cost, work) = (self.telemetry().best, self.bound_work());
        if let Some(prover) = &mut self.prover {
            prover.improve(work, cost);
            self.proven = Some(prover.value());
        }
        0
    }

    #[cfg(not(feature = "lab"))]
    fn prove(&mut self) -> u32 {
        if self.proves { self.bound_work() } else { 0 }
    }

    /// More of it while the search finds nothing better.
    fn bound_work(&self) -> u32 {
        let quiet = self.telemetry().best_at < self.moves / 2;
        BOUND_WORK[usize::from(quiet)]
    }

    /// Takes a bound over, proven elsewhere of what the search minimises.
    pub fn set_proven(&mut self, cost: f64) {
        if self.proves && cost >= self.proven.unwrap_or(0.0) {
            self.proven = Some(cost);
        }
    }

    /// Takes over a path found by another search, if it is better (from a hosted method, always): true when it did.
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
        let saved = |i: &Item| i.run.as_ref().map_or(0.0, |run| run.sharp() as f64) * (-i.resume()).max(0.0);
        let least = |i: &Item| i.fixed - if i.leave.is_some() { saved(i) } else { 0.0 };
        self.proven.map_or(0.0, |cost| self.problem().items.iter().map(least).sum::<f64>() + cost)
    }
}

/// How a run searches.
enum Method {
    Own(&'static dyn Solver),
    #[cfg(feature = "papers")]
    Paper(Box<dyn Solver>),
    #[cfg(not(feature = "papers"))]
    Hosted,
}

impl Method {
    fn named(name: &str, options: &PlanOptions) -> Result<Self, JobError> {
        if let Some(own) = solve::method(name) {
            return Ok(Self::Own(own));
        }
        #[cfg(feature = "papers")]
        {
            let method = solve::papers::method(name, options.parameters.as_deref().unwrap_or_default());
            method.map(Self::Paper).map_err(JobError::Options)
        }
        #[cfg(not(feature = "papers"))]
        if options.parameters.is_some() {
            Ok(Self::Hosted)
        } else {
            let names: Vec<_> = solve::methods().iter().map(|m| m.info().name.to_owned()).collect();
            Err(JobError::Options(super::options::no_such("method", name, &names)))
        }
    }

    fn start<'p>(
        &self,
        p: &'p Problem,
        seed: u64,
        warm: Option<Solution>,
        greedy: Solution,
    ) -> Result<Box<dyn Search + 'p>, JobError> {
        match self {
            Self::Own(own) => Ok(own.start(p, seed, Some(&warm.unwrap_or(greedy)))),
            #[cfg(feature = "papers")]
            Self::Paper(paper) => Ok(Box::new(Hosted::new(p, paper.start(p, seed, None), warm)?)),
            #[cfg(not(feature = "papers"))]
            Self::Hosted => Ok(Box::new(Hosted::new(p, warm.unwrap_or(greedy)))),
        }
    }
}
