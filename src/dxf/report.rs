//! Findings of the reader. They are collected with undecoded names, and decoded once the encoding and all layers are
//! known.

use super::encoding::Decoder;
use super::entity::Hidden;
use crate::finding::{Code, Finding, Findings, Seen, Severity};
use glam::DVec2;
use std::collections::BTreeMap;

/// A finding whose texts are not decoded yet.
#[derive(Clone, Debug)]
pub(super) struct Note<'a> {
    /// Code for programs.
    pub(super) code: Code,
    /// Severity.
    pub(super) severity: Severity,
    /// Sentence for people, in which `{}` is replaced by `name`, or by `?` if that is empty.
    pub(super) message: String,
    /// Name used in the message, as written in the file.
    pub(super) name: &'a [u8],
    /// Index of the layer.
    pub(super) layer: Option<u32>,
    /// Handle as written.
    pub(super) handle: Option<&'a [u8]>,
    /// Position on the sheet, mm.
    pub(super) at: Option<DVec2>,
    /// Number of entities or places the note covers.
    pub(super) count: u32,
}

impl<'a> Note<'a> {
    /// A note without name, layer, handle and place.
    pub(super) fn new(code: Code, severity: Severity, message: impl Into<String>) -> Self {
        Self {
            code,
            severity,
            message: message.into(),
            name: b"",
            layer: None,
            handle: None,
            at: None,
            count: 1,
        }
    }
}

/// Number of notes of one code that are kept; the rest is only counted. It is above the number that [`Findings`] lists,
/// and bounds memory for files that are broken everywhere.
const KEPT_PER_CODE: u32 = 256;

/// Collects notes, and counts entities that occur many times.
#[derive(Debug, Default)]
pub(super) struct Notes<'a> {
    list: Vec<Note<'a>>,
    seen: Seen,
    tallies: BTreeMap<(Subject<'a>, u32), Tally<'a>>,
}

