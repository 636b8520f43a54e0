//! Checks bridges: what goes around connected parts is their outlines, opened where strips end, and the sides of the strips.
//!
//! The drawn outlines of the parts are known, and the path that goes around them. The path is divided into what lies on an outline and what
//! does not, without looking at how the planner made it. What lies on outlines has to cover each of them, up to one opening for each strip;
//! what does not are straight lines, two to a strip, side by side in the stated width, from one part to another, through waste.
//! That the beam follows the path is checked elsewhere (`coverage.rs`), and that it runs half a kerf beside it, too (`kerf.rs`).

use super::nesting::winding;
use super::violation::Violation;
use crate::geometry::{DVec2, Path, Segment};
use crate::machine::{Bridges, PLANS_ALL_LEVERS, Profile};
use crate::order::sort_by;
use crate::plan::model::{Move, Plan};
use crate::sheet::{Bridged, Operation, Sheet, Strip};

/// Lengths and places agree within this, mm: sums of coordinates.
const SAME: f64 = 1e-6;
/// Distances of strips from everything else are measured in steps of this length along them, mm.
const STEP: f64 = 0.05;
/// Fractions of the length of a side at which it is in no part. Between the sides an arc may bulge into a strip.
const INSIDE: [f64; 4] = [0.05, 0.35, 0.65, 0.95];
/// Directions that differ by less make no corner, rad.
const TURN: f64 = 1e-3;
/// Places on each element at which it is compared with the outlines.
const PLACES: [f64; 5] = [0.0, 0.21, 0.5, 0.83, 1.0];

/// Checks the parts that a sheet says are connected, and what the plan says of them.
pub(super) fn check(sheet: &Sheet, machine: &Profile, plan: &Plan, found: &mut Vec<Violation>) {
    if !PLANS_ALL_LEVERS || (sheet.bridged.is_empty() && plan.bridges.is_empty() && plan.summary.bridges == 0)
    {
        return;
    }
    let strips: Vec<Strip> = sheet.bridged.iter().flat_map(|b| &b.strips).copied().collect();
    let mut say = |contour: u32, what, at| found.push(Violation::Bridge { contour, what, at });
    let first = strips.first().or(plan.bridges.first()).map(|s| (s.contours[0], s.sides[0][0]));
    let (contour, at) = first.unwrap_or_default();
    let Some(bridges) = &machine.levers.bridges else {
        return say(contour, "is connected, which the machine does not ask for", at);
    };
    if plan.bridges != strips || plan.summary.bridges as usize != strips.len() {
        say(contour, "has other bridges in the plan than on the sheet", at);
    }
    for group in sheet.bridged.iter() {
        let at = group.outlines.first().and_then(|o| o.1.start()).unwrap_or_default();
        if let Err(what) = around(sheet, group, bridges) {
            say(group.contour, what, at);
        }
        for strip in &group.strips {
            if let Err((what, at)) = stands(sheet, machine, bridges, group, strip) {
                say(strip.contours[0], what, at);
            }
        }
        if let Some(what) = named(plan, group) {
            say(group.contour, what, at);
        }
    }
}

/// Whether every cut around connected parts names all of them, and no other cut names one of them.
fn named(plan: &Plan, group: &Bridged) -> Option<&'static str> {
    let mut others: Vec<u32> = group.outlines.iter().map(|o| o.0).filter(|id| *id != group.contour).collect();
    sort_by(&mut others, |&id| [id.into(), 0, 0]);
    plan.moves.iter().find_map(|m| {
        let Move::Cut { contour, with, .. } = m else { return None };
        if *contour == group.contour {
            return (*with != others).then_some("is cut without naming the parts connected to it");
        }
        others.contains(contour).then_some("is cut around parts, one of which is cut by itself as well")
    })
}

