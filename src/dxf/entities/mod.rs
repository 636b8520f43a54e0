//! Converts records to typed entities, with one file per family of entities.
//!
//! This module lists the kinds that have an outline, and the advice for those that do not.

mod curve;
mod face;
mod hatch;
mod insert;
mod polyline;
mod soundness;
mod spline;

pub(super) use polyline::{Gathering, begin as begin_polyline};
pub(super) use soundness::{Soundness, check_soundness};

use super::entity::Geometry;
use super::record::Record;

/// A kind of entity whose outline can be cut.
#[derive(Clone, Copy, Debug)]
pub(super) struct Kind {
    /// DXF name.
    pub(super) name: &'static str,
    read: for<'a> fn(&Record<'a>) -> Geometry<'a>,
}

const KINDS: [Kind; 13] = [
    Kind { name: "LINE", read: curve::line },
    Kind { name: "CIRCLE", read: curve::circle },
    Kind { name: "ARC", read: curve::arc },
    Kind { name: "LWPOLYLINE", read: polyline::light },
    Kind { name: "SPLINE", read: spline::spline },
    Kind { name: "INSERT", read: insert::insert },
    Kind { name: "ELLIPSE", read: curve::ellipse },
    Kind { name: "SOLID", read: face::solid },
    Kind { name: "TRACE", read: face::solid },
    Kind { name: "3DFACE", read: face::face },
    Kind { name: "HATCH", read: hatch::hatch },
    // A HELIX is a SPLINE followed by the numbers it was made from.
    Kind { name: "HELIX", read: spline::spline },
    // A POLYLINE spans several records; see `begin_polyline`.
    Kind { name: "POLYLINE", read: |_| Geometry::Invalid("its vertices are missing", None) },
];

/// The kind with this name, if its outline can be cut.
pub(super) fn kind(name: &[u8]) -> Option<Kind> {
    KINDS.into_iter().find(|k| k.name.as_bytes() == name)
}

/// The geometry of a record of the given kind.
pub(super) fn geometry<'a>(kind: Kind, record: &Record<'a>) -> Geometry<'a> {
    (kind.read)(record)
}

/// Whether this name is a known entity without an outline.
pub(super) fn is_known(name: &[u8]) -> bool {
    const UNKNOWN: &str = "";
    std::str::from_utf8(name).is_ok_and(|name| advice(name) != advice(UNKNOWN))
}

/// Explains an entity without an outline, and what a person can do about it.
pub(super) fn advice(name: &str) -> &'static str {
    match name {
        "TEXT" | "MTEXT" | "ATTRIB" | "ATTDEF" | "ARCALIGNEDTEXT" | "RTEXT" | "SHAPE" => {
            "text has no outline to cut; turn it into curves in the drawing program if it is to be cut or marked"
        }
        "DIMENSION"
        | "ARC_DIMENSION"
        | "LARGE_RADIAL_DIMENSION"
        | "LEADER"
        | "MULTILEADER"
        | "MLEADER"
        | "TOLERANCE"
        | "ACAD_TABLE" => "dimensions and notes are not cut",
        "REGION" | "BODY" | "3DSOLID" | "SURFACE" | "EXTRUDEDSURFACE" | "LOFTEDSURFACE"
        | "REVOLVEDSURFACE" | "SWEPTSURFACE" | "PLANESURFACE" | "NURBSURFACE" | "MESH" | "POLYMESH"
        | "POLYFACE" => {
            "a region or solid has no outline that can be read; explode it in the drawing program"
        }
        "IMAGE" | "WIPEOUT" | "OLEFRAME" | "OLE2FRAME" | "PDFUNDERLAY" | "DWFUNDERLAY" | "DGNUNDERLAY"
        | "PDFREFERENCE" | "UNDERLAY" => "pictures are not cut",
        "POINT" => "a point has no length to cut",
        "RAY" | "XLINE" => "a construction line without end is not cut",
        "MLINE" => "explode it into lines in the drawing program if it is to be cut",
        "VIEWPORT" | "LIGHT" | "SUN" | "CAMERA" | "SECTIONOBJECT" | "GEOPOSITIONMARKER" => {
            "it belongs to the view"
        }
        "ACAD_PROXY_ENTITY" | "ACAD_PROXY" => "it was made by a program add-on; explode it there to cut it",
        "VERTEX" => "a vertex without its polyline",
        _ => "this kind cannot be read; explode it in the drawing program if it is to be cut",
    }
}
