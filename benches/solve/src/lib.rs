//! The search on instances of every kind, natively and in wasm, for `npm run bench -- solve`.

pub mod source;
pub mod trace;

use kerfway::solve::{self, Search, Status};
use source::Source;
use std::process::ExitCode;
use wasm_bindgen::prelude::*;

/// Prints the reason if a bench failed, and returns the exit code.
pub fn ended(bench: Result<(), String>) -> ExitCode {
    bench.map_or_else(
        |why| {
            eprintln!("{why}");
            ExitCode::FAILURE
        },
        |()| ExitCode::SUCCESS,
    )
}

/// One search. The caller has the clock.
#[wasm_bindgen]
pub struct Runner {
    source: &'static Source,
    search: Box<dyn Search>,
}

#[wasm_bindgen]
impl Runner {
    /// Starts on the source with this index in a file. The memory is never freed, so a process should have one runner.
    pub fn open(file: &str, bytes: Vec<u8>, index: usize, seed: u32) -> Result<Runner, String> {
        let mut sources = Source::of(file, bytes)?;
        if index >= sources.len() {
            return Err(format!("{file} holds {} sources.", sources.len()));
        }
        let source: &'static Source = Box::leak(Box::new(sources.swap_remove(index)));
        let method = solve::method("tour-tree").ok_or("There is no default method.")?;
        Ok(Runner { source, search: method.start(&source.problem, seed.into(), None) })
    }

    /// Searches for `moves` moves. Returns 0 if nothing better was found, 1 if something was, and 2 at the end of the search.
    pub fn step(&mut self, moves: u32) -> u32 {
        let step = self.search.step(moves.into());
        if step.status == Status::Exhausted { 2 } else { step.improved.into() }
    }

    /// Cost of the best solution, as the search counts it.
    pub fn cost(&self) -> f64 {
        self.search.telemetry().best
    }

    /// Length of the best solution, checked by code that shares nothing with the search.
    pub fn value(&self) -> Result<f64, String> {
        self.source.checked(self.search.best())
    }
}
