//! The items nearest to an item on the sheet, found when they are asked for: few are.

use crate::geometry::{Aabb, Buckets, DVec2};
use crate::problem::{Item, ItemId, Problem};

/// Neighbours of an item; where cuts heat each other, as many again that are near, but not too near.
const COUNT: usize = 6;

/// By item: its nearest items, by the places of their first nodes.
pub(super) struct Neighbours<'p> {
    problem: &'p Problem,
    places: Vec<Option<DVec2>>,
    grid: Option<Buckets>,
    lists: Vec<Option<Vec<ItemId>>>,
}

impl<'p> Neighbours<'p> {
    pub(super) fn new(problem: &'p Problem) -> Self {
        let place = |item: &Item| problem.nodes.get(item.nodes.start as usize).map(|n| n.entry);
        let places: Vec<_> = problem.items.iter().map(|i| place(i).filter(|_| !i.nodes.is_empty())).collect();
        Self { problem, lists: vec![None; places.len()], places, grid: None }
    }

    /// The neighbours of an item.
    pub(super) fn of(&mut self, item: ItemId) -> &[ItemId] {
        if self.lists.get(item as usize).is_some_and(Option::is_none) {
            let mut list = self.nearest(item, |_| true);
            if let Some(cooling) = self.problem.cooling() {
                // What is cut next to an item is best one that is near, but not too near.
                list.extend(self.nearest(item, |other| !cooling.are_near(item, other)));
            }
            if let Some(place) = self.lists.get_mut(item as usize) {
                *place = Some(list);
            }
        }
        self.lists.get(item as usize).and_then(Option::as_deref).unwrap_or_default()
    }

    /// The nearest items of those that are wanted.
    fn nearest(&mut self, item: ItemId, wanted: impl Fn(ItemId) -> bool) -> Vec<ItemId> {
        let Some(place) = self.places.get(item as usize).copied().flatten() else { return Vec::new() };
        let places = &self.places;
        let grid = self.grid.get_or_insert_with(|| grid(places));
        let mut found: Vec<(f64, ItemId)> = Vec::new();
        for ring in 0..grid.rings(place) {
            let far = grid.distance_of_ring(ring);
            if found.len() >= COUNT && found.get(COUNT - 1).is_some_and(|f| f.0 <= far * far) {
                break;
            }
            let here = grid.ring(place, ring).filter(|&other| other != item && wanted(other));
            found.extend(here.filter_map(|other| {
                let other_place = places.get(other as usize).copied().flatten()?;
                Some((other_place.distance_squared(place), other))
            }));
            found.sort_unstable_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
            found.truncate(COUNT);
        }
        found.into_iter().map(|f| f.1).collect()
    }
}

/// The places on a grid.
fn grid(places: &[Option<DVec2>]) -> Buckets {
    let bounds = places.iter().flatten().fold(Aabb::EMPTY, |b, &p| b.with(p));
    let mut grid = Buckets::new(bounds, places.len());
    for (id, place) in (0..).zip(places) {
        if let Some(place) = place {
            grid.insert(id, *place);
        }
    }
    grid
}
