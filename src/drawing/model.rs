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
    /// AutoCAD colour index (absolute value).
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
    /// AutoCAD colour index after resolving BYLAYER and BYBLOCK.
    pub color: i16,
    /// Handle as written in the file, used in reports only.
    pub handle: Option<String>,
    /// DXF name of the entity (`LINE`, `LWPOLYLINE`, ...).
    pub kind: &'static str,
    /// Whether the entity was read across a break in the file. Such shapes are present only when asked for.
    pub damaged: bool,
}

/// Number of entities of one kind.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct EntityKindCount {
    /// Name of the kind in DXF.
    pub kind: String,
    /// Number in model space, as written (an INSERT counts once).
    pub count: u32,
    /// Whether entities of this kind become geometry.
    pub supported: bool,
}

/// A drawing in millimetres.
#[derive(Clone, Debug)]
pub struct Drawing {
    /// Value of $ACADVER, if present (`AC1015`).
    pub version: Option<String>,
    /// Unit of the drawing.
    pub units: Units,
    /// Layers in the order of the file, followed by those that are used but missing in the layer table.
    pub layers: Vec<Layer>,
    /// Geometry of model space on visible layers.
    pub shapes: Vec<Shape>,
    /// Entities by kind, most frequent first.
    pub entities: Vec<EntityKindCount>,
    /// Findings of the reader.
    pub findings: Vec<Finding>,
}
