//! JSON text: how a [plan document](crate::plan::document) and every report is written, for other programs.
//!
//! Numbers are written in full (the shortest text that reads back to the same `f64`), so moves join bit for bit and
//! the same plan gives the same bytes everywhere.

use serde::Serialize;
use sha2::{Digest, Sha256};

/// A value as JSON in one line, its numbers in full; a number that is not finite becomes null.
pub fn json_text(value: &impl Serialize) -> String {
    let mut text = Vec::new();
    let mut writer = serde_json::Serializer::with_formatter(&mut text, Plain);
    // Writing to memory cannot fail, and nothing of ours has maps with keys other than text.
    let _ = value.serialize(&mut writer);
    String::from_utf8(text).unwrap_or_default()
}

/// The SHA-256 of bytes, in hexadecimal digits: how documents name files and each other.
pub fn sha256(bytes: impl AsRef<[u8]>) -> String {
    Sha256::digest(bytes).iter().map(|b| format!("{b:02x}")).collect()
}

/// Numbers as std writes them: as few digits as read back bit for bit. serde_json's own way of writing them is as
/// good, and 14 KB of tables more in the wasm file.
struct Plain;

impl serde_json::ser::Formatter for Plain {
    fn write_f64<W: ?Sized + std::io::Write>(&mut self, to: &mut W, value: f64) -> std::io::Result<()> {
        write!(to, "{value}")
    }
}
