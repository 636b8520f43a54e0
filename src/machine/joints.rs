//! Data of micro-joints (tabs, bridges): short lengths of a contour that stay uncut and hold its piece in the sheet.
//!
//! Which contours get how many is said by rules, as in WiCAM ("lug width", "maximum length without lug", "check X and Y")
//! and AMADA (ranges of sizes, each with a number of joints). Joints that a person places by hand are part of the options
//! of the sheet ([`crate::sheet::HandJoint`]). The default sizes are guesses: makers of lasers recommend 0.2 to 1 mm.

use super::leads::LeadSide;
use crate::fields::{Field, Kind, Range};
use serde::{Deserialize, Serialize};

const WIDTH: Range = Range::new(0.01, 100.0, "mm", "a joint is broken by hand");
/// Number of joints of a contour.
pub(crate) const JOINT_COUNT: Range = Range::new(0.0, 1000.0, "", "nobody breaks more joints");
const SPACING: Range = Range::new(1.0, 1e6, "mm", "joints are further apart than they are wide");
const SIZE: Range = Range::new(0.0, 1e6, "mm", "no contour is larger than 1 km");
const CLEARANCE: Range = Range::new(0.0, 1000.0, "mm", "sides of contours are shorter");

/// Micro-joints of a machine with a material.
#[derive(Clone, Debug, PartialEq, Default, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct Joints {
    /// The first rule that fits a contour applies to it. A contour that none fits has no joints, unless they are placed by
    /// hand.
    pub rules: Vec<JointRule>,
}

/// The joints of some contours. Conditions that are not given fit every contour.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
#[cfg_attr(test, derive(ts_rs::TS), ts(optional_fields))]
pub struct JointRule {
    /// Fits holes or outlines of parts only.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub side: Option<LeadSide>,
    /// Fits contours whose box is at least this large in x and y, mm.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub size_min: Option<[f64; 2]>,
    /// Fits contours whose box is at most this large in x and y, mm.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub size_max: Option<[f64; 2]>,
    /// Whether the sizes in x and in y have to be within the limits, or one of them is enough. Default `and`.
    #[cfg_attr(test, ts(as = "Option<SizeTest>"))]
    pub test: SizeTest,
    /// Width of the material that holds, mm. The width of the cut is added to it. Default 0.5.
    #[cfg_attr(test, ts(as = "Option<f64>"))]
    pub width: f64,
    /// Least number of joints. Default 2.
    #[cfg_attr(test, ts(as = "Option<u32>"))]
    pub count: u32,
    /// Greatest length that is cut without a joint, mm; not given: any.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub spacing: Option<f64>,
    /// Least distance of joints from corners, mm. Default 2.
    #[cfg_attr(test, ts(as = "Option<f64>"))]
    pub corner_clearance: f64,
    /// Whether the head stops at a joint. Default `stop`.
    #[cfg_attr(test, ts(as = "Option<JointKind>"))]
    pub kind: JointKind,
}

/// How the sizes of a contour are compared with the limits of a rule.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
#[cfg_attr(test, derive(ts_rs::TS))]
pub enum SizeTest {
    /// Both sizes are within the limits.
    #[default]
    And,
    /// At least one of them is.
    Or,
}

/// How a joint is left uncut.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
#[cfg_attr(test, derive(ts_rs::TS))]
pub enum JointKind {
    /// The beam goes off, the head moves over the joint, and pierces again.
    #[default]
    Stop,
    /// The head keeps moving, and the power is 0 over the joint.
    Flying,
}

impl Default for JointRule {
    fn default() -> Self {
        Self {
            side: None,
            size_min: None,
            size_max: None,
            test: SizeTest::default(),
            width: 0.5,
            count: 2,
            spacing: None,
            corner_clearance: 2.0,
            kind: JointKind::default(),
        }
    }
}

impl Joints {
    /// The fields of the data.
    pub(super) const FIELDS: &'static [Field] =
        &[Field::required("rules", Kind::List(&Kind::Object(JointRule::FIELDS)))];

