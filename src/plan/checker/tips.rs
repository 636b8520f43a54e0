//! Replays which pieces are free at what time, and looks for moves with the head down over those that may have tipped.
//!
//! It shares no formula with `src/tipping`: outlines are not polygons but lines and arcs, with the winding numbers of
//! `nesting.rs`; moves over a piece are found by places along them; extents are those of places along the outline (`tip_sizes.rs`). What comes free by
//! cuts through bridges is found in `cut_apart.rs`.

use super::cut_apart;
use super::fractions::fractions;
use super::joints_left::joints_left;
use super::nesting::{pairs, winding};
use super::rapids;
use super::tip_sizes::{SIZE_SLACK, tips_up};
use super::violation::Violation;
use crate::geometry::{Aabb, BoxIndex, DVec2, Path, Segment, distance};
use crate::machine::{PLANS_ALL_LEVERS, Profile, RiskyMoves, Tips};
use crate::plan::model::{Move, Plan, Way};
use crate::sheet::{Operation, Sheet};
use rustc_hash::{FxHashMap, FxHashSet};
use std::borrow::Cow;

/// A move with the head down must not be this deep over a piece, mm.
const DEPTH: f64 = 0.1;
/// A move begins over a piece that it is this deep over, mm: on an outline it may be inside by rounding.
const BEGINS: f64 = 0.02;
/// What is nearer by less than this is not nearer, mm: plans are made with arcs as chords, which are up to 0.01 mm off.
const NEARER: f64 = 0.05;
/// How much farther from a piece a move may be that is said to cross it, mm.
const SLACK: f64 = 0.2;
/// How far beyond the edge of the bed a way around may be, mm: rounding.
const OFF_BED: f64 = 1e-6;
/// Distance between the places along a move, mm, and their largest number.
const STEP: f64 = 0.25;
const MOST: f64 = 2000.0;
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
    let tips = machine.levers.tips;
    let avoids = tips.is_some_and(|t| t.risky_moves == RiskyMoves::Avoid);
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
            Way::Around | Way::Lifted => avoids,
        };
        if !asked {
            found.push(Violation::Unasked { step });
        }
    }
    let Some(tips) = tips else { return };
    let joints = joints_left(sheet, machine, plan);
    let mut pieces = pieces(sheet, &tips, plan, |c| joints.contains_key(&c));
    for apart in cut_apart::pieces(sheet, &tips, plan, &joints, found) {
        let surely = tips_up(&tips, &apart.outline, false, -SIZE_SLACK);
        let cut_apart::Apart { contour, outline, free_from } = apart;
        pieces.push(Piece { contour, outline: Cow::Owned(outline), free_from, surely });
    }
    let reach = tips.nozzle_radius + tips.margin;
    let index = BoxIndex::new(pieces.iter().map(|p| p.outline.bounds().grown(reach + SLACK)));
    let mut head = machine.home();
    for (step, m) in plan.moves.iter().enumerate() {
        let from = head;
        head = m.end().unwrap_or(head);
        if let Move::Chain { .. } = m
            && avoids
            && !matches!(step.checked_sub(1).and_then(|k| plan.moves.get(k)), Some(Move::Cut { .. }))
            && let Some(piece) = (index.query(Aabb::of(from)).into_iter())
                .filter_map(|k| pieces.get(k))
                .find(|p| p.free_from < step && p.surely && from_piece(&p.outline, from) < reach)
        {
            let what = "begins on a kerf beside a piece that may have tipped";
            found.push(Violation::Tipped { step, contour: piece.contour, what, at: from });
        }
        if let Move::Fly { path } | Move::Chain { path } = m
            && avoids
        {
            let near = |s: &Segment| index.query(s.bounds()).into_iter().filter_map(|k| pieces.get(k));
            let crossed = |s: &Segment| {
                near(s)
                    .find(|p| p.free_from < step && p.surely && crosses(s, &p.outline, reach, DEPTH, -NEARER))
            };
            if let Some((contour, at)) = path.iter().find_map(|s| Some((crossed(s)?.contour, s.at(0.5)))) {
                let what = match m {
                    Move::Fly { .. } => "runs on over a piece that may have tipped",
                    _ => "cuts through waste past a piece that may have tipped",
                };
                found.push(Violation::Tipped { step, contour, what, at });
            }
            continue;
        }
        let Move::Air { to, way } = m else { continue };
        let by_length = machine.levers.lift.filter(|_| !avoids);
        let lifted = by_length.is_some_and(|l| (*to - from).length() - l.stay_down > 1e-6);
        if *way == Way::Lifted || lifted || from == *to || !to.is_finite() {
            continue;
        }
        let line = Segment::line(from, *to);
        let near = index.query(line.bounds());
        let free = || near.iter().filter_map(|&k| pieces.get(k)).filter(|p| p.free_from < step);
        let places = free().next().and_then(|_| rapids::places(machine, from, *to));
        let crosses = |p: &Piece, reach: f64, depth: f64, nearer: f64| match &places {
            Some(places) => passes(places, &p.outline, reach, depth, nearer),
            None => crosses(&line, &p.outline, reach, depth, nearer),
        };
        let middle = (from + *to) * 0.5;
        let crossed = free().find(|p| p.surely && crosses(p, reach, DEPTH, -NEARER));
        // Where each axis moves by itself, a piece beside the way may be said to be crossed, as ramps are not known exactly.
        let may_cross = |p: &Piece| places.is_some() || crosses(p, reach + SLACK, DEPTH * 0.1, NEARER);
        match (way, crossed) {
            (Way::Crosses, _) if avoids => {
                let contour = crossed.map_or(0, |p| p.contour);
                let what = "is down over a piece that may have tipped";
                found.push(Violation::Tipped { step, contour, what, at: middle });
            }
            (Way::Crosses, _) if !free().any(may_cross) => {
                let what = "is said to cross a tipped piece where there is none";
                found.push(Violation::Tipped { step, contour: 0, what, at: middle });
            }
            (Way::Crosses, _) => {}
            (_, Some(piece)) => {
                let what = "is down over a piece that may have tipped";
                found.push(Violation::Tipped { step, contour: piece.contour, what, at: middle });
            }
            _ => {}
        }
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

/// The distance of a place from an outline, mm.
fn from_outline(outline: &Path, p: DVec2) -> f64 {
    outline.segments.iter().map(|s| s.nearest(p).1).fold(f64::INFINITY, f64::min).sqrt()
}

/// The distance of a place from a piece, mm.
fn from_piece(outline: &Path, p: DVec2) -> f64 {
    let d = from_outline(outline, p);
    if d > 0.0 && winding(outline, p) != 0.0 { 0.0 } else { d }
}

/// Whether a line crosses a piece: nearer to it than `reach`, and nearer than at both ends by more than `-nearer`; or
/// `depth` mm over it, but for a stretch at an end that is over it.
fn crosses(line: &Segment, outline: &Path, reach: f64, depth: f64, nearer: f64) -> bool {
    let inside = |p: DVec2| winding(outline, p) != 0.0;
    let from_piece = |p: DVec2| from_piece(outline, p);
    let nearest = outline.segments.iter().map(|s| distance(line, s).0).fold(f64::INFINITY, f64::min);
    let ends = from_piece(line.start()).min(from_piece(line.end()));
    if nearest < reach && nearest < ends + nearer {
        return true;
    }
    // What touches no outline and begins outside is over nothing.
    if nearest > 0.0 && !inside(line.start()) {
        return false;
    }
    let places: Vec<DVec2> = fractions(line.length(), STEP, [2.0, MOST]).map(|f| line.at(f)).collect();
    runs_over(&places, outline, depth)
}

/// The same for a way by places that are close to each other.
fn passes(places: &[DVec2], outline: &Path, reach: f64, depth: f64, nearer: f64) -> bool {
    let area = outline.bounds().grown(reach);
    let near = places.iter().filter(|p| area.contains(**p));
    let nearest = near.map(|p| from_outline(outline, *p)).fold(f64::INFINITY, f64::min);
    let ends = places.first().into_iter().chain(places.last());
    let ends = ends.map(|p| from_piece(outline, *p)).fold(f64::INFINITY, f64::min);
    nearest < reach && (nearest < ends + nearer || runs_over(places, outline, depth))
}

/// Whether a way is `depth` mm over a piece. Where it begins or ends over the piece, the stretch within the outline is exempt.
fn runs_over(places: &[DVec2], outline: &Path, depth: f64) -> bool {
    let area = outline.bounds();
    let inside = |p: DVec2| area.contains(p) && winding(outline, p) != 0.0;
    let begins = |p: Option<&DVec2>| p.is_some_and(|&p| from_outline(outline, p) > BEGINS && inside(p));
    let outside = |p: &DVec2| !inside(*p);
    let first = if begins(places.first()) { places.iter().position(outside) } else { Some(0) };
    let last = if begins(places.last()) { places.iter().rposition(outside) } else { Some(places.len()) };
    let Some((first, last)) = first.zip(last) else { return false };
    let rest = places.get(first..last);
    rest.is_some_and(|rest| rest.iter().any(|&p| inside(p) && from_outline(outline, p) > depth))
}
