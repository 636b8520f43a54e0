//! What the name of a layer suggests.
//!
//! A name is split into words at everything that is no letter, at digits and where lower case turns upper; a word
//! counts only as a whole, so MARKET, TEXTURE or CENTERPIECE suggest nothing. A word that says *cut* outweighs all
//! others: CUT_FRAME is cut.

use super::model::Operation;

/// Cut in the tongues that drawings come in: such a layer means what it says.
const CUT: &[&str] =
    &["CUT", "CUTS", "CUTTING", "LASERCUT", "SCHNITT", "SCHNEIDEN", "DECOUPE", "TAGLIO", "CORTE"];
/// To be marked or engraved.
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
/// Not to be cut: the sheet, and lines that explain the drawing.
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
    "BEND",
    "BENDS",
    "BENDLINE",
    "BENDLINES",
    "BIEGELINIE",
    "BIEGELINIEN",
];

/// What is probably to be done with a layer of that name; `None` when the name says nothing.
pub(super) fn suggestion(name: &str) -> Option<Operation> {
    let words = words(name);
    let any = |list: &[&str]| words.iter().any(|w| list.contains(&w.as_str()));
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

/// The words of a name, in upper case.
fn words(name: &str) -> Vec<String> {
    let mut words = vec![String::new()];
    let mut lower_before = false;
    for c in name.chars() {
        let boundary = !c.is_alphabetic() || (lower_before && c.is_uppercase());
        if boundary && words.last().is_some_and(|w| !w.is_empty()) {
            words.push(String::new());
        }
        if let (true, Some(word)) = (c.is_alphabetic(), words.last_mut()) {
            // Capital sharp s would become SS; the list holds it as written.
            if c == 'ß' { word.push(c) } else { word.extend(c.to_uppercase()) }
        }
        lower_before = c.is_lowercase();
    }
    words
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn whole_words_count_and_parts_of_words_do_not() {
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
