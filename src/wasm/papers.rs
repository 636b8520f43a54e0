//! The methods of papers for JavaScript, in a wasm file of their own: it is loaded when one is chosen.

use super::plain::{object, plain};
use crate::job;
use crate::solve::Status;
use crate::solve::papers;
use js_sys::{Float64Array, Uint8Array, Uint32Array};
use wasm_bindgen::prelude::*;

#[wasm_bindgen(typescript_custom_section)]
const TYPES: &str = "import type { GuestStep, Insight, PaperMethod, WarmPath } from '../protocol.js';";

/// The methods there are, with their parameters.
#[wasm_bindgen(js_name = paperMethods, unchecked_return_type = "PaperMethod[]")]
pub fn paper_methods() -> Result<JsValue, JsError> {
    plain(&papers::cards())
}

/// A method at work on a problem that a planner handed over.
#[wasm_bindgen]
pub struct Guest(job::Guest);

#[wasm_bindgen]
impl Guest {
    /// From the numbers of `Job.packed`; `parameters` is a JSON object with those that differ from the defaults.
    #[wasm_bindgen(constructor)]
    pub fn new(numbers: &[f64], name: &str, parameters: &str, seed: f64) -> Result<Guest, JsError> {
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "a seed is a whole number"
        )]
        Ok(Guest(job::Guest::start(numbers, name, parameters, seed as u64)?))
    }

    /// Works for at most `work` moves.
    #[wasm_bindgen(unchecked_return_type = "GuestStep")]
    pub fn step(&mut self, work: u32) -> Result<JsValue, JsError> {
        let step = self.0.step(work.into());
        plain(&GuestStep {
            done: step.done,
            improved: step.improved,
            exhausted: step.status == Status::Exhausted,
        })
    }

    /// Its best path.
    #[wasm_bindgen(unchecked_return_type = "WarmPath")]
    pub fn best(&self) -> Result<JsValue, JsError> {
        let best = self.0.best();
        object(&[
            ("contours", Uint32Array::from(best.contours.as_slice()).into()),
            ("along", Float64Array::from(best.along.as_slice()).into()),
            ("until", Float64Array::from(best.until.as_slice()).into()),
            ("reversed", Uint8Array::from(best.reversed.as_slice()).into()),
        ])
    }

    /// What makes it special, as it stands now.
    #[wasm_bindgen(unchecked_return_type = "Insight")]
    pub fn insight(&self) -> Result<JsValue, JsError> {
        plain(&self.0.insight())
    }
}

#[derive(serde::Serialize)]
struct GuestStep {
    done: u64,
    improved: bool,
    exhausted: bool,
}
