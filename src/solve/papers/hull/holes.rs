//! Repairs nested visits so that what lies inside a contour is finished before it.
//!
//! Outer contours come first. A contour that is finished too late is removed, with all its visits, and inserted as a whole
//! before the last visit of the contour around it: at the cheapest place there, entered where it was before. Contours that
//! were cut while it was left unfinished are then cut without leaving it, so visits still nest.

use super::model::{Model, Visit};

/// Number of places tried for each contour that moves: those nearest to the last visit of its outer contour, as a contour
/// inside is usually near that visit. 16 places for 10,000 holes take a few milliseconds.
const PLACES: usize = 16;

/// The path of these visits in which every contour is finished before the one around it. `inwards` lists the contours that
/// lie inside others, outer ones first. Visits before `start` stay before everything that moves.
pub(super) fn finished_inside_first(
    model: &Model,
    inwards: &[u32],
    visits: &[Visit],
    start: usize,
) -> Vec<Visit> {
    let items = &model.problem().items;
    // First and last visit of each contour.
    let mut spans: Vec<Option<(usize, usize)>> = vec![None; items.len()];
    for (k, visit) in visits.iter().enumerate().skip(start) {
        let span = &mut spans[model.item(visit.enter) as usize];
        *span = Some((span.map_or(k, |s| s.0), k));
    }
    // For each contour that moves, the index of the visit before which it goes.
    let mut to: Vec<Option<usize>> = vec![None; items.len()];
    let mut moved: Vec<(usize, u32)> = Vec::new();
    for &item in inwards {
        let outer = items[item as usize].before.map_or(item, |o| o) as usize;
        let (Some((first, last)), Some((_, end))) = (spans[item as usize], spans[outer]) else { continue };
        let limit = to[outer].unwrap_or(end);
        if last < limit {
            continue;
        }
        let node = visits[first].enter;
        let price = |k: usize| {
            let before = k.checked_sub(1).map(|k| visits[k].leave);
            let after = Some(visits[k].enter);
            model.gap(before, Some(node)) + model.gap(Some(node), after) - model.gap(before, after)
        };
        let places = (start.max((limit + 1).saturating_sub(PLACES))..=limit).map(|k| (price(k), k));
        let Some((_, place)) = places.reduce(|a, b| if b.0 <= a.0 { b } else { a }) else { continue };
        to[item as usize] = Some(place);
        moved.push((place, item));
    }
    if moved.is_empty() {
        return visits.to_vec();
    }
    // At the same place, inner contours come later in `inwards` and are cut earlier.
    moved.reverse();
    crate::order::sort_by(&mut moved, |m| [m.0 as u64, 0, 0]);
    let mut moved = moved.into_iter().peekable();
    let mut out = Vec::with_capacity(visits.len());
    for (k, &visit) in visits.iter().enumerate() {
        while let Some((_, item)) = moved.next_if(|m| m.0 == k) {
            let node = spans[item as usize].map(|s| visits[s.0].enter);
            out.extend(node.map(|n| Visit { enter: n, leave: n }));
        }
        if k < start || to[model.item(visit.enter) as usize].is_none() {
            out.push(visit);
        }
    }
    out
}
