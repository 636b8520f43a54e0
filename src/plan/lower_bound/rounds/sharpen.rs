//! What a round prepares for the next: what walks must remember, and which pieces of contours are halved.

use super::super::net::{Item, Piece};
use super::super::walks::{Ground, Visit};
use super::excess::legs;
use super::{Strong, extend_ng_set};
use crate::order::sort_by;

/// Most stops of a cycle or precedence fault that is removed: every item on it must remember more.
const LONGEST: usize = 12;
/// Members that a round adds to ng-sets, as a share of the number of items: each may double the states of an item, and after the first of them other
/// walks are best.
const ADDED: f64 = 0.15;
/// Share of the gap that the walks may lose at all knots together without being looked at.
const LITTLE: f64 = 0.1;
/// All pieces are halved after a look at all orders when less than this share of them is left, so that they hardly grow more.
const FEW: f64 = 0.75;
/// Walks that are a smaller part of the mixture say little about which far items need tables.
const SELDOM: f64 = 0.02;

impl Strong {
    /// Excludes the shortest faults of the walks, which are cycles and stops out of order: the items between the two stops
    /// will remember both. A round adds few members, because each may double the states of an item.
    pub(super) fn remember(&mut self) -> bool {
        let order = &self.ground.order;
        let mut faults: Vec<[usize; 3]> = Vec::new();
        for (w, (_, walk)) in self.walks.iter().enumerate() {
            for (i, v) in walk.iter().enumerate() {
                let wrong = |other: &Visit| other.item == v.item || order.forbids(v.item, other.item, false);
                let length = walk[i + 1..].iter().take(LONGEST).position(wrong);
                faults.extend(length.map(|length| [length, w, i]));
            }
        }
        sort_by(&mut faults, |c| c.map(|x| x as u64));
        let mut added = 0;
        for [length, w, i] in faults {
            let (walk, last) = (&self.walks[w].1, i + 1 + length);
            for between in &walk[i + 1..last] {
                for fault in [walk[i].item, walk[last].item] {
                    if extend_ng_set(&mut self.ground.ng_sets, between.item, fault) {
                        added += 1;
                    }
                }
            }
            if added as f64 >= ADDED * self.ground.count() as f64 {
                break;
            }
        }
        added > 0
    }

    /// Gives tables to the pairs of items between which the walks go without one, half as many as there are items at most. Returns whether
    /// there are any. Without a table a walk arrives anywhere on an item and forgets everything: on the sheet of 100 that is what holds
    /// the bound back most.
    pub(super) fn give_tables(&mut self) -> bool {
        let before = self.wanted.len();
        let most = before + self.ground.count() / 2;
        for (_, walk) in self.walks.iter().filter(|w| w.0 > SELDOM) {
            for [from, to] in legs(walk, &self.ground) {
                let [a, b] = [from.item, to.item];
                let ends = [a.min(b), a.max(b)];
                let is_new = self.ground.pair(a, b).is_none() && !self.wanted.contains(&ends);
                if is_new && self.wanted.len() < most {
                    self.wanted.push(ends);
                }
            }
        }
        self.wanted.len() > before
    }

    /// Halves the pieces at knots whose legs in the walks are priced below their real cost. Returns whether there were any.
    pub(super) fn refine(&mut self, upper: f64) -> bool {
        let marks = self.losses(upper);
        let along: Vec<Vec<f64>> = self.ground.items.iter().map(|item| item.along.clone()).collect();
        for (item, marked) in self.ground.items.iter_mut().zip(&marks).filter(|m| m.1.contains(&true)) {
            if let Some(finer) = item.halved(marked) {
                *item = finer;
            }
        }
        self.bundle.halve(&along, &self.ground.items);
        marks.iter().flatten().any(|&marked| marked)
    }

    /// The same after a look at all orders: pieces that touch no knot in use are dropped. If few are left, all of them are halved.
    pub(super) fn refine_orders(&mut self, upper: f64, in_use: &[Vec<bool>]) -> bool {
        let marks = self.losses(upper);
        let items = &mut self.ground.items;
        let all: usize = items.iter().map(|i| i.pieces.len()).sum();
        let left: usize = items.iter().zip(in_use).map(|(i, used)| i.pieces_left(used)).sum();
        let few = (left as f64) < FEW * all as f64;
        for ((item, marked), in_use) in items.iter_mut().zip(&marks).zip(in_use) {
            let marked: Vec<bool> = marked.iter().map(|&m| few || m).collect();
            if let Some(finer) = item.finer(&marked, in_use) {
                *item = finer;
            }
        }
        marks.iter().flatten().any(|&marked| marked)
    }

    /// For each item which of its pieces are at a knot whose legs in the mixture of walks are priced too low.
    fn losses(&self, upper: f64) -> Vec<Vec<bool>> {
        let ground = &self.ground;
        // The loss at a knot that does not matter.
        let little = LITTLE * (upper - self.best).max(0.0) / ground.count() as f64;
        let mut losses: Vec<Vec<f64>> = ground.items.iter().map(|i| vec![0.0; i.knots]).collect();
        for (weight, walk) in &self.walks {
            // The end of an open path costs nothing.
            let ends = |leg: &[Visit; 2]| ground.first == 1 || leg[1].item >= ground.first;
            for leg in legs(walk, ground).into_iter().filter(ends) {
                let seconds = weight * lost(ground, leg);
                leg.iter().for_each(|v| losses[v.item][v.knot] += seconds);
            }
        }
        let marks = |(item, losses): (&Item, &Vec<f64>)| {
            let bad = |p: &Piece| item.can_be_halved(p) && p.knots.iter().any(|&k| losses[k] > little);
            item.pieces.iter().map(bad).collect()
        };
        ground.items.iter().zip(&losses).map(marks).collect()
    }
}

/// How far a leg between two knots is priced below its real cost, s.
fn lost(ground: &Ground, [from, to]: [Visit; 2]) -> f64 {
    let Some(seconds) = ground.leg(from, to) else { return 0.0 };
    let stops = [from, to].map(|v| (&ground.items[v.item], v.knot));
    ground.prices.real(stops.map(|(item, knot)| (item, knot, item.place(knot)))) - seconds
}
