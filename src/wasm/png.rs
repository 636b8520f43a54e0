//! What works on plans that are already written, for JavaScript: the PNG renderer and the calibration of a machine. Both read
//! plan documents, which the planner itself never does, so they are in a wasm file of their own.

use crate::calibration::{self, Measured};
use crate::fields;
use crate::machine::Profile;
use crate::output::png;
use crate::plan::document::Document;
use js_sys::RangeError;
use wasm_bindgen::prelude::*;

/// Renders the plan in `plan_json` (`kerfway.plan/1`) as a PNG file that is `width` px wide (64 to 8192).
#[wasm_bindgen(js_name = renderPng)]
pub fn render_png(plan_json: &str, width: u32) -> Result<Vec<u8>, JsError> {
    png::render(plan_json, width).map_err(|e| JsError::new(&e))
}

/// Fits a machine to the seconds that jobs took. `machine` is its profile, `plans` are the documents of the jobs, `seconds`
/// their times; the result is a `Calibration`. All are JSON. Times that no machine near to this one takes are a `RangeError`.
#[wasm_bindgen]
#[allow(clippy::needless_pass_by_value, reason = "lists of texts come by value")]
pub fn calibrate(machine: &str, plans: Vec<String>, seconds: &[f64]) -> Result<String, JsValue> {
    let (machine, measured) = read(machine, &plans, seconds).map_err(|e| JsError::new(&e))?;
    let calibration = calibration::calibrate(&machine, &measured).map_err(|e| RangeError::new(&e))?;
    Ok(serde_json::to_string(&calibration)
        .map_err(|e| JsError::new(&format!("The calibration cannot be written: {e}.")))?)
}

fn read(machine: &str, plans: &[String], seconds: &[f64]) -> Result<(Profile, Vec<Measured>), String> {
    let machine: Profile = fields::from_json(machine).map_err(|e| e.to_string())?;
    machine.validate().map_err(|e| e.to_string())?;
    let measured = plans
        .iter()
        .zip(seconds)
        .map(|(plan, seconds)| Ok(Measured { plan: Document::read(plan)?, seconds: *seconds }));
    Ok((machine, measured.collect::<Result<_, String>>()?))
}
