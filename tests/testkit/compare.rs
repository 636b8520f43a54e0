//! How far two curves are apart: the Hausdorff distance, both ways, by points dense enough for the question.

use kerfway::geometry::{Aabb, DVec2, Path, Segment};

/// Distance between samples along our elements, mm. With elements bent no tighter than 1 mm a curve leaves its
/// samples' chords by under 0.01 mm; ends and middles are always taken.
const STEP: f64 = 0.25;

/// A flattened curve; a closed one ends on its first point.
pub struct Polyline {
    pub points: Vec<DVec2>,
}

impl Polyline {
    pub fn new(mut points: Vec<DVec2>, closed: bool) -> Self {
        if closed {
            points.extend(points.first().copied());
        }
        Self { points }
    }

    pub fn length(&self) -> f64 {
        self.points.windows(2).map(|w| w[0].distance(w[1])).sum()
    }

    pub fn bounds(&self) -> Aabb {
        self.points.iter().fold(Aabb::EMPTY, |b, p| b.with(*p))
    }

    fn distance(&self, p: DVec2) -> f64 {
        self.points
            .windows(2)
            .map(|w| Segment::line(w[0], w[1]).nearest(p).1)
            .fold(self.points[0].distance_squared(p), f64::min)
            .sqrt()
    }
}

/// Points along a path, ends and middles of its elements among them.
pub fn samples(path: &Path) -> Vec<DVec2> {
    let mut out = Vec::new();
    for s in &path.segments {
        let n = (s.length() / STEP).ceil().clamp(2.0, 4000.0);
        let fractions = (0..4001_u32).map(|i| f64::from(i) / n).take_while(|f| *f < 1.0);
        out.extend(fractions.chain([0.5, 1.0]).map(|f| s.at(f)));
    }
    out
}

/// The largest distance from either curve to the other, mm.
pub fn hausdorff(ours: &Path, theirs: &Polyline) -> f64 {
    let to_ours =
        |p: DVec2| ours.segments.iter().map(|s| s.nearest(p).1).fold(f64::INFINITY, f64::min).sqrt();
    let middles = theirs.points.windows(2).map(|w| (w[0] + w[1]) * 0.5);
    let there = theirs.points.iter().copied().chain(middles).map(to_ours).fold(0.0, f64::max);
    samples(ours).into_iter().map(|p| theirs.distance(p)).fold(there, f64::max)
}

/// Whether a path comes back to its start, whatever its flag says.
pub fn comes_back(path: &Path) -> bool {
    match (path.start(), path.end()) {
        (Some(a), Some(b)) => path.closed || (path.segments.len() > 1 && a.distance(b) < 1e-6),
        _ => false,
    }
}
