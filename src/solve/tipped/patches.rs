//! What the local search has changed in a path of the method, so that it can be changed in the method's next path as well.
//!
//! From one best to the next the method changes little of a large path, and would undo what the local search has gained in the
//! rest. A patch is a window with the same items in both sequences, in another order or with other entries. It fits a new
//! sequence where the items of the window follow each other as before.

use super::change::Change;
use super::sequence::Sequence;
use super::visit::Visit;
use crate::problem::ItemId;
use crate::solve::epsilon::EPSILON;
use crate::solve::traits::Stop;

/// A window before and after the local search.
pub(super) struct Patch {
    items: Vec<ItemId>,
    /// The stops after it, and whether each is entered as before.
    visits: Vec<(Visit, bool)>,
}

/// The smallest windows by which a sequence differs from the stops it began as.
pub(super) fn patches(before: &[Stop], now: &Sequence) -> Vec<Patch> {
    let mut patches = Vec::new();
    if before.len() != now.len() {
        return patches;
    }
    let items: Vec<ItemId> =
        before.iter().filter_map(|s| Some(now.problem.nodes.get(s.node as usize)?.item)).collect();
    let places = now.problem.items.len();
    let mut entered = vec![None; places];
    for (item, stop) in items.iter().zip(before) {
        if let Some(place) = entered.get_mut(*item as usize) {
            *place = Some(*stop);
        }
    }
    let is_kept = |visit: &Visit| entered.get(visit.item as usize).is_some_and(|s| *s == Some(visit.stop));
    // By item: 1 if the window so far has it before and not now, and -1 the other way round.
    let mut balance = vec![0_i8; places];
    let mut unbalanced = 0_usize;
    let mut low = None;
    for (k, (&old, new)) in items.iter().zip(now.visits()).enumerate() {
        if old != new.item {
            for (item, by) in [(old, 1), (new.item, -1)] {
                if let Some(balance) = balance.get_mut(item as usize) {
                    *balance += by;
                    unbalanced = if *balance == 0 { unbalanced.saturating_sub(1) } else { unbalanced + 1 };
                }
            }
        } else if low.is_none() && is_kept(new) {
            continue;
        }
        let from = *low.get_or_insert(k);
        if unbalanced == 0 {
            let visits = now.visits().get(from..=k).into_iter().flatten();
            patches.push(Patch {
                items: items.get(from..=k).unwrap_or_default().to_vec(),
                visits: visits.map(|v| (*v, is_kept(v))).collect(),
            });
            low = None;
        }
    }
    patches
}

impl Patch {
    /// Changes a sequence as the local search did, where that fits and gains.
    pub(super) fn apply(&self, sequence: &mut Sequence) {
        let Some(low) = self.items.first().and_then(|&first| sequence.position(first)) else { return };
        let Some(here) = sequence.visits().get(low..low + self.items.len()) else { return };
        if !here.iter().map(|v| v.item).eq(self.items.iter().copied()) {
            return;
        }
        let entered = |&(visit, kept): &(Visit, bool)| {
            let known = sequence.position(visit.item).filter(|_| kept).and_then(|k| sequence.visit(k));
            known.copied().unwrap_or(visit)
        };
        let visits = self.visits.iter().map(entered).collect();
        sequence.try_change(&mut Change { low, visits, rotated: None }, EPSILON);
    }
}
