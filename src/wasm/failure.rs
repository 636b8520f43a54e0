//! Errors as JavaScript gets them: an `Error` with a sentence, and the report for programs as its property `report`.

use super::plain::plain;
use crate::fields::FieldError;
use crate::job::{ErrorReport, JobError};
use js_sys::{Error, Reflect};
use wasm_bindgen::prelude::*;

/// An error on its way to JavaScript.
pub struct Failure(JsValue);

impl From<Failure> for JsValue {
    fn from(failure: Failure) -> Self {
        failure.0
    }
}

impl From<JobError> for Failure {
    fn from(error: JobError) -> Self {
        error.report().into()
    }
}

impl From<ErrorReport> for Failure {
    fn from(report: ErrorReport) -> Self {
        let made = Error::new(&report.message);
        if let Ok(report) = plain(&report) {
            // A new object takes every property.
            let _ = Reflect::set(&made, &JsValue::from_str("report"), &report);
        }
        Self(made.into())
    }
}

impl From<FieldError> for Failure {
    fn from(error: FieldError) -> Self {
        JobError::from(error).into()
    }
}

impl From<JsError> for Failure {
    fn from(error: JsError) -> Self {
        Self(error.into())
    }
}
