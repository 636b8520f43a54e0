//! The text of an SVG file: UTF-8, UTF-16 by its mark, or the encoding that the XML declaration names.

use crate::drawing::TextDecoder;
use std::borrow::Cow;

/// Decodes the bytes of a file. What has no meaning in its encoding becomes U+FFFD.
pub(super) fn decode(bytes: &[u8], decoder: TextDecoder) -> Cow<'_, str> {
    if let Some(label) = utf_16(bytes) {
        let text = (decoder.0)(label, bytes);
        return Cow::Owned(text.trim_start_matches('\u{feff}').to_owned());
    }
    let bytes = bytes.strip_prefix(b"\xEF\xBB\xBF").unwrap_or(bytes);
    if let Ok(text) = std::str::from_utf8(bytes) {
        return Cow::Borrowed(text);
    }
    match declared(bytes) {
        Some(label) if !label.eq_ignore_ascii_case("utf-8") => Cow::Owned((decoder.0)(label, bytes)),
        // Names in another encoding do no harm: only those characters are replaced.
        _ => String::from_utf8_lossy(bytes),
    }
}

/// The label of UTF-16, by the byte order mark or by the zero beside the first character.
pub(super) fn utf_16(bytes: &[u8]) -> Option<&'static str> {
    match bytes {
        [0xFF, 0xFE, ..] | [b'<', 0, ..] => Some("utf-16le"),
        [0xFE, 0xFF, ..] | [0, b'<', ..] => Some("utf-16be"),
        _ => None,
    }
}

/// The encoding in the XML declaration.
fn declared(bytes: &[u8]) -> Option<&str> {
    // The declaration is ASCII and at the start of the file.
    let start = bytes.get(..200).unwrap_or(bytes);
    let ascii = start.iter().position(|b| !b.is_ascii()).unwrap_or(start.len());
    let head = std::str::from_utf8(start.get(..ascii)?).ok()?;
    let (_, after) = head.split_once("encoding")?;
    let value = after.trim_start().strip_prefix('=')?.trim_start();
    let quote = value.chars().next().filter(|q| matches!(q, '"' | '\''))?;
    value.get(1..)?.split(quote).next()
}
