//! Parts that the smooth solution leaves unconnected.

use super::StopBound;
use super::cut::Partition;
use crate::geometry::Union;
use crate::order::{real, sort_by};
use std::collections::BTreeMap;

/// What is missing below this share of what there should be is no fault: the smooth solution is nowhere exact.
const ENOUGH: f64 = 0.985;
/// Less than this is no fault either, in parts.
const LITTLE: f64 = 0.01;
/// Legs and places that are used less do not hold a part together.
const USED: f64 = 1e-3;
/// Most cuts, as a multiple of the number of items: each takes time in every step.
const MOST_CUTS: usize = 20;
/// No place.
const NOWHERE: usize = usize::MAX;

/// A part that grows: its places, the legs out of it, and the stops of each item in it.
#[derive(Clone, Debug, Default)]
struct Group {
    places: Vec<usize>,
    legs: f64,
    stops: BTreeMap<usize, f64>,
}

/// Two places with a leg between them, and how much it is used.
struct Join {
    places: [usize; 2],
    uses: f64,
    /// The share of the legs at the less used of its ends.
    part: f64,
}

impl StopBound {
    /// Adds cuts: joins places by the legs that are most used, and looks at each part that comes about, and at all parts together. Places are
    /// knots, and then whole items. Cuts that have no price and that the solution satisfies are forgotten.
    pub(super) fn separate(&mut self) {
        let little = 1e-9 * self.mean;
        self.cuts.retain(|c| c.price > little || c.there < c.asked);
        let knots = self.potential.len();
        let (mut by_knot, mut by_item) = (vec![NOWHERE; knots], vec![NOWHERE; knots]);
        let mut used = vec![0.0; knots];
        (0..knots).for_each(|v| used[self.place[v]] += self.offered[v]);
        for k in self.first..self.members.len() {
            for v in self.base[k]..self.base[k] + self.members[k].item.knots {
                by_item[v] = self.base[k];
                if used[self.place[v]] > USED {
                    by_knot[v] = self.place[v];
                }
            }
        }
        let room = MOST_CUTS * self.members.len();
        for places in [by_knot, by_item] {
            for parts in self.torn(&places) {
                if self.cuts.len() < room {
                    self.offer_cut(&parts, &places);
                }
            }
        }
    }

    /// The parts that come about when places are joined: each single one that is not connected with the rest, those with the largest
    /// fault first, and all that there are at the moment when most is missing between them. As the part of each place, 0 for that of home.
    fn torn(&self, place: &[usize]) -> Vec<Vec<u32>> {
        let mut groups = vec![Group::default(); place.len()];
        let mut group: Vec<usize> = (0..place.len()).collect();
        // The stops of each item, and in how many groups it has some.
        let mut all = vec![0.0; self.members.len()];
        let mut spread = vec![0_usize; self.members.len()];
        for (k, all) in all.iter_mut().enumerate().skip(self.first) {
            for v in self.base[k]..self.base[k] + self.members[k].item.knots {
                if place[v] != NOWHERE {
                    let of = &mut groups[place[v]];
                    if of.places.is_empty() {
                        of.places.push(place[v]);
                    }
                    of.legs += self.offered[v];
                    *of.stops.entry(k).or_default() += self.stay[v];
                    *all += self.stay[v];
                }
            }
        }
        groups.iter().for_each(|g| g.stops.keys().for_each(|&k| spread[k] += 1));
        let joins = self.joins(place);
        let mut beside: Vec<Vec<(usize, f64)>> = vec![Vec::new(); place.len()];
        for join in &joins {
            let [p, q] = join.places;
            beside[p].push((q, join.uses));
            beside[q].push((p, join.uses));
        }
        // How surely a group has a stop.
        let stops = |g: &Group| {
            let of = |(k, s): (&usize, &f64)| if *s > 0.999 * all[*k] { 1.0 } else { s.min(1.0) };
            g.stops.iter().map(of).fold(0.0, f64::max)
        };
        // What all groups together ask for, what there is of it, and the state when most is missing.
        let mut asked: f64 = groups.iter().map(stops).sum();
        let mut legs: f64 = 0.5 * groups.iter().map(|g| g.legs).sum::<f64>() + 0.5 * self.home_legs();
        let mut again: f64 =
            (self.first..spread.len()).filter(|&k| spread[k] > 1).map(|k| self.again[k]).sum();
        let mut count = groups.iter().filter(|g| !g.places.is_empty()).count();
        let missing = |asked: f64, legs: f64, again: f64, count: usize| {
            asked - again - legs * count as f64 / (count + 1) as f64
        };
        let (mut most, mut at) = (missing(asked, legs, again, count), 0);
        let mut merges: Vec<[usize; 2]> = Vec::new();
        let mut found: Vec<(f64, Vec<usize>)> = Vec::new();
        for join in joins.iter().filter(|j| j.uses > USED) {
            let [mut a, mut b] = join.places.map(|p| group[p]);
            if a == b {
                continue;
            }
            if groups[a].places.len() < groups[b].places.len() {
                std::mem::swap(&mut a, &mut b);
            }
            asked -= stops(&groups[a]) + stops(&groups[b]);
            let small = std::mem::take(&mut groups[b]);
            let between: f64 =
                small.places.iter().flat_map(|&p| &beside[p]).filter(|l| group[l.0] == a).map(|l| l.1).sum();
            small.places.iter().for_each(|&p| group[p] = a);
            let large = &mut groups[a];
            large.places.extend(&small.places);
            large.legs += small.legs - 2.0 * between;
            legs -= between;
            for (k, s) in small.stops {
                if let Some(here) = large.stops.get_mut(&k) {
                    *here += s;
                    spread[k] -= 1;
                    if spread[k] == 1 {
                        again -= self.again[k];
                    }
                } else {
                    large.stops.insert(k, s);
                }
            }
            let sure = stops(large);
            asked += sure;
            count -= 1;
            merges.push(join.places);
            let now = missing(asked, legs, again, count);
            if now > most {
                (most, at) = (now, merges.len());
            }
            let divided =
                large.stops.iter().filter(|(k, s)| **s <= 0.999 * all[**k]).map(|(k, _)| self.again[*k]);
            let there = 0.5 * large.legs + divided.sum::<f64>();
            if there < ENOUGH * sure - LITTLE {
                found.push((sure - there, large.places.clone()));
            }
        }
        sort_by(&mut found, |f| [u64::MAX - real(f.0), f.1.len() as u64, 0]);
        found.truncate(self.members.len() / 2 + 1);
        let single = |places: Vec<usize>| {
            let mut part = vec![0; place.len()];
            places.into_iter().for_each(|p| part[p] = 1);
            part
        };
        let mut out: Vec<Vec<u32>> = found.into_iter().map(|f| single(f.1)).collect();
        if most > LITTLE {
            out.insert(0, numbered(place, &merges[..at]));
        }
        out
    }

