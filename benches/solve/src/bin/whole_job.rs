//! Seconds of whole jobs, natively: `kerfway-bench-whole-job FILE --machines JSON [--moves N] [--seed S]`.
//!
//! `--machines` is a list of `{"preset": NAME, "base": {...}, "set": {...}}`: the fields that `base` gives replace those of the preset,
//! and the fields that `set` gives replace those. For each, a JSON line: the seconds of the nearest-next path with holes first on the machine of `base`, and those of the best
//! path that the search finds on the changed machine. With `"then": {...}`, the path is searched for on the machine of `set`
//! and then run as it is on that of `then`. Every plan is checked.

use kerfway::job::{Job, LoadOptions, MachineChoice, PlanOptions, problem_of};
use kerfway::machine::{self, Profile};
use kerfway::plan::{self, Plan};
use kerfway::solve::{self, Status};
use serde_json::{Value, json};

/// A file and its bytes.
type Drawing<'a> = (&'a str, &'a [u8]);

fn main() {
    if let Err(why) = run() {
        eprintln!("{why}");
        std::process::exit(1);
    }
}

fn run() -> Result<(), String> {
    let (mut file, mut machines, mut moves, mut seed) = (String::new(), String::new(), 200_000, 1);
    let mut args = std::env::args().skip(1);
    while let Some(word) = args.next() {
        let mut next = || args.next().ok_or(format!("{word} needs a value."));
        match word.as_str() {
            "--machines" => machines = next()?,
            "--moves" => moves = next()?.parse().map_err(|_| "--moves needs a number.")?,
            "--seed" => seed = next()?.parse().map_err(|_| "--seed needs a number.")?,
            _ => file = word,
        }
    }
    let bytes = std::fs::read(&file).map_err(|e| format!("{file}: {e}"))?;
    let machines: Vec<Value> = serde_json::from_str(&machines).map_err(|e| e.to_string())?;
    for machine in machines {
        println!("{}", row((&file, &bytes), &machine, moves, seed)?);
    }
    Ok(())
}

fn row(drawing: Drawing, wanted: &Value, moves: u64, seed: u64) -> Result<Value, String> {
    let name = wanted["preset"].as_str().unwrap_or_default();
    let preset = machine::preset(name).ok_or(format!("There is no machine {name}."))?;
    let preset = changed(&preset, &wanted["base"])?;
    let machine = changed(&preset, &wanted["set"])?;
    let then = if wanted["then"].is_null() { machine.clone() } else { changed(&preset, &wanted["then"])? };
    let nearest = planned(drawing, [&preset; 2], 0, seed)?;
    let ours = planned(drawing, [&machine, &then], moves, seed)?;
    let s = &ours.summary;
    Ok(json!({
        "file": drawing.0, "preset": name, "set": wanted["set"], "contours": s.contours,
        "nearest_next": nearest.summary.total_time, "total": s.total_time, "air": s.air_time, "cut": s.cut_time,
        "pierce": s.pierce_time, "pierces": s.pierces, "chains": s.chains, "lifts": s.lifts, "detours": s.detours, "crossings": s.crossings,
        "waits": s.waits, "wait_time": s.wait_time, "hot_pairs": s.hot_pairs,
    }))
}

fn changed(preset: &Profile, set: &Value) -> Result<Profile, String> {
    let mut value = serde_json::to_value(preset).map_err(|e| e.to_string())?;
    for (field, to) in set.as_object().into_iter().flatten() {
        value[field] = to.clone();
    }
    serde_json::from_value(value).map_err(|e| e.to_string())
}

/// The plan after some moves of the search, checked; without moves, the nearest-next path.
fn planned(
    (_, bytes): Drawing,
    [machine, then]: [&Profile; 2],
    moves: u64,
    seed: u64,
) -> Result<Plan, String> {
    let mut job = Job::load(bytes.to_vec(), "sheet", &LoadOptions::default()).map_err(|e| e.to_string())?;
    if machine.kerf_width > 0.0 || machine.levers.bridges.is_some() {
        // The lines of the beam, around connected parts where there are bridges.
        let chosen = MachineChoice::Profile(Box::new(machine.clone()));
        let options = PlanOptions { machine: chosen, allow_off_bed: true, ..PlanOptions::default() };
        job.start(&options).map_err(|e| e.to_string())?;
    }
    let sheet = job.beam_sheet();
    let problem = problem_of(sheet, machine);
    let method = solve::method("tour-tree").ok_or("There is no method tour-tree.")?;
    let mut search = solve::start(method, &problem, seed, None);
    let mut left = moves;
    while left > 0 {
        let step = search.step(left);
        left -= step.done.min(left);
        if step.status == Status::Exhausted {
            break;
        }
    }
    let solution = if moves == 0 { solve::greedy(&problem) } else { search.best().clone() };
    let plan = plan::from_solution(sheet, &problem_of(sheet, then), &solution);
    plan::check(sheet, then, &plan).map_err(|v| format!("{v:?}"))?;
    Ok(plan)
}
