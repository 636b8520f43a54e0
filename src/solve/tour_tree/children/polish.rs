//! Exact entries for child routes: stops and anchors slide along their tracks, as the stops of a tour do.

use super::super::config::CONFIG;
use super::super::index::index;
use super::super::polish::Slide;
use super::super::space::Space;
use super::tree::Tree;
use crate::solve::Solution;

/// The solution of the routes, with exact entries.
pub(super) fn polished(space: &Space, tree: &Tree) -> Solution {
    let touches = (0..=2 * space.home).map(|t| {
        let stands = tree.is_live(t) && t != space.home;
        stands.then(|| match tree.leave_place(space, t) {
            Some(place) => Slide::fixed(space, tree.item(t), place),
            None => Slide::new(space, tree.item(t), tree.at(t)),
        })
    });
    let mut slides: Vec<Option<Slide>> = touches.collect();
    let solution = |slides: &[Option<Slide>]| {
        let along = |t: u32| slides[t as usize].as_ref().map_or(0.0, |s| s.stop.along);
        Solution::new(space.problem, tree.stops(space, along))
    };
    let mut cost = f64::INFINITY;
    for _ in 0..CONFIG.entry.slide_rounds {
        for t in 0..index(slides.len()) {
            let Some(mut slide) = slides[t as usize].clone() else { continue };
            let end = |t: u32| slides[t as usize].as_ref();
            let from = end(tree.previous(t)).map_or(space.problem.home, |s| s.exit);
            let next = tree.next(t);
            let to = end(next).map_or(space.problem.home, |s| s.entry);
            let to = Some(to).filter(|_| next != space.home || space.problem.closed);
            slide.slide(space, from, to);
            let before = slides[t as usize].replace(slide);
            if !in_order(space, tree, &slides, tree.item(t)) {
                slides[t as usize] = before;
            }
        }
        let now = solution(&slides).cost;
        if now > cost * (1.0 - CONFIG.entry.slide_least_gain) {
            break;
        }
        cost = now;
    }
    solution(&slides)
}

/// Whether the anchors of an item are in the same order along it as before.
fn in_order(space: &Space, tree: &Tree, slides: &[Option<Slide>], item: u32) -> bool {
    let along = |t: u32| slides[t as usize].as_ref().map_or(0.0, |s| s.stop.along);
    let perimeter = space.perimeter(item);
    let mut last = 0.0;
    perimeter <= 0.0
        || tree.anchors(item).iter().all(|&k| {
            let ahead = (along(k) - along(item)).rem_euclid(perimeter);
            let fits = ahead >= last;
            last = ahead;
            fits
        })
}
