//! Checks bridges: what goes around connected parts is their outlines, opened where strips end, and the sides of the strips.
//!
//! The drawn outlines of the parts are known, and the path that goes around them. The path is divided into what lies on an outline and what
//! does not, without looking at how the planner made it. What lies on outlines has to cover each of them, up to one opening for each strip;
//! what does not are straight lines, two to a strip, side by side in the stated width, from one part to another, through waste.
//! That the beam follows the path is checked elsewhere (`coverage.rs`), and that it runs half a kerf beside it, too (`kerf.rs`).

use super::nesting::winding;
use super::violation::Violation;
use crate::geometry::{Aabb, BoxIndex, DVec2, Path, Segment, Union};
use crate::machine::{Bridges, PLANS_ALL_LEVERS, Profile};
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
    let least = bridges.clearance + machine.kerf_width - SAME;
    let ground = Ground {
        sheet,
        bridges,
        least,
        contours: BoxIndex::new(sheet.contours.iter().map(|c| c.drawn.as_ref().unwrap_or(&c.path).bounds())),
        index: BoxIndex::new(strips.iter().map(|s| box_of(s.sides.as_flattened()))),
        strips: &strips,
    };
    let named = named(sheet, plan);
    for (group, named) in sheet.bridged.iter().zip(named) {
        let at = group.outlines.first().and_then(|o| o.1.start()).unwrap_or_default();
        let outlines = BoxIndex::new(group.outlines.iter().map(|o| o.1.bounds()));
        if let Err(what) = around(sheet, group, &outlines, bridges) {
            say(group.contour, what, at);
        }
        for strip in &group.strips {
            if let Err((what, at)) = ground.stands(group, &outlines, strip) {
                say(strip.contours[0], what, at);
            }
        }
        if let Some(what) = named {
            say(group.contour, what, at);
        }
    }
}

/// For each group of connected parts, what is wrong where a cut around them does not name all of them, or another cut names one of them.
fn named(sheet: &Sheet, plan: &Plan) -> Vec<Option<&'static str>> {
    let mut faults = vec![None; sheet.bridged.len()];
    let mut of: Vec<Option<usize>> = vec![None; sheet.contours.len()];
    for (k, group) in sheet.bridged.iter().enumerate() {
        for (id, _) in &group.outlines {
            of.get_mut(*id as usize).into_iter().for_each(|of| *of = Some(k));
        }
    }
    for m in &plan.moves {
        let Move::Cut { contour, with, .. } = m else { continue };
        let Some(k) = of.get(*contour as usize).copied().flatten() else { continue };
        let group = &sheet.bridged[k];
        let others = || group.outlines.iter().map(|o| o.0).filter(|id| *id != group.contour);
        let fault = if *contour != group.contour {
            Some("is cut around parts, one of which is cut by itself as well")
        } else if with.iter().copied().eq(others()) {
            None
        } else {
            Some("is cut without naming the parts connected to it")
        };
        faults[k] = faults[k].or(fault);
    }
    faults
}

/// The place of an outline in the list of its group.
fn place(group: &Bridged, outline: u32) -> Option<usize> {
    group.outlines.binary_search_by_key(&outline, |o| o.0).ok()
}

fn box_of(points: &[DVec2]) -> Aabb {
    points.iter().fold(Aabb::EMPTY, |b, &p| b.with(p))
}

/// Whether the path around connected parts consists of their outlines, opened in one place for each end of a strip, and the sides of the strips.
fn around(
    sheet: &Sheet,
    group: &Bridged,
    outlines: &BoxIndex,
    bridges: &Bridges,
) -> Result<(), &'static str> {
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
        let on = |&k: &usize| PLACES.iter().all(|&f| is_on(&group.outlines[k].1, element.at(f)));
        match outlines.query(element.bounds().grown(SAME)).into_iter().find(on) {
            Some(k) => cut[k] += element.length(),
            None if matches!(element, Segment::Line(_)) => sides.push([element.start(), element.end()]),
            None => return Err("leaves the outlines of its parts in an arc"),
        }
    }
    let same = |a: &[DVec2; 2], b: &[DVec2; 2]| a[0].distance(b[0]) + a[1].distance(b[1]) <= 2.0 * SAME;
    let starts = BoxIndex::new(sides.iter().map(|s| Aabb::of(s[0])));
    let is_run = |wanted: &[DVec2; 2]| {
        let near = starts.query(Aabb::of(wanted[0]).grown(2.0 * SAME));
        near.into_iter().any(|k| same(&sides[k], wanted))
    };
    if sides.len() != 2 * group.strips.len() || !group.strips.iter().flat_map(|s| &s.sides).all(is_run) {
        return Err("leaves the outlines of its parts elsewhere than along its bridges");
    }
    // What is open lies between the two sides of each strip.
    let mut open = vec![0.0; group.outlines.len()];
    for strip in &group.strips {
        for (k, ends) in
            strip.contours.iter().filter_map(|&id| Some((place(group, id)?, opening(strip, id)?)))
        {
            open[k] += length_open(&group.outlines[k].1, ends);
        }
    }
    for (((_, outline), cut), open) in group.outlines.iter().zip(cut).zip(open) {
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
    // There is one strip fewer than parts, so that each has to join two pieces.
    let mut pieces = Union::new(group.outlines.len());
    group.strips.iter().all(|strip| {
        let places = strip.contours.map(|id| place(group, id).and_then(|k| u32::try_from(k).ok()));
        matches!(places, [Some(a), Some(b)] if pieces.join(a, b))
    })
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

/// What strips stand among.
struct Ground<'s> {
    sheet: &'s Sheet,
    bridges: &'s Bridges,
    /// Least distance of a strip from everything else, mm.
    least: f64,
    /// Where the contours are, as drawn.
    contours: BoxIndex,
    /// All strips of the sheet, and where they are.
    strips: &'s [Strip],
    index: BoxIndex,
}

