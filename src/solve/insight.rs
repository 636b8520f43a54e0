//! The inner state of a running method, for live charts and tests.

use serde::Serialize;

/// The state of a method at one moment.
#[derive(Clone, Debug, PartialEq, Default, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct Insight {
    /// Iterations or generations done.
    pub round: u64,
    /// Current values, to be drawn against the round.
    pub curves: Vec<Curve>,
    /// A table of numbers, such as a Q-table.
    pub grid: Option<Grid>,
    /// The partitions of its best path, if it makes any.
    pub partitions: Option<Partitions>,
}

/// Partitions: the contours that are cut between leaving a contour and coming back to it.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct Partitions {
    /// Partition of each contour: 0 for that of home, -1 for a contour without entries.
    pub of: Vec<i32>,
    /// Where each partition except that of home hangs, in order.
    pub parents: Vec<Parent>,
}

/// The place where a contour is left for a partition and resumed.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(rename = "PartitionParent"))]
pub struct Parent {
    /// The contour.
    pub contour: u32,
    /// The place, mm.
    pub at: [f64; 2],
}

/// A named value.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(rename = "InsightCurve"))]
pub struct Curve {
    /// Name for people, with the symbol of the paper.
    pub name: &'static str,
    /// Current value.
    pub value: f64,
    /// Title of the chart in which it is drawn, together with the other curves of that title: they have one unit.
    pub chart: &'static str,
}

/// The charts of the published methods, by title.
#[cfg(feature = "research")]
pub(super) mod charts {
    pub(in super::super) const LENGTH: &str = "Length, mm";
    pub(in super::super) const SECONDS: &str = "Seconds";
    pub(in super::super) const COUNTS: &str = "Partitions and pre-cuts";
    pub(in super::super) const WORK: &str = "Share of the work by step";
    pub(in super::super) const PROSPECT: &str = "Prospect-regret value";
    pub(in super::super) const WEIGHTS: &str = "Inertia and learning factors";
    pub(in super::super) const SINGER: &str = "Singer map";
    pub(in super::super) const FLIGHTS: &str = "Levy flights: kappa against tau";
    pub(in super::super) const OPERATORS: &str = "Share of each crossover";
    pub(in super::super) const STATES: &str = "Share of each state";
    pub(in super::super) const REWARD: &str = "Diversity and reward";
    pub(in super::super) const FITNESS: &str = "Fitness";
}

/// A named table of numbers.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(rename = "InsightGrid"))]
pub struct Grid {
    /// Name for people.
    pub name: &'static str,
    /// Names of the rows.
    pub rows: Vec<&'static str>,
    /// Names of the columns.
    pub columns: Vec<&'static str>,
    /// Values, row by row.
    pub values: Vec<f64>,
    /// Index of the value that was used last.
    pub at: Option<usize>,
}
