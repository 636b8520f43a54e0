//! A drawing as read: shapes in millimetres, layers, units with their source, and findings.

use super::unit::Units;
use crate::finding::Finding;
use crate::geometry::Path;
use serde::Serialize;

/// A layer of the drawing.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Layer {
    /// Decoded name.
    pub name: String,
    /// AutoCAD colour index (absolute value); for SVG the nearest one.
    pub color: i16,
    /// Whether the layer is neither frozen nor off.
    pub visible: bool,
}

/// One entity as a chain of lines and arcs in mm, in sheet coordinates, with blocks expanded.
#[derive(Clone, Debug, PartialEq)]
pub struct Shape {
    /// The geometry.
    pub path: Path,
    /// Index into [`Drawing::layers`].
    pub layer: u32,
    /// AutoCAD colour index after resolving BYLAYER and BYBLOCK; for SVG the nearest one.
    pub color: i16,
    /// Handle as written in the file, used in reports only.
    pub handle: Option<String>,
    /// Name of the entity in its format (`LINE`, `LWPOLYLINE`, ... in DXF; `path`, `rect`, ... in SVG).
    pub kind: &'static str,
    /// Whether the entity was read across a break in the file. Such shapes are present only when asked for.
    pub damaged: bool,
}

/// Number of entities of one kind.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct EntityKindCount {
    /// Name of the kind in the format of the file.
    pub kind: String,
    /// Number in model space, as written (an INSERT or `use` counts once).
    pub count: u32,
    /// Whether entities of this kind become geometry.
    pub supported: bool,
}

/// A drawing in millimetres.
#[derive(Clone, Debug)]
pub struct Drawing {
    /// Version that the file names: the value of $ACADVER (`AC1015`), or that of SVG (`SVG 1.1`).
    pub version: Option<String>,
    /// Unit of the drawing.
    pub units: Units,
    /// Layers in the order of the file, followed by those that are used but missing in the layer table.
    pub layers: Vec<Layer>,
    /// Geometry that is visible, of a DXF file that of model space.
    pub shapes: Vec<Shape>,
    /// Entities by kind, most frequent first.
    pub entities: Vec<EntityKindCount>,
    /// Findings of the reader.
    pub findings: Vec<Finding>,
}
