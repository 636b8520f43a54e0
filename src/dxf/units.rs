//! Determines the unit of a drawing, and whether it is plausible.
//!
//! In four of ten real drawings the header names no unit, and where it does, the unit often comes from a template (of
//! 192 files in inches, 25 were then larger than 6 m). The size of the drawing is therefore evidence too: parts and
//! sheets for a laser measure between 20 mm and 6 m. Nothing is converted silently: the reason is given, and doubt is
//! reported.

use super::header::Header;
use crate::drawing::{Unit, Units, UnitsSource};
use crate::finding::{Code, Finding, Severity};

/// Smallest and largest extent of a drawing that raises no doubt, mm. Only 2 % of real drawings are smaller, most of
/// them in another unit than they say; no common machine has a bed above 6 m.
const PLAUSIBLE_SIZE: std::ops::RangeInclusive<f64> = 20.0..=6000.0;

/// Chooses the unit for a drawing whose larger extent is `size` (in its own units; 0 when unknown). Adds a finding when
/// the unit is guessed or doubtful.
pub(super) fn decide(header: &Header<'_>, given: Option<Unit>, size: f64) -> (Units, Option<Finding>) {
    if let Some(unit) = given {
        let reason = format!("{} were chosen.", unit.plural());
        return (Units { unit, source: UnitsSource::Given, reason, doubtful: false }, None);
    }
    let code = header.insert_units.unwrap_or(0);
    match Unit::of_insert_units(code) {
        Some(unit) => from_header(header, unit, size),
        None => guess(header, code, size),
    }
}

fn from_header(header: &Header<'_>, unit: Unit, size: f64) -> (Units, Option<Finding>) {
    let named = format!("The file says {}", unit.plural());
    let other = match (unit.is_metric(), header.measurement) {
        (true, Some(0)) => Some(Unit::In),
        (false, Some(1)) => Some(Unit::Mm),
        _ => None,
    };
    let doubt = if !is_plausible(unit, size) {
        let likely = if is_plausible(Unit::Mm, size) { Unit::Mm } else { Unit::In };
        let likely = if is_plausible(likely, size) {
            format!(" In {} it would be {}.", likely.plural(), extent(likely, size))
        } else {
            String::new()
        };
        Some(format!(
            "{named}, but then the drawing is {} large.{likely} Check the units.",
            extent(unit, size)
        ))
    } else {
        other.filter(|other| is_plausible(*other, size)).map(|other| {
            format!(
                "{named} ({}), but its other settings are for {} ({}). Check the units.",
                extent(unit, size),
                other.plural(),
                extent(other, size)
            )
        })
    };
    let finding =
        doubt.as_ref().map(|text| Finding::new(Code::UnitsDoubtful, Severity::Warning, text.clone()));
    let doubtful = doubt.is_some();
    let reason = doubt.unwrap_or_else(|| format!("{named}."));
    (Units { unit, source: UnitsSource::Header, reason, doubtful }, finding)
}

fn guess(header: &Header<'_>, code: i64, size: f64) -> (Units, Option<Finding>) {
    let why = match code {
        0 => "The file names no units".to_owned(),
        _ => format!("The file names units that no cutting drawing is in (code {code})"),
    };
    let imperial = header.length_format.is_some_and(|f| matches!(f, 3 | 4)) || header.measurement == Some(0);
    let metric = header.measurement == Some(1);
    let (as_mm, as_in) = (is_plausible(Unit::Mm, size), is_plausible(Unit::In, size));
    let (unit, hint, sure) = match (as_mm, as_in) {
        (true, false) => (Unit::Mm, "only in millimetres the size is usual", true),
        (false, true) if imperial => (Unit::In, "its settings and its size speak for inches", true),
        (false, true) => {
            (Unit::Mm, "most cutting drawings are in millimetres, though this one is small", false)
        }
        (true, true) if metric => (Unit::Mm, "its settings are metric", true),
        (true, true) if imperial => {
            (Unit::Mm, "most cutting drawings are in millimetres, though its settings are for inches", false)
        }
        (true, true) => (Unit::Mm, "most cutting drawings are in millimetres", false),
        (false, false) => {
            (Unit::Mm, "most cutting drawings are in millimetres, though the size is unusual", false)
        }
    };
    let reason = format!("{why}: taken as {} ({}), because {hint}.", unit.plural(), extent(unit, size));
    let severity = if sure { Severity::Info } else { Severity::Warning };
    let message = if sure { reason.clone() } else { format!("{reason} Check the units.") };
    let finding = Finding::new(Code::UnitsGuessed, severity, message);
    (Units { unit, source: UnitsSource::Guessed, reason, doubtful: !sure }, Some(finding))
}

fn is_plausible(unit: Unit, size: f64) -> bool {
    PLAUSIBLE_SIZE.contains(&(size * unit.millimetres()))
}

/// An extent in millimetres or metres, rounded for people.
fn extent(unit: Unit, size: f64) -> String {
    let mm = size * unit.millimetres();
    if mm >= 10_000.0 {
        format!("{:.1} m", mm / 1000.0)
    } else if mm >= 100.0 {
        format!("{mm:.0} mm")
    } else {
        format!("{mm:.3} mm")
    }
}
