//! Numbers as real files write them.
//!
//! Beside plain decimals: a decimal comma (`12,5`), a blank or a missing plus in the exponent (`1.0E 20`), the
//! Fortran exponent letter (`1.5D3`). What is not finite is no number: `nan`, `inf`, `1.#QNAN`, `1e999`.

/// A finite real number; `None` for anything else.
pub(super) fn real(text: &[u8]) -> Option<f64> {
    let plain = std::str::from_utf8(text).ok()?;
    // `parse` also reads words (`nan`, `infinity`): their first letter gives them away, and so does the result.
    let value = plain.parse::<f64>().ok().or_else(|| repaired(plain));
    value.filter(|v| v.is_finite())
}

/// The number after the repairs above, for the few that do not parse as they stand.
fn repaired(text: &str) -> Option<f64> {
    // Longer than any number a program writes: not worth repairing, and a bound on the work.
    const LONGEST: usize = 64;
    if text.len() > LONGEST || !text.bytes().any(|b| b.is_ascii_digit()) {
        return None;
    }
    let mut repaired = String::with_capacity(text.len());
    let mut in_exponent = false;
    for b in text.bytes() {
        match b {
            b'0'..=b'9' | b'+' | b'-' | b'.' => repaired.push(char::from(b)),
            b',' => repaired.push('.'),
            b'e' | b'E' | b'd' | b'D' if !in_exponent => {
                in_exponent = true;
                repaired.push('e');
            }
            b' ' if in_exponent => {}
            _ => return None,
        }
    }
    repaired.parse().ok()
}

/// A whole number; also one written as a real without a fraction (`1.0`), as some programs do for flags.
pub(super) fn int(text: &[u8]) -> Option<i64> {
    let plain = std::str::from_utf8(text).ok()?;
    if let Ok(value) = plain.parse::<i64>() {
        return Some(value);
    }
    let value = real(text)?;
    // Doubles hold whole numbers exactly up to 2^53; flags and counts stay far below.
    let whole = value.fract().abs() < f64::MIN_POSITIVE && value.abs() < 9.0e15;
    #[expect(clippy::cast_possible_truncation, reason = "whole and below 2^53")]
    whole.then_some(value as i64)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn plain_numbers() {
        assert_eq!(real(b"12.5"), Some(12.5));
        assert_eq!(real(b"-0.25e-3"), Some(-0.00025));
        assert_eq!(real(b".5"), Some(0.5));
        assert_eq!(real(b"7."), Some(7.0));
        assert_eq!(int(b"-3"), Some(-3));
    }

    #[test]
    fn decimal_comma() {
        assert_eq!(real(b"12,5"), Some(12.5));
        assert_eq!(real(b"1,2,3"), None);
        assert_eq!(real(b"1.234,5"), None, "thousands separators are ambiguous");
    }

    #[test]
    fn exponent_with_a_blank_or_a_d() {
        assert_eq!(real(b"1.0E 20"), Some(1e20));
        assert_eq!(real(b"1.5D3"), Some(1500.0));
        assert_eq!(real(b"1 2"), None, "blanks between digits are damage");
    }

    #[test]
    fn what_is_not_finite_is_no_number() {
        for text in
            ["nan", "NaN", "inf", "-Infinity", "1.#QNAN", "1.#INF", "1e999", "", " ", "-", "1O.5", "0x10"]
        {
            assert_eq!(real(text.as_bytes()), None, "{text}");
        }
    }

    #[test]
    fn whole_numbers_written_as_reals() {
        assert_eq!(int(b"1.0"), Some(1));
        assert_eq!(int(b"1.5"), None);
        assert_eq!(int(b"1e300"), None);
    }
}
