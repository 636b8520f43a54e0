//! Arrays that cross the boundary: lists of numbers become typed arrays with their own memory, which the receiver may transfer.

use super::failure::Failure;
use super::values::value;
use crate::fields::{Fault, FieldError};
use crate::job::{BestPath, Geometry, JobError, WarmPath};
use js_sys::{Float64Array, Object, Reflect, Uint8Array, Uint32Array};
use wasm_bindgen::JsCast;
use wasm_bindgen::prelude::*;

/// Reads the bytes of a file.
pub(super) fn bytes(given: &JsValue) -> Result<Vec<u8>, Failure> {
    let says = || format!("The file is {}. Give its bytes (Uint8Array).", value(given, 1));
    let bytes = given.dyn_ref::<Uint8Array>().map(Uint8Array::to_vec);
    Ok(bytes.ok_or_else(|| FieldError::new(Fault::WrongType, "file", says()))?)
}

/// An object with these fields.
pub(super) fn object(fields: &[(&str, JsValue)]) -> Result<JsValue, JsError> {
    let object = Object::new();
    for (name, value) in fields {
        Reflect::set(&object, &JsValue::from_str(name), value)
            .map_err(|_| JsError::new("The report could not be passed on."))?;
    }
    Ok(object.into())
}

/// Paths as typed arrays.
pub(super) fn geometry(g: &Geometry) -> Result<JsValue, JsError> {
    object(&[
        ("segments", Float64Array::from(g.segments.as_slice()).into()),
        ("offsets", Uint32Array::from(g.offsets.as_slice()).into()),
    ])
}

/// What a search needs of a path to start from it, as typed arrays.
#[cfg(feature = "research")]
pub(super) fn warm_path(p: &WarmPath) -> Result<JsValue, JsError> {
    object(&[
        ("contours", Uint32Array::from(p.contours.as_slice()).into()),
        ("along", Float64Array::from(p.along.as_slice()).into()),
        ("until", Float64Array::from(p.until.as_slice()).into()),
        ("reversed", Uint8Array::from(p.reversed.as_slice()).into()),
    ])
}

/// The path of the head as typed arrays.
pub(super) fn path(p: &BestPath) -> Result<JsValue, JsError> {
    object(&[
        ("contours", Uint32Array::from(p.contours.as_slice()).into()),
        ("points", Float64Array::from(p.points.as_slice()).into()),
        ("along", Float64Array::from(p.along.as_slice()).into()),
        ("until", Float64Array::from(p.until.as_slice()).into()),
        ("reversed", Uint8Array::from(p.reversed.as_slice()).into()),
        ("times", Float64Array::from(p.times.as_slice()).into()),
        ("leads", Float64Array::from(p.leads.segments.as_slice()).into()),
        ("leadOffsets", Uint32Array::from(p.leads.offsets.as_slice()).into()),
        ("joints", Float64Array::from(p.joints.segments.as_slice()).into()),
        ("jointOffsets", Uint32Array::from(p.joints.offsets.as_slice()).into()),
        ("loops", Float64Array::from(p.loops.segments.as_slice()).into()),
        ("loopOffsets", Uint32Array::from(p.loops.offsets.as_slice()).into()),
        ("preCuts", Float64Array::from(p.pre_cuts.as_slice()).into()),
        ("pauses", Float64Array::from(p.pauses.as_slice()).into()),
        ("ways", Uint8Array::from(p.ways.as_slice()).into()),
        ("via", Float64Array::from(p.via.as_slice()).into()),
        ("viaOf", Uint32Array::from(p.via_of.as_slice()).into()),
        ("tips", Uint32Array::from(p.tips.as_slice()).into()),
        ("freedBy", Uint32Array::from(p.freed_by.as_slice()).into()),
        ("waits", Float64Array::from(p.waits.as_slice()).into()),
    ])
}

/// Reads a path that another search hands over. Typed arrays take a millisecond for 10,000 contours, a thirtieth of the
/// time of single numbers.
pub(super) fn handed(value: &JsValue) -> Result<WarmPath, Failure> {
    let field = |name: &str| Reflect::get(value, &JsValue::from_str(name)).unwrap_or_default();
    let numbers = |name: &str| field(name).dyn_into::<Float64Array>().map(|a| a.to_vec());
    let contours = field("contours").dyn_into::<Uint32Array>().map(|a| a.to_vec());
    let reversed = field("reversed").dyn_into::<Uint8Array>().map(|a| a.to_vec());
    match (contours, numbers("along"), reversed) {
        (Ok(contours), Ok(along), Ok(reversed)) => {
            Ok(WarmPath { contours, along, until: numbers("until").unwrap_or_default(), reversed })
        }
        _ => Err(JobError::UnfitPath.into()),
    }
}
