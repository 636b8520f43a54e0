//! The lower bound on benchmark instances and sheets, natively: `kerfway-bench-bound FILE... [--seconds S] [--upper U] [--open]`.
//! JSON lines: one whenever the clock has doubled, and one at the end. The known best value, or `--upper`, sets the
//! length of its steps, as the search's best does in a plan. `--flows`: the bound by flows. `--shares`: the bound by shares. `--stops`: the same with the bound by stops, for contours that may be left and pierce groups. `--open`: the path does not
//! return home. `--machine NAME`: that of a drawing, in place of `length`, `--ends`: its closed contours are
//! entered and left only where their elements end. `--search MOVES`: the value known is that of a search of so many
//! moves. Seconds are those of the processor. At the end the certificate of the bound is checked, with a line of what it proves
//! and how long its check takes.

#[path = "../source.rs"]
#[allow(dead_code, reason = "the search's driver uses more of it")]
mod source;

use cpu_time::ThreadTime;
use kerfway::plan::{Certified, FlowBound, LowerBound, ShareBound, StopBound};
use kerfway::solve::{self, Solution};
use source::Source;

/// Work between two looks at the clock: a few milliseconds.
const SLICE: u32 = 2_000_000;
/// The first line, s.
const FIRST_LINE: f64 = 0.25;

fn main() {
    let mut files = Vec::new();
    let (mut seconds, mut upper, mut which, mut open) = (10.0, None, Which::Search, false);
    let (mut machine, mut moves, mut at_ends) = (None, None, false);
    let mut args = std::env::args().skip(1);
    while let Some(word) = args.next() {
        let number = |next: Option<String>| next.and_then(|n| n.parse::<f64>().ok());
        match word.as_str() {
            "--seconds" => seconds = number(args.next()).unwrap_or(seconds),
            "--flows" => which = Which::Flows,
            "--shares" => which = Which::Shares,
            "--stops" => which = Which::Stops,
            "--machine" => machine = args.next(),
            "--ends" => at_ends = true,
            "--search" => moves = args.next().and_then(|n| n.parse::<u64>().ok()),
            "--open" => open = true,
            "--upper" => upper = number(args.next()),
            _ => files.push(word),
        }
    }
    for file in files {
        match Source::read(&file) {
            Ok(mut sources) => {
                for source in &mut sources {
                    // The rules of the paper are no drawing's.
                    if machine.as_ref().is_some_and(|m| source.on(m, at_ends).is_err()) {
                        continue;
                    }
                    if open {
                        (source.problem.closed, source.problem.machine.return_home) = (false, false);
                    }
                    let mut path = None;
                    if let Some(moves) = moves {
                        let mut search = solve::methods()[0].start(&source.problem, 1, None);
                        search.step(moves);
                        let fixed: f64 = source.problem.items.iter().map(|i| i.fixed).sum();
                        source.known = Some(search.best().cost + fixed - source.problem.paid());
                        path = Some(search.best().clone());
                    }
                    bound(source, seconds, upper, which, path.as_ref());
                }
            }
            Err(why) => {
                eprintln!("{why}");
                std::process::exit(1);
            }
        }
    }
}

#[derive(Clone, Copy)]
enum Which {
    Search,
    Shares,
    Flows,
    Stops,
}

/// One of the bounds.
enum Kind {
    Search(LowerBound),
    Shares(Box<ShareBound>),
    Flows(Box<FlowBound>),
    Stops(Box<StopBound>),
}

impl Kind {
    fn improve(&mut self, upper: f64) -> bool {
        match self {
            Self::Search(bound) => bound.improve(SLICE, upper),
            Self::Shares(bound) => bound.improve(SLICE),
            Self::Flows(bound) => bound.improve(SLICE),
            Self::Stops(bound) => bound.improve(SLICE),
        }
    }

    /// The travel of the best path that it knows itself, s.
    fn known(&self) -> f64 {
        if let Self::Search(bound) = self { bound.known() } else { f64::INFINITY }
    }

    fn value(&self) -> f64 {
        match self {
            Self::Search(bound) => bound.value(),
            Self::Shares(bound) => bound.value(),
            Self::Flows(bound) => bound.value(),
            Self::Stops(bound) => bound.value(),
        }
    }
}

fn bound(source: &Source, seconds: f64, upper: Option<f64>, which: Which, path: Option<&Solution>) {
    let Some(upper) = upper.or(source.known) else {
        eprintln!("{}: no value is known; give one by --upper.", source.name);
        return;
    };
    let clock = ThreadTime::now();
    let bound = match which {
        Which::Search => {
            let mut bound = LowerBound::new(&source.problem);
            if let Some(path) = path {
                bound.knows(&source.problem, path);
            }
            Some(Kind::Search(bound))
        }
        Which::Shares => ShareBound::new(&source.problem).map(|b| Kind::Shares(Box::new(b))),
        Which::Flows => FlowBound::new(&source.problem).map(|b| Kind::Flows(Box::new(b))),
        Which::Stops => StopBound::new(&source.problem).map(|b| Kind::Stops(Box::new(b))),
    };
    let Some(mut bound) = bound else { return eprintln!("{}: this bound does not apply.", source.name) };
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
                "instance": source.name, "items": source.problem.items.len(), "known": upper, "best": upper.min(bound.known()), "bound": value,
                "gap_percent": 100.0 * (upper / value - 1.0), "seconds": now, "numbers": slices * u64::from(SLICE), "longest_slice": longest,
                "done": !more,
            });
            println!("{row}");
        }
        if over {
            // A bound by walks is written by its check, so it is checked twice.
            let problem = &source.problem;
            let walks = match &bound {
                Kind::Search(bound) => bound.certificate(problem, 0.0),
                Kind::Shares(_) | Kind::Stops(_) | Kind::Flows(_) => None,
            };
            let before = clock.elapsed().as_secs_f64();
            let checked = match &bound {
                Kind::Search(_) => walks.as_ref().map(|c| c.check(problem)),
                Kind::Flows(bound) => bound.certificate().map(|c| c.check(problem)),
                Kind::Shares(bound) => bound.certificate().map(|c| c.check(problem)),
                Kind::Stops(bound) => bound.certificate().map(|c| c.check(problem)),
            };
            let check_seconds = clock.elapsed().as_secs_f64() - before;
            match checked {
                Some(Ok(certified)) => {
                    println!(
                        "{}",
                        serde_json::json!({ "instance": source.name, "certified": certified, "check_seconds": check_seconds })
                    );
                }
                Some(Err(fault)) => eprintln!("{}: {fault}", source.name),
                None => {}
            }
            return;
        }
    }
}
