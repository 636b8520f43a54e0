//! Benchmark instances and lower bounds for JavaScript, in a wasm file of its own: it is loaded when they are wanted.

use crate::job;
use crate::plan::LowerBound;
use crate::problem::Problem;
use wasm_bindgen::prelude::*;

/// The default method on an instance of the TSPLIB family.
#[wasm_bindgen]
pub struct Solving(job::Solving);

#[wasm_bindgen]
impl Solving {
    /// Reads an instance and starts the search.
    #[wasm_bindgen(constructor)]
    pub fn new(bytes: &[u8], seed: f64) -> Result<Solving, JsError> {
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "a seed is a whole number"
        )]
        Ok(Solving(job::Solving::start(bytes, seed as u64)?))
    }

    /// What the file calls the instance.
    pub fn name(&self) -> String {
        self.0.name().to_owned()
    }

    /// Works for at most `work` moves; false when nothing more can be gained.
    pub fn step(&mut self, work: u32) -> bool {
        self.0.step(work.into())
    }

    /// What no tour is shorter than, if that is known.
    #[wasm_bindgen(js_name = lowerBound)]
    pub fn lower_bound(&self) -> Option<f64> {
        self.0.lower_bound()
    }

    /// Moves done so far.
    pub fn moves(&self) -> f64 {
        self.0.moves() as f64
    }

    /// The best tour so far, by the numbers of the file.
    pub fn tour(&self) -> Vec<u32> {
        self.0.tour()
    }

    /// Its length, added up anew, once the tour has passed its check.
    pub fn length(&self) -> Result<f64, JsError> {
        Ok(self.0.length()?)
    }
}

/// The lower bound of a problem that a planner handed over.
#[wasm_bindgen]
pub struct Prover(LowerBound);

#[wasm_bindgen]
impl Prover {
    /// From the numbers of `Job.packed`.
    #[wasm_bindgen(constructor)]
    pub fn new(numbers: &[f64]) -> Result<Prover, JsError> {
        let problem = Problem::unpacked(numbers).ok_or(JsError::new("These numbers are no problem."))?;
        Ok(Prover(LowerBound::new(&problem)))
    }

    /// Works on it; `upper` is the cost of a known solution. Gives what is proven, in seconds.
    pub fn improve(&mut self, work: u32, upper: f64) -> f64 {
        self.0.improve(work, upper);
        self.0.value()
    }
}
