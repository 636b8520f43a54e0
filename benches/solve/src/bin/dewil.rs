//! The partition-tree method and what it is compared with, on one sheet, natively. One JSON line a run.
//!
//!     dewil FILE MACHINE RUNS
//!
//! MACHINE: a profile as JSON. RUNS: a JSON list of `{"name", "method", "parameters", "seeds", "as_long_as", "seconds"}`;
//! a method without an end works as many seconds as the run of that name did, or at least so many.

use kerfway::job::{Job, LoadOptions};
use kerfway::machine::Profile;
use kerfway::plan::{self, LowerBound};
use kerfway::problem::{self, Problem};
use kerfway::sheet::Sheet;
use kerfway::solve::{self, Search, Solution, Status, papers};
use serde_json::{Value, json};
use std::time::Instant;

/// Moves between two looks whether it goes on: some milliseconds.
const SLICE: u64 = 10_000;
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
    let job = Job::load(bytes, file, &LoadOptions::default()).map_err(|e| e.to_string())?;
    let sheet = job.sheet();
    let problem = problem::from_sheet(sheet, &machine);
    let mut took: Vec<(Value, u64, f64)> = Vec::new();
    // Seconds of the best path by the search's measure, and what every path costs besides.
    let (mut best, mut fixed) = (f64::INFINITY, 0.0);
    for run in &runs {
        for seed in 1..=run["seeds"].as_u64().unwrap_or(1) {
            let other = took.iter().find(|t| t.0 == run["as_long_as"] && t.1 == seed).map(|t| t.2);
            let wanted = other.map(|other| other.max(run["seconds"].as_f64().unwrap_or(0.0)));
            let (row, cost) = row(run, (seed, wanted), (sheet, &machine, &problem))?;
            took.push((run["name"].clone(), seed, row["seconds"].as_f64().unwrap_or(0.0)));
            best = best.min(cost);
            fixed = row["fixed"].as_f64().unwrap_or(0.0);
            println!("{row}");
        }
    }
    let mut bound = LowerBound::new(&problem);
    let clock = Instant::now();
    while bound.improve(SLICE_OF_BOUND, best) && clock.elapsed().as_secs_f64() < BOUND_SECONDS {}
    println!("{}", json!({ "name": "bound", "value": bound.value() + fixed }));
    Ok(())
}

fn row(
    run: &Value,
    (seed, wanted): (u64, Option<f64>),
    (sheet, machine, problem): (&Sheet, &Profile, &Problem),
) -> Result<(Value, f64), String> {
    let name = run["method"].as_str().ok_or("Which method?")?;
    let clock = Instant::now();
    let made;
    let mut search: Box<dyn Search> = match solve::method(name) {
        Some(method) => method.start(problem, seed, None),
        None => {
            made = papers::method(name, &run["parameters"].to_string())?;
            made.start(problem, seed, None)
        }
    };
    let mut moves = 0;
    while wanted.is_none_or(|wanted| clock.elapsed().as_secs_f64() < wanted) {
        let step = search.step(SLICE);
        moves += step.done;
        if step.status == Status::Exhausted {
            break;
        }
    }
    let seconds = clock.elapsed().as_secs_f64();
    let best: &Solution = search.best();
    let plan = plan::from_solution(sheet, problem, best);
    plan::check(sheet, machine, &plan).map_err(|v| format!("{}: {v:?}", run["name"]))?;
    let s = &plan.summary;
    // Everything but cutting, as in the paper.
    let value = s.total_time - s.cut_time;
    let row = json!({
        "name": run["name"], "method": name, "seed": seed, "value": value, "fixed": value - best.cost,
        "pre_cuts": s.pre_cuts, "pierces": s.pierces, "air": s.air_time, "moves": moves, "seconds": seconds,
        "contours": sheet.contours.len(), "insight": search.insight(),
    });
    Ok((row, best.cost))
}
