//! Checks that a cut follows its contour: from any start, in either direction, exactly once and completely.
//!
//! The first point of the cut is located on the elements of the contour. From each place where it lies, the cut is followed
//! in both directions, element by element, and compared at five points of each. A walk never turns back, so if its length
//! is that of the contour, it has passed each place once.

use super::tolerance::{SAME, slack};
use crate::geometry::{DVec2, Path, Segment};

/// Elements shorter than this are rounding, mm.
const NOTHING: f64 = SAME * SAME;

/// Why a cut does not follow its contour.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Fault {
    /// It leaves the contour near this point.
    Strays(DVec2),
    /// It ends too early or continues too far.
    Length {
        /// Length cut, mm.
        worked: f64,
        /// Length of the contour, mm.
        length: f64,
    },
}

/// Checks that `cut` follows `contour`, up to a `gap` of some mm that is left uncut.
pub(super) fn follows(contour: &Path, cut: &[Segment], gap: f64) -> Result<(), Fault> {
    let elements: Vec<Element> =
        contour.segments.iter().filter(|s| s.length() > NOTHING).map(Element::new).collect();
    let length: f64 = elements.iter().map(|e| e.length).sum::<f64>() - gap;
    let same = SAME + elements.iter().map(|e| e.slack).sum::<f64>();
    let Some(first) = cut.first() else { return Err(Fault::Length { worked: 0.0, length }) };

    let mut farthest: Option<(f64, Fault)> = None;
    for (index, element) in elements.iter().enumerate() {
        let (fraction, distance2) = element.shape.nearest(first.start());
        if distance2.sqrt() > SAME + element.slack {
            continue;
        }
        for direction in [1.0, -1.0] {
            let mut walk = Walk {
                elements: &elements,
                closed: contour.closed,
                index,
                at: fraction * element.length,
                direction,
                worked: 0.0,
            };
            let fault = match walk.along(cut) {
                Ok(()) if (walk.worked - length).abs() <= same => return Ok(()),
                Ok(()) => Fault::Length { worked: walk.worked, length },
                Err(fault) => fault,
            };
            if farthest.is_none_or(|(worked, _)| walk.worked > worked) {
                farthest = Some((walk.worked, fault));
            }
        }
    }
    Err(farthest.map_or(Fault::Strays(first.start()), |(_, fault)| fault))
}

/// An element of the contour.
struct Element<'s> {
    shape: &'s Segment,
    length: f64,
    /// Largest deviation of points on it that is not a fault, mm.
    slack: f64,
    /// Whether it is a full circle, whose start a piece may pass.
    circle: bool,
}

impl<'s> Element<'s> {
    fn new(shape: &'s Segment) -> Self {
        let circle = matches!(shape, Segment::Arc(a) if a.is_circle());
        Self { shape, length: shape.length(), slack: slack(shape), circle }
    }
}

/// A place on the contour, with a direction.
struct Walk<'e> {
    elements: &'e [Element<'e>],
    closed: bool,
    index: usize,
    /// Position along the element, mm.
    at: f64,
    /// 1 along the contour, -1 against it.
    direction: f64,
    /// Length followed so far, mm.
    worked: f64,
}

impl Walk<'_> {
    fn along(&mut self, cut: &[Segment]) -> Result<(), Fault> {
        for piece in cut {
            let length = piece.length();
            if length <= NOTHING {
                continue;
            }
            self.enter_next(piece).ok_or(Fault::Strays(piece.start()))?;
            let element = &self.elements[self.index];
            for t in [0.0, 0.25, 0.5, 0.75, 1.0] {
                let there = (self.at + self.direction * t * length) / element.length;
                let there = if element.circle { there.rem_euclid(1.0) } else { there };
                // A place beyond the element's end is compared with that end.
                if element.shape.at(there).distance(piece.at(t)) > SAME + element.slack {
                    return Err(Fault::Strays(piece.at(t)));
                }
            }
            self.at += self.direction * length;
            if element.circle {
                self.at = self.at.rem_euclid(element.length);
            }
            self.worked += length;
        }
        Ok(())
    }

    /// Continues from the end of an element to the next, unless a piece ends there instead of beginning there; `None` at the end
    /// of an open contour.
    fn enter_next(&mut self, piece: &Segment) -> Option<()> {
        let element = &self.elements[self.index];
        let last = self.elements.len() - 1;
        let (left, end) = if self.direction > 0.0 {
            (element.length - self.at, element.shape.end())
        } else {
            (self.at, element.shape.start())
        };
        let ends_there = piece.end().distance(end) < piece.start().distance(end);
        if left > SAME + element.slack || ends_there {
            return Some(());
        }
        if self.direction > 0.0 {
            self.index = if self.index < last { self.index + 1 } else { self.closed.then_some(0)? };
            self.at = 0.0;
        } else {
            self.index = if self.index > 0 { self.index - 1 } else { self.closed.then_some(last)? };
            self.at = self.elements[self.index].length;
        }
        Some(())
    }
}

