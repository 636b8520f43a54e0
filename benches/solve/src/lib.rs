//! The search and the lower bounds on instances of every kind, natively and in wasm, for `npm run bench -- solve`.

pub mod source;
pub mod trace;

use kerfway::plan::{Certified, FlowBound, LowerBound};
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

/// The lower bounds of one instance: by walks, and by flows. The caller has the clock.
#[wasm_bindgen]
pub struct Bounds {
    source: Source,
    known: f64,
    walks: LowerBound,
    flows: Option<Box<FlowBound>>,
}

#[wasm_bindgen]
impl Bounds {
    /// Starts on the only instance in a file, whose best known value sets the length of steps.
    pub fn open(file: &str, bytes: Vec<u8>, known: f64) -> Result<Bounds, String> {
        let source = Source::of(file, bytes)?.pop().ok_or_else(|| format!("{file} holds no instance."))?;
        let walks = LowerBound::new(&source.problem);
        Ok(Bounds { source, known, walks, flows: None })
    }

    /// Looks at about `work` more numbers of the walks. Returns whether more work may help.
    #[wasm_bindgen(js_name = improveWalks)]
    pub fn improve_walks(&mut self, work: u32) -> bool {
        self.walks.improve(work, self.known)
    }

    /// No tour is shorter, by the walks.
    pub fn walks(&self) -> f64 {
        self.walks.value()
    }

    /// Starts the flows. Returns whether they apply to the instance.
    #[wasm_bindgen(js_name = startFlows)]
    pub fn start_flows(&mut self) -> bool {
        self.flows = FlowBound::new(&self.source.problem).map(Box::new);
        self.flows.is_some()
    }

    /// Looks at about `work` more numbers of the flows. Returns whether more work may help.
    #[wasm_bindgen(js_name = improveFlows)]
    pub fn improve_flows(&mut self, work: u32) -> bool {
        self.flows.as_mut().is_some_and(|flows| flows.improve(work))
    }

    /// No tour is shorter, by the flows: the value that the check of their certificate gives, in exact arithmetic.
    pub fn certified(&self) -> Result<Option<f64>, String> {
        let certificate = self.flows.as_ref().and_then(|flows| flows.certificate());
        certificate.map(|c| c.check(&self.source.problem)).transpose().map_err(|fault| fault.to_string())
    }
}
