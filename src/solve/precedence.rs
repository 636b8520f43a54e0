//! Precedence between items: lists in both directions of the pairs that the problem names, without their transitive closure.
//!
//! The named pairs are enough, although precedence is transitive: two neighbouring stretches of a feasible tour may change
//! places if no pair has its first item in one stretch and its second in the other. Proof: let a be in the first stretch, b
//! in the second, and a before b only through c. Then c is between them, so in one of the two stretches, and one of the
//! pairs (a, c) and (c, b) crosses from one stretch to the other, or again has an item between that does.

use crate::problem::{ItemId, Problem};

/// A list of items for each item, all in one array.
struct Lists {
    first: Vec<u32>,
    all: Vec<ItemId>,
}

impl Lists {
    /// The second items of the pairs by their first item, in the order of the pairs.
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
    /// The only item that waits for an item; [`NONE`] if there is none, [`SEVERAL`] if there are more. Nearly all queries
    /// are answered here.
    sole: Vec<ItemId>,
    /// Whether any item waits for another.
    pub(super) any: bool,
    /// Whether precedence comes from containment alone, not from given pairs.
    pub(super) nested_only: bool,
}

/// No item waits for this one.
const NONE: ItemId = ItemId::MAX;
/// More than one item waits for this one.
const SEVERAL: ItemId = NONE - 1;

impl Precedence {
    /// The precedence of a problem's items and home. Pairs with the start of a cycle are left out, because it comes first anyway.
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
            nested_only: !pairs.is_empty() && problem.table().is_none(),
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
