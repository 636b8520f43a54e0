//! What the reader hands on: shapes in millimetres, layers, units and their source, findings.

use crate::finding::Finding;
use crate::geometry::Path;
use serde::{Deserialize, Serialize};

/// Units of a drawing.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Unit {
    /// 25.4 mm.
    In,
    /// 304.8 mm.
    Ft,
    /// 914.4 mm.
    Yd,
    /// 0.0254 mm.
    Mil,
    /// A millionth of an inch.
    Microinch,
    /// 0.001 mm.
    Um,
    /// 1 mm.
    Mm,
    /// 10 mm.
    Cm,
    /// 100 mm.
    Dm,
    /// 1000 mm.
    M,
}

impl Unit {
    /// How many millimetres one of it is.
    pub const fn millimetres(self) -> f64 {
        match self {
            Self::In => 25.4,
            Self::Ft => 304.8,
            Self::Yd => 914.4,
            Self::Mil => 0.0254,
            Self::Microinch => 0.000_025_4,
            Self::Um => 0.001,
            Self::Mm => 1.0,
            Self::Cm => 10.0,
            Self::Dm => 100.0,
            Self::M => 1000.0,
        }
    }

    /// Its name in a sentence.
    pub const fn plural(self) -> &'static str {
        match self {
            Self::In => "inches",
            Self::Ft => "feet",
            Self::Yd => "yards",
            Self::Mil => "mils",
            Self::Microinch => "microinches",
            Self::Um => "micrometres",
            Self::Mm => "millimetres",
            Self::Cm => "centimetres",
            Self::Dm => "decimetres",
            Self::M => "metres",
        }
    }

    /// Metric or imperial.
    pub const fn is_metric(self) -> bool {
        matches!(self, Self::Um | Self::Mm | Self::Cm | Self::Dm | Self::M)
    }

    /// The unit of an $INSUNITS code; `None` for 0 and for those no drawing to cut is in (miles, parsecs, ...).
    pub const fn of_insert_units(code: i64) -> Option<Self> {
        // 21 to 23 are survey feet, inches and yards: 2 parts in a million longer.
        Some(match code {
            1 | 22 => Self::In,
            2 | 21 => Self::Ft,
            4 => Self::Mm,
            5 => Self::Cm,
            6 => Self::M,
            8 => Self::Microinch,
            9 => Self::Mil,
            10 | 23 => Self::Yd,
            13 => Self::Um,
            14 => Self::Dm,
            _ => return None,
        })
    }
}

/// Where the units come from.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum UnitsSource {
    /// $INSUNITS.
    Header,
    /// Guessed from size and $MEASUREMENT: see `reason`.
    Guessed,
    /// By the person.
    Given,
}

/// The units taken, and why.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Units {
    /// The unit taken.
    pub unit: Unit,
    /// From where.
    pub source: UnitsSource,
    /// One sentence for people: why this unit.
    pub reason: String,
    /// Whether a person should be asked: guessed without evidence, or the size speaks against the header.
    pub doubtful: bool,
}

/// A layer of the drawing.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Layer {
    /// Name, decoded.
    pub name: String,
    /// AutoCAD colour index (absolute value).
    pub color: i16,
    /// Neither frozen nor off.
    pub visible: bool,
}

/// One entity as a chain of lines and arcs in mm, in sheet coordinates, blocks expanded.
#[derive(Clone, Debug, PartialEq)]
pub struct Shape {
    /// The geometry.
    pub path: Path,
    /// Index into [`Drawing::layers`].
    pub layer: u32,
    /// AutoCAD colour index as resolved (by layer, by block).
    pub color: i16,
    /// Handle as written in the file, for reports only.
    pub handle: Option<String>,
    /// DXF name of the entity (`LINE`, `LWPOLYLINE`, ...).
    pub kind: &'static str,
    /// Read through a break in the file; only present when asked for.
    pub damaged: bool,
}

/// How many entities of a kind the file holds, blocks expanded or not.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct EntityKindCount {
    /// DXF name.
    pub kind: String,
    /// In model space, as written (an INSERT counts once).
    pub count: u32,
    /// Whether it becomes geometry.
    pub supported: bool,
}

/// A drawing in millimetres.
#[derive(Clone, Debug)]
pub struct Drawing {
    /// $ACADVER, when given (`AC1015`).
    pub version: Option<String>,
    /// Units taken.
    pub units: Units,
    /// Layers, in order of the file; those not in the table but used follow.
    pub layers: Vec<Layer>,
    /// Geometry of model space, visible layers only.
    pub shapes: Vec<Shape>,
    /// Entities by kind, most frequent first.
    pub entities: Vec<EntityKindCount>,
    /// Everything worth knowing.
    pub findings: Vec<Finding>,
}

/// Bounds against hostile files. Past one of them the file is refused with a sentence that names it.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Limits {
    /// Bytes of the file.
    pub bytes: usize,
    /// Elements (lines and arcs) after blocks are expanded.
    pub elements: usize,
    /// Depth of nested blocks.
    pub depth: usize,
    /// Largest coordinate, mm.
    pub coordinate: f64,
}

/// How to read.
#[derive(Clone, Debug, PartialEq)]
pub struct ReadOptions {
    /// Units given by the person; otherwise header or guess.
    pub unit: Option<Unit>,
    /// Largest distance between a spline or ellipse and its lines and arcs, mm.
    pub tolerance: f64,
    /// Keep entities read through a break in the file.
    pub keep_damaged: bool,
    /// Bounds.
    pub limits: Limits,
    /// Reads names in code pages of several bytes a character.
    pub decoder: TextDecoder,
}

/// Decodes bytes in an encoding named by its label in the WHATWG Encoding Standard, with U+FFFD where they mean nothing.
///
/// The default has all tables natively. In wasm it has none and reads UTF-8: the bindings hand over the platform's decoder.
#[derive(Clone, Copy, Debug)]
pub struct TextDecoder(pub fn(label: &str, bytes: &[u8]) -> String);

impl Default for TextDecoder {
    fn default() -> Self {
        Self(decode)
    }
}

/// Decoders read the same text, so options that differ in nothing else are the same.
impl PartialEq for TextDecoder {
    fn eq(&self, _: &Self) -> bool {
        true
    }
}

#[cfg(not(target_arch = "wasm32"))]
fn decode(label: &str, bytes: &[u8]) -> String {
    let encoding = encoding_rs::Encoding::for_label(label.as_bytes()).unwrap_or(encoding_rs::UTF_8);
    encoding.decode_without_bom_handling(bytes).0.into_owned()
}

#[cfg(target_arch = "wasm32")]
fn decode(_: &str, bytes: &[u8]) -> String {
    String::from_utf8_lossy(bytes).into_owned()
}

impl Default for ReadOptions {
    fn default() -> Self {
        Self {
            unit: None,
            tolerance: 0.005,
            keep_damaged: false,
            limits: Limits { bytes: 256 << 20, elements: 2_000_000, depth: 16, coordinate: 1e6 },
            decoder: TextDecoder::default(),
        }
    }
}

/// Why a file cannot be used: one sentence for people.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum ReadError {
    /// Not a DXF: names the format found when known, and what to do.
    #[error("{0}")]
    NotDxf(String),
    /// Nothing to cut in it.
    #[error("{0}")]
    Empty(String),
    /// A limit was passed.
    #[error("{0}")]
    Limit(String),
}
