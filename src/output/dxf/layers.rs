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
        // The number that the next layer of each name gets.
        let mut next: FxHashMap<String, u32> = FxHashMap::default();
        let list = sheet
            .layers
            .iter()
            .map(|layer| {
                let name = written(&layer.name);
                let small = written(&layer.name.chars().map(lower).collect::<String>());
                let (mut unique, mut key) = (name.clone(), small.clone());
                while next.contains_key(&key) {
                    let n = next.entry(small.clone()).or_insert(2);
                    (unique, key) = (numbered(&name, *n), numbered(&small, *n));
                    *n += 1;
                }
                next.insert(key, 2);
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

/// A name with a number, shortened so that both fit.
fn numbered(name: &str, n: u32) -> String {
    let number = format!("_{n}");
    let kept = name.get(..name.len().min(LONGEST - number.len())).unwrap_or(name);
    // Not in the middle of an escaped character, `\U+00DF`.
    let kept = kept.rsplit_once("\\U+").filter(|(_, code)| code.len() < 4).map_or(kept, |(before, _)| before);
    format!("{kept}{number}")
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
    use super::super::super::sheet_facts::LayerFacts;
    use super::*;
    use crate::machine::Settings;

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

    /// Each name tried all numbers from 2 on, which took a minute for 8,000 layers, and became longer than AutoCAD accepts.
    #[test]
    fn names_that_coincide_get_the_next_number() {
        let long = "x".repeat(300);
        let layer = |name: &str| LayerFacts { name: name.to_owned(), color: 1, settings: Settings::NONE };
        let names = ["a", "A", "a_2", "a", &long, &long];
        let layers = Layers::of(&SheetFacts { layers: names.map(layer).to_vec(), ..SheetFacts::default() });
        let written: Vec<&str> = layers.list.iter().map(|(name, _)| name.as_str()).collect();
        let (whole, shortened) = ("x".repeat(255), format!("{}_2", "x".repeat(253)));
        assert_eq!(written, ["a", "A_2", "a_2_2", "a_3", &whole, &shortened]);
        let many = vec![layer(&long); 8_000];
        let layers = Layers::of(&SheetFacts { layers: many, ..SheetFacts::default() });
        let escaped = vec![layer(&"\u{df}".repeat(300)); 100];
        let list = Layers::of(&SheetFacts { layers: escaped, ..SheetFacts::default() }).list;
        assert_eq!(list[99].0, format!("{}_100", "\\U+00DF".repeat(35)));
        let last = layers.list.last().map(|(name, _)| name.as_str()).unwrap_or_default();
        assert!(last.len() == 255 && last.ends_with("x_8000"), "{last}");
    }
}
