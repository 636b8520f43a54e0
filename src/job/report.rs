//! What a job reports to its caller: the loaded drawing, as a report and as flat arrays.
//!
//! Reports are plain data for serde. Geometry is flat arrays of numbers, which reach JavaScript as typed arrays thirty
//! times faster than as objects.

use crate::drawing::{Drawing, EntityKindCount, Units};
use crate::finding::Finding;
use crate::geometry::{Path, Segment};
use crate::plan::Summary;
use crate::sheet::{Contour, LayerUse, Operation, Part, Sheet};
use serde::Serialize;

/// A contour, for lists.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct ContourInfo<'a> {
    /// Its index, which identifies it everywhere.
    pub id: u32,
    /// Whether it returns to its start.
    pub closed: bool,
    /// Name of its layer.
    pub layer: &'a str,
    /// Cut, mark, or ignore: skipped by the option `exclude`, or as the border.
    pub operation: Operation,
    /// The contour directly around it.
    pub inside: Option<u32>,
    /// Length, mm.
    pub length: f64,
    /// Area, mm².
    pub area: f64,
    /// Whether it is a skeleton cut, which nobody drew.
    #[serde(skip_serializing_if = "std::ops::Not::not")]
    #[cfg_attr(test, ts(as = "Option<bool>", optional))]
    pub skeleton: bool,
}

/// The content of a drawing, without its geometry.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(rename = "LoadedReport"))]
pub struct Loaded<'a> {
    /// Name of the file.
    pub name: &'a str,
    /// SHA-256 of its bytes, in hexadecimal.
    pub sha256: &'a str,
    /// Version of the file, `$ACADVER`.
    pub version: Option<&'a str>,
    /// The units used, and where they come from.
    pub units: &'a Units,
    /// Number of entities in model space, by kind.
    pub entities: &'a [EntityKindCount],
    /// Layers and their operations.
    pub layers: &'a [LayerUse],
    /// Contours by id.
    pub contours: Vec<ContourInfo<'a>>,
    /// The parts: outer contours with their holes.
    pub parts: &'a [Part],
    /// The contour that looks like the border of the sheet.
    pub outline: Option<u32>,
    /// Bounding box of all contours, mm: xmin, ymin, xmax, ymax; zeros if there are none.
    pub bounds: [f64; 4],
    /// Findings of the reader, then of the sheet.
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
    let info = |(id, c): (u32, &Contour)| ContourInfo {
        id,
        closed: c.path.closed,
        layer: sheet.layer_name(id),
        operation: c.operation,
        inside: c.inside,
        length: c.length,
        area: c.area,
        skeleton: c.skeleton,
    };
    (0..).zip(&sheet.contours).map(info).collect()
}

/// The job without a search, for comparison.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct Baselines {
    /// In the order of the drawing.
    pub drawing: Summary,
    /// By nearest neighbour.
    pub greedy: Summary,
}

/// Paths as flat arrays.
#[derive(Clone, Debug, PartialEq, Default)]
pub struct Geometry {
    /// Seven numbers for each element: start, end, centre, and sweep in rad. A line has sweep 0 and centre 0, 0.
    pub segments: Vec<f64>,
    /// Index of the first element of each path, and the number of elements at the end.
    pub offsets: Vec<u32>,
}

impl Geometry {
    /// The arrays for some paths.
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
