//! A stop that slides along its contour.

use super::super::net::Item;
use super::super::track::{SAME, Track};
use crate::geometry::DVec2;

/// Steps for slopes and curvatures, mm: a thousandth of what matters in a drawing, and far above rounding.
const STEP: f64 = 1e-3;

/// A stop of a path.
#[derive(Debug)]
pub(super) struct Stop<'g> {
    /// Where the head arrives and leaves, if it does not slide.
    fixed: [DVec2; 2],
    slide: Option<Slide<'g>>,
}

/// Where it is on its track.
#[derive(Debug)]
struct Slide<'g> {
    track: &'g Track,
    /// Arc lengths between which the track and the extra seconds of stops are smooth, from 0 to the whole length.
    ends: Vec<f64>,
    /// Which of these stretches it is on.
    stretch: usize,
    along: f64,
}

/// A place where a stop may be.
#[derive(Clone, Copy, Debug)]
pub(super) struct Place {
    pub(super) along: f64,
    pub(super) arrives: DVec2,
    pub(super) leaves: DVec2,
    /// Extra seconds of the stop.
    pub(super) extra: f64,
}

/// What a step along the track does.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Step {
    /// Where the head goes, and how that turns.
    pub(super) tangent: DVec2,
    pub(super) curvature: DVec2,
    /// Extra seconds for each mm.
    pub(super) extra: f64,
}

impl<'g> Stop<'g> {
    /// A stop of an item, where it is entered at one knot and left from the other.
    pub(super) fn new(item: &'g Item, knots: [usize; 2]) -> Self {
        let slide = item.track().map(|track| {
            let mut slide = Slide { track, ends: track.smooth_ends(), stretch: 0, along: 0.0 };
            slide.put(item.along[knots[0]]);
            slide
        });
        Self { fixed: knots.map(|knot| item.place(knot)), slide }
    }

    /// Where the head arrives and leaves.
    pub(super) fn places(&self) -> [DVec2; 2] {
        self.slide.as_ref().map_or(self.fixed, |s| [s.track.at(s.along); 2])
    }

    /// Extra seconds of the stop.
    pub(super) fn extra(&self) -> f64 {
        self.slide.as_ref().map_or(0.0, |s| 2.0 * s.track.half(s.along))
    }

    /// What a step does; `None` if it does not slide.
    pub(super) fn step(&self) -> Option<Step> {
        let slide = self.slide.as_ref()?;
        let [from, to] = slide.span();
        let step = STEP.min(0.25 * (to - from));
        let middle = slide.along.clamp(from + step, to - step);
        let [p, q, r] = [middle - step, middle, middle + step].map(|s| slide.track.at(s));
        let curvature = (r - 2.0 * q + p) / (step * step);
        let more = slide.track.half(middle + step) - slide.track.half(middle - step);
        let tangent = (r - p) / (2.0 * step) + curvature * (slide.along - middle);
        Some(Step { tangent, curvature, extra: more / step })
    }

    /// The places at some shares of the whole contour from its own; only its own if it does not slide.
    pub(super) fn places_beside(&self, shares: &[f64]) -> Vec<Place> {
        let Some(slide) = &self.slide else {
            let [arrives, leaves] = self.fixed;
            return vec![Place { along: 0.0, arrives, leaves, extra: 0.0 }];
        };
        let length = slide.length();
        let place = |share: &f64| {
            let along = (slide.along + share * length).rem_euclid(length);
            let at = slide.track.at(along);
            Place { along, arrives: at, leaves: at, extra: 2.0 * slide.track.half(along) }
        };
        shares.iter().map(place).collect()
    }

    pub(super) fn along(&self) -> f64 {
        self.slide.as_ref().map_or(0.0, |s| s.along)
    }

    /// Puts it at an arc length.
    pub(super) fn put(&mut self, along: f64) {
        if let Some(slide) = &mut self.slide {
            slide.put(along);
        }
    }

    /// Moves it along its track, to the end of its stretch at most.
    pub(super) fn go(&mut self, along: f64) {
        if let Some(slide) = &mut self.slide {
            let [from, to] = slide.span();
            slide.along = along.clamp(from, to);
        }
    }

    /// Whether it is at the end of its stretch that it would leave. `slope`: of all seconds along the track.
    pub(super) fn leaves(&self, slope: f64) -> bool {
        self.slide.as_ref().is_none_or(|slide| {
            let [from, to] = slide.span();
            if slope > 0.0 { slide.along <= from + SAME } else { slide.along >= to - SAME }
        })
    }

    /// Puts it at the beginning of the next stretch, at the same place.
    pub(super) fn turn(&mut self, slope: f64) {
        if let Some(slide) = &mut self.slide {
            let stretches = slide.ends.len() - 1;
            let next = if slope > 0.0 { slide.stretch + stretches - 1 } else { slide.stretch + 1 };
            slide.stretch = next % stretches;
            let [from, to] = slide.span();
            slide.along = if slope > 0.0 { to } else { from };
        }
    }
}

impl Slide<'_> {
    fn length(&self) -> f64 {
        self.ends[self.ends.len() - 1]
    }

    fn put(&mut self, along: f64) {
        self.along = along;
        self.stretch = self.ends.partition_point(|&s| s <= along).clamp(1, self.ends.len() - 1) - 1;
    }

    fn span(&self) -> [f64; 2] {
        [self.ends[self.stretch], self.ends[self.stretch + 1]]
    }
}
