//! The partition-tree method and what it is compared with, on one sheet, natively. One JSON line a run.
//!
//!     dewil FILE MACHINE RUNS
//!
//! MACHINE: a profile as JSON. RUNS: a JSON list of `{"name", "method", "parameters", "seeds", "as_long_as", "seconds",
//! "common_cuts", "whole"}`. With `common_cuts` the paths through pierce groups are found in that way, with `whole` no group
//! is left for other contours.
//! Seconds are those of the processor, each method beginning with the same problem in hand. A method without an end works
//! as long as the run of that name, which has one, and no longer: both are run in turn, again and again where that is
//! short, and what counts is how many moves it gets done in that time in the median. With `seconds`, so many at least.

use cpu_time::ThreadTime;
use kerfway::job::{Job, LoadOptions, problem_of};
use kerfway::machine::Profile;
use kerfway::plan::{self, LowerBound};
use kerfway::problem::Problem;
use kerfway::sheet::Sheet;
use kerfway::solve::{self, Search, Status, Stop, papers};
use serde_json::{Value, json};

/// Moves between two looks whether it goes on: some milliseconds.
const SLICE: u64 = 10_000;
/// The same where milliseconds count: 10 to 20 us.
const SHORT: u64 = 100;
/// Both of two methods are run again until that took so many seconds, or so often: a clock tells 1 ms to some percent.
const REPEATED: f64 = 0.5;
const TIMES: usize = 25;
/// Work of the lower bound in one go, numbers looked at, and seconds it gets.
const SLICE_OF_BOUND: u32 = 2_000_000;
const BOUND_SECONDS: f64 = 2.0;

fn main() -> std::process::ExitCode {
    kerfway_bench_solve::ended(bench())
}

fn bench() -> Result<(), String> {
    let args: Vec<String> = std::env::args().skip(1).collect();
    let [file, machine, runs] = &args[..] else { return Err("dewil FILE MACHINE RUNS".into()) };
    let bytes = std::fs::read(file).map_err(|_| format!("{file} cannot be read."))?;
    let machine: Profile = serde_json::from_str(machine).map_err(|e| e.to_string())?;
    let runs: Vec<Value> = serde_json::from_str(runs).map_err(|e| e.to_string())?;
    let mut problems: Vec<(&Value, &Value, Job, Problem)> = Vec::new();
    for run in &runs {
        let (cuts, whole) = (&run["common_cuts"], &run["whole"]);
        if problems.iter().any(|p| (p.0, p.1) == (cuts, whole)) {
            continue;
        }
        let common_cuts = serde_json::from_value(cuts.clone()).unwrap_or_default();
        let load = LoadOptions { common_cuts, ..LoadOptions::default() };
        let job = Job::load(bytes.clone(), file, &load).map_err(|e| e.to_string())?;
        let clock = ThreadTime::now();
        let mut problem = problem_of(job.sheet(), &machine);
        if problems.is_empty() {
            println!("{}", json!({ "name": "problem", "seconds": clock.elapsed().as_secs_f64() }));
        }
        if whole.as_bool() == Some(true) {
            problem.items.iter_mut().flat_map(|i| &mut i.paths).for_each(|p| p.leave_points.clear());
        }
        problems.push((cuts, whole, job, problem));
    }
    // Seconds of the best path by the search's measure, and what every path costs besides.
    let (mut best, mut fixed) = (f64::INFINITY, 0.0);
    for run in &runs {
        let Some((_, _, job, problem)) =
            problems.iter().find(|p| (p.0, p.1) == (&run["common_cuts"], &run["whole"]))
        else {
            continue;
        };
        let case = Case { sheet: job.sheet(), machine: &machine, problem };
        for seed in 1..=run["seeds"].as_u64().unwrap_or(1) {
            let other = runs.iter().find(|r| r["name"] == run["as_long_as"]);
            let (row, cost) = match (other, run["seconds"].as_f64()) {
                (Some(other), Some(least)) => {
                    let clock = ThreadTime::now();
                    case.to_its_end(other, seed)?;
                    let seconds = clock.elapsed().as_secs_f64().max(least);
                    case.timed(run, seed, |search, clock| {
                        while clock.elapsed().as_secs_f64() < seconds {
                            search.step(SLICE);
                        }
                    })?
                }
                (Some(other), None) => {
                    let Some(moves) = case.moves_as_long_as(run, other, seed)? else {
                        println!("{}", json!({ "name": run["name"], "seed": seed, "value": null }));
                        continue;
                    };
                    case.timed(run, seed, |search, _| {
                        search.step(moves);
                    })?
                }
                (None, _) => case.timed(run, seed, |search, _| ended(search))?,
            };
            best = best.min(cost);
            fixed = row["fixed"].as_f64().unwrap_or(0.0);
            // What leaving groups may save is no part of a bound.
            fixed -= problem.items.iter().map(|i| i.fixed - i.least()).sum::<f64>();
            println!("{row}");
        }
    }
    let Some((_, _, _, problem)) = problems.first() else { return Ok(()) };
    let mut bound = LowerBound::new(problem);
    let clock = ThreadTime::now();
    while bound.improve(SLICE_OF_BOUND, best) && clock.elapsed().as_secs_f64() < BOUND_SECONDS {}
    println!("{}", json!({ "name": "bound", "value": bound.value() + fixed }));
    Ok(())
}

