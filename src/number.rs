//! Writes numbers in the same way in sentences and in every format: fixed decimals, no trailing zeros, a decimal point, no
//! exponent, no "-0".
//!
//! The digits come from the standard library's exact decimal formatting, so they are the same on every target.

use std::fmt::{self, Display};

/// A number that is formatted with at most `decimals` decimals.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Fixed {
    value: f64,
    decimals: usize,
}

/// `value` with at most `decimals` decimals: `fixed(2.50, 3)` reads `2.5`, `fixed(-0.0001, 3)` reads `0`.
pub(crate) fn fixed(value: f64, decimals: usize) -> Fixed {
    debug_assert!(value.is_finite(), "a number without a decimal form is to be written");
    Fixed { value, decimals }
}

/// Ten to the power of a number of decimals: the points of the grid in one unit.
pub(crate) fn power_of_ten(decimals: u32) -> f64 {
    (0..decimals).fold(1.0, |n, _| n * 10.0)
}

impl Display for Fixed {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let digits = format!("{:.*}", self.decimals, self.value);
        let short = if digits.contains('.') {
            digits.trim_end_matches('0').trim_end_matches('.')
        } else {
            digits.as_str()
        };
        f.write_str(if short == "-0" { "0" } else { short })
    }
}

#[cfg(test)]
mod tests {
    use super::fixed;

    #[test]
    fn trims_zeros_and_never_writes_minus_zero_or_an_exponent() {
        let text = |v: f64, d: usize| fixed(v, d).to_string();
        assert_eq!(text(2.5, 3), "2.5");
        assert_eq!(text(100.0, 0), "100");
        assert_eq!(text(100.0, 3), "100");
        assert_eq!(text(-0.0004, 3), "0");
        assert_eq!(text(-0.0006, 3), "-0.001");
        assert_eq!(text(-0.0, 3), "0");
        assert_eq!(text(1e9, 3), "1000000000");
        assert_eq!(text(1e-9, 3), "0");
        assert_eq!(text(0.1 + 0.2, 10), "0.3");
    }
}
