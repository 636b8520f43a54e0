//! Why a machine profile is refused.

use super::profile_fields::SHAPE;
use crate::fields::{Fault, FieldError, Range, out_of_range};

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

impl ProfileError {
    /// The field that it is about.
    fn field(&self) -> &'static str {
        match self {
            Self::Value { field, .. } => field,
            Self::Materials(_) => "materials",
            Self::Bed(..) => "bed",
            Self::LiftWithoutZ => "levers.lift",
            Self::TipsWithoutLift | Self::TipsWithPreCuts => "levers.tips",
            Self::HeatWithFly | Self::HeatWithPreCuts => "levers.heat",
            Self::MovingPreCuts => "levers.moving_pierce",
            Self::ChainsWith(_) => "levers.chains",
            Self::CommonCutsWith(_) => "levers.common_cuts",
            Self::FlyPreCuts => "levers.fly",
            Self::Dialect(_) => "dialect",
        }
    }
}

impl From<ProfileError> for FieldError {
    fn from(error: ProfileError) -> Self {
        match error {
            ProfileError::Value { field, value, range } => {
                Self::out_of_range(SHAPE.value, field, value, &range)
            }
            error => Self::new(Fault::Contradiction, error.field(), error.to_string()),
        }
    }
}
