//! Cuts: parts into which places are divided, with the price of connecting them.

/// A leg between two knots of a pair of items, by their places in the lists of all knots.
#[derive(Clone, Copy, Debug)]
pub(super) struct Leg {
    pub(super) ends: [u32; 2],
    pub(super) seconds: f64,
}

/// Places divided into parts. Part 0 holds home and everything that is not listed.
#[derive(Clone, Debug)]
pub(super) struct Partition {
    /// Items of which some knots are in other parts, in ascending order, with the part of each knot.
    pub(super) held: Vec<(usize, Vec<u32>)>,
    /// For each part from 1 on the item whose stops there are counted; `None` if an item lies in it whole.
    pub(super) visited: Vec<Option<usize>>,
    /// The price of joining one part to the others, s.
    pub(super) price: f64,
    /// The active legs that cross it.
    pub(super) crossing: Vec<u32>,
    /// How much of what it asks for there is in the smooth solution: both sides of the inequality.
    pub(super) there: f64,
    pub(super) asked: f64,
}

impl Partition {
    pub(super) fn new(held: Vec<(usize, Vec<u32>)>, visited: Vec<Option<usize>>) -> Self {
        Self { held, visited, price: 0.0, crossing: Vec::new(), there: 0.0, asked: f64::INFINITY }
    }

    /// The share of its price that a leg between two of its parts pays.
    pub(super) fn of_leg(&self) -> f64 {
        let others = self.visited.len() as f64;
        others / (others + 1.0)
    }

    /// What a leg between two of its parts pays: without rounding, if the price is the number of all parts times a whole number of units.
    pub(super) fn leg_price(&self) -> f64 {
        let others = self.visited.len() as f64;
        self.price / (others + 1.0) * others
    }

    /// Lowers the price to the number of all parts times a whole number of units.
    pub(super) fn round(&mut self, power: i32) {
        let parts = self.visited.len() as f64 + 1.0;
        self.price = parts * whole(self.price / parts, power);
    }

    /// Number of parts that hold an item whole.
    pub(super) fn whole(&self) -> f64 {
        self.visited.iter().filter(|v| v.is_none()).count() as f64
    }

    /// The parts of an item's knots; `None` if all are in part 0.
    pub(super) fn of(&self, item: usize) -> Option<&[u32]> {
        let at = self.held.binary_search_by(|h| h.0.cmp(&item)).ok()?;
        self.held.get(at).map(|h| h.1.as_slice())
    }

    /// Whether some leg between two items can cross it.
    pub(super) fn may_cross(&self, [a, b]: [usize; 2]) -> bool {
        let (p, q) = (self.of(a).unwrap_or(&[0]), self.of(b).unwrap_or(&[0]));
        let first = p.first();
        !p.iter().chain(q).all(|part| Some(part) == first)
    }

    /// The items that lie in several parts.
    pub(super) fn divided(&self) -> impl Iterator<Item = usize> + '_ {
        self.held.iter().filter(|h| in_several(&h.1)).map(|h| h.0)
    }

    /// The knots whose stops are counted: of which item, and which.
    pub(super) fn counted(&self) -> impl Iterator<Item = (usize, usize)> + '_ {
        self.visited.iter().zip(1..).filter_map(|(v, part)| v.map(|item| (item, part))).flat_map(
            |(item, part)| {
                let knots = self.of(item).unwrap_or_default();
                knots.iter().enumerate().filter(move |k| *k.1 == part).map(move |(k, _)| (item, k))
            },
        )
    }
}

/// Whether an item whose knots are in these parts lies in several of them.
pub(super) fn in_several(parts: &[u32]) -> bool {
    parts.windows(2).any(|w| w[0] != w[1])
}

/// Seconds rounded down to whole units, which are this power of two.
pub(super) fn whole(seconds: f64, power: i32) -> f64 {
    libm::ldexp(libm::ldexp(seconds, -power).floor(), power)
}
