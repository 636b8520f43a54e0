//! Validates machine profiles: the range of every number, and fields that do not fit together.

use super::joints::Joints;
use super::leads::Leads;
use super::profile::Profile;
use super::profile_error::ProfileError;
use super::profile_fields::{
    ACCEL, ANGLE, DELAY, DEVIATION, FULL, KERF, PASSES, PLACE, POWER, PRE_CUT, SPEED, VERSIONS, WAIT, Z_STEP,
};
use super::skeleton::Skeleton;
use crate::letters::same_name;

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
        if let Some(contradiction) = self.contradiction() {
            return Err(contradiction);
        }
        self.dialect.document().map_err(ProfileError::Dialect)?;
        self.check_materials()
    }

    /// The first two fields that do not fit together.
    fn contradiction(&self) -> Option<ProfileError> {
        if let Some([x0, y0, x1, y1]) = self.bed.filter(|[x0, y0, x1, y1]| x0 >= x1 || y0 >= y1) {
            return Some(ProfileError::Bed(x0, y0, x1, y1));
        }
        if self.levers.moving_pierce.is_some() && self.pre_cut_time.is_some() {
            return Some(ProfileError::MovingPreCuts);
        }
        if self.levers.fly.is_some() && self.pre_cut_time.is_some() {
            return Some(ProfileError::FlyPreCuts);
        }
        if let Some(other) = self.without_chains() {
            return Some(ProfileError::ChainsWith(other));
        }
        if let Some(other) = self.without_common_cuts() {
            return Some(ProfileError::CommonCutsWith(other));
        }
        if self.levers.lift.is_some() && self.z_speed.is_none() {
            return Some(ProfileError::LiftWithoutZ);
        }
        if self.levers.avoid_tips() && self.levers.lift.is_none() {
            return Some(ProfileError::TipsWithoutLift);
        }
        if self.levers.avoid_tips() && self.pre_cut_time.is_some() {
            return Some(ProfileError::TipsWithPreCuts);
        }
        if self.levers.heat.is_some() && self.levers.fly.is_some() {
            return Some(ProfileError::HeatWithFly);
        }
        if self.levers.heat.is_some() && self.pre_cut_time.is_some() {
            return Some(ProfileError::HeatWithPreCuts);
        }
        None
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