    /// The first rule that fits a contour with a box of this size, mm.
    pub fn rule(&self, side: LeadSide, size: [f64; 2]) -> Option<&JointRule> {
        self.rules.iter().find(|r| r.fits(side, size))
    }

    /// The numbers with their names and ranges.
    pub(super) fn numbers(&self) -> impl Iterator<Item = (&'static str, f64, Range)> {
        self.rules.iter().flat_map(|r| {
            let ([x0, y0], [x1, y1]) = (r.size_min.unwrap_or_default(), r.size_max.unwrap_or_default());
            [
                ("joints.rules.size_min[0]", x0, SIZE),
                ("joints.rules.size_min[1]", y0, SIZE),
                ("joints.rules.size_max[0]", x1, SIZE),
                ("joints.rules.size_max[1]", y1, SIZE),
                ("joints.rules.width", r.width, WIDTH),
                ("joints.rules.count", r.count.into(), JOINT_COUNT),
                ("joints.rules.spacing", r.spacing.unwrap_or(SPACING.most), SPACING),
                ("joints.rules.corner_clearance", r.corner_clearance, CLEARANCE),
            ]
        })
    }
}

impl JointRule {
    const FIELDS: &'static [Field] = &[
        Field::nullable("side", Kind::Choice(&["hole", "outer"])),
        Field::nullable("size_min", Kind::Pair(&Kind::Number(SIZE))),
        Field::nullable("size_max", Kind::Pair(&Kind::Number(SIZE))),
        Field::optional("test", Kind::Choice(&["and", "or"])),
        Field::optional("width", Kind::Number(WIDTH)),
        Field::optional("count", Kind::Whole(JOINT_COUNT)),
        Field::nullable("spacing", Kind::Number(SPACING)),
        Field::optional("corner_clearance", Kind::Number(CLEARANCE)),
        Field::optional("kind", Kind::Choice(&["stop", "flying"])),
    ];

    fn fits(&self, side: LeadSide, size: [f64; 2]) -> bool {
        let least = self.size_min.unwrap_or([0.0; 2]);
        let most = self.size_max.unwrap_or([f64::INFINITY; 2]);
        let within = |k: usize| (least[k]..=most[k]).contains(&size[k]);
        let fits = match self.test {
            SizeTest::And => within(0) && within(1),
            SizeTest::Or => within(0) || within(1),
        };
        fits && self.side.is_none_or(|s| s == side)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_size_window_takes_one_or_both_sizes() {
        let rule = |test, side| JointRule {
            side,
            size_min: Some([10.0, 20.0]),
            size_max: Some([100.0, 50.0]),
            test,
            ..JointRule::default()
        };
        let fits = |test, size| rule(test, None).fits(LeadSide::Outer, size);
        for (size, both, one) in [
            ([10.0, 50.0], true, true),
            ([9.9, 30.0], false, true),
            ([100.1, 30.0], false, true),
            ([50.0, 50.1], false, true),
            ([5.0, 5.0], false, false),
        ] {
            assert_eq!((fits(SizeTest::And, size), fits(SizeTest::Or, size)), (both, one), "{size:?}");
        }
        let of = |side| rule(SizeTest::And, Some(side)).fits(LeadSide::Outer, [50.0, 30.0]);
        assert!(of(LeadSide::Outer) && !of(LeadSide::Hole));
    }

    #[test]
    fn what_is_not_given_has_its_default_and_the_first_rule_applies() {
        let joints: Joints =
            serde_json::from_str(r#"{"rules": [{"side": "hole", "count": 1}, {"width": 0.2}]}"#).unwrap();
        let [hole, other] = joints.rules.as_slice() else { panic!("two rules") };
        assert_eq!(*hole, JointRule { side: Some(LeadSide::Hole), count: 1, ..JointRule::default() });
        assert_eq!(*other, JointRule { width: 0.2, ..JointRule::default() });
        assert_eq!(joints.rule(LeadSide::Hole, [1.0; 2]), Some(hole));
        assert_eq!(joints.rule(LeadSide::Outer, [1.0; 2]), Some(other));
    }
}
