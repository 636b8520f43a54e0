//! Dewil, Vansteenwegen, Cattrysse, Laguna & Vossen (2014): the partition-tree, for plate in which a piercing costs seconds.
//!
//! Contours are in **partitions**: routes, each of which hangs at a node of a contour in its parent partition, where that
//! contour is left (a pre-cut) and resumed; the root's hangs at home. A path is a partitioning, a rooted directed spanning
//! tree between partitions, and a generalized travelling salesman tour within each. What is minimised is seconds of air
//! moves, pre-cuts and what entries cost by their place; piercing and cutting are the same for every path.
//!
//! The steps of section 4, and where they stand:
//! 1. (a) Initial partitions: the construction heuristic `pfr.rs`; or one partition; or each contour its own. (b) GTSP of
//!    partitions without precedence, `gtsp.rs`. (c) Repartition with precedence, `repartition.rs`.
//! 2. Cheapest connections (`connect.rs`) and the least arborescence of them (`edmonds.rs`).
//! 3. Its resolution, cases (a) to (d), `resolve.rs`.
//! 4. GTSP in every partition.
//! 5. Repartition without precedence: `partitions.rs` (a partition hung up elsewhere; merged with single children and hung
//!    up elsewhere) and `sequences.rs` (a sub-sequence becomes a partition; goes into another).
//! 6. Back to 2, until 10 rounds brought no gain.
//! 7. Restored feasibility, `repair.rs`.
//! 8. Improved entries, `entries.rs`, and repartition with precedence.
//! 9. The path, `walk.rs`.
//!
//! # Where this differs from the paper
//! * LKH on the problem transformed by Noon and Bean is not here: the moves of our default search solve the partition
//!   (`gtsp.rs`), and a partition that has not changed since is not solved again.
//! * Nodes are the entries of [`Problem`](crate::problem::Problem): ends of elements and even places between them.
//! * Moves and connections are looked for among near nodes (`ground.rs`), not among all; sub-sequences are of 50 contours at
//!   most.
//! * Where a partition is hung up elsewhere, its ring may be broken elsewhere too, and a single contour be entered
//!   elsewhere: the paper does not say that they are not.
//! * The paper's PFr is told in four sentences; how we read them stands in `pfr.rs`.
//! * Contours are run in their stored direction. With several partitions on one contour the direction may matter for
//!   precedence (footnote 4); the moves that keep precedence check the whole path.
//! * A contour that is moved in the repair leaves what hung from it in its old place.
//! * The best path is the best allowed one at the ends of construction, step 1 and step 8: with PFr to start from, never
//!   worse than PFr. The value at the very end is a curve of its own.
//! * Contours without pre-cuts (marks, open cuts, groups with common cuts, machines that leave nothing) are no parents but
//!   beside their entry. Ranks, groups, pairs and tables of costs: see `single.rs`.
//!
//! [`GtspLk`] is one partition alone, [`Pfr`] the construction.

mod connect;
mod edmonds;
mod entries;
mod forest;
mod frame;
mod ground;
mod gtsp;
mod methods;
mod moves;
mod params;
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
mod told;
mod walk;

pub use methods::{GtspLk, Pfr};
pub use params::{InitialPartitions, InitialTours, PartitionTree};
pub use repartition::RepartitionMoves;
