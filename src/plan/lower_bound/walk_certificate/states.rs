//! The states of walks as the check of a certificate knows them: the item where a walk is, and which of the items in this item's ng-set it must not
//! visit any more.
//!
//! A walk must not come back to an item, nor to one that has to be before an item it has been to. It knows that of an item as long as this item is in the ng-sets
//! of all items since.

use super::super::fault::CertificateFault;
use super::super::order::Order;
use std::collections::BTreeMap;
use std::ops::Range;

/// Most items: the sets of all of them take two megabytes.
pub(super) const MOST_ITEMS: usize = 4_096;
/// Most states, and most legs between them: about 100 MB. The search for the bound has room for far fewer.
const MOST_STATES: usize = 200_000;
const MOST_LEGS: usize = 4_000_000;
/// Most numbers in the sets of all states: 64 MB.
const MOST_WORDS: usize = 4_000_000;

/// Some items, as bits.
#[derive(Clone, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
struct Set(Vec<u128>);

impl Set {
    fn of(items: impl Iterator<Item = usize>, count: usize) -> Self {
        let mut bits = vec![0; count.div_ceil(128)];
        items.for_each(|i| bits[i / 128] |= 1 << (i % 128));
        Self(bits)
    }

    fn has(&self, item: usize) -> bool {
        self.0[item / 128] >> (item % 128) & 1 == 1
    }

    fn add(&mut self, other: &Self) {
        self.0.iter_mut().zip(&other.0).for_each(|(a, b)| *a |= b);
    }

    fn and(&self, other: &Self) -> Self {
        Self(self.0.iter().zip(&other.0).map(|(a, b)| a & b).collect())
    }
}

/// Legs from one item to a state of another, which is near.
#[derive(Clone, Debug)]
pub(super) struct Step {
    pub(super) to: usize,
    pub(super) from: usize,
    /// The states left, a range of [`States::sources`].
    pub(super) sources: Range<usize>,
}

/// All states that walks come to, and the legs between them.
#[derive(Clone, Debug, Default)]
pub(super) struct States {
    /// The item of each.
    pub(super) item: Vec<usize>,
    /// What walks must not come to any more.
    sets: Vec<Set>,
    /// For each item the state of a walk that remembers nothing.
    pub(super) fresh: Vec<usize>,
    /// By the state they lead to.
    pub(super) steps: Vec<Step>,
    pub(super) sources: Vec<usize>,
    /// For each item those that are not near and from where a walk may come.
    pub(super) far: Vec<Vec<usize>>,
}

impl States {
    /// The states of walks over the items from `first` on. `near`: for each item the later ones that it is near; `ng_sets`: for each item what walks
    /// remember there.
    pub(super) fn new(
        (near, ng_sets): (&[Vec<usize>], &[Vec<usize>]),
        order: &Order,
        first: usize,
    ) -> Result<Self, CertificateFault> {
        let count = ng_sets.len();
        // Where a walk must not come to after each item.
        let set = |items: &mut dyn Iterator<Item = usize>| Set::of(items, count);
        let barred: Vec<Set> = (0..count)
            .map(|past| set(&mut (first..count).filter(|&i| i == past || order.forbids(past, i, false))))
            .collect();
        let lists: Vec<Set> = ng_sets.iter().map(|list| set(&mut list.iter().copied())).collect();
        let later: Vec<Set> = near.iter().map(|list| set(&mut list.iter().copied())).collect();
        let are_near = |a: usize, b: usize| later[a.min(b)].has(a.max(b));
        let pairs = |of: usize, near: bool| -> Vec<usize> {
            (first..count).filter(|&other| other != of && are_near(of, other) == near).collect()
        };
        let to_near: Vec<Vec<usize>> = (0..count).map(|item| pairs(item, true)).collect();
        let mut states = Self::default();
        for item in 0..count {
            let far = if item < first { Vec::new() } else { pairs(item, false) };
            states.far.push(far.into_iter().filter(|&from| !barred[from].has(item)).collect());
        }
        let mut known: BTreeMap<(usize, Set), usize> = BTreeMap::new();
        let mut state = |states: &mut Self, item: usize, set: Set| {
            *known.entry((item, set.clone())).or_insert_with(|| {
                states.item.push(item);
                states.sets.push(set);
                states.sets.len() - 1
            })
        };
        for item in 0..count {
            let fresh = if item < first { 0 } else { state(&mut states, item, set(&mut std::iter::empty())) };
            states.fresh.push(fresh);
        }
        // State led to, item left, state left.
        let mut legs: Vec<[u32; 3]> = Vec::new();
        let mut at = 0;
        while let Some(&item) = states.item.get(at) {
            let mut out = barred[item].clone();
            states.barred_in(at, ng_sets).for_each(|i| out.add(&barred[i]));
            for &next in to_near[item].iter().filter(|&&next| !out.has(next)) {
                let to = state(&mut states, next, out.and(&lists[next]));
                let words = states.sets.len() * count.div_ceil(128);
                if states.sets.len() > MOST_STATES || words > MOST_WORDS || legs.len() >= MOST_LEGS {
                    return Err(CertificateFault::TooMuch("states of walks"));
                }
                legs.push([to, item, at].map(|x| u32::try_from(x).unwrap_or(u32::MAX)));
            }
            at += 1;
        }
        legs.sort_unstable();
        for [to, from, source] in legs.into_iter().map(|leg| leg.map(|x| x as usize)) {
            let end = states.sources.len() + 1;
            states.sources.push(source);
            match states.steps.last_mut().filter(|s| (s.to, s.from) == (to, from)) {
                Some(step) => step.sources.end = end,
                None => states.steps.push(Step { to, from, sources: end - 1..end }),
            }
        }
        Ok(states)
    }

    /// What is in the ng-set of a state's item and must not be visited any more.
    pub(super) fn barred_in<'s>(
        &'s self,
        state: usize,
        ng_sets: &'s [Vec<usize>],
    ) -> impl Iterator<Item = usize> + 's {
        ng_sets[self.item[state]].iter().copied().filter(move |&i| self.sets[state].has(i))
    }
}
