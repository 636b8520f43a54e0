//! Legs that matter at a temperature.

/// Legs from one knot of an item, in whatever state, to knots of a state of another.
#[derive(Clone, Copy, Debug)]
pub(super) struct Slot {
    /// The step of the net.
    pub(super) step: u32,
    pub(super) knot: u32,
    /// Where its legs start, and the parts of the states left.
    pub(super) legs: u32,
    pub(super) parts: u32,
}

/// A leg to a knot of a state.
#[derive(Clone, Copy, Debug)]
pub(super) struct Leg {
    /// The place of the knot in a row of numbers.
    pub(super) to: u32,
    pub(super) seconds: f64,
}

/// All legs between two items without a table.
#[derive(Clone, Copy, Debug)]
pub(super) struct Far {
    pub(super) from: usize,
    pub(super) to: usize,
    pub(super) seconds: f64,
}

/// The legs that matter, and how much the smooth solution uses them.
#[derive(Clone, Debug, Default)]
pub(super) struct Legs {
    /// The last one only ends the lists of the one before.
    pub(super) slots: Vec<Slot>,
    pub(super) legs: Vec<Leg>,
    /// How much each leg is used, up to a factor for each item that it leads to.
    pub(super) uses: Vec<f64>,
    /// The part of each state left in what leaves a knot.
    pub(super) parts: Vec<f64>,
    pub(super) far: Vec<Far>,
}

impl Legs {
    /// Work of a step: exponentials take about as long as four numbers.
    pub(super) fn work(&self) -> u64 {
        6 * (1 + self.legs.len() + self.parts.len()) as u64
    }

    /// Each slot with its legs and its parts.
    pub(super) fn each(&self) -> impl Iterator<Item = (Slot, std::ops::Range<usize>)> + '_ {
        self.slots.windows(2).map(|w| (w[0], w[0].legs as usize..w[1].legs as usize))
    }
}
