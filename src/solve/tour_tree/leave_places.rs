//! The places where paths through pierce groups may be left for other items, laid out for the search.
//!
//! A child route that hangs from a pierce group has one of these places, which belongs to the path by which the group is cut.
//! The places of a group are numbered path by path, and along each path in order.

use super::index::index;
use crate::geometry::DVec2;
use crate::problem::{LeavePoint, Problem};
use std::ops::Range;

/// The items that are no pierce groups.
const NONE: u32 = u32::MAX;

/// The places of all groups.
#[derive(Default)]
pub(super) struct LeavePlaces<'p> {
    /// By item: its group; empty if there are no groups.
    of: Vec<u32>,
    groups: Vec<Group<'p>>,
}

struct Group<'p> {
    /// By path: its first place; the number of all places at the end.
    first: Vec<u32>,
    places: Vec<&'p LeavePoint>,
    /// The points where any path may be left, each once.
    points: Vec<DVec2>,
}

impl<'p> LeavePlaces<'p> {
    pub(super) fn new(problem: &'p Problem) -> Self {
        let mut all = Self::default();
        for (id, item) in problem.items.iter().enumerate().filter(|(_, i)| i.is_pierce_group()) {
            all.of.resize(problem.items.len(), NONE);
            all.of[id] = index(all.groups.len());
            let mut group = Group { first: vec![0], places: Vec::new(), points: Vec::new() };
            let mut known = Vec::new();
            for path in &item.paths {
                group.places.extend(&path.leave_points);
                group.first.push(index(group.places.len()));
            }
            for place in &group.places {
                let node = place.node as usize;
                known.resize(known.len().max(node + 1), false);
                if !std::mem::replace(&mut known[node], true) {
                    group.points.push(place.ends[0]);
                }
            }
            all.groups.push(group);
        }
        all
    }

    /// Whether there are any pierce groups.
    #[inline]
    pub(super) fn any(&self) -> bool {
        !self.of.is_empty()
    }

    fn group(&self, item: u32) -> Option<&Group<'p>> {
        self.groups.get(*self.of.get(item as usize)? as usize)
    }

    /// Whether an item is a pierce group.
    #[inline]
    pub(super) fn is_group(&self, item: u32) -> bool {
        self.of.get(item as usize).is_some_and(|&g| g != NONE)
    }

    /// Whether an item is a pierce group that may be left.
    pub(super) fn may_leave(&self, item: u32) -> bool {
        self.group(item).is_some_and(|g| !g.places.is_empty())
    }

    /// The numbers of the places on one path of a group.
    pub(super) fn on_path(&self, item: u32, path: u32) -> Range<u32> {
        self.group(item).map_or(0..0, |g| g.first[path as usize]..g.first[path as usize + 1])
    }

    /// A place of a group.
    pub(super) fn place(&self, item: u32, at: u32) -> Option<&'p LeavePoint> {
        self.group(item)?.places.get(at as usize).copied()
    }

    /// The points where a group may be left; none for other items.
    pub(super) fn points(&self, item: u32) -> &[DVec2] {
        self.group(item).map_or(&[], |g| &g.points)
    }
}
