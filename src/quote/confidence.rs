//! How far the figures of a quote can be relied on.

use crate::drawing::UnitsSource;
use crate::finding::{Code, Finding, Severity};
use crate::geometry::{Aabb, BoxIndex};
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
    pub reasons: Vec<Reason>,
}

/// Why figures cannot be relied on.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(rename = "ConfidenceReason"))]
pub struct Reason {
    /// The kind of reason.
    pub code: ReasonCode,
    /// The code of the findings, if they are the reason.
    pub finding: Option<Code>,
    /// How many there are.
    pub count: u32,
    /// One sentence for people.
    pub message: String,
}

/// The kind of a reason.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
#[cfg_attr(test, derive(ts_rs::TS))]
pub enum ReasonCode {
    /// The units may be wrong.
    UnitsDoubtful,
    /// The units were guessed.
    UnitsGuessed,
    /// Contours that are cut are open.
    OpenCuts,
    /// The machine has no setting for the material.
    NoSetting,
    /// Findings that are more than information.
    Findings,
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

/// The confidence in the figures of the whole job. `unset`: a material that was named but not planned for, and the title of
/// the machine.
pub(super) fn confidence(
    input: &Input,
    defects: &[Defect],
    contours: &[Contour],
    unset: Option<(&str, &str)>,
) -> Confidence {
    let mut doubts = Doubts::none();
    if let Some((material, machine)) = unset {
        let message =
            format!("The machine has no setting for {material}: its times are those of \"{machine}\".");
        doubts.add(Level::Medium, Reason { code: ReasonCode::NoSetting, finding: None, count: 1, message });
    }
    let mut of_units =
        |level, code, message| doubts.add(level, Reason { code, finding: None, count: 1, message });
    if let Some(reason) = &input.units_doubt {
        of_units(Level::Low, ReasonCode::UnitsDoubtful, format!("The unit is in doubt. {reason}"));
    } else if input.units_source == UnitsSource::Guessed {
        let message = "The file does not say its units; they were guessed from what it shows.".into();
        of_units(Level::Medium, ReasonCode::UnitsGuessed, message);
    }
    let open = contours.iter().filter(|c| c.is_open() && c.operation == Operation::Cut).count();
    if open > 0 {
        let message = match open {
            1 => "1 contour that is cut is open: it encloses no part.".into(),
            _ => format!("{open} contours that are cut are open: they enclose no part."),
        };
        let count = u32::try_from(open).unwrap_or(u32::MAX);
        doubts.add(Level::Medium, Reason { code: ReasonCode::OpenCuts, finding: None, count, message });
    }
    for defect in defects {
        // The sentences above already name the open contours that are cut and the doubt about the unit, and where a job lies
        // changes no figure of it.
        let told = match defect.code {
            Code::OpenContour => open > 0,
            Code::UnitsGuessed | Code::UnitsDoubtful => input.units_doubt.is_some(),
            _ => false,
        };
        if !told && defect.code != Code::OffBed {
            doubts.add_defect(defect);
        }
    }
    doubts.0
}

/// The confidence in the figures of each part, from the findings that lie in its box. What concerns the whole job, such as
/// guessed units, is in the confidence of the job alone.
pub(super) fn of_parts(findings: &[Finding], boxes: &[Aabb]) -> Vec<Confidence> {
    let index = BoxIndex::new(boxes.iter().copied());
    let mut on: Vec<Vec<Finding>> = vec![Vec::new(); boxes.len()];
    for finding in findings.iter().filter(|f| f.severity != Severity::Info) {
        let Some(at) = finding.at else { continue };
        index.visit(Aabb::of(at).grown(NEAR), |part| {
            if let Some(list) = on.get_mut(part) {
                list.push(Finding { count: 1, ..finding.clone() });
            }
            true
        });
    }
    let of = |findings: &Vec<Finding>| {
        let mut doubts = Doubts::none();
        defects(findings).iter().for_each(|defect| doubts.add_defect(defect));
        doubts.0
    };
    on.iter().map(of).collect()
}

/// A finding this near to the box of a part lies on it, mm: gaps and copies are found within such distances.
const NEAR: f64 = 0.1;

/// Reasons as they add up.
struct Doubts(Confidence);

impl Doubts {
    fn none() -> Self {
        Self(Confidence { level: Level::High, reasons: Vec::new() })
    }

    fn add(&mut self, at_least: Level, reason: Reason) {
        self.0.level = self.0.level.max(at_least);
        self.0.reasons.push(reason);
    }

    fn add_defect(&mut self, &Defect { code, severity, count }: &Defect) {
        // A border that is cut changes the number of parts and all areas.
        let is_grave = severity == Severity::Error || code == Code::SheetOutline;
        let at_least = if is_grave { Level::Low } else { Level::Medium };
        let message = format!("{}.", code.in_words(count));
        self.add(at_least, Reason { code: ReasonCode::Findings, finding: Some(code), count, message });
    }
}
