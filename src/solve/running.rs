//! A problem with the search that works on it.

use crate::problem::Problem;
use crate::solve::Search;

type Searching<'p> = Box<dyn Search + 'p>;

// The search borrows its problem; both live as long as their owner.
self_cell::self_cell!(
    pub(super) struct Running {
        owner: Problem,
        #[covariant]
        dependent: Searching,
    }
);
