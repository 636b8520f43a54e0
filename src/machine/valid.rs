//! Validates machine profiles: their fields, and the range of every number.
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
use crate::fields::{Fault, Field, FieldError, Kind, Range, Shape, Shaped, out_of_range};
use crate::letters::same_name;
use std::f64::consts::PI;

/// The only version of the data so far; later code will convert older versions on reading.
pub(super) const VERSION: u32 = 1;

/// Why a profile cannot be used, as one sentence for people.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum ProfileError {
    /// A value is out of its range.
    #[error("{}", out_of_range(SHAPE.value, .field, *.value, .range))]
    Value {
        /// Name of the field, as written in the data.
        field: &'static str,
        /// Its value.
        value: f64,
        /// Its valid range.
        range: Range,
    },
    /// Two materials have one name, or one has none.
    #[error("The machine's materials: {0} Give each a name of its own.")]
    Materials(String),
    /// The bed has no area.
    #[error(
        "The machine's field \"bed\" is [{0}, {1}, {2}, {3}]. Give [xmin, ymin, xmax, ymax] in mm, the least values first."
    )]
    Bed(f64, f64, f64, f64),
    /// A lever that the machine cannot have.
    #[error(
        "The machine has levers.moving_pierce and pre_cut_time. A cut that is left unfinished is not begun moving: give one of them."
    )]
    MovingPreCuts,
    /// Contours are to be cut on the run on a machine that leaves cuts unfinished.
    #[error(
        "The machine has levers.fly and pre_cut_time. Plate that is cut with pre-cuts is not cut on the run: give one of them."
    )]
    FlyPreCuts,
    /// Contours are to be joined by cuts through waste on a machine that leaves cuts unfinished or pauses in corners.
    #[error(
        "The machine has levers.chains and {0}. Chains are planned for machines that cut each contour in one go, and turn corners with the beam on: give one of them."
    )]
    ChainsWith(&'static str),
    /// Contours are to be cut together on a machine that does something in between for which they are not planned.
    #[error(
        "The machine has levers.common_cuts and {0}. Contours that are cut together are planned without it: give one of them."
    )]
    CommonCutsWith(&'static str),
    /// The head is to be lifted, and there is no speed for it.
    #[error(
        "The machine has levers.lift, but no z_speed. Give the speed of the z axis, or leave out the lift."
    )]
    LiftWithoutZ,
    /// Moves are to avoid tipped pieces, and the head cannot be lifted over them.
    #[error(
        "The machine's levers.tips avoids risky moves, but there is no levers.lift. Give the lift, or set risky_moves to \"ignore\"."
    )]
    TipsWithoutLift,
    /// Contours are left unfinished, and the search is to avoid tipped pieces.
    #[error(
        "The machine's levers.tips avoids risky moves, and the machine has pre_cut_time. Cuts that are left unfinished are not planned around tipped pieces: leave out pre_cut_time, or set risky_moves to \"ignore\"."
    )]
    TipsWithPreCuts,
    /// Cuts are to keep apart, and rows of them are cut on the run.
    #[error(
        "The machine has levers.heat and levers.fly. Contours that are cut on the run follow each other at once: give one of them."
    )]
    HeatWithFly,
    /// Cuts are to keep apart, and contours are left unfinished.
    #[error(
        "The machine has levers.heat and pre_cut_time. Cuts that are left unfinished are not planned with heat in mind: give one of them."
    )]
    HeatWithPreCuts,
    /// There is no such dialect, or its document contradicts itself.
    #[error("{0}")]
    Dialect(String),
}

impl From<ProfileError> for FieldError {
    fn from(error: ProfileError) -> Self {
        match error {
            ProfileError::Value { field, value, range } => {
                Self::out_of_range(SHAPE.value, field, value, &range)
            }
            ProfileError::Materials(_) => Self::new(Fault::Contradiction, "materials", error.to_string()),
            ProfileError::Bed(..) => Self::new(Fault::Contradiction, "bed", error.to_string()),
            ProfileError::LiftWithoutZ => Self::new(Fault::Contradiction, "levers.lift", error.to_string()),
            ProfileError::TipsWithoutLift | ProfileError::TipsWithPreCuts => {
                Self::new(Fault::Contradiction, "levers.tips", error.to_string())
            }
            ProfileError::HeatWithFly | ProfileError::HeatWithPreCuts => {
                Self::new(Fault::Contradiction, "levers.heat", error.to_string())
            }
            ProfileError::MovingPreCuts => {
                Self::new(Fault::Contradiction, "levers.moving_pierce", error.to_string())
            }
            ProfileError::ChainsWith(_) => {
                Self::new(Fault::Contradiction, "levers.chains", error.to_string())
            }
            ProfileError::CommonCutsWith(_) => {
                Self::new(Fault::Contradiction, "levers.common_cuts", error.to_string())
            }
            ProfileError::FlyPreCuts => Self::new(Fault::Contradiction, "levers.fly", error.to_string()),
            ProfileError::Dialect(sentence) => Self::new(Fault::Contradiction, "dialect", sentence),
        }
    }
}

