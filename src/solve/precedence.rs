//! Which items come before which: lists in both directions, of the pairs that the problem names and no others.
//!
//! The pairs themselves are enough for every test, though precedence is transitive: two neighbouring stretches of a
//! feasible tour may change places if no pair has its first item in one and its second in the other. For let a be
//! in the first stretch, b in the second, and a before b only by way of c: c lies between them, so in one of the
//! two stretches, and one of the pairs (a, c) and (c, b), or one between them again, goes across.

use crate::problem::{ItemId, Problem};

/// Items by item.
struct Lists {
    first: Vec<u32>,
    all: Vec<ItemId>,
}

impl Lists {
    /// The second of each pair, by the first; in the order of the pairs.
    fn new(items: usize, pairs: &[(ItemId, ItemId)]) -> Self {
        let mut first = vec![0; items + 1];
        for (key, _) in pairs {
            first[*key as usize + 1] += 1;
        }
        for i in 1..first.len() {
            first[i] += first[i - 1];
        }
        let mut next = first.clone();
        let mut all = vec![0; pairs.len()];
        for &(key, value) in pairs {
            all[next[key as usize] as usize] = value;
            next[key as usize] += 1;
        }
        Self { first, all }
    }

    fn of(&self, item: ItemId) -> &[ItemId] {
        let i = item as usize;
        &self.all[self.first[i] as usize..self.first[i + 1] as usize]
    }
}

/// Precedence between items, from containment and from given pairs.
pub(super) struct Precedence {
    before: Lists,
    after: Lists,
    /// The one item that waits for an item; [`NONE`] for none, [`SEVERAL`] for more. Nearly all questions end here.
    sole: Vec<ItemId>,
    /// Some item waits for another.
    pub(super) any: bool,
    /// Items wait for what lies inside them, and for nothing else.
    pub(super) nested_only: bool,
}

/// No item waits.
const NONE: ItemId = ItemId::MAX;
/// More than one item waits.
const SEVERAL: ItemId = NONE - 1;

impl Precedence {
    /// Of a problem's items, and home. The start of a cycle is before everything as it is.
    pub(super) fn new(problem: &Problem) -> Self {
        let nested = (0..).zip(&problem.items).filter_map(|(i, item)| Some((i, item.before?)));
        let items = problem.items.len() + 1;
        let pairs: Vec<(ItemId, ItemId)> =
            nested.chain(problem.pairs.iter().copied()).filter(|p| Some(p.0) != problem.start()).collect();
        let turned: Vec<(ItemId, ItemId)> = pairs.iter().map(|&(a, b)| (b, a)).collect();
        let after = Lists::new(items, &pairs);
        let sole = (0..).map(|i| match after.of(i) {
            [] => NONE,
            [one] => *one,
            _ => SEVERAL,
        });
        Self {
            sole: sole.take(items).collect(),
            before: Lists::new(items, &turned),
            after,
            any: !pairs.is_empty(),
            nested_only: !pairs.is_empty() && problem.pairs.is_empty(),
        }
    }

    /// Items that an item waits for.
    pub(super) fn before(&self, item: ItemId) -> &[ItemId] {
        self.before.of(item)
    }

    /// Items that wait for an item.
    pub(super) fn after(&self, item: ItemId) -> &[ItemId] {
        self.after.of(item)
    }

    /// Whether something that `blocks` waits for an item.
    pub(super) fn waits(&self, item: ItemId, blocks: impl Fn(ItemId) -> bool) -> bool {
        match self.sole[item as usize] {
            NONE => false,
            SEVERAL => self.after(item).iter().any(|&i| blocks(i)),
            one => blocks(one),
        }
    }
}
