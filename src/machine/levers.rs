//! Data of the levers: abilities of a machine that make a job shorter and that a person switches on.
//!
//! With all of them off, plans are what they were without them.

use super::bridges::Bridges;
use super::corners::Corners;
use super::heat::Heat;
use super::tips::Tips;
use crate::fields::{Field, Kind, Range};
use serde::de::IgnoredAny;
use serde::{Deserialize, Deserializer, Serialize};

const OVERCUT: Range = Range::new(0.0, 100.0, "mm", "thin sheet is cut through after a few millimetres");
const REACH: Range =
    Range::new(0.1, 1000.0, "mm", "a head that runs on over more than that would rather stop");
const CHAIN: Range = Range::new(0.1, 1000.0, "mm", "a cut through more waste takes longer than piercing");
const CHAIN_CLEARANCE: Range =
    Range::new(0.0, 100.0, "mm", "a chain keeps away from everything that it does not join");
const SHIFT: Range =
    Range::new(0.0, 100.0, "mm", "a part that is moved further belongs elsewhere on the sheet");
const HEIGHT: Range = Range::new(0.1, 500.0, "mm", "a head is lifted over parts that may tip");
const STAY_DOWN: Range = Range::new(0.0, 1e5, "mm", "short moves are made with the head down");

/// Moves that are longer than [`Lift::stay_down`] or [`Fly::reach`] by less than this count as that long, mm: between equal holes of a grid, sums of
/// coordinates differ in their last digits.
const SAME_LENGTH: f64 = 1e-6;

/// Whether this build plans every lever. The core wasm leaves out those that few jobs use, so that a first visit of the page stays small: such
/// jobs are planned by the research build, as those of published methods are.
pub const PLANS_ALL_LEVERS: bool = cfg!(feature = "research");

/// The levers that are switched on.
#[derive(Clone, Copy, Debug, PartialEq, Default, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
#[cfg_attr(test, derive(ts_rs::TS), ts(optional_fields))]
pub struct Levers {
    /// The beam goes on as the head starts to move; `None`: the head pierces at rest.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub moving_pierce: Option<MovingPierce>,
    /// The head is lifted for moves with the beam off; `None`: it stays down.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub lift: Option<Lift>,
    /// Rows and grids of contours are cut on the run; `None`: the head stops before each contour.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub fly: Option<Fly>,
    /// Contours are joined by cuts through waste; `None`: the head pierces for each of them.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub chains: Option<Chains>,
    /// Parts stay connected by strips of material, so that their outlines are one cut; `None`: each outline is a cut.
    #[serde(deserialize_with = "bridges", skip_serializing_if = "no_bridges")]
    pub bridges: Option<Bridges>,
    /// Contours that share cuts, such as outlines one kerf apart, are pierced once and cut together; `None`: each is pierced.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub common_cuts: Option<SharedCuts>,
    /// Pieces that may tip up under the head, and what is done about moves over them; `None`: nothing is known of them.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub tips: Option<Tips>,
    /// Cuts near each other follow each other no sooner than stated, or at a charge; `None`: heat does not matter.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub heat: Option<Heat>,
    /// Corners are cut in a loop through waste or rounded, where that saves time; `None`: the beam turns in them.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub corners: Option<Corners>,
}

/// Fly cuts: the head runs along a row of contours, or along the sides of a grid of them, without stopping, and the beam is
/// switched while it runs.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(test, derive(ts_rs::TS), ts(optional_fields))]
pub struct Fly {
    /// Longest run with the beam off between two cuts, mm.
    pub reach: f64,
    /// Length of a contour cut in one go that is cut again at its end, because the beam was not through at its beginning, mm.
    /// Sides that are cut one by one are never cut again. Default 0.
    #[serde(default)]
    #[cfg_attr(test, ts(as = "Option<f64>"))]
    pub overcut: f64,
}

impl Fly {
    /// Whether the head runs on over `distance` mm with the beam off.
    pub fn reaches(&self, distance: f64) -> bool {
        distance <= self.reach + SAME_LENGTH
    }

    /// Length that a contour of `length` mm is cut again, mm: at most half of it.
    pub fn cut_again(&self, length: f64) -> f64 {
        self.overcut.min(0.5 * length)
    }
}

