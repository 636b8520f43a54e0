//! Numbers as real files write them.
//!
//! Beside plain decimals: a decimal comma (`12,5`), a blank or a missing plus in the exponent (`1.0E 20`), the
//! Fortran exponent letter (`1.5D3`). What is not finite is no number: `nan`, `inf`, `1.#QNAN`, `1e999`.
//!
//! Read by `lexical-parse-float`, to the nearest double as the standard library does, but without its table of powers, which
//! alone is 10 kB that does not compress: 8.4 kB gzip less wasm.

use lexical_parse_float::FromLexical;

/// A finite real number; `None` for anything else.
pub(super) fn real(text: &[u8]) -> Option<f64> {
    let plain = std::str::from_utf8(text).ok()?;
    // It also reads `nan` and `infinity`, which are no numbers: what is not finite is sorted out below.
    let value = f64::from_lexical(plain.as_bytes()).ok().or_else(|| repaired(plain));
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
    f64::from_lexical(repaired.as_bytes()).ok()
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

    /// The standard library as the oracle: digits by chance, doubles as written, halves between doubles.
    #[test]
    fn the_nearest_double() {
        let same = |text: &str| {
            let expected = text.parse::<f64>().ok().filter(|v| v.is_finite());
            assert_eq!(real(text.as_bytes()).map(f64::to_bits), expected.map(f64::to_bits), "{text}");
        };
        let mut dice = 1_u64;
        let mut roll = || {
            dice = dice.wrapping_mul(0x5851_F42D_4C95_7F2D).wrapping_add(0x1405_7B7E_F767_814F);
            dice >> 11
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
        // Halves between two doubles, and as little more as can be: to the even one, and up.
        for k in 0..200_u64 {
            let half = (1 << 53) + 2 * k + 1;
            same(&half.to_string());
            same(&format!("{half}.{:0>300}1", ""));
            same(&format!("{half}e22"));
        }
        // As small and as large as doubles go.
        let extreme = "5e-324 2.4703282292062327e-324 2.4703282292062328e-324 2.2250738585072011e-308 1e-400 -0 \
            1.7976931348623157e308 1.7976931348623158e308 1.7976931348623159e308";
        let odd = "1.e5 .5e1 -.5 +7. . -. e5 1e 1e+ --1 1e5.0 1_0 00012.50";
        extreme.split(' ').chain(odd.split(' ')).for_each(same);
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
