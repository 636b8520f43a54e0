//! The plan as data: the moves of the head in order, and their sums.

use crate::geometry::{Affine, DVec2, Segment};
use crate::machine::{CornerKind, PLANS_ALL_LEVERS};
use crate::sheet::Strip;
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

/// A corner in which a cut does not stop.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Turn {
    /// What is cut instead.
    pub kind: CornerKind,
    /// The corner, mm.
    pub at: DVec2,
    /// Number of the first element of the cut that is not the contour.
    pub first: usize,
    /// Number of these elements: those of a loop, or the arc that replaces the corner.
    pub count: usize,
}

impl Turn {
    /// The elements of it.
    pub fn of<'p, T>(&self, path: &'p [T]) -> &'p [T] {
        path.get(self.first..self.first.saturating_add(self.count)).unwrap_or_default()
    }

    /// The elements of a cut as if it turned in its corners: without loops, and with the corner drawn in place of every arc.
    pub fn undone(path: &[Segment], turns: &[Self]) -> Vec<Segment> {
        let mut out = Vec::with_capacity(path.len());
        let mut done = 0;
        for turn in turns {
            let Some(before) = path.get(done..turn.first) else { continue };
            let elements = turn.of(path);
            out.extend_from_slice(before);
            if let (CornerKind::Round, Some(a), Some(b)) = (turn.kind, elements.first(), elements.last()) {
                out.extend([Segment::line(a.start(), turn.at), Segment::line(turn.at, b.end())]);
            }
            done = turn.first + elements.len();
        }
        out.extend_from_slice(path.get(done..).unwrap_or_default());
        out
    }
}

/// How many elements of a cut belong to leads and overcut. The lead-in comes first; then the contour, the overcut, and the
/// lead-out. All are cut without switching the beam.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default, Serialize, Deserialize)]
pub struct Leads {
    /// Elements of the lead-in.
    pub lead_in: usize,
    /// Elements of the overcut, which repeat the beginning of the contour.
    pub overcut: usize,
    /// Elements of the lead-out.
    pub lead_out: usize,
}

impl Leads {
    /// Those of a cut and of the stretch that continues it.
    #[must_use]
    pub fn and(self, next: Self) -> Self {
        Self {
            lead_in: self.lead_in + next.lead_in,
            overcut: self.overcut + next.overcut,
            lead_out: self.lead_out + next.lead_out,
        }
    }

    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        *self == Self::default()
    }

    /// Lead-in, contour, overcut and lead-out among the elements of a cut.
    pub fn divide<'p, T>(&self, path: &'p [T]) -> [&'p [T]; 4] {
        let (lead_in, rest) = path.split_at(self.lead_in.min(path.len()));
        let (rest, lead_out) = rest.split_at(rest.len().saturating_sub(self.lead_out));
        let (contour, overcut) = rest.split_at(rest.len().saturating_sub(self.overcut));
        [lead_in, contour, overcut, lead_out]
    }

    /// The leads of a stretch of the elements, from number `first`, of which there are `count`; `all` is their whole number.
    pub(super) fn of_stretch(&self, first: usize, count: usize, all: usize) -> Self {
        let last = first + count;
        let within = |from: usize, to: usize| to.min(last).saturating_sub(from.max(first));
        let out = all.saturating_sub(self.lead_out);
        Self {
            lead_in: within(0, self.lead_in),
            overcut: within(out.saturating_sub(self.overcut), out),
            lead_out: within(out, all),
        }
    }
}

