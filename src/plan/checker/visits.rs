//! Checks when each contour is cut: in one go or, where the machine allows it, left unfinished and resumed.
//!
//! The cuts of a contour are followed in order as one. Each must continue where the previous one ended, and together they
//! must be the contour, once. What is begun between two cuts of a contour is also finished between them.

use super::coverage::{Fault, follows, leads};
use super::joints;
use super::leads::overcut;
use super::tolerance::{SAME, rounding, stretch};
use super::violation::Violation;
use crate::geometry::{Path, Segment};
use crate::machine::Profile;
use crate::sheet::{Operation, Sheet};

/// The state of one contour.
#[derive(Clone, Default)]
struct Work {
    /// Indices of its first and last move.
    steps: Option<(usize, usize)>,
    /// What was cut of it in each pass that is finished.
    done: Vec<Vec<Segment>>,
    /// Everything cut of it so far in this pass, and its length in mm.
    path: Vec<Segment>,
    length: f64,
    /// Whether it may be resumed without piercing.
    ready: bool,
    /// The stretch of the remaining contour that was cut ahead.
    ahead: Vec<Segment>,
    /// Whether the last thing on it was a joint.
    at_joint: bool,
}

/// The contours of a sheet and their states.
pub(super) struct Visits<'s> {
    sheet: &'s Sheet,
    /// Cost of a pre-cut; `None` if nothing may be left unfinished.
    pre_cut: Option<f64>,
    work: Vec<Work>,
    /// Number of passes over each contour before the head goes on.
    passes: Vec<u32>,
    /// By contour: lengths that the machine's rules leave uncut at its end, mm: a gap, or a joint at which it begins.
    gap: Vec<[f64; 2]>,
    /// Contours that are begun and not finished, the outermost first.
    open: Vec<u32>,
    /// The contours of all cuts in order.
    pub(super) order: Vec<u32>,
}

impl<'s> Visits<'s> {
    pub(super) fn new(sheet: &'s Sheet, machine: &Profile) -> Self {
        let work = vec![Work::default(); sheet.contours.len()];
        let passes = sheet.contours.iter().map(|c| sheet.passes_at_once(c, machine)).collect();
        let gap = |(id, c)| [(-overcut(sheet, machine, id, c)).max(0.0), joints::length(sheet, machine, id)];
        let gap = (0..).zip(&sheet.contours).map(gap).collect();
        Self { sheet, pre_cut: machine.pre_cut_time, work, passes, gap, open: Vec::new(), order: Vec::new() }
    }

    /// Whether a contour was begun and is not finished.
    pub(super) fn is_unfinished(&self, contour: u32) -> bool {
        self.open.contains(&contour)
    }

    /// Whether a contour may continue without piercing.
    pub(super) fn is_ready(&self, contour: u32) -> bool {
        self.pre_cut == Some(0.0) || self.work.get(contour as usize).is_some_and(|w| w.ready)
    }

    /// Follows a pre-cut after the cut of a contour. Returns whether some of the contour remains.
    pub(super) fn pre_cut(&mut self, contour: u32, ahead: &[Segment]) -> bool {
        let fits = self.is_unfinished(contour) && self.pre_cut.is_some_and(|seconds| seconds > 0.0);
        if let Some(work) = self.work.get_mut(contour as usize) {
            work.ready = fits;
            work.ahead = ahead.to_vec();
        }
        fits
    }

