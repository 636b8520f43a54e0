//! Colours: hexadecimal, `rgb()`, `hsl()` and names.

use super::color_names::NAMES;
use super::numbers::Scanner;

/// Red, green and blue.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub(super) struct Rgb(pub(super) [u8; 3]);

impl Rgb {
    pub(super) const BLACK: Self = Self([0; 3]);

    /// `#ff0000`.
    pub(super) fn hex(self) -> String {
        let [r, g, b] = self.0;
        format!("#{r:02x}{g:02x}{b:02x}")
    }

    /// The AutoCAD colour index whose colour is nearest, among the nine that every program shows alike.
    pub(super) fn nearest_index(self) -> i16 {
        const INDICES: [(i16, [u8; 3]); 9] = [
            (1, [255, 0, 0]),
            (2, [255, 255, 0]),
            (3, [0, 255, 0]),
            (4, [0, 255, 255]),
            (5, [0, 0, 255]),
            (6, [255, 0, 255]),
            // White on a dark background, black on a light one.
            (7, [0, 0, 0]),
            (7, [255, 255, 255]),
            (8, [128, 128, 128]),
        ];
        let distance = |other: [u8; 3]| -> i32 {
            self.0
                .iter()
                .zip(other)
                .map(|(a, b)| (i32::from(*a) - i32::from(b)) * (i32::from(*a) - i32::from(b)))
                .sum()
        };
        INDICES.iter().min_by_key(|(_, rgb)| distance(*rgb)).map_or(7, |(index, _)| *index)
    }
}

/// A colour and whether anything of it is visible; `None` if the text is no colour.
pub(super) fn read(text: &str) -> Option<(Rgb, bool)> {
    // SVG 1.1 allows the same colour in a profile after it, as Inkscape writes it.
    let text = text.split_once("icc-color(").map_or(text, |(color, _)| color.trim_end());
    if let Some(digits) = text.strip_prefix('#') {
        return hexadecimal(digits);
    }
    if let Some((function, arguments)) = text.split_once('(') {
        return from_function(&function.trim().to_ascii_lowercase(), arguments);
    }
    if text.eq_ignore_ascii_case("transparent") {
        return Some((Rgb::BLACK, false));
    }
    let name = text.to_ascii_lowercase();
    let at = NAMES.binary_search_by(|(n, _)| n.cmp(&name.as_str())).ok()?;
    NAMES.get(at).map(|(_, rgb)| {
        let [_, r, g, b] = rgb.to_be_bytes();
        (Rgb([r, g, b]), true)
    })
}

fn hexadecimal(digits: &str) -> Option<(Rgb, bool)> {
    let values: Vec<u8> =
        digits.chars().map(|c| c.to_digit(16).and_then(|d| u8::try_from(d).ok())).collect::<Option<_>>()?;
    let (rgb, alpha) = match *values.as_slice() {
        [r, g, b] => ([r * 17, g * 17, b * 17], 15),
        [r, g, b, a] => ([r * 17, g * 17, b * 17], a),
        [r, r2, g, g2, b, b2] => ([r * 16 + r2, g * 16 + g2, b * 16 + b2], 15),
        [r, r2, g, g2, b, b2, a, a2] => ([r * 16 + r2, g * 16 + g2, b * 16 + b2], a | a2),
        _ => return None,
    };
    Some((Rgb(rgb), alpha > 0))
}

fn from_function(function: &str, arguments: &str) -> Option<(Rgb, bool)> {
    let mut scanner = Scanner::new(arguments);
    let mut values = [(0.0, false); 4];
    let mut count = 0;
    loop {
        scanner.skip_separator();
        if scanner.accept(b'/') {
            scanner.skip_blanks();
        }
        if scanner.accept(b')') {
            break;
        }
        let number = scanner.number()?;
        let percent = scanner.accept(b'%');
        scanner.name();
        *values.get_mut(count)? = (number, percent);
        count += 1;
    }
    if count < 3 {
        return None;
    }
    let visible = count < 4 || values[3].0 > 0.0;
    let rgb = if function.starts_with("rgb") {
        let channel = |(v, percent): (f64, bool)| if percent { v * 2.55 } else { v };
        [values[0], values[1], values[2]].map(channel)
    } else if function.starts_with("hsl") {
        from_hsl(values[0].0, values[1].0 / 100.0, values[2].0 / 100.0)
    } else {
        return None;
    };
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "clamped to a byte")]
    Some((Rgb(rgb.map(|v| v.round().clamp(0.0, 255.0) as u8)), visible))
}

/// Channels from 0 to 255 of a hue in degrees, and saturation and lightness from 0 to 1.
fn from_hsl(hue: f64, saturation: f64, lightness: f64) -> [f64; 3] {
    let amplitude = saturation.clamp(0.0, 1.0) * lightness.min(1.0 - lightness);
    [0.0, 8.0, 4.0].map(|n| {
        let k = (n + hue / 30.0).rem_euclid(12.0);
        255.0 * (lightness - amplitude * (k - 3.0).min(9.0 - k).clamp(-1.0, 1.0))
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_way_to_write_a_colour() {
        let hex = |text: &str| read(text).map(|(c, visible)| (c.hex(), visible));
        for text in [
            "red",
            "Red",
            "#f00",
            "#FF0000",
            "#f00f",
            "rgb(255,0,0)",
            "rgb(100% 0% 0%)",
            "rgba(255, 0, 0, 0.5)",
            "hsl(0, 100%, 50%)",
            "hsl(0deg 100% 50% / 1)",
            "RGB(255, 0, 0)",
            "#ff0000 icc-color(sRGB, 1, 0, 0)",
            "red icc-color(sRGB, 1, 0, 0)",
        ] {
            assert_eq!(hex(text), Some(("#ff0000".to_owned(), true)), "{text}");
        }
        assert_eq!(hex("lightgoldenrodyellow"), Some(("#fafad2".to_owned(), true)));
        for text in ["transparent", "#ff000000", "rgba(1,2,3,0)", "#f000"] {
            assert_eq!(read(text).map(|c| c.1), Some(false), "{text}");
        }
        for text in ["", "reddish", "#ff", "#gggggg", "rgb(1,2)", "rgb(1,2,3", "lab(1 2 3)", "#é"] {
            assert_eq!(read(text), None, "{text}");
        }
        assert!(NAMES.is_sorted());
    }

    #[test]
    fn nearest_index_of_a_palette() {
        assert_eq!(read("#fe0203").unwrap().0.nearest_index(), 1);
        assert_eq!(read("black").unwrap().0.nearest_index(), 7);
        assert_eq!(read("white").unwrap().0.nearest_index(), 7);
        assert_eq!(read("navy").unwrap().0.nearest_index(), 5);
    }
}
