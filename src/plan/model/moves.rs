//! The moves of the head.

use super::leads::Leads;
use super::turn::Turn;
use crate::geometry::{DVec2, Segment};
use serde::{Deserialize, Serialize};

/// One move of the head. It starts where the previous one ended; the first starts at home.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub enum Move {
    /// Moves with the beam off, straight or per axis as the machine does.
    Air {
        /// End point, mm.
        to: DVec2,
        /// What it does about pieces that may have tipped, on a machine with `levers.tips`.
        #[serde(default, skip_serializing_if = "Way::is_plain")]
        way: Way,
    },
    /// Pierces at the current point.
    Pierce,
    /// The beam goes on as the next cut or mark begins to move, so that there is no wait before it.
    MovingStart,
    /// Leaves a contour unfinished. The beam cuts a short stretch ahead, so that the contour can be resumed from within it
    /// without piercing.
    PreCut {
        /// The contour's id.
        contour: u32,
        /// Point where the contour is left, mm.
        to: DVec2,
        /// The stretch cut ahead from there, after which the head returns with the beam off; empty if pre-cuts have no
        /// length.
        ahead: Vec<Segment>,
    },
    /// Pauses in a sharp corner with the beam off; the next move continues the cut.
    Macro {
        /// The contour's id.
        contour: u32,
        /// Position of the corner, mm.
        at: DVec2,
    },
    /// Leaves a micro-joint uncut: with the beam off, the head goes to its end, where the contour is cut on.
    Joint {
        /// The contour's id.
        contour: u32,
        /// The elements of the contour that stay uncut.
        path: Vec<Segment>,
        /// Whether the head runs along them without stopping, as if it cut. If not, it stops, moves straight to the end of
        /// the joint, and pierces there.
        flying: bool,
    },
    /// Runs on from one cut to the next with the beam off, without stopping, as if it cut: both cuts are one motion.
    Fly {
        /// The elements of the way.
        path: Vec<Segment>,
    },
    /// Cuts through waste to the beginning of the next cut, which is not pierced, and stops at both ends. It begins at the end of the cut
    /// before it, with the beam still on; or, after an air move, on the kerf of that cut, where the beam goes on without piercing.
    Chain {
        /// The elements of the cut through waste.
        path: Vec<Segment>,
    },
    /// Lowers or raises the head with the beam off, for the passes of a deep cut.
    Height {
        /// Height, mm: 0 as focused, negative when lowered.
        z: f64,
    },
    /// Waits where the head is, with the beam off, until what was cut nearby has cooled.
    Wait {
        /// How long, s.
        seconds: f64,
    },
    /// Cuts along a contour, or a stretch of it. A contour that is left unfinished continues in a later cut where this one
    /// ended.
    Cut {
        /// The contour's id; in a pierce group, the contour on which the cut begins.
        contour: u32,
        /// Other contours of a pierce group that the cut runs along, in order; or those of the other parts that bridges connect.
        with: Vec<u32>,
        /// Its elements from the place where it is entered or resumed, in the direction of travel.
        path: Vec<Segment>,
        /// Whether the contour is marked instead of cut through.
        mark: bool,
        /// Which of the elements are not the contour, but its leads and its overcut.
        leads: Leads,
        /// The corners that are cut in a loop or rounded, in order.
        #[serde(default, skip_serializing_if = "Vec::is_empty")]
        turns: Vec<Turn>,
    },
}

/// What an air move does about pieces that may have tipped.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Way {
    /// It is straight, and meets none of them. Where they are avoided, the head is down; otherwise the length of the move
    /// decides whether it is lifted.
    #[default]
    Plain,
    /// It ends at a place on the way around them, with the head down; the next move goes on from there.
    Around,
    /// It is straight, with the head lifted over them.
    Lifted,
    /// It crosses one of them with the head down.
    Crosses,
}

impl Way {
    /// Whether there is nothing to say of it.
    #[allow(clippy::trivially_copy_pass_by_ref, reason = "the signature that serde asks for")]
    pub fn is_plain(&self) -> bool {
        *self == Self::Plain
    }
}

impl Move {
    /// An air move that meets no piece that may have tipped.
    pub fn air(to: DVec2) -> Self {
        Self::Air { to, way: Way::Plain }
    }

    /// Whether the head runs on over this with the beam off, so that the cuts before and after it are one motion: a flying
    /// joint, or the way between two cuts on the run.
    pub fn runs_on(&self) -> bool {
        matches!(self, Self::Joint { flying: true, .. } | Self::Fly { .. })
    }

    /// Whether it is a pre-cut that has a length.
    pub fn cuts_ahead(&self) -> bool {
        matches!(self, Self::PreCut { ahead, .. } if !ahead.is_empty())
    }

    /// Where the head is afterwards; `None` if it has not moved.
    pub fn end(&self) -> Option<DVec2> {
        match self {
            Self::Air { to, .. } | Self::PreCut { to, .. } => Some(*to),
            Self::Cut { path, .. } | Self::Joint { path, .. } | Self::Fly { path } | Self::Chain { path } => {
                path.last().map(Segment::end)
            }
            Self::Pierce
            | Self::MovingStart
            | Self::Macro { .. }
            | Self::Height { .. }
            | Self::Wait { .. } => None,
        }
    }
}
