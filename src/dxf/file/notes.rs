//! Findings on places where a file is broken, and on its end.

use super::contents::File;
use crate::dxf::breaks::BreakKind;
use crate::dxf::record::Record;
use crate::dxf::report::Note;
use crate::dxf::tokens::Tokens;
use crate::finding::{Code, Severity};

/// Notes the places where the file is broken that were found since the last time. `record`: the one they are in.
pub(super) fn note_breaks<'a>(tokens: &mut Tokens<'a>, file: &mut File<'a>, record: Option<&Record<'a>>) {
    for b in tokens.take_breaks() {
        let (word, place) = (tokens.place_word(), b.place);
        let (code, text) = match b.kind {
            BreakKind::OutOfSync => (
                Code::Resynchronised,
                format!(
                    "The file is broken near {word} {place}: lines are missing, doubled or swapped. Reading went on at the next sound place."
                ),
            ),
            BreakKind::BadValue => {
                (Code::BadNumber, format!("Near {word} {place} there is no number where one must be."))
            }
            BreakKind::MergeConflict => (
                Code::Resynchronised,
                format!(
                    "The file holds an unresolved merge conflict at {word} {place}: both versions are read. Resolve it and load the file again."
                ),
            ),
        };
        file.notes.push(Note {
            layer: record.and_then(|r| r.layer).map(|name| file.layers.index(name)),
            handle: record.and_then(|r| r.handle),
            ..Note::new(code, Severity::Warning, text)
        });
    }
}

/// Notes a file that does not end as it should. `ended`: whether its end mark was read.
pub(super) fn note_end(tokens: &Tokens<'_>, ended: bool, file: &mut File<'_>) {
    let text = if ended {
        if !tokens.has_more() {
            return;
        }
        "Text after the end mark of the file was not read."
    } else if tokens.cut_off() {
        "The file ends in the middle: it was probably not copied whole. What comes after is missing."
    } else {
        "The file ends without its end mark: it may not have been copied whole. Check that nothing is missing."
    };
    let severity = if ended { Severity::Info } else { Severity::Warning };
    file.notes.push(Note::new(Code::Truncated, severity, text));
}