/// The sums of a plan. Lengths are in mm, times in s.
#[derive(Clone, Debug, PartialEq, Default, Serialize, Deserialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct Summary {
    /// Number of contours cut or marked.
    pub contours: u32,
    /// Number of open contours among them.
    pub open_contours: u32,
    /// Number of parts.
    pub parts: u32,
    /// Number of piercings at rest.
    pub pierces: u32,
    /// Number of cuts and marks that begin with the beam on as the head starts to move.
    #[serde(default, skip_serializing_if = "is_none")]
    #[cfg_attr(test, ts(as = "Option<u32>", optional))]
    pub moving_starts: u32,
    /// Number of cuts that begin on the run: the head does not stop before them.
    #[serde(default, skip_serializing_if = "is_none")]
    #[cfg_attr(test, ts(as = "Option<u32>", optional))]
    pub fly_cuts: u32,
    /// Number of cuts through waste that lead to contours.
    #[serde(default, skip_serializing_if = "is_none")]
    #[cfg_attr(test, ts(as = "Option<u32>", optional))]
    pub chains: u32,
    /// Those of them that begin on the kerf of a contour or at the edge of the sheet, after an air move.
    #[serde(default, skip_serializing_if = "is_none")]
    #[cfg_attr(test, ts(as = "Option<u32>", optional))]
    pub edge_starts: u32,
    /// The length of all of them, mm, which is part of the length of cuts.
    #[serde(default, skip_serializing_if = "crate::fields::is_zero")]
    #[cfg_attr(test, ts(as = "Option<f64>", optional))]
    pub chain_length: f64,
    /// Number of bridges between parts.
    #[serde(default, skip_serializing_if = "is_none")]
    #[cfg_attr(test, ts(as = "Option<u32>", optional))]
    pub bridges: u32,
    /// Number of air moves for which the head is lifted.
    #[serde(default, skip_serializing_if = "is_none")]
    #[cfg_attr(test, ts(as = "Option<u32>", optional))]
    pub lifts: u32,
    /// Number of air moves that go around pieces that may have tipped.
    #[serde(default, skip_serializing_if = "is_none")]
    #[cfg_attr(test, ts(as = "Option<u32>", optional))]
    pub detours: u32,
    /// Number of air moves that cross pieces that may have tipped, with the head down.
    #[serde(default, skip_serializing_if = "is_none")]
    #[cfg_attr(test, ts(as = "Option<u32>", optional))]
    pub crossings: u32,
    /// Number of waits until what was cut nearby has cooled.
    #[serde(default, skip_serializing_if = "is_none")]
    #[cfg_attr(test, ts(as = "Option<u32>", optional))]
    pub waits: u32,
    /// Time of these waits. It is part of the time of air moves.
    #[serde(default, skip_serializing_if = "crate::fields::is_zero")]
    #[cfg_attr(test, ts(as = "Option<f64>", optional))]
    pub wait_time: f64,
    /// Number of pairs of cuts nearer to each other than the machine asks for that follow each other sooner than it asks for.
    #[serde(default, skip_serializing_if = "is_none")]
    #[cfg_attr(test, ts(as = "Option<u32>", optional))]
    pub hot_pairs: u32,
    /// Number of pre-cuts.
    pub pre_cuts: u32,
    /// Number of micro-joints.
    #[serde(default, skip_serializing_if = "is_none")]
    #[cfg_attr(test, ts(as = "Option<u32>", optional))]
    pub joints: u32,
    /// Time of stopping at micro-joints: moving over them and piercing after them. It is part of the time of air moves and
    /// of piercing.
    #[serde(default, skip_serializing_if = "crate::fields::is_zero")]
    #[cfg_attr(test, ts(as = "Option<f64>", optional))]
    pub joint_time: f64,
    /// Length of cuts and marks, leads included.
    pub cut_length: f64,
    /// Length of lead-ins, lead-outs and overcuts.
    #[serde(default, skip_serializing_if = "crate::fields::is_zero")]
    #[cfg_attr(test, ts(as = "Option<f64>", optional))]
    pub lead_length: f64,
    /// Number of skeleton cuts, which are not among the contours.
    #[serde(default, skip_serializing_if = "is_none")]
    #[cfg_attr(test, ts(as = "Option<u32>", optional))]
    pub skeleton_cuts: u32,
    /// Length of skeleton cuts. It is part of the length of cuts.
    #[serde(default, skip_serializing_if = "crate::fields::is_zero")]
    #[cfg_attr(test, ts(as = "Option<f64>", optional))]
    pub skeleton_length: f64,
    /// Time from the end of the last other cut to the end of the last skeleton cut: air, piercing and cutting.
    #[serde(default, skip_serializing_if = "crate::fields::is_zero")]
    #[cfg_attr(test, ts(as = "Option<f64>", optional))]
    pub skeleton_time: f64,
    /// Number of corners that are cut in a loop through waste.
    #[serde(default, skip_serializing_if = "is_none")]
    #[cfg_attr(test, ts(as = "Option<u32>", optional))]
    pub loops: u32,
    /// The length of all loops, which is part of the length of cuts.
    #[serde(default, skip_serializing_if = "crate::fields::is_zero")]
    #[cfg_attr(test, ts(as = "Option<f64>", optional))]
    pub loop_length: f64,
    /// Number of corners that are rounded.
    #[serde(default, skip_serializing_if = "is_none")]
    #[cfg_attr(test, ts(as = "Option<u32>", optional))]
    pub rounded_corners: u32,
    /// The greatest distance of a rounded corner from the corner drawn, mm.
    #[serde(default, skip_serializing_if = "crate::fields::is_zero")]
    #[cfg_attr(test, ts(as = "Option<f64>", optional))]
    pub corner_deviation: f64,
    /// Length of air moves.
    pub air_length: f64,
    /// Time along contours, by look-ahead over corners and acceleration. It includes the ways between cuts on the run, and chains.
    pub cut_time: f64,
    /// Time of air moves, of lowering and raising the head, and of waits.
    pub air_time: f64,
    /// Time of piercing, including beam delays.
    pub pierce_time: f64,
    /// Time of pre-cuts.
    pub pre_cut_time: f64,
    /// Time of pauses in sharp corners.
    pub macro_time: f64,
    /// Total time.
    pub total_time: f64,
    /// Lower bound of the total time of every plan; 0 if not computed.
    pub lower_bound: f64,
    /// (total - bound) / bound; `None` when there is no bound.
    pub gap: Option<f64>,
    /// Bounding box of everything cut or marked: xmin, ymin, xmax, ymax.
    pub bounds: [f64; 4],
}

