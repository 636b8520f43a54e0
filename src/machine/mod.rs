//! The machine: its data ([`Profile`]), and the times that follow from it ([`air_time`], [`cut_time`]).

mod arc;
mod bed;
mod closed_run;
mod corner;
pub mod dialect;
mod float32;
mod joints;
mod leads;
mod levers;
mod lookahead;
mod materials;
mod motion;
mod presets;
mod process;
mod profile;
mod ramp;
mod settings;
mod sharp_corner;
mod valid;

pub use bed::{Anchor, Start};
pub use closed_run::ClosedRun;
pub(crate) use corner::MARGIN;
pub(crate) use float32::{FarOut, far_out, spacing_at};
pub(crate) use joints::JOINT_COUNT;
pub use joints::{JointKind, JointRule, Joints, SizeTest};
pub(crate) use leads::LEAD_KINDS;
pub use leads::{LeadKind, LeadPosition, LeadRule, LeadShape, LeadSide, Leads};
pub use levers::{Fly, Levers, Lift, MovingPierce};
pub use lookahead::{cut_time, process_time};
pub use motion::{AirTime, air_time};
pub use presets::{preset, presets};
pub use process::Process;
pub use profile::{Axes, Profile, Takes, Travel};
pub use settings::{MaterialSetting, Settings};
pub use sharp_corner::SharpCorner;
pub use valid::{LAYER_SETTINGS, ProfileError, check_settings};
