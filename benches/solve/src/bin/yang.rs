//! Yang's example, natively: drawing order with the nearest starts, the genetic algorithm, the default method, on
//! `tests/fixtures/yang`. One JSON line a run, with both lengths of its path: by the longer axis (time) and straight.
//!
//!     yang SEEDS [PARAMETERS]
//!
//! With parameters, a JSON object, only the genetic algorithm runs. Seconds are those of the processor.

use cpu_time::ThreadTime;
use kerfway::geometry::DVec2;
use kerfway::machine;
use kerfway::problem::{Item, Node, Problem};
use kerfway::solve::{self, Search, Status, papers};
use serde_json::{Value, json};

/// Moves between two looks at the end.
const SLICE: u64 = 100_000;
/// Moves of the default method, which knows no end.
const MOVES: u64 = 4_000_000;

fn main() -> std::process::ExitCode {
    kerfway_bench_solve::ended(bench())
}

fn bench() -> Result<(), String> {
    let seeds: u64 = std::env::args().nth(1).and_then(|s| s.parse().ok()).ok_or("yang SEEDS")?;
    let file = concat!(env!("CARGO_MANIFEST_DIR"), "/../../tests/fixtures/yang/yang-27.json");
    let text = std::fs::read_to_string(file).map_err(|_| format!("{file} cannot be read."))?;
    let data: Value = serde_json::from_str(&text).map_err(|e| e.to_string())?;
    let problem = problem(&data).ok_or("The instance is not as expected.")?;
    let drawn: Vec<usize> = (0..problem.items.len()).collect();
    // Every second row the other way.
    let mut turned = drawn.clone();
    turned.chunks_mut(9).skip(1).step_by(2).for_each(<[usize]>::reverse);
    for (name, order) in [("as drawn", drawn), ("rows in turn", turned)] {
        tell(&problem, name, 1, &nearest(&problem, &order), json!({}));
    }
    let parameters = std::env::args().nth(2);
    let ga =
        papers::method("dual-coding-ga", parameters.as_deref().unwrap_or("{}")).map_err(|e| e.message)?;
    for seed in 1..=seeds {
        run(&problem, "dual-coding-ga", seed, ga.start(&problem, seed, None), u64::MAX);
        if parameters.is_some() {
            continue;
        }
        run(&problem, "tour-tree", seed, solve::methods()[0].start(&problem, seed, None), MOVES);
    }
    Ok(())
}

fn run(problem: &Problem, name: &str, seed: u64, mut search: Box<dyn Search + '_>, most: u64) {
    let clock = ThreadTime::now();
    let mut moves = 0;
    while moves < most {
        let step = search.step(SLICE);
        moves += step.done;
        if step.status == Status::Exhausted {
            break;
        }
    }
    let seconds = clock.elapsed().as_secs_f64();
    let nodes: Vec<u32> = search.best().stops.iter().map(|s| s.node).collect();
    let more = json!({ "moves": moves, "seconds": seconds, "found": search.telemetry().best_at });
    tell(problem, name, seed, &nodes, more);
}

fn tell(problem: &Problem, name: &str, seed: u64, nodes: &[u32], more: Value) {
    let place = |&n: &u32| problem.nodes[n as usize].entry;
    let way: Vec<DVec2> = [problem.home].into_iter().chain(nodes.iter().map(place)).collect();
    let sum = |of: fn(DVec2) -> f64| way.windows(2).map(|w| of(w[1] - w[0])).sum::<f64>();
    let (time, length) = (sum(|d| d.abs().max_element()), sum(|d| d.length()));
    println!("{}", json!({ "name": name, "seed": seed, "time": time, "length": length, "run": more }));
}

/// Contours in an order, each from its point nearest to the one before: the existing path of the paper's figure 6.
fn nearest(problem: &Problem, order: &[usize]) -> Vec<u32> {
    let mut here = problem.home;
    let mut nodes = Vec::new();
    for &item in order {
        let away = |n: &u32| problem.nodes[*n as usize].entry.distance(here);
        let next = problem.items[item].nodes.clone().min_by(|a, b| away(a).total_cmp(&away(b)));
        nodes.extend(next);
        here = next.map_or(here, |n| problem.nodes[n as usize].entry);
    }
    nodes
}

/// Contours entered at their feature points; a millimetre of the longer axis takes a second.
fn problem(data: &Value) -> Option<Problem> {
    let point = |v: &Value| Some(DVec2::new(v[0].as_f64()?, v[1].as_f64()?));
    let (mut items, mut nodes): (Vec<Item>, Vec<Node>) = (Vec::new(), Vec::new());
    for (contour, item) in data["contours"].as_array()?.iter().zip(0..) {
        let first = u32::try_from(nodes.len()).ok()?;
        for (p, along) in contour["points"].as_array()?.iter().zip(0..) {
            let (entry, twin) = (point(p)?, u32::try_from(nodes.len()).ok()?);
            nodes.push(Node { item, entry, exit: entry, along: f64::from(along), reversed: false, twin });
        }
        let nodes = first..u32::try_from(nodes.len()).ok()?;
        items.push(Item { nodes, ..Item::default() });
    }
    let machine = machine::preset("length-chebyshev")?;
    let home = point(&data["origin"])?;
    Some(Problem { items, nodes, home, closed: false, ..Problem::empty(machine) })
}