/// Whether the path around connected parts consists of their outlines, opened in one place for each end of a strip, and the sides of the strips.
fn around(sheet: &Sheet, group: &Bridged, bridges: &Bridges) -> Result<(), &'static str> {
    let Some(contour) = sheet.contours.get(group.contour as usize) else { return Err("is unknown") };
    let path = contour.drawn.as_ref().unwrap_or(&contour.path);
    if group.strips.len() + 1 != group.outlines.len()
        || bridges.most.is_some_and(|most| group.outlines.len() as f64 > most)
    {
        return Err("goes around another number of parts than its bridges connect");
    }
    let elsewhere = |(id, outline): &&(u32, Path)| {
        let known = sheet.contours.get(*id as usize);
        let as_drawn = known.is_some_and(|c| c.path == *outline && c.operation == Operation::Ignore);
        known.is_none_or(|c| c.bridged != Some(group.contour)) || *id != group.contour && !as_drawn
    };
    if group.outlines.iter().any(|o| elsewhere(&o)) {
        return Err("goes around a part that is not left to it");
    }
    if !is_tree(group) {
        return Err("has bridges that leave a part unconnected");
    }
    if path.largest_gap() > SAME || !path.closed {
        return Err("goes around parts in a path that is not closed");
    }
    // Length cut of each outline, and the sides.
    let mut cut = vec![0.0; group.outlines.len()];
    let mut sides: Vec<[DVec2; 2]> = Vec::new();
    for element in path.segments.iter().filter(|s| s.length() > SAME) {
        let on = |outline: &Path| PLACES.iter().all(|&f| is_on(outline, element.at(f)));
        match group.outlines.iter().position(|(_, outline)| on(outline)) {
            Some(k) => cut[k] += element.length(),
            None if matches!(element, Segment::Line(_)) => sides.push([element.start(), element.end()]),
            None => return Err("leaves the outlines of its parts in an arc"),
        }
    }
    let same = |a: &[DVec2; 2], b: &[DVec2; 2]| a[0].distance(b[0]) + a[1].distance(b[1]) <= 2.0 * SAME;
    let wanted: Vec<[DVec2; 2]> = group.strips.iter().flat_map(|s| s.sides).collect();
    if sides.len() != wanted.len() || !wanted.iter().all(|w| sides.iter().any(|s| same(s, w))) {
        return Err("leaves the outlines of its parts elsewhere than along its bridges");
    }
    for ((id, outline), cut) in group.outlines.iter().zip(cut) {
        // What is open lies between the two sides of each strip.
        let open: f64 =
            group.strips.iter().filter_map(|s| opening(s, *id)).map(|ends| length_open(outline, ends)).sum();
        let missing = outline.length() - open - cut;
        if missing > SAME * (2.0 + outline.length()) {
            return Err("leaves more of an outline uncut than where bridges end");
        }
        if missing < -SAME * (2.0 + outline.length()) {
            return Err("cuts an outline where a bridge ends on it");
        }
    }
    Ok(())
}

/// Whether the strips connect all parts to one piece.
fn is_tree(group: &Bridged) -> bool {
    let mut reached: Vec<u32> = group.outlines.first().map(|o| o.0).into_iter().collect();
    for _ in &group.strips {
        for [a, b] in group.strips.iter().map(|s| s.contours) {
            match (reached.contains(&a), reached.contains(&b)) {
                (true, false) => reached.push(b),
                (false, true) => reached.push(a),
                _ => {}
            }
        }
    }
    group.outlines.iter().all(|(id, _)| reached.contains(id))
}

/// Where a strip opens an outline: from and to, in the direction of the outline.
pub(super) fn opening(strip: &Strip, outline: u32) -> Option<[DVec2; 2]> {
    let [[a, b], [c, d]] = strip.sides;
    match strip.contours {
        [one, _] if one == outline => Some([a, d]),
        [_, other] if other == outline => Some([c, b]),
        _ => None,
    }
}

/// Length of an outline from one place on it to another, in its direction, mm.
fn length_open(outline: &Path, [from, to]: [DVec2; 2]) -> f64 {
    let along = |p: DVec2| outline.nearest(p).map_or(0.0, |n| n.0);
    let length = along(to) - along(from);
    if length < 0.0 { length + outline.length() } else { length }
}

fn is_on(outline: &Path, point: DVec2) -> bool {
    outline.nearest(point).is_some_and(|(_, at)| at.distance(point) <= SAME)
}

