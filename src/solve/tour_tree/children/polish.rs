//! Exact entries for child routes: stops and anchors slide along their tracks, as the stops of a tour do.

use super::super::config::CONFIG;
use super::super::index::index;
use super::super::slide::Slide;
use super::super::slide_together::{Base, slide_together};
use super::super::space::Space;
use super::tree::Tree;
use crate::solve::Solution;
use std::iter::successors;

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
    let together = slid_together(space, tree, &slides);
    let ordered = (0..space.home).all(|item| in_order(space, tree, &together, item));
    solution(if ordered { &together } else { &slides })
}

/// The same with the stops of each route slid together, whatever their order along their items.
fn slid_together<'p>(space: &Space<'p>, tree: &Tree, slides: &[Option<Slide<'p>>]) -> Vec<Option<Slide<'p>>> {
    let mut together = slides.to_vec();
    for start in (space.home..=2 * space.home).filter(|&t| tree.is_live(t)) {
        let touches: Vec<u32> =
            successors(Some(tree.next(start)), |&t| Some(tree.next(t))).take_while(|&t| t != start).collect();
        let mut stops: Vec<Slide> = touches.iter().filter_map(|&t| together[t as usize].clone()).collect();
        // An anchor stays: its route leaves it and comes back.
        let base = slides[start as usize].as_ref().map_or(
            Base { at: space.problem.home, closed: space.problem.closed },
            |anchor| Base { at: anchor.exit, closed: true },
        );
        slide_together(space, base, &mut stops);
        for (&t, stop) in touches.iter().zip(stops) {
            together[t as usize] = Some(stop);
        }
    }
    together
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
