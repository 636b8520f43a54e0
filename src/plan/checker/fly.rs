//! Checks cuts on the run (`levers.fly`): where the head may run on, and that each contour is cut once and wholly, in one go or
//! side by side in several runs.
//!
//! A contour in one go is followed along its whole length. Of one that is cut in pieces, the middle of each piece is found on the
//! contour; the pieces around these middles have to lie on the contour, and each has to begin where the one before it ends.

use super::coverage::{Fault, follows};
use super::joints;
use super::lead_rules;
use super::leads;
use super::tolerance::{SAME, rounding};
use super::violation::Violation;
use crate::geometry::{DVec2, Path, Segment};
use crate::machine::{PLANS_ALL_LEVERS, Profile};
use crate::plan::model::{Leads, Move, Plan};
use crate::sheet::{Contour, Operation, Sheet};

/// Largest error of an overcut, mm.
const OVERCUT: f64 = 1e-3;

/// A cut of a contour that is cut on the run.
struct Piece {
    step: usize,
    path: Path,
    overcut: Vec<Segment>,
    /// Whether it has leads.
    led: bool,
}

/// The contours of a plan that are cut on the run, with their cuts.
pub(super) struct Flown {
    /// By contour; `None`: it is not cut on the run.
    work: Vec<Option<Vec<Piece>>>,
}

impl Flown {
    /// Every contour with a cut before or after which the head runs on.
    pub(super) fn new(sheet: &Sheet, plan: &Plan) -> Self {
        let mut work: Vec<Option<Vec<Piece>>> = sheet.contours.iter().map(|_| None).collect();
        for pair in plan.moves.windows(2) {
            if let [Move::Fly { .. }, Move::Cut { contour, .. }]
            | [Move::Cut { contour, .. }, Move::Fly { .. }] = pair
                && let Some(of) = work.get_mut(*contour as usize)
            {
                *of = Some(Vec::new());
            }
        }
        Self { work }
    }

    /// Whether a contour is cut on the run.
    pub(super) fn holds(&self, contour: u32) -> bool {
        PLANS_ALL_LEVERS && self.work.get(contour as usize).is_some_and(Option::is_some)
    }

    /// Follows a cut of such a contour.
    pub(super) fn cut(&mut self, step: usize, contour: u32, path: &[Segment], leads: &Leads) {
        let [lead_in, on, overcut, lead_out] = leads.divide(path);
        if let Some(Some(pieces)) = self.work.get_mut(contour as usize) {
            let led = !lead_in.is_empty() || !lead_out.is_empty();
            pieces.push(Piece { step, path: Path::new(on.to_vec(), false), overcut: overcut.to_vec(), led });
        }
    }

    /// After the last move: every such contour may be cut on the run, and is cut wholly and once; and the head runs on only where
    /// and as far as the machine does.
    pub(super) fn finish(&self, sheet: &Sheet, machine: &Profile, plan: &Plan, found: &mut Vec<Violation>) {
        // Builds without them refuse machines with cuts on the run.
        if !PLANS_ALL_LEVERS {
            return;
        }
        runs(sheet, machine, plan, found);
        for ((id, contour), pieces) in (0..).zip(&sheet.contours).zip(&self.work) {
            let Some(pieces) = pieces else { continue };
            let Some(step) = pieces.last().map(|p| p.step) else { continue };
            let mut beam = |what| found.push(Violation::Beam { step, what });
            let once = sheet.process_of(contour, machine).passes == 1 && contour.next_pass.is_none();
            if !contour.path.closed || contour.operation != Operation::Cut || !once {
                beam("cuts on the run what is open, a mark, or cut in several passes");
            }
            if joints::asked(sheet, machine, id).is_some() || lead_rules::asked(sheet, machine, id, contour) {
                beam("cuts on the run what has joints or leads");
            }
            if pieces.iter().any(|p| p.led) {
                beam("has leads on the run");
            }
            let fault = match pieces.as_slice() {
                [piece] => whole(machine, contour, piece, &mut beam),
                pieces => piecewise(contour, pieces),
            };
            match fault {
                Some(Fault::Strays(at)) => found.push(Violation::Strays { step, contour: id, at }),
                Some(Fault::Length { worked, length }) => {
                    found.push(Violation::Partly { step, contour: id, worked, length });
                }
                None => {}
            }
        }
    }
}

