//! What a job tells its caller: the loaded drawing as a report and as flat arrays.
//!
//! Reports are plain data for serde; geometry is numbers in a row, which cross into JavaScript as typed arrays
//! thirty times faster than as objects.

use crate::dxf::{Drawing, EntityKindCount, Units};
use crate::finding::Finding;
use crate::geometry::{Path, Segment};
use crate::plan::Summary;
use crate::sheet::{Contour, LayerUse, Operation, Part, Sheet};
use serde::Serialize;

/// A contour, for lists.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct ContourInfo<'a> {
    /// Its index, which is its name everywhere.
    pub id: u32,
    /// Comes back to its start.
    pub closed: bool,
    /// Layer it is on.
    pub layer: &'a str,
    /// Cut or mark.
    pub operation: Operation,
    /// The contour around it.
    pub inside: Option<u32>,
    /// mm.
    pub length: f64,
    /// mm2.
    pub area: f64,
}

/// What a drawing turned out to hold, without its geometry.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Loaded<'a> {
    /// Of the file.
    pub name: &'a str,
    /// Of the bytes, in hexadecimal.
    pub sha256: &'a str,
    /// $ACADVER.
    pub version: Option<&'a str>,
    /// Units taken, and why.
    pub units: &'a Units,
    /// Entities of model space by kind.
    pub entities: &'a [EntityKindCount],
    /// Layers with what is done with them.
    pub layers: &'a [LayerUse],
    /// Contours by id.
    pub contours: Vec<ContourInfo<'a>>,
    /// Parts.
    pub parts: &'a [Part],
    /// The contour that looks like the border of the sheet.
    pub outline: Option<u32>,
    /// Box around all contours, mm: xmin, ymin, xmax, ymax; zeros when there are none.
    pub bounds: [f64; 4],
    /// Of the reader, then of the sheet.
    pub findings: Vec<&'a Finding>,
}

/// The report on a drawing and its sheet.
pub(super) fn loaded<'a>(
    name: &'a str,
    sha256: &'a str,
    drawing: &'a Drawing,
    sheet: &'a Sheet,
) -> Loaded<'a> {
    let bounds = if sheet.bounds.is_empty() {
        [0.0; 4]
    } else {
        [sheet.bounds.min.x, sheet.bounds.min.y, sheet.bounds.max.x, sheet.bounds.max.y]
    };
    Loaded {
        name,
        sha256,
        version: drawing.version.as_deref(),
        units: &drawing.units,
        entities: &drawing.entities,
        layers: &sheet.layers,
        contours: contours(sheet),
        parts: &sheet.parts,
        outline: sheet.outline,
        bounds,
        findings: drawing.findings.iter().chain(&sheet.findings).collect(),
    }
}

/// The contours of a sheet, for lists.
pub(super) fn contours(sheet: &Sheet) -> Vec<ContourInfo<'_>> {
    (0u32..).zip(&sheet.contours).map(|(id, c)| contour_info(id, c, sheet)).collect()
}

fn contour_info<'a>(id: u32, contour: &Contour, sheet: &'a Sheet) -> ContourInfo<'a> {
    ContourInfo {
        id,
        closed: contour.path.closed,
        layer: sheet.layers.get(contour.layer as usize).map_or("", |l| l.name.as_str()),
        operation: contour.operation,
        inside: contour.inside,
        length: contour.length,
        area: contour.area,
    }
}

/// How the job would run without a search.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Baselines {
    /// As drawn.
    pub drawing: Summary,
    /// Always the nearest allowed contour.
    pub greedy: Summary,
}

/// Chains of elements as numbers in a row.
#[derive(Clone, Debug, PartialEq, Default)]
pub struct Geometry {
    /// Seven numbers an element: start, end, centre, sweep in rad (0: a line, whose centre is 0, 0).
    pub segments: Vec<f64>,
    /// The element at which each chain starts; one more at the end.
    pub offsets: Vec<u32>,
}

impl Geometry {
    /// The arrays of some chains.
    pub fn of<'a>(paths: impl Iterator<Item = &'a Path>) -> Self {
        let mut g = Self { segments: Vec::new(), offsets: vec![0] };
        let mut elements = 0u32;
        for path in paths {
            for s in &path.segments {
                let (center, sweep) = match s {
                    Segment::Line(_) => (Default::default(), 0.0),
                    Segment::Arc(a) => (a.center, a.sweep),
                };
                let (from, to) = (s.start(), s.end());
                g.segments.extend([from.x, from.y, to.x, to.y, center.x, center.y, sweep]);
                elements += 1;
            }
            g.offsets.push(elements);
        }
        g
    }
}
