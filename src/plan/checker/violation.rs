//! The faults that a plan may have.

use crate::geometry::DVec2;

/// A fault of a plan. `step` is the index of the move, `contour` the id of the contour.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum Violation {
    /// A number that is not finite.
    #[error("move {step} holds a number that is not finite")]
    NotFinite {
        /// Which move.
        step: usize,
    },
    /// A move does not start where the head is.
    #[error("move {step} starts {gap} mm away from where the head is")]
    NotJoined {
        /// Which move.
        step: usize,
        /// How far, mm.
        gap: f64,
    },
    /// A sharp corner is cut without a pause.
    #[error("move {step} cuts contour {contour} through the sharp corner at {at} without a pause")]
    NoMacro {
        /// Which move.
        step: usize,
        /// Which contour.
        contour: u32,
        /// The corner, mm.
        at: DVec2,
    },
    /// Piercing and cutting do not fit together.
    #[error("move {step}: the head {what}")]
    Beam {
        /// Which move.
        step: usize,
        /// What the head does wrong.
        what: &'static str,
    },
    /// A contour is marked instead of cut, or cut instead of marked.
    #[error(
        "move {step}: contour {contour} is marked where it should be cut, or cut where it should be marked"
    )]
    Operation {
        /// Which move.
        step: usize,
        /// Which contour.
        contour: u32,
    },
    /// The sheet has no such contour.
    #[error("move {step} cuts contour {contour}, which the sheet does not have")]
    Unknown {
        /// Which move.
        step: usize,
        /// Which contour.
        contour: u32,
    },
    /// A contour is cut more than once.
    #[error("move {step} cuts contour {contour} a second time")]
    Again {
        /// Which move.
        step: usize,
        /// Which contour.
        contour: u32,
    },
    /// A contour is left unfinished and resumed where that is not allowed.
    #[error("move {step} continues contour {contour}, which must be cut in one go")]
    Left {
        /// Which move.
        step: usize,
        /// Which contour.
        contour: u32,
    },
    /// A contour is resumed while one that was begun after it is unfinished.
    #[error(
        "move {step} continues contour {contour} before contour {inner}, which was begun after it, is finished"
    )]
    Crossed {
        /// Which move.
        step: usize,
        /// Which contour.
        contour: u32,
        /// The unfinished contour.
        inner: u32,
    },
    /// A contour is never cut.
    #[error("contour {contour} is not cut")]
    Missing {
        /// Which contour.
        contour: u32,
    },
    /// A cut leaves its contour.
    #[error("move {step} leaves contour {contour} near {at}")]
    Strays {
        /// Which move.
        step: usize,
        /// Which contour.
        contour: u32,
        /// Approximate position, mm.
        at: DVec2,
    },
    /// The beam removes something of a part, leaves material on it, or runs on the wrong side of its outline.
    #[error("move {step} does not keep half a kerf from the drawn outline of contour {contour} at {at}")]
    Kerf {
        /// Which move.
        step: usize,
        /// Which contour.
        contour: u32,
        /// Position, mm.
        at: DVec2,
    },
    /// A lead or an overcut is not as the machine's rules say, or does not lie in scrap.
    #[error("move {step}: the lead or overcut of contour {contour} {what} at {at}")]
    Lead {
        /// Which move.
        step: usize,
        /// Which contour.
        contour: u32,
        /// What is wrong.
        what: &'static str,
        /// Position, mm.
        at: DVec2,
    },
    /// A corner in which a cut does not stop is not cut as the machine or a person asks for.
    #[error("move {step}: a corner of contour {contour} {what} at {at}")]
    Corner {
        /// Which move.
        step: usize,
        /// Which contour.
        contour: u32,
        /// What is wrong.
        what: &'static str,
        /// Position, mm.
        at: DVec2,
    },
    /// A cut through waste that joins two contours is not as the machine has it, or does not lie in waste.
    #[error("move {step}: the cut through waste {what} at {at}")]
    Chain {
        /// Which move.
        step: usize,
        /// What is wrong.
        what: &'static str,
        /// Position, mm.
        at: DVec2,
    },
    /// Parts are not connected by bridges as the machine has it, or a bridge does not lie in waste.
    #[error("contour {contour} {what} at {at}")]
    Bridge {
        /// Which contour.
        contour: u32,
        /// What is wrong.
        what: &'static str,
        /// Position, mm.
        at: DVec2,
    },
    /// A micro-joint is not as the machine's rules or a person ask for.
    #[error("move {step}: a micro-joint of contour {contour} {what} at {at}")]
    Joint {
        /// Which move.
        step: usize,
        /// Which contour.
        contour: u32,
        /// What is wrong.
        what: &'static str,
        /// Position, mm.
        at: DVec2,
    },
    /// A skeleton cut is nearer to a part than its clearance.
    #[error("move {step}: a skeleton cut is too near to a part at {at}")]
    Skeleton {
        /// Which move.
        step: usize,
        /// Position, mm.
        at: DVec2,
    },
    /// An air move does not do what it should about pieces that may have tipped.
    #[error("move {step}: the head {what}, contour {contour} at {at}")]
    Tipped {
        /// Which move.
        step: usize,
        /// The contour that bounds the piece.
        contour: u32,
        /// What is wrong.
        what: &'static str,
        /// Position on the move, mm.
        at: DVec2,
    },
    /// A way around tipped pieces leaves the bed.
    #[error("move {step}: the head goes around a tipped piece beyond the bed, at {at}")]
    OffBed {
        /// Which move.
        step: usize,
        /// Where it goes, mm.
        at: DVec2,
    },
    /// An air move is lifted or goes around where the machine does not ask for it.
    #[error(
        "move {step}: the head goes around tipped pieces or over them, which the machine does not ask for"
    )]
    Unasked {
        /// Which move.
        step: usize,
    },
    /// A cut begins while one near it is still hot, on a machine that waits.
    #[error("move {step} begins contour {contour} {seconds} s after contour {hot} near it")]
    Hot {
        /// Which move.
        step: usize,
        /// Which contour.
        contour: u32,
        /// The contour that is still hot.
        hot: u32,
        /// Seconds between the end of that and the beginning of this.
        seconds: f64,
    },
    /// The head waits where the machine does not ask for it.
    #[error("move {step} waits, which the machine does not ask for")]
    NeedlessWait {
        /// Which move.
        step: usize,
    },
    /// Less or more than the whole contour is cut.
    #[error("move {step} cuts {worked} mm of contour {contour}, which is {length} mm long")]
    Partly {
        /// Which move.
        step: usize,
        /// Which contour.
        contour: u32,
        /// Length cut, mm.
        worked: f64,
        /// Length of the contour, mm.
        length: f64,
    },
    /// An outer contour is finished before a contour inside it.
    #[error("contour {outer} is finished before contour {inner} inside it")]
    CutFree {
        /// The outer contour.
        outer: u32,
        /// The contour inside it.
        inner: u32,
    },
    /// A contour is cut after the area that contains it has fallen out.
    #[error("move {step} cuts contour {contour} after everything around it was cut free")]
    Fallen {
        /// Which move.
        step: usize,
        /// Which contour.
        contour: u32,
    },
    /// A contour is resumed, or cut up to an area that is free, without a pre-cut there.
    #[error("move {step} cuts contour {contour} from or to a place that needs a pre-cut")]
    NoPreCut {
        /// Which move.
        step: usize,
        /// Which contour.
        contour: u32,
    },
    /// The order by layer, of marks before cuts, or of a sequence is not kept.
    #[error("contour {later} should have been cut before contour {earlier}")]
    Rank {
        /// The contour that was cut first.
        earlier: u32,
        /// The contour that should have been cut before it.
        later: u32,
    },
    /// The passes over a contour are not as asked for.
    #[error("contour {contour} {what}")]
    Passes {
        /// Which contour.
        contour: u32,
        /// What is wrong with its passes.
        what: &'static str,
    },
    /// The head has the wrong height.
    #[error("at move {step} the head is at the height {z} mm instead of {asked} mm")]
    Height {
        /// Which move.
        step: usize,
        /// Its height, mm.
        z: f64,
        /// The height of this pass, mm.
        asked: f64,
    },
    /// With parts cut one by one, a part was left and continued later.
    #[error("contour {contour} of part {part} is not cut together with the rest of the part")]
    Torn {
        /// Which part.
        part: u32,
        /// The contour at which it is continued.
        contour: u32,
    },
    /// A group that is kept together was left and continued later.
    #[error("contour {contour} is not cut together with the rest of its group")]
    Apart {
        /// The contour at which it is continued.
        contour: u32,
    },
    /// The path does not end at home.
    #[error("the head ends {left} mm away from home")]
    NotHome {
        /// Distance from home, mm.
        left: f64,
    },
    /// A sum is wrong.
    #[error("the plan states {what} as {says}, but its moves add up to {found}")]
    Sum {
        /// Which sum.
        what: &'static str,
        /// Value in the plan.
        says: f64,
        /// Value added up again.
        found: f64,
    },
}
