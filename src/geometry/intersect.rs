//! Where two segments meet: crossings, touches, and stretches they share.
//!
//! The candidates are the crossings of the two lines or circles, and the place nearest to each end of either segment. A
//! candidate farther than the tolerance from either segment is dropped. Candidates closer to each other than the
//! tolerance are merged, preferring ends: an end that falls short by less than the tolerance still meets the other
//! segment. Between neighbouring candidates the segments either run within the tolerance of each other (an overlap) or
//! not. The distance between two lines, a line and a circle, or two circles has at most one maximum there, so a few
//! test places decide.

use super::segment::{Arc, Line, Segment};
use crate::order::{real, sort_by};
use glam::DVec2;

/// A place where two segments meet.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Meeting {
    /// Fraction of the first segment's length, in [0, 1].
    pub a: f64,
    /// Fraction of the second segment's length, in [0, 1].
    pub b: f64,
    /// The place on the first segment, mm.
    pub point: DVec2,
    /// Whether the segments cross here; `false` where one only touches the other, with an end or tangentially.
    pub crossing: bool,
}

/// A stretch that two segments share within the tolerance.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Overlap {
    /// Start and end on the first segment, as ascending fractions.
    pub a: [f64; 2],
    /// The same places on the second segment, as fractions; they descend when it runs in the opposite direction.
    pub b: [f64; 2],
}

/// All places and stretches where two segments meet.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Intersections {
    /// Single places in order along the first segment; none lies in or at the end of an overlap.
    pub points: Vec<Meeting>,
    /// Shared stretches longer than the tolerance, in order along the first segment.
    pub overlaps: Vec<Overlap>,
}

impl Intersections {
    /// Whether the segments do not meet.
    pub fn is_empty(&self) -> bool {
        self.points.is_empty() && self.overlaps.is_empty()
    }
}

/// Finds where segments `a` and `b` come within `tolerance` mm of each other. The start of a full circle is not an end.
pub fn intersect(a: &Segment, b: &Segment, tolerance: f64) -> Intersections {
    let mut out = Intersections::default();
    if !a.bounds().grown(tolerance).overlaps(&b.bounds()) {
        return out;
    }
    let mut meetings = candidates(a, b, tolerance);
    thin(&mut meetings, a, b, tolerance);
    out.overlaps = overlaps(&meetings, a, b, tolerance);
    let shared = |f: f64| out.overlaps.iter().any(|o| o.a[0] <= f && f <= o.a[1]);
    let seam = |f: f64| is_circle(a) && (f <= 0.0 && shared(1.0) || f >= 1.0 && shared(0.0));
    out.points = meetings.into_iter().filter(|m| !shared(m.a) && !seam(m.a)).collect();
    out
}

fn is_circle(s: &Segment) -> bool {
    matches!(s, Segment::Arc(a) if a.is_circle())
}

/// Whether fraction `f` is an end of the segment. A circle has no ends.
fn is_end(s: &Segment, f: f64) -> bool {
    (f <= 0.0 || f >= 1.0) && !is_circle(s)
}

/// Ends near the other segment, then crossings, all within the tolerance of both segments.
fn candidates(a: &Segment, b: &Segment, tolerance: f64) -> Vec<Meeting> {
    let mut out = Vec::new();
    let near = tolerance * tolerance;
    if !is_circle(a) {
        for (f, end) in [(0.0, a.start()), (1.0, a.end())] {
            let (g, d) = b.nearest(end);
            if d <= near {
                out.push(Meeting { a: f, b: g, point: end, crossing: false });
            }
        }
    }
    if !is_circle(b) {
        for (g, end) in [(0.0, b.start()), (1.0, b.end())] {
            let (f, d) = a.nearest(end);
            if d <= near {
                out.push(Meeting { a: f, b: g, point: a.at(f), crossing: false });
            }
        }
    }
    let mut cross = |point: DVec2, crossing: bool| {
        let ((f, da), (g, db)) = (a.nearest(point), b.nearest(point));
        if da <= near && db <= near {
            let crossing = crossing && !is_end(a, f) && !is_end(b, g);
            out.push(Meeting { a: f, b: g, point: a.at(f), crossing });
        }
    };
    match (a, b) {
        (Segment::Line(a), Segment::Line(b)) => line_line(a, b, &mut cross),
        (Segment::Line(l), Segment::Arc(c)) | (Segment::Arc(c), Segment::Line(l)) => {
            line_circle(l, c, &mut cross)
        }
        (Segment::Arc(a), Segment::Arc(b)) => circle_circle(a, b, &mut cross),
    }
    out
}

fn line_line(a: &Line, b: &Line, cross: &mut impl FnMut(DVec2, bool)) {
    let (u, v) = (a.end - a.start, b.end - b.start);
    let det = u.perp_dot(v);
    let t = (b.start - a.start).perp_dot(v) / det;
    if t.is_finite() {
        cross(a.start + u * t, true);
    }
}

