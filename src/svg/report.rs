//! Findings of the reader. They are counted while the drawing is walked, and named once all layers have their names.

use super::layers::{Key, Names};
use super::subject::Subject;
use crate::finding::{Code, Finding, Findings, Seen, Severity};
use crate::geometry::DVec2;
use std::collections::BTreeMap;

#[derive(Debug, Default)]
struct Tally {
    count: u32,
    handle: Option<String>,
    at: Option<DVec2>,
}

/// Number of notes that are kept; the rest is only counted. It is above the number that [`Findings`] lists.
const KEPT: u32 = 256;

/// Collects what was found.
#[derive(Debug, Default)]
pub(super) struct Report {
    tallies: BTreeMap<(Subject, Option<Key>), Tally>,
    notes: Vec<(Finding, Option<Key>)>,
    seen: Seen,
    /// Tallies of groups, whose place is that of the first shape in them.
    without_place: Vec<(Subject, Option<Key>)>,
}

impl Report {
    /// Counts one more `subject`. Without a place, it gets that of the next shape.
    pub(super) fn count(
        &mut self,
        subject: Subject,
        key: Option<Key>,
        handle: Option<&str>,
        at: Option<DVec2>,
    ) {
        let entry = (subject, key);
        if at.is_none() && !self.tallies.contains_key(&entry) {
            self.without_place.push(entry.clone());
        }
        let tally = self.tallies.entry(entry).or_insert_with(|| Tally {
            count: 0,
            handle: handle.map(str::to_owned),
            at,
        });
        tally.count = tally.count.saturating_add(1);
    }

    /// Whether a subject without a layer was counted, so that it has its place.
    pub(super) fn has(&self, subject: Subject) -> bool {
        self.tallies.contains_key(&(subject, None))
    }

    /// Counts many at once.
    pub(super) fn count_all(&mut self, subject: Subject, n: u32) {
        if n > 0 {
            self.tallies.entry((subject, None)).or_default().count += n;
        }
    }

    /// The place of a shape, for what waits for one.
    pub(super) fn place(&mut self, at: DVec2) {
        for entry in self.without_place.drain(..) {
            if let Some(tally) = self.tallies.get_mut(&entry) {
                tally.at = Some(at);
            }
        }
    }

    /// Notes a shape that cannot be cut, or only in part.
    pub(super) fn invalid(&mut self, message: String, key: Key, handle: Option<&str>, at: Option<DVec2>) {
        if self.seen.lists(Code::InvalidGeometry, 1, KEPT) {
            let mut finding =
                Finding::new(Code::InvalidGeometry, Severity::Warning, message).of_handle(handle);
            finding.at = at;
            self.notes.push((finding, Some(key)));
        }
    }

    /// The findings, with the names of layers.
    pub(super) fn into_findings(self, names: &Names) -> Vec<Finding> {
        let mut findings = Findings::default();
        let layer = |key: Option<Key>| key.and_then(|k| names.get(&k).cloned());
        for (mut finding, key) in self.notes {
            finding.layer = layer(key);
            findings.push(finding);
        }
        for (code, rest) in self.seen.rests() {
            findings.push(Finding::new(code, Severity::Info, "").times(rest));
        }
        for ((subject, key), tally) in self.tallies {
            let (code, severity, message) = subject.sentence(tally.count);
            findings.push(Finding {
                code,
                severity,
                message,
                layer: layer(key),
                handle: tally.handle,
                at: tally.at.filter(|p| p.is_finite()),
                count: tally.count,
            });
        }
        findings.into_list()
    }
}
