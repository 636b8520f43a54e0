//! Tables 3 and 4 of the hull-part paper, natively: every method on a sheet of `tests/fixtures/hull`. One JSON line a run.
//!
//!     hull NAME SHEET SEEDS [METHOD]...
//!
//! METHOD is a name, or `{"method": NAME, "parameters": {...}, "trace": ROUNDS}`. Seconds are those of the processor.

use cpu_time::ThreadTime;
use kerfway::geometry::DVec2;
use kerfway::machine;
use kerfway::problem::{Item, Node, Problem};
use kerfway::solve::{self, Search, Solver, Status, papers};
use kerfway_bench_solve::trace::Trace;
use serde_json::{Value, json};

/// Moves between two looks at the clock.
const SLICE: u64 = 100_000;
/// Moves of the default method, which knows no end.
const MOVES: u64 = 8_000_000;

fn main() -> std::process::ExitCode {
    kerfway_bench_solve::ended(bench())
}

fn bench() -> Result<(), String> {
    let args: Vec<String> = std::env::args().skip(1).collect();
    let [name, sheet, seeds, methods @ ..] = &args[..] else {
        return Err("hull NAME SHEET SEEDS [METHOD]...".into());
    };
    let file = format!("{}/../../tests/fixtures/hull/{name}.json", env!("CARGO_MANIFEST_DIR"));
    let text = std::fs::read_to_string(&file).map_err(|_| format!("{file} cannot be read."))?;
    let sheets: Vec<Value> = serde_json::from_str(&text).map_err(|e| e.to_string())?;
    let index: usize = sheet.parse().map_err(|_| "Which sheet?")?;
    let sheet = sheets.get(index).ok_or("There is no such sheet.")?;
    let problem = problem(sheet).ok_or("The sheet is not as expected.")?;
    let seeds: u64 = seeds.parse().map_err(|_| "How many seeds?")?;
    // The paper's populations.
    let population = if name == "hull-5-20" { 100 } else { 200 };
    for given in methods {
        let one: Value = serde_json::from_str(given).unwrap_or_else(|_| json!({ "method": given }));
        let method = one["method"].as_str().ok_or("Which method?")?;
        let mut parameters = json!({ "population": population });
        if let (Some(all), Some(own)) = (parameters.as_object_mut(), one["parameters"].as_object()) {
            all.extend(own.clone());
        }
        let faithful = solve::method(method).is_none();
        let solver: Box<dyn Solver> = match solve::method(method) {
            Some(_) => Box::new(Default(method.to_owned())),
            None => papers::method(method, &parameters.to_string()).map_err(|e| e.message)?,
        };
        for seed in 1..=seeds {
            let clock = ThreadTime::now();
            let mut search = solver.start(&problem, seed, None);
            let mut moves = 0;
            let mut trace = Trace::every(one["trace"].as_u64().unwrap_or(0));
            while faithful || moves < MOVES {
                let step = search.step(SLICE);
                moves += step.done;
                trace.look(search.as_ref(), step.status == Status::Exhausted);
                if step.status == Status::Exhausted {
                    break;
                }
            }
            // The paper's value is that of the code; the plan is read from it.
            let length = search.insight().and_then(|i| i.curves.first().map(|c| c.value));
            let cost = search.best().cost;
            println!(
                "{}",
                json!({
                    "method": method, "seed": seed, "length": length.unwrap_or(cost), "plan": cost,
                    "optimum": sheet["optimum"], "moves": moves, "seconds": clock.elapsed().as_secs_f64(),
                    "found": search.telemetry().best_at, "insight": search.insight(), "trace": trace.json(),
                })
            );
        }
    }
    Ok(())
}

/// A method by its name.
struct Default(String);

impl Solver for Default {
    fn info(&self) -> solve::SolverInfo {
        self.method().info()
    }

    fn start<'p>(
        &self,
        problem: &'p Problem,
        seed: u64,
        warm: Option<&solve::Solution>,
    ) -> Box<dyn Search + 'p> {
        self.method().start(problem, seed, warm)
    }
}

impl Default {
    fn method(&self) -> &'static dyn Solver {
        solve::method(&self.0).unwrap_or(solve::methods()[0])
    }
}

/// Contours entered and left at their corners, free of charge; millimetres are seconds.
fn problem(sheet: &Value) -> Option<Problem> {
    let point = |v: &Value| Some(DVec2::new(v[0].as_f64()?, v[1].as_f64()?));
    let (mut items, mut nodes): (Vec<Item>, Vec<Node>) = (Vec::new(), Vec::new());
    for (contour, item) in sheet["contours"].as_array()?.iter().zip(0..) {
        let first = u32::try_from(nodes.len()).ok()?;
        let corners = contour.as_array()?.iter().map(point).collect::<Option<Vec<DVec2>>>()?;
        let mut along = 0.0;
        for (&entry, next) in corners.iter().zip(corners.iter().cycle().skip(1)) {
            let twin = u32::try_from(nodes.len()).ok()?;
            nodes.push(Node { item, entry, exit: entry, along, reversed: false, twin });
            along += entry.distance(*next);
        }
        let nodes = first..u32::try_from(nodes.len()).ok()?;
        items.push(Item { nodes, leave: Some(0.0), ..Item::default() });
    }
    let machine = machine::preset("length-partial")?;
    let home = point(&sheet["origin"])?;
    Some(Problem { items, nodes, home, closed: true, ..Problem::empty(machine) })
}
