//! The order in which items are finished: a linked list with increasing labels, so that "finished before" is one comparison
//! and moving a stretch takes as many steps as it has items.
//!
//! Whatever is cut while an item is unfinished is finished before it: an item and all that hangs from it are one stretch,
//! which the item ends. Source of the labels: Dietz & Sleator, Two algorithms for maintaining order in a list, STOC 1987, in
//! its simplest form: if no room is left between two labels, all labels are written again.

/// The list. Home is both its end and its beginning.
#[derive(Clone)]
pub(super) struct FinishOrder {
    next: Vec<u32>,
    previous: Vec<u32>,
    label: Vec<u64>,
    home: u32,
}

impl FinishOrder {
    /// A list that holds only home, which has the largest number of all items.
    pub(super) fn new(home: u32) -> Self {
        let all = vec![home; home as usize + 1];
        Self { next: all.clone(), previous: all, label: vec![0; home as usize + 1], home }
    }

    pub(super) fn next(&self, item: u32) -> u32 {
        self.next[item as usize]
    }

    pub(super) fn previous(&self, item: u32) -> u32 {
        self.previous[item as usize]
    }

    /// The label of an item, which increases along the list; that of home is 0.
    pub(super) fn label(&self, item: u32) -> u64 {
        self.label[item as usize]
    }

    /// Whether an item is in the stretch from `first` to `last`; home is in none.
    pub(super) fn holds(&self, first: u32, last: u32, item: u32) -> bool {
        (self.label(first)..=self.label(last)).contains(&self.label(item))
    }

    /// The items from `first` to `last`.
    pub(super) fn stretch(&self, first: u32, last: u32) -> impl Iterator<Item = u32> {
        std::iter::successors(Some(first), move |&i| (i != last).then(|| self.next(i)))
    }

    /// Appends a new item.
    pub(super) fn append(&mut self, item: u32) {
        self.link(item, item, self.previous(self.home));
    }

    /// Moves the stretch from `first` to `last` after `to`, which is not in it.
    pub(super) fn move_stretch(&mut self, first: u32, last: u32, to: u32) {
        let (before, after) = (self.previous(first), self.next(last));
        if before == to {
            return;
        }
        self.next[before as usize] = after;
        self.previous[after as usize] = before;
        self.link(first, last, to);
    }

    fn link(&mut self, first: u32, last: u32, to: u32) {
        let after = self.next(to);
        self.next[to as usize] = first;
        self.previous[first as usize] = to;
        self.next[last as usize] = after;
        self.previous[after as usize] = last;
        let high = if after == self.home { u64::MAX } else { self.label(after) };
        let count = self.stretch(first, last).count() as u64;
        let step = (high - self.label(to)) / (count + 1);
        if step > 0 {
            self.number(first, last, self.label(to), step);
        } else {
            let all = self.next.len() as u64;
            self.number(self.next(self.home), self.previous(self.home), 0, u64::MAX / (all + 1));
        }
    }

    fn number(&mut self, first: u32, last: u32, from: u64, step: u64) {
        let (mut item, mut label) = (first, from);
        loop {
            label += step;
            self.label[item as usize] = label;
            if item == last {
                return;
            }
            item = self.next(item);
        }
    }
}
