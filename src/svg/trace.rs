//! Converts an outline in user units to lines and arcs in mm.
//!
//! Under a map that keeps angles, circular arcs remain exact arcs. Other arcs, and curves, are fitted within the
//! tolerance. Points are the exact images of those in the file, so shapes that meet in the drawing meet on the sheet.

use super::outline::{Chain, Piece};
use crate::geometry::{Affine, Beziers, DVec2, Path, Segment, pin_ends};

/// Farthest place, mm, where curves are still fitted: a hundred times the limit of coordinates. A curve that comes from
/// farther away would take thousands of elements before it is refused.
const FARTHEST: f64 = 1e8;

/// The image of a chain; `None` if it lies farther away than any sheet. Pieces without length are left out.
pub(super) fn path(chain: &Chain, map: &Affine, tolerance: f64) -> Option<Path> {
    let mut tracer =
        Tracer { tolerance, segments: Vec::with_capacity(chain.pieces.len() + 1), curves: Vec::new() };
    let start = place(chain.start, map)?;
    let mut at = start;
    for piece in &chain.pieces {
        at = match *piece {
            Piece::Line(to) => {
                let to = place(to, map)?;
                tracer.line(at, to);
                to
            }
            Piece::Quadratic(control, to) => {
                let to = place(to, map)?;
                tracer.curves.push(Beziers::of_quadratic(at, place(control, map)?, to));
                to
            }
            Piece::Cubic(a, b, to) => {
                let to = place(to, map)?;
                tracer.curves.push([at, place(a, map)?, place(b, map)?, to]);
                to
            }
            Piece::Arc(ellipse, to) => {
                let to = place(to, map)?;
                let image = ellipse.transformed(map);
                [image.center, image.center + image.major, image.center + image.minor]
                    .iter()
                    .all(is_near)
                    .then_some(())?;
                tracer.flush();
                let mut arc = image.to_segments(tolerance);
                // A whole ellipse starts and ends at its first point already.
                if !ellipse.is_full() {
                    pin_ends(&mut arc, at, to);
                }
                tracer.segments.extend(arc);
                to
            }
        };
    }
    if chain.closed {
        tracer.line(at, start);
    }
    tracer.flush();
    Some(Path::closed_if_ends_meet(tracer.segments))
}

fn place(p: DVec2, map: &Affine) -> Option<DVec2> {
    Some(map.point(p)).filter(is_near)
}

fn is_near(p: &DVec2) -> bool {
    p.is_finite() && p.abs().max_element() <= FARTHEST
}

struct Tracer {
    tolerance: f64,
    segments: Vec<Segment>,
    /// Curves that follow one another, which are fitted together.
    curves: Vec<[DVec2; 4]>,
}

impl Tracer {
    fn line(&mut self, from: DVec2, to: DVec2) {
        self.flush();
        if from != to {
            self.segments.push(Segment::line(from, to));
        }
    }

    fn flush(&mut self) {
        if !self.curves.is_empty() {
            let curves = std::mem::take(&mut self.curves);
            let (from, to) = (curves.first().map(|c| c[0]), curves.last().map(|c| c[3]));
            let mut fitted = Beziers::new(curves).to_segments(self.tolerance);
            if let (Some(from), Some(to)) = (from, to) {
                pin_ends(&mut fitted, from, to);
            }
            self.segments.extend(fitted);
        }
    }
}
