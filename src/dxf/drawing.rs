//! The result of reading: shapes in millimetres, layers, units with their source, and findings.

use crate::finding::Finding;
use crate::geometry::Path;
use serde::{Deserialize, Serialize};

/// The unit of length of a drawing.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
#[cfg_attr(test, derive(ts_rs::TS))]
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
    /// Length of the unit in millimetres.
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

    /// Name of the unit in a sentence.
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

    /// Whether the unit is metric, not imperial.
    pub const fn is_metric(self) -> bool {
        matches!(self, Self::Um | Self::Mm | Self::Cm | Self::Dm | Self::M)
    }

    /// The unit of an $INSUNITS code; `None` for 0 and for units that no cutting drawing uses (miles, parsecs, ...).
    pub const fn of_insert_units(code: i64) -> Option<Self> {
        // 21 to 23 are survey feet, inches and yards, which are 2 parts in a million longer.
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

/// Where the unit comes from.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
#[cfg_attr(test, derive(ts_rs::TS))]
pub enum UnitsSource {
    /// The header variable $INSUNITS.
    Header,
    /// Guessed from the size and $MEASUREMENT; see `reason`.
    Guessed,
    /// Chosen by the person.
    Given,
}

/// The unit of a drawing, and why it was chosen.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(rename = "UnitsTaken"))]
pub struct Units {
    /// The chosen unit.
    pub unit: Unit,
    /// Where the unit comes from.
    pub source: UnitsSource,
    /// One sentence for people that gives the reason for this unit.
    pub reason: String,
    /// Whether a person should be asked, because the unit was guessed without evidence or the size contradicts the
    /// header.
    pub doubtful: bool,
}

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

/// Limits that protect against hostile files. A file that exceeds one is refused with a sentence that names it.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Limits {
    /// Size of the file, bytes.
    pub bytes: usize,
    /// Number of lines and arcs after blocks are expanded.
    pub elements: usize,
    /// Nesting depth of blocks.
    pub depth: usize,
    /// Largest coordinate, mm.
    pub coordinate: f64,
}

/// Options for reading.
#[derive(Clone, Debug, PartialEq)]
pub struct ReadOptions {
    /// Unit chosen by the person; `None` takes it from the header or guesses it.
    pub unit: Option<Unit>,
    /// Largest distance between a spline or ellipse and the lines and arcs that replace it, mm.
    pub tolerance: f64,
    /// Whether to keep entities that were read across a break in the file.
    pub keep_damaged: bool,
    /// Limits on the input.
    pub limits: Limits,
    /// Decodes names in code pages of several bytes per character.
    pub decoder: TextDecoder,
}

/// Decodes bytes in an encoding named by its label in the WHATWG Encoding Standard; bytes without a meaning become
/// U+FFFD.
///
/// The default has all tables natively. In wasm it has none and reads UTF-8, so the bindings pass the platform's
/// decoder instead.
#[derive(Clone, Copy, Debug)]
pub struct TextDecoder(pub fn(label: &str, bytes: &[u8]) -> String);

impl Default for TextDecoder {
    fn default() -> Self {
        Self(decode)
    }
}

/// Decoders give the same text, so options that differ in nothing else are equal.
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

/// Why a file cannot be used, as one sentence for people.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum ReadError {
    /// The file is not a DXF. The sentence names the format if it was recognised, and says what to do.
    #[error("{0}")]
    NotDxf(String),
    /// The drawing holds nothing to cut.
    #[error("{0}")]
    Empty(String),
    /// The file exceeds a limit.
    #[error("{0}")]
    Limit(String),
}
