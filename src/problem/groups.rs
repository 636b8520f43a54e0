//! Groups: items that follow each other with nothing else in between, as far as their ranks are one. A group may hold
//! other groups, so they form a forest: for sheets worked part by part, a part with what lies in its holes.
//!
//! Whether an order keeps groups together shows at its seams. The seam between two items that follow each other
//! belongs to the smallest group that holds both (or to none). A change within a stretch keeps all groups together if
//! the stretch is made of whole things that lie side by side in one group (or in none): the group holds both its ends,
//! and neither the seam before it nor the one behind it lies deeper than that group, inside one of those things.

use super::ids::ItemId;

/// Which item belongs to which group; empty when nothing has to stay together.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Groups {
    pub(super) of: Vec<Option<u32>>,
    /// The group around each, and how many there are around it.
    pub(super) around: Vec<Option<u32>>,
    depth: Vec<u32>,
}

impl Groups {
    /// `of`: the smallest group of each item. `around`: the group around each group.
    pub fn new(of: Vec<Option<u32>>, around: Vec<Option<u32>>) -> Self {
        let mut groups = Self { of, around, depth: Vec::new() };
        // No chain is longer than there are groups, also where they are no forest.
        let deepest = groups.around.len();
        groups.depth = (0..)
            .zip(&groups.around)
            .map(|(g, _)| groups.outwards(Some(g)).take(deepest).fold(0, |n, _| n + 1))
            .collect();
        groups
    }

    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        self.around.is_empty()
    }

    /// How many there are.
    pub fn count(&self) -> usize {
        self.around.len()
    }

    /// The groups of an item, the smallest first.
    pub fn of(&self, item: ItemId) -> impl Iterator<Item = u32> {
        self.outwards(self.of.get(item as usize).copied().flatten())
    }

    /// Whether a stretch with these items at its ends may change its order as things that lie side by side in a group.
    /// `seams`: the groups of the seams before and behind it, `None` where the rank changes.
    pub fn may_change(&self, group: Option<u32>, ends: [ItemId; 2], seams: [Option<u32>; 2]) -> bool {
        let depth = |g: Option<u32>| g.map_or(0, |g| self.depth[g as usize]);
        let holds = |item: ItemId| group.is_none_or(|g| self.of(item).any(|h| h == g));
        ends.into_iter().all(holds) && seams.into_iter().all(|seam| depth(seam) <= depth(group))
    }

    /// The smallest group that holds two items.
    pub fn common(&self, a: ItemId, b: ItemId) -> Option<u32> {
        let mut a = self.of.get(a as usize).copied().flatten()?;
        let mut b = self.of.get(b as usize).copied().flatten()?;
        while a != b {
            let (x, y) = (self.depth[a as usize], self.depth[b as usize]);
            if x >= y {
                a = self.around[a as usize]?;
            }
            if y >= x {
                b = self.around[b as usize]?;
            }
        }
        Some(a)
    }

    /// Whether an order keeps every group together, in each rank by itself.
    pub fn kept(&self, order: impl Iterator<Item = ItemId>, rank: impl Fn(ItemId) -> u32) -> bool {
        let mut left: Vec<Option<u32>> = vec![None; self.around.len()];
        let mut last: Option<ItemId> = None;
        for item in order {
            for gone in last.iter().flat_map(|&l| self.of(l)).filter(|&g| !self.of(item).any(|h| h == g)) {
                left[gone as usize] = last.map(&rank);
            }
            if self.of(item).any(|g| left[g as usize] == Some(rank(item))) {
                return false;
            }
            last = Some(item);
        }
        true
    }

    fn outwards(&self, group: Option<u32>) -> impl Iterator<Item = u32> {
        std::iter::successors(group, |&g| self.around.get(g as usize).copied().flatten())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn seams_and_orders() {
        // Items 0 and 1 in group 1, which lies in group 0 with item 2; item 3 in group 2; item 4 in none.
        let groups = Groups::new(vec![Some(1), Some(1), Some(0), Some(2), None], vec![None, Some(0), None]);
        assert_eq!(groups.common(0, 1), Some(1));
        assert_eq!(groups.common(0, 2), Some(0));
        assert_eq!(groups.common(2, 3), None);
        assert_eq!(groups.common(4, 0), None);
        assert_eq!(groups.of(0).collect::<Vec<_>>(), [1, 0]);
        let kept = |order: &[u32]| groups.kept(order.iter().copied(), |_| 0);
        for together in [[0, 1, 2, 3, 4], [4, 2, 1, 0, 3], [3, 1, 0, 2, 4]] {
            assert!(kept(&together), "{together:?}");
        }
        for torn in [[0, 2, 1, 3, 4], [0, 1, 3, 2, 4], [2, 4, 0, 1, 3]] {
            assert!(!kept(&torn), "{torn:?}");
        }
        // Of another rank, a part is begun anew.
        assert!(groups.kept([0, 3, 1, 2].into_iter(), |i| u32::from(i != 0 && i != 3)));
    }
}
