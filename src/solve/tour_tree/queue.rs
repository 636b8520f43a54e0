//! The work queue of a local search.

use std::collections::VecDeque;

/// Items around which the tour has changed. Each is in the queue at most once.
pub(super) struct Queue {
    items: VecDeque<u32>,
    waiting: Vec<bool>,
}

impl Queue {
    pub(super) fn new(items: usize) -> Self {
        Self { items: VecDeque::new(), waiting: vec![false; items] }
    }

    pub(super) fn push(&mut self, item: u32) {
        if !std::mem::replace(&mut self.waiting[item as usize], true) {
            self.items.push_back(item);
        }
    }

    pub(super) fn push_all(&mut self, items: &[u32]) {
        items.iter().for_each(|&i| self.push(i));
    }

    pub(super) fn pop(&mut self) -> Option<u32> {
        let item = self.items.pop_front()?;
        self.waiting[item as usize] = false;
        Some(item)
    }
}
