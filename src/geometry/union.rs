//! Disjoint sets; the smallest member is the root, so numbering follows first members.

/// Disjoint sets of numbers from 0 on.
pub(crate) struct Union(Vec<u32>);

impl Union {
    /// Sets of one member each.
    pub(crate) fn new(n: usize) -> Self {
        Self((0_u32..).take(n).collect())
    }

    /// Adds a set of one member, and returns it.
    pub(crate) fn add(&mut self) -> u32 {
        let next = u32::try_from(self.0.len()).unwrap_or(u32::MAX);
        self.0.push(next);
        next
    }

    /// The smallest member of a member's set.
    pub(crate) fn root(&mut self, mut i: u32) -> u32 {
        while self.0[i as usize] != i {
            let up = self.0[self.0[i as usize] as usize];
            self.0[i as usize] = up;
            i = up;
        }
        i
    }

    /// Makes two sets one, and says whether they were two.
    pub(crate) fn join(&mut self, a: u32, b: u32) -> bool {
        let (a, b) = (self.root(a), self.root(b));
        self.0[a.max(b) as usize] = a.min(b);
        a != b
    }

    /// For each member the number of its set; sets are numbered in order of their first member.
    pub(crate) fn numbered(mut self) -> Vec<u32> {
        let mut number = vec![0; self.0.len()];
        let mut next = 0;
        for i in 0_u32.. {
            if i as usize == number.len() {
                break;
            }
            let root = self.root(i);
            if root == i {
                number[i as usize] = next;
                next += 1;
            } else {
                number[i as usize] = number[root as usize];
            }
        }
        number
    }
}
