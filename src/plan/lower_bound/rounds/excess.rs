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
pub(in super::super) fn legs(walk: &[Visit], ground: &Ground) -> Vec<[Visit; 2]> {
    let mut from = Visit { item: 0, knot: 0 };
    let mut legs = Vec::with_capacity(walk.len() + 1);
    for &to in walk {
        legs.push([from, to]);
        from = if ground.items[to.item].paired { Visit { knot: to.knot ^ 1, ..to } } else { to };
    }
    legs.push([from, Visit { item: ground.first - 1, knot: 0 }]);
    legs
}

/// What a walk takes without charges, s, if home is one point.
pub(super) fn seconds(walk: &[Visit], ground: &Ground) -> f64 {
    let seconds =
        |[from, to]: [Visit; 2]| ground.leg(from, to).unwrap_or_else(|| ground.gap(from.item, to.item));
    legs(walk, ground).into_iter().map(seconds).sum()
}
