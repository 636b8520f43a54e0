//! What the patterns of fly cuts share: the contours, and the seconds of a way through them.

use crate::geometry::{DVec2, Segment};
use crate::machine::{AirTime, Fly, Process, Profile, cut_time};
use crate::order::{real, sort_by};
use crate::problem::seconds::seconds_alone;
use crate::problem::sub_path::{Stroke, SubPath};
use crate::sheet::{Contour, Sheet};
use crate::tipping::Zones;

/// Contours that are cut on the run, and the ways through them: each is followed by the same way back.
pub(super) struct Flown {
    pub(super) contours: Vec<u32>,
    pub(super) ways: Vec<SubPath>,
    /// Seconds less than one by one.
    pub(super) saved: f64,
}

impl Flown {
    /// Whether no move with the beam off crosses a piece that may tip, whichever of them are free by then.
    pub(super) fn is_clear(&self, zones: &Zones) -> bool {
        let crosses = |from, to| zones.crosses(from, to, |_| true);
        self.ways.iter().all(|way| {
            let mut head = way.ends[0];
            way.strokes.iter().all(|stroke| {
                let from = head;
                match stroke {
                    Stroke::Air(to) => {
                        head = *to;
                        !crosses(from, *to)
                    }
                    Stroke::Fly(path) => {
                        head = path.last().map_or(head, Segment::end);
                        !path.iter().any(|s| crosses(s.start(), s.end()))
                    }
                    Stroke::Cut { path, .. } => {
                        head = path.last().map_or(head, Segment::end);
                        true
                    }
                    Stroke::Pierce | Stroke::MovingStart | Stroke::PreCut { .. } => true,
                }
            })
        })
    }
}

/// What both patterns need: the contours and their seconds.
pub(super) struct Work<'s> {
    pub(super) sheet: &'s Sheet,
    pub(super) machine: &'s Profile,
    pub(super) lever: Fly,
    pub(super) process: Process,
    pub(super) air: AirTime,
}

impl Work<'_> {
    pub(super) fn contour(&self, id: u32) -> Option<&Contour> {
        self.sheet.contours.get(id as usize)
    }

    /// A way of these strokes from a place to another, with its seconds.
    pub(super) fn way(&self, strokes: Vec<Stroke>) -> Option<SubPath> {
        let start =
            strokes.iter().find_map(|s| if let Stroke::Cut { path, .. } = s { path.first() } else { None });
        let start = start?.start();
        let (mut head, mut seconds) = (start, 0.0);
        let mut motion: Vec<Segment> = Vec::new();
        for (k, stroke) in strokes.iter().enumerate() {
            match stroke {
                Stroke::Air(to) => {
                    seconds += self.air.seconds(head, *to);
                    head = *to;
                }
                Stroke::Cut { path, .. } | Stroke::Fly(path) => {
                    motion.extend(path);
                    head = path.last().map_or(head, Segment::end);
                    if !matches!(strokes.get(k + 1), Some(Stroke::Cut { .. } | Stroke::Fly(_))) {
                        seconds +=
                            cut_time(self.machine, &self.process, &motion) + self.machine.delays_of_cut(true);
                        motion.clear();
                    }
                }
                Stroke::Pierce | Stroke::MovingStart | Stroke::PreCut { .. } => {}
            }
        }
        let ends = [start, head];
        Some(SubPath { ends, lead_in: None, strokes, seconds, leave_points: Vec::new(), falls: Vec::new() })
    }

    /// Contours as one group, if that saves seconds. `hop`: the least distance between two of them that follow each other, mm.
    pub(super) fn flown(&self, mut contours: Vec<u32>, ways: Vec<SubPath>, hop: f64) -> Option<Flown> {
        let alone = |id: &u32| self.contour(*id).map_or(0.0, |c| seconds_alone(self.sheet, self.machine, c));
        let hops = contours.len().saturating_sub(1) as f64;
        // Along either axis a move is not faster than along both.
        let hop = self
            .air
            .seconds(DVec2::ZERO, DVec2::new(hop, 0.0))
            .min(self.air.seconds(DVec2::ZERO, DVec2::new(0.0, hop)));
        let alone = contours.iter().map(alone).sum::<f64>() + hops * hop;
        let least = ways.iter().map(|w| w.seconds).fold(f64::INFINITY, f64::min);
        sort_by(&mut contours, |&c| [c.into(), 0, 0]);
        let saved = alone - least;
        (saved > 0.0).then_some(Flown { contours, ways, saved })
    }
}

/// The distance between two boxes along the farther axis, mm.
pub(super) fn apart(a: &Contour, b: &Contour) -> f64 {
    let gap = (a.bounds.min - b.bounds.max).max(b.bounds.min - a.bounds.max);
    gap.max_element().max(0.0)
}

/// Sorts by two numbers.
pub(super) fn sort_by_two<T>(items: &mut Vec<T>, numbers: impl Fn(&T) -> [f64; 2]) {
    sort_by(items, |item| {
        let [a, b] = numbers(item);
        [real(a), real(b), 0]
    });
}
