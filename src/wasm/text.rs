//! The platform's text decoder, for code pages whose tables would weigh more than the reader.

use wasm_bindgen::prelude::*;

#[wasm_bindgen]
extern "C" {
    type TextDecoder;

    #[wasm_bindgen(constructor, catch)]
    fn new(label: &str) -> Result<TextDecoder, JsValue>;

    #[wasm_bindgen(method)]
    fn decode(this: &TextDecoder, bytes: &[u8]) -> String;
}

/// The text of `bytes` in an encoding of the web, U+FFFD where they mean nothing. Platforms that lack the encoding
/// take the bytes for UTF-8.
pub(super) fn decode(label: &str, bytes: &[u8]) -> String {
    match TextDecoder::new(label) {
        Ok(decoder) => decoder.decode(bytes),
        Err(_) => String::from_utf8_lossy(bytes).into_owned(),
    }
}
