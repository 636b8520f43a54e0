//! The plan as JSON, format `kerfway.plan/1`, for other programs. mm, mm2, s.
//!
//! Everything needed to check or repeat the plan is in it: the drawing's hash, units and their source, the method, seed
//! and budget, the machine, the options, the moves, the findings. `www/sdk/plan.schema.json` is the published schema.
//!
//! Numbers are written in full (the shortest text that reads back to the same `f64`), so moves join bit for bit and
//! the same plan gives the same bytes everywhere.

mod view;

use crate::dxf::{Drawing, ReadOptions};
use crate::finding::Finding;
use crate::machine::Profile;
use crate::plan::Plan;
use crate::sheet::{Sheet, SheetOptions};
use serde::Serialize;
use view::View;

/// The drawing a plan is for.
#[derive(Clone, Copy, Debug)]
pub struct Input<'a> {
    /// File name, for people.
    pub name: &'a str,
    /// SHA-256 of the file's bytes, lower-case hexadecimal.
    pub sha256: &'a str,
}

/// What the search was given, and what it did with it.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Budget {
    /// Moves asked for.
    pub moves: Option<u64>,
    /// Seconds asked for.
    pub seconds: Option<f64>,
    /// Moves done.
    pub done: u64,
    /// Searches side by side, each with this budget; `None`: one.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub workers: Option<u32>,
}

/// A plan with all it came from.
#[derive(Clone, Copy, Debug)]
pub struct Document<'a> {
    /// The file.
    pub input: Input<'a>,
    /// What was read from it: units and findings.
    pub drawing: &'a Drawing,
    /// The contours planned.
    pub sheet: &'a Sheet,
    /// How the drawing was read.
    pub read: &'a ReadOptions,
    /// How it was arranged.
    pub arrange: &'a SheetOptions,
    /// The machine.
    pub machine: &'a Profile,
    /// Name of the method.
    pub method: &'a str,
    /// Its parameters, where some differ from the defaults: a JSON object.
    pub parameters: Option<&'a str>,
    /// Decided every random choice.
    pub seed: u64,
    /// What the search was given.
    pub budget: Budget,
    /// The plan.
    pub plan: &'a Plan,
    /// What else is worth knowing, besides the findings of drawing and sheet.
    pub more: &'a [Finding],
}

/// The text of a document, in one line.
pub fn json(document: &Document) -> String {
    json_text(&View::of(document))
}

/// Any value as JSON in one line, its numbers in full; what is not finite is null.
pub fn json_text(value: &impl Serialize) -> String {
    let mut text = Vec::new();
    let mut writer = serde_json::Serializer::with_formatter(&mut text, Plain);
    // Writing to memory cannot fail, and nothing of ours has maps with keys other than text.
    let _ = value.serialize(&mut writer);
    String::from_utf8(text).unwrap_or_default()
}

/// Numbers as std writes them: as few digits as read back bit for bit. serde_json's own way of writing them is as
/// good, and 14 KB of tables more in the wasm file.
struct Plain;

impl serde_json::ser::Formatter for Plain {
    fn write_f64<W: ?Sized + std::io::Write>(&mut self, to: &mut W, value: f64) -> std::io::Result<()> {
        write!(to, "{value}")
    }
}
