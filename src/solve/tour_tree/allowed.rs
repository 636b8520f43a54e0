//! Which changes of order precedence, ranks and groups allow. The local search asks only for moves that gain.

use super::tour::Tour;

impl Tour<'_> {
    /// Whether the tour keeps ranks, groups and, unless nesting is ignored, precedence. For debug assertions.
    pub(super) fn is_feasible(&self) -> bool {
        let rank = |p: usize| self.space.rank[self.item(p) as usize];
        let ranks = (2..=self.last()).all(|p| rank(p - 1) <= rank(p));
        let late = |i: u32| self.space.precedence.waits(i, |o| self.position(o) < self.position(i));
        ranks
            && self.keeps_all_groups()
            && (self.ignores_nesting || !self.current().order.iter().any(|&i| late(i)))
    }

    /// Whether all groups are together.
    pub(super) fn keeps_all_groups(&self) -> bool {
        let (groups, items) = (&self.space.problem.groups, self.current().order[1..].iter().copied());
        groups.is_empty() || groups.are_together(items, |i| self.space.rank[i as usize])
    }

    /// Whether a stretch may be reversed: nothing in it waits for anything else in it.
    pub(super) fn may_reverse(&self, from: usize, to: usize) -> bool {
        let stretch = &self.current().order[from..=to];
        self.same_rank(from, to)
            && self.keeps_groups(from, to, [self.item(from), self.item(to)])
            && (self.ignores_precedence()
                || !stretch.iter().any(|&i| self.space.precedence.waits(i, |o| self.position(o) <= to)))
    }

    /// Whether two neighbouring stretches may change places: nothing in the second waits for anything in the first.
    pub(super) fn may_exchange(&self, from: usize, middle: usize, to: usize) -> bool {
        let between = [self.item(middle), self.item(middle + 1)];
        if !self.same_rank(from, to) || !self.keeps_groups(from, to, between) {
            return false;
        }
        if self.ignores_precedence() {
            return true;
        }
        // The shorter stretch is looked through.
        if middle - from < to - middle {
            let second = middle + 1..=to;
            !self.current().order[from..=middle]
                .iter()
                .any(|&i| self.space.precedence.waits(i, |o| second.contains(&self.position(o))))
        } else {
            self.current().order[middle + 1..=to].iter().all(|&i| {
                self.space.precedence.before(i).iter().all(|&c| !(from..=middle).contains(&self.position(c)))
            })
        }
    }

    fn ignores_precedence(&self) -> bool {
        self.ignores_nesting || !self.space.precedence.any
    }

    /// Whether groups stay together when the order of a stretch changes; `of` is a pair of items whose common group holds
    /// what changes places, see `problem/groups.rs`.
    fn keeps_groups(&self, from: usize, to: usize, of: [u32; 2]) -> bool {
        let groups = &self.space.problem.groups;
        let seam = |p: usize| {
            let (a, b) = (self.item(p - 1), self.item(p));
            let one_rank = self.space.rank[a as usize] == self.space.rank[b as usize];
            if one_rank { groups.common(a, b) } else { None }
        };
        groups.is_empty()
            || groups.may_change(
                groups.common(of[0], of[1]),
                [self.item(from), self.item(to)],
                [seam(from), seam(to + 1)],
            )
    }

    /// Whether a stretch has one rank. Ranks never fall along the tour, so that its ends decide.
    fn same_rank(&self, from: usize, to: usize) -> bool {
        self.space.rank[self.item(from) as usize] == self.space.rank[self.item(to) as usize]
    }
}
