//! Nested visits made an allowed path: what lies inside a contour is finished before it.
//!
//! Outer contours first: a contour that is finished too late is taken out, all its visits, and put back whole before the
//! last visit of what it lies in, at the cheapest place there, entered where it was. What was cut while it was left is then
//! cut without leaving it, so visits still nest.

use super::model::{Model, Visit};

/// Places looked at for each contour that moves, the nearest to its outer contour's last visit: a contour inside is near
/// that visit more often than not, and 10,000 holes times 16 places are a few milliseconds.
const PLACES: usize = 16;

/// The path of these visits in which every contour is finished before the one around it. `inwards`: contours that lie in
/// others, outer ones first. `start`: visits before this one stay before all that moves.
pub(super) fn finished_inside_first(
    model: &Model,
    inwards: &[u32],
    visits: &[Visit],
    start: usize,
) -> Vec<Visit> {
    let items = &model.problem().items;
    // First and last visit of each contour of these visits.
    let mut spans: Vec<Option<(usize, usize)>> = vec![None; items.len()];
    for (k, visit) in visits.iter().enumerate().skip(start) {
        let span = &mut spans[model.item(visit.enter) as usize];
        *span = Some((span.map_or(k, |s| s.0), k));
    }
    // Where each moves to: before the visit of that index.
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
    // Those of one place: what lies inside comes later in `inwards` and is cut earlier.
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
