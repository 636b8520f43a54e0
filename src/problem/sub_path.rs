//! A path through a pierce group: what the head does from the place where it arrives to the place where it leaves.
//!
//! The paths of a group are the nodes of its item. A solver of groups (`solve::pierce_group`) finds them. The solvers of
//! whole problems see their ends, their seconds, and the [`LeavePoint`]s where a path may be left for other items. The plan
//! writes the strokes out.
//!
//! A place on a path is the length cut before it, in mm. As on a closed contour, one number stands for both ends: 0.

use crate::geometry::{DVec2, Segment};

/// A path through all of a pierce group.
#[derive(Clone, Debug, PartialEq)]
pub struct SubPath {
    /// Where the head arrives and leaves, mm.
    pub ends: [DVec2; 2],
    /// The straight lead-in to where the first stroke cuts, if it has one: the head arrives at its beginning.
    pub lead_in: Option<Segment>,
    /// What the head does in between.
    pub strokes: Vec<Stroke>,
    /// The seconds of all strokes together.
    pub seconds: f64,
    /// Where it may be left for other items, in order; empty where the group is cut in one go.
    pub leave_points: Vec<LeavePoint>,
    /// By area of the group: the place on the path at which it has fallen out, mm; infinite for area 0, the one around the
    /// group. Empty if there are no leave points.
    pub falls: Vec<f64>,
}

/// A place between two elements where a path may be left for other items and resumed.
///
/// Within a run of the beam, leaving takes a pre-cut of the element that follows. It is possible only while nothing at that
/// node has come loose. Where the path makes an air move anyway, the head goes to other items from the beginning of that
/// move and comes back to its end: no pre-cut is needed, and the air move is saved.
#[derive(Clone, Debug, PartialEq)]
pub struct LeavePoint {
    /// Its place on the path: the length cut before, mm.
    pub along: f64,
    /// The node of the group where the head leaves.
    pub node: u32,
    /// Where the head leaves and where it returns to, mm.
    pub ends: [DVec2; 2],
    /// Seconds of leaving and resuming: the pre-cut and the stop of the beam, or the air move that is saved, as a negative
    /// number. Exact if the run of the beam is left at one place, or if the head reaches its full speed between two.
    pub seconds: f64,
    /// Number of strokes before it.
    pub strokes: usize,
    /// Number of stretches of the next stroke that are cut before it.
    pub spans: usize,
    /// The pre-cut from which the path is resumed; `None` where the path makes an air move anyway.
    pub pre_cut: Option<Stroke>,
}

impl SubPath {
    /// The leave point at a place; `None` at both ends of the path, and where it must not be left.
    #[expect(clippy::float_cmp, reason = "a stop has the place of its leave point bit for bit")]
    pub fn leave_point(&self, along: f64) -> Option<&LeavePoint> {
        if along == 0.0 {
            return None;
        }
        self.leave_points.iter().find(|p| p.along == along)
    }

    /// Where the head arrives to begin at a place, mm; `None` if the path cannot be resumed there.
    pub fn arrival(&self, along: f64) -> Option<DVec2> {
        if along == 0.0 { Some(self.ends[0]) } else { self.leave_point(along).map(|p| p.ends[1]) }
    }

    /// Where the head leaves the path at a place, mm; `None` if it must not be left there.
    pub fn departure(&self, until: f64) -> Option<DVec2> {
        if until == 0.0 { Some(self.ends[1]) } else { self.leave_point(until).map(|p| p.ends[0]) }
    }

    /// The place before which an item in an area of the group must be done; 0, which means before the group, if it is not
    /// known in which area it lies.
    pub fn due(&self, area: Option<u32>) -> f64 {
        area.and_then(|area| self.falls.get(area as usize)).copied().unwrap_or(0.0)
    }

    /// What the head does from one place to another, with the pre-cut from which the path is resumed.
    pub fn stretch(&self, along: f64, until: f64) -> Vec<Stroke> {
        let (from, to) = (self.leave_point(along), self.leave_point(until));
        // The air move at which a path was left is not made.
        let first = from.map_or((0, 0), |p| (p.strokes + usize::from(p.pre_cut.is_none()), p.spans));
        let last = to.map_or((self.strokes.len(), 0), |p| (p.strokes, p.spans));
        let mut out = Vec::new();
        for (k, stroke) in self.strokes.iter().enumerate().skip(first.0) {
            if (k, 0) >= last {
                break;
            }
            let skipped = if k == first.0 { first.1 } else { 0 };
            let end = if k == last.0 { last.1 } else { usize::MAX };
            out.push(stroke.part(skipped, end));
        }
        out.extend(to.and_then(|p| p.pre_cut.clone()));
        out
    }

    /// The stretches of contours that it cuts, in order.
    pub fn spans(&self) -> impl Iterator<Item = &Span> {
        self.strokes
            .iter()
            .flat_map(|s| if let Stroke::Cut { spans, .. } = s { spans.as_slice() } else { &[] })
    }
}

/// One action of the head in a group.
#[derive(Clone, Debug, PartialEq)]
pub enum Stroke {
    /// Moves through the air to a point, mm.
    Air(DVec2),
    /// Pierces.
    Pierce,
    /// The beam goes on as the next cut begins to move.
    MovingStart,
    /// Runs on to the next cut without stopping, with the beam off.
    Fly(Vec<Segment>),
    /// Cuts the beginning of a later stretch in advance, from where the head is.
    PreCut {
        /// The contour it is on.
        contour: u32,
        /// What is cut; empty where pre-cuts have no length.
        ahead: Vec<Segment>,
    },
    /// Cuts along elements of the group.
    Cut {
        /// The stretches of contours, in order.
        spans: Vec<Span>,
        /// The geometry of all of them, in the direction of travel.
        path: Vec<Segment>,
        /// Number of segments after those of the stretches that repeat the beginning of the cut.
        overcut: usize,
    },
}

impl Stroke {
    /// A cut along its stretches from number `first` to before number `end`; other strokes as they are.
    fn part(&self, first: usize, end: usize) -> Self {
        let Self::Cut { spans, path, overcut } = self else { return self.clone() };
        let end = end.min(spans.len());
        let again = if end == spans.len() { *overcut } else { 0 };
        let elements = |count: usize| spans.iter().take(count).map(|s| s.elements).sum::<usize>();
        Self::Cut {
            spans: spans.get(first..end).unwrap_or_default().to_vec(),
            path: path.get(elements(first)..elements(end) + again).unwrap_or_default().to_vec(),
            overcut: again,
        }
    }
}

/// A stretch of a contour in the direction of travel.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Span {
    /// Its contour.
    pub contour: u32,
    /// Arc length from the contour's stored start to where the stretch is entered, mm.
    pub along: f64,
    /// Arc length from the contour's stored start to where the stretch is left, mm.
    pub until: f64,
    /// Runs against the contour's stored direction.
    pub reversed: bool,
    /// Length, mm.
    pub length: f64,
    /// Number of segments of the path that belong to it.
    pub elements: usize,
}
