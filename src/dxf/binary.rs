//! Reads the tags of a binary file (`AutoCAD Binary DXF`) in one pass, borrowing from it.
//!
//! Group codes take one byte up to release 12 (255 announces a longer code) and two bytes since. The type of a value
//! follows from its code; text ends with a zero byte. A code that no release defines has a value of unknown length, so
//! the reader is out of sync and resumes at the next group 0 with a keyword.

use super::breaks::{Break, BreakKind};
use super::tag::{Tag, Value, ValueType, is_keyword, value_type};

/// The first bytes of every binary DXF.
pub(super) const SENTINEL: &[u8] = b"AutoCAD Binary DXF\r\n\x1A\0";

/// Longest text value in bytes. AutoCAD writes at most 2,049 characters of up to four bytes each, and some programs
/// write longer texts. It bounds the work of a reader that is out of sync.
const LONGEST_TEXT: usize = 65_536;

/// Reader of the tags of a binary file.
#[derive(Debug)]
pub(super) struct Binary<'a> {
    data: &'a [u8],
    at: usize,
    wide_codes: bool,
    after_break: bool,
    breaks: Vec<Break>,
    cut_off: bool,
}

impl<'a> Binary<'a> {
    /// Creates a reader at the first tag of `data`, which starts with [`SENTINEL`].
    pub(super) fn new(data: &'a [u8]) -> Self {
        let at = SENTINEL.len();
        // The first tag is group 0 or a comment (999). If codes have one byte, the second byte is a letter of its text,
        // and both bytes together are far above every code.
        let wide_codes = match data.get(at..at + 2) {
            Some(&[low, high]) => u16::from_le_bytes([low, high]) <= 1071,
            _ => true,
        };
        Self { data, at, wide_codes, after_break: false, breaks: Vec::new(), cut_off: false }
    }

    /// Byte offset of the next tag.
    fn offset(&self) -> u32 {
        u32::try_from(self.at).unwrap_or(u32::MAX)
    }

    /// The breaks found since the last call, in order.
    pub(super) fn take_breaks(&mut self) -> Vec<Break> {
        std::mem::take(&mut self.breaks)
    }

    /// Whether the file ended within a tag.
    pub(super) fn cut_off(&self) -> bool {
        self.cut_off
    }

    /// Whether any bytes are left.
    pub(super) fn has_more(&self) -> bool {
        self.data.get(self.at..).is_some_and(|rest| rest.iter().any(|b| !matches!(b, 0 | 0x1A)))
    }

    /// The next tag; `None` at the end of the file.
    pub(super) fn next(&mut self) -> Option<Tag<'a>> {
        if self.at >= self.data.len() {
            return None;
        }
        match self.tag_at(self.at) {
            Ok((tag, next)) => {
                let bad = tag.value == Value::Bad;
                if bad {
                    self.breaks.push(Break { place: self.offset(), kind: BreakKind::BadValue });
                }
                self.at = next;
                Some(Tag { after_break: std::mem::take(&mut self.after_break) || bad, repaired: bad, ..tag })
            }
            Err(Fault::Nonsense) => {
                self.breaks.push(Break { place: self.offset(), kind: BreakKind::OutOfSync });
                self.after_break = true;
                self.at = self.next_keyword(self.at + 1)?;
                let (tag, next) = self.tag_at(self.at).ok()?;
                self.at = next;
                self.after_break = false;
                Some(Tag { after_break: true, ..tag })
            }
            Err(Fault::End) => {
                self.cut_off = true;
                self.at = self.data.len();
                None
            }
        }
    }

    /// The tag at `at`, and the offset of the next one.
    fn tag_at(&self, at: usize) -> Result<(Tag<'a>, usize), Fault> {
        let (code, at) = self.code_at(at)?;
        let text = |at| self.text_at(at).map(|(t, next)| (Value::Text(t), next));
        let (value, next) = match code {
            0 => match self.text_at(at)? {
                (t, next) if is_keyword(t) => (Value::Text(t), next),
                _ => return Err(Fault::Nonsense),
            },
            // Chunks of bytes, preceded by a length byte.
            310..=319 | 1004 => {
                let [length] = self.bytes(at)?;
                let end = at + 1 + usize::from(length);
                (Value::Text(self.data.get(at + 1..end).ok_or(Fault::End)?), end)
            }
            290..=299 => {
                let [flag] = self.bytes(at)?;
                (Value::Int(i64::from(flag)), at + 1)
            }
            90..=99 | 420..=429 | 440..=459 | 1071 => {
                (Value::Int(i64::from(i32::from_le_bytes(self.bytes(at)?))), at + 4)
            }
            160..=169 => (Value::Int(i64::from_le_bytes(self.bytes(at)?)), at + 8),
            _ => match value_type(code) {
                ValueType::Keyword | ValueType::Text => text(at)?,
                ValueType::Real => {
                    let value = f64::from_le_bytes(self.bytes(at)?);
                    (if value.is_finite() { Value::Real(value) } else { Value::Bad }, at + 8)
                }
                ValueType::Int => (Value::Int(i64::from(i16::from_le_bytes(self.bytes(at)?))), at + 2),
                ValueType::Unknown => return Err(Fault::Nonsense),
            },
        };
        Ok((Tag::sound(code, value), next))
    }

    fn code_at(&self, at: usize) -> Result<(i32, usize), Fault> {
        if self.wide_codes {
            return Ok((i32::from(i16::from_le_bytes(self.bytes(at)?)), at + 2));
        }
        match self.bytes(at)? {
            [255] => Ok((i32::from(i16::from_le_bytes(self.bytes(at + 1)?)), at + 3)),
            [code] => Ok((i32::from(code), at + 1)),
        }
    }

    fn text_at(&self, at: usize) -> Result<(&'a [u8], usize), Fault> {
        let rest = self.data.get(at..).ok_or(Fault::End)?;
        match rest.iter().take(LONGEST_TEXT).position(|b| *b == 0) {
            Some(length) => Ok((rest.get(..length).unwrap_or_default().trim_ascii(), at + length + 1)),
            None if rest.len() > LONGEST_TEXT => Err(Fault::Nonsense),
            None => Err(Fault::End),
        }
    }

    fn bytes<const N: usize>(&self, at: usize) -> Result<[u8; N], Fault> {
        self.data.get(at..at + N).and_then(|b| b.try_into().ok()).ok_or(Fault::End)
    }

    /// The next offset from `from` on that reads as a group 0 with a keyword of capital letters.
    fn next_keyword(&mut self, from: usize) -> Option<usize> {
        // Lengths of a keyword. The shortest are ARC and EOF; the longest in use has 34 letters.
        const KEYWORD: std::ops::RangeInclusive<usize> = 3..=40;
        let zeros = if self.wide_codes { 2 } else { 1 };
        let mut at = from;
        while let Some(rest) = self.data.get(at..).filter(|rest| rest.len() > zeros) {
            let name = rest.get(zeros..).unwrap_or_default();
            let length = name.iter().take(*KEYWORD.end() + 1).position(|b| *b == 0);
            if rest.iter().take(zeros).all(|b| *b == 0)
                && let Some(length) = length
                && KEYWORD.contains(&length)
                && name
                    .iter()
                    .take(length)
                    .all(|b| b.is_ascii_uppercase() || b.is_ascii_digit() || *b == b'_')
            {
                return Some(at);
            }
            at += 1;
        }
        self.at = self.data.len();
        self.cut_off = true;
        None
    }
}

/// Why a tag could not be read.
enum Fault {
    /// The file ends within the tag.
    End,
    /// The bytes make no sense as a tag.
    Nonsense,
}
