//! The machine: its data ([`Profile`]), and the times that follow from it.
//!
//! A profile says how fast the head moves and cuts, what piercing takes, which leads, joints and skeleton cuts there are, and
//! which [`Levers`] save time. [`presets`] has typical machines. A profile from outside is read by the table of its fields
//! (`profile_fields.rs`) and checked by [`Profile::validate`].
//!
//! [`air_time`] is the time of a move with the beam off (`motion.rs`), and [`cut_time`] that of a cut, which slows down in
//! corners (`lookahead.rs`). [`ClosedRun`] says what a closed cut takes from each place of entry.

mod arc;
mod bed;
mod bridges;
mod closed_run;
mod corner;
mod corners;
pub mod dialect;
mod float32;
mod heat;
mod joints;
mod leads;
mod levers;
mod lookahead;
mod materials;
mod motion;
mod presets;
mod process;
mod profile;
mod profile_error;
mod profile_fields;
mod ramp;
mod settings;
mod sharp_corner;
mod skeleton;
mod tips;
mod valid;

pub use bed::{Anchor, Start};
pub use bridges::Bridges;
pub use closed_run::ClosedRun;
pub(crate) use corner::MARGIN;
pub(crate) use corners::CORNER_KINDS;
pub use corners::{CornerKind, Corners};
pub(crate) use float32::{FarOut, far_out, spacing_at};
pub(crate) use heat::SAME_HEAT;
pub use heat::{Heat, SmallHoles};
pub(crate) use joints::JOINT_COUNT;
pub use joints::{JointKind, JointRule, Joints, SizeTest};
pub(crate) use leads::LEAD_KINDS;
pub use leads::{LeadKind, LeadPosition, LeadRule, LeadShape, LeadSide, Leads};
pub use levers::{Chains, Fly, Levers, Lift, MovingPierce, PLANS_ALL_LEVERS, SharedCuts};
pub use lookahead::{cut_time, process_time};
pub use motion::{AirTime, air_time};
pub use presets::{preset, presets};
pub use process::Process;
pub use profile::{Axes, Profile, Takes, Travel};
pub use profile_error::ProfileError;
pub use profile_fields::{LAYER_SETTINGS, check_settings};
pub use settings::{MaterialSetting, Settings};
pub use sharp_corner::SharpCorner;
pub use skeleton::Skeleton;
pub(crate) use tips::SAME_SIZE;
pub use tips::{Falls, RiskyMoves, Slats, Tips};
