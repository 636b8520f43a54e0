//! The lines that divide the sheet, and the stretches of them that are cut.

use super::super::model::Sheet;
use super::blocked::{Across, Interval, merge, worked};
use super::fault::{MOST, SkeletonFault};
use crate::geometry::{Aabb, DVec2, Path};
use crate::machine::Skeleton;

/// Shorter stretches are not cut, mm: they are hardly longer than the hole that piercing makes.
const SHORTEST: f64 = 2.0;
/// A line that runs along an edge at the clearance is not interrupted by rounding, mm.
const GRAZE: f64 = 1e-6;
/// How many more joints than needed are tried so that none lies on a crossing.
const TRIES: u32 = 4;
/// Rounding of a quotient that is a whole number of pieces.
const ROUNDING: f64 = 1e-9;

/// What the lines run through.
pub(super) struct Grid<'s> {
    outline: &'s Path,
    skeleton: &'s Skeleton,
    /// Length that a joint leaves uncut along the line of the beam, mm.
    joint: f64,
    obstacles: Vec<&'s Path>,
}

impl<'s> Grid<'s> {
    pub(super) fn new(sheet: &'s Sheet, outline: &'s Path, skeleton: &'s Skeleton, kerf: f64) -> Self {
        Self { outline, skeleton, joint: skeleton.joint_width + kerf, obstacles: worked(sheet).collect() }
    }

    /// The lines that divide a box evenly into pieces no larger than asked for.
    pub(super) fn lines(&self, room: Aabb) -> Result<Vec<Across>, SkeletonFault> {
        let mut lines = Vec::new();
        let Skeleton { spacing_x, spacing_y, .. } = *self.skeleton;
        for (upright, spacing) in [(true, spacing_x), (false, spacing_y)] {
            let Some(spacing) = spacing else { continue };
            let pick = |p: DVec2| if upright { p.x } else { p.y };
            let (from, size) = (pick(room.min), pick(room.size()));
            let pieces = (size / spacing - ROUNDING).ceil().max(1.0);
            if pieces > f64::from(MOST) {
                return Err(SkeletonFault::TooMany);
            }
            let mut k = 1.0;
            while k < pieces {
                lines.push(Across { upright, at: from + size * k / pieces });
                k += 1.0;
            }
        }
        Ok(lines)
    }

    /// The stretches of a line that are cut, within a box, from end to end. `lines`: those that may cross it.
    pub(super) fn stretches(&self, line: Across, room: Aabb, lines: &[Across]) -> Vec<(DVec2, DVec2)> {
        let (first, last) = line.within(&room);
        let mut blocked = vec![(f64::NEG_INFINITY, first), (last, f64::INFINITY)];
        for path in &self.obstacles {
            line.block(path, self.skeleton.clearance - GRAZE, &mut blocked);
        }
        merge(&mut blocked);
        let mut out = Vec::new();
        for (from, to) in line.inside(self.outline) {
            let mut at = from;
            for &(begin, end) in &blocked {
                self.with_joints(line, (at, begin.min(to)), lines, &mut out);
                at = at.max(end);
            }
            self.with_joints(line, (at, to), lines, &mut out);
        }
        out
    }

    /// Adds a stretch in pieces no longer than the distance between joints.
    fn with_joints(
        &self,
        line: Across,
        (from, to): Interval,
        lines: &[Across],
        out: &mut Vec<(DVec2, DVec2)>,
    ) {
        let length = to - from;
        let long_enough = length >= SHORTEST;
        if !long_enough {
            return;
        }
        let pitch = |pieces: f64| (length + self.joint) / pieces;
        let least = self.skeleton.joint_spacing.map_or(1.0, |spacing| {
            ((length + self.joint) / (spacing + self.joint) - ROUNDING).ceil().max(1.0)
        });
        let crosses =
            |at: f64| lines.iter().any(|l| l.upright != line.upright && (l.at - at).abs() < self.joint);
        let joint = |pieces: f64, k: f64| from + k * pitch(pieces) - 0.5 * self.joint;
        let clear = |pieces: f64| count_to(pieces).all(|k| !crosses(joint(pieces, k)));
        let mut tries = (0..TRIES).map(|more| least + f64::from(more));
        let pieces = if least > 1.0 { tries.find(|&n| clear(n)).unwrap_or(least) } else { least };
        let ends = count_to(pieces).map(|k| joint(pieces, k)).chain([to + 0.5 * self.joint]);
        let mut at = from;
        for joint in ends {
            let end = (joint - 0.5 * self.joint).min(to);
            if end - at >= SHORTEST {
                out.push((line.point(at), line.point(end)));
            }
            at = joint + 0.5 * self.joint;
        }
    }
}

/// The whole numbers from 1 to below `n`.
fn count_to(n: f64) -> impl Iterator<Item = f64> {
    std::iter::successors(Some(1.0), |k| Some(k + 1.0)).take_while(move |&k| k < n)
}
