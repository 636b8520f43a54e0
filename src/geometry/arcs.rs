//! Divides arcs into pieces, because no format can represent every arc.
//!
//! A full circle is ambiguous wherever an arc is given by its ends, and an arc given by ends and radius (SVG) is
//! ill-conditioned near half a turn. Every format states the largest sweep that it represents well.

use super::{Arc, DVec2, Segment, math};
use std::f64::consts::FRAC_PI_2;

/// Tolerance when pieces are counted, as a fraction of a piece, so that rounding does not turn one piece into two.
const COUNT_SLACK: f64 = 1e-9;

/// Divides an arc into equal pieces of at most `largest` rad, in order; the ends of the arc are kept bit for bit.
pub(crate) fn split(arc: &Arc, largest: f64) -> impl Iterator<Item = Arc> + use<> {
    let arc = *arc;
    let pieces = (arc.sweep.abs() / largest - COUNT_SLACK).ceil().max(1.0);
    let at = move |i: f64| Segment::Arc(arc).at(i / pieces);
    // A sweep is at most 2 pi, so there are few pieces.
    std::iter::successors(Some(0.0), |i| Some(i + 1.0)).take_while(move |i| *i < pieces).map(move |i| Arc {
        start: at(i),
        end: at(i + 1.0),
        center: arc.center,
        sweep: arc.sweep / pieces,
    })
}

/// The ends of equal chords within `deviation` mm of the arc, in order; the last one is the arc's end.
pub(crate) fn flattened(arc: &Arc, deviation: f64) -> impl Iterator<Item = DVec2> + use<> {
    // r (1 - cos(sweep / 2)) is at most r sweep^2 / 8. A chord over more than a quarter turn would hardly resemble a
    // circle.
    let sweep = (8.0 * deviation / arc.radius()).sqrt().min(FRAC_PI_2);
    split(arc, sweep).map(|piece| piece.end)
}

/// Largest distance between an arc of at most half a turn and its chord, mm: r (1 - cos(sweep / 2)), in a form that
/// stays accurate for small sweeps.
pub(crate) fn sagitta(arc: &Arc) -> f64 {
    let s = math::sin(arc.sweep * 0.25);
    2.0 * arc.radius() * s * s
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::{PI, TAU};

    #[test]
    fn pieces_join_bit_for_bit_and_keep_the_ends() {
        let circle = Arc::circle(DVec2::new(3.0, 4.0), 2.0);
        let halves: Vec<Arc> = split(&circle, PI).collect();
        assert_eq!(halves.len(), 2);
        assert_eq!((halves[0].start, halves[1].end), (circle.start, circle.end));
        assert_eq!(halves[0].end, halves[1].start);
        assert!((halves[0].end - DVec2::new(1.0, 4.0)).length() < 1e-12);

        assert_eq!(split(&circle, TAU / 3.0).count(), 3);
        let quarter = Arc::from_angles(DVec2::ZERO, 1.0, 0.3, -FRAC_PI_2);
        assert_eq!(split(&quarter, PI).collect::<Vec<_>>(), [quarter]);
    }

    #[test]
    fn sagitta_of_a_half_turn_is_the_radius_and_is_accurate_for_small_sweeps() {
        assert!((sagitta(&Arc::from_angles(DVec2::ZERO, 5.0, 0.0, PI)) - 5.0).abs() < 1e-12);
        let flat = sagitta(&Arc::from_angles(DVec2::ZERO, 1e5, 0.0, 1e-6));
        assert!((flat / 1.25e-8 - 1.0).abs() < 1e-6, "{flat}");
    }
}
