//! What can be wrong with a plan.

use crate::geometry::DVec2;

/// One thing that is wrong with a plan. `step` is the index of the move, `contour` the contour's id.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum Violation {
    /// A number that is not finite.
    #[error("move {step} holds a number that is not finite")]
    NotFinite {
        /// Which move.
        step: usize,
    },
    /// The beam jumps: a cut does not start where the head is.
    #[error("move {step} starts {gap} mm away from where the head is")]
    NotJoined {
        /// Which move.
        step: usize,
        /// How far, mm.
        gap: f64,
    },
    /// A sharp corner is cut through without a pause.
    #[error("move {step} cuts contour {contour} through the sharp corner at {at} without a pause")]
    NoMacro {
        /// Which move.
        step: usize,
        /// Which contour.
        contour: u32,
        /// The corner, mm.
        at: DVec2,
    },
    /// Piercing and cutting do not go together.
    #[error("move {step}: the head {what}")]
    Beam {
        /// Which move.
        step: usize,
        /// What it does.
        what: &'static str,
    },
    /// Marked though to be cut, or the other way round.
    #[error(
        "move {step}: contour {contour} is marked where it should be cut, or cut where it should be marked"
    )]
    Operation {
        /// Which move.
        step: usize,
        /// Which contour.
        contour: u32,
    },
    /// A contour the sheet does not hold.
    #[error("move {step} works contour {contour}, which the sheet does not hold")]
    Unknown {
        /// Which move.
        step: usize,
        /// Which contour.
        contour: u32,
    },
    /// Worked more than once.
    #[error("move {step} works contour {contour} again")]
    Again {
        /// Which move.
        step: usize,
        /// Which contour.
        contour: u32,
    },
    /// Left unfinished and resumed where that is not allowed.
    #[error("move {step} goes on with contour {contour}, which is to be worked in one go")]
    Left {
        /// Which move.
        step: usize,
        /// Which contour.
        contour: u32,
    },
    /// Resumed while what was begun after it is unfinished.
    #[error("move {step} goes on with contour {contour} before contour {inner}, begun after it, is finished")]
    Crossed {
        /// Which move.
        step: usize,
        /// Which contour.
        contour: u32,
        /// The one that is unfinished.
        inner: u32,
    },
    /// Never worked.
    #[error("contour {contour} is not worked")]
    Missing {
        /// Which contour.
        contour: u32,
    },
    /// The cut leaves its contour.
    #[error("move {step} leaves contour {contour} near {at}")]
    Strays {
        /// Which move.
        step: usize,
        /// Which contour.
        contour: u32,
        /// About where, mm.
        at: DVec2,
    },
    /// The beam takes something of a part, leaves something on it, or runs on the wrong side of its outline.
    #[error("move {step} does not keep half a kerf from the drawn outline of contour {contour} at {at}")]
    Kerf {
        /// Which move.
        step: usize,
        /// Which contour.
        contour: u32,
        /// The place, mm.
        at: DVec2,
    },
    /// Less or more of the contour is worked than there is.
    #[error("move {step} works {worked} mm of contour {contour}, which is {length} mm long")]
    Partly {
        /// Which move.
        step: usize,
        /// Which contour.
        contour: u32,
        /// Length worked, mm.
        worked: f64,
        /// Length there is, mm.
        length: f64,
    },
    /// An outer contour is finished before something inside it.
    #[error("contour {outer} is finished before contour {inner} inside it")]
    CutFree {
        /// The outer contour.
        outer: u32,
        /// What lies inside it.
        inner: u32,
    },
    /// Cut after the area it lies in has fallen out.
    #[error("move {step} cuts contour {contour} where everything around it is cut free already")]
    Fallen {
        /// Which move.
        step: usize,
        /// Which contour.
        contour: u32,
    },
    /// Resumed, or cut up to what is cut free, without a pre-cut there.
    #[error("move {step} cuts contour {contour} from or to a place where it needed a pre-cut")]
    NoPreCut {
        /// Which move.
        step: usize,
        /// Which contour.
        contour: u32,
    },
    /// The order by layer, or marks before cuts, is not kept.
    #[error("contour {later} should have been worked before contour {earlier}")]
    Rank {
        /// Worked first.
        earlier: u32,
        /// Worked after it, against its rank.
        later: u32,
    },
    /// Part by part, a part was left and taken up again.
    #[error("contour {contour} of part {part} is not worked together with the rest of the part")]
    Torn {
        /// Which part.
        part: u32,
        /// The contour at which it is taken up again.
        contour: u32,
    },
    /// Ends elsewhere than at home.
    #[error("the head ends {left} mm away from home")]
    NotHome {
        /// How far, mm.
        left: f64,
    },
    /// A sum that does not add up.
    #[error("the plan says {what} is {says}, its moves add up to {found}")]
    Sum {
        /// Which sum.
        what: &'static str,
        /// By the plan.
        says: f64,
        /// Added up again.
        found: f64,
    },
}
