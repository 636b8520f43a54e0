//! Decodes the text of a DXF: names of layers, blocks and programs.
//!
//! Up to AC1018 (R2004) text is in the code page of $DWGCODEPAGE; from AC1021 (R2007) on it is in UTF-8. In both,
//! `\U+XXXX` is a Unicode character and `\M+nXXXX` a character of an East Asian code page. Many programs write UTF-8
//! although the header names a Western code page. Bytes that are valid UTF-8 beyond ASCII are therefore read as UTF-8
//! there, because such text hardly ever occurs by chance in a one-byte code page.

use super::header::Header;
use super::multi_byte::MultiByte;
use super::single_byte::{self as pages, SingleByte};
use crate::drawing::TextDecoder;
use std::borrow::Cow;

/// The encoding of a file's text.
#[derive(Clone, Copy, Debug)]
enum Encoding {
    Utf8,
    SingleByte(&'static SingleByte),
    MultiByte(MultiByte),
}

impl Encoding {
    fn name(self) -> &'static str {
        match self {
            Self::Utf8 => "UTF-8",
            Self::SingleByte(page) => page.name,
            Self::MultiByte(page) => page.label(),
        }
    }

    /// The text of `bytes`, and whether some of them had no meaning.
    fn decode(self, decoder: TextDecoder, bytes: &[u8]) -> (String, bool) {
        match self {
            // Invalid UTF-8 is usually text in the code page of the author's computer.
            Self::Utf8 => (pages::WINDOWS_1252.decode(bytes).0, true),
            Self::SingleByte(page) => page.decode(bytes),
            Self::MultiByte(page) => page.decode(decoder, bytes),
        }
    }
}

/// Turns bytes of a file into text.
#[derive(Debug)]
pub(super) struct Decoder {
    encoding: Encoding,
    decoder: TextDecoder,
    replaced: u32,
}

impl Decoder {
    /// Creates the decoder for a file with this header.
    pub(super) fn new(header: &Header<'_>, decoder: TextDecoder) -> Self {
        // Versions are AC and four digits, so the order of the bytes is the order of the releases.
        let utf8 = header.version.is_some_and(|v| v.starts_with(b"AC") && v >= b"AC1021".as_slice());
        let declared = header.code_page.and_then(code_page);
        Self {
            encoding: if utf8 {
                Encoding::Utf8
            } else {
                declared.unwrap_or(Encoding::SingleByte(&pages::WINDOWS_1252))
            },
            decoder,
            replaced: 0,
        }
    }

    /// Name of the encoding, for messages.
    pub(super) fn name(&self) -> &'static str {
        self.encoding.name()
    }

    /// Number of texts with bytes that could not be decoded.
    pub(super) fn replaced(&self) -> u32 {
        self.replaced
    }

    /// Decodes `bytes`, including escapes.
    pub(super) fn text<'b>(&mut self, bytes: &'b [u8]) -> Cow<'b, str> {
        let text = self.decode(bytes);
        if text.contains('\\') { Cow::Owned(unescape(&text, self.decoder)) } else { text }
    }

    fn decode<'b>(&mut self, bytes: &'b [u8]) -> Cow<'b, str> {
        // Text in a code page of several bytes per character may be valid UTF-8 by chance.
        let may_be_utf8 = bytes.is_ascii() || !matches!(self.encoding, Encoding::MultiByte(_));
        if may_be_utf8 && let Ok(text) = std::str::from_utf8(bytes) {
            return Cow::Borrowed(text);
        }
        let (text, wrong) = self.encoding.decode(self.decoder, bytes);
        self.replaced = self.replaced.saturating_add(u32::from(wrong));
        Cow::Owned(text)
    }
}

