//! The cut of a contour with its leads: lead-in, contour, overcut or gap, lead-out, without switching the beam in between.

use crate::geometry::{Path, Segment};

/// The leads of one entry.
#[derive(Clone, Debug, PartialEq, Default)]
pub struct Lead {
    /// From the place of piercing to the contour; empty for none.
    pub lead_in: Vec<Segment>,
    /// Length cut twice at the entry, mm; negative: left uncut before it.
    pub overcut: f64,
    /// From where the contour ends; empty for none.
    pub lead_out: Vec<Segment>,
    /// A straight cut through waste to where the lead-in begins, from a kerf or from the edge of the sheet, where nothing is
    /// pierced. It is no part of the cut.
    pub approach: Option<Segment>,
}

/// The elements of a cut, with how many of them are not the contour itself.
#[derive(Clone, Debug, PartialEq, Default)]
pub struct Run {
    /// All elements in order.
    pub path: Vec<Segment>,
    /// Number of elements of the lead-in, which come first.
    pub lead_in: usize,
    /// Number of elements of the overcut, which come after the contour.
    pub overcut: usize,
    /// Number of elements of the lead-out, which come last.
    pub lead_out: usize,
}

impl Lead {
    /// Whether the contour is cut once around and nothing else.
    pub fn is_bare(&self) -> bool {
        self.lead_in.is_empty() && self.lead_out.is_empty() && self.overcut.total_cmp(&0.0).is_eq()
    }

    /// Where a run around a closed contour of `length` mm ends if it is entered at `along`: the arc length from the
    /// contour's start, mm.
    pub(super) fn end(overcut: f64, along: f64, length: f64) -> f64 {
        (along + overcut).rem_euclid(length)
    }

    /// The whole cut of a closed contour that is entered `along` mm from its start.
    pub fn run(&self, contour: &Path, along: f64) -> Run {
        let end = Self::end(self.overcut, along, contour.length());
        let mut path = self.lead_in.clone();
        let mut overcut = 0;
        if self.overcut < 0.0 {
            path.extend(contour.between(along, end));
        } else {
            path.extend(contour.starting_at(along).segments);
            if self.overcut > 0.0 {
                let again = contour.between(along, end);
                overcut = again.len();
                path.extend(again);
            }
        }
        path.extend(&self.lead_out);
        Run { path, lead_in: self.lead_in.len(), overcut, lead_out: self.lead_out.len() }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::{Arc, DVec2};

    fn square() -> Path {
        let corners = [[0.0, 0.0], [10.0, 0.0], [10.0, 10.0], [0.0, 10.0]].map(DVec2::from_array);
        Path::new((0..4).map(|k| Segment::line(corners[k], corners[(k + 1) % 4])).collect(), true)
    }

    fn length(path: &[Segment]) -> f64 {
        path.iter().map(Segment::length).sum()
    }

    #[test]
    fn an_overcut_is_cut_twice_and_a_gap_is_left() {
        let circle = Path::new(vec![Segment::Arc(Arc::circle(DVec2::new(3.0, 4.0), 5.0))], true);
        for contour in [square(), circle] {
            let whole = contour.length();
            for along in [0.0, 3.0, 20.0, whole - 0.5] {
                for overcut in [-2.0, 0.0, 0.7, 4.0] {
                    let lead = Lead { overcut, ..Lead::default() };
                    let run = lead.run(&contour, along);
                    assert!((length(&run.path) - whole - overcut).abs() < 1e-9, "{along} {overcut}");
                    assert_eq!(run.overcut > 0, overcut > 0.0);
                    let end = contour.at((along + overcut).rem_euclid(whole)).unwrap();
                    assert!(run.path.last().unwrap().end().distance(end) < 1e-9);
                    for pair in run.path.windows(2) {
                        assert!(pair[0].end().distance(pair[1].start()) < 1e-9);
                    }
                }
            }
        }
    }

    #[test]
    fn leads_join_the_contour() {
        let at = DVec2::new(5.0, 0.0);
        let line = |from: DVec2, to: DVec2| vec![Segment::line(from, to)];
        let lead = Lead {
            lead_in: line(DVec2::new(5.0, -3.0), at),
            overcut: 1.0,
            lead_out: line(DVec2::new(6.0, 0.0), DVec2::new(6.0, -2.0)),
            approach: None,
        };
        let run = lead.run(&square(), 5.0);
        assert_eq!((run.lead_in, run.overcut, run.lead_out), (1, 1, 1));
        assert!((length(&run.path) - (3.0 + 40.0 + 1.0 + 2.0)).abs() < 1e-12);
        assert!(run.path.windows(2).all(|p| p[0].end() == p[1].start()));
    }
}