/// Chains: from the end of a contour the beam cuts straight through waste to the entry of the next one, where that takes less
/// time than switching it off, moving and piercing.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(test, derive(ts_rs::TS), ts(optional_fields))]
pub struct Chains {
    /// Longest cut through waste, mm.
    pub reach: f64,
    /// Least distance of such a cut from every contour but the two that it joins, and from these away from its ends, mm. Default 1.
    #[serde(default = "chain_clearance")]
    #[cfg_attr(test, ts(as = "Option<f64>"))]
    pub clearance: f64,
    /// Such a cut may also begin on the kerf of any contour that was cut before, or at the edge of the sheet: the head moves there
    /// with the beam off, and the beam goes on without piercing. Skeleton cuts begin at the edge and on each other, too. Default false.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    #[cfg_attr(test, ts(as = "Option<bool>"))]
    pub edge_starts: bool,
}

/// A millimetre, as between leads and other cuts: the edge of a part is not touched by the heat of the chain.
fn chain_clearance() -> f64 {
    1.0
}

/// Common cuts: contours that share cuts are pierced once and cut together, stretch by stretch. Where the beam begins again
/// on a kerf of theirs, it does not pierce.
#[derive(Clone, Copy, Debug, PartialEq, Default, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(test, derive(ts_rs::TS), ts(optional_fields))]
pub struct SharedCuts {
    /// Parts that would stand one kerf from a neighbour if they were moved by at most this are reported, mm. Default 0: none are.
    #[serde(default, skip_serializing_if = "crate::fields::is_zero")]
    #[cfg_attr(test, ts(as = "Option<f64>"))]
    pub shift: f64,
    /// These parts are moved. Default false.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    #[cfg_attr(test, ts(as = "Option<bool>"))]
    pub shift_parts: bool,
}

/// Lifting the head for moves with the beam off. It is lifted and lowered with the speed of the z axis
/// ([`Profile::z_speed`](super::Profile::z_speed)).
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(test, derive(ts_rs::TS), ts(optional_fields))]
pub struct Lift {
    /// How far the head is lifted, mm.
    pub height: f64,
    /// Moves up to this length are made with the head down, mm. Default 0.
    #[serde(default)]
    #[cfg_attr(test, ts(as = "Option<f64>"))]
    pub stay_down: f64,
    /// The head is lifted before it travels and lowered after that. Otherwise it is lifted during the first half of the way and
    /// lowered during the second. Default false.
    #[serde(default)]
    #[cfg_attr(test, ts(as = "Option<bool>"))]
    pub at_rest: bool,
}

impl Lift {
    /// Whether the head is lifted for a move of `distance` mm.
    pub fn is_for(&self, distance: f64) -> bool {
        distance > self.longest_down()
    }

    /// Length of the longest move with the head down, mm.
    pub(crate) fn longest_down(&self) -> f64 {
        self.stay_down + SAME_LENGTH
    }
}

/// Piercing while the head moves: for marks, and for closed cuts in material that is thin enough. Neither the piercing time
/// nor the delay of the beam before a cut is spent then.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(test, derive(ts_rs::TS), ts(optional_fields))]
pub struct MovingPierce {
    /// Length of a closed cut that is cut again at its end because the beam was not through at its beginning, mm. Default 0.
    #[serde(default)]
    #[cfg_attr(test, ts(as = "Option<f64>"))]
    pub overcut: f64,
}

/// Reads the bridges of a machine. A build that does not plan them only has to know that there are some, and is smaller so.
fn bridges<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Option<Bridges>, D::Error> {
    if PLANS_ALL_LEVERS {
        return Option::deserialize(deserializer);
    }
    let given = Option::<IgnoredAny>::deserialize(deserializer)?;
    Ok(given.map(|_| Bridges { width: 1.0, reach: 1.0, clearance: 1.0, most: None, cut_later: false }))
}

/// Whether the bridges of a machine are not written: there are none, or this build does not know what they are.
#[allow(clippy::trivially_copy_pass_by_ref, reason = "the signature that serde asks for")]
fn no_bridges(bridges: &Option<Bridges>) -> bool {
    !PLANS_ALL_LEVERS || bridges.is_none()
}

