//! Data of lead-ins, lead-outs and overcuts: which contours get which, as rules of the machine and its material.
//!
//! A *lead-in* is a cut through scrap from the place of piercing to the contour, so that the mark of piercing is not on the
//! part. A *lead-out* leaves the contour again before the beam goes off. An *overcut* follows the contour on beyond its
//! start, so that no hair remains there.
//!
//! Names follow CypCut and WiCAM (none, line, arc, line and arc). The default sizes are guesses within what makers of
//! lasers recommend, one and a half to three times the kerf; the material decides.

use crate::fields::{Field, Kind, Range};
use serde::{Deserialize, Serialize};
use std::f64::consts::{FRAC_PI_2, PI};

const CLEARANCE: Range = Range::new(0.0, 1000.0, "mm", "no part needs more space around it");
const LEAD_ANGLE: Range =
    Range::new(0.01, PI, "rad", "a lead leaves its contour, and turns by at most half a turn");
const LEAD: Range = Range::new(0.01, 1000.0, "mm", "a lead is longer than the beam is wide");
const OVERCUT: Range = Range::new(-100.0, 1000.0, "mm", "an overcut only closes the cut");
const SHARE: Range = Range::new(0.01, 1.0, "", "it is a fraction of the radius of the hole");
const SIZE: Range = Range::new(0.0, 1e6, "mm", "no contour is longer than 1 km");

/// Lead-ins, lead-outs and overcuts of a machine with a material.
#[derive(Clone, Debug, PartialEq, Default, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct Leads {
    /// Least distance of leads from everything that is not scrap, mm. A lead touches its own contour only where it joins.
    pub clearance: f64,
    /// The first rule that fits a contour applies to it. A contour that none fits has no lead.
    pub rules: Vec<LeadRule>,
}

/// The leads of some contours. Conditions that are not given fit every contour.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(test, derive(ts_rs::TS), ts(optional_fields))]
pub struct LeadRule {
    /// Fits holes or outlines of parts only.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub side: Option<LeadSide>,
    /// Fits contours whose box has a longer side below this, mm: of a circle, the diameter.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub diameter_below: Option<f64>,
    /// Fits contours that are shorter than this, mm.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub perimeter_below: Option<f64>,
    /// From the place of piercing to the contour.
    pub lead_in: LeadShape,
    /// From the contour to where the beam goes off. Default: none.
    #[serde(default)]
    #[cfg_attr(test, ts(as = "Option<LeadShape>"))]
    pub lead_out: LeadShape,
    /// Where leads join the contour. Default: anywhere.
    #[serde(default)]
    #[cfg_attr(test, ts(as = "Option<LeadPosition>"))]
    pub position: LeadPosition,
    /// Greatest size of a lead in a hole, as a fraction of the radius of the largest circle in the hole. Default 0.4.
    #[serde(default = "max_share")]
    #[cfg_attr(test, ts(as = "Option<f64>"))]
    pub max_share: f64,
    /// Length of the contour that is cut again after its start, mm; negative: length that is left uncut before it. It is at
    /// most half of the contour. Default 0.
    #[serde(default)]
    #[cfg_attr(test, ts(as = "Option<f64>"))]
    pub overcut: f64,
}

/// Which side of a contour is scrap.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
#[cfg_attr(test, derive(ts_rs::TS))]
pub enum LeadSide {
    /// Holes: the inside is scrap.
    Hole,
    /// Outlines of parts: the outside is scrap.
    Outer,
}

/// Where leads join a contour.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
#[cfg_attr(test, derive(ts_rs::TS))]
pub enum LeadPosition {
    /// Wherever the search enters the contour.
    #[default]
    Any,
    /// At its corners; anywhere on contours without corners.
    Corner,
    /// In the middle of its sides.
    Side,
}

/// The form of a lead.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
#[cfg_attr(test, derive(ts_rs::TS))]
pub enum LeadKind {
    /// No lead: the beam goes on or off on the contour.
    #[default]
    None,
    /// A straight line.
    Line,
    /// An arc that is tangent to the contour.
    Arc,
    /// A line that continues as an arc, which is tangent to the contour.
    LineArc,
    /// A straight line from the centre of the largest circle in the hole. Outlines of parts get a line instead.
    Center,
}

/// The names of the forms of leads.
pub(crate) const LEAD_KINDS: &[&str] = &["none", "line", "arc", "line-arc", "center"];

/// One lead.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(test, derive(ts_rs::TS), ts(optional_fields))]
pub struct LeadShape {
    /// Its form.
    pub kind: LeadKind,
    /// Length of the line, mm. Default 3.
    #[serde(default = "length")]
    #[cfg_attr(test, ts(as = "Option<f64>"))]
    pub length: f64,
    /// Radius of the arc, mm. Default 1.5.
    #[serde(default = "radius")]
    #[cfg_attr(test, ts(as = "Option<f64>"))]
    pub radius: f64,
    /// Of a line the angle to the contour, of an arc its sweep, rad. Default pi/2.
    #[serde(default = "angle")]
    #[cfg_attr(test, ts(as = "Option<f64>"))]
    pub angle: f64,
}

fn max_share() -> f64 {
    0.4
}

fn length() -> f64 {
    3.0
}

fn radius() -> f64 {
    1.5
}

fn angle() -> f64 {
    FRAC_PI_2
}

impl Default for LeadRule {
    fn default() -> Self {
        Self {
            side: None,
            diameter_below: None,
            perimeter_below: None,
            lead_in: LeadShape::default(),
            lead_out: LeadShape::default(),
            position: LeadPosition::default(),
            max_share: max_share(),
            overcut: 0.0,
        }
    }
}