#[allow(clippy::trivially_copy_pass_by_ref, reason = "what serde asks for")]
fn is_none(count: &u32) -> bool {
    *count == 0
}

impl Summary {
    /// The times of everything that the head does, s.
    pub(super) fn seconds(&self) -> f64 {
        self.air_time + self.cut_time + self.pierce_time + self.pre_cut_time + self.macro_time
    }

    /// Sets the lower bound of the total time in seconds; 0 means none. A bound above the total is due to rounding, so the
    /// plan is optimal.
    pub fn set_bound(&mut self, bound: f64) {
        if bound > 0.0 {
            self.lower_bound = bound.min(self.total_time);
            self.gap = Some((self.total_time - self.lower_bound) / self.lower_bound);
        }
    }
}

/// Moves and their sums. As data it keeps every bit, unlike the plan document, whose arcs have no sweep.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Plan {
    /// The moves in order.
    pub moves: Vec<Move>,
    /// Their sums.
    pub summary: Summary,
    /// The strips of material that connect parts.
    #[serde(default, skip_serializing_if = "no_bridges")]
    pub bridges: Vec<Strip>,
}

/// Whether there are none to write. Builds that plan none are smaller without writing them.
pub(super) fn no_bridges(bridges: &[Strip]) -> bool {
    !PLANS_ALL_LEVERS || bridges.is_empty()
}

impl Plan {
    /// The same plan at another place, moved by `shift` mm. Lengths and times stay as they are.
    pub fn moved(mut self, shift: DVec2) -> Self {
        if shift == DVec2::ZERO {
            return self;
        }
        let by = Affine::translation(shift);
        let run = |path: &mut [Segment]| {
            path.iter_mut().for_each(|s| *s = by.segment(s).unwrap_or(*s));
        };
        for step in &mut self.moves {
            match step {
                Move::Air { to, .. } => *to += shift,
                Move::Pierce | Move::MovingStart | Move::Height { .. } | Move::Wait { .. } => {}
                Move::PreCut { to, ahead, .. } => {
                    *to += shift;
                    run(ahead);
                }
                Move::Macro { at, .. } => *at += shift,
                Move::Cut { path, turns, .. } => {
                    run(path);
                    turns.iter_mut().for_each(|turn| turn.at += shift);
                }
                Move::Joint { path, .. } | Move::Fly { path } | Move::Chain { path } => run(path),
            }
        }
        if PLANS_ALL_LEVERS {
            self.bridges.iter_mut().flat_map(|b| b.sides.as_flattened_mut()).for_each(|p| *p += shift);
        }
        let [x0, y0, x1, y1] = self.summary.bounds;
        self.summary.bounds = [x0 + shift.x, y0 + shift.y, x1 + shift.x, y1 + shift.y];
        self
    }
}
