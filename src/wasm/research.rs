//! Published methods and benchmark instances for JavaScript, which only the research build contains.

use super::plain::plain;
use crate::job;
use crate::solve::papers;
use wasm_bindgen::prelude::*;

#[wasm_bindgen(typescript_custom_section)]
const TYPES: &str = "import type { PaperMethod } from '../protocol.js';";

/// The methods of published papers, with their parameters.
#[wasm_bindgen(js_name = paperMethods, unchecked_return_type = "PaperMethod[]")]
pub fn paper_methods() -> Result<JsValue, JsError> {
    plain(&papers::cards())
}

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

    /// The name of the instance, as given in the file.
    pub fn name(&self) -> String {
        self.0.name().to_owned()
    }

    /// Does at most `work` moves. Returns false when nothing can be improved any more.
    pub fn step(&mut self, work: u32) -> bool {
        self.0.step(work.into())
    }

    /// Lower bound of the length of every tour, if there is one.
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

    /// The length of the best tour, computed again after the tour has passed its check.
    pub fn length(&self) -> Result<f64, JsError> {
        Ok(self.0.length()?)
    }
}
