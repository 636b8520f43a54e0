//! The dialect document: every field, with its unit and what it means.

use serde::{Deserialize, Serialize};

/// How a controller is spoken to.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct Dialect {
    /// Name and version of this format: `kerfway.dialect/1`.
    #[cfg_attr(test, ts(type = "'kerfway.dialect/1'"))]
    pub schema: String,
    /// Name of the dialect (`grbl-m4`).
    pub name: String,
    /// Title for people.
    pub title: String,
    /// The controllers it is for, as sentences name them (`GRBL 1.1`).
    pub controller: String,
    /// Unit of coordinates and feeds. The header must select it.
    pub units: FileUnit,
    /// Decimals of numbers.
    pub decimals: Decimals,
    /// How the program waits; `None` if the controller cannot.
    pub dwell: Option<Dwell>,
    /// How the power of the beam is set.
    pub power: Power,
    /// How the material is pierced; `None` if the controller cannot: a plan with a piercing time is refused.
    pub pierce: Option<Pierce>,
    /// Whether the controller itself keeps the beam off on G0. The power is set to 0 before every rapid in any case.
    pub rapids_dark: bool,
    /// Whether the controller runs G0 with the feed in force, so that rapids need an F word of their own.
    #[serde(default, skip_serializing_if = "is_false")]
    pub rapid_feed: bool,
    /// Largest distance between an arc and the chords written for it, mm; `None`: arcs are written as G2 and G3.
    pub chords: Option<f64>,
    /// The commands of the air assist; `None` if there are none: a plan with air is refused.
    pub air: Option<Air>,
    /// Whether the controller has a Z axis. Without one, a plan that lowers the head between passes is refused.
    #[serde(default, skip_serializing_if = "is_false")]
    pub z: bool,
    /// How comments are written.
    pub comments: Comments,
    /// Longest line in characters.
    pub line_length: u32,
    /// What ends a line.
    pub line_end: LineEnd,
    /// Lines before the first move. A line that begins with `;` is a comment, written in the style of `comments`.
    /// Placeholders such as `{seconds}` are replaced; a line whose placeholder has no value is left out.
    pub header: Vec<String>,
    /// Lines at the end, after the beam is off and the head is home.
    pub footer: Vec<String>,
}

#[allow(clippy::trivially_copy_pass_by_ref, reason = "what serde asks for")]
fn is_false(flag: &bool) -> bool {
    !flag
}

/// Unit of coordinates in the program.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
#[cfg_attr(test, derive(ts_rs::TS))]
pub enum FileUnit {
    /// Millimetres (G21).
    Mm,
    /// Inches (G20).
    Inch,
}

impl FileUnit {
    /// Millimetres in this unit.
    pub fn mm(self) -> f64 {
        match self {
            Self::Mm => 1.0,
            Self::Inch => 25.4,
        }
    }
}

/// Numbers of decimals.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct Decimals {
    /// Of X, Y and Z.
    pub xy: u32,
    /// Of I and J: one more than of X and Y lets the two radii of an arc agree.
    pub ij: u32,
    /// Of F.
    pub feed: u32,
}

/// How a program waits.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct Dwell {
    /// The word after G4 that holds the time: `P`, `S`, `X` or `F`.
    pub word: String,
    /// Its unit.
    pub unit: DwellUnit,
    /// Its decimals.
    pub decimals: u32,
}

/// Unit of a dwell.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
#[cfg_attr(test, derive(ts_rs::TS))]
pub enum DwellUnit {
    /// Seconds.
    S,
    /// Milliseconds.
    Ms,
}

impl DwellUnit {
    /// Number of this unit in a second.
    pub fn per_second(self) -> f64 {
        match self {
            Self::S => 1.0,
            Self::Ms => 1000.0,
        }
    }
}

/// How the power of the beam is set.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct Power {
    /// By which commands.
    pub by: PowerBy,
    /// The word that holds it: `S` or `Q`.
    pub word: String,
    /// Number at full power; `None`: `max_s` of the machine.
    pub full: Option<f64>,
    /// Its decimals.
    pub decimals: u32,
    /// Number of the output (E of M67, P of M106).
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[cfg_attr(test, ts(optional = nullable))]
    pub output: Option<u32>,
    /// With `macro`: the lines that switch the beam on, with `{power}`.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    #[cfg_attr(test, ts(as = "Option<Vec<String>>", optional))]
    pub on: Vec<String>,
    /// With `macro`: the lines that switch it off.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    #[cfg_attr(test, ts(as = "Option<Vec<String>>", optional))]
    pub off: Vec<String>,
}

impl Power {
    /// The number at full power on a machine with this `max_s`.
    pub fn full_or(&self, max_s: f64) -> f64 {
        self.full.unwrap_or(max_s)
    }
}

/// By which commands the power is set. The reader follows the beam by the same choice.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
#[cfg_attr(test, derive(ts_rs::TS))]
pub enum PowerBy {
    /// GRBL's laser mode with dynamic power: M4, and S on the lines of motions. At rest the beam is off.
    LaserM4,
    /// GRBL's laser mode with constant power: M3, and S on the lines of motions.
    LaserM3,
    /// A spindle output: M3 S before a cut, M5 after it. It acts at once and on every motion.
    SpindleM3,
    /// An analog output: M67, which acts with the next motion.
    OutputM67,
    /// Marlin's inline mode: M3 I, and S on the lines of motions.
    InlineM3,
    /// A fan output: M106 S before a cut, M107 after it.
    FanM106,
    /// S on the lines of motions, and the beam fires only during them (Smoothieware).
    Motion,
    /// The lines `on` and `off` of the document.
    Macro,
}

/// How the material is pierced.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct Pierce {
    /// The method.
    pub by: PierceBy,
    /// With `creep`: the length that is cut slowly, mm.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[cfg_attr(test, ts(optional = nullable))]
    pub length: Option<f64>,
    /// With `macro`: its lines, with `{seconds}` and `{power}`. They leave the beam on.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    #[cfg_attr(test, ts(as = "Option<Vec<String>>", optional))]
    pub lines: Vec<String>,
}

/// The ways to pierce.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
#[cfg_attr(test, derive(ts_rs::TS))]
pub enum PierceBy {
    /// A dwell under M3, in the motion mode G1, in which GRBL's laser mode lets the beam on.
    DwellM3,
    /// M68, which sets the output at once, and a dwell.
    DwellM68,
    /// The command that switches the beam on at once, and a dwell.
    DwellStandard,
    /// The head moves so slowly along the beginning of the cut that this takes the piercing time.
    Creep,
    /// The lines of the document.
    Macro,
}

/// The commands of the air assist.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct Air {
    /// Line that switches it on.
    pub on: String,
    /// Line that switches it off.
    pub off: String,
}

/// How comments are written.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
#[cfg_attr(test, derive(ts_rs::TS))]
pub enum Comments {
    /// After a semicolon.
    Semicolon,
    /// In parentheses.
    Parentheses,
    /// Not at all.
    None,
}

/// What ends a line.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
#[cfg_attr(test, derive(ts_rs::TS))]
pub enum LineEnd {
    /// Line feed.
    Lf,
    /// Carriage return and line feed.
    Crlf,
}
