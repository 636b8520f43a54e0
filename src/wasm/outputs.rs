//! The writers of programs and drawings for JavaScript. They are a wasm file of their own, because nobody needs them before
//! there is a plan. They get checked values from the planner, as text, and check none themselves.

use super::failure::Failure;
use super::plain::plain;
use crate::fields;
use crate::job::ErrorReport;
use crate::machine::Profile;
use crate::output::{self, OutputKind, WorkOrder, Written};
use js_sys::Uint8Array;
use wasm_bindgen::prelude::*;

#[wasm_bindgen(typescript_custom_section)]
const TYPES: &str = "import type { ProgramCheck } from '../protocol.js';";

/// Writes a work order of the planner in a format.
#[wasm_bindgen(js_name = writeOutput, unchecked_return_type = "string | Uint8Array<ArrayBuffer>")]
pub fn write_output(order: &str, kind: &str) -> Result<JsValue, Failure> {
    let kind: OutputKind = kind.parse().map_err(JsError::from)?;
    Ok(match read(order)?.write(kind).map_err(ErrorReport::from)? {
        Written::Text(text) => text.into(),
        Written::Bytes(bytes) => Uint8Array::from(bytes.as_slice()).into(),
    })
}

/// What the check says of the G-code of a work order.
#[wasm_bindgen(unchecked_return_type = "ProgramCheck")]
pub fn preflight(order: &str) -> Result<JsValue, Failure> {
    Ok(plain(&read(order)?.preflight().map_err(ErrorReport::from)?)?)
}

/// Checks a program by the rules of a machine's dialect; `machine` is the profile as the planner reads it.
#[wasm_bindgen(js_name = checkProgram, unchecked_return_type = "ProgramCheck")]
pub fn check_program(program: &str, machine: &str) -> Result<JsValue, Failure> {
    let machine: Profile = fields::from_checked_json(machine).map_err(|e| JsError::new(&e))?;
    Ok(plain(&output::check(program, &machine).map_err(|e| JsError::new(&e))?)?)
}

fn read(order: &str) -> Result<WorkOrder, JsError> {
    WorkOrder::read(order).map_err(|e| JsError::new(&e))
}
