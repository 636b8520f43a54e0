//! SPLINE, and the SPLINE that a HELIX carries.

use crate::dxf::entity::{Geometry, Spline};
use crate::dxf::record::Record;
use crate::dxf::tag::Tag;
use glam::DVec3;

pub(super) fn spline<'a>(record: &Record<'a>) -> Geometry<'a> {
    // What follows in a HELIX uses the same codes for its axis and radius.
    let own = record.tags.iter().take_while(|t| t.text() != Some(b"AcDbHelix"));
    let spline = gather(own, [11, 21, 31]);
    let place = spline.control.first().or(spline.fit.first()).copied();
    match spline.control.is_empty() && spline.fit.is_empty() {
        true => Geometry::Invalid("it has no points", place),
        false => Geometry::Spline(Box::new(spline)),
    }
}

/// Reads a spline from its tags; `fit_codes` are those of fit points.
fn gather<'t, 'a: 't>(tags: impl Iterator<Item = &'t Tag<'a>>, fit_codes: [i32; 3]) -> Spline {
    let mut spline = Spline { degree: 3, ..Spline::default() };
    let (mut start, mut end) = (None::<DVec3>, None::<DVec3>);
    for tag in tags {
        let Some(value) = tag.real() else { continue };
        match tag.code {
            70 => spline.closed = tag.int().unwrap_or(0) & 0b11 != 0,
            71 => spline.degree = tag.int().and_then(|n| usize::try_from(n).ok()).unwrap_or(0),
            40 => spline.knots.push(value),
            41 => spline.weights.push(value),
            10 => spline.control.push(DVec3::new(value, 0.0, 0.0)),
            20 => set(spline.control.last_mut(), 1, value),
            30 => set(spline.control.last_mut(), 2, value),
            12 => start = Some(DVec3::new(value, 0.0, 0.0)),
            22 => set(start.as_mut(), 1, value),
            32 => set(start.as_mut(), 2, value),
            13 => end = Some(DVec3::new(value, 0.0, 0.0)),
            23 => set(end.as_mut(), 1, value),
            33 => set(end.as_mut(), 2, value),
            code if code == fit_codes[0] => spline.fit.push(DVec3::new(value, 0.0, 0.0)),
            code if code == fit_codes[1] => set(spline.fit.last_mut(), 1, value),
            code if code == fit_codes[2] => set(spline.fit.last_mut(), 2, value),
            _ => {}
        }
    }
    Spline { start_tangent: start, end_tangent: end, ..spline }
}

fn set(point: Option<&mut DVec3>, axis: usize, value: f64) {
    if let Some(p) = point {
        p[axis] = value;
    }
}
