//! LINE, CIRCLE, ARC, ELLIPSE.

use crate::dxf::entity::Form;
use crate::dxf::ocs::few_turns;
use crate::dxf::record::Record;
use crate::geometry::math;
use std::f64::consts::TAU;

pub(super) fn line<'a>(record: &Record<'a>) -> Form<'a> {
    match (record.point(10), record.point(11)) {
        (Some(a), Some(b)) => Form::Line(a, b),
        (a, b) => Form::Invalid("one of its ends is missing", a.or(b)),
    }
}

pub(super) fn circle<'a>(record: &Record<'a>) -> Form<'a> {
    let center = record.point(10);
    match (center, record.real(40)) {
        (Some(center), Some(radius)) if radius > 0.0 => {
            Form::Arc { center, radius, start: 0.0, end: None, normal: record.normal }
        }
        (None, _) => Form::Invalid("its centre is missing", None),
        _ => Form::Invalid("its radius is missing or not above 0", center),
    }
}

pub(super) fn arc<'a>(record: &Record<'a>) -> Form<'a> {
    match circle(record) {
        Form::Arc { center, radius, normal, .. } => {
            // Programs leave out an angle of 0, hence also both ends of a full turn.
            let [start, end] =
                [(50, 0.0), (51, 360.0)].map(|(code, or)| record.real(code).map_or(or, few_turns));
            Form::Arc { center, radius, start, end: Some(end), normal }
        }
        invalid => invalid,
    }
}

pub(super) fn ellipse<'a>(record: &Record<'a>) -> Form<'a> {
    let place = record.point(10);
    let (Some(center), Some(major), Some(ratio)) = (place, record.point(11), record.real(40)) else {
        return Form::Invalid("its centre, axis or axis ratio is missing", place);
    };
    let minor = record.normal.normalize_or_zero().cross(major) * ratio;
    if major.length_squared() <= 0.0 || minor.length_squared() <= 0.0 {
        return Form::Invalid("one of its axes has no length", place);
    }
    let start = record.real(41).unwrap_or(0.0);
    let end = record.real(42).unwrap_or(TAU);
    Form::Ellipse { center, major, minor, start: math::wrap_tau(start), sweep: parameter_sweep(start, end) }
}

/// The counter-clockwise way from parameter `start` to `end`, rad; a whole turn when they meet.
pub(super) fn parameter_sweep(start: f64, end: f64) -> f64 {
    // Files hold 2 pi with 6 digits and more: what misses a whole turn by less is one.
    const WHOLE: f64 = 1e-6;
    let sweep = math::wrap_tau(end - start);
    if !(WHOLE..=TAU - WHOLE).contains(&sweep) { TAU } else { sweep }
}
