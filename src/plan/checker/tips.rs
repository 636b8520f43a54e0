//! Replays which pieces are free at what time, and looks for moves with the head down over those that may have tipped.
//!
//! It shares no formula with `src/tipping`: outlines are not polygons but lines and arcs, with the winding numbers of
//! `nesting.rs`; moves over a piece are found by places along them (`over.rs`); extents are those of places along the outline (`tip_sizes.rs`). What comes free by
//! cuts through bridges is found in `cut_apart.rs`.

use super::cut_apart;
use super::joints_left::joints_left;
use super::nesting::pairs;
use super::over::{Limits, MOST, SLACK, STEP, from_piece, line_crosses, places_cross};
use super::rapids;
use super::tip_sizes::{SIZE_SLACK, tips_up};
use super::violation::Violation;
use crate::geometry::{Aabb, BoxIndex, DVec2, Path, Segment};
use crate::machine::{PLANS_ALL_LEVERS, Profile, RiskyMoves, Tips};
use crate::plan::model::{Move, Plan, Way};
use crate::sheet::{Operation, Sheet};
use rustc_hash::{FxHashMap, FxHashSet};
use std::borrow::Cow;

/// How far beyond the edge of the bed a way around may be, mm: rounding.
const OFF_BED: f64 = 1e-6;
/// Sides nearer than this are shared, mm.
const ONE_LINE: f64 = 0.11;

/// A piece that may tip.
struct Piece<'s> {
    contour: u32,
    outline: Cow<'s, Path>,
    /// Index of the last move that cuts its outline.
    free_from: usize,
    /// Whether it tips even if its sizes are off by their rounding.
    surely: bool,
}

pub(super) fn check(sheet: &Sheet, machine: &Profile, plan: &Plan, found: &mut Vec<Violation>) {
    // Builds without them refuse machines with pieces that tip.
    if !PLANS_ALL_LEVERS {
        return;
    }
    ways(machine, plan, found);
    let Some(tips) = machine.levers.tips else { return };
    let tipped = Tipped::new(sheet, machine, &tips, plan, found);
    let mut head = machine.home();
    for (step, m) in plan.moves.iter().enumerate() {
        let from = head;
        head = m.end().unwrap_or(head);
        match m {
            Move::Chain { path } if tipped.avoids => {
                if !matches!(step.checked_sub(1).and_then(|k| plan.moves.get(k)), Some(Move::Cut { .. })) {
                    tipped.start_on_kerf(step, from, found);
                }
                tipped.run(step, path, "cuts through waste past a piece that may have tipped", found);
            }
            Move::Fly { path } if tipped.avoids => {
                tipped.run(step, path, "runs on over a piece that may have tipped", found);
            }
            Move::Air { to, way } => tipped.air(step, [from, *to], *way, found),
            _ => {}
        }
    }
}

/// Checks that air moves go around pieces, over them or lifted only where the machine asks for it, and stay on the bed.
fn ways(machine: &Profile, plan: &Plan, found: &mut Vec<Violation>) {
    let tips = machine.levers.tips;
    for (step, m) in plan.moves.iter().enumerate() {
        let Move::Air { to, way } = m else { continue };
        if let (Way::Around, Some([x0, y0, x1, y1])) = (way, machine.bed)
            && !(x0 - OFF_BED..=x1 + OFF_BED).contains(&to.x) | !(y0 - OFF_BED..=y1 + OFF_BED).contains(&to.y)
        {
            found.push(Violation::OffBed { step, at: *to });
        }
        let asked = match way {
            Way::Plain => true,
            Way::Crosses => tips.is_some(),
            Way::Around | Way::Lifted => tips.is_some_and(|t| t.risky_moves == RiskyMoves::Avoid),
        };
        if !asked {
            found.push(Violation::Unasked { step });
        }
    }
}

