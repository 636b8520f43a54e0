//! Numbers as real files write them.
//!
//! Besides plain decimals, these are accepted: a decimal comma (`12,5`), a blank or a missing plus in the exponent
//! (`1.0E 20`), and the Fortran exponent letter (`1.5D3`). Values that are not finite are rejected: `nan`, `inf`,
//! `1.#QNAN`, `1e999`.
//!
//! Numbers are parsed by `lexical-parse-float`, which rounds to the nearest double like the standard library. It works
//! without the library's table of powers, which saves 8.4 kB of gzipped wasm.

use lexical_parse_float::FromLexical;

/// A finite real number; `None` for any other text.
pub(super) fn real(text: &[u8]) -> Option<f64> {
    let plain = std::str::from_utf8(text).ok()?;
    // The parser also accepts `nan` and `infinity`; the filter below removes them.
    let value = f64::from_lexical(plain.as_bytes()).ok().or_else(|| repaired(plain));
    value.filter(|v| v.is_finite())
}

/// Parses the few numbers that need one of the repairs above.
fn repaired(text: &str) -> Option<f64> {
    // Longer texts than any program writes for a number are not repaired, which bounds the work.
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
    f64::from_lexical(repaired.as_bytes()).ok()
}

/// A whole number, possibly written as a real without a fraction (`1.0`), as some programs write flags.
pub(super) fn int(text: &[u8]) -> Option<i64> {
    let plain = std::str::from_utf8(text).ok()?;
    if let Ok(value) = plain.parse::<i64>() {
        return Some(value);
    }
    let value = real(text)?;
    // Doubles represent whole numbers exactly up to 2^53; flags and counts stay far below.
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

    /// Compares random digits, printed doubles and midpoints between doubles with the standard library.
    #[test]
    fn rounds_to_the_nearest_double() {
        let same = |text: &str| {
            let expected = text.parse::<f64>().ok().filter(|v| v.is_finite());
            assert_eq!(real(text.as_bytes()).map(f64::to_bits), expected.map(f64::to_bits), "{text}");
        };
        let mut rng = 1_u64;
        let mut roll = || {
            rng = rng.wrapping_mul(0x5851_F42D_4C95_7F2D).wrapping_add(0x1405_7B7E_F767_814F);
            rng >> 11
        };
        for _ in 0..100_000 {
            let (whole, part) = (roll() % 10_u64.pow((roll() % 16) as u32), roll());
            same(&format!("{whole}.{part:016}"));
            same(&format!("-{whole}.{}", part % 1_000_000));
            same(&format!("{whole}{part}.{part}e{}", roll() % 300));
            same(&format!("+{whole}.{part}E-{:02}", roll() % 345));
            let value = f64::from_bits(roll() << 11 ^ roll());
            if value.is_finite() {
                same(&value.to_string());
                same(&format!("{value:e}"));
                same(&format!("{value:.40e}"));
            }
        }
        // Midpoints between two doubles round to the even one; the smallest increase above them rounds up.
        for k in 0..200_u64 {
            let half = (1 << 53) + 2 * k + 1;
            same(&half.to_string());
            same(&format!("{half}.{:0>300}1", ""));
            same(&format!("{half}e22"));
        }
        // The smallest and the largest doubles.
        let extreme = "5e-324 2.4703282292062327e-324 2.4703282292062328e-324 2.2250738585072011e-308 1e-400 -0 \
            1.7976931348623157e308 1.7976931348623158e308 1.7976931348623159e308";
        let unusual = "1.e5 .5e1 -.5 +7. . -. e5 1e 1e+ --1 1e5.0 1_0 00012.50";
        extreme.split(' ').chain(unusual.split(' ')).for_each(same);
    }

    #[test]
    fn decimal_comma() {
        assert_eq!(real(b"12,5"), Some(12.5));
        assert_eq!(real(b"1,2,3"), None);
        assert_eq!(real(b"1.234,5"), None, "thousands separators are ambiguous");
    }

    #[test]
    fn exponent_with_a_blank_or_the_letter_d() {
        assert_eq!(real(b"1.0E 20"), Some(1e20));
        assert_eq!(real(b"1.5D3"), Some(1500.0));
        assert_eq!(real(b"1 2"), None, "blanks between digits are damage");
    }

    #[test]
    fn non_finite_values_are_rejected() {
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
