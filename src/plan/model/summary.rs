//! The sums of a plan.

use serde::{Deserialize, Serialize};

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
    pub(in crate::plan) fn seconds(&self) -> f64 {
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
