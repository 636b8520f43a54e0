//! A problem together with the search that works on it.

use super::Search;
use crate::problem::Problem;

type Searching<'p> = Box<dyn Search + 'p>;

// The search borrows its problem; both live as long as their owner.
self_cell::self_cell!(
    pub(crate) struct Running {
        owner: Problem,
        #[covariant]
        dependent: Searching,
    }
);
