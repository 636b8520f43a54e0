//! Data of what falls and what tips: which pieces may stand up under the head once they are cut free, and how near to them
//! the head may pass.
//!
//! No figure here is measured: the defaults are guesses that fit a fibre laser over slats ([lapas.io, "Micro-joints"]: parts
//! below 150 mm are at risk, slats stand 50 to 75 mm apart).
//!
//! [lapas.io, "Micro-joints"]: https://lapas.io/blog/micro-joints-laser-cutting

use crate::fields::{Field, Kind, Range};
use crate::geometry::{Affine, Path};
use glam::DVec2;
use serde::{Deserialize, Serialize};
use std::f64::consts::PI;

const RADIUS: Range = Range::new(0.0, 200.0, "mm", "a nozzle is no wider than a hand");
const MARGIN: Range = Range::new(0.0, 200.0, "mm", "it keeps the nozzle clear of a piece that moves");
const PITCH: Range = Range::new(1.0, 1000.0, "mm", "slats that are farther apart carry no sheet");
const ANGLE: Range = Range::new(-PI, PI, "rad", "half a turn is every direction of slats");
const SIZE: Range = Range::new(0.0, 1e5, "mm", "a table is no larger than 100 m");

/// What falls, what tips, and what is done about it.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
#[cfg_attr(test, derive(ts_rs::TS), ts(optional_fields))]
pub struct Tips {
    /// What is done about moves with the head down over pieces that may have tipped. Default `avoid`, which needs
    /// [`Levers::lift`](super::Levers::lift).
    #[cfg_attr(test, ts(as = "Option<RiskyMoves>"))]
    pub risky_moves: RiskyMoves,
    /// Radius of the nozzle, mm. Default 10, a guess.
    #[cfg_attr(test, ts(as = "Option<f64>"))]
    pub nozzle_radius: f64,
    /// Distance that the nozzle keeps from a tipped piece, mm. Default 2, a guess.
    #[cfg_attr(test, ts(as = "Option<f64>"))]
    pub margin: f64,
    /// The slats under the sheet; `None`: not known.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[cfg_attr(test, ts(optional = nullable))]
    pub slats: Option<Slats>,
    /// Pieces smaller than this across the slats may tip, mm; without slats, pieces whose smaller extent along x or y is
    /// below it. Default 150, a guess.
    #[cfg_attr(test, ts(as = "Option<f64>"))]
    pub tips_below: f64,
    /// Pieces smaller than this both across and along the slats drop, mm. Default: the pitch of the slats; 50, a guess,
    /// where they are not known.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[cfg_attr(test, ts(optional = nullable))]
    pub drops_below: Option<f64>,
    /// What is cut out of holes up to this size along x and y may be crossed with the head down, mm. Default 0.
    #[cfg_attr(test, ts(as = "Option<f64>"))]
    pub cross_over: f64,
}

/// What is done about moves with the head down over pieces that may have tipped.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
#[cfg_attr(test, derive(ts_rs::TS))]
pub enum RiskyMoves {
    /// They are reported.
    Ignore,
    /// They go around these pieces, or over them with the head lifted, and the search chooses order and entries for it.
    #[default]
    Avoid,
}

/// The slats under the sheet.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(test, derive(ts_rs::TS), ts(optional_fields))]
pub struct Slats {
    /// Distance from slat to slat, mm.
    pub pitch: f64,
    /// Direction in which they run, from the x axis, rad. Default 0.
    #[serde(default)]
    #[cfg_attr(test, ts(as = "Option<f64>"))]
    pub angle: f64,
}

/// What becomes of a piece that is cut free.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Falls {
    /// It falls between the slats.
    Drops,
    /// It may stand up.
    Tips,
    /// It lies on the slats as before.
    Stays,
}

/// Distance between slats where it is not known, mm: the narrow ones of lapas.io.
const USUAL_PITCH: f64 = 50.0;

/// Sizes that differ by less are the same, mm: a circle of 150 mm is not below 150 mm, wherever it lies.
pub(crate) const SAME_SIZE: f64 = 1e-6;

impl Default for Tips {
    fn default() -> Self {
        Self {
            risky_moves: RiskyMoves::default(),
            nozzle_radius: 10.0,
            margin: 2.0,
            slats: None,
            tips_below: 150.0,
            drops_below: None,
            cross_over: 0.0,
        }
    }
}

