//! Groups: items of one rank that are visited without any other item in between. A group may contain other groups, so that
//! they form a forest: on sheets that are cut part by part, a part with the parts in its holes.
//!
//! The seam between two successive items belongs to the smallest group that contains both, or to none. A change within a
//! stretch keeps all groups together if the stretch consists of whole members of one group (or of none): the group contains
//! both ends of the stretch, and neither the seam before the stretch nor the one after it is deeper than the group, that is
//! inside one of its members.

use super::ids::ItemId;

/// The group of each item; empty if nothing has to stay together.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Groups {
    pub(super) of: Vec<Option<u32>>,
    /// The group around each group.
    pub(super) around: Vec<Option<u32>>,
    /// The number of groups around each group.
    depth: Vec<u32>,
}

impl Groups {
    /// `of`: the smallest group of each item. `around`: the group around each group.
    pub fn new(of: Vec<Option<u32>>, around: Vec<Option<u32>>) -> Self {
        let mut groups = Self { of, around, depth: Vec::new() };
        // The limit ends every chain, even if the input is not a forest.
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

    /// Number of groups.
    pub fn count(&self) -> usize {
        self.around.len()
    }

    /// The groups of an item, the smallest first.
    pub fn of(&self, item: ItemId) -> impl Iterator<Item = u32> {
        self.outwards(self.of.get(item as usize).copied().flatten())
    }

    /// Whether a stretch with these items at its ends may change its order as whole members of a group. `seams`: the groups
    /// of the seams before and after it, `None` where the rank changes.
    pub fn may_change(&self, group: Option<u32>, ends: [ItemId; 2], seams: [Option<u32>; 2]) -> bool {
        let depth = |g: Option<u32>| g.map_or(0, |g| self.depth[g as usize]);
        let holds = |item: ItemId| group.is_none_or(|g| self.of(item).any(|h| h == g));
        ends.into_iter().all(holds) && seams.into_iter().all(|seam| depth(seam) <= depth(group))
    }

    /// The smallest group that contains two items.
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

    /// Whether an order keeps every group together, within each rank.
    pub fn are_together(&self, order: impl Iterator<Item = ItemId>, rank: impl Fn(ItemId) -> u32) -> bool {
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
        let together_in = |order: &[u32]| groups.are_together(order.iter().copied(), |_| 0);
        for together in [[0, 1, 2, 3, 4], [4, 2, 1, 0, 3], [3, 1, 0, 2, 4]] {
            assert!(together_in(&together), "{together:?}");
        }
        for torn in [[0, 2, 1, 3, 4], [0, 1, 3, 2, 4], [2, 4, 0, 1, 3]] {
            assert!(!together_in(&torn), "{torn:?}");
        }
        // In another rank, a part may start again.
        assert!(groups.are_together([0, 3, 1, 2].into_iter(), |i| u32::from(i != 0 && i != 3)));
    }
}
