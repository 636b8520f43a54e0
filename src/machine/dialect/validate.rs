//! Refuses dialects that contradict themselves, each in one sentence.

use super::model::{Dialect, PierceBy, Power, PowerBy};
use crate::fields::no_such;

/// What lines of a header or footer may contain in braces.
pub const PLACEHOLDERS: [&str; 23] = [
    "version",
    "job",
    "machine",
    "machine_title",
    "dialect",
    "material",
    "hash",
    "contours",
    "pierces",
    "cut_length",
    "air_length",
    "seconds",
    "time",
    "unit",
    "xmin",
    "xmax",
    "ymin",
    "ymax",
    "width",
    "height",
    "corner_tolerance",
    "controller",
    "checksum",
];

/// What the lines that switch the beam on and those that pierce may contain in braces.
const OF_ON: [&str; 1] = ["power"];
const OF_PIERCE: [&str; 2] = ["power", "seconds"];

impl Dialect {
    /// Checks that the parts of the document fit together.
    ///
    /// # Errors
    /// One sentence about the first contradiction.
    pub fn validate(&self) -> Result<(), String> {
        let refuse = |why: String| Err(format!("The dialect \"{}\" {why}", self.name));
        if let Some(pierce) = &self.pierce {
            let fits = match pierce.by {
                PierceBy::DwellM3 => matches!(self.power.by, PowerBy::LaserM4 | PowerBy::LaserM3),
                PierceBy::DwellM68 => self.power.by == PowerBy::OutputM67,
                PierceBy::DwellStandard => {
                    matches!(self.power.by, PowerBy::SpindleM3 | PowerBy::InlineM3 | PowerBy::FanM106)
                }
                PierceBy::Creep => true,
                PierceBy::Macro => self.power.by == PowerBy::Macro,
            };
            if !fits {
                return refuse(format!(
                    "pierces by \"{}\", which does not work with power by \"{}\": choose another of the two, or \"creep\".",
                    pierce.by.word(),
                    self.power.by.word()
                ));
            }
            if self.dwell.is_none() && !matches!(pierce.by, PierceBy::Creep | PierceBy::Macro) {
                return refuse(
                    "pierces by a dwell but has none: give \"dwell\", or pierce by \"creep\".".into(),
                );
            }
            if pierce.by == PierceBy::Creep && pierce.length.is_none() {
                return refuse("pierces by \"creep\" without a length: give \"pierce.length\" in mm.".into());
            }
            if pierce.by == PierceBy::Macro && pierce.lines.is_empty() {
                return refuse("pierces by \"macro\" without lines: give \"pierce.lines\".".into());
            }
        }
        if self.power.by == PowerBy::Macro && (self.power.on.is_empty() || self.power.off.is_empty()) {
            return refuse(
                "sets the power by \"macro\" without lines: give \"power.on\" and \"power.off\".".into(),
            );
        }
        let Power { by, word, on, off, .. } = &self.power;
        let taken = if *by == PowerBy::OutputM67 { "Q" } else { "S" };
        if *by != PowerBy::Macro && word != taken {
            return refuse(format!(
                "sets the power by \"{}\" with the word {word}, which these commands do not take: set \"power.word\" to \"{taken}\".",
                by.word()
            ));
        }
        let lines = |field: &str, list: &[String], known: &[&str]| {
            list.iter().try_for_each(|line| self.line(field, line, known))
        };
        lines("header", &self.header, &PLACEHOLDERS)?;
        lines("footer", &self.footer, &PLACEHOLDERS)?;
        lines("power.on", on, &OF_ON)?;
        lines("power.off", off, &[])?;
        lines("pierce.lines", self.pierce.as_ref().map_or(&[][..], |p| &p.lines), &OF_PIERCE)?;
        let Some(air) = &self.air else { return Ok(()) };
        self.line("air.on", &air.on, &[])?;
        self.line("air.off", &air.off, &[])
    }

    /// Checks one line of a field: printable ASCII, known placeholders, and not too long. Comments are shortened when written.
    fn line(&self, field: &str, line: &str, known: &[&str]) -> Result<(), String> {
        let refuse =
            |why: String| Err(format!("The dialect \"{}\" has a line in \"{field}\" {why}", self.name));
        if let Some(bad) = line.chars().find(|c| !(' '..='~').contains(c)) {
            return refuse(format!("with the character {bad:?}: use plain ASCII characters only."));
        }
        let comment = line.starts_with(';');
        if !comment && line.len() > self.line_length as usize {
            return refuse(format!(
                "of {} characters, but its lines have at most {}.",
                line.len(),
                self.line_length
            ));
        }
        let mut rest = line;
        while let Some((_, open)) = rest.split_once('{') {
            let Some((name, after)) = open.split_once('}') else {
                return refuse(format!("with an open brace: {line}"));
            };
            if known.is_empty() {
                return refuse(format!(
                    "with the placeholder \"{name}\", but it is written as it is: {line}"
                ));
            }
            if !known.contains(&name) {
                let why = no_such("placeholder", name, known);
                return Err(format!("In \"{field}\" of the dialect \"{}\": {why}", self.name));
            }
            rest = after;
        }
        Ok(())
    }
}

impl PowerBy {
    /// As the document writes it.
    pub fn word(self) -> &'static str {
        match self {
            Self::LaserM4 => "laser-m4",
            Self::LaserM3 => "laser-m3",
            Self::SpindleM3 => "spindle-m3",
            Self::OutputM67 => "output-m67",
            Self::InlineM3 => "inline-m3",
            Self::FanM106 => "fan-m106",
            Self::Motion => "motion",
            Self::Macro => "macro",
        }
    }
}

impl PierceBy {
    /// As the document writes it.
    pub fn word(self) -> &'static str {
        match self {
            Self::DwellM3 => "dwell-m3",
            Self::DwellM68 => "dwell-m68",
            Self::DwellStandard => "dwell-standard",
            Self::Creep => "creep",
            Self::Macro => "macro",
        }
    }
}
