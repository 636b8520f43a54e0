//! What makes a method special, while it works: for live charts and tests.

use serde::Serialize;

/// Numbers of a method at one time.
#[derive(Clone, Debug, PartialEq, Default, Serialize)]
pub struct Insight {
    /// Iterations or generations done.
    pub round: u64,
    /// Values now; whoever listens draws them against the round.
    pub curves: Vec<Curve>,
    /// A table of numbers, such as a Q-table.
    pub grid: Option<Grid>,
    /// The partitions of its best path, where it makes them.
    pub partitions: Option<Partitions>,
}

/// Which contours are cut between leaving a contour and coming back to it.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Partitions {
    /// Partition of each contour, 0 that of home; -1 for a contour without entries.
    pub of: Vec<i32>,
    /// Where each but that of home hangs, from the first on.
    pub parents: Vec<Parent>,
}

/// A place where a contour is left for a partition and resumed.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Parent {
    /// The contour.
    pub contour: u32,
    /// The place, mm.
    pub at: [f64; 2],
}

/// A value with its name.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Curve {
    /// For people, with its symbol in the paper.
    pub name: &'static str,
    /// Its value now.
    pub value: f64,
}

/// Numbers by row and column.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Grid {
    /// For people.
    pub name: &'static str,
    /// Names of its rows.
    pub rows: Vec<&'static str>,
    /// Names of its columns.
    pub columns: Vec<&'static str>,
    /// Row by row.
    pub values: Vec<f64>,
    /// The one last used.
    pub at: Option<usize>,
}
