//! The search on benchmark instances, natively: `kerfway-bench-solve FILE... [--seconds S | --moves N] [--seeds K]
//! [--first SEED] [--json [--tour]]`. Prints one line for each instance, or one JSON line for each run, with the nodes of the
//! tour if `--tour` is given. A run ends as soon as it reaches the best known value, unless `--on` is given. `--cpu` counts
//! processor time instead of the time of the clock, for a machine that others use too (Linux only).

use kerfway::solve::{self, Status};
use kerfway_bench_solve::source::Source;
use std::time::Instant;

/// Moves between two readings of the clock: about a millisecond.
const SLICE: u64 = 5_000;

struct Options {
    files: Vec<String>,
    seconds: f64,
    moves: u64,
    seeds: u64,
    first: u64,
    json: bool,
    on: bool,
    cpu: bool,
    tour: bool,
}

/// The result of one run.
struct Run {
    value: f64,
    seconds: f64,
    moves: u64,
    /// Seconds until the best was found.
    found: f64,
    reached: bool,
    /// Seconds and value at the start and at every improvement.
    trace: Vec<(f64, f64)>,
    /// The numbers of the nodes in the file; none for sheets.
    tour: Option<Vec<u32>>,
}

fn main() {
    let outcome = options().and_then(|options| {
        for file in &options.files {
            for source in Source::read(file)? {
                bench(&source, &options)?;
            }
        }
        Ok(())
    });
    if let Err(why) = outcome {
        eprintln!("{why}");
        std::process::exit(1);
    }
}

fn options() -> Result<Options, String> {
    let mut o = Options {
        files: Vec::new(),
        seconds: 10.0,
        moves: u64::MAX,
        seeds: 5,
        first: 1,
        json: false,
        on: false,
        cpu: false,
        tour: false,
    };
    let mut args = std::env::args().skip(1);
    while let Some(word) = args.next() {
        let mut number = || {
            args.next().and_then(|n| n.parse::<f64>().ok()).ok_or_else(|| format!("{word} needs a number."))
        };
        match word.as_str() {
            "--seconds" => o.seconds = number()?,
            "--moves" => (o.moves, o.seconds) = (number()? as u64, f64::INFINITY),
            "--seeds" => o.seeds = number()? as u64,
            "--first" => o.first = number()? as u64,
            "--json" => o.json = true,
            "--on" => o.on = true,
            "--cpu" => o.cpu = true,
            "--tour" => o.tour = true,
            _ => o.files.push(word),
        }
    }
    Ok(o)
}

fn bench(source: &Source, options: &Options) -> Result<(), String> {
    let mut runs = Vec::new();
    for seed in options.first..options.first + options.seeds {
        let run =
            run(source, seed, options).map_err(|fault| format!("{} seed {seed}: {fault}", source.name))?;
        if options.json {
            let mut row = serde_json::json!({
                "instance": source.name, "items": source.problem.items.len(), "nodes": source.problem.nodes.len(),
                "known": source.known, "seed": seed, "value": run.value, "gap": gap(source, &run),
                "seconds": run.seconds, "found": run.found, "moves": run.moves, "reached": run.reached,
                "trace": run.trace, "memory": peak(),
            });
            if options.tour {
                row["tour"] = serde_json::json!(run.tour);
            }
            println!("{row}");
        }
        runs.push(run);
    }
    if !options.json {
        let gaps: Vec<f64> = runs.iter().filter_map(|r| gap(source, r)).collect();
        let reached = runs.iter().filter(|r| r.reached).count();
        let mut found: Vec<f64> = runs.iter().map(|r| r.found).collect();
        found.sort_by(f64::total_cmp);
        let best = runs.iter().map(|r| r.value).fold(f64::INFINITY, f64::min);
        let rate =
            runs.iter().map(|r| r.moves as f64).sum::<f64>() / runs.iter().map(|r| r.seconds).sum::<f64>();
        let values: Vec<String> = runs.iter().take(8).map(|r| format!("{:.3}", r.value)).collect();
        println!(
            "{:28} {:4} items known {:10.3} best {best:10.3} reached {reached}/{} mean gap {:.3} % median found {:.3} s {:.1} M/s  {}",
            source.name,
            source.problem.items.len(),
            source.known.unwrap_or(f64::NAN),
            runs.len(),
            gaps.iter().sum::<f64>() / gaps.len() as f64,
            found[found.len() / 2],
            rate / 1e6,
            values.join(" "),
        );
    }
    Ok(())
}

fn run(source: &Source, seed: u64, options: &Options) -> Result<Run, String> {
    let clock = Clock::start(options.cpu);
    let method = solve::method("tour-tree").ok_or("There is no default method.")?;
    let mut search = method.start(&source.problem, seed, None);
    let (mut moves, mut found) = (0, 0.0);
    let reached = |cost: f64| source.known.is_some_and(|k| cost <= k + 1e-6);
    let mut least = search.telemetry().best;
    let mut trace = vec![(clock.seconds(), least)];
    loop {
        let step = search.step(SLICE.min(options.moves - moves));
        moves += step.done;
        if step.improved {
            found = clock.seconds();
            least = search.telemetry().best;
            trace.push((found, least));
        }
        let over = moves >= options.moves || clock.seconds() >= options.seconds;
        if over || step.status == Status::Exhausted || (reached(least) && !options.on) {
            let seconds = clock.seconds();
            // Checked at the end only: on 10,000 contours a check at every improvement would take most of the time.
            least = source.checked(search.best())?;
            trace.push((found, least));
            let tour = source.tour(search.best());
            return Ok(Run { value: least, seconds, moves, found, reached: reached(least), trace, tour });
        }
    }
}

/// A clock: time of day, or processor time, which does not count what other programs take on a shared machine.
enum Clock {
    Wall(Instant),
    Processor(f64),
}

impl Clock {
    fn start(cpu: bool) -> Self {
        if cpu { Self::Processor(processor()) } else { Self::Wall(Instant::now()) }
    }

    fn seconds(&self) -> f64 {
        match self {
            Self::Wall(start) => start.elapsed().as_secs_f64(),
            Self::Processor(start) => processor() - start,
        }
    }
}

/// Processor time of this program in seconds, as Linux reports it; NaN on other systems.
fn processor() -> f64 {
    let text = std::fs::read_to_string("/proc/self/schedstat").unwrap_or_default();
    text.split(' ').next().and_then(|ns| ns.parse::<f64>().ok()).map_or(f64::NAN, |ns| ns / 1e9)
}

/// The most memory that this program has held so far, in bytes, as Linux reports it; `None` on other systems.
fn peak() -> Option<f64> {
    let text = std::fs::read_to_string("/proc/self/status").ok()?;
    let row = text.lines().find_map(|l| l.strip_prefix("VmHWM:"))?;
    row.trim().strip_suffix(" kB")?.parse::<f64>().ok().map(|kb| 1024.0 * kb)
}

fn gap(source: &Source, run: &Run) -> Option<f64> {
    source.known.map(|known| 100.0 * (run.value - known) / known)
}
