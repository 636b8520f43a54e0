//! The lower bound on benchmark instances and sheets, natively: `kerfway-bench-bound FILE... [--seconds S] [--upper U]`.
//! JSON lines: one whenever the clock has doubled, and one at the end. The known best value, or `--upper`, sets the
//! length of its steps, as the search's best does in a plan.

#[path = "../source.rs"]
#[allow(dead_code, reason = "the search's driver uses more of it")]
mod source;

use kerfway::plan::LowerBound;
use source::Source;
use std::time::Instant;

/// Work between two looks at the clock: a few milliseconds.
const SLICE: u32 = 2_000_000;
/// The first line, s.
const FIRST_LINE: f64 = 0.25;

fn main() {
    let mut files = Vec::new();
    let (mut seconds, mut upper) = (10.0, None);
    let mut args = std::env::args().skip(1);
    while let Some(word) = args.next() {
        let number = |next: Option<String>| next.and_then(|n| n.parse::<f64>().ok());
        match word.as_str() {
            "--seconds" => seconds = number(args.next()).unwrap_or(seconds),
            "--upper" => upper = number(args.next()),
            _ => files.push(word),
        }
    }
    for file in files {
        match Source::read(&file) {
            Ok(sources) => sources.iter().for_each(|source| bound(source, seconds, upper)),
            Err(why) => {
                eprintln!("{why}");
                std::process::exit(1);
            }
        }
    }
}

fn bound(source: &Source, seconds: f64, upper: Option<f64>) {
    let Some(upper) = upper.or(source.known) else {
        eprintln!("{}: no value is known; give one by --upper.", source.name);
        return;
    };
    let clock = Instant::now();
    let mut bound = LowerBound::new(&source.problem);
    let (mut next, mut longest, mut slices) = (FIRST_LINE, 0.0_f64, 0_u64);
    loop {
        let before = clock.elapsed().as_secs_f64();
        let more = bound.improve(SLICE, upper);
        slices += 1;
        let now = clock.elapsed().as_secs_f64();
        longest = longest.max(now - before);
        let over = !more || now >= seconds;
        if over || now >= next {
            next = 2.0 * now;
            let value = bound.value();
            let row = serde_json::json!({
                "instance": source.name, "items": source.problem.items.len(), "known": upper, "bound": value,
                "gap_percent": 100.0 * (upper / value - 1.0), "seconds": now, "numbers": slices * u64::from(SLICE), "longest_slice": longest,
                "done": !more,
            });
            println!("{row}");
        }
        if over {
            return;
        }
    }
}