/// Works until nothing more can be gained.
fn ended(search: &mut dyn Search) {
    while search.step(SLICE).status != Status::Exhausted {}
}

/// What all methods work on.
struct Case<'c> {
    sheet: &'c Sheet,
    machine: &'c Profile,
    problem: &'c Problem,
}

impl<'c> Case<'c> {
    fn start(&self, run: &Value, seed: u64) -> Result<Box<dyn Search + 'c>, String> {
        let name = run["method"].as_str().ok_or("Which method?")?;
        Ok(match solve::method(name) {
            Some(method) => method.start(self.problem, seed, None),
            None => papers::method(name, &run["parameters"].to_string()).map_err(|e| e.message)?.start(
                self.problem,
                seed,
                None,
            ),
        })
    }

    fn to_its_end(&self, run: &Value, seed: u64) -> Result<(), String> {
        let mut search = self.start(run, seed)?;
        ended(search.as_mut());
        Ok(())
    }

    /// Moves that one method gets done, its start included, while another one works to its end; none if it has not
    /// even started by then.
    fn moves_as_long_as(&self, run: &Value, other: &Value, seed: u64) -> Result<Option<u64>, String> {
        let mut done: Vec<Option<u64>> = Vec::new();
        let all = ThreadTime::now();
        while done.is_empty() || (all.elapsed().as_secs_f64() < REPEATED && done.len() < TIMES) {
            let clock = ThreadTime::now();
            self.to_its_end(other, seed)?;
            let time = clock.elapsed();
            let clock = ThreadTime::now();
            let mut search = self.start(run, seed)?;
            let mut moves = None;
            while clock.elapsed() <= time {
                moves = Some(moves.map_or(0, |moves| moves + SHORT));
                search.step(SHORT);
            }
            done.push(moves);
        }
        done.sort_unstable();
        Ok(done[(done.len() - 1) / 2])
    }

    /// A method at work, its path checked; and what that costs by the search's measure.
    fn timed(
        &self,
        run: &Value,
        seed: u64,
        work: impl FnOnce(&mut dyn Search, ThreadTime),
    ) -> Result<(Value, f64), String> {
        let clock = ThreadTime::now();
        let mut search = self.start(run, seed)?;
        work(search.as_mut(), clock);
        let seconds = clock.elapsed().as_secs_f64();
        let best = search.best();
        let plan = plan::from_solution(self.sheet, self.problem, best);
        plan::check(self.sheet, self.machine, &plan).map_err(|v| format!("{}: {v:?}", run["name"]))?;
        let s = &plan.summary;
        // Everything but cutting, as in the paper.
        let value = s.total_time - s.cut_time;
        let row = json!({
            "name": run["name"], "method": run["method"], "seed": seed, "value": value, "fixed": value - best.cost,
            "left": groups_left(self.problem, &best.stops), "pre_cuts": s.pre_cuts, "pierces": s.pierces, "air": s.air_time, "moves": search.telemetry().moves,
            "seconds": seconds, "contours": self.sheet.contours.len(), "insight": search.insight(),
        });
        Ok((row, best.cost))
    }
}

/// How often pierce groups are left for other contours.
fn groups_left(problem: &Problem, stops: &[Stop]) -> usize {
    let item = |s: &&Stop| &problem.items[problem.nodes[s.node as usize].item as usize];
    let visits = stops.iter().filter(|s| item(s).is_pierce_group()).count();
    visits - problem.items.iter().filter(|i| i.is_pierce_group()).count()
}
