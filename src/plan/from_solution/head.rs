//! The head on its way: the moves so far, and where it is.

use crate::corner::{Corner, turned};
use crate::geometry::{DVec2, Path, Segment};
use crate::joint::{Divided, Stretch};
use crate::machine::{PLANS_ALL_LEVERS, Process, Profile};
use crate::plan::model::{Leads, Move, Turn};
use crate::problem::Stroke;

/// The corners of a contour that may be cut in loops or rounded, and which of them are.
pub(super) type Corners<'p> = (&'p [Corner], &'p [usize]);

/// Writes moves. Each method leaves the head where its last move ends.
pub(super) struct Head<'p> {
    machine: &'p Profile,
    pub(super) moves: Vec<Move>,
    pub(super) at: DVec2,
}

impl<'p> Head<'p> {
    /// The head at `at`, with room for this many moves.
    pub(super) fn new(machine: &'p Profile, at: DVec2, capacity: usize) -> Self {
        Self { machine, moves: Vec::with_capacity(capacity), at }
    }

    /// Moves with the beam off, unless the head is already there.
    pub(super) fn go(&mut self, to: DVec2) {
        if self.at != to {
            self.moves.push(Move::air(to));
            self.at = to;
        }
    }

    /// Cuts through waste to where a contour is entered.
    pub(super) fn chain(&mut self, chain: Segment) {
        self.go(chain.start());
        self.moves.push(Move::Chain { path: vec![chain] });
        self.at = chain.end();
    }

    /// Lowers the head for a pass, if the process asks for it; returns whether it did.
    pub(super) fn lower(&mut self, pass: u32, process: &Process) -> bool {
        let z = 0.0 - f64::from(pass) * process.z_step;
        if z < 0.0 {
            self.moves.push(Move::Height { z });
        }
        z < 0.0
    }

    /// Cuts or marks along elements without stopping in their corners.
    pub(super) fn run(&mut self, contour: u32, path: Vec<Segment>, mark: bool, leads: Leads) {
        self.at = path.last().map_or(self.at, Segment::end);
        self.moves.push(Move::Cut { contour, with: Vec::new(), path, mark, leads, turns: Vec::new() });
    }

    /// Cuts along elements of one contour, with a macro in each sharp corner.
    pub(super) fn cut(&mut self, contour: u32, path: &[Segment], leads: Leads, turns: &[Turn]) {
        self.cut_along(path, leads, turns, |_| contour);
    }

    /// Cuts along elements, with a macro in each sharp corner. `whose` gives the contour of each element.
    fn cut_along(&mut self, path: &[Segment], leads: Leads, turns: &[Turn], whose: impl Fn(usize) -> u32) {
        let mut done = 0;
        for run in self.machine.runs(path) {
            let Some(first) = run.first() else { continue };
            if done > 0 {
                self.moves.push(Move::Macro { contour: whose(done - 1), at: first.start() });
            }
            let (contour, mut with) = (whose(done), Vec::new());
            for other in (done..done + run.len()).map(&whose) {
                if other != contour && !with.contains(&other) {
                    with.push(other);
                }
            }
            let leads = leads.of_stretch(done, run.len(), path.len());
            let here = |turn: &&Turn| (done..done + run.len()).contains(&turn.first);
            let turns =
                turns.iter().filter(here).map(|turn| Turn { first: turn.first - done, ..*turn }).collect();
            self.moves.push(Move::Cut { contour, with, path: run.to_vec(), mark: false, leads, turns });
            done += run.len();
        }
        self.at = path.last().map_or(self.at, Segment::end);
    }

    /// Cuts the stretches of a contour with joints, from its entry on.
    pub(super) fn over_joints(&mut self, contour: u32, divided: Divided, flying: bool, corners: Corners) {
        let mut joints = divided.joints.into_iter();
        for (k, stretch) in divided.stretches.into_iter().enumerate() {
            if k == 0 || !flying {
                self.moves.push(Move::Pierce);
            }
            let Stretch { path, lead_in, overcut, lead_out } = stretch;
            let leads = Leads { lead_in, overcut, lead_out };
            let (path, turns) = with_turns(path, leads, corners);
            self.cut(contour, &path, leads, &turns);
            if let Some(path) = joints.next() {
                self.moves.push(Move::Joint { contour, path, flying });
            }
        }
    }

    /// Visits a pierce group or contours that are cut on the run, with a lead to the first cut if there is one.
    pub(super) fn through(&mut self, mut lead: Option<Segment>, strokes: &[Stroke]) {
        for stroke in strokes {
            match stroke {
                Stroke::Air(to) => self.go(*to),
                Stroke::Pierce => self.moves.push(Move::Pierce),
                Stroke::MovingStart => self.moves.push(Move::MovingStart),
                Stroke::Fly(path) => {
                    self.moves.push(Move::Fly { path: path.clone() });
                    self.at = path.last().map_or(self.at, Segment::end);
                }
                Stroke::PreCut { contour, ahead } => {
                    self.moves.push(Move::PreCut { contour: *contour, to: self.at, ahead: ahead.clone() });
                }
                Stroke::Cut { spans, path, overcut } => {
                    let whose = spans.iter().flat_map(|s| std::iter::repeat_n(s.contour, s.elements));
                    let whose: Vec<u32> = whose.collect();
                    let path: Vec<Segment> = lead.take().into_iter().chain(path.iter().copied()).collect();
                    let lead_in = path.len() - (whose.len() + overcut).min(path.len());
                    let leads = Leads { lead_in, overcut: *overcut, ..Leads::default() };
                    self.cut_along(&path, leads, &[], |element| {
                        whose
                            .get(element.saturating_sub(lead_in))
                            .or(whose.last())
                            .copied()
                            .unwrap_or_default()
                    });
                }
            }
        }
    }

    /// Cuts the rest of a contour ahead, which is left here and resumed later.
    pub(super) fn pre_cut(&mut self, contour: u32, rest: Vec<Segment>) {
        let ahead = self.machine.cut_ahead(&Path::new(rest, false));
        self.moves.push(Move::PreCut { contour, to: self.at, ahead });
    }
}

/// The elements of a cut with the corners that are cut in loops or rounded.
pub(super) fn with_turns(
    path: Vec<Segment>,
    leads: Leads,
    (corners, chosen): Corners,
) -> (Vec<Segment>, Vec<Turn>) {
    if !PLANS_ALL_LEVERS || chosen.is_empty() {
        return (path, Vec::new());
    }
    let on = leads.lead_in..path.len().saturating_sub(leads.overcut + leads.lead_out);
    let (path, made) = turned(&path, on, corners, chosen);
    let turns = made.into_iter().filter_map(|made| {
        let corner = corners.get(made.corner)?;
        Some(Turn { kind: corner.kind, at: corner.at, first: made.first, count: made.count })
    });
    (path, turns.collect())
}
