//! The properties that all entities have.

use super::contents::File;
use crate::dxf::entities::{self, Soundness};
use crate::dxf::entity::{BY_LAYER, Entity, Geometry, Hidden};
use crate::dxf::record::Record;

/// An entity of a kind, with its geometry and the properties of its record.
pub(super) fn with_properties<'a>(
    record: &Record<'a>,
    file: &mut File<'a>,
    kind: &'static str,
    geometry: Geometry<'a>,
) -> Entity<'a> {
    let hidden = match (record.paper, record.invisible) {
        (true, _) => Some(Hidden::Paper),
        (_, true) => Some(Hidden::Invisible),
        _ => None,
    };
    // An entity that is not cut need not be checked.
    let soundness = if kind.is_empty() { Soundness::Sound } else { entities::check_soundness(record) };
    Entity {
        kind,
        handle: record.handle,
        layer: file.layers.index(record.layer.unwrap_or(b"0")),
        color: record.color.and_then(|c| i16::try_from(c).ok()).unwrap_or(BY_LAYER),
        damaged: record.damaged || soundness == Soundness::Broken,
        assumed: if let Soundness::Assumed(what) = soundness { Some(what) } else { None },
        hidden,
        geometry,
    }
}
