//! What works on plans that are already written, for JavaScript: the PNG renderer and the calibration of a machine. Both read
//! plan documents, which the planner itself never does, so they are in a wasm file of their own.

use crate::calibration::{self, Measured};
use crate::fields;
use crate::machine::Profile;
use crate::output::png;
use crate::plan::document::Document;
use wasm_bindgen::prelude::*;

/// Renders the plan in `plan_json` (`kerfway.plan/1`) as a PNG file that is `width` px wide (64 to 8192).
#[wasm_bindgen(js_name = renderPng)]
pub fn render_png(plan_json: &str, width: u32) -> Result<Vec<u8>, JsError> {
    png::render(plan_json, width).map_err(|e| JsError::new(&e))
}

/// Fits a machine to the seconds that jobs took. `machine` is its profile, `plans` are the documents of the jobs, `seconds`
/// their times; the result is a `Calibration`. All are JSON.
#[wasm_bindgen]
#[allow(clippy::needless_pass_by_value, reason = "lists of texts come by value")]
pub fn calibrate(machine: &str, plans: Vec<String>, seconds: &[f64]) -> Result<String, JsError> {
    fitted(machine, &plans, seconds).map_err(|e| JsError::new(&e))
}

fn fitted(machine: &str, plans: &[String], seconds: &[f64]) -> Result<String, String> {
    let machine: Profile = fields::from_json(machine).map_err(|e| e.to_string())?;
    machine.validate().map_err(|e| e.to_string())?;
    let measured = plans
        .iter()
        .zip(seconds)
        .map(|(plan, seconds)| Ok(Measured { plan: Document::read(plan)?, seconds: *seconds }));
    let calibration = calibration::calibrate(&machine, &measured.collect::<Result<Vec<_>, String>>()?)?;
    serde_json::to_string(&calibration).map_err(|e| format!("The calibration cannot be written: {e}."))
}
