//! Numbers and separators of attribute values: path data, points, transforms, lengths.
//!
//! SVG writes numbers without blanks where that is unambiguous (`1.5.5-2e3` is three numbers), so numbers are scanned
//! from a text instead of being split at blanks.

use lexical_parse_float::FromLexical;

/// Powers of ten that doubles represent exactly.
const POWERS: [f64; 23] = [
    1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18,
    1e19, 1e20, 1e21, 1e22,
];

/// Reads a text from its start.
#[derive(Clone, Copy, Debug)]
pub(super) struct Scanner<'a> {
    bytes: &'a [u8],
    at: usize,
}

impl<'a> Scanner<'a> {
    pub(super) fn new(text: &'a str) -> Self {
        Self { bytes: text.as_bytes(), at: 0 }
    }

    /// The next byte.
    pub(super) fn peek(&self) -> Option<u8> {
        self.bytes.get(self.at).copied()
    }

    /// Skips one byte.
    pub(super) fn advance(&mut self) {
        self.at += 1;
    }

    /// Skips white space.
    pub(super) fn skip_blanks(&mut self) {
        while matches!(self.peek(), Some(b' ' | b'\n' | b'\r' | b'\t' | 0x0C)) {
            self.at += 1;
        }
    }

    /// Skips white space with at most one comma.
    pub(super) fn skip_separator(&mut self) {
        self.skip_blanks();
        if self.peek() == Some(b',') {
            self.at += 1;
            self.skip_blanks();
        }
    }

    /// Skips this byte, if it is next.
    pub(super) fn accept(&mut self, byte: u8) -> bool {
        let is_next = self.peek() == Some(byte);
        self.at += usize::from(is_next);
        is_next
    }

    /// What has not been read.
    pub(super) fn rest(&self) -> &'a [u8] {
        self.bytes.get(self.at..).unwrap_or_default()
    }

    /// A name: letters and hyphens.
    pub(super) fn name(&mut self) -> &'a [u8] {
        let rest = self.rest();
        let length = rest.iter().position(|b| !b.is_ascii_alphabetic() && *b != b'-').unwrap_or(rest.len());
        self.at += length;
        rest.get(..length).unwrap_or_default()
    }

    /// A finite number. Where there is none, nothing is read.
    pub(super) fn number(&mut self) -> Option<f64> {
        let start = self.at;
        let number = self.scanned_number();
        if number.is_none() {
            self.at = start;
        }
        number
    }

    /// A number after a separator.
    pub(super) fn next_number(&mut self) -> Option<f64> {
        self.skip_separator();
        self.number()
    }

    /// The flag of an arc, 0 or 1, after which no separator is needed.
    pub(super) fn next_flag(&mut self) -> Option<bool> {
        self.skip_separator();
        let flag = match self.peek()? {
            b'0' => false,
            b'1' => true,
            _ => return None,
        };
        self.at += 1;
        Some(flag)
    }

    fn scanned_number(&mut self) -> Option<f64> {
        let start = self.at;
        let negative = self.accept(b'-');
        if !negative {
            self.accept(b'+');
        }
        let mut digits = Digits::default();
        self.digits(&mut digits);
        let whole = digits.count;
        if self.accept(b'.') {
            self.digits(&mut digits);
        }
        if digits.count == 0 {
            return None;
        }
        let decimals = digits.count - whole;
        let exponent = self.exponent();
        let fraction = i64::try_from(decimals).ok()?;
        // A product or quotient of two exact doubles is rounded once, so it is the nearest double (W. D. Clinger, "How to
        // read floating point numbers accurately", 1990).
        let power = exponent - fraction;
        let exact = POWERS.get(usize::try_from(power.abs()).unwrap_or(usize::MAX));
        let value = match exact {
            Some(p) if digits.significant <= 15 => {
                let mantissa = digits.value as f64;
                let value = if power < 0 { mantissa / p } else { mantissa * p };
                if negative { -value } else { value }
            }
            _ => f64::from_lexical(self.bytes.get(start..self.at)?).ok()?,
        };
        value.is_finite().then_some(value)
    }

    fn digits(&mut self, digits: &mut Digits) {
        while let Some(b @ b'0'..=b'9') = self.peek() {
            digits.push(b - b'0');
            self.at += 1;
        }
    }

    /// An exponent. In `2em` there is none.
    fn exponent(&mut self) -> i64 {
        let start = self.at;
        if self.accept(b'e') || self.accept(b'E') {
            let negative = self.accept(b'-');
            if !negative {
                self.accept(b'+');
            }
            if matches!(self.peek(), Some(b'0'..=b'9')) {
                let mut exponent = 0_i64;
                while let Some(b @ b'0'..=b'9') = self.peek() {
                    exponent = (exponent * 10 + i64::from(b - b'0')).min(100_000);
                    self.at += 1;
                }
                return if negative { -exponent } else { exponent };
            }
        }
        self.at = start;
        0
    }
}

/// The digits of a number.
#[derive(Default)]
struct Digits {
    count: usize,
    /// Digits after leading zeros.
    significant: usize,
    value: u64,
}

impl Digits {
    fn push(&mut self, digit: u8) {
        self.count += 1;
        if self.significant > 0 || digit > 0 {
            self.significant += 1;
            // Only read where there are at most fifteen digits.
            self.value = self.value.wrapping_mul(10).wrapping_add(u64::from(digit));
        }
    }
}

/// All numbers of a list, up to the first thing that is not one.
pub(super) fn list(text: &str) -> impl Iterator<Item = f64> + '_ {
    let mut scanner = Scanner::new(text);
    std::iter::from_fn(move || scanner.next_number())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn numbers(text: &str) -> Vec<f64> {
        list(text).collect()
    }

    #[test]
    fn numbers_need_no_blanks_between_them() {
        assert_eq!(numbers("1.5.5-2e3+4"), [1.5, 0.5, -2000.0, 4.0]);
        assert_eq!(numbers("0.25,-.5\n7. 1E-2"), [0.25, -0.5, 7.0, 0.01]);
        assert_eq!(numbers("1,,2"), [1.0]);
        assert_eq!(numbers("1 nan 2"), [1.0]);
        assert_eq!(numbers("1e999"), [0.0; 0]);
        assert_eq!(numbers("-"), [0.0; 0]);
    }

    #[test]
    fn an_em_is_a_unit_and_not_an_exponent() {
        let mut scanner = Scanner::new("2em");
        assert_eq!(scanner.number(), Some(2.0));
        assert_eq!(scanner.name(), b"em");
    }

    #[test]
    fn rounds_to_the_nearest_double() {
        let mut state = 1_u64;
        let mut random = || {
            state = state.wrapping_mul(0x5851_F42D_4C95_7F2D).wrapping_add(0x1405_7B7E_F767_814F);
            state >> 11
        };
        for _ in 0..20_000 {
            let (whole, decimals) = (random() % 100_000, random() % 1_000_000_000);
            for text in [
                format!("{whole}.{decimals}"),
                format!("-0.000{decimals}e{}", random() % 40),
                format!("{whole}{decimals}{whole}.{decimals}e-{}", random() % 300),
                format!("{:e}", f64::from_bits(random() << 10)),
            ] {
                let expected = text.parse::<f64>().ok().filter(|v| v.is_finite());
                let value = Scanner::new(&text).number();
                assert_eq!(value.map(f64::to_bits), expected.map(f64::to_bits), "{text}");
            }
        }
    }
}