    /// How much the legs of home are used.
    fn home_legs(&self) -> f64 {
        self.offered[..self.base.get(self.first).copied().unwrap_or(0)].iter().sum()
    }

    /// The legs between places, the relatively most used first.
    fn joins(&self, place: &[usize]) -> Vec<Join> {
        let mut joins: Vec<Join> = Vec::new();
        let home = self.base[self.first];
        for (leg, &uses) in self.active.iter().zip(&self.uses) {
            let ends = leg.ends.map(|v| v as usize);
            let places = ends.map(|v| place[v]);
            if uses > 1e-5 && ends[0] >= home && !places.contains(&NOWHERE) {
                let part = uses / self.offered[ends[0]].min(self.offered[ends[1]]);
                joins.push(Join { places, uses, part });
            }
        }
        sort_by(&mut joins, |j| [u64::MAX - real(j.part), j.places[0] as u64, j.places[1] as u64]);
        joins
    }

    /// Adds parts as a cut if it is new. `part`: the part of each place.
    fn offer_cut(&mut self, part: &[u32], place: &[usize]) {
        let highest = part.iter().copied().max().unwrap_or(0);
        let mut held: Vec<(usize, Vec<u32>)> = Vec::new();
        // For each part the most stops of an item in it, and the item; infinite for one that lies in it whole.
        let mut most: Vec<(f64, Option<usize>)> = vec![(0.0, None); highest as usize + 1];
        for k in self.first..self.members.len() {
            let (base, knots) = (self.base[k], self.members[k].item.knots);
            let of = |v: usize| (place[base + v] != NOWHERE).then(|| part[place[base + v]]);
            let known: Vec<u32> = (0..knots).filter_map(of).collect();
            if known.iter().all(|p| *p == 0) {
                continue;
            }
            // A knot that is not used belongs to the nearest used one along its contour.
            let turns = self.members[k].item.can_halve();
            let nearest = |v: usize| {
                let beside = |d: usize| of((v + d) % knots).or_else(|| of((v + knots - d) % knots));
                of(v).or_else(|| (1..=knots / 2).filter(|_| turns).find_map(beside)).unwrap_or(0)
            };
            let mut parts: Vec<u32> = (0..knots).map(nearest).collect();
            if known.windows(2).all(|w| w[0] == w[1]) {
                parts.fill(known[0]);
            }
            let whole = parts.windows(2).all(|w| w[0] == w[1]);
            for v in 0..knots {
                let stops: f64 = if whole {
                    f64::INFINITY
                } else {
                    (0..knots).filter(|&w| parts[w] == parts[v]).map(|w| self.stay[base + w]).sum()
                };
                let of = &mut most[parts[v] as usize];
                if stops > of.0 {
                    *of = (stops, Some(k));
                }
            }
            held.push((k, parts));
        }
        // Parts in which nothing stops join that of home.
        let mut number = vec![0; most.len()];
        let mut visited = Vec::new();
        for (part, of) in most.iter().enumerate().skip(1).filter(|m| m.1.0 > USED) {
            visited.push(of.1.filter(|_| of.0.is_finite()));
            number[part] = u32::try_from(visited.len()).unwrap_or(0);
        }
        held.iter_mut().for_each(|h| h.1.iter_mut().for_each(|p| *p = number[*p as usize]));
        held.retain(|h| h.1.iter().any(|p| *p != 0));
        if visited.is_empty() || held.len() < 2 {
            return;
        }
        if self.cuts.iter().all(|c| c.visited != visited || c.held != held) {
            self.cuts.push(Partition::new(held, visited));
        }
    }
}

/// The part of each place after these merges, from 1 on.
fn numbered(place: &[usize], merges: &[[usize; 2]]) -> Vec<u32> {
    let id = |p: usize| u32::try_from(p).unwrap_or(u32::MAX);
    let mut joined = Union::new(place.len());
    for &[p, q] in merges {
        joined.join(id(p), id(q));
    }
    let (mut number, mut next) = (vec![0_u32; place.len()], 0);
    let mut part = vec![0_u32; place.len()];
    for &p in place.iter().filter(|p| **p != NOWHERE) {
        let root = joined.root(id(p)) as usize;
        if number[root] == 0 {
            next += 1;
            number[root] = next;
        }
        part[p] = number[root];
    }
    part
}
