//! LWPOLYLINE, and POLYLINE with the VERTEX records after it.

use crate::dxf::entity::{Geometry, Polyline3d, Vertex};
use crate::dxf::ocs;
use crate::dxf::record::Record;
use glam::{DVec2, DVec3};

pub(super) fn light<'a>(record: &Record<'a>) -> Geometry<'a> {
    let count = record.int(90).and_then(|n| usize::try_from(n).ok()).unwrap_or(0);
    // The count comes from the file, so memory is limited by the tags that are really there.
    let mut vertices: Vec<Vertex> = Vec::with_capacity(count.min(record.tags.len()));
    let (mut elevation, mut wide) = (0.0, false);
    for tag in &record.tags {
        let (Some(value), last) = (tag.real(), vertices.last_mut()) else { continue };
        match (tag.code, last) {
            (10, _) => vertices.push(Vertex { at: DVec2::new(value, 0.0), bulge: 0.0 }),
            (20, Some(v)) => v.at.y = value,
            (42, Some(v)) => v.bulge = value,
            (38, _) => elevation = value,
            // A constant width, or the width at the start or end of a segment.
            (40 | 41 | 43, _) => wide |= value > 0.0,
            _ => {}
        }
    }
    flat(vertices, record.flag(1), wide, elevation, record.normal)
}

fn flat<'a>(vertices: Vec<Vertex>, closed: bool, wide: bool, elevation: f64, normal: DVec3) -> Geometry<'a> {
    if vertices.len() < 2 {
        let place = vertices.first().map(|v| ocs::axes(normal) * v.at.extend(elevation));
        return Geometry::Invalid("it has fewer than two vertices", place);
    }
    Geometry::Polyline { vertices, closed, wide, elevation, normal }
}

/// The type of a POLYLINE (group 70).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Style {
    Flat,
    Spatial,
    Mesh,
    Polyface,
}

/// A POLYLINE whose vertices are being collected. It ends at SEQEND, or at any other record that is not a VERTEX.
#[derive(Debug)]
pub(in crate::dxf) struct Gathering {
    style: Style,
    closed: bool,
    wide: bool,
    elevation: f64,
    normal: DVec3,
    flat: Vec<Vertex>,
    spatial: Vec<DVec3>,
    first: Option<DVec3>,
}

/// Starts a POLYLINE.
pub(in crate::dxf) fn begin(record: &Record<'_>) -> Gathering {
    let style = if record.flag(64) {
        Style::Polyface
    } else if record.flag(16) {
        Style::Mesh
    } else if record.flag(8) {
        Style::Spatial
    } else {
        Style::Flat
    };
    Gathering {
        style,
        closed: record.flag(1),
        wide: is_wide(record),
        // Groups 10 and 20 of the POLYLINE itself are always 0; 30 is its elevation.
        elevation: record.real(30).unwrap_or(0.0),
        normal: record.normal,
        flat: Vec::new(),
        spatial: Vec::new(),
        first: None,
    }
}

/// Whether a POLYLINE or a VERTEX has a width at the start or the end of a segment.
fn is_wide(record: &Record<'_>) -> bool {
    [40, 41].into_iter().any(|code| record.real(code).is_some_and(|width| width > 0.0))
}

impl Gathering {
    /// Adds a VERTEX. Frame vertices of a spline fit are skipped, because they are not part of the outline.
    pub(in crate::dxf) fn add(&mut self, vertex: &Record<'_>) {
        const FRAME: i64 = 16;
        const MESH: i64 = 64;
        const POLYFACE: i64 = 128;
        if vertex.flag(FRAME) || (vertex.flag(POLYFACE) && !vertex.flag(MESH)) {
            return;
        }
        let Some(at) = vertex.point(10) else { return };
        self.first = self.first.or(Some(at));
        self.wide |= is_wide(vertex);
        match self.style {
            Style::Flat => {
                self.flat.push(Vertex { at: at.truncate(), bulge: vertex.real(42).unwrap_or(0.0) });
            }
            Style::Spatial => self.spatial.push(at),
            Style::Mesh | Style::Polyface => {}
        }
    }

    /// The geometry, or the name of the kind that has none to cut, with its place.
    pub(in crate::dxf) fn end<'a>(self) -> Result<Geometry<'a>, (&'static str, Option<DVec3>)> {
        match self.style {
            Style::Flat => Ok(flat(self.flat, self.closed, self.wide, self.elevation, self.normal)),
            Style::Spatial if self.spatial.len() < 2 => {
                Ok(Geometry::Invalid("it has fewer than two vertices", self.spatial.first().copied()))
            }
            Style::Spatial => {
                Ok(Geometry::Polylines3d(vec![Polyline3d { points: self.spatial, closed: self.closed }]))
            }
            Style::Mesh => Err(("POLYMESH", self.first)),
            Style::Polyface => Err(("POLYFACE", self.first)),
        }
    }
}
