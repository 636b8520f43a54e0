//! East Asian code pages of several bytes per character. Their tables take 200 kB, so in wasm the caller passes the
//! platform's own decoder ([`TextDecoder`]), which every browser and Node have.

use crate::drawing::TextDecoder;

/// A code page of several bytes per character.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum MultiByte {
    /// Code page 932, Japan.
    ShiftJis,
    /// Code page 936, China.
    Gbk,
    /// GB 18030, the national standard of China.
    Gb18030,
    /// Code pages 949 and 1361, Korea.
    EucKr,
    /// Code page 950, Taiwan and Hong Kong.
    Big5,
}

impl MultiByte {
    /// Its label in the WHATWG Encoding Standard, for decoders and messages.
    pub(super) fn label(self) -> &'static str {
        match self {
            Self::ShiftJis => "Shift_JIS",
            Self::Gbk => "GBK",
            Self::Gb18030 => "gb18030",
            Self::EucKr => "EUC-KR",
            Self::Big5 => "Big5",
        }
    }

    /// The text of `bytes`, and whether some of them had no meaning.
    pub(super) fn decode(self, decoder: TextDecoder, bytes: &[u8]) -> (String, bool) {
        let text = (decoder.0)(self.label(), bytes);
        let wrong = text.chars().any(|c| c == char::REPLACEMENT_CHARACTER);
        (text, wrong)
    }
}
