//! The dialects that come with Kerfway.

use super::model::Dialect;
use crate::fields::from_checked_json;

/// The documents, the default first.
const DOCUMENTS: [(&str, &str); 11] = [
    ("grbl-m4", include_str!("shipped/grbl-m4.json")),
    ("grbl-m3", include_str!("shipped/grbl-m3.json")),
    ("fluidnc", include_str!("shipped/fluidnc.json")),
    ("grblhal", include_str!("shipped/grblhal.json")),
    ("linuxcnc-m67", include_str!("shipped/linuxcnc-m67.json")),
    ("linuxcnc-spindle", include_str!("shipped/linuxcnc-spindle.json")),
    ("marlin-inline", include_str!("shipped/marlin-inline.json")),
    ("marlin-fan", include_str!("shipped/marlin-fan.json")),
    ("smoothie", include_str!("shipped/smoothie.json")),
    ("mach4-m67", include_str!("shipped/mach4-m67.json")),
    ("template", include_str!("shipped/template.json")),
];

/// All shipped dialects, the default first.
pub fn dialects() -> Vec<Dialect> {
    // The documents are part of the program, and a test checks each of them.
    DOCUMENTS.iter().filter_map(|(_, text)| from_checked_json(text).ok()).collect()
}

/// The shipped dialect of this name.
pub fn dialect(name: &str) -> Option<Dialect> {
    let (_, text) = DOCUMENTS.iter().find(|(known, _)| *known == name)?;
    from_checked_json(text).ok()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fields::from_json;

    #[test]
    fn every_shipped_document_is_valid_and_has_the_name_of_its_file() {
        for (name, text) in DOCUMENTS {
            let read: Dialect = from_json(text).unwrap_or_else(|e| panic!("{name}: {e}"));
            assert_eq!(read.name, name);
            assert_eq!(read.validate(), Ok(()), "{name}");
            assert_eq!(dialect(name), Some(read));
        }
        assert_eq!(dialects().len(), DOCUMENTS.len());
    }
}