/// The pieces that may tip, and moves beside and over them.
struct Tipped<'c> {
    machine: &'c Profile,
    /// Whether the machine goes around tipped pieces.
    avoids: bool,
    /// Distance from a piece within which the nozzle may touch it, mm.
    reach: f64,
    pieces: Vec<Piece<'c>>,
    index: BoxIndex,
}

impl<'c> Tipped<'c> {
    fn new(
        sheet: &'c Sheet,
        machine: &'c Profile,
        tips: &Tips,
        plan: &Plan,
        found: &mut Vec<Violation>,
    ) -> Self {
        let joints = joints_left(sheet, machine, plan);
        let mut pieces = pieces(sheet, tips, plan, |c| joints.contains_key(&c));
        for apart in cut_apart::pieces(sheet, tips, plan, &joints, found) {
            let surely = tips_up(tips, &apart.outline, false, -SIZE_SLACK);
            let cut_apart::Apart { contour, outline, free_from } = apart;
            pieces.push(Piece { contour, outline: Cow::Owned(outline), free_from, surely });
        }
        let reach = tips.nozzle_radius + tips.margin;
        let index = BoxIndex::new(pieces.iter().map(|p| p.outline.bounds().grown(reach + SLACK)));
        Self { machine, avoids: tips.risky_moves == RiskyMoves::Avoid, reach, pieces, index }
    }

    /// The pieces near an area that are free before a move.
    fn free(&self, step: usize, area: Aabb) -> impl Iterator<Item = &Piece<'c>> {
        let near = self.index.query(area).into_iter().filter_map(|k| self.pieces.get(k));
        near.filter(move |p| p.free_from < step)
    }

    /// Checks where a chain begins that no cut leads to.
    fn start_on_kerf(&self, step: usize, at: DVec2, found: &mut Vec<Violation>) {
        let beside = |p: &&Piece| p.surely && from_piece(&p.outline, at) < self.reach;
        if let Some(piece) = self.free(step, Aabb::of(at)).find(beside) {
            let what = "begins on a kerf beside a piece that may have tipped";
            found.push(Violation::Tipped { step, contour: piece.contour, what, at });
        }
    }

    /// Checks a chain or a way between cuts on the run, which does `what` if it crosses a piece.
    fn run(&self, step: usize, path: &[Segment], what: &'static str, found: &mut Vec<Violation>) {
        let limits = Limits::surely(self.reach);
        let crossed = |s: &Segment| {
            self.free(step, s.bounds()).find(|p| p.surely && line_crosses(s, &p.outline, limits))
        };
        if let Some((contour, at)) = path.iter().find_map(|s| Some((crossed(s)?.contour, s.at(0.5)))) {
            found.push(Violation::Tipped { step, contour, what, at });
        }
    }

    /// Checks an air move with the head down.
    fn air(&self, step: usize, [from, to]: [DVec2; 2], way: Way, found: &mut Vec<Violation>) {
        let by_length = self.machine.levers.lift.filter(|_| !self.avoids);
        let lifted = by_length.is_some_and(|l| (to - from).length() - l.stay_down > 1e-6);
        if way == Way::Lifted || lifted || from == to || !to.is_finite() {
            return;
        }
        let line = Segment::line(from, to);
        let free: Vec<&Piece> = self.free(step, line.bounds()).collect();
        let places = free.first().and_then(|_| rapids::places(self.machine, from, to));
        let crosses = |p: &Piece, limits: Limits| match &places {
            Some(places) => places_cross(places, &p.outline, limits),
            None => line_crosses(&line, &p.outline, limits),
        };
        let crossed = free.iter().find(|p| p.surely && crosses(p, Limits::surely(self.reach)));
        // Where each axis moves by itself, a piece beside the way may be said to be crossed, as ramps are not known exactly.
        let may_cross = |p: &&Piece| places.is_some() || crosses(p, Limits::perhaps(self.reach));
        let (contour, what) = match (way, crossed) {
            (Way::Crosses, _) if self.avoids => {
                (crossed.map_or(0, |p| p.contour), "is down over a piece that may have tipped")
            }
            (Way::Crosses, _) if !free.iter().any(may_cross) => {
                (0, "is said to cross a tipped piece where there is none")
            }
            (Way::Crosses, _) | (_, None) => return,
            (_, Some(piece)) => (piece.contour, "is down over a piece that may have tipped"),
        };
        found.push(Violation::Tipped { step, contour, what, at: (from + to) * 0.5 });
    }
}

