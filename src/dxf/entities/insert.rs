//! INSERT, with its array.

use crate::dxf::entity::{Geometry, Insert};
use crate::dxf::ocs;
use crate::dxf::record::Record;
use glam::{DVec2, DVec3};

pub(super) fn insert<'a>(record: &Record<'a>) -> Geometry<'a> {
    let place = record.point(10);
    let Some(name) = record.text(2) else {
        return Geometry::Invalid("it names no block", place.map(|p| ocs::axes(record.normal) * p));
    };
    let scale = |code| record.real(code).filter(|s| s.abs() > 0.0).unwrap_or(1.0);
    let count = |code| record.int(code).and_then(|n| u32::try_from(n).ok()).unwrap_or(1).max(1);
    Geometry::Insert(Box::new(Insert {
        name,
        // A block may be defined after its inserts, so it is looked up at the end of the file.
        block: None,
        at: place.unwrap_or(DVec3::ZERO),
        scale: DVec3::new(scale(41), scale(42), scale(43)),
        rotation: record.real(50).unwrap_or(0.0),
        counts: [count(70), count(71)],
        spacing: DVec2::new(record.real(44).unwrap_or(0.0), record.real(45).unwrap_or(0.0)),
        normal: record.normal,
    }))
}
