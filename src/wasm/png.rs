//! The PNG renderer for JavaScript, in a wasm file of its own.

use crate::output::png;
use wasm_bindgen::prelude::*;

/// Renders the plan in `plan_json` (`kerfway.plan/1`) as a PNG file that is `width` px wide (64 to 8192).
#[wasm_bindgen(js_name = renderPng)]
pub fn render_png(plan_json: &str, width: u32) -> Result<Vec<u8>, JsError> {
    png::render(plan_json, width).map_err(|e| JsError::new(&e))
}