/// The pieces that may tip and are cut free by the plan.
fn pieces<'s>(sheet: &'s Sheet, tips: &Tips, plan: &Plan, is_held: impl Fn(u32) -> bool) -> Vec<Piece<'s>> {
    let mut last: FxHashMap<u32, usize> = FxHashMap::default();
    for (step, m) in plan.moves.iter().enumerate() {
        let Move::Cut { contour, with, .. } = m else { continue };
        for c in with.iter().chain([contour]) {
            last.insert(*c, step);
        }
    }
    // Holes lie inside an odd number of outlines.
    let mut around = vec![0_u32; sheet.contours.len()];
    if tips.cross_over > 0.0 {
        for (inner, _) in pairs(sheet) {
            around[inner as usize] += 1;
        }
    }
    let mut pieces: Vec<Piece> = Vec::new();
    let mut shapes: FxHashSet<u32> = FxHashSet::default();
    for (contour, known) in (0..).zip(&sheet.contours) {
        let outline = if known.path.closed { Some(&known.path) } else { known.outline.as_ref() };
        let Some(outline) = outline else { continue };
        let cuts = known.operation == Operation::Cut && known.next_pass.is_none();
        let hole = around[contour as usize] % 2 == 1;
        // A shape whose sides are shared with others is free when all that is left of it is cut.
        let same = |c: &u32| sheet.contours.get(*c as usize).is_some_and(|c| c.rest_of == known.rest_of);
        let own: Vec<u32> = match known.rest_of {
            Some(shape) if !shapes.insert(shape) => continue,
            Some(_) => (0..).take(sheet.contours.len()).filter(same).collect(),
            None => vec![contour],
        };
        let others = if known.rest_of.is_some() { shared(sheet, outline, &own) } else { Vec::new() };
        let free_from = own.iter().chain(&others).map(|c| last.get(c).copied()).max().flatten();
        let Some(free_from) = free_from.filter(|_| cuts && !own.iter().any(|c| is_held(*c))) else {
            continue;
        };
        if tips_up(tips, outline, hole, SIZE_SLACK) {
            let surely = tips_up(tips, outline, hole, -SIZE_SLACK);
            pieces.push(Piece { contour, outline: Cow::Borrowed(outline), free_from, surely });
        }
    }
    pieces
}

/// The contours of others that cut sides of an outline: some of their places lie on it where none of its own cuts does.
fn shared(sheet: &Sheet, outline: &Path, own: &[u32]) -> Vec<u32> {
    let is_on = |path: &Path, p: DVec2| path.nearest(p).is_some_and(|(_, on)| on.distance(p) < ONE_LINE);
    let by_own =
        |p: DVec2| own.iter().filter_map(|&c| sheet.contours.get(c as usize)).any(|c| is_on(&c.path, p));
    let area = outline.bounds().grown(ONE_LINE);
    let is_shared = |s: &Segment| {
        let count = (s.length() / STEP).ceil().clamp(1.0, MOST);
        let mut places = std::iter::successors(Some(0.5), |k| Some(k + 1.0)).take_while(|k| *k < count);
        s.bounds().overlaps(&area)
            && places.any(|k| {
                let p = s.at(k / count);
                area.contains(p) && is_on(outline, p) && !by_own(p)
            })
    };
    let cuts = (0..)
        .zip(&sheet.contours)
        .filter(|(id, c)| c.operation == Operation::Cut && c.next_pass.is_none() && !own.contains(id));
    cuts.filter(|(_, c)| c.path.segments.iter().any(is_shared)).map(|(id, _)| id).collect()
}