impl Levers {
    /// A lever that is switched on and that this build does not plan: its name, and what a machine with it does.
    pub fn not_in_this_build(&self) -> Option<(&'static str, &'static str)> {
        let not_in_core = [
            (self.fly.is_some(), "fly", "cuts on the run"),
            (self.chains.is_some(), "chains", "joins contours through waste"),
            (self.bridges.is_some(), "bridges", "connects parts by bridges"),
            (self.common_cuts.is_some(), "common_cuts", "cuts what shares cuts together"),
            (self.tips.is_some(), "tips", "minds pieces that tip"),
            (self.heat.is_some(), "heat", "minds heat"),
            (self.corners.is_some(), "corners", "cuts corners in loops or rounds them"),
        ];
        let on = not_in_core.into_iter().find(|lever| lever.0)?;
        (!PLANS_ALL_LEVERS).then_some((on.1, on.2))
    }

    /// The fields of the data.
    pub(super) const FIELDS: &'static [Field] = &[
        Field::nullable("moving_pierce", Kind::Object(MOVING_PIERCE)),
        Field::nullable("lift", Kind::Object(LIFT)),
        Field::nullable("fly", Kind::Object(FLY)),
        Field::nullable("chains", Kind::Object(CHAINS)),
        Field::nullable("bridges", Kind::Object(Bridges::FIELDS)),
        Field::nullable("common_cuts", Kind::Object(SHARED)),
        Field::nullable("tips", Kind::Object(Tips::FIELDS)),
        Field::nullable("heat", Kind::Object(Heat::FIELDS)),
        Field::nullable("corners", Kind::Object(Corners::FIELDS)),
    ];

    /// Whether moves go around pieces that may have tipped, or over them with the head lifted. Then the head is lifted for
    /// no other moves.
    pub fn avoid_tips(&self) -> bool {
        self.tips.is_some_and(|tips| tips.avoids())
    }

    /// The lift, where the length of a move alone decides whether the head is lifted for it.
    pub fn lift_by_length(&self) -> Option<Lift> {
        self.lift.filter(|_| !self.avoid_tips())
    }

    /// Length that a contour of `length` mm is cut again because it was pierced at speed, mm: at most half of it.
    pub fn cut_again(&self, length: f64) -> f64 {
        self.moving_pierce.map_or(0.0, |p| p.overcut.min(0.5 * length))
    }

    /// Whether all are off.
    pub fn is_none(&self) -> bool {
        *self == Self::default()
    }

    /// The numbers with their names and ranges, but for those of bridges, which the planner that has them checks.
    pub(super) fn numbers(&self) -> impl Iterator<Item = (&'static str, f64, Range)> {
        let overcut = self.moving_pierce.map(|p| ("levers.moving_pierce.overcut", p.overcut, OVERCUT));
        let lift = self.lift.map(|l| {
            [("levers.lift.height", l.height, HEIGHT), ("levers.lift.stay_down", l.stay_down, STAY_DOWN)]
        });
        let fly = self
            .fly
            .map(|f| [("levers.fly.reach", f.reach, REACH), ("levers.fly.overcut", f.overcut, OVERCUT)]);
        let chains = self.chains.map(|c| {
            [
                ("levers.chains.reach", c.reach, CHAIN),
                ("levers.chains.clearance", c.clearance, CHAIN_CLEARANCE),
            ]
        });
        let shift = self.common_cuts.map(|c| ("levers.common_cuts.shift", c.shift, SHIFT));
        let tips = self.tips.iter().flat_map(Tips::numbers);
        let heat = self.heat.iter().flat_map(Heat::numbers);
        let corners = self.corners.iter().flat_map(Corners::numbers);
        let motion = [lift, fly, chains].into_iter().flatten().flatten();
        overcut.into_iter().chain(motion).chain(shift).chain(tips).chain(heat).chain(corners)
    }
}

const MOVING_PIERCE: &[Field] = &[Field::optional("overcut", Kind::Number(OVERCUT))];

const LIFT: &[Field] = &[
    Field::required("height", Kind::Number(HEIGHT)),
    Field::optional("stay_down", Kind::Number(STAY_DOWN)),
    Field::optional("at_rest", Kind::Flag),
];

const FLY: &[Field] =
    &[Field::required("reach", Kind::Number(REACH)), Field::optional("overcut", Kind::Number(OVERCUT))];

const CHAINS: &[Field] = &[
    Field::required("reach", Kind::Number(CHAIN)),
    Field::optional("clearance", Kind::Number(CHAIN_CLEARANCE)),
    Field::optional("edge_starts", Kind::Flag),
];

const SHARED: &[Field] =
    &[Field::optional("shift", Kind::Number(SHIFT)), Field::optional("shift_parts", Kind::Flag)];