/// Reports both crossings and, for a tangent within the tolerance, the place where the line is closest.
fn line_circle(l: &Line, c: &Arc, cross: &mut impl FnMut(DVec2, bool)) {
    let Some(u) = (l.end - l.start).try_normalize() else { return };
    let foot = l.start + u * (c.center - l.start).dot(u);
    let (radius, height2) = (c.radius(), foot.distance_squared(c.center));
    let half2 = radius * radius - height2;
    if half2 > 0.0 {
        let half = u * half2.sqrt();
        cross(foot - half, true);
        cross(foot + half, true);
    }
    cross(foot, false);
}

/// Reports both crossings and, for circles that touch within the tolerance, the places where they may be closest.
fn circle_circle(a: &Arc, b: &Arc, cross: &mut impl FnMut(DVec2, bool)) {
    let between = b.center - a.center;
    let (ra, rb, d2) = (a.radius(), b.radius(), between.length_squared());
    let Some(u) = between.try_normalize() else { return };
    let d = d2.sqrt();
    // Distance from the first centre to the line through the two crossings.
    let along = (d2 + ra * ra - rb * rb) / (2.0 * d);
    let half2 = ra * ra - along * along;
    if half2 > 0.0 {
        let (middle, half) = (a.center + u * along, u.perp() * half2.sqrt());
        cross(middle + half, true);
        cross(middle - half, true);
    }
    // The circles touch from outside, or from inside with the smaller circle on either side.
    cross(a.center + u * ra, false);
    cross(a.center - u * ra, false);
}

/// Sorts meetings along `a` and keeps one of those at the same place within the tolerance.
fn thin(meetings: &mut Vec<Meeting>, a: &Segment, b: &Segment, tolerance: f64) {
    // At the same place an end is preferred to a crossing, and a crossing to a touch.
    let rank = |m: &Meeting| {
        4 * u64::from(!is_end(a, m.a)) + 2 * u64::from(!is_end(b, m.b)) + u64::from(!m.crossing)
    };
    sort_by(meetings, |m| [rank(m), real(m.a), real(m.b)]);
    let apart = |s: &Segment, f: f64, g: f64| {
        let d = (f - g).abs();
        s.length() * if is_circle(s) { d.min(1.0 - d) } else { d }
    };
    let mut kept: Vec<Meeting> = Vec::with_capacity(meetings.len());
    for m in meetings.iter() {
        let same = |k: &Meeting| apart(a, k.a, m.a).max(apart(b, k.b, m.b)) <= 2.0 * tolerance;
        if !kept.iter().any(same) {
            kept.push(*m);
        }
    }
    sort_by(&mut kept, |m| [real(m.a), real(m.b), 0]);
    *meetings = kept;
}

/// Stretches between neighbouring meetings along which the segments stay within the tolerance.
fn overlaps(meetings: &[Meeting], a: &Segment, b: &Segment, tolerance: f64) -> Vec<Overlap> {
    /// Where a stretch is tested: in its middle and near its ends, as fractions.
    const PLACES: [f64; 5] = [0.5, 0.25, 0.75, 0.1, 0.9];
    let near = tolerance * tolerance;
    let mut stations: Vec<f64> = meetings.iter().map(|m| m.a).collect();
    // A circle has stretches before its first and after its last meeting, and a break where the other circle starts.
    stations.extend([0.0, 1.0]);
    if is_circle(b) {
        stations.push(a.nearest(b.start()).0);
    }
    sort_by(&mut stations, |&s| [real(s), 0, 0]);
    let mut out: Vec<Overlap> = Vec::new();
    for w in stations.windows(2) {
        let place = |f: f64| w[0] + (w[1] - w[0]) * f;
        let long = (w[1] - w[0]) * a.length() > tolerance;
        if !(long && PLACES.iter().all(|f| b.nearest(a.at(place(*f))).1 <= near)) {
            continue;
        }
        // The start of a circle is also its end; choose the fraction on this stretch's side.
        let on_b = |f: f64, beside: f64| {
            let (g, side) = (b.nearest(a.at(f)).0, b.nearest(a.at(place(beside))).0);
            if is_circle(b) && (g - side).abs() > 0.5 { 1.0 - g.round() } else { g }
        };
        let next = Overlap { a: [w[0], w[1]], b: [on_b(w[0], 0.1), on_b(w[1], 0.9)] };
        match out.last_mut() {
            Some(last)
                if (next.a[0] - last.a[1]) * a.length() <= tolerance
                    && (last.b[1] - next.b[0]).abs() < 0.5 =>
            {
                last.a[1] = next.a[1];
                last.b[1] = next.b[1];
            }
            _ => out.push(next),
        }
    }
    out
}
