//! Crossings: contours that cross themselves or each other.
//!
//! Elements whose boxes meet are intersected. If one passes through another between their ends, they cross. If they
//! meet at an end, the courses of both contours shortly before and after the place decide: they cross when the arms of
//! each lie on different sides of the other. An end that stops there, and contours that touch and separate again, do
//! not cross. Crossings of cuts are reported. Marks may cross anything, but the nesting needs to know which cuts they
//! cross.

use super::findings::{count, plural};
use super::model::{Contour, Operation};
use super::source::Source;
use crate::finding::{Code, Finding, Findings, Severity};
use crate::geometry::{Aabb, BoxIndex, DVec2, Path, Segment, intersect};
use crate::order::sort_by;
use rustc_hash::FxHashMap;

/// Number of boxes visited per element on average, and for a small drawing in total. A sheet needs two or three;
/// thousands of circles around each other need thousands, and a finding then reports that not all were checked.
const BOXES_PER_ELEMENT: usize = 200;
const MIN_BOXES: usize = 2_000_000;
/// Number of pairs intersected per element on average, and for a small drawing in total.
const PAIRS_PER_ELEMENT: usize = 8;
const MIN_PAIRS: usize = 200_000;
/// Largest number of places recorded for a pair of contours.
const MAX_PLACES: usize = 100;
/// Distance before and after a meeting at which the courses are compared, in tolerances. It is large compared with
/// rounding and short elements.
const ARM_LENGTH: f64 = 10.0;
/// Sine of the angle below which two arms have the same direction, so that they touch and do not cross.
const SAME_DIRECTION: f64 = 0.02;

/// Index of an element of a contour.
#[derive(Clone, Copy)]
struct ElementRef {
    contour: u32,
    element: usize,
}

/// Finds and reports crossings, and marks contours that cross themselves. Returns the pairs of different contours that
/// cross, of which at least one is a cut. Elements within `tolerance` mm of each other only touch.
pub(super) fn find(
    source: Source,
    contours: &mut [Contour],
    tolerance: f64,
    findings: &mut Findings,
) -> Vec<(u32, u32)> {
    let (places, boxes) = elements(contours);
    let index = BoxIndex::new(boxes.iter().copied());
    let mut look = (BOXES_PER_ELEMENT * places.len()).max(MIN_BOXES);
    let mut work = (PAIRS_PER_ELEMENT * places.len()).max(MIN_PAIRS);
    let mut found = PairPlaces::default();
    for (i, (&a, &around)) in places.iter().zip(&boxes).enumerate() {
        index.visit(around, |j| {
            look = look.saturating_sub(1);
            if j > i && may_meet(contours, (a, &around), (places[j], &boxes[j]), tolerance) {
                work = work.saturating_sub(1);
                meetings(contours, a, places[j], tolerance, &mut found);
            }
            look > 0 && work > 0
        });
    }
    sort_by(&mut found.pairs, |((a, b), _)| [(*a).into(), (*b).into(), 0]);
    for &((a, b), ref at) in &found.pairs {
        if is_cut(&contours[a as usize]) && is_cut(&contours[b as usize]) {
            findings.push(finding(source, contours, (a, b), at));
        }
        if a == b {
            contours[a as usize].self_crossing = true;
        }
    }
    if look == 0 || work == 0 {
        let message = "So many lines lie over each other that only some of them were checked for crossings.";
        findings.push(Finding::new(Code::NotAllChecked, Severity::Info, message));
    }
    found.pairs.into_iter().map(|(pair, _)| pair).filter(|(a, b)| a != b).collect()
}

fn is_cut(c: &Contour) -> bool {
    c.operation == Operation::Cut
}

fn elements(contours: &[Contour]) -> (Vec<ElementRef>, Vec<Aabb>) {
    let mut places = Vec::new();
    let mut boxes = Vec::new();
    for (contour, c) in (0_u32..).zip(contours).filter(|(_, c)| c.is_processed()) {
        for (element, s) in c.path.segments.iter().enumerate() {
            places.push(ElementRef { contour, element });
            boxes.push(s.bounds());
        }
    }
    (places, boxes)
}

fn segment(contours: &[Contour], p: ElementRef) -> &Segment {
    &contours[p.contour as usize].path.segments[p.element]
}

/// Whether two elements whose boxes meet need to be intersected.
fn may_meet(contours: &[Contour], a: (ElementRef, &Aabb), b: (ElementRef, &Aabb), tolerance: f64) -> bool {
    if [a.0, b.0].iter().all(|p| !is_cut(&contours[p.contour as usize])) {
        return false;
    }
    let (first, second) = (segment(contours, a.0), segment(contours, b.0));
    let lines = matches!((first, second), (Segment::Line(_), Segment::Line(_)));
    let path = &contours[a.0.contour as usize].path;
    let neighbours = a.0.contour == b.0.contour && are_neighbours(path, a.0.element, b.0.element);
    // Two consecutive lines meet only in their common corner.
    let only_corner = neighbours && lines;
    !(only_corner || misses(first, b.1, tolerance) || misses(second, a.1, tolerance))
}

fn are_neighbours(path: &Path, i: usize, j: usize) -> bool {
    let (low, high) = (i.min(j), i.max(j));
    high - low == 1 || (path.closed && low == 0 && high + 1 == path.segments.len())
}