/// Whether a strip is as wide and as long as the machine says, lies in waste, and keeps its distance from everything else.
fn stands(
    sheet: &Sheet,
    machine: &Profile,
    bridges: &Bridges,
    group: &Bridged,
    strip: &Strip,
) -> Result<(), (&'static str, DVec2)> {
    let [[a, b], [c, d]] = strip.sides;
    let way = (b - a).normalize_or_zero();
    if [c - a, d - a, c - b, d - b].iter().any(|v| (way.perp_dot(*v) - bridges.width).abs() > SAME) {
        return Err(("has a bridge of another width than asked for", a));
    }
    if (d - c).dot(way) > 0.0 || a.distance(b).max(c.distance(d)) > bridges.reach + SAME {
        return Err(("has a bridge that is longer than asked for", a));
    }
    for (id, ends) in strip.contours.iter().zip([[a, d], [c, b]]) {
        let outline = group.outlines.iter().find(|o| o.0 == *id).map(|o| &o.1);
        if let Some(at) = ends.into_iter().find(|&p| !outline.is_some_and(|o| is_on(o, p))) {
            return Err(("has a bridge that does not end on an outline", at));
        }
    }
    let own = || group.outlines.iter().filter(|o| strip.contours.contains(&o.0)).map(|o| &o.1);
    for f in INSIDE {
        let [p, q] = [a.lerp(b, f), d.lerp(c, f)];
        if let Some(&at) = [p, q].iter().find(|&&p| own().any(|o| winding(o, p) != 0.0)) {
            return Err(("has a bridge in a part", at));
        }
    }
    let least = bridges.clearance + machine.kerf_width - SAME;
    let steps = (a.distance(b).max(c.distance(d)) / STEP).ceil().max(1.0);
    let places = (0..).map(f64::from).take_while(|k| *k <= steps).map(|k| k / steps);
    let along: Vec<DVec2> = places
        .flat_map(|f| {
            let [p, q] = [a.lerp(b, f), d.lerp(c, f)];
            [p, p.midpoint(q), q]
        })
        .collect();
    let nearest = |path: &Path| {
        let around = path.bounds().grown(least);
        let near = along.iter().filter(|p| around.contains(**p));
        near.copied().find(|p| path.nearest(*p).is_some_and(|(_, at)| at.distance(*p) < least))
    };
    let others = sheet.contours.iter().zip(0..).filter(|(c, id)| {
        c.operation != Operation::Ignore && !c.is_added() && c.next_pass.is_none() && *id != group.contour
    });
    let others = others.map(|(c, _)| c.drawn.as_ref().unwrap_or(&c.path));
    let beside = group.outlines.iter().filter(|o| !strip.contours.contains(&o.0)).map(|o| &o.1);
    if let Some(at) = others.chain(beside).find_map(nearest) {
        return Err(("has a bridge too near to something else", at));
    }
    let strips = sheet.bridged.iter().flat_map(|b| &b.strips).filter(|other| *other != strip);
    for other in strips {
        let sides = other.sides.map(|[from, to]| Segment::line(from, to));
        if let Some(at) = along.iter().find(|p| sides.iter().any(|s| s.nearest(**p).1.sqrt() < least)) {
            return Err(("has two bridges too near to each other", *at));
        }
    }
    // Only the sides count here: the middle of a wide strip is nearer to nothing.
    let sides = strip.sides.map(|[from, to]| Segment::line(from, to));
    let corners = own().flat_map(corners);
    if let Some(at) = corners.into_iter().find(|p| sides.iter().any(|s| s.nearest(*p).1.sqrt() < least)) {
        return Err(("has a bridge too near to a corner", at));
    }
    Ok(())
}

/// The corners of an outline.
fn corners(outline: &Path) -> Vec<DVec2> {
    let elements = outline.segments.iter();
    let next = outline.segments.iter().cycle().skip(1);
    let turns = elements.zip(next).filter(|(a, b)| a.tangent(1.0).distance(b.tangent(0.0)) > TURN);
    turns.map(|(a, _)| a.end()).collect()
}
