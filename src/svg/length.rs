//! Lengths with units, and what they mean in user units.

use super::numbers::Scanner;
use crate::geometry::DVec2;

/// The unit of a length.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum LengthUnit {
    /// User units.
    None,
    Px,
    Pt,
    Pc,
    Mm,
    Cm,
    Q,
    In,
    Em,
    Ex,
    Percent,
}

/// A number with a unit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Length {
    pub(super) number: f64,
    pub(super) unit: LengthUnit,
}

impl Length {
    /// Reads a length. Text after it is refused.
    pub(super) fn read(text: &str) -> Option<Self> {
        let mut scanner = Scanner::new(text);
        scanner.skip_blanks();
        let length = Self::scan(&mut scanner)?;
        scanner.skip_blanks();
        scanner.rest().is_empty().then_some(length)
    }

    /// Reads the length that comes next.
    pub(super) fn scan(scanner: &mut Scanner<'_>) -> Option<Self> {
        let number = scanner.number()?;
        let unit = if scanner.accept(b'%') {
            LengthUnit::Percent
        } else {
            match scanner.name().to_ascii_lowercase().as_slice() {
                b"" => LengthUnit::None,
                b"px" => LengthUnit::Px,
                b"pt" => LengthUnit::Pt,
                b"pc" => LengthUnit::Pc,
                b"mm" => LengthUnit::Mm,
                b"cm" => LengthUnit::Cm,
                b"q" => LengthUnit::Q,
                b"in" => LengthUnit::In,
                b"em" | b"rem" => LengthUnit::Em,
                b"ex" => LengthUnit::Ex,
                _ => return None,
            }
        };
        Some(Self { number, unit })
    }

    /// The length in mm, if its unit is one of a ruler.
    pub(super) fn millimetres(self) -> Option<f64> {
        let unit = match self.unit {
            LengthUnit::Mm => 1.0,
            LengthUnit::Cm => 10.0,
            LengthUnit::Q => 0.25,
            LengthUnit::In => 25.4,
            LengthUnit::Pt => 25.4 / 72.0,
            LengthUnit::Pc => 25.4 / 6.0,
            _ => return None,
        };
        Some(self.number * unit)
    }
}

/// What a percentage is a part of.
#[derive(Clone, Copy, Debug)]
pub(super) enum Axis {
    Width,
    Height,
    Diagonal,
}

/// What lengths mean at one place.
#[derive(Clone, Copy, Debug)]
pub(super) struct Lengths {
    /// User units per inch where a length has a unit of a ruler.
    pub(super) dpi: f64,
    /// Size of the nearest viewport, in user units.
    pub(super) viewport: DVec2,
}

/// Font size in user units where a length is in em. No laser drawing depends on it.
const FONT_SIZE: f64 = 16.0;

impl Lengths {
    /// A length in user units.
    pub(super) fn resolve(&self, length: Length, axis: Axis) -> f64 {
        if let Some(mm) = length.millimetres() {
            return mm * self.dpi / 25.4;
        }
        let whole = match axis {
            Axis::Width => self.viewport.x,
            Axis::Height => self.viewport.y,
            Axis::Diagonal => (self.viewport.length_squared() / 2.0).sqrt(),
        };
        length.number
            * match length.unit {
                LengthUnit::Percent => whole / 100.0,
                LengthUnit::Em => FONT_SIZE,
                LengthUnit::Ex => FONT_SIZE / 2.0,
                _ => 1.0,
            }
    }

    /// The length that a text says, in user units.
    pub(super) fn read(&self, text: &str, axis: Axis) -> Option<f64> {
        Length::read(text).map(|l| self.resolve(l, axis))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lengths_with_units() {
        let here = Lengths { dpi: 96.0, viewport: DVec2::new(200.0, 100.0) };
        for (text, expected) in [
            ("5", 5.0),
            (" 5px ", 5.0),
            ("1in", 96.0),
            ("25.4mm", 96.0),
            ("72pt", 96.0),
            ("6pc", 96.0),
            ("50%", 100.0),
            ("2em", 32.0),
            ("101.6Q", 96.0),
        ] {
            let value = here.read(text, Axis::Width).unwrap();
            assert!((value - expected).abs() < 1e-12, "{text}: {value}");
        }
        for text in ["", "px", "5 5", "5furlong", "auto"] {
            assert_eq!(Length::read(text), None, "{text}");
        }
    }
}