const VERSIONS: Range = Range::new(1.0, 1.0, "", "this Kerfway reads machine profiles of version 1");
const PLACE: Range = Range::new(-1e6, 1e6, "mm", "no table reaches further than 1 km");
const SPEED: Range = Range::new(
    1e-3,
    1e5,
    "mm/s",
    "no head is faster than 100 m/s, and none cuts a millimetre in over 15 minutes",
);
const ACCEL: Range = Range::new(0.1, 1e7, "mm/s2", "no drive accelerates with more than 1,000 g");
const PASSES: Range = Range::new(1.0, 100.0, "", "a beam that needs more does not cut the material");
const Z_STEP: Range = Range::new(0.0, 50.0, "mm", "a pass cuts no deeper");
const POWER: Range = Range::new(0.0, 1.0, "", "it is a fraction of full power");
const DEVIATION: Range = Range::new(0.0, 10.0, "mm", "a corner rounded by more is not the corner drawn");
const WAIT: Range =
    Range::new(0.0, 600.0, "s", "thick plate is pierced in seconds, so ten minutes are a slip");
const PRE_CUT: Range = Range::new(0.0, 1000.0, "mm", "a pre-cut is a short start of a cut");
const ANGLE: Range = Range::new(0.0, PI, "rad", "corners have at most half a turn");
/// Half of the smallest kerf is the distance within which lines are duplicates. Water jets cut 1 mm wide, plasma up to
/// 10 mm.
const KERF: Range =
    Range::new(0.02, 10.0, "mm", "no beam is thinner, and no jet or plasma cuts wider").or_zero();
const DELAY: Range = Range::new(0.0, 60.0, "s", "a beam settles within a second or so");
const FULL: Range = Range::new(1.0, 1e6, "", "controllers take numbers of a few digits for full power");

