//! The contours of a program: what is cut between two rapids, which of them are the same, and how many parts they make.

use super::program::Event;
use crate::geometry::{Aabb, BoxIndex, DVec2, Path, Segment, interior_point, math, winding};
use crate::order::{real, sort_by};

/// What is cut without a pause.
#[derive(Clone, Debug)]
pub(super) struct Cut {
    /// Line of the program where it begins.
    pub(super) line: u32,
    pub(super) path: Vec<Segment>,
}

/// Largest distance between the ends of a closed contour, mm: coordinates are rounded to a micrometre or more.
const CLOSED: f64 = 0.01;
/// Largest difference between the measures of two contours that are the same, mm.
const SAME: f64 = 0.01;

/// The cuts of a program in order. A dwell does not end a cut.
pub(super) fn cuts(events: &[Event]) -> Vec<Cut> {
    let mut all: Vec<Cut> = Vec::new();
    let mut goes_on = false;
    for event in events {
        match event {
            Event::Move { line, rapid: false, path, power, .. } if power.lit > 0.0 => {
                match all.last_mut().filter(|_| goes_on) {
                    Some(cut) => cut.path.push(*path),
                    None => all.push(Cut { line: *line, path: vec![*path] }),
                }
                goes_on = true;
            }
            Event::Move { .. } | Event::Height { .. } | Event::Contour { .. } => goes_on = false,
            Event::Dwell { .. } => {}
        }
    }
    all
}

impl Cut {
    pub(super) fn is_closed(&self) -> bool {
        let ends = self.path.first().zip(self.path.last());
        ends.is_some_and(|(first, last)| first.start().distance(last.end()) <= CLOSED)
            && self.length() > CLOSED
    }

    pub(super) fn length(&self) -> f64 {
        self.path.iter().map(Segment::length).sum()
    }

    /// What the motions turn from one to the next, rad.
    pub(super) fn turns(&self) -> f64 {
        let turn = |w: &[Segment]| math::turn(w[0].tangent(1.0), w[1].tangent(0.0)).abs();
        self.path.windows(2).map(turn).sum()
    }

    fn bounds(&self) -> Aabb {
        self.path.iter().fold(Aabb::EMPTY, |b, s| b.union(s.bounds()))
    }

    /// What does not depend on where the cut begins and in which direction it runs: length, box, and the centre and
    /// spread of its chords, all in mm.
    fn measures(&self) -> [f64; 9] {
        let (bounds, length) = (self.bounds(), self.length().max(f64::MIN_POSITIVE));
        let mean = |of: &dyn Fn(DVec2) -> f64| self.path.iter().map(|s| simpson(s, of)).sum::<f64>() / length;
        let center = DVec2::new(mean(&|p| p.x), mean(&|p| p.y));
        let root = |v: f64| v.abs().sqrt() * v.signum();
        let spread = [
            root(mean(&|p| (p.x - center.x) * (p.x - center.x))),
            root(mean(&|p| (p.x - center.x) * (p.y - center.y))),
        ];
        [
            length,
            bounds.min.x,
            bounds.min.y,
            bounds.max.x,
            bounds.max.y,
            center.x,
            center.y,
            spread[0],
            spread[1],
        ]
    }
}

/// The integral of a function along an element, by Simpson's rule over quarters of it.
fn simpson(s: &Segment, of: &dyn Fn(DVec2) -> f64) -> f64 {
    const WEIGHTS: [f64; 9] = [1.0, 4.0, 2.0, 4.0, 2.0, 4.0, 2.0, 4.0, 1.0];
    let sum: f64 = WEIGHTS.iter().enumerate().map(|(k, w)| w * of(s.at(k as f64 / 8.0))).sum();
    sum * s.length() / 24.0
}

/// How often each different contour is cut, with the line where it is first cut.
pub(super) fn repeats(cuts: &[Cut]) -> Vec<(u32, u32)> {
    let mut measured: Vec<(u32, [f64; 9])> = cuts.iter().map(|c| (c.line, c.measures())).collect();
    sort_by(&mut measured, |(_, m)| [real(m[0]), real(m[1]), real(m[2])]);
    let corner = |m: &[f64; 9]| Aabb::of(DVec2::new(m[1], m[2]));
    let index = BoxIndex::new(measured.iter().map(|(_, m)| corner(m)));
    let mut counted = vec![false; measured.len()];
    let mut groups = Vec::new();
    for k in 0..measured.len() {
        if counted[k] {
            continue;
        }
        let (mut line, mut count) = (measured[k].0, 0);
        for j in index.query(corner(&measured[k].1).grown(SAME)).into_iter().filter(|&j| j >= k) {
            let same = measured[j].1.iter().zip(&measured[k].1).all(|(a, b)| (a - b).abs() <= SAME);
            if same && !counted[j] {
                counted[j] = true;
                count += 1;
                line = line.min(measured[j].0);
            }
        }
        groups.push((line, count));
    }
    groups
}

/// The closed contours along a path that is open: contours that are joined by cuts through waste, or that have leads. What lies
/// before and between them is skipped element by element, and what follows [`SKIPPED`] of them is not looked at.
fn loops(path: &[Segment]) -> Vec<Path> {
    const SKIPPED: usize = 8;
    let (mut found, mut from, mut skipped) = (Vec::new(), 0, 0);
    while let Some(rest) = path.get(from..).filter(|rest| !rest.is_empty() && skipped <= SKIPPED) {
        let start = rest[0].start();
        let mut length = 0.0;
        let back = rest.iter().position(|s| {
            length += s.length();
            length > CLOSED && s.end().distance(start) <= CLOSED
        });
        match back.and_then(|last| rest.get(..=last)) {
            Some(whole) => {
                found.push(Path::new(whole.to_vec(), true));
                (from, skipped) = (from + whole.len(), 0);
            }
            None => (from, skipped) = (from + 1, skipped + 1),
        }
    }
    found
}

/// Number of parts: closed contours that lie inside an even number of others.
pub(super) fn parts(cuts: &[Cut]) -> u32 {
    let mut closed: Vec<Path> = Vec::new();
    for cut in cuts {
        if cut.is_closed() {
            closed.push(Path::new(cut.path.clone(), true));
        } else {
            closed.extend(loops(&cut.path));
        }
    }
    // A contour that is cut again is no second part.
    let boxes: Vec<Aabb> = closed.iter().map(Path::bounds).collect();
    let corners = BoxIndex::new(boxes.iter().map(|b| Aabb::of(b.min)));
    let mut all = 0..boxes.len();
    closed.retain(|_| {
        let Some(k) = all.next() else { return true };
        let b = boxes[k];
        let near = |o: &Aabb| o.min.distance(b.min).max(o.max.distance(b.max)) <= SAME;
        !corners.query(Aabb::of(b.min).grown(SAME)).into_iter().any(|j| j < k && near(&boxes[j]))
    });
    let index = BoxIndex::new(closed.iter().map(Path::bounds));
    let mut parts = 0;
    for (k, path) in closed.iter().enumerate() {
        let Some(inside) = interior_point(path).or_else(|| path.start()) else { continue };
        let around = index.query(Aabb::of(inside)).into_iter().filter(|&j| {
            j != k
                && closed[j].bounds().contains_box(&path.bounds())
                && winding(&closed[j], inside).is_inside()
        });
        parts += u32::from(around.count() % 2 == 0);
    }
    parts
}
