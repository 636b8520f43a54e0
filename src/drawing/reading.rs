//! What the caller of a reader sets, and how a reader refuses a file.

use super::unit::Unit;
use crate::geometry::DVec2;
use serde::{Deserialize, Serialize};

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

impl Limits {
    /// Refuses a file that is larger than these limits allow.
    pub(crate) fn check_size(&self, bytes: usize) -> Result<(), ReadError> {
        if bytes <= self.bytes {
            return Ok(());
        }
        Err(ReadError::Limit(format!(
            "The file has {} MB; up to {} MB can be read. Delete what is not to be cut, or split the drawing.",
            // Rounded up, so that a size just above the limit does not look equal to it.
            bytes.div_ceil(1 << 20),
            self.bytes >> 20
        )))
    }

    /// Whether a point is no farther from the origin than these limits allow.
    pub(crate) fn is_near(&self, p: DVec2) -> bool {
        p.is_finite() && p.abs().max_element() <= self.coordinate
    }
}

/// Options for reading.
#[derive(Clone, Debug, PartialEq)]
pub struct ReadOptions {
    /// Unit chosen by the person; `None` takes it from the header or guesses it.
    pub unit: Option<Unit>,
    /// Pixels per inch, chosen by the person for a drawing in pixels.
    pub dpi: Option<f64>,
    /// Largest distance between a spline or ellipse and the lines and arcs that replace it, mm.
    pub tolerance: f64,
    /// Whether to keep entities that were read across a break in the file.
    pub keep_damaged: bool,
    /// Quarter turns of the drawing around its origin, counter-clockwise.
    pub quarter_turns: u8,
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
            dpi: None,
            tolerance: 0.005,
            keep_damaged: false,
            quarter_turns: 0,
            limits: Limits { bytes: 256 << 20, elements: 2_000_000, depth: 16, coordinate: 1e6 },
            decoder: TextDecoder::default(),
        }
    }
}

/// Why a file cannot be used, as one sentence for people.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum ReadError {
    /// The file is of another format, or damaged beyond reading. The sentence names the format if it was recognised, and says what to do.
    #[error("{0}")]
    NotADrawing(String),
    /// The drawing holds nothing to cut.
    #[error("{0}")]
    Empty(String),
    /// The file exceeds a limit.
    #[error("{0}")]
    Limit(String),
}
