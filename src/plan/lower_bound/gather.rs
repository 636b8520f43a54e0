//! Sets of places with too few legs to the others, found by joining places again and again by the legs between them.

use super::net::{Item, bases};
use super::places::Places;
use crate::order::{real, sort_by};
use std::cmp::Reverse;
use std::collections::{BTreeMap, BinaryHeap};

/// Legs and places that are used less do not hold a set together.
const USED: f64 = 1e-3;
/// Legs that are used less are nothing.
const NOTHING: f64 = 1e-5;
/// No place.
const NOWHERE: u32 = u32::MAX;

/// How much a solution uses the legs between knots, which are counted through all items.
#[derive(Debug)]
pub(super) struct Usage<'i> {
    items: &'i [Item],
    first: usize,
    /// Where the knots of each item start.
    base: Vec<usize>,
    /// The two knots of each leg, and how much it is used.
    legs: Vec<([usize; 2], f64)>,
    /// The same in all, for each knot.
    degree: Vec<f64>,
}

/// What sets are looked for.
#[derive(Clone, Copy, Debug)]
pub(super) struct Search {
    /// Sets may hold some knots of an item. If not, they hold items.
    pub(super) knots: bool,
    /// Legs that are a large part of what their ends have come first, not legs that are used most.
    pub(super) relative: bool,
    /// A set is found if it has fewer legs to the others than this share of what it should have, less this.
    pub(super) enough: f64,
    pub(super) little: f64,
}

/// A set of places that grows: its places, the legs out of it, and how much of each item stops in it, in legs.
#[derive(Clone, Debug, Default)]
struct Group {
    /// Its own number.
    name: u32,
    places: Vec<u32>,
    legs: f64,
    stops: BTreeMap<usize, f64>,
    /// The legs to other sets.
    beside: BTreeMap<u32, f64>,
}

impl<'i> Usage<'i> {
    /// `first`: the first item that is not home.
    pub(super) fn new(items: &'i [Item], first: usize) -> Self {
        let (base, knots) = bases(items);
        Self { items, first, base, legs: Vec::new(), degree: vec![0.0; knots] }
    }

    /// Adds a leg between two knots of items.
    pub(super) fn add(&mut self, ends: [(usize, usize); 2], uses: f64) {
        let ends = ends.map(|(item, knot)| self.base[item] + knot);
        ends.iter().for_each(|&v| self.degree[v] += uses);
        if uses > NOTHING {
            self.legs.push((ends, uses));
        }
    }

    /// The sets with too few legs, those with the largest fault first.
    pub(super) fn sets(&self, search: Search) -> Vec<Places> {
        let place = self.places(search.knots);
        let found = self.grown(&place, search);
        found.iter().filter_map(|places| self.around(places, &place)).collect()
    }

    /// The place of each knot: itself or its item.
    fn places(&self, knots: bool) -> Vec<u32> {
        let mut places = vec![NOWHERE; self.degree.len()];
        for (item, &base) in self.items.iter().zip(&self.base).skip(self.first) {
            for k in 0..item.knots {
                // Of an open contour, the two ends are one place.
                let place = base + if item.paired { k - k % 2 } else { k };
                let used = self.degree[place] + if item.paired { self.degree[place + 1] } else { 0.0 };
                if !knots {
                    places[base + k] = u32::try_from(base).unwrap_or(NOWHERE);
                } else if used > USED {
                    places[base + k] = u32::try_from(place).unwrap_or(NOWHERE);
                }
            }
        }
        places
    }

    /// Joins the two sets with the most legs between them again and again, and returns each set with too few legs that comes about.
    fn grown(&self, place: &[u32], search: Search) -> Vec<Vec<u32>> {
        let mut groups = self.single(place);
        let weight = |groups: &[Group], [a, b]: [u32; 2]| {
            let [a, b] = [&groups[a as usize], &groups[b as usize]];
            let part = if search.relative { a.legs.min(b.legs).max(USED) } else { 1.0 };
            a.beside.get(&b.name).map_or(0.0, |between| between / part)
        };
        // The heaviest first; what a join has changed is entered again.
        let mut joins: BinaryHeap<(u64, Reverse<[u32; 2]>)> = BinaryHeap::new();
        for (&[a, b], between) in &self.between(place) {
            let mut add = |a: u32, b: u32| *groups[a as usize].beside.entry(b).or_default() += between;
            add(a, b);
            add(b, a);
        }
        for (a, group) in (0..).zip(&groups) {
            let after = group.beside.range(a + 1..).filter(|b| *b.1 > USED);
            joins.extend(after.map(|(&b, _)| (real(weight(&groups, [a, b])), Reverse([a, b]))));
        }
        let mut found: Vec<(f64, Vec<u32>)> = Vec::new();
        while let Some((heaviest, Reverse([a, b]))) = joins.pop() {
            if heaviest != real(weight(&groups, [a, b])) || groups[a as usize].places.is_empty() {
                continue;
            }
            let [mut a, mut b] = [a, b];
            if groups[a as usize].beside.len() < groups[b as usize].beside.len() {
                std::mem::swap(&mut a, &mut b);
            }
            let small = std::mem::take(&mut groups[b as usize]);
            let large = &mut groups[a as usize];
            let between = large.beside.remove(&b).unwrap_or(0.0);
            large.places.extend(small.places);
            large.legs += small.legs - 2.0 * between;
            for (k, legs) in small.stops {
                *large.stops.entry(k).or_default() += legs;
            }
            for (&c, more) in small.beside.iter().filter(|c| *c.0 != a) {
                *groups[a as usize].beside.entry(c).or_default() += more;
                let other = &mut groups[c as usize].beside;
                other.remove(&b);
                *other.entry(a).or_default() += more;
            }
            let large = &groups[a as usize];
            for (&c, _) in large.beside.iter().filter(|c| *c.1 > USED) {
                let ends = [a.min(c), a.max(c)];
                joins.push((real(weight(&groups, ends)), Reverse(ends)));
            }
            let most = large.stops.values().fold(0.0, |m: f64, &s| m.max(s)).min(2.0);
            if large.legs < search.enough * most - search.little {
                found.push((most - large.legs, large.places.clone()));
            }
        }
        sort_by(&mut found, |f| [u64::MAX - real(f.0), f.1.len() as u64, 0]);
        found.truncate(self.items.len() / 2);
        found.into_iter().map(|f| f.1).collect()
    }

