//! The average leg of a problem, by which the bounds for hundreds of contours measure their temperatures.

use super::halving;
use super::net::Item;
use super::pairs::Pairs;
use super::prices::Prices;
use crate::geometry::DVec2;

/// What items pay at first is about an average leg, unless pieces are long beside the ways between contours: then the numbers between their
/// knots are far too small, or even negative. That is so below this share of the way to the nearest contour.
const ROUGHLY: f64 = 0.1;

/// The seconds of an average leg, above 0. `paid`: what an item pays at first, in the mean.
pub(super) fn average_leg(paid: f64, items: &[Item], pairs: &Pairs, prices: &Prices) -> f64 {
    let nearest = if prices.given() { 0.0 } else { nearest(items, pairs, prices) };
    (if paid < ROUGHLY * nearest { nearest } else { paid }).max(1e-9)
}

/// The seconds between the nearest knots of an item and any other with which it is paired, in the mean.
fn nearest(items: &[Item], pairs: &Pairs, prices: &Prices) -> f64 {
    let places: Vec<Vec<DVec2>> = items.iter().map(halving::places).collect();
    let mut nearest = vec![f64::INFINITY; items.len()];
    for pair in &pairs.list {
        let [from, to] = pair.items.map(|k| &places[k]);
        let legs = from.iter().flat_map(|&p| to.iter().map(move |&q| (p, q)));
        let least = legs.map(|(p, q)| prices.minorant.air().seconds(p, q)).fold(f64::INFINITY, f64::min);
        pair.items.iter().for_each(|&k| nearest[k] = nearest[k].min(least));
    }
    nearest.iter().filter(|s| s.is_finite()).sum::<f64>() / nearest.len() as f64
}
