//! Elements as an output gives them back, compared with the path they stand for. Arithmetic of its own.

#![allow(
    dead_code,
    clippy::disallowed_methods,
    reason = "each test takes what it needs; the product's arithmetic is not to judge itself"
)]

use glam::DVec2;
use kerfway::geometry::Segment;
use std::f64::consts::{PI, TAU};

/// A straight or circular element, mm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Element {
    pub(crate) from: DVec2,
    pub(crate) to: DVec2,
    /// Centre and signed sweep, rad, of an arc.
    pub(crate) arc: Option<(DVec2, f64)>,
}

impl Element {
    pub(crate) fn line(from: DVec2, to: DVec2) -> Self {
        Self { from, to, arc: None }
    }

    /// The arc from `from` to `to` whose sweep, at most half a turn, has the given radius and direction.
    pub(crate) fn of_radius(from: DVec2, to: DVec2, radius: f64, ccw: bool) -> Self {
        let chord = to - from;
        let half = chord.length() * 0.5;
        let rise = (radius * radius - half * half).max(0.0).sqrt();
        let left = if ccw { 1.0 } else { -1.0 };
        let center = (from + to) * 0.5 + chord.perp().normalize_or_zero() * rise * left;
        let sweep = 2.0 * (half / radius).min(1.0).asin() * left;
        Self { from, to, arc: Some((center, sweep)) }
    }

    pub(crate) fn length(&self) -> f64 {
        match self.arc {
            Some((center, sweep)) => (self.from - center).length() * sweep.abs(),
            None => self.from.distance(self.to),
        }
    }

    /// The point at fraction `f` of the way.
    pub(crate) fn at(&self, f: f64) -> DVec2 {
        match self.arc {
            Some((center, sweep)) => {
                let (s, c) = (sweep * f).sin_cos();
                let v = self.from - center;
                center + DVec2::new(v.x * c - v.y * s, v.x * s + v.y * c)
            }
            None => self.from + (self.to - self.from) * f,
        }
    }

    /// Distance of a point, mm.
    pub(crate) fn distance(&self, p: DVec2) -> f64 {
        let ends = p.distance(self.from).min(p.distance(self.to));
        match self.arc {
            Some((center, sweep)) => {
                let (a, b) = (self.from - center, p - center);
                let turn = f64::atan2(a.perp_dot(b), a.dot(b)) * sweep.signum();
                let turn = if turn < 0.0 { turn + TAU } else { turn };
                if turn <= sweep.abs() { (b.length() - a.length()).abs() } else { ends }
            }
            None => {
                let d = self.to - self.from;
                let f = (p - self.from).dot(d) / d.length_squared();
                if (0.0..=1.0).contains(&f) { p.distance(self.from + d * f) } else { ends }
            }
        }
    }
}

/// Whether `elements` run along `path`: joined, from its start to its end, nowhere more than `deviation` mm away either
/// way, and as long. A path that is smaller than the deviation may be missing.
pub(crate) fn assert_same_path(elements: &[Element], path: &[Segment], deviation: f64) {
    for w in elements.windows(2) {
        assert_eq!(w[0].to, w[1].from, "the path is broken");
    }
    let (from, to) = (path[0].start(), path[path.len() - 1].end());
    let Some((first, last)) = elements.first().zip(elements.last()) else {
        assert!(path.iter().all(|s| s.bounds().grown(deviation).contains(from)), "missing: {path:?}");
        return;
    };
    assert!(first.from.distance(from) <= deviation, "starts at {}, not {from}", first.from);
    assert!(last.to.distance(to) <= deviation, "ends at {}, not {to}", last.to);

    let fractions = || (0..=24).map(|i| f64::from(i) / 24.0);
    for segment in path {
        for f in fractions() {
            let p = segment.at(f);
            let off = elements.iter().map(|e| e.distance(p)).fold(f64::INFINITY, f64::min);
            assert!(off <= deviation, "nothing within {off} mm of {f} of {segment:?}");
        }
    }
    for element in elements {
        for f in fractions() {
            let off = path.iter().map(|s| s.nearest(element.at(f)).1.sqrt()).fold(f64::INFINITY, f64::min);
            assert!(off <= deviation, "{off} mm from the plan at {f} of {element:?}");
        }
    }

    let written: f64 = elements.iter().map(Element::length).sum();
    let planned: f64 = path.iter().map(Segment::length).sum();
    // Both ends of a segment are off by at most the deviation; the length of an arc also by that of its radius.
    let slack: f64 = path
        .iter()
        .map(|s| match s {
            Segment::Line(_) => 2.0 * deviation,
            Segment::Arc(a) => (2.0 + a.sweep.abs().max(PI)) * deviation,
        })
        .sum();
    assert!((written - planned).abs() <= slack, "{written} mm written, {planned} mm planned");
}