impl Ground<'_> {
    /// Whether a strip is as wide and as long as the machine says, lies in waste, and keeps its distance from everything else.
    fn stands(
        &self,
        group: &Bridged,
        outlines: &BoxIndex,
        strip: &Strip,
    ) -> Result<(), (&'static str, DVec2)> {
        let Self { sheet, bridges, least, .. } = *self;
        let [[a, b], [c, d]] = strip.sides;
        let way = (b - a).normalize_or_zero();
        if [c - a, d - a, c - b, d - b].iter().any(|v| (way.perp_dot(*v) - bridges.width).abs() > SAME) {
            return Err(("has a bridge of another width than asked for", a));
        }
        if (d - c).dot(way) > 0.0 || a.distance(b).max(c.distance(d)) > bridges.reach + SAME {
            return Err(("has a bridge that is longer than asked for", a));
        }
        let outline = |id: u32| place(group, id).and_then(|k| group.outlines.get(k)).map(|o| &o.1);
        for (id, ends) in strip.contours.into_iter().zip([[a, d], [c, b]]) {
            if let Some(at) = ends.into_iter().find(|&p| !outline(id).is_some_and(|o| is_on(o, p))) {
                return Err(("has a bridge that does not end on an outline", at));
            }
        }
        let [one, other] = strip.contours;
        let own = || [one.min(other), one.max(other)].into_iter().filter_map(outline);
        for f in INSIDE {
            let [p, q] = [a.lerp(b, f), d.lerp(c, f)];
            if let Some(&at) = [p, q].iter().find(|&&p| own().any(|o| winding(o, p) != 0.0)) {
                return Err(("has a bridge in a part", at));
            }
        }
        let steps = (a.distance(b).max(c.distance(d)) / STEP).ceil().max(1.0);
        let places = (0..).map(f64::from).take_while(|k| *k <= steps).map(|k| k / steps);
        let along: Vec<DVec2> = places
            .flat_map(|f| {
                let [p, q] = [a.lerp(b, f), d.lerp(c, f)];
                [p, p.midpoint(q), q]
            })
            .collect();
        let room = box_of(&along).grown(least);
        let nearest = |path: &Path| {
            let around = path.bounds().grown(least);
            let near = along.iter().filter(|p| around.contains(**p));
            near.copied().find(|p| path.nearest(*p).is_some_and(|(_, at)| at.distance(*p) < least))
        };
        let others =
            self.contours.query(room).into_iter().map(|k| (&sheet.contours[k], k)).filter(|(c, k)| {
                let plain = c.operation != Operation::Ignore && !c.is_added() && c.next_pass.is_none();
                plain && *k != group.contour as usize
            });
        let others = others.map(|(c, _)| c.drawn.as_ref().unwrap_or(&c.path));
        let beside = outlines.query(room).into_iter().map(|k| &group.outlines[k]);
        let beside = beside.filter(|o| !strip.contours.contains(&o.0)).map(|o| &o.1);
        if let Some(at) = others.chain(beside).find_map(nearest) {
            return Err(("has a bridge too near to something else", at));
        }
        for other in self.index.query(room).into_iter().map(|k| &self.strips[k]).filter(|o| *o != strip) {
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
}

/// The corners of an outline.
fn corners(outline: &Path) -> Vec<DVec2> {
    let elements = outline.segments.iter();
    let next = outline.segments.iter().cycle().skip(1);
    let turns = elements.zip(next).filter(|(a, b)| a.tangent(1.0).distance(b.tangent(0.0)) > TURN);
    turns.map(|(a, _)| a.end()).collect()
}
