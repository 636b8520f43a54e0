#![allow(missing_docs, clippy::all, clippy::pedantic, clippy::unwrap_used, clippy::print_stdout, clippy::disallowed_methods, clippy::indexing_slicing)]
use kerfway::{problem, plan::LowerBound, geometry::DVec2};
use kerfway::problem::{Problem, Item, Node};
fn main() {
    let a: Vec<String> = std::env::args().collect();
    let closed = a[2] == "closed";
    let mut m = kerfway::machine::preset(&a[3]).unwrap();
    m.return_home = closed;
    let p = if a[1].ends_with(".json") {
        let v: serde_json::Value = serde_json::from_slice(&std::fs::read(&a[1]).unwrap()).unwrap();
        let boundary = a.get(4).is_some_and(|x| x == "boundary");
        let mut items = vec![]; let mut nodes: Vec<Node> = vec![];
        for c in v["contours"].as_array().unwrap() {
            let f = nodes.len() as u32;
            for pt in c["points"].as_array().unwrap() {
                if boundary && !pt["on_boundary"].as_bool().unwrap() { continue; }
                let e = DVec2::new(pt["x"].as_f64().unwrap(), pt["y"].as_f64().unwrap());
                let id = nodes.len() as u32;
                nodes.push(Node { item: items.len() as u32, entry: e, exit: e, along: 0.0, reversed: false, twin: id });
            }
            items.push(Item { nodes: f..nodes.len() as u32, before: if boundary { parent(&v, c) } else { None }, rank: 0, fixed: 0.0, track: None });
        }
        Problem { items, nodes, home: DVec2::ZERO, closed, machine: m }
    } else {
        let o: kerfway::job::LoadOptions = serde_json::from_str(r#"{"layers":[{"name":"SHEET","operation":"ignore"},{"name":"MARK","operation":"ignore"}]}"#).unwrap();
        let j = kerfway::job::Job::load(std::fs::read(&a[1]).unwrap(), "x", &o).unwrap();
        let s = j.sheet().clone();
        problem::from_sheet(&s, &m)
    };
    let t0 = std::time::Instant::now();
    let ub: f64 = std::env::var("UB").unwrap().parse().unwrap();
    let secs: f64 = std::env::var("SECS").unwrap().parse().unwrap();
    let mut b = LowerBound::new(&p);
    let mut next = 0.0; let mut more = true; let mut slices = 0; let mut longest: f64 = 0.0;
    while more {
        let s0 = t0.elapsed().as_secs_f64();
        more = b.improve(20_000_000, ub); slices += 1;
        let t = t0.elapsed().as_secs_f64();
        longest = longest.max(t - s0);
        if t > next || !more { println!("{t:.2}s slices {slices} longest {longest:.3} value {:.6} gap {:.4}% {}", b.value(), 100.0 * (ub / b.value() - 1.0), b.state()); next = t + secs / 12.0; }
        if t > secs { break; }
    }
}

fn parent(v: &serde_json::Value, c: &serde_json::Value) -> Option<u32> {
    let p = &c["parent"];
    if p.is_null() { return None; }
    v["contours"].as_array().unwrap().iter().position(|o| o["n"] == *p || o["id"] == *p).map(|x| x as u32)
}
