//! Tags: the pairs of group code and value that every DXF consists of, ASCII or binary.
//!
//! The group code determines the type of its value ("Group Code Value Types Reference", DXF reference, Autodesk).
//! Values borrow from the file; numbers are parsed once, here.

use super::number;

/// Type of the value of a group code.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum ValueType {
    /// Group 0, which starts an entity, table, section or block.
    Keyword,
    /// Any text, including handles and binary data in hexadecimal digits.
    Text,
    /// A finite real number.
    Real,
    /// A whole number.
    Int,
    /// The type of a code that no release of DXF defines.
    Unknown,
}

/// The type of the value that follows group code `code`.
pub(super) fn value_type(code: i32) -> ValueType {
    match code {
        0 => ValueType::Keyword,
        10..=59 | 110..=149 | 210..=239 | 460..=469 | 1010..=1059 => ValueType::Real,
        60..=79
        | 90..=99
        | 160..=179
        | 270..=299
        | 370..=389
        | 400..=409
        | 420..=429
        | 440..=459
        | 1060..=1071 => ValueType::Int,
        -5..=9 | 100..=102 | 105 | 300..=369 | 390..=399 | 410..=419 | 430..=439 | 470..=481 | 999..=1009 => {
            ValueType::Text
        }
        _ => ValueType::Unknown,
    }
}

/// A value as read from the file.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Value<'a> {
    /// Text as in the file, without surrounding white space, not decoded.
    Text(&'a [u8]),
    /// A finite real number.
    Real(f64),
    /// A whole number.
    Int(i64),
    /// A value of another type than the group code requires.
    Bad,
}

/// One group code with its value.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Tag<'a> {
    /// Group code.
    pub(super) code: i32,
    /// Its value.
    pub(super) value: Value<'a>,
    /// Whether something between the previous tag and this one could not be read.
    pub(super) after_break: bool,
    /// Whether the tag was reconstructed: its value is bad, or its code was missing.
    pub(super) repaired: bool,
}

impl<'a> Tag<'a> {
    /// A tag that was read without trouble.
    pub(super) fn sound(code: i32, value: Value<'a>) -> Self {
        Self { code, value, after_break: false, repaired: false }
    }

    /// The keyword of a group 0; empty when it could not be read.
    pub(super) fn keyword(&self) -> Option<&'a [u8]> {
        match (self.code, self.value) {
            (0, Value::Text(t)) => Some(t),
            (0, _) => Some(b""),
            _ => None,
        }
    }

    /// The value as a real number.
    pub(super) fn real(&self) -> Option<f64> {
        match self.value {
            Value::Real(v) => Some(v),
            Value::Int(v) =>
            {
                #[expect(clippy::cast_precision_loss, reason = "flags and counts, far below 2^53")]
                Some(v as f64)
            }
            _ => None,
        }
    }

    /// The value as a whole number.
    pub(super) fn int(&self) -> Option<i64> {
        match self.value {
            Value::Int(v) => Some(v),
            _ => None,
        }
    }

    /// The value as text.
    pub(super) fn text(&self) -> Option<&'a [u8]> {
        match self.value {
            Value::Text(t) => Some(t),
            _ => None,
        }
    }
}

/// Parses `text` as the value of group code `code`; `None` when it does not have the code's type.
pub(super) fn value_of(code: i32, text: &[u8]) -> Option<Value<'_>> {
    match value_type(code) {
        ValueType::Keyword => is_keyword(text).then_some(Value::Text(text)),
        ValueType::Text | ValueType::Unknown => Some(Value::Text(text)),
        ValueType::Real => number::real(text).map(Value::Real),
        ValueType::Int => number::int(text).map(Value::Int),
    }
}

/// Whether the text can follow a group 0: one word with at least one letter (`LINE`, `3DFACE`, `ACAD_TABLE`).
pub(super) fn is_keyword(text: &[u8]) -> bool {
    let word = |b: &u8| b.is_ascii_alphanumeric() || matches!(b, b'_' | b'-' | b'.' | b':' | b'$' | b'*');
    text.iter().all(word) && text.iter().any(u8::is_ascii_alphabetic)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn values_follow_their_code() {
        assert_eq!(value_of(10, b"1.5"), Some(Value::Real(1.5)));
        assert_eq!(value_of(70, b"65"), Some(Value::Int(65)));
        assert_eq!(value_of(8, b"65"), Some(Value::Text(b"65")));
        assert_eq!(value_of(10, b"LINE"), None);
        assert_eq!(value_of(0, b"3DFACE"), Some(Value::Text(b"3DFACE")));
        assert_eq!(value_of(0, b"30"), None);
        assert_eq!(value_of(0, b""), None);
    }
}
