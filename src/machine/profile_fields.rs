//! The fields of machine profiles and of the settings of layers, with the range of every number.
//!
//! The limits are wide. They reject mistakes (a lost decimal point, metres instead of millimetres) and numbers that a
//! controller cannot read, but not unusual machines.

use super::dialect::Dialect;
use super::joints::Joints;
use super::leads::Leads;
use super::levers::Levers;
use super::profile::Profile;
use super::settings::Settings;
use super::skeleton::Skeleton;
use crate::fields::{Field, Kind, Range, Shape, Shaped};
use std::f64::consts::PI;

/// The only version of the data so far; later code will convert older versions on reading.
pub(super) const VERSION: u32 = 1;

pub(super) const VERSIONS: Range =
    Range::new(1.0, 1.0, "", "this Kerfway reads machine profiles of version 1");
pub(super) const PLACE: Range = Range::new(-1e6, 1e6, "mm", "no table reaches further than 1 km");
pub(super) const SPEED: Range = Range::new(
    1e-3,
    1e5,
    "mm/s",
    "no head is faster than 100 m/s, and none cuts a millimetre in over 15 minutes",
);
pub(super) const ACCEL: Range = Range::new(0.1, 1e7, "mm/s2", "no drive accelerates with more than 1,000 g");
pub(super) const PASSES: Range =
    Range::new(1.0, 100.0, "", "a beam that needs more does not cut the material");
pub(super) const Z_STEP: Range = Range::new(0.0, 50.0, "mm", "a pass cuts no deeper");
pub(super) const POWER: Range = Range::new(0.0, 1.0, "", "it is a fraction of full power");
pub(super) const DEVIATION: Range =
    Range::new(0.0, 10.0, "mm", "a corner rounded by more is not the corner drawn");
pub(super) const WAIT: Range =
    Range::new(0.0, 600.0, "s", "thick plate is pierced in seconds, so ten minutes are a slip");
pub(super) const PRE_CUT: Range = Range::new(0.0, 1000.0, "mm", "a pre-cut is a short start of a cut");
pub(super) const ANGLE: Range = Range::new(0.0, PI, "rad", "corners have at most half a turn");
/// Half of the smallest kerf is the distance within which lines are duplicates. Water jets cut 1 mm wide, plasma up to
/// 10 mm.
pub(super) const KERF: Range =
    Range::new(0.02, 10.0, "mm", "no beam is thinner, and no jet or plasma cuts wider").or_zero();
pub(super) const DELAY: Range = Range::new(0.0, 60.0, "s", "a beam settles within a second or so");
pub(super) const FULL: Range =
    Range::new(1.0, 1e6, "", "controllers take numbers of a few digits for full power");

pub(super) const SHAPE: Shape = Shape {
    owner: "The machine",
    item: "field",
    value: "The machine's field",
    fields: &[
        Field::required("version", Kind::Whole(VERSIONS)),
        Field::required("name", Kind::Text),
        Field::required("title", Kind::Text),
        Field::required("home", Kind::Pair(&Kind::Number(PLACE))),
        Field::nullable("bed", Kind::Four(&Kind::Number(PLACE))),
        Field::required("return_home", Kind::Flag),
        Field::required("travel", Kind::Choice(&["straight", "vector", "per-axis"])),
        Field::required("rapid", Kind::Object(RAPID)),
        Field::required("cut", Kind::Object(PROCESS)),
        Field::required("mark", Kind::Object(PROCESS)),
        Field::nullable("junction_deviation", Kind::Number(DEVIATION)),
        Field::required("pierce_time", Kind::Number(WAIT)),
        Field::nullable("pre_cut_time", Kind::Number(WAIT)),
        Field::optional("pre_cut_length", Kind::Number(PRE_CUT)),
        Field::nullable("sharp_corner", Kind::Object(CORNER)),
        Field::optional("kerf_width", Kind::Number(KERF)),
        Field::nullable("z_speed", Kind::Number(SPEED)),
        Field::optional("materials", Kind::List(&Kind::Object(MATERIAL))),
        Field::nullable("leads", Kind::Object(Leads::FIELDS)),
        Field::optional("levers", Kind::Object(Levers::FIELDS)),
        Field::nullable("joints", Kind::Object(Joints::FIELDS)),
        Field::nullable("skeleton", Kind::Object(Skeleton::FIELDS)),
        Field::required("beam_on_delay", Kind::Number(DELAY)),
        Field::required("beam_off_delay", Kind::Number(DELAY)),
        Field::optional("takes", Kind::Choice(&["gcode", "dxf", "svg"])),
        Field::required("dialect", Kind::NameOr(&Dialect::SHAPE)),
        Field::required("max_s", Kind::Number(FULL)),
    ],
};

const RAPID: &[Field] = &[
    Field::required("speed", Kind::Pair(&Kind::Number(SPEED))),
    Field::nullable("accel", Kind::Pair(&Kind::Number(ACCEL))),
];

const PROCESS: &[Field] = &[
    Field::required("speed", Kind::Number(SPEED)),
    Field::nullable("accel", Kind::Number(ACCEL)),
    Field::required("power", Kind::Number(POWER)),
    Field::nullable("min_power", Kind::Number(POWER)),
    Field::optional("passes", Kind::Whole(PASSES)),
    Field::optional("z_step", Kind::Number(Z_STEP)),
    Field::optional("air", Kind::Flag),
];

const MATERIAL: &[Field] = &[
    Field::required("name", Kind::Text),
    Field::optional("cut", Kind::Object(SETTINGS)),
    Field::optional("mark", Kind::Object(SETTINGS)),
    Field::nullable("pierce_time", Kind::Number(WAIT)),
    Field::nullable("kerf_width", Kind::Number(KERF)),
];

const SETTINGS: &[Field] = &[
    Field::nullable("speed", Kind::Number(SPEED)),
    Field::nullable("power", Kind::Number(POWER)),
    Field::nullable("min_power", Kind::Number(POWER)),
    Field::nullable("passes", Kind::Whole(PASSES)),
    Field::nullable("z_step", Kind::Number(Z_STEP)),
    Field::nullable("air", Kind::Flag),
];

/// The settings of a layer, as callers write them.
pub const LAYER_SETTINGS: &[Field] = &[
    Field::required("name", Kind::Text),
    Field::nullable("operation", Kind::Choice(&["cut", "mark", "ignore"])),
    Field::nullable("speed", Kind::Number(SPEED)),
    Field::nullable("power", Kind::Number(POWER)),
    Field::nullable("minPower", Kind::Number(POWER)),
    Field::nullable("passes", Kind::Whole(PASSES)),
    Field::nullable("zStep", Kind::Number(Z_STEP)),
    Field::nullable("air", Kind::Flag),
];

const CORNER: &[Field] =
    &[Field::required("angle", Kind::Number(ANGLE)), Field::required("time", Kind::Number(WAIT))];

impl Shaped for Profile {
    const SHAPE: Shape = SHAPE;
}

/// Checks the settings of a layer; the error is the name of the first wrong field, its value and its range.
pub fn check_settings(settings: &Settings) -> Result<(), (&'static str, f64, Range)> {
    let values = [
        ("speed", settings.speed, SPEED),
        ("power", settings.power, POWER),
        ("minPower", settings.min_power, POWER),
        ("passes", settings.passes.map(f64::from), PASSES),
        ("zStep", settings.z_step, Z_STEP),
    ];
    let given = values.into_iter().filter_map(|(field, value, range)| Some((field, value?, range)));
    given.into_iter().find(|(_, value, range)| !range.holds(*value)).map_or(Ok(()), Err)
}