impl Default for LeadShape {
    fn default() -> Self {
        Self { kind: LeadKind::None, length: length(), radius: radius(), angle: angle() }
    }
}

impl Leads {
    /// The fields of the data.
    pub(super) const FIELDS: &'static [Field] = &[
        Field::required("clearance", Kind::Number(CLEARANCE)),
        Field::required("rules", Kind::List(&Kind::Object(LeadRule::FIELDS))),
    ];

    /// The first rule that fits a contour; `extent` is the longer side of its box, mm.
    pub fn rule(&self, side: LeadSide, extent: f64, perimeter: f64) -> Option<&LeadRule> {
        self.rules.iter().find(|r| {
            r.side.is_none_or(|s| s == side)
                && r.diameter_below.is_none_or(|d| extent < d)
                && r.perimeter_below.is_none_or(|p| perimeter < p)
        })
    }

    /// The numbers with their names and ranges.
    pub(super) fn numbers(&self) -> impl Iterator<Item = (&'static str, f64, Range)> {
        let rules = self.rules.iter().flat_map(|r| {
            [
                ("leads.rules.diameter_below", r.diameter_below.unwrap_or(SIZE.most), SIZE),
                ("leads.rules.perimeter_below", r.perimeter_below.unwrap_or(SIZE.most), SIZE),
                ("leads.rules.lead_in.length", r.lead_in.length, LEAD),
                ("leads.rules.lead_in.radius", r.lead_in.radius, LEAD),
                ("leads.rules.lead_in.angle", r.lead_in.angle, LEAD_ANGLE),
                ("leads.rules.lead_out.length", r.lead_out.length, LEAD),
                ("leads.rules.lead_out.radius", r.lead_out.radius, LEAD),
                ("leads.rules.lead_out.angle", r.lead_out.angle, LEAD_ANGLE),
                ("leads.rules.max_share", r.max_share, SHARE),
                ("leads.rules.overcut", r.overcut, OVERCUT),
            ]
        });
        [("leads.clearance", self.clearance, CLEARANCE)].into_iter().chain(rules)
    }
}

impl LeadRule {
    /// The same rule with a lead-in of another form; with none there is no lead-out either.
    pub(crate) fn with_lead_in(mut self, kind: LeadKind) -> Self {
        self.lead_in.kind = kind;
        if kind == LeadKind::None {
            self.lead_out.kind = kind;
        }
        self
    }

    const FIELDS: &'static [Field] = &[
        Field::nullable("side", Kind::Choice(&["hole", "outer"])),
        Field::nullable("diameter_below", Kind::Number(SIZE)),
        Field::nullable("perimeter_below", Kind::Number(SIZE)),
        Field::required("lead_in", Kind::Object(LeadShape::FIELDS)),
        Field::optional("lead_out", Kind::Object(LeadShape::FIELDS)),
        Field::optional("position", Kind::Choice(&["any", "corner", "side"])),
        Field::optional("max_share", Kind::Number(SHARE)),
        Field::optional("overcut", Kind::Number(OVERCUT)),
    ];
}

impl LeadShape {
    const FIELDS: &'static [Field] = &[
        Field::required("kind", Kind::Choice(LEAD_KINDS)),
        Field::optional("length", Kind::Number(LEAD)),
        Field::optional("radius", Kind::Number(LEAD)),
        Field::optional("angle", Kind::Number(LEAD_ANGLE)),
    ];

    /// How far it reaches into the scrap at most, mm, as far as its own numbers say.
    pub fn size(&self) -> f64 {
        match self.kind {
            LeadKind::None => 0.0,
            LeadKind::Line | LeadKind::Center => self.length,
            LeadKind::Arc => self.radius,
            LeadKind::LineArc => self.radius + self.length,
        }
    }

    /// The same lead with all lengths multiplied by `by`.
    pub fn scaled(self, by: f64) -> Self {
        Self { length: self.length * by, radius: self.radius * by, ..self }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn line(length: f64) -> LeadShape {
        LeadShape { kind: LeadKind::Line, length, ..LeadShape::default() }
    }

    #[test]
    fn the_first_rule_that_fits_applies() {
        let rule = |side, diameter_below, perimeter_below, length| LeadRule {
            side,
            diameter_below,
            perimeter_below,
            lead_in: line(length),
            ..LeadRule::default()
        };
        let leads = Leads {
            clearance: 1.0,
            rules: vec![
                rule(Some(LeadSide::Hole), Some(5.0), None, 1.0),
                rule(Some(LeadSide::Hole), None, None, 2.0),
                rule(None, None, Some(100.0), 3.0),
            ],
        };
        let length = |side, extent, perimeter| leads.rule(side, extent, perimeter).map(|r| r.lead_in.length);
        assert_eq!(length(LeadSide::Hole, 4.9, 500.0), Some(1.0));
        assert_eq!(length(LeadSide::Hole, 5.0, 500.0), Some(2.0));
        assert_eq!(length(LeadSide::Outer, 4.9, 99.0), Some(3.0));
        assert_eq!(length(LeadSide::Outer, 4.9, 100.0), None);
    }

    #[test]
    fn what_is_not_given_has_its_default() {
        let text = r#"{"clearance": 1, "rules": [{"lead_in": {"kind": "line-arc"}}]}"#;
        let leads: Leads = serde_json::from_str(text).unwrap();
        let rule = &leads.rules[0];
        assert_eq!(
            rule.lead_in,
            LeadShape { kind: LeadKind::LineArc, length: 3.0, radius: 1.5, angle: FRAC_PI_2 }
        );
        assert_eq!((rule.lead_out.kind, rule.position), (LeadKind::None, LeadPosition::Any));
        assert_eq!((rule.max_share, rule.overcut), (0.4, 0.0));
    }
}
