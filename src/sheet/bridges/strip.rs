//! Strips that may connect two sides: straight across the waste between them, all of one width.

use super::side::{Hit, Side};
use crate::geometry::{DVec2, Segment};
use crate::sheet::Strip;

/// Straight sides face each other if the angle between them has at most this sine: 15 degrees.
const NEARLY_PARALLEL: f64 = 0.258_819;
/// Where strips are tried along the stretch in which two straight sides face each other, as fractions of it: in the middle first.
const PLACES: [f64; 3] = [0.5, 0.25, 0.75];
/// The width of a strip is at most this part of the radius of an arc on which it ends, so that it leaves the arc steeply.
const OF_RADIUS: f64 = 1.0;

/// A strip, and the openings at its ends.
#[derive(Clone, Copy, Debug)]
pub(super) struct Candidate {
    pub(super) strip: Strip,
    /// The sides on which it ends, by number.
    pub(super) of: [usize; 2],
    /// Where the outlines are opened: arc length from their start to where the opening begins and ends, mm.
    pub(super) openings: [[f64; 2]; 2],
}

/// The strips `width` mm wide between two sides, with lengths from `least` to `most` mm.
pub(super) fn between(
    sides: [&Side; 2],
    of: [usize; 2],
    width: f64,
    [least, most]: [f64; 2],
) -> Vec<Candidate> {
    let [a, b] = sides;
    let fits = |side: &Side| match &side.shape {
        Segment::Line(_) => true,
        // Arcs that bulge outwards; outlines run counter-clockwise.
        Segment::Arc(arc) => arc.ccw() && width <= OF_RADIUS * arc.radius(),
    };
    if !fits(a) || !fits(b) {
        return Vec::new();
    }
    let across = |(origin, way): (DVec2, DVec2)| {
        let half = way.perp() * (0.5 * width);
        // On the first outline the opening runs along `half`, on the second against it.
        let hit = |side: &Side, by: DVec2, far: bool| side.hit(origin + by, way, far);
        let first = [hit(a, -half, true)?, hit(a, half, true)?];
        let second = [hit(b, half, false)?, hit(b, -half, false)?];
        let lengths = [second[1].far - first[0].far, second[0].far - first[1].far];
        let fits = lengths.iter().all(|l| (least..=most).contains(l));
        let forward = [(a, &first), (b, &second)].iter().all(|(side, ends)| runs_forward(side, ends));
        (fits && forward).then(|| Candidate {
            strip: Strip {
                contours: [a.contour, b.contour],
                sides: [[first[0].at, second[1].at], [second[0].at, first[1].at]],
            },
            of,
            openings: [first.map(|h| a.along(h.fraction)), second.map(|h| b.along(h.fraction))],
        })
    };
    axes(a, b).into_iter().filter_map(across).collect()
}

/// Whether an opening runs in the direction of its side. On a whole circle it may run across the seam.
fn runs_forward(side: &Side, [from, to]: &[Hit; 2]) -> bool {
    matches!(&side.shape, Segment::Arc(arc) if arc.is_circle()) || from.fraction < to.fraction
}

/// The middle lines of strips from one side to another: a point, and the unit vector from the first side to the second.
fn axes(a: &Side, b: &Side) -> Vec<(DVec2, DVec2)> {
    match (&a.shape, &b.shape) {
        (Segment::Line(l), Segment::Line(m)) => {
            let (u, v) = (a.shape.tangent(0.0), b.shape.tangent(0.0));
            if u.dot(v) >= 0.0 || u.perp_dot(v).abs() > NEARLY_PARALLEL {
                return Vec::new();
            }
            // Outlines run counter-clockwise, so the waste is on the right.
            let along = (u - v).normalize_or_zero();
            let way = -along.perp();
            let from = l.start.dot(along).max(m.end.dot(along));
            let to = l.end.dot(along).min(m.start.dot(along));
            if from >= to {
                return Vec::new();
            }
            let at = |part: f64| along * (from + part * (to - from)) + way * l.start.dot(way);
            PLACES.map(|part| (at(part), way)).to_vec()
        }
        (Segment::Arc(l), Segment::Arc(m)) => vec![(l.center, (m.center - l.center).normalize_or_zero())],
        (Segment::Arc(l), Segment::Line(_)) => vec![(l.center, b.shape.tangent(0.0).perp())],
        (Segment::Line(_), Segment::Arc(m)) => vec![(m.center, -a.shape.tangent(0.0).perp())],
    }
}
