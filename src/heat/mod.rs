//! Heat: which cuts are near each other, and what it costs if they follow each other too soon.
//!
//! Two cuts are *near* if their lines come nearer to each other than the machine's distance (`machine::Heat`), leads aside. Near cuts
//! should have the machine's seconds between the end of one and the beginning of the other, which is where the head pierces.
//! Otherwise the head waits, or the search pays a charge for the pair ([`Cooling::due`]).
//!
//! Nothing here knows contours, so that the search can use it.

mod near;

use crate::geometry::{Aabb, BoxIndex, DVec2, Path};
use crate::machine::{Heat, PLANS_ALL_LEVERS, SAME_HEAT};
use near::Places;
use rustc_hash::FxHashSet;

/// Which cuts are near each other, and how long they stay hot.
#[derive(Debug)]
pub struct Cooling {
    distance: f64,
    seconds: f64,
    charge: Option<f64>,
    /// By item: its bounds and its first place; `None` for an item that heats nothing.
    boxes: Vec<Option<(Aabb, DVec2)>>,
    /// Pairs, the smaller number first, that are near although their first places are not.
    near: FxHashSet<(u32, u32)>,
}

/// What is due before a cut begins.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Due {
    /// Seconds that the head waits.
    pub wait: f64,
    /// Cuts near it that are still hot when it begins.
    pub hot: u32,
}

impl Cooling {
    /// The cuts of a machine that minds heat: by item its line, `None` for what is no cut. `None` if no pair of cuts matters.
    pub fn new(heat: &Heat, lines: &[Option<&Path>]) -> Option<Self> {
        if !PLANS_ALL_LEVERS || !heat.minds_pairs() {
            return None;
        }
        let distance = heat.distance - SAME_HEAT;
        let places: Vec<Option<Places>> = lines.iter().map(|l| l.and_then(Places::new)).collect();
        let boxes: Vec<_> = places.iter().map(|p| p.as_ref().map(|p| (p.bounds(), p.first()))).collect();
        let index = BoxIndex::new(boxes.iter().map(|b| b.map_or(Aabb::EMPTY, |b| b.0)));
        let mut all =
            Self { distance, seconds: heat.seconds, charge: heat.charge, boxes, near: FxHashSet::default() };
        for (a, known) in (0_u32..).zip(&places) {
            let Some(known) = known else { continue };
            index.visit(known.bounds().grown(distance), |other| {
                let b = u32::try_from(other).unwrap_or(u32::MAX);
                if a < b
                    && all.by_box(a, b).is_none()
                    && places
                        .get(other)
                        .is_some_and(|o| o.as_ref().is_some_and(|o| known.are_near(o, distance)))
                {
                    all.near.insert((a, b));
                }
                true
            });
        }
        Some(all)
    }

    /// Seconds from the end of a cut to the beginning of one near it.
    pub fn seconds(&self) -> f64 {
        self.seconds
    }

    /// Whether the head waits for near cuts; otherwise each pair has a charge.
    pub fn waits(&self) -> bool {
        self.charge.is_none()
    }

    /// Whether two items are near each other. An item is not near itself.
    pub fn are_near(&self, a: u32, b: u32) -> bool {
        let (a, b) = (a.min(b), a.max(b));
        self.by_box(a, b).unwrap_or_else(|| self.near.contains(&(a, b)))
    }

    /// What boxes and first places say; `None` if that is not enough.
    fn by_box(&self, a: u32, b: u32) -> Option<bool> {
        let of = |k: u32| self.boxes.get(k as usize).copied().flatten();
        let Some(((x, p), (y, q))) = of(a).zip(of(b)).filter(|_| a != b) else { return Some(false) };
        let gap = (x.min - y.max).max(y.min - x.max).max(DVec2::ZERO);
        let limit = self.distance * self.distance;
        if gap.length_squared() >= limit {
            return Some(false);
        }
        (p.distance_squared(q) < limit).then_some(true)
    }

    /// What is due before an item that the head reaches at `arrival`, s. `before`: the items cut before it with the seconds at which
    /// they ended, the last first.
    pub fn due(&self, item: u32, arrival: f64, before: impl Iterator<Item = (u32, f64)>) -> Due {
        let mut due = Due::default();
        for (other, end) in before {
            if arrival - end >= self.seconds - SAME_HEAT {
                break;
            }
            if self.are_near(item, other) {
                if self.waits() {
                    // The others ended before it.
                    due.wait = end + self.seconds - arrival;
                    break;
                }
                due.hot += 1;
            }
        }
        due
    }

    /// The seconds that the search counts for what is due.
    pub fn cost(&self, due: Due) -> f64 {
        self.charge.map_or(due.wait, |charge| charge * f64::from(due.hot))
    }
}