/// The ways between cuts: the machine has the lever, they are short enough, and both cuts are of the same speed.
fn runs(sheet: &Sheet, machine: &Profile, plan: &Plan, found: &mut Vec<Violation>) {
    for (step, three) in plan.moves.windows(3).enumerate() {
        let [before, Move::Fly { path }, after] = three else { continue };
        let mut beam = |what| found.push(Violation::Beam { step: step + 1, what });
        let Some(lever) = machine.levers.fly else {
            beam("cuts on the run, which the machine does not");
            continue;
        };
        if path.iter().map(Segment::length).sum::<f64>() > lever.reach + SAME {
            beam("runs on farther than the machine does");
        }
        match (before, after) {
            (Move::Cut { contour: a, .. }, Move::Cut { contour: b, .. }) => {
                if sheet.process_by_id(*a, machine) != sheet.process_by_id(*b, machine) {
                    beam("runs on to a cut of another process");
                }
            }
            _ => beam("runs on without a cut before and after it"),
        }
    }
}

/// The fault of a contour that is cut in one go, which is cut again at its end.
fn whole(
    machine: &Profile,
    contour: &Contour,
    piece: &Piece,
    beam: &mut impl FnMut(&'static str),
) -> Option<Fault> {
    let asked = machine.levers.fly.map_or(0.0, |f| f.overcut.min(0.5 * contour.path.length()));
    let again: f64 = piece.overcut.iter().map(Segment::length).sum();
    if (again - asked).abs() > OVERCUT || leads::strays(&piece.path.segments, &piece.overcut).is_some() {
        beam("does not cut the beginning again on the run");
    }
    follows(&contour.path, &piece.path.segments, 0.0).err()
}

/// The fault of a contour that is cut in pieces, none of which is cut again.
fn piecewise(contour: &Contour, pieces: &[Piece]) -> Option<Fault> {
    let length = contour.path.length();
    let slack = SAME + contour.path.segments.iter().map(rounding).sum::<f64>();
    let cut = |p: &Piece| p.path.length() + p.overcut.iter().map(Segment::length).sum::<f64>();
    let worked: f64 = pieces.iter().map(cut).sum();
    let incomplete = Some(Fault::Length { worked, length });
    let exact = (worked - length).abs() <= slack;
    if !exact {
        return incomplete;
    }
    let mut ends = Vec::with_capacity(pieces.len());
    for piece in pieces {
        let half = 0.5 * piece.path.length();
        let middle = contour.path.nearest(piece.path.at(half)?)?.0;
        let place = |along: f64| contour.path.at(along.rem_euclid(length));
        let at = |from: f64| piece.path.at(half + from);
        let astray = |way: f64| {
            let far = |from: &f64| {
                let (a, b) = (at(*from), place(middle + way * from));
                !a.zip(b).is_some_and(|(a, b)| a.distance(b) <= slack)
            };
            [-half, -0.5 * half, 0.0, 0.5 * half, half].into_iter().find(far)
        };
        if let (Some(from), Some(_)) = (astray(1.0), astray(-1.0)) {
            return Some(Fault::Strays(at(from).unwrap_or(DVec2::ZERO)));
        }
        ends.push((middle - half, middle + half));
    }
    ends.sort_by(|a, b| a.0.total_cmp(&b.0));
    let gap = |a: &(f64, f64), b: &(f64, f64)| (b.0 - a.1).abs() > slack;
    if ends.windows(2).any(|w| gap(&w[0], &w[1])) { incomplete } else { None }
}
