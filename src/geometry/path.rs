//! A chain of elements joined end to end: the shape of a contour, or of one entity of a drawing.
//!
//! A position on a path is its arc length from the start in mm, because the search moves entries continuously.

use super::aabb::Aabb;
use super::segment::{Arc, Segment};
use glam::DVec2;

/// A position nearer than this to an element's end is that end, mm. Sums of lengths differ in their last bits, and an
/// element shorter than this has no reliable direction.
const SNAP: f64 = 1e-9;

/// Elements joined end to end: `segments[i].end() == segments[i + 1].start()`, bit for bit. When `closed`, the last end
/// is also the first start.
#[derive(Clone, Debug, PartialEq, Default)]
pub struct Path {
    /// The elements in order of travel.
    pub segments: Vec<Segment>,
    /// Whether the path returns to its start.
    pub closed: bool,
}

impl Path {
    /// A path from elements.
    pub fn new(segments: Vec<Segment>, closed: bool) -> Self {
        Self { segments, closed }
    }

    /// The chain as a path, which is closed when it ends exactly where it starts. A single line back to its start is a
    /// point, not an outline.
    pub fn closed_if_ends_meet(segments: Vec<Segment>) -> Self {
        let path = Self::new(segments, false);
        let encloses =
            path.segments.len() > 1 || path.segments.first().is_some_and(|s| matches!(s, Segment::Arc(_)));
        let closed = encloses && path.start() == path.end();
        Self { closed, ..path }
    }

    /// First point; `None` for a path without elements.
    pub fn start(&self) -> Option<DVec2> {
        self.segments.first().map(Segment::start)
    }

    /// Last point; `None` for a path without elements.
    pub fn end(&self) -> Option<DVec2> {
        self.segments.last().map(Segment::end)
    }

    /// Length, mm.
    pub fn length(&self) -> f64 {
        self.segments.iter().map(Segment::length).sum()
    }

    /// Signed area of a closed path, mm2, counter-clockwise positive.
    pub fn area(&self) -> f64 {
        0.5 * self.segments.iter().map(Segment::doubled_area).sum::<f64>()
    }

    /// The smallest box around the path.
    pub fn bounds(&self) -> Aabb {
        self.segments.iter().fold(Aabb::EMPTY, |b, s| b.union(s.bounds()))
    }

    /// The same path in the opposite direction.
    pub fn reversed(&self) -> Self {
        Self { segments: self.segments.iter().rev().map(Segment::reversed).collect(), closed: self.closed }
    }

    /// The largest distance between one element's end and the next one's start, mm; 0 when joined bit for bit.
    pub fn largest_gap(&self) -> f64 {
        let inner = self.segments.windows(2).map(|w| w[0].end().distance(w[1].start()));
        let last = match (self.closed, self.start(), self.end()) {
            (true, Some(a), Some(b)) => a.distance(b),
            _ => 0.0,
        };
        inner.fold(last, f64::max)
    }

    /// The point `s` mm along the path; `s` is clamped to its length.
    pub fn at(&self, s: f64) -> Option<DVec2> {
        let (i, f) = self.locate(s)?;
        self.segments.get(i).map(|g| g.at(f))
    }

    /// The place nearest to a point: its arc length, mm, and the point there; `None` for a path without elements.
    pub fn nearest(&self, p: DVec2) -> Option<(f64, DVec2)> {
        let mut before = 0.0;
        let mut best: Option<(f64, f64, DVec2)> = None;
        for s in &self.segments {
            let (fraction, distance2) = s.nearest(p);
            if best.is_none_or(|b| distance2 < b.0) {
                best = Some((distance2, before + fraction * s.length(), s.at(fraction)));
            }
            before += s.length();
        }
        best.map(|b| (b.1, b.2))
    }

    /// Index of the element `s` mm along the path, and the fraction along it, which is 0 within 1e-9 mm of the
    /// element's start.
    pub fn locate(&self, s: f64) -> Option<(usize, f64)> {
        // The lengths are summed in the same order as by callers that compute a corner's arc length, so the corner is
        // met bit for bit.
        let mut before = 0.0;
        for (i, g) in self.segments.iter().enumerate() {
            let len = g.length();
            let rest = s.max(0.0) - before;
            if rest <= SNAP && len > 0.0 {
                return Some((i, 0.0));
            }
            if rest < len - SNAP {
                return Some((i, rest / len));
            }
            before += len;
        }
        Some((self.segments.len().checked_sub(1)?, 1.0))
    }

    /// The elements from `from` to `to` mm along a closed path, in its own direction. They run across the path's end
    /// where `to` lies before `from`.
    pub fn between(&self, from: f64, to: f64) -> Vec<Segment> {
        let (Some((i, f)), Some((j, g))) = (self.locate(from), self.locate(to)) else { return Vec::new() };
        if i == j && f < g {
            return vec![self.segments[i].piece(f, g)];
        }
        let mut out = Vec::new();
        if f < 1.0 {
            out.push(self.segments[i].piece(f, 1.0));
        }
        if i < j {
            out.extend(&self.segments[i + 1..j]);
        } else {
            out.extend(self.segments[i + 1..].iter().chain(&self.segments[..j]));
        }
        if g > 0.0 {
            out.push(self.segments[j].piece(0.0, g));
        }
        out
    }

    /// A closed path with its start moved `s` mm along it, in the same direction; an open path is returned unchanged. A
    /// circle remains one arc.
    pub fn starting_at(&self, s: f64) -> Self {
        let Some((i, f)) = self.locate(s).filter(|_| self.closed) else { return self.clone() };
        let cut = self.segments[i];
        if let (Segment::Arc(a), [_]) = (cut, self.segments.as_slice())
            && a.is_circle()
        {
            let start = cut.at(f);
            return Self::new(vec![Segment::Arc(Arc { start, end: start, ..a })], true);
        }
        let inside = f > 0.0 && f < 1.0;
        let mut out = Vec::with_capacity(self.segments.len() + 1);
        if f < 1.0 {
            out.push(if inside { cut.piece(f, 1.0) } else { cut });
        }
        out.extend(self.segments[i + 1..].iter().chain(&self.segments[..i]).copied());
        if f > 0.0 {
            out.push(if inside { cut.piece(0.0, f) } else { cut });
        }
        Self::new(out, true)
    }
}

/// Sets the ends of a chain to those its neighbours expect; they differ only by rounding.
pub(crate) fn pin_ends(chain: &mut [Segment], start: DVec2, end: DVec2) {
    match chain.first_mut() {
        Some(Segment::Line(l)) => l.start = start,
        Some(Segment::Arc(a)) => a.start = start,
        None => {}
    }
    match chain.last_mut() {
        Some(Segment::Line(l)) => l.end = end,
        Some(Segment::Arc(a)) => a.end = end,
        None => {}
    }
}
