//! The partition-tree of Dewil, Vansteenwegen, Cattrysse, Laguna & Vossen (2014), for plate in which a piercing takes
//! seconds.
//!
//! Contours are divided into **partitions**. Each partition is a route that is attached to a node of a contour in its
//! parent partition. That contour is left at the node, with a pre-cut, and resumed after the route. The root is attached to
//! home. So a path consists of a partitioning, a rooted directed spanning tree between partitions, and a generalized
//! travelling salesman tour (GTSP) within each. The method minimises the seconds of air moves, pre-cuts, entries and pauses in
//! sharp corners; piercing and cutting times are the same for every path.
//!
//! The steps of section 4 and their files:
//! 1. (a) Initial partitions: the construction heuristic `pfr.rs`, or one partition, or one for each contour. (b) GTSP of
//!    partitions without precedence, `gtsp.rs`. (c) Repartitioning with precedence, `repartition.rs`.
//! 2. Cheapest connections (`connect.rs`) and their minimum arborescence (`edmonds.rs`).
//! 3. Rebuilding the tree from it, cases (a) to (d), `resolve.rs`.
//! 4. GTSP in every partition.
//! 5. Repartitioning without precedence: `partitions.rs` (a partition is attached elsewhere, or merged with single children
//!    first) and `sequences.rs` (a sub-sequence becomes a partition or moves to another).
//! 6. Back to step 2, until 10 rounds in a row brought no improvement.
//! 7. Restoring feasibility, `repair.rs`.
//! 8. Improving entries, `entries.rs`, and repartitioning with precedence.
//! 9. The path, `visits.rs`.
//!
//! # Differences from the paper
//! * The paper solves the GTSP with LKH on the problem transformed by Noon and Bean. Here the moves of our default search
//!   solve it (`gtsp.rs`), and a partition that has not changed is not solved again.
//! * Nodes are the entries of [`Problem`](crate::problem::Problem): ends of elements and evenly spaced places between them.
//!   The parameter `nodes` selects the ends of all elements instead (`element_ends.rs`).
//! * Moves and connections are searched among near nodes (`graph.rs`), not among all, and sub-sequences have at most 50
//!   contours. The parameter `neighbourhood` lifts these limits.
//! * When a partition is attached elsewhere, its ring may be opened elsewhere too, and a single contour may be entered
//!   elsewhere, also where it moves as a sub-sequence. The paper says "simply the reattachment". The parameter `reattach`
//!   switches both off.
//! * A merger of two or three contours is tried in every order with the best entries of each. The paper says only that it
//!   is evaluated.
//! * The paper describes PFr in four sentences; `pfr.rs` states how they were interpreted.
//! * The paper does not say in which direction a contour is cut, as that does not change the time (footnote 1). Here it is
//!   the stored direction. With several partitions on one contour it can matter for precedence (footnote 4), and the moves
//!   that keep precedence check the whole path.
//! * Steps 7 and 8 begin from the best round, not from the last one.
//! * The repair works on the path (section 4.6): "the entire contour is shifted". So what is attached to the contour keeps its
//!   place in the path. Contours are repaired from the innermost outwards, not in the order of the path.
//! * Step 8 chooses the entries of all contours; in the paper those of the contours that the repair moved, which the
//!   parameter `entries` selects.
//! * The best path is the best feasible one after the construction and after steps 1, 7 and 8. With PFr as the start it is
//!   never worse than PFr. The value at the end is a separate curve.
//! * Nothing can be attached to a contour that may not be left (marks, open cuts, machines that do not leave contours); where
//!   the arborescence leads to one, the child goes next to it in its route. For ranks, groups, pairs and tables of costs see
//!   `single.rs`.
//! * The paths through a pierce group with common cuts are found beforehand: by default by exact and beam search, some of
//!   them with air moves that contours beside the group bridge (figure 8b, which the authors tried and left out). The paper
//!   uses its element insertion heuristic (section 4.7), which the option `common_cuts: insertion` of a job selects; it is
//!   not a parameter of the method. A group is left at the nodes that its path passes, and a partition that hangs from it
//!   stays at its node when the path changes. Where the path makes an air move anyway, the partition bridges it, as in
//!   figure 8d.
//!
//! [`GtspLk`] is one partition alone, by default repaired in another way than the paper's (`single.rs`); [`Pfr`] is the
//! construction.

mod connect;
mod drawn_partitions;
mod edmonds;
mod element_ends;
mod entries;
mod forest;
mod framework;
mod graph;
mod gtsp;
mod hooks;
mod methods;
mod moves;
mod parameters;
mod partitions;
mod pfr;
mod repair;
mod repartition;
mod resolve;
mod sequences;
mod single;
mod stage;
#[cfg(test)]
mod tests;
mod visits;

pub use methods::{GtspLk, Pfr};
pub use moves::Reattach;
pub use parameters::{FinalEntries, InitialPartitions, InitialTours, PartitionTree, TourRepair};
pub use repartition::RepartitionMoves;
