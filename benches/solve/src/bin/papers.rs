//! One method on the instances of a file, seed by seed, each run to the method's own end: `papers METHOD FILE
//! [--parameters JSON] [--only NAME] [--seeds K] [--first SEED] [--seconds S] [--threads N] [--trace ROUNDS]`. One JSON line a run, with the length of a tour checked
//! by code that shares nothing with the method. METHOD is one of the papers', or one of Kerfway's, which needs seconds.

use cpu_time::ThreadTime;
use kerfway::solve::{self, Solver, Status, papers};
use kerfway_bench_solve::source::Source;
use kerfway_bench_solve::trace::Trace;
use std::sync::Mutex;
use std::sync::atomic::{AtomicU64, Ordering};

/// Moves between two looks at the clock: about a millisecond.
const SLICE: u64 = 20_000;

struct Options {
    words: Vec<String>,
    parameters: String,
    only: Option<String>,
    seeds: u64,
    /// The first seed.
    first: u64,
    seconds: f64,
    threads: usize,
    /// Rounds between two values of the curves; 0 for none.
    trace: u64,
}

fn main() -> std::process::ExitCode {
    kerfway_bench_solve::ended(options().and_then(|options| bench(&options)))
}

fn options() -> Result<Options, String> {
    let mut o = Options {
        words: Vec::new(),
        parameters: String::new(),
        only: None,
        seeds: 5,
        first: 1,
        seconds: f64::INFINITY,
        trace: 0,
        threads: std::thread::available_parallelism().map_or(1, |n| n.get()),
    };
    let mut args = std::env::args().skip(1);
    while let Some(word) = args.next() {
        let mut next = || args.next().ok_or_else(|| format!("{word} needs a value."));
        let number = |text: String| text.parse::<f64>().map_err(|_| format!("{text} is no number."));
        match word.as_str() {
            "--parameters" => o.parameters = next()?,
            "--first" => o.first = number(next()?)? as u64,
            "--only" => o.only = Some(next()?),
            "--seeds" => o.seeds = number(next()?)? as u64,
            "--threads" => o.threads = number(next()?)?.max(1.0) as usize,
            "--seconds" => o.seconds = number(next()?)?,
            "--trace" => o.trace = number(next()?)? as u64,
            _ => o.words.push(word),
        }
    }
    Ok(o)
}

fn bench(options: &Options) -> Result<(), String> {
    let [name, file] = options.words.as_slice() else { return Err("Which method, on which file?".into()) };
    for source in Source::read(file)? {
        if options.only.as_ref().is_some_and(|only| *only != source.name) {
            continue;
        }
        // Seeds go to as many threads as asked for, or as the machine has.
        let next = AtomicU64::new(options.first);
        let rows = Mutex::new(Ok(Vec::new()));
        std::thread::scope(|scope| {
            for _ in 0..options.threads {
                scope.spawn(|| {
                    loop {
                        let seed = next.fetch_add(1, Ordering::Relaxed);
                        if seed >= options.first + options.seeds {
                            break;
                        }
                        let row = run(&source, name, seed, options);
                        if let Ok(mut rows) = rows.lock() {
                            match (row, rows.as_mut()) {
                                (Ok(row), Ok(list)) => list.push((seed, row)),
                                (Err(why), Ok(_)) => *rows = Err(why),
                                (_, Err(_)) => {}
                            }
                        }
                    }
                });
            }
        });
        let mut rows = rows.into_inner().map_err(|_| "A run failed.")??;
        rows.sort_by_key(|r: &(u64, _)| r.0);
        rows.iter().for_each(|(_, row)| println!("{row}"));
    }
    Ok(())
}

fn run(source: &Source, name: &str, seed: u64, options: &Options) -> Result<serde_json::Value, String> {
    let paper = papers::method(name, &options.parameters);
    let method: &dyn Solver = match (&paper, solve::method(name)) {
        (Ok(paper), _) => paper.as_ref(),
        (Err(_), Some(own)) => own,
        (Err(why), None) => return Err(why.message.clone()),
    };
    let clock = ThreadTime::now();
    let mut search = method.start(&source.problem, seed, None);
    // A tour without an edge the instance fixes, or the drawing's order, has no length: only what stands at the end must.
    let checked = |search: &dyn solve::Search| source.checked(search.best());
    let mut length = checked(search.as_ref());
    let mut found = 0;
    let mut trace = Trace::every(options.trace);
    loop {
        let step = search.step(SLICE);
        if step.improved {
            length = checked(search.as_ref());
            found = search.insight().map_or(0, |i| i.round);
        }
        let known = length.as_ref().is_ok_and(|length| source.known.is_some_and(|k| *length <= k + 1e-6));
        let seconds = clock.elapsed().as_secs_f64();
        let end = step.status == Status::Exhausted || seconds >= options.seconds || known;
        trace.look(search.as_ref(), end);
        if end {
            return Ok(serde_json::json!({
                "instance": source.name, "items": source.problem.items.len(), "known": source.known, "method": name,
                "seed": seed, "length": length.as_ref().ok(), "fault": length.as_ref().err(), "found": found, "rounds": search.insight().map_or(0, |i| i.round),
                "seconds": seconds, "moves": search.telemetry().moves, "air_seconds": source.air_seconds(search.best()),
                "cut_seconds": source.cut_seconds, "insight": search.insight(), "trace": trace.json(),
            }));
        }
    }
}
