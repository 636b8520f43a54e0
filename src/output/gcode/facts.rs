//! The values of the placeholders in a dialect's header and footer: what a program says about itself.

use super::checksum;
use crate::machine::Profile;
use crate::machine::dialect::{Dialect, FileUnit};
use crate::number::fixed;
use crate::plan::Plan;

/// What the program says about the job; a name alone is enough.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct JobFacts<'a> {
    /// Name of the job, such as the file of the drawing.
    pub name: &'a str,
    /// SHA-256 of the drawing, in hexadecimal.
    pub hash: Option<&'a str>,
    /// Name of the material.
    pub material: Option<&'a str>,
}

impl<'a> From<&'a str> for JobFacts<'a> {
    fn from(name: &'a str) -> Self {
        Self { name, ..Self::default() }
    }
}

impl<'a> From<&'a String> for JobFacts<'a> {
    fn from(name: &'a String) -> Self {
        Self::from(name.as_str())
    }
}

/// A part of a line.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Part {
    /// Words and numbers, which are kept.
    Text(String),
    /// A name given by a person, which may be shortened.
    Name(String),
}

impl Part {
    pub(super) fn text(&self) -> &str {
        match self {
            Self::Text(text) | Self::Name(text) => text,
        }
    }
}

/// Corner tolerance for machines that state none, mm: GRBL's default.
const CORNER_TOLERANCE: f64 = 0.01;

/// The values of all placeholders.
pub(super) struct Facts {
    values: Vec<(&'static str, Part)>,
}

impl Facts {
    pub(super) fn of(plan: &Plan, profile: &Profile, dialect: &Dialect, job: &JobFacts) -> Self {
        let sums = &plan.summary;
        let [xmin, ymin, xmax, ymax] = sums.bounds;
        let name = |text: &str| Some(Part::Name(text.to_owned()));
        let text = |text: String| Some(Part::Text(text));
        let number = |n: f64| text(fixed(n, 1).to_string());
        let unit = match dialect.units {
            FileUnit::Mm => "mm",
            FileUnit::Inch => "inch",
        };
        let tolerance = profile.junction_deviation.filter(|d| *d > 0.0).unwrap_or(CORNER_TOLERANCE);
        let all = [
            ("version", text(env!("CARGO_PKG_VERSION").to_owned())),
            ("job", name(job.name)),
            ("machine", name(&profile.name)),
            ("machine_title", name(&profile.title)),
            ("dialect", name(&dialect.name)),
            ("controller", name(&dialect.controller)),
            ("material", job.material.and_then(name)),
            ("hash", job.hash.and_then(|hash| text(hash.to_owned()))),
            ("contours", text(sums.contours.to_string())),
            ("pierces", text(sums.pierces.to_string())),
            ("cut_length", number(sums.cut_length)),
            ("air_length", number(sums.air_length)),
            ("seconds", number(sums.total_time)),
            ("time", text(clock(sums.total_time))),
            ("unit", text(unit.to_owned())),
            ("xmin", number(xmin)),
            ("xmax", number(xmax)),
            ("ymin", number(ymin)),
            ("ymax", number(ymax)),
            ("width", number(xmax - xmin)),
            ("height", number(ymax - ymin)),
            ("checksum", text(checksum::PLACE.to_owned())),
            ("corner_tolerance", text(fixed(tolerance / dialect.units.mm(), 4).to_string())),
        ];
        Self { values: all.into_iter().filter_map(|(name, value)| Some((name, value?))).collect() }
    }

    /// The parts of a line; `None` if one of its placeholders has no value.
    pub(super) fn parts(&self, line: &str) -> Option<Vec<Part>> {
        let mut parts = Vec::new();
        let mut rest = line;
        while let Some((before, open)) = rest.split_once('{') {
            let (name, after) = open.split_once('}')?;
            parts.push(Part::Text(before.to_owned()));
            parts.push(self.values.iter().find(|(known, _)| *known == name)?.1.clone());
            rest = after;
        }
        parts.push(Part::Text(rest.to_owned()));
        Some(parts)
    }
}

/// Hours, minutes and seconds: `1:02:03`.
fn clock(seconds: f64) -> String {
    let whole = seconds.round();
    let (hours, minutes) = ((whole / 3600.0).floor(), (whole / 60.0).floor() % 60.0);
    format!("{hours}:{minutes:02}:{:02}", whole % 60.0)
}
