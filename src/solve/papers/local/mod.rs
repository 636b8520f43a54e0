//! Local search for the published methods: 2-opt and Or-opt over near items, then the best entries for the order found. It
//! ignores precedence; its result is repaired like every other order.

mod entry_choice;
mod local_search;
mod near;
mod search_space;

pub(super) use entry_choice::EntryChoice;
pub(super) use local_search::LocalSearch;
pub(super) use near::NearItems;
pub(super) use search_space::SearchSpace;
