//! Whether a lead lies in scrap: the distances of leads from all cuts, found with an index.
//!
//! A lead keeps `clearance` from every other contour that is cut, along its whole length. Where a contour shares a side
//! with another one, the outline of that other one counts too, so that no lead begins on such a side. From its own contour
//! a lead keeps the clearance beyond a *window* around the place where they join. Within the window it comes near by
//! nature: there it must not touch the contour again, and has to stay half as far away as it is deep. As it gets deeper on its
//! way, this is asked of its halves, quarters and so on (`stages`), each as deep as where it begins, and of its end.

use super::shape::Outwards;
use crate::geometry::{Aabb, BoxIndex, DVec2, Segment, distance, winding};
use crate::sheet::{Contour, Operation};

/// Least distance from other cuts, mm, if a smaller clearance is asked for: leads then still cross nothing.
const LEAST: f64 = 0.01;
/// Half of the window around the joint, in lengths of lead and clearance.
const WINDOW: f64 = 2.0;
/// The part of a lead next to the joint that is not compared with its own contour, as a fraction of its length.
const JOINT: f64 = 0.05;
/// Distance within which a lead touches its own contour, mm: a tenth of the finest coordinates that controllers take.
const TOUCHING: f64 = 1e-4;
/// Distance that a lead keeps from its own contour, in depths.
const KEPT: f64 = 0.5;
/// Where stages of a lead begin, as fractions of its length; the last one ends with it. What comes before them is next to the joint.
const STAGES: [f64; 4] = [0.0625, 0.125, 0.25, 0.5];

/// All cuts, and where leads may be.
pub(crate) struct Scrap<'s> {
    pub(super) contours: &'s [Contour],
    pub(super) elements: Vec<Element>,
    pub(super) index: BoxIndex,
    /// The contours that bound parts and holes, and the index of their boxes.
    outlines: Vec<u32>,
    boxes: BoxIndex,
    clearance: f64,
    /// Added to the distance from contours that are cut along their drawn line, mm: half the kerf.
    beside_drawn: f64,
    /// Leads stay in this box.
    pub(super) bed: Option<Aabb>,
}

pub(super) struct Element {
    pub(super) contour: u32,
    pub(super) shape: Segment,
    /// Arc length of its start on the contour, mm.
    start: f64,
    /// Least distance of other leads, mm.
    pub(super) least: f64,
}

/// A place where leads of a contour are tried.
#[derive(Clone, Copy)]
pub(super) struct Joint {
    pub(super) contour: u32,
    /// Arc length of the place, mm.
    pub(super) along: f64,
}

impl<'s> Scrap<'s> {
    /// `kerf` is the width of the beam if contours are offset for it, mm.
    pub(crate) fn new(contours: &'s [Contour], clearance: f64, kerf: f64, bed: Option<Aabb>) -> Self {
        let mut scrap = Self {
            contours,
            elements: Vec::new(),
            index: BoxIndex::new([]),
            outlines: Vec::new(),
            boxes: BoxIndex::new([]),
            clearance: clearance.max(LEAST),
            beside_drawn: 0.5 * kerf,
            bed,
        };
        for (contour, c) in
            (0..).zip(contours).filter(|(_, c)| c.operation == Operation::Cut && c.pass == 0 && !c.is_added())
        {
            let beside = if c.drawn.is_some() { 0.0 } else { scrap.beside_drawn };
            let mut start = 0.0;
            for &shape in &c.boundary().unwrap_or(&c.path).segments {
                scrap.elements.push(Element { contour, shape, start, least: scrap.clearance + beside });
                start += shape.length();
            }
        }
        let outlines = (0..).zip(contours).filter(|(_, c)| c.bounds_area() && c.pass == 0);
        let boxed = outlines.filter_map(|(id, c)| Some((id, c.boundary()?.bounds())));
        let (outlines, boxes): (Vec<u32>, Vec<Aabb>) = boxed.unzip();
        (scrap.outlines, scrap.boxes) = (outlines, BoxIndex::new(boxes));
        scrap.index = BoxIndex::new(scrap.elements.iter().map(|e| e.shape.bounds()));
        scrap
    }

    /// How far away contours matter, mm.
    pub(super) fn reach(&self) -> f64 {
        self.clearance + self.beside_drawn
    }

    /// Whether a lead from a joint outwards lies in scrap.
    pub(super) fn holds(&self, joint: Joint, lead: &Outwards) -> bool {
        let Some(tip) = lead.path.last().map(Segment::end) else { return true };
        let Some(own) = self.contours.get(joint.contour as usize) else { return false };
        let in_bed = |b: &Aabb| lead.path.iter().all(|s| b.contains_box(&s.bounds()));
        if !self.bed.as_ref().is_none_or(in_bed) {
            return false;
        }
        let length: f64 = lead.path.iter().map(Segment::length).sum();
        let window =
            Window { along: joint.along, half: WINDOW * (length + self.clearance), whole: own.length };
        let reach = self.reach();
        let kept = |depth: f64| self.clearance.min(KEPT * depth);
        let least_tip = kept(lead.depth(tip));
        let mut skip = JOINT * length;
        let mut passed = 0.0;
        for s in &lead.path {
            let free = free_part(s, &mut skip);
            let stages = stages(s, passed, length);
            passed += s.length();
            let mut fits = true;
            self.index.visit(s.bounds().grown(reach), |k| {
                let element = &self.elements[k];
                fits = if element.contour == joint.contour {
                    window.parts(element).into_iter().flatten().all(|(part, near)| {
                        if near {
                            free.is_none_or(|free| distance(&free, &part).0 > TOUCHING)
                                && part.nearest(tip).1.sqrt() >= least_tip
                                && stages
                                    .iter()
                                    .all(|stage| distance(stage, &part).0 >= kept(lead.depth(stage.start())))
                        } else {
                            distance(s, &part).0 >= self.clearance
                        }
                    })
                } else {
                    distance(s, &element.shape).0 >= element.least
                };
                fits
            });
            if !fits {
                return false;
            }
        }
        self.is_in_scrap(own, tip)
    }

