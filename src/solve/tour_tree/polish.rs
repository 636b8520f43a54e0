//! Exact entries: all stops slide along their tracks, one after the other (`slide.rs`), in rounds until a round gains
//! nothing worth while, and at last all together (`slide_together.rs`).

use super::config::CONFIG;
use super::slide::Slide;
use super::slide_together::{Base, slide_together};
use super::snapshot::TourSnapshot;
use super::tour::Tour;
use crate::solve::{Solution, Stop};

/// The solution of a tour, with entries at its places.
pub(super) fn unpolished(tour: &Tour, snapshot: &TourSnapshot) -> Solution {
    Solution::new(tour.space.problem, stops(tour, snapshot))
}

/// The stops of a tour, with entries at its places.
pub(super) fn stops(tour: &Tour, snapshot: &TourSnapshot) -> Vec<Stop> {
    // Home is a stop only where it is an item of the problem.
    let first = usize::from(tour.space.problem.table().is_none());
    snapshot.order[first..].iter().map(|&item| tour.space.stop(item, snapshot.at[item as usize])).collect()
}

/// The solution of a tour, with exact entries.
pub(super) fn polished(tour: &Tour, snapshot: &TourSnapshot) -> Solution {
    let space = &tour.space;
    if space.travel.by_table() {
        return unpolished(tour, snapshot);
    }
    let mut stops: Vec<Slide> =
        snapshot.order[1..].iter().map(|&item| Slide::new(space, item, snapshot.at[item as usize])).collect();
    let mut cost = f64::INFINITY;
    for _ in 0..CONFIG.entry.slide_rounds {
        for k in 0..stops.len() {
            let from = if k == 0 { space.problem.home } else { stops[k - 1].exit };
            let to = match stops.get(k + 1) {
                Some(next) => Some(next.entry),
                None => space.problem.closed.then_some(space.problem.home),
            };
            stops[k].slide(space, from, to);
        }
        let now = Solution::new(space.problem, stops.iter().map(|s| s.stop).collect()).cost;
        if now > cost * (1.0 - CONFIG.entry.slide_least_gain) {
            break;
        }
        cost = now;
    }
    slide_together(space, Base { at: space.problem.home, closed: space.problem.closed }, &mut stops);
    Solution::new(space.problem, stops.iter().map(|s| s.stop).collect())
}
