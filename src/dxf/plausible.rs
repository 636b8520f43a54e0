//! Tests that show whether a reader is in sync: group codes, values, and keywords that start a part of the file.

use super::tag::{ValueType, value_of, value_type};

/// Parses a group code: a whole number from -5 to 32,767 alone on its line.
pub(super) fn group_code(text: &[u8]) -> Option<i32> {
    let (sign, digits) = match text {
        [b'-', rest @ ..] => (-1, rest),
        _ => (1, text),
    };
    if digits.is_empty() || digits.len() > 5 {
        return None;
    }
    let mut code = 0i32;
    for b in digits {
        if !b.is_ascii_digit() {
            return None;
        }
        code = code * 10 + i32::from(b - b'0');
    }
    let code = sign * code;
    (-5..=i32::from(i16::MAX)).contains(&code).then_some(code)
}

/// Whether a pair looks like one that a reader in sync would see. This is stricter than reading.
pub(super) fn is_plausible(code: i32, value: &[u8]) -> bool {
    let hex = |text: &[u8]| !text.is_empty() && text.len() <= 16 && text.iter().all(u8::is_ascii_hexdigit);
    match code {
        5 | 105 | 320..=369 | 390..=399 => hex(value),
        100 => value.first().is_some_and(u8::is_ascii_alphabetic),
        102 => value.first() == Some(&b'{') || value == b"}",
        _ => value_type(code) != ValueType::Unknown && value_of(code, value).is_some(),
    }
}

/// Keywords that start or end a part of the file, or a common entity. They are enough to resynchronise.
pub(super) fn is_structure(text: &[u8]) -> bool {
    const WORDS: [&[u8]; 32] = [
        b"SECTION",
        b"ENDSEC",
        b"EOF",
        b"TABLE",
        b"ENDTAB",
        b"BLOCK",
        b"ENDBLK",
        b"LAYER",
        b"LTYPE",
        b"STYLE",
        b"BLOCK_RECORD",
        b"LINE",
        b"CIRCLE",
        b"ARC",
        b"LWPOLYLINE",
        b"POLYLINE",
        b"VERTEX",
        b"SEQEND",
        b"ELLIPSE",
        b"SPLINE",
        b"INSERT",
        b"HATCH",
        b"SOLID",
        b"TRACE",
        b"3DFACE",
        b"POINT",
        b"TEXT",
        b"MTEXT",
        b"DIMENSION",
        b"ATTRIB",
        b"LEADER",
        b"VIEWPORT",
    ];
    WORDS.contains(&text)
}

/// Whether the line is a conflict marker of a version control system.
pub(super) fn is_conflict_marker(text: &[u8]) -> bool {
    [&b"<<<<<<<"[..], b"=======", b">>>>>>>", b"|||||||"].iter().any(|m| text.starts_with(m))
}
