//! Code pages of several bytes a character. Their tables weigh 200 kB, so in wasm the caller hands over the platform's own
//! decoder ([`TextDecoder`]), which every browser and Node have.

use super::drawing::TextDecoder;

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
    pub(super) fn decode(self, decoder: TextDecoder, bytes: &[u8]) -> (String, bool) {
        let text = (decoder.0)(self.label(), bytes);
        let wrong = text.chars().any(|c| c == char::REPLACEMENT_CHARACTER);
        (text, wrong)
    }
}