/// Whether the line or circle of an element passes a box at a distance.
fn misses(s: &Segment, b: &Aabb, tolerance: f64) -> bool {
    match s {
        Segment::Line(l) => {
            let d = l.end - l.start;
            let side = |p: DVec2| d.perp_dot(p - l.start);
            let corners =
                [b.min, DVec2::new(b.max.x, b.min.y), b.max, DVec2::new(b.min.x, b.max.y)].map(side);
            let off = tolerance * d.length();
            corners.iter().all(|&c| c > off) || corners.iter().all(|&c| c < -off)
        }
        Segment::Arc(a) => {
            let nearest = a.center.distance(a.center.clamp(b.min, b.max));
            let far = (a.center - b.min).abs().max((a.center - b.max).abs()).length();
            nearest > a.radius() + tolerance || far < a.radius() - tolerance
        }
    }
}

/// The places where pairs of contours cross.
#[derive(Default)]
struct PairPlaces {
    pairs: Vec<((u32, u32), Vec<DVec2>)>,
    index: FxHashMap<(i64, i64), u32>,
}

impl PairPlaces {
    fn of(&mut self, pair: (u32, u32)) -> &mut Vec<DVec2> {
        let next = u32::try_from(self.pairs.len()).unwrap_or(u32::MAX);
        let at = *self.index.entry((pair.0.into(), pair.1.into())).or_insert(next);
        if at == next {
            self.pairs.push((pair, Vec::new()));
        }
        &mut self.pairs[at as usize].1
    }
}

/// Records the crossings of two elements.
fn meetings(contours: &[Contour], a: ElementRef, b: ElementRef, tolerance: f64, found: &mut PairPlaces) {
    for m in intersect(segment(contours, a), segment(contours, b), tolerance).points {
        if !(m.crossing || cross_at_corner(contours, (a, m.a), (b, m.b), tolerance)) {
            continue;
        }
        let pair = (a.contour.min(b.contour), a.contour.max(b.contour));
        let at = found.of(pair);
        // Up to four pairs of elements meet at a corner, so a place may be found repeatedly.
        if at.len() < MAX_PLACES && at.iter().all(|p| p.distance(m.point) > ARM_LENGTH * tolerance) {
            at.push(m.point);
        }
    }
}

/// Whether two contours cross at a place where one of them has a corner.
fn cross_at_corner(contours: &[Contour], a: (ElementRef, f64), b: (ElementRef, f64), tolerance: f64) -> bool {
    let arms = |(place, f): (ElementRef, f64)| {
        let path = &contours[place.contour as usize].path;
        let at = path.segments[place.element].at(f);
        let along = |forward| {
            beyond(path, place.element, f, ARM_LENGTH * tolerance, forward)
                .map(|p| (p - at).normalize_or_zero())
        };
        Some((along(false)?, along(true)?))
    };
    let (Some((a0, a1)), Some((b0, b1))) = (arms(a), arms(b)) else { return false };
    let apart = |u: DVec2, v: DVec2| u.perp_dot(v).abs() > SAME_DIRECTION || u.dot(v) < 0.0;
    let distinct = [a0, a1].iter().all(|&u| [b0, b1].iter().all(|&v| apart(u, v)));
    distinct && between(a0, b0, a1) != between(a0, b1, a1)
}

/// Whether `v` comes before `to` when turning counter-clockwise from `from`.
fn between(from: DVec2, v: DVec2, to: DVec2) -> bool {
    let left = from.perp_dot(to) >= 0.0;
    if left {
        from.perp_dot(v) >= 0.0 && v.perp_dot(to) >= 0.0
    } else {
        !(to.perp_dot(v) >= 0.0 && v.perp_dot(from) >= 0.0)
    }
}

/// The point `distance` mm along a path from fraction `f` of an element, forward or backward; `None` when the path ends
/// before.
fn beyond(path: &Path, element: usize, f: f64, distance: f64, forward: bool) -> Option<DVec2> {
    let n = path.segments.len();
    let mut rest = distance;
    let mut i = element;
    let mut from = if forward { f } else { 1.0 - f };
    for _ in 0..=n {
        let s = path.segments.get(i)?;
        let length = s.length();
        let left = length * (1.0 - from);
        if rest < left {
            let g = from + rest / length;
            return Some(s.at(if forward { g } else { 1.0 - g }));
        }
        rest -= left;
        from = 0.0;
        i = match (forward, i) {
            (true, i) if i + 1 < n => i + 1,
            (true, _) if path.closed => 0,
            (false, i) if i > 0 => i - 1,
            (false, _) if path.closed => n - 1,
            _ => return None,
        };
    }
    None
}

fn finding(source: Source, contours: &[Contour], (a, b): (u32, u32), at: &[DVec2]) -> Finding {
    let first = contours[a as usize].first_shape;
    let places = plural(at.len(), "place", "places");
    let (code, message) = if a == b {
        let text = format!("This contour crosses itself in {places}: what lies inside it is in doubt.");
        (Code::SelfCrossing, text)
    } else {
        let other = contours[b as usize].first_shape;
        let handle = source.handle(other);
        let other = handle.map_or_else(String::new, |h| format!(", the other one (handle {h})"));
        let text = format!("Two contours cross in {places}{other}: both are cut as drawn.");
        (Code::Crossing, text)
    };
    source.finding(first, code, Severity::Warning, message, at.first().copied()).times(count(at.len()))
}
