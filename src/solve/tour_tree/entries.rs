//! All entries of an order at once: the cheapest way through layers of places, one layer an item.
//!
//! A dynamic programme over the order (layer by layer, for each place the least cost so far), once for every place of
//! home. Local moves change one entry at a time; this finds what only pays together. Not for items with places all
//! along a track, which slide (`polish.rs`).
//! Source: the cluster optimisation of Fischetti, Salazar & Toth, Operations Research 45 (1997).

use super::space::index;
use super::tour::Tour;
use super::travel::Place;

/// Enters every item where the whole tour costs least; gives the seconds gained. `changed` hears of each item that
/// is entered elsewhere.
pub(super) fn enter_best(tour: &mut Tour, cost: f64, mut changed: impl FnMut(u32)) -> f64 {
    let home = tour.space.home;
    let items: Vec<u32> = (1..=tour.last()).map(|p| tour.item(p)).collect();
    let (mut least, mut best) = (cost, Vec::new());
    for start in 0..index(tour.space.places(home).len()) {
        // The places where the layer before is left, and what each has cost.
        let mut reached: Vec<(Place, f64)> = vec![(tour.space.exit(home, start), 0.0)];
        let mut from: Vec<Vec<u32>> = Vec::with_capacity(items.len());
        for &item in &items {
            let mut next = Vec::with_capacity(tour.space.places(item).len());
            let mut via = Vec::with_capacity(next.capacity());
            tour.priced += (reached.len() * tour.space.places(item).len() / 8) as u64;
            for at in 0..index(tour.space.places(item).len()) {
                let entry = tour.space.places(item)[at as usize];
                let (cost, k) = cheapest(&reached, |p| tour.space.travel.seconds(p, entry));
                next.push((tour.space.exit(item, at), cost + tour.space.extra(item, at)));
                via.push(k);
            }
            reached = next;
            from.push(via);
        }
        let end = tour.space.places(home)[start as usize];
        let (total, mut k) = cheapest(&reached, |p| tour.way(p, home, end));
        if total < least {
            least = total;
            best.clear();
            for via in from.iter().rev() {
                best.push(k);
                k = via[k as usize];
            }
            best.push(start);
        }
    }
    let visited = items.iter().rev().chain([&home]);
    for (&item, &at) in visited.zip(&best).filter(|(i, at)| tour.at(**i) != **at).collect::<Vec<_>>() {
        tour.enter(item, at);
        changed(item);
    }
    cost - least
}

/// The least cost by way of one of the places reached, and which.
fn cheapest(reached: &[(Place, f64)], way: impl Fn(Place) -> f64) -> (f64, u32) {
    let costs = reached.iter().map(|&(p, cost)| cost + way(p));
    let least = (0..).zip(costs).fold(
        (f64::INFINITY, 0),
        |least, (k, cost)| {
            if cost < least.0 { (cost, k) } else { least }
        },
    );
    (least.0, least.1)
}
