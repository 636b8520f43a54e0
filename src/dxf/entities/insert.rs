//! INSERT, with its array.

use crate::dxf::entity::{Form, Insert};
use crate::dxf::record::Record;
use glam::{DVec2, DVec3};

pub(super) fn insert<'a>(record: &Record<'a>) -> Form<'a> {
    let place = record.point(10);
    let Some(name) = record.text(2) else { return Form::Invalid("it names no block", place) };
    let scale = |code| record.real(code).filter(|s| s.abs() > 0.0).unwrap_or(1.0);
    let count = |code| record.int(code).and_then(|n| u32::try_from(n).ok()).unwrap_or(1).max(1);
    Form::Insert(Box::new(Insert {
        name,
        // Blocks may follow their inserts: found when all is read.
        block: None,
        at: place.unwrap_or(DVec3::ZERO),
        scale: DVec3::new(scale(41), scale(42), scale(43)),
        rotation: record.real(50).unwrap_or(0.0),
        counts: [count(70), count(71)],
        spacing: DVec2::new(record.real(44).unwrap_or(0.0), record.real(45).unwrap_or(0.0)),
        normal: record.normal,
    }))
}