/// The encoding for a $DWGCODEPAGE value such as `ANSI_1252`.
fn code_page(name: &[u8]) -> Option<Encoding> {
    let name = name.to_ascii_uppercase();
    let number = name.rsplit(|b| *b == b'_').next().unwrap_or(&name);
    let number = number.strip_prefix(b"DOS").unwrap_or(number);
    let page = match number {
        b"874" => &pages::WINDOWS_874,
        b"932" => return Some(Encoding::MultiByte(MultiByte::ShiftJis)),
        b"936" => return Some(Encoding::MultiByte(MultiByte::Gbk)),
        b"949" | b"1361" => return Some(Encoding::MultiByte(MultiByte::EucKr)),
        b"950" => return Some(Encoding::MultiByte(MultiByte::Big5)),
        b"437" => &pages::IBM437,
        b"850" => &pages::IBM850,
        b"852" => &pages::IBM852,
        b"1250" => &pages::WINDOWS_1250,
        b"1251" => &pages::WINDOWS_1251,
        b"866" => &pages::IBM866,
        b"1252" => &pages::WINDOWS_1252,
        b"1253" => &pages::WINDOWS_1253,
        b"1254" => &pages::WINDOWS_1254,
        b"1255" => &pages::WINDOWS_1255,
        b"1256" => &pages::WINDOWS_1256,
        b"1257" => &pages::WINDOWS_1257,
        b"1258" => &pages::WINDOWS_1258,
        b"GB18030" | b"54936" => return Some(Encoding::MultiByte(MultiByte::Gb18030)),
        b"ROMAN" => &pages::MACINTOSH,
        b"8859-2" | b"ISO8859-2" => &pages::ISO_8859_2,
        b"8859-3" | b"ISO8859-3" => &pages::ISO_8859_3,
        b"8859-4" | b"ISO8859-4" => &pages::ISO_8859_4,
        b"8859-5" | b"ISO8859-5" => &pages::ISO_8859_5,
        b"8859-6" | b"ISO8859-6" => &pages::ISO_8859_6,
        b"8859-7" | b"ISO8859-7" => &pages::ISO_8859_7,
        b"8859-8" | b"ISO8859-8" => &pages::ISO_8859_8,
        b"UTF-8" | b"UTF8" | b"65001" => return Some(Encoding::Utf8),
        _ => return None,
    };
    Some(Encoding::SingleByte(page))
}

/// Replaces `\U+XXXX` and `\M+nXXXX`; malformed escapes stay unchanged.
fn unescape(text: &str, decoder: TextDecoder) -> String {
    let mut out = String::with_capacity(text.len());
    let mut rest = text;
    while let Some(start) = rest.find('\\') {
        let (before, escape) = rest.split_at(start);
        out.push_str(before);
        let (c, length) = match (unicode_escape(escape), multibyte_escape(escape, decoder)) {
            (Some(c), _) => (c, 7),
            (_, Some(c)) => (c, 8),
            _ => ('\\', 1),
        };
        out.push(c);
        rest = escape.get(length..).unwrap_or_default();
    }
    out.push_str(rest);
    out
}

fn unicode_escape(text: &str) -> Option<char> {
    char::from_u32(hex4(text.strip_prefix("\\U+")?)?)
}

fn multibyte_escape(text: &str, decoder: TextDecoder) -> Option<char> {
    let digits = text.strip_prefix("\\M+")?;
    let encoding = match digits.bytes().next()? {
        b'1' => MultiByte::ShiftJis,
        b'2' => MultiByte::Big5,
        b'3' | b'4' => MultiByte::EucKr,
        b'5' => MultiByte::Gbk,
        _ => return None,
    };
    let code = u16::try_from(hex4(digits.get(1..)?)?).ok()?;
    let bytes = code.to_be_bytes();
    let (text, wrong) = encoding.decode(decoder, &bytes);
    if wrong { None } else { text.chars().next() }
}

fn hex4(text: &str) -> Option<u32> {
    let digits = text.get(..4)?;
    digits.bytes().all(|b| b.is_ascii_hexdigit()).then(|| u32::from_str_radix(digits, 16).ok())?
}
