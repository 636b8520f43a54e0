//! The search that decides everything together against one thing after the other, natively: `joint NAME... [--seconds S] [--seeds K]`.
//!
//! A name is a drawing, or `nest:SEED` for a seeded nest of the tests. For each, and for each seed, two JSON lines:
//!
//! * `leads`: the search that knows leads, against one that does not and gets the nearest lead at each of its entries;
//! * `tips`: the search that knows which pieces tip, against one that does not, whose path then avoids them as it is
//!   (`afterwards`) or lifts the head for every move (`lifted`).
//!
//! Both searches of a pair have as much processor time. Seconds are those of the whole job; `rate` is the share of the moves
//! that the search without leads makes.

#[path = "../../../../tests/testkit/leads.rs"]
mod leads;
#[path = "../../../../tests/testkit/sheets.rs"]
mod sheets;

use cpu_time::ThreadTime;
use kerfway::job::{Job, LoadOptions, problem_of};
use kerfway::machine::{LeadKind, Levers, Lift, Profile, Tips, preset};
use kerfway::plan;
use kerfway::problem::Problem;
use kerfway::sheet::Sheet;
use kerfway::solve::{self, Solution, Status};
use kerfway_bench_solve::ended;
use serde_json::json;
use std::process::ExitCode;

/// Contours of a nest.
const NEST: usize = 60;
/// Moves between two readings of the clock.
const SLICE: u64 = 500;
/// Seconds of processor time for which one of two searches works before the other does.
const TURN: f64 = 0.02;

fn main() -> ExitCode {
    ended(run())
}

fn run() -> Result<(), String> {
    let (mut names, mut seconds, mut seeds) = (Vec::new(), 5.0, 5);
    let mut args = std::env::args().skip(1);
    while let Some(word) = args.next() {
        let mut next = || args.next().ok_or(format!("{word} needs a value."));
        match word.as_str() {
            "--seconds" => seconds = next()?.parse().map_err(|_| "--seconds needs a number.")?,
            "--seeds" => seeds = next()?.parse().map_err(|_| "--seeds needs a number.")?,
            _ => names.push(word),
        }
    }
    for name in names {
        let sheet = sheet(&name)?;
        for seed in 1..=seeds {
            println!("{}", leads_row(&name, &sheet, seconds, seed)?);
            println!("{}", tips_row(&name, &sheet, seconds, seed)?);
        }
    }
    Ok(())
}

fn sheet(name: &str) -> Result<Sheet, String> {
    if let Some(seed) = name.strip_prefix("nest:") {
        let seed = seed.parse().map_err(|_| format!("{name} needs a number."))?;
        return Ok(leads::oriented(sheets::nested_sheet_with_gaps(NEST, seed)));
    }
    let bytes = std::fs::read(name).map_err(|e| format!("{name}: {e}"))?;
    let job = Job::load(bytes, name, &LoadOptions::default()).map_err(|e| e.to_string())?;
    Ok(job.sheet().clone())
}

/// The best paths of two problems after some seconds of processor time each, and the numbers of moves. The searches take turns, so
/// that what else the machine does slows both.
fn searched(problems: [&Problem; 2], seconds: f64, seed: u64) -> Result<[(Solution, u64); 2], String> {
    let method = solve::method("tour-tree").ok_or("There is no method tour-tree.")?;
    let mut searches = problems.map(|problem| {
        let clock = ThreadTime::now();
        let search = solve::start(method, problem, seed, None);
        (search, clock.elapsed().as_secs_f64(), Status::Running)
    });
    loop {
        let open = searches.iter_mut().filter(|s| s.1 < seconds && s.2 == Status::Running);
        let Some((search, spent, status)) = open.min_by(|a, b| a.1.total_cmp(&b.1)) else { break };
        let (clock, before, until) = (ThreadTime::now(), *spent, (*spent + TURN).min(seconds));
        while *spent < until && *status == Status::Running {
            *status = search.step(SLICE).status;
            *spent = before + clock.elapsed().as_secs_f64();
        }
    }
    Ok(searches.map(|(search, ..)| (search.best().clone(), search.telemetry().moves)))
}

/// Seconds of the whole job by a path, after its plan passed the checker.
fn seconds_of(sheet: &Sheet, problem: &Problem, path: &Solution) -> Result<f64, String> {
    let plan = plan::from_solution(sheet, problem, path);
    plan::check(sheet, &problem.machine, &plan).map_err(|v| format!("{v:?}"))?;
    Ok(plan.summary.total_time)
}

fn thin() -> Result<Profile, String> {
    preset("fibre-3kw-thin").ok_or("There is no machine fibre-3kw-thin.".to_owned())
}

fn leads_row(name: &str, sheet: &Sheet, seconds: f64, seed: u64) -> Result<serde_json::Value, String> {
    let machine = leads::with_leads(thin()?, leads::leads(LeadKind::Arc, 0.5, 0.2));
    let with = problem_of(sheet, &machine);
    let without = problem_of(sheet, &Profile { leads: None, ..machine });
    let [(joint, moves), (path, plain)] = searched([&with, &without], seconds, seed)?;
    let total = seconds_of(sheet, &with, &joint)?;
    let afterwards = total + leads::attached(&with, &without, &path) - joint.cost;
    Ok(json!({
        "name": name, "table": "leads", "seed": seed, "contours": sheet.contours.len(), "joint": total, "afterwards": afterwards,
        "rate": moves as f64 / plain as f64, "moves_off": plain as f64 / seconds, "moves_on": moves as f64 / seconds,
    }))
}

fn tips_row(name: &str, sheet: &Sheet, seconds: f64, seed: u64) -> Result<serde_json::Value, String> {
    let thin = thin()?;
    let lift = Some(Lift { height: 10.0, stay_down: 0.0, at_rest: false });
    let levers = |lift, tips| Levers { lift, tips, ..Levers::default() };
    let machine = |levers| Profile { z_speed: Some(100.0), levers, ..thin.clone() };
    let avoiding = problem_of(sheet, &machine(levers(lift, Some(Tips::default()))));
    let lifting = problem_of(sheet, &machine(levers(lift, None)));
    let unknowing = problem_of(sheet, &thin);
    let [(joint, _), (path, _)] = searched([&avoiding, &unknowing], seconds, seed)?;
    Ok(json!({
        "name": name, "table": "tips", "seed": seed, "contours": sheet.contours.len(), "joint": seconds_of(sheet, &avoiding, &joint)?,
        "afterwards": seconds_of(sheet, &avoiding, &path)?, "lifted": seconds_of(sheet, &lifting, &path)?,
    }))
}
