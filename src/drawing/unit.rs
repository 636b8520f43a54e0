//! The unit of length of a drawing, and where it comes from.

use serde::{Deserialize, Serialize};

/// Pixels per inch in browsers and in Inkscape since version 0.92.
///
/// Source: "CSS Values and Units Module Level 3" (W3C), section 6.2.
pub const CSS_DPI: f64 = 96.0;

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
    /// A pixel: 1/96 inch, unless [`Units::dpi`] has another number.
    Px,
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
            Self::Px => 25.4 / CSS_DPI,
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
            Self::Px => "pixels",
        }
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
    /// The file says it: in the header variable $INSUNITS, or as the size of its SVG page.
    Header,
    /// Guessed from the drawing, or from the program that wrote it; see `reason`.
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
    /// Pixels per inch, if the unit is a pixel.
    pub dpi: Option<f64>,
    /// Length in mm of one unit of the drawing's coordinates. It differs from the unit where an SVG page is scaled.
    pub scale: f64,
    /// Where the unit comes from.
    pub source: UnitsSource,
    /// One sentence for people that gives the reason for this unit.
    pub reason: String,
    /// Whether a person should be asked, because the unit was guessed from too little evidence or the evidence contradicts
    /// the file.
    pub doubtful: bool,
    /// How sure the unit is, from 0 to 1: the share of the evidence for it. 1 for a unit that a person chose.
    pub confidence: f64,
}

impl Units {
    /// The units that a person chose: a unit, or pixels of a resolution. `None` if nothing was chosen.
    pub(crate) fn chosen(unit: Option<Unit>, dpi: Option<f64>) -> Option<Self> {
        let unit = if dpi.is_some() { Unit::Px } else { unit? };
        let dpi = (unit == Unit::Px).then_some(dpi.unwrap_or(CSS_DPI));
        let reason = match dpi {
            Some(dpi) => format!("Chosen: pixels, {dpi} to the inch."),
            None => format!("Chosen: {}.", unit.plural()),
        };
        let scale = dpi.map_or(unit.millimetres(), |dpi| 25.4 / dpi);
        Some(Self { unit, dpi, scale, source: UnitsSource::Given, reason, doubtful: false, confidence: 1.0 })
    }

    /// Why the unit may be wrong, if it is doubtful.
    pub fn doubt(&self) -> Option<String> {
        self.doubtful.then(|| self.reason.clone())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_resolution_means_pixels() {
        let chosen = |unit, dpi| Units::chosen(unit, dpi).map(|u| (u.unit, u.scale));
        assert_eq!(chosen(None, None), None);
        assert_eq!(chosen(Some(Unit::Cm), None), Some((Unit::Cm, 10.0)));
        assert_eq!(chosen(Some(Unit::Px), None), Some((Unit::Px, 25.4 / 96.0)));
        assert_eq!(chosen(None, Some(72.0)), Some((Unit::Px, 25.4 / 72.0)));
    }
}