    /// Whether a point is in the scrap of a contour: within the contours around it and, of a hole, within itself, but in
    /// nothing else. Contours that cross each other have no such point where they overlap.
    pub(super) fn is_in_scrap(&self, own: &Contour, p: DVec2) -> bool {
        let (mut around, mut clear) = (0, true);
        self.boxes.visit(Aabb::of(p), |k| {
            let id = self.outlines.get(k).copied().unwrap_or_default();
            if let Some(outline) = self.contours.get(id as usize).and_then(Contour::boundary) {
                let winding = winding(outline, p);
                clear = !winding.on_edge;
                around += u32::from(winding.number != 0);
            }
            clear
        });
        clear && around == own.depth + own.depth % 2
    }
}

/// The part of an element that is not next to the joint, of which `skip` mm are left to pass.
fn free_part(s: &Segment, skip: &mut f64) -> Option<Segment> {
    let length = s.length();
    let passed = skip.min(length);
    *skip -= passed;
    (passed < length).then(|| s.piece(passed / length, 1.0))
}

/// The stages of a lead of `length` mm that run along one of its elements, of which `passed` mm of the lead lie before.
fn stages(s: &Segment, passed: f64, length: f64) -> Vec<Segment> {
    let ends = STAGES.into_iter().skip(1).chain([1.0]);
    let fraction = |of_lead: f64| ((of_lead * length - passed) / s.length()).clamp(0.0, 1.0);
    let stretches = STAGES.into_iter().zip(ends).map(|(from, to)| (fraction(from), fraction(to)));
    stretches.filter(|(from, to)| to > from).map(|(from, to)| s.piece(from, to)).collect()
}

/// The stretch of a closed contour around a joint.
struct Window {
    along: f64,
    half: f64,
    /// Length of the contour, mm.
    whole: f64,
}

impl Window {
    /// The parts of an element of the contour, each with whether it lies in the window.
    fn parts(&self, element: &Element) -> [Option<(Segment, bool)>; 4] {
        let length = element.shape.length();
        let inside = 2.0 * self.half;
        if inside >= self.whole || length <= 0.0 {
            return [Some((element.shape, true)), None, None, None];
        }
        // Counted from the start of the window, which an element that passes the whole contour meets twice.
        let from = (element.start - self.along + self.half).rem_euclid(self.whole);
        let fraction = |at: f64| ((at - from) / length).clamp(0.0, 1.0);
        let [a, b, c] = [inside, self.whole, self.whole + inside].map(fraction);
        let part = |from: f64, to: f64, near| (to > from).then(|| (element.shape.piece(from, to), near));
        [part(0.0, a, true), part(a, b, false), part(b, c, true), part(c, 1.0, false)]
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::Arc;

    fn length(parts: &[Option<(Segment, bool)>], near: bool) -> f64 {
        parts.iter().flatten().filter(|p| p.1 == near).map(|p| p.0.length()).sum()
    }

    #[test]
    fn a_window_divides_a_loop_once() {
        let circle = Segment::Arc(Arc::circle(DVec2::ZERO, 5.0));
        let whole = circle.length();
        let halves = [circle.piece(0.0, 0.5), circle.piece(0.5, 1.0)];
        for along in [0.0, 0.3, 10.0, 0.5 * whole, whole - 0.2] {
            for half in [0.5, 4.0, 15.0] {
                let window = Window { along, half, whole };
                let element = |shape: Segment, start| Element { contour: 0, shape, start, least: 0.0 };
                let one = window.parts(&element(circle, 0.0));
                let two =
                    [window.parts(&element(halves[0], 0.0)), window.parts(&element(halves[1], 0.5 * whole))];
                let near = 2.0 * half;
                assert!((length(&one, true) - near).abs() < 1e-9, "{along} {half}");
                let sum: f64 = two.iter().map(|p| length(p, true)).sum();
                assert!((sum - near).abs() < 1e-9, "{along} {half}: {sum}");
                let at = circle.at(along / whole);
                let far = one.iter().flatten().filter(|p| !p.1).map(|p| p.0.nearest(at).1.sqrt());
                let chord = 2.0 * 5.0 * crate::geometry::math::sin(0.5 * half / 5.0);
                assert!(far.into_iter().all(|d| d >= chord - 1e-9));
            }
        }
    }
}
