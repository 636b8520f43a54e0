//! The lower bound on benchmark instances and sheets, natively: `kerfway-bench-bound FILE... [--seconds S] [--upper U] [--open]`.
//! JSON lines: one whenever the clock has doubled, and one at the end. The known best value, or `--upper`, sets the
//! length of its steps, as the search's best does in a plan. `--shares`: the bound by shares, whose certificate is checked again
//! at the end. `--open`: the path does not return home. Seconds are those of the processor.

#[path = "../source.rs"]
#[allow(dead_code, reason = "the search's driver uses more of it")]
mod source;

use cpu_time::ThreadTime;
use kerfway::plan::{LowerBound, ShareBound};
use source::Source;

/// Work between two looks at the clock: a few milliseconds.
const SLICE: u32 = 2_000_000;
/// The first line, s.
const FIRST_LINE: f64 = 0.25;

fn main() {
    let mut files = Vec::new();
    let (mut seconds, mut upper, mut shares, mut open) = (10.0, None, false, false);
    let mut args = std::env::args().skip(1);
    while let Some(word) = args.next() {
        let number = |next: Option<String>| next.and_then(|n| n.parse::<f64>().ok());
        match word.as_str() {
            "--seconds" => seconds = number(args.next()).unwrap_or(seconds),
            "--shares" => shares = true,
            "--open" => open = true,
            "--upper" => upper = number(args.next()),
            _ => files.push(word),
        }
    }
    for file in files {
        match Source::read(&file) {
            Ok(mut sources) => {
                for source in &mut sources {
                    if open {
                        (source.problem.closed, source.problem.machine.return_home) = (false, false);
                    }
                    bound(source, seconds, upper, shares);
                }
            }
            Err(why) => {
                eprintln!("{why}");
                std::process::exit(1);
            }
        }
    }
}

/// One of the two bounds.
enum Kind {
    Search(LowerBound),
    Shares(Box<ShareBound>),
}

impl Kind {
    fn improve(&mut self, upper: f64) -> bool {
        match self {
            Self::Search(bound) => bound.improve(SLICE, upper),
            Self::Shares(bound) => bound.improve(SLICE),
        }
    }

    fn value(&self) -> f64 {
        match self {
            Self::Search(bound) => bound.value(),
            Self::Shares(bound) => bound.value(),
        }
    }
}

fn bound(source: &Source, seconds: f64, upper: Option<f64>, shares: bool) {
    let Some(upper) = upper.or(source.known) else {
        eprintln!("{}: no value is known; give one by --upper.", source.name);
        return;
    };
    let clock = ThreadTime::now();
    let mut bound = match shares.then(|| ShareBound::new(&source.problem)) {
        None => Kind::Search(LowerBound::new(&source.problem)),
        Some(Some(bound)) => Kind::Shares(Box::new(bound)),
        Some(None) => return eprintln!("{}: the bound by shares does not apply.", source.name),
    };
    let (mut next, mut longest, mut slices) = (FIRST_LINE, 0.0_f64, 0_u64);
    loop {
        let before = clock.elapsed().as_secs_f64();
        let more = bound.improve(upper);
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
            if let Kind::Shares(bound) = &bound
                && let Some(Err(fault)) = bound.certificate().map(|c| c.check(&source.problem))
            {
                eprintln!("{}: {fault}", source.name);
            }
            return;
        }
    }
}
