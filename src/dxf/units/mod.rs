//! Determines the unit of a drawing, and how sure it is.
//!
//! In four of ten real drawings the header names no unit, and where it does, the unit often comes from a template (of
//! 192 files in inches, 25 were then larger than 6 m). So the drawing itself is evidence: its size, holes, names of
//! layers, texts, settings and round values are weighed for millimetres and for inches. Nothing is converted silently:
//! the reason is given, and doubt is reported.

mod evidence;
mod facts;
mod names;

use super::file::File;
use crate::drawing::{Unit, Units, UnitsSource};
use crate::finding::{Code, Finding, Severity};
use crate::number::fixed;
use evidence::{PLAUSIBLE_SIZE, Weighed};
use facts::Facts;

/// Share of the evidence above which a unit raises no doubt.
const SURE: f64 = 0.9;
/// How many times likelier the unit of the header is than another one, before the drawing is looked at.
const HEADER_ODDS: f64 = 20.0;
/// Smallest part that somebody cuts by itself, mm: a washer. Below the usual sizes, millimetres in the header are believed down to here
/// if nothing else speaks for inches.
const SMALLEST_PART: f64 = 2.0;

/// Chooses the unit for a drawing whose larger extent is `size` (in its own units; 0 when unknown). Adds a finding when
/// the unit is guessed or doubtful.
pub(super) fn decide(file: &File<'_>, given: Option<Units>, size: f64) -> (Units, Option<Finding>) {
    if let Some(units) = given {
        return (units, None);
    }
    let header = &file.header;
    let facts = Facts::of(file, size);
    let weighed = Weighed::of(header, &facts);
    let code = header.insert_units.unwrap_or(0);
    match Unit::of_insert_units(code) {
        Some(unit) => from_header(unit, &facts, &weighed),
        None => guess(code, &facts, &weighed),
    }
}

fn from_header(unit: Unit, facts: &Facts, weighed: &Weighed) -> (Units, Option<Finding>) {
    let size = facts.extent;
    let named = format!("The file says {}", unit.plural());
    // The other of the two units that the evidence is about.
    let (other, against) = match unit {
        Unit::In => (Unit::Mm, 1.0 - weighed.inches()),
        _ => (Unit::In, weighed.inches()),
    };
    // What the file says weighs as much as the strongest evidence.
    let against = against / (against + (1.0 - against) * HEADER_ODDS);
    let is_small_part = unit == Unit::Mm && (SMALLEST_PART..*PLAUSIBLE_SIZE.start()).contains(&size);
    let is_usual = is_plausible(unit, size) || is_small_part;
    let doubt = if !is_usual {
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
    } else if matches!(unit, Unit::In | Unit::Mm) && against > 1.0 - SURE && is_plausible(other, size) {
        Some(format!(
            "{named} ({}), but {} ({}) are likely as well, because {}. Check the units.",
            extent(unit, size),
            other.plural(),
            extent(other, size),
            weighed.reasons(other == Unit::In)
        ))
    } else {
        None
    };
    let finding =
        doubt.as_ref().map(|text| Finding::new(Code::UnitsDoubtful, Severity::Warning, text.clone()));
    let doubtful = doubt.is_some();
    let confidence = if is_usual { 1.0 - against } else { 0.5_f64.min(1.0 - against) };
    let reason = doubt.unwrap_or_else(|| format!("{named}."));
    (
        Units {
            unit,
            dpi: None,
            scale: unit.millimetres(),
            source: UnitsSource::Header,
            reason,
            doubtful,
            confidence,
        },
        finding,
    )
}

fn guess(code: i64, facts: &Facts, weighed: &Weighed) -> (Units, Option<Finding>) {
    let why = match code {
        0 => "The file names no units".to_owned(),
        _ => format!("The file names units that no cutting drawing is in (code {code})"),
    };
    let inches = weighed.inches();
    let (unit, other, confidence) =
        if inches > 0.5 { (Unit::In, Unit::Mm, inches) } else { (Unit::Mm, Unit::In, 1.0 - inches) };
    let is_sure = confidence >= SURE;
    let size = facts.extent;
    let (pro, contra) = (weighed.reasons(unit == Unit::In), weighed.reasons(unit != Unit::In));
    let pro = if pro.is_empty() { "most cutting drawings are in millimetres".to_owned() } else { pro };
    let contra = if contra.is_empty() || is_sure {
        String::new()
    } else {
        format!(" It may also be in {} ({}), because {contra}.", other.plural(), extent(other, size))
    };
    let reason =
        format!("{why}: taken as {} ({}), because {pro}.{contra}", unit.plural(), extent(unit, size));
    let severity = if is_sure { Severity::Info } else { Severity::Warning };
    let message = if is_sure { reason.clone() } else { format!("{reason} Check the units.") };
    let finding = Finding::new(Code::UnitsGuessed, severity, message);
    (
        Units {
            unit,
            dpi: None,
            scale: unit.millimetres(),
            source: UnitsSource::Guessed,
            reason,
            doubtful: !is_sure,
            confidence,
        },
        Some(finding),
    )
}

fn is_plausible(unit: Unit, size: f64) -> bool {
    PLAUSIBLE_SIZE.contains(&(size * unit.millimetres()))
}

/// An extent in millimetres or metres, rounded for people.
fn extent(unit: Unit, size: f64) -> String {
    let mm = size * unit.millimetres();
    // Farther than that nothing is read; a number from a damaged file may have 300 digits.
    if mm > 1e6 {
        "over 1 km".to_owned()
    } else if mm >= 10_000.0 {
        format!("{:.1} m", mm / 1000.0)
    } else if mm >= 100.0 {
        // A tenth, so that whole inches remain such when it is converted.
        format!("{} mm", fixed(mm, 1))
    } else {
        format!("{} mm", fixed(mm, 3))
    }
}
