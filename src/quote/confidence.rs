//! How far the figures of a quote can be relied on.

use crate::drawing::UnitsSource;
use crate::finding::{Code, Finding, Severity};
use crate::plan::document::{Contour, Input};
use crate::sheet::Operation;
use serde::Serialize;

/// A kind of defect.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct Defect {
    /// The code of its findings.
    pub code: Code,
    /// The severity of its findings.
    pub severity: Severity,
    /// How many there are.
    pub count: u32,
}

/// How far the figures can be relied on.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct Confidence {
    /// In one word.
    pub level: Level,
    /// Why it is not high.
    pub reasons: Vec<String>,
}

/// In one word.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize)]
#[serde(rename_all = "kebab-case")]
#[cfg_attr(test, derive(ts_rs::TS), ts(rename = "ConfidenceLevel"))]
pub enum Level {
    /// Nothing known speaks against the figures.
    High,
    /// Something may change them a little: a person should look.
    Medium,
    /// They may be wrong altogether.
    Low,
}

/// Findings that are more than information, by code.
pub(super) fn defects(findings: &[Finding]) -> Vec<Defect> {
    let mut defects: Vec<Defect> = Vec::new();
    for f in findings.iter().filter(|f| f.severity != Severity::Info) {
        match defects.iter_mut().find(|d| d.code == f.code) {
            Some(known) => known.count = known.count.saturating_add(f.count),
            None => defects.push(Defect { code: f.code, severity: f.severity, count: f.count }),
        }
    }
    defects
}

pub(super) fn confidence(input: &Input, defects: &[Defect], contours: &[Contour]) -> Confidence {
    let mut level = Level::High;
    let mut reasons = Vec::new();
    let mut doubt = |at_least: Level, reason: String| {
        level = level.max(at_least);
        reasons.push(reason);
    };
    if input.units_source == UnitsSource::Guessed {
        doubt(Level::Low, "The file does not say its units; they were guessed.".into());
    }
    let open = contours.iter().filter(|c| c.is_open() && c.operation == Operation::Cut).count();
    match open {
        0 => {}
        1 => doubt(Level::Medium, "1 contour that is cut is open: it encloses no part.".into()),
        _ => doubt(Level::Medium, format!("{open} contours that are cut are open: they enclose no part.")),
    }
    for Defect { code, severity, count } in defects {
        // The sentence above already names the open contours that are cut, and where a job lies changes no figure of it.
        if (*code == Code::OpenContour && open > 0) || *code == Code::OffBed {
            continue;
        }
        // A border that is cut changes the number of parts and all areas.
        let grave = *severity == Severity::Error || *code == Code::SheetOutline;
        let at_least = if grave { Level::Low } else { Level::Medium };
        doubt(at_least, format!("{}.", code.in_words(*count)));
    }
    Confidence { level, reasons }
}