/// What is counted per layer instead of listed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Subject<'a> {
    /// Entities of a kind without an outline.
    Unsupported(&'a [u8]),
    /// Entities that are not visible.
    Hidden(Hidden),
    /// Filled areas of a kind that become their outlines.
    Outline(&'static str),
    /// Polylines of a kind that have a width.
    Wide(&'static str),
    /// Entities of a kind that are tilted against the sheet.
    Projected(&'static str),
    /// Inserts of a block that is not defined.
    MissingBlock(&'a [u8]),
    /// Inserts of a block that refers to another file.
    ExternalBlock(&'a [u8]),
    /// Inserts that show only a part of a block.
    ClippedBlock(&'a [u8]),
    /// Inserts of a block inside itself.
    CyclicBlock(&'a [u8]),
}

/// A count, with handle and position of the first one.
#[derive(Debug)]
struct Tally<'a> {
    count: u32,
    handle: Option<&'a [u8]>,
    at: Option<DVec2>,
}

impl<'a> Notes<'a> {
    /// Adds one note.
    pub(super) fn push(&mut self, note: Note<'a>) {
        if self.seen.lists(note.code, note.count, KEPT_PER_CODE) {
            self.list.push(note);
        }
    }

    /// Counts one more `subject` on a layer.
    pub(super) fn count(
        &mut self,
        subject: Subject<'a>,
        layer: u32,
        handle: Option<&'a [u8]>,
        at: Option<DVec2>,
    ) {
        let tally = self.tallies.entry((subject, layer)).or_insert(Tally { count: 0, handle, at });
        tally.count = tally.count.saturating_add(1);
    }

    /// The findings, with texts decoded by `decoder` and names from `layers`.
    pub(super) fn into_findings(
        self,
        decoder: &mut Decoder,
        layers: &[crate::drawing::Layer],
    ) -> Vec<Finding> {
        let mut findings = Findings::default();
        let overflow =
            self.seen.rests().map(|(code, rest)| Note { count: rest, ..Note::new(code, Severity::Info, "") });
        let tallies = self.tallies.into_iter().map(|((subject, layer), tally)| tally.note(subject, layer));
        for note in self.list.into_iter().chain(overflow).chain(tallies) {
            let name = if note.name.is_empty() { b"?" } else { note.name };
            let message = match note.message.split_once("{}") {
                Some((before, after)) => format!("{before}{}{after}", decoder.text(name)),
                None => note.message,
            };
            let layer = note.layer.and_then(|i| layers.get(i as usize)).map(|l| l.name.clone());
            let handle = note.handle.map(|h| decoder.text(h).into_owned());
            findings.push(Finding {
                code: note.code,
                severity: note.severity,
                message,
                layer,
                handle,
                at: note.at.filter(|p| p.is_finite()),
                count: note.count,
            });
        }
        findings.into_list()
    }
}

impl<'a> Tally<'a> {
    fn note(&self, subject: Subject<'a>, layer: u32) -> Note<'a> {
        let n = self.count;
        let (code, severity, name, message): (_, _, &[u8], String) = match subject {
            Subject::Unsupported(name) => {
                let kind = std::str::from_utf8(name).unwrap_or("");
                let advice = super::entities::advice(kind);
                let severity = if kind == "POINT" { Severity::Info } else { Severity::Warning };
                (Code::UnsupportedEntity, severity, name, format!("{n} {{}} left out: {advice}."))
            }
            Subject::Hidden(why) => {
                let (why, entities) =
                    (hidden_because(why), if n == 1 { "entity is" } else { "entities are" });
                let message = format!("{n} {entities} {why} and not cut.");
                (Code::HiddenEntity, Severity::Info, b"", message)
            }
            Subject::Outline(kind) => {
                let message = format!(
                    "The outline of {n} {kind} is taken as lines to cut; the filling is not. Where it lies on other lines it is cut once."
                );
                (Code::OutlineTaken, Severity::Info, b"", message)
            }
            Subject::Wide(kind) => {
                let message = format!("{n} {kind} drawn with a width: cut along the middle line, once.");
                (Code::OutlineTaken, Severity::Info, b"", message)
            }
            Subject::Projected(kind) => {
                let message = format!(
                    "{n} {kind} tilted against the sheet or at changing height: cut as seen from above, which may be shorter than it is."
                );
                (Code::Projected, Severity::Warning, b"", message)
            }
            Subject::MissingBlock(name) => {
                let message = format!(
                    "The block \"{{}}\" is inserted ({n}) but not in the file: its content is missing."
                );
                (Code::MissingBlock, Severity::Error, name, message)
            }
            Subject::ExternalBlock(name) => {
                let message = format!(
                    "The block \"{{}}\" ({n}) refers to another drawing file and is missing here. Bind it in the drawing program and save again."
                );
                (Code::MissingBlock, Severity::Error, name, message)
            }
            Subject::ClippedBlock(name) => {
                let message = format!(
                    "The block \"{{}}\" is clipped where it is inserted ({n}; XCLIP), but cut whole. Explode it there and trim it in the drawing program."
                );
                (Code::UnsupportedEntity, Severity::Warning, name, message)
            }
            Subject::CyclicBlock(name) => {
                let message =
                    format!("The block \"{{}}\" contains itself; the inner insert ({n}) is left out.");
                (Code::CyclicBlock, Severity::Error, name, message)
            }
        };
        Note {
            name,
            layer: Some(layer),
            handle: self.handle,
            at: self.at,
            count: n,
            ..Note::new(code, severity, message)
        }
    }
}

fn hidden_because(why: Hidden) -> &'static str {
    match why {
        Hidden::Paper => "on a paper layout",
        Hidden::Invisible => "switched invisible",
        Hidden::Frozen => "on a frozen layer",
        Hidden::Off => "on a layer that is switched off",
    }
}