impl Tips {
    /// The fields of the data.
    pub(super) const FIELDS: &'static [Field] = &[
        Field::optional("risky_moves", Kind::Choice(&["ignore", "avoid"])),
        Field::optional("nozzle_radius", Kind::Number(RADIUS)),
        Field::optional("margin", Kind::Number(MARGIN)),
        Field::nullable("slats", Kind::Object(SLATS)),
        Field::optional("tips_below", Kind::Number(SIZE)),
        Field::nullable("drops_below", Kind::Number(SIZE)),
        Field::optional("cross_over", Kind::Number(SIZE)),
    ];

    /// Whether moves keep clear of pieces that may have tipped.
    pub fn avoids(&self) -> bool {
        self.risky_moves == RiskyMoves::Avoid
    }

    /// How near the middle of the nozzle may come to a tipped piece, mm.
    pub fn reach(&self) -> f64 {
        self.nozzle_radius + self.margin
    }

    /// What becomes of a piece with these extents across and along the slats, mm.
    pub fn falls(&self, across: f64, along: f64) -> Falls {
        let pitch = self.slats.map_or(USUAL_PITCH, |s| s.pitch);
        let drops = self.drops_below.unwrap_or(pitch);
        let below = |size: f64, limit: f64| size < limit - SAME_SIZE;
        if below(across, drops) && below(along, drops) {
            Falls::Drops
        } else if below(across, self.tips_below) {
            Falls::Tips
        } else {
            Falls::Stays
        }
    }

    /// What becomes of what an outline bounds.
    pub fn falls_within(&self, outline: &Path) -> Falls {
        match self.slats {
            // Turned so that the slats run along x.
            Some(Slats { angle, .. }) => {
                let turned = outline.segments.iter().filter_map(|s| Affine::rotation(-angle).segment(s));
                let size = Path::new(turned.collect(), true).bounds().size();
                self.falls(size.y, size.x)
            }
            None => {
                let size = outline.bounds().size();
                self.falls(size.min_element(), size.max_element())
            }
        }
    }

    /// Whether what is cut out of a hole of this size, mm, may be crossed with the head down.
    pub fn crosses_over(&self, size: DVec2) -> bool {
        size.max_element() <= self.cross_over + SAME_SIZE
    }

    /// The numbers with their names and ranges.
    pub(super) fn numbers(&self) -> impl Iterator<Item = (&'static str, f64, Range)> + use<> {
        let slats = self.slats;
        [
            ("levers.tips.nozzle_radius", Some(self.nozzle_radius), RADIUS),
            ("levers.tips.margin", Some(self.margin), MARGIN),
            ("levers.tips.slats.pitch", slats.map(|s| s.pitch), PITCH),
            ("levers.tips.slats.angle", slats.map(|s| s.angle), ANGLE),
            ("levers.tips.tips_below", Some(self.tips_below), SIZE),
            ("levers.tips.drops_below", self.drops_below, SIZE),
            ("levers.tips.cross_over", Some(self.cross_over), SIZE),
        ]
        .into_iter()
        .filter_map(|(name, value, range)| Some((name, value?, range)))
    }
}

const SLATS: &[Field] =
    &[Field::required("pitch", Kind::Number(PITCH)), Field::optional("angle", Kind::Number(ANGLE))];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn size_and_slats_decide_what_falls() {
        let guess = Tips::default();
        // Unknown slats: 50 mm apart.
        assert_eq!(guess.falls(49.0, 49.0), Falls::Drops);
        assert_eq!(guess.falls(49.0, 51.0), Falls::Tips);
        assert_eq!(guess.falls(149.0, 900.0), Falls::Tips);
        assert_eq!(guess.falls(150.0, 150.0), Falls::Stays);
        // With a pitch, what fits between two slats both ways drops; with a limit of its own, what is below that.
        let slats = Tips { slats: Some(Slats { pitch: 80.0, angle: 0.0 }), ..guess };
        assert_eq!(slats.falls(79.0, 60.0), Falls::Drops);
        assert_eq!(slats.falls(20.0, 80.0), Falls::Tips);
        assert_eq!(Tips { drops_below: Some(30.0), ..slats }.falls(40.0, 40.0), Falls::Tips);
        assert!((guess.reach() - 12.0).abs() < 1e-12);
        assert!(!guess.crosses_over(DVec2::ONE));
        assert!(Tips { cross_over: 3.0, ..guess }.crosses_over(DVec2::new(3.0, 2.0)));
    }
}
