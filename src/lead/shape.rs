//! The geometry of a lead at a place of a contour.
//!
//! Leads are built from the contour outwards into the scrap, which is on the right of a contour in its stored direction.
//! A lead-in is cut against that, and a lead-out is the mirror image: both start from the same formulas, with the direction
//! of travel turned round.

use crate::geometry::{Arc, DVec2, Path, Segment, math};
use crate::machine::{LeadKind, LeadShape};
use std::f64::consts::{PI, TAU};

/// A place of a closed contour.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Spot {
    /// Arc length from the contour's start, mm.
    pub(super) along: f64,
    /// The point, mm.
    pub(super) at: DVec2,
    /// Unit directions of travel into it and on from it; they differ in corners.
    pub(super) arrives: DVec2,
    pub(super) leaves: DVec2,
}

/// Which lead.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Which {
    In,
    Out,
}

/// A lead from the contour outwards.
#[derive(Clone, Debug, PartialEq, Default)]
pub(super) struct Outwards {
    pub(super) path: Vec<Segment>,
    /// Unit direction across the contour into the scrap.
    waste: DVec2,
}

impl Outwards {
    /// Distance of a place from the line that is tangent to the contour where the lead joins it, mm.
    pub(super) fn depth(&self, place: DVec2) -> f64 {
        self.path.first().map_or(0.0, |s| (place - s.start()).dot(self.waste).abs())
    }
}

/// A corner turns by more than this, rad: five degrees, as joints of flattened curves turn by less.
const CORNER: f64 = 5.0 * PI / 180.0;
/// Lines stay this far from the contour on both sides, rad: below one degree the two cuts melt into one.
const LEAST_ANGLE: f64 = PI / 180.0;
/// Directions nearer than this are the same, rad: a hundredth of the accuracy of a tangent that leads promise.
const SAME_DIRECTION: f64 = 2e-5;

impl Spot {
    /// The place `along` mm from the start of a closed contour; `None` for a contour without length.
    pub(super) fn new(contour: &Path, along: f64) -> Option<Self> {
        let (i, f) = contour.locate(along)?;
        let count = contour.segments.len();
        let here = contour.segments.get(i)?;
        let has_length = |s: &&Segment| s.length() > 0.0;
        let behind = (0..count).map(|k| &contour.segments[(i + count - 1 - k) % count]).find(has_length)?;
        let ahead = (1..=count).map(|k| &contour.segments[(i + k) % count]).find(has_length)?;
        let arrives = if f > 0.0 { here.tangent(f) } else { behind.tangent(1.0) };
        let leaves = if f < 1.0 { here.tangent(f) } else { ahead.tangent(0.0) };
        Some(Self { along, at: here.at(f), arrives, leaves })
    }

    /// By how much the contour turns here, rad, positive to the left.
    fn turn(&self) -> f64 {
        math::atan2(self.arrives.perp_dot(self.leaves), self.arrives.dot(self.leaves))
    }

    /// Whether this is a corner.
    pub(super) fn is_corner(&self) -> bool {
        self.turn().abs() > CORNER
    }

    /// The lead at this place; `None` if it would begin in the part. `center` is that of the largest circle in the hole.
    pub(super) fn lead(&self, shape: &LeadShape, which: Which, center: Option<DVec2>) -> Option<Outwards> {
        // Against the direction of the contour, and into the scrap.
        let (back, waste) = match which {
            Which::In => (-self.leaves, -self.leaves.perp()),
            Which::Out => (self.arrives, -self.arrives.perp()),
        };
        let (sin, cos) = (math::sin(shape.angle), math::cos(shape.angle));
        let (path, least) = match (shape.kind, center) {
            (LeadKind::None, _) => return Some(Outwards::default()),
            (LeadKind::Center, Some(center)) => (vec![Segment::line(self.at, center)], LEAST_ANGLE),
            (LeadKind::Line | LeadKind::Center, _) => {
                let end = self.at + shape.length * (back * cos + waste * sin);
                (vec![Segment::line(self.at, end)], LEAST_ANGLE)
            }
            (LeadKind::Arc | LeadKind::LineArc, _) => {
                let r = shape.radius;
                let end = self.at + back * (r * sin) + waste * (r * (1.0 - cos));
                let center = self.at + waste * r;
                let sweep = if back.perp_dot(waste) > 0.0 { shape.angle } else { -shape.angle };
                let mut path = vec![Segment::Arc(Arc { start: self.at, end, center, sweep })];
                if shape.kind == LeadKind::LineArc {
                    path.push(Segment::line(end, end + shape.length * (back * cos + waste * sin)));
                }
                (path, -SAME_DIRECTION)
            }
        };
        let starts = path.first()?.tangent(0.0);
        self.is_scrap(starts, least).then_some(Outwards { path, waste })
    }

    /// Whether a direction points into the scrap, at least `least` rad from the contour on both sides.
    fn is_scrap(&self, direction: DVec2, least: f64) -> bool {
        // Clockwise from the contour ahead to the direction, and on to the contour behind.
        let scrap = PI + self.turn();
        let to = math::wrap_tau(math::turn(direction, self.leaves));
        let to = if TAU - to <= SAME_DIRECTION { 0.0 } else { to };
        (least..=scrap - least).contains(&to)
    }

    /// The angle of a line lead that leaves in the middle of the scrap, rad: the same for lead-ins and lead-outs, because
    /// one is measured from the contour ahead and the other from the contour behind.
    pub(super) fn middle_angle(&self) -> f64 {
        0.5 * (PI - self.turn())
    }

