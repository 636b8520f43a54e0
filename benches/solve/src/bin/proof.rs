//! The whole proof of a job, as its worker does it beside the search, natively: `proof FILE... [--machine NAME] [--seconds S]`.
//! A JSON line for each drawing: the air time of the best path that the proof has found, the share of it that is not proven at the end, after how many
//! seconds some shares were proven, and when the proof ended. Seconds are those of the processor.

use cpu_time::ThreadTime;
use kerfway::job::{Job, LoadOptions, MachineChoice, PlanOptions, Proof};
use serde_json::{Value, json};

/// Work between two looks at the clock: a few milliseconds.
const SLICE: u32 = 2_000_000;
/// Shares of the air that are not proven yet. The last is about what the proof of an optimum leaves.
const LEFT: [f64; 5] = [1e-1, 1e-2, 1e-3, 1e-4, 2e-7];

fn main() {
    let (mut files, mut machine, mut seconds) = (Vec::new(), "length".to_owned(), 60.0);
    let mut args = std::env::args().skip(1);
    while let Some(word) = args.next() {
        match word.as_str() {
            "--machine" => machine = args.next().unwrap_or(machine),
            "--seconds" => seconds = args.next().and_then(|s| s.parse().ok()).unwrap_or(seconds),
            _ => files.push(word),
        }
    }
    for file in files {
        match proven(&file, &machine, seconds) {
            Ok(line) => println!("{line}"),
            Err(why) => eprintln!("{file}: {why}"),
        }
    }
}

fn proven(file: &str, machine: &str, seconds: f64) -> Result<Value, String> {
    let bytes = std::fs::read(file).map_err(|e| e.to_string())?;
    let machine = MachineChoice::Preset(machine.to_owned());
    let options = PlanOptions { machine, allow_off_bed: true, ..PlanOptions::default() };
    let reading = LoadOptions::default();
    let mut job = Job::load(bytes.clone(), file, &reading).map_err(|e| e.to_string())?;
    job.start(&options).map_err(|e| e.to_string())?;
    let mut proof = Proof::start(bytes, file, reading, &options).map_err(|e| e.to_string())?;
    let (start, mut rises) = (ThreadTime::now(), Vec::new());
    let (mut more, mut best) = (true, 0.0);
    while more && start.elapsed().as_secs_f64() < seconds {
        more = proof.improve(SLICE);
        if proof.seconds() > best {
            best = proof.seconds();
            rises.push((start.elapsed().as_secs_f64(), best));
        }
    }
    let ended = start.elapsed().as_secs_f64();
    let run = job.run_mut().map_err(|e| e.to_string())?;
    if let Some(path) = proof.better_path() {
        run.take_over(&path).map_err(|e| e.to_string())?;
    }
    let contours = job.sheet().contours.len();
    let summary = job.run().map_err(|e| e.to_string())?.plan(job.sheet()).summary;
    let when = |left: f64| {
        let enough = summary.total_time - left * summary.air_time;
        rises.iter().find(|(_, bound)| *bound >= enough).map(|(at, _)| *at)
    };
    Ok(json!({
        "drawing": file, "contours": contours, "air": summary.air_time,
        "left": (summary.total_time - best) / summary.air_time,
        "proven": LEFT.map(|left| json!({ "but": left, "seconds": when(left) })),
        "seconds": ended, "done": !more,
    }))
}
