//! What a walk is charged for: how far it is from a tour.

use super::super::charges::{Charges, Cut, HAS_CUTS};
use super::super::walks::{Ground, Visit};

/// Stops at each item, less one; and for each cut two, less the legs of the walk across it.
pub(super) fn excess(walk: &[Visit], charges: &Charges, first: usize) -> Vec<f64> {
    let mut excess = vec![-1.0; charges.items()];
    excess[..first].fill(0.0);
    walk.iter().for_each(|v| excess[v.item] += 1.0);
    if HAS_CUTS {
        excess.extend(charges.cuts().iter().map(|cut| 2.0 - crossings(walk, cut)));
    }
    excess
}

/// How many legs of a walk cross a cut.
pub(super) fn crossings(walk: &[Visit], cut: &Cut) -> f64 {
    let (mut inside, mut legs) = (false, 0.0);
    for now in walk.iter().map(|v| cut[v.item]).chain([false]) {
        legs += if now == inside { 0.0 } else { 1.0 };
        inside = now;
    }
    legs
}

/// The legs of a walk from home and back to it, between the knots where they start and end.
pub(super) fn legs<'w>(walk: &'w [Visit], ground: &'w Ground) -> impl Iterator<Item = [Visit; 2]> + 'w {
    let [start, end] = [0, ground.first - 1].map(|item| Visit { item, knot: 0 });
    let left = |v: &Visit| if ground.items[v.item].paired { Visit { knot: v.knot ^ 1, ..*v } } else { *v };
    let from = std::iter::once(start).chain(walk.iter().map(left));
    from.zip(walk.iter().copied().chain([end])).map(|(from, to)| [from, to])
}

/// What a walk takes without charges, s.
pub(super) fn seconds(walk: &[Visit], ground: &Ground) -> f64 {
    legs(walk, ground).map(|[from, to]| ground.leg(from, to)).sum()
}
