//! The platform's text decoder, for code pages whose tables would weigh more than the reader.

use web_sys::TextDecoder;

/// The text of `bytes` in an encoding of the web, U+FFFD where they mean nothing. Platforms that lack the encoding
/// take the bytes for UTF-8.
pub(super) fn decode(label: &str, bytes: &[u8]) -> String {
    let decoded = TextDecoder::new_with_label(label).and_then(|decoder| decoder.decode_with_u8_array(bytes));
    decoded.unwrap_or_else(|_| String::from_utf8_lossy(bytes).into_owned())
}
