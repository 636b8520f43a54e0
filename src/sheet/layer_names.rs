//! What the name of a layer suggests about its operation.
//!
//! A name is divided into words at everything that is not a letter, at digits, and where lower case changes to upper.
//! Only whole words count, so MARKET, TEXTURE or CENTERPIECE suggest nothing. A word for *cut* outweighs all others:
//! CUT_FRAME is cut.

use super::model::Operation;
use crate::letters::{lower, same_letters};

/// Words for cutting in the common languages of drawings.
const CUT: &[&str] =
    &["CUT", "CUTS", "CUTTING", "LASERCUT", "SCHNITT", "SCHNEIDEN", "DECOUPE", "DÉCOUPE", "TAGLIO", "CORTE"];
/// Words for marking or engraving.
const MARK: &[&str] = &[
    "MARK",
    "MARKS",
    "MARKING",
    "MARKINGS",
    "ENGRAVE",
    "ENGRAVED",
    "ENGRAVING",
    "ENGRAVINGS",
    "ETCH",
    "ETCHED",
    "ETCHING",
    "SCORE",
    "SCORING",
    "SCRIBE",
    "GRAVUR",
    "GRAVUREN",
    "GRAVIEREN",
    "GRAVURE",
    "TEXT",
    "TEXTE",
    "TEXTS",
    "LABEL",
    "LABELS",
    "ENGRAVUR",
    "RASTER",
];
/// Words for what is not cut: the sheet, and lines that explain the drawing.
const IGNORE: &[&str] = &[
    "SHEET",
    "SHEETS",
    "BORDER",
    "BORDERS",
    "FRAME",
    "RAHMEN",
    "BLECH",
    "TAFEL",
    "STOCK",
    "MATERIAL",
    "DIM",
    "DIMS",
    "DIMENSION",
    "DIMENSIÓN",
    "DIMENSIONS",
    "BEMASSUNG",
    "BEMAßUNG",
    "COTES",
    "CONSTRUCTION",
    "KONSTRUKTION",
    "HIDDEN",
    "VERDECKT",
    "CENTER",
    "CENTERS",
    "CENTRE",
    "CENTERLINE",
    "CENTERLINES",
    "CENTRELINE",
    "MITTELLINIE",
    "MITTELLINIEN",
    "NOTE",
    "NOTES",
    "ANNOTATION",
    "ANNOTATIONS",
    "TITLE",
    "TITLEBLOCK",
    "SCHRIFTFELD",
    "VIEWPORT",
    "VIEWPORTS",
    "DEFPOINTS",
    "GUIDE",
    "GUIDES",
    "REFERENCE",
    "RÉFÉRENCE",
    "BEND",
    "BENDS",
    "BENDLINE",
    "BENDLINES",
    "BIEGELINIE",
    "BIEGELINIEN",
];

/// Words for the sheet itself.
const SHEET: &[&str] = &[
    "SHEET", "SHEETS", "BORDER", "BORDERS", "FRAME", "RAHMEN", "BLECH", "TAFEL", "STOCK", "MATERIAL", "BED",
    "PAGE",
];
/// Words for parts and their outlines.
const PART: &[&str] = &[
    "PART",
    "PARTS",
    "OUTLINE",
    "OUTLINES",
    "BOUNDARY",
    "BOUNDARIES",
    "CONTOUR",
    "CONTOURS",
    "PROFILE",
    "PROFILES",
    "OUTER",
    "OUTSIDE",
    "PERIMETER",
    "EDGE",
    "EDGES",
    "BODY",
    "KONTUR",
    "KONTUREN",
    "UMRISS",
    "TEIL",
    "TEILE",
    "CONTORNO",
];

/// Whether a layer's name says that the sheet is drawn on it. PART_FRAME and CUT_BORDER do not.
pub(super) fn names_sheet(name: &str) -> bool {
    let has = |words: &[&str]| has_word(name, words);
    has(SHEET) && !has(CUT) && !has(&["PART", "PARTS", "TEIL", "TEILE"])
}

/// Whether a layer's name says that outlines of parts are drawn on it.
pub(super) fn names_parts(name: &str) -> bool {
    !names_sheet(name) && (has_word(name, PART) || has_word(name, CUT))
}

fn has_word(name: &str, list: &[&str]) -> bool {
    words(name).iter().any(|w| list.iter().any(|l| same_letters(l, w)))
}

/// The operation that a layer's name suggests; `None` if it suggests nothing.
pub(super) fn suggestion(name: &str) -> Option<Operation> {
    let any = |list: &[&str]| has_word(name, list);
    if any(CUT) {
        None
    } else if any(IGNORE) {
        Some(Operation::Ignore)
    } else if any(MARK) {
        Some(Operation::Mark)
    } else {
        None
    }
}

/// The words of a name, in lower case.
fn words(name: &str) -> Vec<String> {
    let mut words = vec![String::new()];
    let mut lower_before = false;
    for c in name.chars() {
        let letter = c.is_ascii_alphabetic() || (c >= 'À' && c != '×' && c != '÷');
        let small = lower(c);
        let boundary = !letter || (lower_before && small != c);
        if boundary && words.last().is_some_and(|w| !w.is_empty()) {
            words.push(String::new());
        }
        if let (true, Some(word)) = (letter, words.last_mut()) {
            word.push(small);
        }
        lower_before = letter && small == c;
    }
    words
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_of_the_sheet_and_of_part_outlines() {
        for name in ["SHEET", "Sheet_Outline", "BORDER", "Rahmen", "stock", "frame-1"] {
            assert!(names_sheet(name) && !names_parts(name), "{name}");
        }
        for name in ["part_boundary", "outline", "OUTER", "Profile 1", "CUT", "cut_border", "part_frame"] {
            assert!(names_parts(name) && !names_sheet(name), "{name}");
        }
        for name in ["0", "Layer 1", "PARTITION", "HOLES"] {
            assert!(!names_parts(name) && !names_sheet(name), "{name}");
        }
    }

    #[test]
    fn only_whole_words_count() {
        for name in [
            "SHEET",
            "sheet-1",
            "Sheet_Outline",
            "BORDER",
            "Frame2",
            "Rahmen",
            "DIM",
            "HIDDEN",
            "0-CENTER",
            "bemaßung",
            "Construction Lines",
            "centerLine",
            "partFrame",
        ] {
            assert_eq!(suggestion(name), Some(Operation::Ignore), "{name}");
        }
        for name in
            ["MARK", "part marks", "Engrave", "ETCH_TOP", "Gravur", "TEXT", "textLabel", "1_Engraving"]
        {
            assert_eq!(suggestion(name), Some(Operation::Mark), "{name}");
        }
        for name in [
            "MARKET",
            "TEXTURE",
            "CENTERPIECE",
            "DIMPLE",
            "BORDERLAND",
            "0",
            "OUTLINE",
            "HOLES",
            "Layer 1",
            "CUT_FRAME",
            "cut marks",
            "",
            "___",
            "FRAMEWORK",
            "STRETCH",
            "SKETCH",
            "UNDERSCORE",
        ] {
            assert_eq!(suggestion(name), None, "{name}");
        }
    }
}
