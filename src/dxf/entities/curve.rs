//! LINE, CIRCLE, ARC, ELLIPSE.

use crate::dxf::entity::Geometry;
use crate::dxf::ocs::{axes, without_whole_turns};
use crate::dxf::record::Record;
use crate::geometry::math;
use std::f64::consts::TAU;

pub(super) fn line<'a>(record: &Record<'a>) -> Geometry<'a> {
    match (record.point(10), record.point(11)) {
        (Some(a), Some(b)) => Geometry::Line(a, b),
        (a, b) => Geometry::Invalid("one of its ends is missing", a.or(b)),
    }
}

pub(super) fn circle<'a>(record: &Record<'a>) -> Geometry<'a> {
    let center = record.point(10);
    match (center, record.real(40)) {
        (Some(center), Some(radius)) if radius > 0.0 => {
            Geometry::Arc { center, radius, start: 0.0, end: None, normal: record.normal }
        }
        (None, _) => Geometry::Invalid("its centre is missing", None),
        _ => {
            let place = center.map(|p| axes(record.normal) * p);
            Geometry::Invalid("its radius is missing or not above 0", place)
        }
    }
}

pub(super) fn arc<'a>(record: &Record<'a>) -> Geometry<'a> {
    match circle(record) {
        Geometry::Arc { center, radius, normal, .. } => {
            // Programs omit an angle of 0, and so both ends of a full circle.
            let [start, end] =
                [(50, 0.0), (51, 360.0)].map(|(code, or)| record.real(code).map_or(or, without_whole_turns));
            Geometry::Arc { center, radius, start, end: Some(end), normal }
        }
        invalid => invalid,
    }
}

pub(super) fn ellipse<'a>(record: &Record<'a>) -> Geometry<'a> {
    let place = record.point(10);
    let (Some(center), Some(major), Some(ratio)) = (place, record.point(11), record.real(40)) else {
        return Geometry::Invalid("its centre, axis or axis ratio is missing", place);
    };
    let minor = record.normal.normalize_or_zero().cross(major) * ratio;
    if major.length_squared() <= 0.0 || minor.length_squared() <= 0.0 {
        return Geometry::Invalid("one of its axes has no length", place);
    }
    let start = record.real(41).unwrap_or(0.0);
    let end = record.real(42).unwrap_or(TAU);
    Geometry::Ellipse {
        center,
        major,
        minor,
        start: math::wrap_tau(start),
        sweep: parameter_sweep(start, end),
    }
}

/// The counter-clockwise sweep from parameter `start` to `end`, rad; a full turn when they coincide.
pub(super) fn parameter_sweep(start: f64, end: f64) -> f64 {
    // Files give 2 pi with 6 or more digits, so a smaller difference is a full turn.
    const WHOLE: f64 = 1e-6;
    let sweep = math::wrap_tau(end - start);
    if !(WHOLE..=TAU - WHOLE).contains(&sweep) { TAU } else { sweep }
}
