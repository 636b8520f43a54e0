//! Parts that the smooth solution leaves unconnected.

use super::StopBound;
use super::cut::Partition;
use super::groups::{Groups, Join, LITTLE, NOWHERE};
use crate::geometry::Union;
use crate::order::{real, sort_by};

/// Legs and places that are used less do not hold a part together.
const USED: f64 = 1e-3;
/// Most cuts, as a multiple of the number of items: each takes time in every step.
const MOST_CUTS: usize = 20;

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
        let joins = self.joins(place);
        let mut groups = Groups::new(self, place, &joins);
        // The state when most is missing.
        let (mut most, mut at) = (groups.missing(), 0);
        let mut merges: Vec<[usize; 2]> = Vec::new();
        let mut found: Vec<(f64, Vec<usize>)> = Vec::new();
        for join in joins.iter().filter(|j| j.uses > USED) {
            let Some(group) = groups.join(join.places) else { continue };
            merges.push(join.places);
            let now = groups.missing();
            if now > most {
                (most, at) = (now, merges.len());
            }
            found.extend(groups.fault(group));
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
    pub(super) fn home_legs(&self) -> f64 {
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
