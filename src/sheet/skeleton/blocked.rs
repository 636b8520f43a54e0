//! Where a straight line across the sheet is nearer to something than it may be.
//!
//! All lines run in the direction of x or y. On such a line, the places within `reach` of an element are found exactly: those
//! near its ends lie in a disk, those beside a straight element in a rectangle, and those beside an arc in a part of a ring.

use super::super::model::{Contour, Sheet};
use crate::geometry::{Aabb, Arc, DVec2, Path, Segment, winding};

/// A line across the sheet.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Across {
    /// Whether it runs in the direction of y.
    pub(super) upright: bool,
    /// Its x if it is upright, otherwise its y, mm.
    pub(super) at: f64,
}

/// Places on a line, from the first to the last, mm.
pub(super) type Interval = (f64, f64);

impl Across {
    /// Along the line, and across it.
    fn turned(self, p: DVec2) -> DVec2 {
        if self.upright { DVec2::new(p.y, p.x) } else { p }
    }

    /// The point at a place on the line.
    pub(super) fn point(self, along: f64) -> DVec2 {
        self.turned(DVec2::new(along, self.at))
    }

    /// What the line has of a box.
    pub(super) fn within(self, room: &Aabb) -> Interval {
        (self.turned(room.min).x, self.turned(room.max).x)
    }

    /// Whether the line comes within `reach` of a box.
    fn meets(self, bounds: &Aabb, reach: f64) -> bool {
        (self.turned(bounds.min).y - reach..=self.turned(bounds.max).y + reach).contains(&self.at)
    }

    /// Adds the places that are inside a path or within `reach` of it. An open path has no inside.
    pub(super) fn block(self, path: &Path, reach: f64, blocked: &mut Vec<Interval>) {
        if !self.meets(&path.bounds(), reach) {
            return;
        }
        let mut near = Vec::new();
        for element in path.segments.iter().filter(|s| self.meets(&s.bounds(), reach)) {
            self.beside(element, reach, &mut near);
        }
        merge(&mut near);
        if path.closed {
            let inside = near.windows(2).map(|w| (w[0].1, w[1].0));
            blocked.extend(inside.filter(|(a, b)| winding(path, self.point(0.5 * (a + b))).number != 0));
        }
        blocked.append(&mut near);
    }

    /// The places where the line is inside a closed path.
    pub(super) fn inside(self, path: &Path) -> Vec<Interval> {
        let mut edges = Vec::new();
        for element in path.segments.iter().filter(|s| self.meets(&s.bounds(), 0.0)) {
            self.beside(element, 0.0, &mut edges);
        }
        merge(&mut edges);
        let between = edges.windows(2).map(|w| (w[0].1, w[1].0));
        between.filter(|(a, b)| winding(path, self.point(0.5 * (a + b))).number != 0).collect()
    }

    /// Adds the places within `reach` of an element.
    fn beside(self, element: &Segment, reach: f64, near: &mut Vec<Interval>) {
        for end in [element.start(), element.end()] {
            let end = self.turned(end);
            near.extend(chord(end, reach, self.at));
        }
        match element {
            Segment::Line(l) => {
                near.extend(self.beside_line(self.turned(l.start), self.turned(l.end), reach))
            }
            Segment::Arc(arc) => self.beside_arc(arc, reach, near),
        }
    }

    /// The part of the line in the rectangle with the line from `a` to `b` as its axis.
    fn beside_line(self, a: DVec2, b: DVec2, reach: f64) -> Option<Interval> {
        let length = a.distance(b);
        let d = (b - a).try_normalize()?;
        // Along the axis between 0 and `length`, and beside it at most by `reach`.
        let h = self.at - a.y;
        let along = between(d.x, h * d.y, 0.0, length)?;
        let beside = between(d.y, -h * d.x, -reach, reach)?;
        let both = (along.0.max(beside.0), along.1.min(beside.1));
        (both.0 <= both.1).then_some((a.x + both.0, a.x + both.1))
    }

    /// The parts of the line in the ring around an arc, where the arc is.
    fn beside_arc(self, arc: &Arc, reach: f64, near: &mut Vec<Interval>) {
        let (center, radius) = (self.turned(arc.center), arc.radius());
        let Some(outer) = chord(center, radius + reach, self.at) else { return };
        if reach == 0.0 {
            // Without a width there are no stretches, only the places where the line crosses the circle.
            let on_arc =
                |at: &f64| arc.is_circle() || arc.fraction_of(self.point(*at) - arc.center).is_some();
            near.extend([outer.0, outer.1].into_iter().filter(on_arc).map(|at| (at, at)));
            return;
        }
        let mut cuts = vec![outer.0, outer.1];
        cuts.extend(chord(center, radius - reach, self.at).into_iter().flat_map(|(a, b)| [a, b]));
        // Where the line leaves the sector of the arc.
        for end in [arc.start, arc.end] {
            let ray = self.turned(end) - center;
            let h = self.at - center.y;
            let at = if ray.y == 0.0 { center.x } else { center.x + ray.x * h / ray.y };
            if at > outer.0 && at < outer.1 {
                cuts.push(at);
            }
        }
        cuts.sort_by(f64::total_cmp);
        let is_near = |at: f64| {
            let v = self.point(at) - arc.center;
            (v.length() - radius).abs() <= reach && (arc.is_circle() || arc.fraction_of(v).is_some())
        };
        near.extend(cuts.windows(2).map(|w| (w[0], w[1])).filter(|(a, b)| is_near(0.5 * (a + b))));
    }
}

/// The places `u` with `least <= k * u + c <= most`; all of them have no end.
fn between(k: f64, c: f64, least: f64, most: f64) -> Option<Interval> {
    if k == 0.0 {
        return (least <= c && c <= most).then_some((f64::NEG_INFINITY, f64::INFINITY));
    }
    let (a, b) = ((least - c) / k, (most - c) / k);
    Some((a.min(b), a.max(b)))
}

/// The part of the line at height `at` in a disk.
fn chord(center: DVec2, radius: f64, at: f64) -> Option<Interval> {
    let h = at - center.y;
    if radius < 0.0 || h.abs() > radius {
        return None;
    }
    let half = (radius * radius - h * h).max(0.0).sqrt();
    Some((center.x - half, center.x + half))
}

/// Sorts intervals and joins those that overlap.
pub(super) fn merge(intervals: &mut Vec<Interval>) {
    intervals.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.total_cmp(&b.1)));
    intervals.dedup_by(|next, last| {
        let joined = next.0 <= last.1;
        if joined {
            last.1 = last.1.max(next.1);
        }
        joined
    });
}

/// The curves that skeleton cuts keep away from: everything that is worked.
pub(super) fn worked(sheet: &Sheet) -> impl Iterator<Item = &Path> {
    curves(sheet, |_| true)
}

/// The outlines of what is cut out of the sheet: those of them that lie in no other.
pub(super) fn outermost(sheet: &Sheet) -> impl Iterator<Item = &Path> {
    curves(sheet, |c| c.bounds_area() && c.inside.is_none())
}

fn curves(sheet: &Sheet, which: impl Fn(&Contour) -> bool) -> impl Iterator<Item = &Path> {
    let all = sheet.contours.iter().filter(|c| c.is_processed() && !c.skeleton && c.next_pass.is_none());
    all.filter(move |c| which(c)).map(|c| c.boundary().unwrap_or(&c.path))
}
