//! Groups of places that grow while places are joined by legs, and what is missing between them.

use super::StopBound;
use std::collections::BTreeMap;

/// What is missing below this share of what there should be is no fault: the smooth solution is nowhere exact.
const ENOUGH: f64 = 0.985;
/// Less than this is no fault either, in parts.
pub(super) const LITTLE: f64 = 0.01;
/// No place.
pub(super) const NOWHERE: usize = usize::MAX;
/// An item of which less than this share of the stops lies in a group is divided between groups.
const WHOLE: f64 = 0.999;

/// Two places with a leg between them, and how much it is used.
pub(super) struct Join {
    pub(super) places: [usize; 2],
    pub(super) uses: f64,
    /// The share of the legs at the less used of its ends.
    pub(super) part: f64,
}

/// Places that are joined: the legs out of them, the stops of each item there, and how surely there is a stop.
#[derive(Clone, Debug, Default)]
struct Group {
    places: Vec<usize>,
    legs: f64,
    stops: BTreeMap<usize, f64>,
    sure: f64,
}

/// All groups. At first, each place is one.
pub(super) struct Groups<'b> {
    bound: &'b StopBound,
    groups: Vec<Group>,
    /// By place: its group.
    of: Vec<usize>,
    /// By place: the places with legs to it, and how much these are used.
    beside: Vec<Vec<(usize, f64)>>,
    /// By item: its stops, and in how many groups it has some.
    stops: Vec<f64>,
    spread: Vec<usize>,
    /// Over all groups: how surely they have stops, the legs out of them, and the further stops of items with stops in several groups.
    sure: f64,
    legs: f64,
    again: f64,
    /// How many groups have places.
    count: usize,
}

impl<'b> Groups<'b> {
    /// The places, `place` by knot, with the legs between them.
    pub(super) fn new(bound: &'b StopBound, place: &[usize], joins: &[Join]) -> Self {
        let mut groups = vec![Group::default(); place.len()];
        let mut stops = vec![0.0; bound.members.len()];
        for (k, stops) in stops.iter_mut().enumerate().skip(bound.first) {
            for v in bound.base[k]..bound.base[k] + bound.members[k].item.knots {
                if place[v] != NOWHERE {
                    let group = &mut groups[place[v]];
                    if group.places.is_empty() {
                        group.places.push(place[v]);
                    }
                    group.legs += bound.offered[v];
                    *group.stops.entry(k).or_default() += bound.stay[v];
                    *stops += bound.stay[v];
                }
            }
        }
        groups.iter_mut().for_each(|g| g.sure = g.how_sure(&stops));
        let mut spread = vec![0_usize; bound.members.len()];
        groups.iter().for_each(|g| g.stops.keys().for_each(|&k| spread[k] += 1));
        let mut beside: Vec<Vec<(usize, f64)>> = vec![Vec::new(); place.len()];
        for join in joins {
            let [p, q] = join.places;
            beside[p].push((q, join.uses));
            beside[q].push((p, join.uses));
        }
        let again = (bound.first..spread.len()).filter(|&k| spread[k] > 1).map(|k| bound.again[k]).sum();
        Self {
            bound,
            of: (0..place.len()).collect(),
            beside,
            stops,
            spread,
            sure: groups.iter().map(|g| g.sure).sum(),
            legs: 0.5 * groups.iter().map(|g| g.legs).sum::<f64>() + 0.5 * bound.home_legs(),
            again,
            count: groups.iter().filter(|g| !g.places.is_empty()).count(),
            groups,
        }
    }

    /// What is missing between all groups.
    pub(super) fn missing(&self) -> f64 {
        self.sure - self.again - self.legs * self.count as f64 / (self.count + 1) as f64
    }

    /// Joins the groups of two places; returns the group that comes about, or `None` if they were in the same one.
    pub(super) fn join(&mut self, places: [usize; 2]) -> Option<usize> {
        let [mut a, mut b] = places.map(|p| self.of[p]);
        if a == b {
            return None;
        }
        if self.groups[a].places.len() < self.groups[b].places.len() {
            std::mem::swap(&mut a, &mut b);
        }
        self.sure -= self.groups[a].sure + self.groups[b].sure;
        let small = std::mem::take(&mut self.groups[b]);
        let legs = small.places.iter().flat_map(|&p| &self.beside[p]);
        let between: f64 = legs.filter(|l| self.of[l.0] == a).map(|l| l.1).sum();
        small.places.iter().for_each(|&p| self.of[p] = a);
        let large = &mut self.groups[a];
        large.places.extend(&small.places);
        large.legs += small.legs - 2.0 * between;
        self.legs -= between;
        for (k, s) in small.stops {
            if let Some(here) = large.stops.get_mut(&k) {
                *here += s;
                self.spread[k] -= 1;
                if self.spread[k] == 1 {
                    self.again -= self.bound.again[k];
                }
            } else {
                large.stops.insert(k, s);
            }
        }
        large.sure = large.how_sure(&self.stops);
        self.sure += large.sure;
        self.count -= 1;
        Some(a)
    }

    /// What is missing between a group and the rest, with the places of the group; `None` if it is connected with the rest.
    pub(super) fn fault(&self, group: usize) -> Option<(f64, Vec<usize>)> {
        let group = &self.groups[group];
        let divided = group.stops.iter().filter(|(k, s)| **s <= WHOLE * self.stops[**k]);
        let there = 0.5 * group.legs + divided.map(|(k, _)| self.bound.again[*k]).sum::<f64>();
        (there < ENOUGH * group.sure - LITTLE).then(|| (group.sure - there, group.places.clone()))
    }
}

impl Group {
    /// How surely it has a stop. `all`: the stops of each item.
    fn how_sure(&self, all: &[f64]) -> f64 {
        let of = |(k, s): (&usize, &f64)| if *s > WHOLE * all[*k] { 1.0 } else { s.min(1.0) };
        self.stops.iter().map(of).fold(0.0, f64::max)
    }
}
