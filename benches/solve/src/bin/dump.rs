//! Dump.
#[path = "../source.rs"]
#[allow(dead_code, reason = "x")]
mod source;
use source::Source;
fn main() {
    let file = std::env::args().nth(1).unwrap();
    let step: f64 = std::env::args().nth(2).unwrap().parse().unwrap();
    let sources = Source::read(&file).unwrap();
    let p = &sources[0].problem;
    let mut items = Vec::new();
    for it in &p.items {
        let nodes = &p.nodes[it.nodes.start as usize..it.nodes.end as usize];
        if let Some(path) = &it.track {
            let len: f64 = path.segments.iter().map(|s| s.length()).sum();
            let n = (len / step).ceil().max(4.0) as usize;
            let mut along: Vec<f64> = (0..n).map(|i| len * i as f64 / n as f64).collect();
            along.extend(nodes.iter().map(|n| n.along));
            along.sort_by(f64::total_cmp); along.dedup();
            items.push(serde_json::json!({"closed": true, "pts": along.iter().filter_map(|&s| path.at(s)).map(|q| [q.x, q.y]).collect::<Vec<_>>()}));
        } else {
            items.push(serde_json::json!({"closed": false, "pts": nodes.iter().filter(|n| true || n.entry.x > 0.0).flat_map(|n| [[n.entry.x, n.entry.y], [n.exit.x, n.exit.y]]).collect::<Vec<_>>()}));
        }
    }
    println!("{}", serde_json::json!({"home": [p.home.x, p.home.y], "closed": p.closed, "items": items, "known": sources[0].known}));
}
