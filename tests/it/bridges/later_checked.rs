//! What the checker says of plans in which one thing is wrong with a cut through a bridge.

use super::later::later;
use super::{bridging, nest, p, planned, with};
use kerfway::geometry::{DVec2, Path, Segment};
use kerfway::machine::Profile;
use kerfway::plan::{self, Move, Plan};
use kerfway::sheet::Sheet;
use serde_json::json;

struct Case {
    sheet: Sheet,
    machine: Profile,
    plan: Plan,
}

/// Three squares in a row: the cut around them is contour 0, those through the two bridges are 3 to 6.
fn case() -> Case {
    let machine = with(&later(&bridging(3.0, 10.0)), &json!({ "pierce_time": 3.0 }));
    let job = planned(&nest(3, 1, p(20.0, 20.0), 8.0), machine.clone());
    let plan = job.plan().unwrap();
    assert_eq!(plan.summary.bridges, 2);
    Case { sheet: job.beam_sheet().clone(), machine, plan }
}

impl Case {
    /// What the checker says, with sums that are right.
    fn found(&mut self) -> String {
        let before = self.plan.summary.clone();
        self.plan.summary = plan::evaluate(&self.plan.moves, &self.sheet, &self.machine);
        (self.plan.summary.parts, self.plan.summary.bridges) = (before.parts, before.bridges);
        let found = plan::check(&self.sheet, &self.machine, &self.plan).err().unwrap_or_default();
        found.iter().map(|v| format!("{v}\n")).collect()
    }

    /// The place of the cut of a contour among the moves.
    fn place(&self, wanted: u32) -> usize {
        let is = |m: &Move| matches!(m, Move::Cut { contour, .. } if *contour == wanted);
        self.plan.moves.iter().position(is).unwrap()
    }

    /// Replaces the line of a cut, and the move to it.
    fn follow(&mut self, contour: u32, from: DVec2, to: DVec2) {
        let at = self.place(contour);
        let path = vec![Segment::line(from, to)];
        if let Move::Cut { path: cut, .. } = &mut self.plan.moves[at] {
            cut.clone_from(&path);
        }
        self.arrive(at, from);
        if matches!(self.plan.moves.get(at + 1), Some(Move::Cut { .. })) {
            self.plan.moves.insert(at + 1, Move::air(self.start(at + 1)));
        }
        let known = &mut self.sheet.contours[contour as usize];
        known.path = Path::new(path, false);
        (known.length, known.bounds) = (known.path.length(), known.path.bounds());
    }

    fn start(&self, at: usize) -> DVec2 {
        let Move::Cut { path, .. } = &self.plan.moves[at] else { panic!("no cut") };
        path[0].start()
    }

    /// The move before a cut ends where that begins.
    fn arrive(&mut self, at: usize, to: DVec2) {
        match &mut self.plan.moves[at - 1] {
            Move::Air { to: end, .. } => *end = to,
            _ => self.plan.moves.insert(at, Move::air(to)),
        }
    }

    fn line(&self, contour: u32) -> [DVec2; 2] {
        let path = &self.sheet.contours[contour as usize].path;
        [path.start().unwrap(), path.end().unwrap()]
    }
}

#[track_caller]
fn says(case: &mut Case, what: &str) {
    let found = case.found();
    assert!(found.contains(what), "{found}");
}

#[test]
fn the_plan_is_right_as_it_is() {
    assert_eq!(case().found(), "");
    // The other way along a cut is as good, with its move.
    let mut turned = case();
    let [from, to] = turned.line(4);
    turned.follow(4, to, from);
    assert_eq!(turned.found(), "");
}

#[test]
fn cuts_that_nobody_asks_for_are_found() {
    let mut case = case();
    case.machine.levers.bridges.as_mut().unwrap().cut_later = false;
    says(&mut case, "has a cut through a bridge, which the machine does not make");
}

#[test]
fn cuts_that_are_missing_or_made_twice_are_found() {
    // One is left out of the plan, or out of the sheet as well.
    let mut missing = case();
    let at = missing.place(5);
    missing.plan.moves[at] = Move::air(missing.line(5)[0]);
    says(&mut missing, "5");
    let mut unknown = case();
    let at = unknown.place(6);
    unknown.plan.moves[at] = Move::air(p(0.0, 0.0));
    unknown.sheet.contours.pop();
    says(&mut unknown, "is not cut once along the stretch where a bridge ends on it");
    let mut twice = case();
    let again = twice.sheet.contours[6].clone();
    twice.sheet.contours.push(again);
    says(&mut twice, "is not cut once along the stretch where a bridge ends on it");
    let mut more = case();
    let mut other = more.sheet.contours[6].clone();
    let [from, to] = more.line(6);
    other.path = Path::new(vec![Segment::line(from + p(0.0, 5.0), to + p(0.0, 5.0))], false);
    more.sheet.contours.push(other);
    says(&mut more, "has more cuts through bridges than bridges end on it");
}

#[test]
fn cuts_elsewhere_are_found() {
    let wrong = "is not cut once along the stretch where a bridge ends on it";
    for change in [p(0.1, 0.0), p(0.0, 0.1), p(0.0, 5.0)] {
        let mut moved = case();
        let [from, to] = moved.line(4);
        moved.follow(4, from + change, to + change);
        says(&mut moved, wrong);
    }
    let mut short = case();
    let [from, to] = short.line(4);
    short.follow(4, from, from.lerp(to, 0.9));
    says(&mut short, wrong);
    let mut long = case();
    let [from, to] = long.line(4);
    long.follow(4, from, from.lerp(to, 1.1));
    says(&mut long, wrong);
    // For the outline of another part, or beside the drawn line as if there were a kerf.
    let mut other = case();
    other.sheet.contours[4].bridged = Some(2);
    says(&mut other, wrong);
    let mut kerf = case();
    kerf.machine.kerf_width = 0.2;
    kerf.sheet.contours[0].drawn = Some(kerf.sheet.contours[0].path.clone());
    says(&mut kerf, wrong);
}

#[test]
fn cuts_before_the_cut_around_the_parts_are_found() {
    let mut early = case();
    let (around, cut) = (early.place(0), early.place(3));
    let moved = early.plan.moves[cut].clone();
    let [from, _] = early.line(3);
    let at = early.start(around);
    early.plan.moves[cut] = Move::air(early.plan.moves[cut].end().unwrap());
    // Before the cut around the parts: there, pierced, and on to where that one begins.
    let first = early.plan.moves[..around].iter().rposition(|m| matches!(m, Move::Air { .. })).unwrap();
    let start = if let Move::Cut { path, .. } = &moved { path[0].start() } else { from };
    early
        .plan
        .moves
        .splice(first..around, [Move::air(start), Move::Pierce, moved, Move::air(at), Move::Pierce]);
    says(&mut early, "is completed before the cut around the connected parts");
}

#[test]
fn a_cut_that_begins_on_no_kerf_has_to_be_pierced() {
    let mut off = case();
    let [from, to] = off.line(4);
    off.follow(4, from.lerp(to, 0.2), to);
    says(&mut off, "cuts without piercing");
}