    /// Follows the next cut.
    pub(super) fn cut(&mut self, step: usize, contour: u32, path: &[Segment], found: &mut Vec<Violation>) {
        let (Some(known), Some(work)) =
            (self.sheet.contours.get(contour as usize), self.work.get_mut(contour as usize))
        else {
            found.push(Violation::Unknown { step, contour });
            return;
        };
        let gap = self.gap.get(contour as usize).copied().unwrap_or_default();
        let gap = gap[0].max(gap[1]);
        let slack: f64 = known.path.segments.iter().map(|s| rounding(s) + stretch(s)).sum();
        let length = known.path.length() - gap - SAME - slack;
        let passes = self.passes.get(contour as usize).map_or(1, |&n| n as usize);
        if let Some((first, _)) = work.steps.filter(|_| work.length >= length) {
            if work.done.len() + 1 >= passes {
                found.push(Violation::Again { step, contour });
                return;
            }
            if self.order.last() != Some(&contour) {
                found.push(Violation::Passes { contour, what: "is left between its passes" });
            }
            let finished = std::mem::take(&mut work.path);
            work.done.push(finished);
            work.length = 0.0;
            work.steps = Some((first, step));
            self.open.push(contour);
        } else if let Some((first, _)) = work.steps {
            let may_be_left =
                self.pre_cut.is_some() && known.path.closed && known.operation == Operation::Cut;
            if !may_be_left && !work.at_joint {
                found.push(Violation::Left { step, contour });
            }
            if let Some(&inner) = self.open.last().filter(|&&last| last != contour) {
                found.push(Violation::Crossed { step, contour, inner });
            }
            work.steps = Some((first, step));
        } else {
            work.steps = Some((step, step));
            self.open.push(contour);
        }
        let ahead = Path::new(std::mem::take(&mut work.ahead), false);
        if !leads(&Path::new(path.to_vec(), false), &ahead) {
            found.push(Violation::Beam { step, what: "goes on elsewhere than it was cut ahead" });
        }
        work.path.extend(path);
        work.length += path.iter().map(Segment::length).sum::<f64>();
        (work.ready, work.at_joint) = (false, false);
        if work.length >= length {
            self.open.retain(|&o| o != contour);
        }
        self.order.push(contour);
    }

    /// Follows a joint, which stays uncut. Returns whether the contour is being cut.
    pub(super) fn joint(&mut self, contour: u32, path: &[Segment]) -> bool {
        let unfinished = self.is_unfinished(contour);
        if let Some(work) = self.work.get_mut(contour as usize) {
            work.path.extend(path);
            work.length += path.iter().map(Segment::length).sum::<f64>();
            work.at_joint = true;
        }
        unfinished
    }

    /// Follows a cut of a contour that is cut with its group.
    pub(super) fn note(&mut self, step: usize, contour: u32) {
        if let Some(work) = self.work.get_mut(contour as usize) {
            work.steps = Some((work.steps.map_or(step, |s| s.0), step));
            self.order.push(contour);
        }
    }

    /// The move at which a contour was first cut.
    pub(super) fn begins(&self, contour: u32) -> Option<usize> {
        self.work.get(contour as usize)?.steps.map(|s| s.0)
    }

    /// The move at which a contour was last cut.
    pub(super) fn ends(&self, contour: u32) -> Option<usize> {
        self.work.get(contour as usize)?.steps.map(|s| s.1)
    }

    /// After the last move: every contour is cut completely in each of its passes.
    ///
    /// `elsewhere`: the contours that are followed elsewhere.
    pub(super) fn finish(&self, elsewhere: impl Fn(u32) -> bool, found: &mut Vec<Violation>) {
        for ((contour, work), known) in (0..).zip(&self.work).zip(&self.sheet.contours) {
            let Some((_, step)) = work.steps else {
                if known.is_processed() && known.path.segments.iter().any(|s| s.length() > SAME) {
                    found.push(Violation::Missing { contour });
                }
                continue;
            };
            if elsewhere(contour) {
                continue;
            }
            if work.done.len() + 1 != self.passes.get(contour as usize).map_or(1, |&n| n as usize) {
                found.push(Violation::Passes { contour, what: "is not cut in as many passes as asked for" });
            }
            let gaps = self.gap.get(contour as usize).copied().unwrap_or_default();
            // Without a lead's gap, a contour may begin at a joint.
            let uncut = known.path.length() - work.length;
            let gap = if (uncut - gaps[0]).abs() <= (uncut - gaps[1]).abs() { gaps[0] } else { gaps[1] };
            let rounds = work.done.iter().chain([&work.path]);
            if let Some(fault) = rounds.map(|path| follows(&known.path, path, gap)).find_map(Result::err) {
                found.push(match fault {
                    Fault::Strays(at) => Violation::Strays { step, contour, at },
                    Fault::Length { worked, length } => Violation::Partly { step, contour, worked, length },
                });
            }
        }
    }
}
