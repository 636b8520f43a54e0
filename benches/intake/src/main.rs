//! Native figures for one file, as one line of JSON: milliseconds of every run of every stage.

use kerfway_bench_intake::{Read, read_dxf_crate, read_kerfway};
use std::time::Instant;

fn runs(count: usize, mut stage: impl FnMut() -> usize) -> String {
    let times: Vec<String> = (0..count)
        .map(|_| {
            let start = Instant::now();
            assert!(stage() > 0, "nothing was read");
            format!("{:.2}", start.elapsed().as_secs_f64() * 1e3)
        })
        .collect();
    format!("[{}]", times.join(","))
}

fn main() {
    let mut args = std::env::args().skip(1);
    let (Some(file), Some(count)) = (args.next(), args.next().and_then(|c| c.parse().ok())) else {
        eprintln!("usage: kerfway-bench-intake FILE.dxf RUNS");
        std::process::exit(2);
    };
    let bytes = match std::fs::read(&file) {
        Ok(bytes) => bytes,
        Err(error) => {
            eprintln!("{file} cannot be read: {error}");
            std::process::exit(1);
        }
    };
    let ours = runs(count, || read_kerfway(&bytes));
    let theirs = runs(count, || read_dxf_crate(&bytes));
    let assembled = Read::open(&bytes).map_or_else(|| "[]".into(), |read| runs(count, || read.assemble()));
    println!("{{\"kerfway\":{ours},\"dxf\":{theirs},\"assemble\":{assembled}}}");
}
