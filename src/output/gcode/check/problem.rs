//! What is wrong with a program.

use crate::finding::Severity;
use serde::Serialize;

/// What kind of thing is wrong.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
#[cfg_attr(test, derive(ts_rs::TS), ts(rename = "CheckCode"))]
pub enum Code {
    /// A line that the check cannot read, or a command that it does not know.
    Unreadable,
    /// A line that the controller cannot hold, or a character that it acts upon.
    BadLine,
    /// The program does not say whether its numbers are millimetres or inches.
    UnitsUnknown,
    /// The beam is on during a rapid.
    BeamOnRapid,
    /// The power is above 0 on a rapid, and only the controller's own rule keeps the beam off.
    PowerOnRapid,
    /// A cut without power.
    DarkCut,
    /// A cut with the head lifted.
    LiftedCut,
    /// A wait in which the beam is off although it should pierce.
    DarkPierce,
    /// A power outside its range.
    PowerOutOfRange,
    /// A motion without a feed, or with one that the machine does not have.
    FeedOutOfRange,
    /// A wait that the machine does not ask for.
    WaitOutOfRange,
    /// An arc whose ends do not fit its centre.
    BadArc,
    /// The head leaves the bed.
    OffBed,
    /// Contours that are cut more or fewer times than the others.
    CutTwice,
    /// The beam is not switched off at the end.
    BeamOnAtEnd,
    /// The end of the program is missing.
    Incomplete,
    /// The program is not what its header or the plan says.
    Differs,
    /// There is nothing to cut.
    Empty,
    /// A program of Kerfway's has lines that were changed, added or removed since.
    Changed,
}

/// Something wrong with a program.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(rename = "CheckProblem"))]
pub struct Problem {
    /// What kind of thing.
    pub code: Code,
    /// An error: the program must not be run. A warning: look at it.
    pub severity: Severity,
    /// What, where, and what it means, in one sentence.
    pub message: String,
    /// Number of the first line, counted from 1.
    pub line: Option<u32>,
    /// How often it was found.
    pub count: u32,
}

/// The problems of a program, one for each kind and severity.
#[derive(Debug, Default)]
pub(super) struct Problems(pub(super) Vec<Problem>);

impl Problems {
    pub(super) fn add(
        &mut self,
        code: Code,
        severity: Severity,
        line: Option<u32>,
        message: impl FnOnce() -> String,
    ) {
        match self.0.iter_mut().find(|p| p.code == code && p.severity == severity) {
            Some(known) => known.count += 1,
            None => self.0.push(Problem { code, severity, message: message(), line, count: 1 }),
        }
    }

    pub(super) fn error(&mut self, code: Code, line: Option<u32>, message: impl FnOnce() -> String) {
        self.add(code, Severity::Error, line, message);
    }
}
