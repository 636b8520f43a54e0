//! What `npm run bench -- solve` runs: the search on instances of every kind, natively and in wasm alike.

pub mod source;

use kerfway::solve::{self, Search, Status};
use source::Source;
use std::process::ExitCode;
use wasm_bindgen::prelude::*;

/// How a bench ends: what went wrong is said.
pub fn ended(bench: Result<(), String>) -> ExitCode {
    bench.map_or_else(
        |why| {
            eprintln!("{why}");
            ExitCode::FAILURE
        },
        |()| ExitCode::SUCCESS,
    )
}

/// One search, for a caller with a clock.
#[wasm_bindgen]
pub struct Runner {
    source: &'static Source,
    search: Box<dyn Search>,
}

#[wasm_bindgen]
impl Runner {
    /// Starts on the source of that index in a file. Its memory is never given back: one runner a process.
    pub fn open(file: &str, bytes: Vec<u8>, index: usize, seed: u32) -> Result<Runner, String> {
        let mut sources = Source::of(file, bytes)?;
        if index >= sources.len() {
            return Err(format!("{file} holds {} sources.", sources.len()));
        }
        let source: &'static Source = Box::leak(Box::new(sources.swap_remove(index)));
        let method = solve::method("tour-tree").ok_or("There is no default method.")?;
        Ok(Runner { source, search: method.start(&source.problem, seed.into(), None) })
    }

    /// Works for so many moves: 0 nothing better, 1 something better, 2 at its end.
    pub fn step(&mut self, moves: u32) -> u32 {
        let step = self.search.step(moves.into());
        if step.status == Status::Exhausted { 2 } else { step.improved.into() }
    }

    /// What the best costs, by the search.
    pub fn cost(&self) -> f64 {
        self.search.telemetry().best
    }

    /// The length of the best, checked by code that shares nothing with the search.
    pub fn value(&self) -> Result<f64, String> {
        self.source.checked(self.search.best())
    }
}
