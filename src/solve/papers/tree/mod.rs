//! The partition-tree of Dewil, Vansteenwegen, Cattrysse, Laguna & Vossen (2014), for plate in which a piercing takes
//! seconds.
//!
//! Contours are divided into **partitions**. Each partition is a route that is attached to a node of a contour in its
//! parent partition. That contour is left at the node, with a pre-cut, and resumed after the route. The root is attached to
//! home. So a path consists of a partitioning, a rooted directed spanning tree between partitions, and a generalized
//! travelling salesman tour (GTSP) within each. The method minimises the seconds of air moves, pre-cuts and entries;
//! piercing and cutting times are the same for every path.
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
//!   elsewhere. The paper does not exclude this.
//! * The paper describes PFr in four sentences; `pfr.rs` states how they were interpreted.
//! * Contours are cut in their stored direction. With several partitions on one contour the direction may matter for
//!   precedence (footnote 4); the moves that keep precedence check the whole path.
//! * A contour that is moved by the repair leaves everything attached to it in its old place.
//! * The best path is the best feasible one after the construction, step 1 and step 8. With PFr as the start it is never
//!   worse than PFr. The value at the end is a separate curve.
//! * Contours without pre-cuts (marks, open cuts, machines that do not leave contours) can be parents only next to their
//!   entry. For ranks, groups, pairs and tables of costs see `single.rs`.
//! * A pierce group with common cuts is entered by one of the paths that were found through it beforehand, and left at the
//!   nodes that this path passes (section 4.7). A partition that hangs from a group stays at its node when the path changes.
//!   Where the path makes an air move anyway, the partition bridges it, as in figure 8d.
//!
//! [`GtspLk`] is one partition alone, repaired in another way than the paper's (`single.rs`); [`Pfr`] is the construction.

mod connect;
mod drawn_partitions;
mod edmonds;
mod element_ends;
mod entries;
mod forest;
mod framework;
mod graph;
mod gtsp;
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
pub use parameters::{InitialPartitions, InitialTours, PartitionTree};
pub use repartition::RepartitionMoves;