const SHAPE: Shape = Shape {
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

impl Profile {
    /// Checks that every value can be used for planning; the error names the first that cannot.
    pub fn validate(&self) -> Result<(), ProfileError> {
        let values = [
            ("version", Some(self.version.into()), VERSIONS),
            ("home[0]", Some(self.home[0]), PLACE),
            ("home[1]", Some(self.home[1]), PLACE),
            ("bed[0]", self.bed.map(|b| b[0]), PLACE),
            ("bed[1]", self.bed.map(|b| b[1]), PLACE),
            ("bed[2]", self.bed.map(|b| b[2]), PLACE),
            ("bed[3]", self.bed.map(|b| b[3]), PLACE),
            ("rapid.speed[0]", Some(self.rapid.speed[0]), SPEED),
            ("rapid.speed[1]", Some(self.rapid.speed[1]), SPEED),
            ("rapid.accel[0]", self.rapid.accel.map(|a| a[0]), ACCEL),
            ("rapid.accel[1]", self.rapid.accel.map(|a| a[1]), ACCEL),
            ("cut.speed", Some(self.cut.speed), SPEED),
            ("cut.accel", self.cut.accel, ACCEL),
            ("cut.power", Some(self.cut.power), POWER),
            ("cut.min_power", self.cut.min_power, POWER),
            ("cut.passes", Some(self.cut.passes.into()), PASSES),
            ("cut.z_step", Some(self.cut.z_step), Z_STEP),
            ("mark.min_power", self.mark.min_power, POWER),
            ("mark.passes", Some(self.mark.passes.into()), PASSES),
            ("mark.z_step", Some(self.mark.z_step), Z_STEP),
            ("z_speed", self.z_speed, SPEED),
            ("mark.speed", Some(self.mark.speed), SPEED),
            ("mark.accel", self.mark.accel, ACCEL),
            ("mark.power", Some(self.mark.power), POWER),
            ("junction_deviation", self.junction_deviation, DEVIATION),
            ("pierce_time", Some(self.pierce_time), WAIT),
            ("pre_cut_time", self.pre_cut_time, WAIT),
            ("pre_cut_length", Some(self.pre_cut_length), PRE_CUT),
            ("sharp_corner.angle", self.sharp_corner.map(|c| c.angle), ANGLE),
            ("sharp_corner.time", self.sharp_corner.map(|c| c.time), WAIT),
            ("kerf_width", Some(self.kerf_width), KERF),
            ("beam_on_delay", Some(self.beam_on_delay), DELAY),
            ("beam_off_delay", Some(self.beam_off_delay), DELAY),
            ("max_s", Some(self.max_s), FULL),
        ];
        let given = values.into_iter().filter_map(|(field, value, range)| Some((field, value?, range)));
        let mut all = given
            .chain(self.leads.iter().flat_map(Leads::numbers))
            .chain(self.levers.numbers())
            .chain(self.joints.iter().flat_map(Joints::numbers))
            .chain(self.skeleton.iter().flat_map(Skeleton::numbers));
        if let Some((field, value, range)) = all.find(|(_, value, range)| !range.holds(*value)) {
            return Err(ProfileError::Value { field, value, range });
        }
        if let Some([x0, y0, x1, y1]) = self.bed.filter(|[x0, y0, x1, y1]| x0 >= x1 || y0 >= y1) {
            return Err(ProfileError::Bed(x0, y0, x1, y1));
        }
        if self.levers.moving_pierce.is_some() && self.pre_cut_time.is_some() {
            return Err(ProfileError::MovingPreCuts);
        }
        if self.levers.fly.is_some() && self.pre_cut_time.is_some() {
            return Err(ProfileError::FlyPreCuts);
        }
        if let Some(other) = self.without_chains() {
            return Err(ProfileError::ChainsWith(other));
        }
        if let Some(other) = self.without_common_cuts() {
            return Err(ProfileError::CommonCutsWith(other));
        }
        if self.levers.lift.is_some() && self.z_speed.is_none() {
            return Err(ProfileError::LiftWithoutZ);
        }
        if self.levers.avoid_tips() && self.levers.lift.is_none() {
            return Err(ProfileError::TipsWithoutLift);
        }
        if self.levers.avoid_tips() && self.pre_cut_time.is_some() {
            return Err(ProfileError::TipsWithPreCuts);
        }
        if self.levers.heat.is_some() && self.levers.fly.is_some() {
            return Err(ProfileError::HeatWithFly);
        }
        if self.levers.heat.is_some() && self.pre_cut_time.is_some() {
            return Err(ProfileError::HeatWithPreCuts);
        }
        self.dialect.document().map_err(ProfileError::Dialect)?;
        self.check_materials()
    }

    /// The field that a machine with chains must not have.
    fn without_chains(&self) -> Option<&'static str> {
        self.levers.chains?;
        let fields =
            [("pre_cut_time", self.pre_cut_time.is_some()), ("sharp_corner", self.sharp_corner.is_some())];
        fields.into_iter().find(|f| f.1).map(|f| f.0)
    }

    /// The field that a machine with common cuts must not have.
    fn without_common_cuts(&self) -> Option<&'static str> {
        self.levers.common_cuts?;
        let fields = [
            ("pre_cut_time", self.pre_cut_time.is_some()),
            ("levers.tips", self.levers.tips.is_some()),
            ("levers.heat", self.levers.heat.is_some()),
        ];
        fields.into_iter().find(|f| f.1).map(|f| f.0)
    }

    /// Every material has a name of its own, and values within their ranges.
    fn check_materials(&self) -> Result<(), ProfileError> {
        for (index, material) in self.materials.iter().enumerate() {
            let name = material.name.trim();
            if name.is_empty() {
                return Err(ProfileError::Materials("one has no name.".to_owned()));
            }
            if self.materials.iter().take(index).any(|m| same_name(&m.name, name)) {
                return Err(ProfileError::Materials(format!("two are named \"{name}\".")));
            }
            if let Ok(with) = self.clone().with_material(name) {
                Self { materials: Vec::new(), ..with }.validate()?;
            }
        }
        Ok(())
    }
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
