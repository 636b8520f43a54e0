//! Removes elements that are too short for any program to show.
//!
//! Coordinates of programs have three decimals of a millimetre. An element of half a step gets another direction when they
//! are rounded, so the controller slows down for a corner that nobody drew, or it is lost, and the plan waits for corners
//! that the machine never sees: on a fast machine, programs of such drawings took from 4 % less to 4 % more time than
//! their plans. The elements before and after it meet instead, as across a gap; where neither can give way, it stays.

use super::close::{INVISIBLE, meet};
use crate::geometry::{Path, Segment};

/// The path without elements of at most half a step of programs.
pub(super) fn without_fragments(mut path: Path) -> Path {
    let is_fragment = |s: &Segment| s.length() <= INVISIBLE;
    let Some(first) = path.segments.iter().position(|s| !is_fragment(s)) else { return path };
    if !path.segments.iter().any(is_fragment) {
        return path;
    }
    if path.closed {
        path.segments.rotate_left(first);
    }
    let mut kept: Vec<Segment> = Vec::with_capacity(path.segments.len());
    let mut fragments: Vec<Segment> = Vec::new();
    for s in path.segments {
        if is_fragment(&s) {
            fragments.push(s);
            continue;
        }
        let before = kept.last().copied().filter(|_| !fragments.is_empty());
        match before.and_then(|before| met(before, s)) {
            Some((a, b)) => {
                kept.pop();
                kept.extend([a, b]);
                fragments.clear();
            }
            None => {
                kept.append(&mut fragments);
                kept.push(s);
            }
        }
    }
    if let ([first, .., last], true) = (&mut kept[..], path.closed && !fragments.is_empty())
        && let Some((a, b)) = met(*last, *first)
    {
        (*last, *first) = (a, b);
        fragments.clear();
    }
    kept.append(&mut fragments);
    Path { segments: kept, ..path }
}

/// Two elements that meet where what was between them is removed, if one of them can give way.
fn met(a: Segment, b: Segment) -> Option<(Segment, Segment)> {
    if a.end().distance(b.start()) > INVISIBLE {
        return None;
    }
    match meet(a, b) {
        (a, None, b) => Some((a, b)),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::{Arc, DVec2};
    use std::f64::consts::FRAC_PI_2;

    fn path(places: &[[f64; 2]], closed: bool) -> Path {
        let places: Vec<DVec2> = places.iter().map(|&p| DVec2::from(p)).collect();
        let mut segments: Vec<Segment> = places.windows(2).map(|w| Segment::line(w[0], w[1])).collect();
        if closed {
            segments.push(Segment::line(places[places.len() - 1], places[0]));
        }
        Path::new(segments, closed)
    }

    #[test]
    fn lines_meet_in_the_middle_of_what_was_between_them() {
        let bent = path(&[[0.0, 0.0], [10.0, 0.0], [10.0004, 0.0002], [20.0, 5.0]], false);
        let expected = path(&[[0.0, 0.0], [10.0002, 0.0001], [20.0, 5.0]], false);
        assert_eq!(without_fragments(bent), expected);
    }

    #[test]
    fn what_a_program_shows_stays() {
        let bent = path(&[[0.0, 0.0], [10.0, 0.0], [10.0006, 0.0], [20.0, 5.0]], false);
        assert_eq!(without_fragments(bent.clone()), bent);
    }

    #[test]
    fn several_in_a_row_that_lead_too_far_stay() {
        let staircase =
            path(&[[0.0, 0.0], [10.0, 0.0], [10.0004, 0.0], [10.0004, 0.0004], [20.0, 5.0]], false);
        assert_eq!(without_fragments(staircase.clone()), staircase);
    }

    #[test]
    fn a_closed_path_that_begins_with_one_stays_closed() {
        let square = [[0.0, -0.0004], [0.0, 0.0], [10.0, 0.0], [10.0, 10.0], [0.0, 10.0]];
        let closed = without_fragments(path(&square, true));
        assert_eq!(closed.segments.len(), 4);
        assert!(closed.largest_gap() <= 0.0);
        assert!((closed.area() - 100.0).abs() < 0.01, "{}", closed.area());
    }

    #[test]
    fn an_arc_begins_where_the_one_before_it_ends() {
        let arc = |center: [f64; 2], from: [f64; 2], to: [f64; 2]| {
            let [center, start, end] = [center, from, to].map(DVec2::from);
            Segment::Arc(Arc { start, end, center, sweep: FRAC_PI_2 })
        };
        let a = arc([0.0, 0.0], [10.0, 0.0], [0.0, 10.0]);
        let b = arc([-0.0003, 0.0], [-0.0003, 10.0], [-10.0003, 0.0]);
        let joined = without_fragments(Path::new(vec![a, Segment::line(a.end(), b.start()), b], false));
        let [first, second] = joined.segments[..] else { panic!("{joined:?}") };
        assert_eq!((first, second.start(), second.end()), (a, a.end(), b.end()));
    }

    #[test]
    fn a_path_of_nothing_else_stays() {
        let dot = path(&[[0.0, 0.0], [0.0003, 0.0], [0.0003, 0.0003]], true);
        assert_eq!(without_fragments(dot.clone()), dot);
    }
}
