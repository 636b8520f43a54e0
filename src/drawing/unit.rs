//! The unit of length of a drawing, and where it comes from.

use serde::{Deserialize, Serialize};

/// The unit of length of a drawing.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
#[cfg_attr(test, derive(ts_rs::TS))]
pub enum Unit {
    /// 25.4 mm.
    In,
    /// 304.8 mm.
    Ft,
    /// 914.4 mm.
    Yd,
    /// 0.0254 mm.
    Mil,
    /// A millionth of an inch.
    Microinch,
    /// 0.001 mm.
    Um,
    /// 1 mm.
    Mm,
    /// 10 mm.
    Cm,
    /// 100 mm.
    Dm,
    /// 1000 mm.
    M,
}

impl Unit {
    /// Length of the unit in millimetres.
    pub const fn millimetres(self) -> f64 {
        match self {
            Self::In => 25.4,
            Self::Ft => 304.8,
            Self::Yd => 914.4,
            Self::Mil => 0.0254,
            Self::Microinch => 0.000_025_4,
            Self::Um => 0.001,
            Self::Mm => 1.0,
            Self::Cm => 10.0,
            Self::Dm => 100.0,
            Self::M => 1000.0,
        }
    }

    /// Name of the unit in a sentence.
    pub const fn plural(self) -> &'static str {
        match self {
            Self::In => "inches",
            Self::Ft => "feet",
            Self::Yd => "yards",
            Self::Mil => "mils",
            Self::Microinch => "microinches",
            Self::Um => "micrometres",
            Self::Mm => "millimetres",
            Self::Cm => "centimetres",
            Self::Dm => "decimetres",
            Self::M => "metres",
        }
    }

    /// Whether the unit is metric, not imperial.
    pub const fn is_metric(self) -> bool {
        matches!(self, Self::Um | Self::Mm | Self::Cm | Self::Dm | Self::M)
    }

    /// The unit of an $INSUNITS code; `None` for 0 and for units that no cutting drawing uses (miles, parsecs, ...).
    pub const fn of_insert_units(code: i64) -> Option<Self> {
        // 21 to 23 are survey feet, inches and yards, which are 2 parts in a million longer.
        Some(match code {
            1 | 22 => Self::In,
            2 | 21 => Self::Ft,
            4 => Self::Mm,
            5 => Self::Cm,
            6 => Self::M,
            8 => Self::Microinch,
            9 => Self::Mil,
            10 | 23 => Self::Yd,
            13 => Self::Um,
            14 => Self::Dm,
            _ => return None,
        })
    }
}

/// Where the unit comes from.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
#[cfg_attr(test, derive(ts_rs::TS))]
pub enum UnitsSource {
    /// The header variable $INSUNITS.
    Header,
    /// Guessed from the size and $MEASUREMENT; see `reason`.
    Guessed,
    /// Chosen by the person.
    Given,
}

/// The unit of a drawing, and why it was chosen.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(rename = "UnitsTaken"))]
pub struct Units {
    /// The chosen unit.
    pub unit: Unit,
    /// Where the unit comes from.
    pub source: UnitsSource,
    /// One sentence for people that gives the reason for this unit.
    pub reason: String,
    /// Whether a person should be asked, because the unit was guessed without evidence or the size contradicts the
    /// header.
    pub doubtful: bool,
}
