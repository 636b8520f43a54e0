//! Kicks that cut long legs, for items in groups that lie far apart.
//!
//! Where items stand in groups, the few legs from group to group are much of the tour. A kick at random places nearly always
//! cuts short legs, and at a temperature that suits those no other way from group to group is accepted. So a share of the
//! kicks looks for a long leg around each of its three cuts, and is judged at a temperature that suits the legs it cuts. The
//! share grows with that of long legs in the tour: where all legs are alike there are no such kicks.

use super::config::CONFIG;
use super::exchange::{Stretches, draw_stretches};
use super::tour::Tour;
use crate::solve::rng::{Draw, Rng};

#[cfg(test)]
mod tests;

/// The percentage of kicks that cut long legs, for a tour whose legs take `mean_leg` seconds on average.
pub(super) fn percentage_of_kicks(tour: &Tour, mean_leg: f64) -> usize {
    let (mut long, mut all) = (0.0, 0.0);
    for position in 0..=tour.last() {
        // A leg that saves time is not long.
        let leg = tour.leg_from(position).max(0.0);
        all += leg;
        long += if leg > CONFIG.long_legs.least * mean_leg { leg } else { 0.0 };
    }
    let share = if all > 0.0 { CONFIG.long_legs.kicks_per_share * long / all } else { 0.0 };
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a small number from 0 on")]
    ((100.0 * share) as usize).min(CONFIG.long_legs.most_percent)
}

/// Draws two stretches, and puts each of their three ends at the longest of some legs that are drawn around it.
pub(super) fn draw_between_long_legs(tour: &Tour, rng: &mut Rng) -> Option<Stretches> {
    let Stretches { from, middle, to } = draw_stretches(tour, rng, CONFIG.long_legs.longest)?;
    let (one, two) = (middle + 1 - from, to - middle);
    // The ends stay on their sides of the middle of each stretch, so that none becomes empty.
    let (half_one, half_two) = (from - 1 + one / 2, middle + two / 2);
    let before = longest_leg(tour, rng, (from - 1).saturating_sub(one), half_one);
    let between = longest_leg(tour, rng, half_one + 1, half_two);
    let after = longest_leg(tour, rng, half_two + 1, (to + two).min(tour.last()));
    Some(Stretches { from: before + 1, middle: between, to: after })
}

/// The position from which the longest of some legs leaves that are drawn between two positions.
fn longest_leg(tour: &Tour, rng: &mut Rng, from: usize, to: usize) -> usize {
    let mut longest = from;
    for _ in 0..CONFIG.long_legs.tries {
        let position = from + rng.below(to + 1 - from);
        if tour.leg_from(position) > tour.leg_from(longest) {
            longest = position;
        }
    }
    longest
}

/// How much hotter than others a kick is judged: as much as the three legs that it cuts are longer than mean legs.
pub(super) fn heat(tour: &Tour, stretches: Stretches, mean_leg: f64) -> f64 {
    let Stretches { from, middle, to } = stretches;
    let cut: f64 = [from - 1, middle, to].into_iter().map(|position| tour.leg_from(position)).sum();
    if mean_leg > 0.0 { (cut / (3.0 * mean_leg)).max(1.0) } else { 1.0 }
}
