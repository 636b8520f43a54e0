//! Sets of places with too few legs to the others. A tour that stops at one of them enters and leaves the set.

use super::cut::Cut;
use super::{ROUGH, ShareBound, WARM};
use crate::order::{real, sort_by};
use std::collections::BTreeMap;

/// Legs below this share of what there should be are a fault: the smooth solution is nowhere exact.
const ENOUGH: f64 = 0.985;
/// Legs missing below this are no fault either.
const LITTLE: f64 = 0.01;
/// Legs and places that are used less do not hold a set together.
const USED: f64 = 1e-3;
/// Most cuts, as a multiple of the number of items: each takes time in every step.
const MOST_CUTS: usize = 40;

/// No place.
const NOWHERE: u32 = u32::MAX;

/// A set of places that grows: its places, the legs out of it, and how much of each item stops in it, in legs.
#[derive(Clone, Debug, Default)]
struct Group {
    places: Vec<u32>,
    legs: f64,
    stops: BTreeMap<usize, f64>,
}

impl ShareBound {
    /// Adds cuts: joins places by the most used legs first, and looks at each set that comes about. Places are knots, and then
    /// whole items. Cuts without a price and with legs enough are forgotten.
    pub(super) fn separate(&mut self) {
        let little = 1e-9 * self.mean;
        self.cuts.retain(|c| c.price > little || c.legs < c.target);
        // How much each knot is used, in legs.
        let mut degree = vec![0.0; self.stay.len()];
        for e in 0..self.starts.len() - 1 {
            let [a, b] = self.pairs.list[e].items.map(|k| self.base[k]);
            for l in self.starts[e]..self.starts[e + 1] {
                degree[a + self.active[l].i as usize] += self.uses[l];
                degree[b + self.active[l].j as usize] += self.uses[l];
            }
        }
        let (mut by_knot, mut by_item) = (vec![NOWHERE; degree.len()], vec![NOWHERE; degree.len()]);
        for k in self.first..self.items.len() {
            let knots = self.base[k]..self.base[k] + self.items[k].knots;
            for v in knots.clone() {
                // Of an open contour, the two ends are one place.
                let place = if self.items[k].paired { v - (v - knots.start) % 2 } else { v };
                let used = if self.items[k].paired { degree[place] + degree[place + 1] } else { degree[v] };
                by_item[v] = u32::try_from(knots.start).unwrap_or(NOWHERE);
                if used > USED {
                    by_knot[v] = u32::try_from(place).unwrap_or(NOWHERE);
                }
            }
        }
        let room = MOST_CUTS * self.items.len();
        // While it is hot every item stops everywhere a little, and pieces are still long: no set of knots means anything yet.
        let cold = self.rounds >= ROUGH && self.temperature <= 1.001 * WARM * self.mean;
        let of_knots = [(by_knot.as_slice(), true), (&by_knot, false)].into_iter().filter(|_| cold);
        for (places, relative) in of_knots.chain([(by_item.as_slice(), false)]) {
            for found in self.grown(places, &degree, relative) {
                if self.cuts.len() < room {
                    self.offer_cut(&found, places);
                }
            }
        }
    }

    /// The sets with too few legs that come about when places are joined, those with the largest fault first.
    fn grown(&self, place: &[u32], degree: &[f64], relative: bool) -> Vec<Vec<u32>> {
        let mut groups = vec![Group::default(); place.len()];
        let mut group: Vec<u32> = (0..).take(place.len()).collect();
        for k in self.first..self.items.len() {
            for v in self.base[k]..self.base[k] + self.items[k].knots {
                if place[v] != NOWHERE {
                    let of = &mut groups[place[v] as usize];
                    if of.places.is_empty() {
                        of.places.push(place[v]);
                    }
                    of.legs += degree[v];
                    *of.stops.entry(k).or_default() += degree[v];
                }
            }
        }
        let mut joins: Vec<(f64, u32, u32, f64)> = Vec::new();
        for e in 0..self.starts.len() - 1 {
            let [a, b] = self.pairs.list[e].items.map(|k| self.base[k]);
            for l in self.starts[e]..self.starts[e + 1] {
                let ends = [a + self.active[l].i as usize, b + self.active[l].j as usize];
                let [p, q] = ends.map(|v| place[v]);
                if self.uses[l] > 1e-5 && p != NOWHERE && q != NOWHERE {
                    let part = degree[ends[0]].min(degree[ends[1]]);
                    joins.push((
                        if relative { self.uses[l] / part } else { self.uses[l] },
                        p,
                        q,
                        self.uses[l],
                    ));
                }
            }
        }
        // The legs between places, from both sides.
        let mut beside: Vec<Vec<(u32, f64)>> = vec![Vec::new(); place.len()];
        for &(_, p, q, uses) in &joins {
            beside[p as usize].push((q, uses));
            beside[q as usize].push((p, uses));
        }
        joins.retain(|j| j.3 > USED);
        sort_by(&mut joins, |j| [u64::MAX - real(j.0), j.1.into(), j.2.into()]);
        let mut found: Vec<(f64, Vec<u32>)> = Vec::new();
        for (_, p, q, _) in joins {
            let [mut a, mut b] = [p, q].map(|v| group[v as usize] as usize);
            if a == b {
                continue;
            }
            if groups[a].places.len() < groups[b].places.len() {
                std::mem::swap(&mut a, &mut b);
            }
            let small = std::mem::take(&mut groups[b]);
            let between: f64 = small
                .places
                .iter()
                .flat_map(|&v| &beside[v as usize])
                .filter(|l| group[l.0 as usize] as usize == a)
                .map(|l| l.1)
                .sum();
            for &v in &small.places {
                group[v as usize] = u32::try_from(a).unwrap_or(NOWHERE);
            }
            let large = &mut groups[a];
            large.places.extend(small.places);
            large.legs += small.legs - 2.0 * between;
            for (k, legs) in small.stops {
                *large.stops.entry(k).or_default() += legs;
            }
            let most = large.stops.values().fold(0.0, |m: f64, &s| m.max(s)).min(2.0);
            if large.legs < ENOUGH * most - LITTLE {
                found.push((most - large.legs, large.places.clone()));
            }
        }
        sort_by(&mut found, |f| [u64::MAX - real(f.0), f.1.len() as u64, 0]);
        found.truncate(self.items.len() / 2);
        found.into_iter().map(|f| f.1).collect()
    }

    /// Adds a set of places as a cut if it is new.
    fn offer_cut(&mut self, places: &[u32], place: &[u32]) {
        let mut chosen = vec![false; place.len()];
        places.iter().for_each(|&v| chosen[v as usize] = true);
        let mut held: Vec<(usize, Option<Vec<bool>>)> = Vec::new();
        let mut most = (0.0, None);
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
            let stops: f64 =
                inside.iter().enumerate().filter(|v| *v.1).map(|(v, _)| self.stay[base + v]).sum();
            if all && most.1 != Some(usize::MAX) {
                most = (1.0, Some(usize::MAX));
            } else if !all && stops > most.0 && most.1 != Some(usize::MAX) {
                most = (stops, Some(k));
            }
            held.push((k, (!all).then_some(inside)));
        }
        let everything = held.len() == self.items.len() - self.first && held.iter().all(|h| h.1.is_none());
        let Some(visited) = most.1 else { return };
        if everything || held.len() < 2 {
            return;
        }
        let visited = (visited != usize::MAX).then_some(visited);
        if self.cuts.iter().all(|c| c.visited != visited || c.held != held) {
            self.cuts.push(Cut::new(held, visited));
        }
    }
}
