//! Code pages of several bytes a character. Their tables weigh 200 kB: in wasm the platform's own decoder is asked,
//! which every browser and Node have for the web's sake.

/// A code page by its label in the WHATWG Encoding Standard.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum EastAsian {
    /// 932, Japan.
    ShiftJis,
    /// 936, China.
    Gbk,
    /// China, the national standard.
    Gb18030,
    /// 949 and 1361, Korea.
    EucKr,
    /// 950, Taiwan and Hong Kong.
    Big5,
}

impl EastAsian {
    /// Its label, for decoders and messages.
    pub(super) fn label(self) -> &'static str {
        match self {
            Self::ShiftJis => "Shift_JIS",
            Self::Gbk => "GBK",
            Self::Gb18030 => "gb18030",
            Self::EucKr => "EUC-KR",
            Self::Big5 => "Big5",
        }
    }

    /// The text of `bytes`, and whether some of them meant nothing.
    pub(super) fn decode(self, bytes: &[u8]) -> (String, bool) {
        let text = decode(self.label(), bytes);
        let wrong = text.chars().any(|c| c == char::REPLACEMENT_CHARACTER);
        (text, wrong)
    }
}

#[cfg(not(target_arch = "wasm32"))]
fn decode(label: &str, bytes: &[u8]) -> String {
    let encoding = encoding_rs::Encoding::for_label(label.as_bytes()).unwrap_or(encoding_rs::UTF_8);
    encoding.decode_without_bom_handling(bytes).0.into_owned()
}

#[cfg(target_arch = "wasm32")]
fn decode(label: &str, bytes: &[u8]) -> String {
    crate::wasm::decode(label, bytes)
}