    /// A set for each place, without what is beside it.
    fn single(&self, place: &[u32]) -> Vec<Group> {
        let mut groups: Vec<Group> =
            (0..).take(place.len()).map(|name| Group { name, ..Group::default() }).collect();
        for k in self.first..self.items.len() {
            for v in self.base[k]..self.base[k] + self.items[k].knots {
                if place[v] != NOWHERE {
                    let of = &mut groups[place[v] as usize];
                    if of.places.is_empty() {
                        of.places.push(place[v]);
                    }
                    of.legs += self.degree[v];
                    *of.stops.entry(k).or_default() += self.degree[v];
                }
            }
        }
        groups
    }

    /// The legs between each two places.
    fn between(&self, place: &[u32]) -> BTreeMap<[u32; 2], f64> {
        let mut between = BTreeMap::new();
        for &(ends, uses) in &self.legs {
            let [p, q] = ends.map(|v| place[v]);
            if p != NOWHERE && q != NOWHERE && p != q {
                *between.entry([p.min(q), p.max(q)]).or_default() += uses;
            }
        }
        between
    }

    /// The knots of these places; `None` if that is everything or next to nothing.
    fn around(&self, places: &[u32], place: &[u32]) -> Option<Places> {
        let mut chosen = vec![false; place.len()];
        places.iter().for_each(|&v| chosen[v as usize] = true);
        let mut held: Vec<(usize, Option<Vec<bool>>)> = Vec::new();
        let mut most = (0.0, None);
        let mut is_whole = false;
        for k in self.first..self.items.len() {
            let base = self.base[k];
            let of = |v: usize| (place[base + v] != NOWHERE).then(|| chosen[place[base + v] as usize]);
            let knots = self.items[k].knots;
            if !(0..knots).any(|v| of(v) == Some(true)) {
                continue;
            }
            // A place that is not used belongs to the nearest used one along its contour.
            let turns = self.items[k].can_halve();
            let nearest = |v: usize| {
                let beside = |d: usize| of((v + d) % knots).or_else(|| of((v + knots - d) % knots));
                of(v).or_else(|| (1..=knots / 2).filter(|_| turns).find_map(beside)).unwrap_or(false)
            };
            let mut inside: Vec<bool> = (0..knots).map(nearest).collect();
            let unused = !turns && (0..knots).all(|v| of(v) != Some(false));
            if unused {
                inside.fill(true);
            }
            let all = inside.iter().all(|&x| x);
            is_whole |= all;
            let legs: f64 =
                inside.iter().enumerate().filter(|v| *v.1).map(|(v, _)| self.degree[base + v]).sum();
            if legs > most.0 {
                most = (legs, Some(k));
            }
            held.push((k, (!all).then_some(inside)));
        }
        let everything = held.len() == self.items.len() - self.first && held.iter().all(|h| h.1.is_none());
        let visited = most.1.filter(|_| !is_whole);
        (!everything && held.len() > 1 && (is_whole || visited.is_some())).then_some(Places { held, visited })
    }
}

#[cfg(test)]
mod tests {
    use super::super::net::points;
    use super::*;
    use crate::geometry::DVec2;

    fn usage<'i>(items: &'i [Item], legs: &[[(usize, usize); 2]]) -> Usage<'i> {
        let mut usage = Usage::new(items, 1);
        legs.iter().for_each(|&leg| usage.add(leg, 1.0));
        usage
    }

    /// Two triangles, and home beside the first: nothing joins the second to the rest.
    #[test]
    fn a_set_of_items_without_legs_is_found() {
        let items = vec![points(&[DVec2::ZERO], false); 7];
        let legs = [[0, 1], [1, 2], [2, 3], [3, 0], [4, 5], [5, 6], [6, 4]].map(|ends| ends.map(|i| (i, 0)));
        let sets =
            usage(&items, &legs).sets(Search { knots: false, relative: false, enough: 1.0, little: 0.1 });
        let all = |items: &[usize]| items.iter().map(|&i| (i, None)).collect::<Vec<_>>();
        assert_eq!(sets, [Places { held: all(&[4, 5, 6]), visited: None }]);
    }

    /// Two circles of legs at the two knots of the same items: each stops at half of the knots only.
    #[test]
    fn a_set_through_items_is_found() {
        let items = vec![points(&[DVec2::ZERO, DVec2::ONE], false); 4];
        let mut usage = Usage::new(&items, 1);
        for (knot, ends) in [(0, [0, 1]), (0, [1, 2]), (0, [2, 0]), (1, [1, 2]), (1, [2, 3]), (1, [3, 1])] {
            usage.add(ends.map(|i| (i, if i == 0 { 0 } else { knot })), 0.5);
        }
        let search = Search { knots: true, relative: false, enough: 1.0, little: 0.1 };
        let half = Some(vec![false, true]);
        // The third item stops at its second knot only, so that it is held whole.
        let held = vec![(1, half.clone()), (2, half), (3, None)];
        assert_eq!(usage.sets(search), [Places { held, visited: None }]);
    }
}