    /// Whether arcs cannot be tangent to the contour here without cutting into the part: it turns into the scrap.
    pub(super) fn is_concave(&self) -> bool {
        self.turn() < -SAME_DIRECTION
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::FRAC_PI_2;

    fn shape(kind: LeadKind, length: f64, radius: f64, degrees: f64) -> LeadShape {
        LeadShape { kind, length, radius, angle: degrees.to_radians() }
    }

    /// A square of 10 mm, counter-clockwise: scrap is outside.
    fn square() -> Path {
        let corners = [[0.0, 0.0], [10.0, 0.0], [10.0, 10.0], [0.0, 10.0]].map(DVec2::from_array);
        Path::new((0..4).map(|k| Segment::line(corners[k], corners[(k + 1) % 4])).collect(), true)
    }

    fn end(lead: &Outwards) -> DVec2 {
        lead.path.last().unwrap().end()
    }

    #[track_caller]
    fn near(a: DVec2, x: f64, y: f64) {
        assert!(a.distance(DVec2::new(x, y)) < 1e-12, "{a} is not {x}, {y}");
    }

    #[test]
    fn leads_in_the_middle_of_a_side_end_where_they_should() {
        // On the lower side, travelling to +x: scrap is below.
        let spot = Spot::new(&square(), 5.0).unwrap();
        let at = |s: LeadShape, which| end(&spot.lead(&s, which, None).unwrap());
        near(at(shape(LeadKind::Line, 3.0, 1.0, 90.0), Which::In), 5.0, -3.0);
        let d = 3.0 * 0.5_f64.sqrt();
        near(at(shape(LeadKind::Line, 3.0, 1.0, 45.0), Which::In), 5.0 - d, -d);
        near(at(shape(LeadKind::Line, 3.0, 1.0, 45.0), Which::Out), 5.0 + d, -d);
        near(at(shape(LeadKind::Arc, 3.0, 2.0, 90.0), Which::In), 3.0, -2.0);
        near(at(shape(LeadKind::Arc, 3.0, 2.0, 90.0), Which::Out), 7.0, -2.0);
        near(at(shape(LeadKind::LineArc, 3.0, 2.0, 90.0), Which::In), 3.0, -5.0);
        near(at(shape(LeadKind::Arc, 3.0, 2.0, 180.0), Which::In), 5.0, -4.0);
    }

    #[test]
    fn arcs_are_tangent_to_their_contour() {
        let hole = Path::new(vec![Segment::Arc(Arc::circle(DVec2::new(1.0, 2.0), 8.0))], true).reversed();
        for contour in [square(), hole] {
            for k in 0..20 {
                let spot = Spot::new(&contour, contour.length() * f64::from(k) / 20.0).unwrap();
                for which in [Which::In, Which::Out] {
                    let lead = spot.lead(&shape(LeadKind::LineArc, 2.0, 1.0, 70.0), which, None).unwrap();
                    let travel = if which == Which::In { spot.leaves } else { -spot.arrives };
                    let turn = math::turn(-lead.path[0].tangent(0.0), travel);
                    assert!(turn.abs() < 0.1_f64.to_radians() * 1e-3, "{turn}");
                    let [arc, line] = lead.path[..] else { panic!("an arc and a line") };
                    assert!(
                        arc.end() == line.start()
                            && math::turn(arc.tangent(1.0), line.tangent(0.0)).abs() < 1e-9
                    );
                }
            }
        }
    }

    #[test]
    fn a_lead_into_the_part_is_refused() {
        // An L: the inner corner is at (4, 4).
        let corners = [[0.0, 0.0], [10.0, 0.0], [10.0, 4.0], [4.0, 4.0], [4.0, 10.0], [0.0, 10.0]]
            .map(DVec2::from_array);
        let l = Path::new((0..6).map(|k| Segment::line(corners[k], corners[(k + 1) % 6])).collect(), true);
        let inner = Spot::new(&l, 20.0).unwrap();
        near(inner.at, 4.0, 4.0);
        assert!(inner.is_corner());
        // Travelling up from here, a line at 45 degrees from behind begins in the part; the middle of the scrap does not.
        assert_eq!(inner.lead(&shape(LeadKind::Line, 2.0, 1.0, 45.0), Which::In, None), None);
        assert_eq!(inner.lead(&shape(LeadKind::Arc, 2.0, 1.0, 90.0), Which::In, None), None);
        for which in [Which::In, Which::Out] {
            let angle = inner.middle_angle();
            assert!((angle - 1.5 * FRAC_PI_2).abs() < 1e-12);
            let lead = inner.lead(&LeadShape { angle, ..shape(LeadKind::Line, 2.0, 1.0, 45.0) }, which, None);
            let d = 2.0 * 0.5_f64.sqrt();
            near(end(&lead.unwrap()), 4.0 + d, 4.0 + d);
        }
    }

    #[test]
    fn a_lead_from_the_center_begins_there() {
        let center = DVec2::new(1.0, 2.0);
        let hole = Path::new(vec![Segment::Arc(Arc::circle(center, 3.0))], true).reversed();
        let spot = Spot::new(&hole, 4.0).unwrap();
        let lead = spot.lead(&shape(LeadKind::Center, 9.0, 1.0, 90.0), Which::In, Some(center)).unwrap();
        assert_eq!(end(&lead), center);
        assert!((lead.depth(center) - 3.0).abs() < 1e-9);
    }
}
