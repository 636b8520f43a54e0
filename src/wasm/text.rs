//! The platform's text decoder, used for code pages whose tables would be larger than the reader.

use web_sys::TextDecoder;

/// Decodes `bytes` in an encoding of the web platform; invalid bytes become U+FFFD. A platform that lacks the encoding
/// decodes them as UTF-8.
pub(super) fn decode(label: &str, bytes: &[u8]) -> String {
    let decoded = TextDecoder::new_with_label(label).and_then(|decoder| decoder.decode_with_u8_array(bytes));
    decoded.unwrap_or_else(|_| String::from_utf8_lossy(bytes).into_owned())
}
