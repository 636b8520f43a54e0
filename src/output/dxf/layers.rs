//! Layers of the sheet, with names that every DXF reader accepts.

use super::super::sheet_facts::SheetFacts;
use crate::letters::lower;
use rustc_hash::FxHashMap;
use std::fmt::Write as _;

/// Characters that AutoCAD does not allow in names, from R2000 on.
const FORBIDDEN: &str = "<>/\\\":;?*|,=`";
/// Longest name that AutoCAD accepts, in characters.
const LONGEST: usize = 255;
/// Colour 7 is white on black and black on white; it is used for layers without a colour of their own.
const DEFAULT_COLOR: i16 = 7;

/// Names and colours, by layer index of the sheet.
pub(super) struct Layers {
    list: Vec<(String, i16)>,
}

impl Layers {
    /// The layers of a sheet. Names that would coincide get a number, because DXF ignores case.
    pub(super) fn of(sheet: &SheetFacts) -> Self {
        let mut taken: FxHashMap<Vec<u8>, u32> = FxHashMap::default();
        let list = sheet
            .layers
            .iter()
            .map(|layer| {
                let name = written(&layer.name);
                let small = written(&layer.name.chars().map(lower).collect::<String>());
                let (mut unique, mut key, mut n) = (name.clone(), small.clone(), 2);
                while taken.insert(key.into_bytes(), n).is_some() {
                    (unique, key) = (format!("{name}_{n}"), format!("{small}_{n}"));
                    n += 1;
                }
                let color = if (1..=255).contains(&layer.color) { layer.color } else { DEFAULT_COLOR };
                (unique, color)
            })
            .collect();
        Self { list }
    }

    /// The name of a contour's layer in the file.
    pub(super) fn of_contour(&self, sheet: &SheetFacts, contour: u32) -> &str {
        let known = sheet.contour(contour).and_then(|c| self.list.get(c.layer as usize));
        known.map_or("0", |(name, _)| name)
    }

    /// Names and colours for the layer table: layer 0, which every drawing has, and the others.
    pub(super) fn defined(&self) -> Vec<(&str, i16)> {
        let zero = ("0", DEFAULT_COLOR);
        let named = self.list.iter().map(|(name, color)| (name.as_str(), *color));
        if self.list.iter().any(|(name, _)| name == "0") {
            named.collect()
        } else {
            std::iter::once(zero).chain(named).collect()
        }
    }
}

/// A name in its form for the file: forbidden and control characters are replaced, characters outside ASCII are
/// escaped.
fn written(name: &str) -> String {
    let mut out = String::new();
    for c in name.trim().chars() {
        let mut one = String::new();
        match c {
            c if c.is_control() || FORBIDDEN.contains(c) => one.push('_'),
            c if c.is_ascii() => one.push(c),
            c => {
                for unit in c.encode_utf16(&mut [0; 2]) {
                    let _ = write!(one, "\\U+{unit:04X}");
                }
            }
        }
        if out.len() + one.len() > LONGEST {
            break;
        }
        out.push_str(&one);
    }
    if out.is_empty() { "0".to_owned() } else { out }
}

#[cfg(test)]
mod tests {
    use super::written;

    #[test]
    fn names_are_ascii_without_forbidden_characters() {
        assert_eq!(written("Cut outer 3mm"), "Cut outer 3mm");
        assert_eq!(written(" a/b:c\n "), "a_b_c");
        assert_eq!(written("au\u{df}en"), "au\\U+00DFen");
        assert_eq!(written("\u{1f525}"), "\\U+D83D\\U+DD25");
        assert_eq!(written(""), "0");
        assert!(written(&"\u{df}".repeat(300)).len() <= 255);
        assert!(written(&"\u{df}".repeat(300)).ends_with("\\U+00DF"));
    }
}