/// Whether a run begins with the stretch that was cut ahead.
pub(super) fn leads(run: &Path, ahead: &Path) -> bool {
    let length = ahead.length();
    let slack = SAME + run.segments.iter().map(slack).sum::<f64>();
    [0.0, 0.5, 1.0].into_iter().filter(|_| length > 0.0).all(|t| {
        let places = run.at(t * length).zip(ahead.at(t * length));
        length <= run.length() + slack && places.is_some_and(|(a, b)| a.distance(b) <= slack)
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::Arc;

    fn follows(contour: &Path, cut: &[Segment]) -> Result<(), Fault> {
        super::follows(contour, cut, 0.0)
    }

    fn slot() -> Path {
        let p = DVec2::new;
        Path::new(
            vec![
                Segment::line(p(0.0, 0.0), p(10.0, 0.0)),
                Segment::Arc(Arc::new(p(10.0, 0.0), p(10.0, 4.0), p(10.0, 2.0), true)),
                Segment::line(p(10.0, 4.0), p(0.0, 4.0)),
                Segment::Arc(Arc::new(p(0.0, 4.0), p(0.0, 0.0), p(0.0, 2.0), true)),
            ],
            true,
        )
    }

    #[test]
    fn any_start_and_direction_follow() {
        let length = slot().length();
        for k in 0..50 {
            let cut = slot().starting_at(length * f64::from(k) / 50.0);
            assert_eq!(follows(&slot(), &cut.segments), Ok(()));
            assert_eq!(follows(&slot(), &cut.reversed().segments), Ok(()));
            assert_eq!(follows(&slot().reversed(), &cut.segments), Ok(()));
        }
    }

    /// Joining ends over a gap may move the end of an arc along its circle as well; its sweep stays. A cut that divides such
    /// an arc follows its contour all the same.
    #[test]
    fn a_cut_that_divides_an_arc_whose_end_was_moved_follows() {
        let mut slot = slot();
        let moved = DVec2::new(10.02, 4.0);
        if let [_, Segment::Arc(arc), Segment::Line(next), _] = slot.segments.as_mut_slice() {
            (arc.end, next.start) = (moved, moved);
        }
        let length = slot.length();
        for k in 0..50 {
            let cut = slot.starting_at(length * f64::from(k) / 50.0);
            assert_eq!(follows(&slot, &cut.segments), Ok(()), "{k}");
            assert_eq!(follows(&slot, &cut.reversed().segments), Ok(()), "{k}");
        }
    }

    /// Four arcs around a disc as a drawing with six decimals has them: the last one ends beside the circle that it begins on.
    fn disc_of_rounded_arcs() -> Path {
        let p = DVec2::new;
        let arc = |start, end, center| {
            Segment::Arc(Arc { start, end, center, sweep: -std::f64::consts::FRAC_PI_2 })
        };
        let [east, south, west, north] = [
            p(60.416_652, 49.071_419),
            p(55.416_732, 44.071_499),
            p(50.416_813, 49.071_419),
            p(55.416_732, 54.071_338),
        ];
        Path::new(
            vec![
                arc(east, south, p(55.416_732, 49.071_419)),
                arc(south, west, p(55.416_733_584, 49.071_419)),
                arc(west, north, p(55.416_732, 49.071_419)),
                arc(north, east, p(55.416_732, 49.071_417_283)),
            ],
            true,
        )
    }

    #[test]
    fn a_cut_that_begins_a_hair_before_the_end_of_an_element_follows() {
        let disc = disc_of_rounded_arcs();
        let length = disc.length();
        for k in -60..60 {
            let cut = disc.starting_at((length + 1e-7 * f64::from(k)) % length);
            assert_eq!(follows(&disc, &cut.segments), Ok(()), "{k}");
            assert_eq!(follows(&disc, &cut.reversed().segments), Ok(()), "{k}, backwards");
        }
    }

    /// An arc that ends farther from its centre than it begins is longer backwards.
    #[test]
    fn a_cut_along_an_arc_that_is_longer_backwards_follows() {
        let p = DVec2::new;
        let half = std::f64::consts::PI;
        let arc = Arc { start: p(1.0, 0.0), end: p(-1.000_001, 0.0), center: DVec2::ZERO, sweep: half };
        let line = Path::new(vec![Segment::Arc(arc)], false);
        let back = line.reversed();
        assert!((back.length() - line.length() - 1e-6 * half).abs() < 1e-9);
        assert_eq!(follows(&line, &back.segments), Ok(()));
    }

    #[test]
    fn parts_and_repeats_are_reported() {
        let whole = slot().starting_at(3.0).segments;
        let length = slot().length();
        assert!(matches!(
            follows(&slot(), &whole[..3]),
            Err(Fault::Length { worked, length: l }) if worked < length - 1.0 && (l - length).abs() < 1e-9
        ));
        let twice: Vec<Segment> = whole.iter().chain(&whole).copied().collect();
        assert!(
            matches!(follows(&slot(), &twice), Err(Fault::Length { worked, .. }) if worked > length * 1.9)
        );
        // Half of the contour there and back has the right length but does not follow it.
        let half = slot().starting_at(0.0).segments[..2].to_vec();
        let back: Vec<Segment> = half.iter().rev().map(Segment::reversed).collect();
        let there_and_back: Vec<Segment> = half.into_iter().chain(back).collect();
        assert!(matches!(follows(&slot(), &there_and_back), Err(Fault::Strays(_))));
    }

    #[test]
    fn other_shapes_stray() {
        let mut cut = slot().segments;
        cut[1] = Segment::line(DVec2::new(10.0, 0.0), DVec2::new(10.0, 4.0));
        assert!(matches!(follows(&slot(), &cut), Err(Fault::Strays(_))));
        let moved: Vec<Segment> = slot()
            .segments
            .iter()
            .map(|s| Segment::line(s.start() + DVec2::X * 1e-4, s.end() + DVec2::X * 1e-4))
            .collect();
        assert!(matches!(follows(&slot(), &moved), Err(Fault::Strays(_))));
    }

    #[test]
    fn open_contours_are_run_from_end_to_end() {
        let open = Path::new(slot().segments[..3].to_vec(), false);
        assert_eq!(follows(&open, &open.segments), Ok(()));
        assert_eq!(follows(&open, &open.reversed().segments), Ok(()));
        assert!(matches!(follows(&open, &open.segments[1..]), Err(Fault::Length { .. })));
    }

    /// Lens of two flat arcs between two points. Bulges range from nearly straight to round, at coordinates where fuzzing
    /// found faults (6e5 mm).
    fn lens(corner: DVec2, chord: DVec2, bulge: f64) -> Path {
        let (a, b) = (corner, corner + chord);
        let arc = |from, to| Segment::Arc(Arc::from_bulge(from, to, bulge).unwrap());
        Path::new(vec![arc(a, b), arc(b, a)], true)
    }

    #[test]
    fn sound_cuts_at_large_coordinates_and_radii_do_not_stray() {
        for corner in [DVec2::new(6e5, -3e5), DVec2::new(6.123e5, 5.9e5)] {
            for chord in [DVec2::new(0.37, 0.11), DVec2::new(-310.0, 77.0), DVec2::new(-3.3e5, 2.1e5)] {
                for bulge in [1e-9, 1e-7, 1e-5, 1e-3, 0.3, 1.0] {
                    let path = lens(corner, chord, bulge);
                    for k in 0..40 {
                        let cut = path.starting_at(path.length() * f64::from(k) / 40.0);
                        assert_eq!(follows(&path, &cut.segments), Ok(()), "{corner} {chord} {bulge} {k}");
                        assert_eq!(follows(&path, &cut.reversed().segments), Ok(()));
                        assert_eq!(follows(&path.reversed(), &cut.segments), Ok(()));
                    }
                }
            }
        }
    }

    #[test]
    fn faults_at_large_coordinates_are_reported() {
        // With a radius of 26 m, rounding may reach 9 nm.
        let path = lens(DVec2::new(6e5, -3e5), DVec2::new(-310.0, 77.0), 3e-3);
        let cut = path.starting_at(100.0).segments;
        let moved = |by: DVec2| -> Vec<Segment> {
            let moved = |s: &Segment| match *s {
                Segment::Arc(a) => {
                    Segment::Arc(Arc { start: a.start + by, end: a.end + by, center: a.center + by, ..a })
                }
                Segment::Line(l) => Segment::line(l.start + by, l.end + by),
            };
            cut.iter().map(moved).collect()
        };
        assert_eq!(follows(&path, &moved(DVec2::ZERO)), Ok(()));
        for by in [DVec2::X, DVec2::Y, DVec2::ONE] {
            assert!(matches!(follows(&path, &moved(by * 5e-6)), Err(Fault::Strays(_))));
        }
        assert!(matches!(follows(&path, &cut[..2]), Err(Fault::Length { .. })));
        let chords: Vec<Segment> = cut.iter().map(|s| Segment::line(s.start(), s.end())).collect();
        assert!(matches!(follows(&path, &chords), Err(Fault::Strays(_))));
    }

    #[test]
    fn circles_follow_from_any_point() {
        let circle = Path::new(vec![Segment::Arc(Arc::circle(DVec2::ONE, 5.0))], true);
        let turned = |a: f64, sweep: f64| vec![Segment::Arc(Arc::from_angles(DVec2::ONE, 5.0, a, sweep))];
        assert_eq!(follows(&circle, &circle.starting_at(11.0).reversed().segments), Ok(()));
        assert!(follows(&circle, &turned(0.0, 3.0)).is_err());
        assert!(follows(&circle, &turned(1.0, 3.0)).is_err());
    }
}
