//! Places that every tour enters and leaves if it stops at one of them, with the price of legs across their border.

/// A leg between two knots of a pair of items.
#[derive(Clone, Copy, Debug)]
pub(super) struct Leg {
    pub(super) i: u32,
    pub(super) j: u32,
    pub(super) seconds: f64,
}

/// Some knots, and the price of legs between them and the others.
#[derive(Clone, Debug)]
pub(super) struct Cut {
    /// The items of which it holds some knots, in ascending order, and which: `None` for all.
    pub(super) held: Vec<(usize, Option<Vec<bool>>)>,
    /// The item whose stops here pay twice the price; `None`: every tour pays it, because an item is held whole.
    pub(super) visited: Option<usize>,
    pub(super) price: f64,
    /// The legs of the smooth solution that cross it, and how many there should be at least.
    pub(super) legs: f64,
    pub(super) target: f64,
    /// The pairs of items all of whose legs cross it, and the active legs of other pairs that do.
    pub(super) pairs: Vec<u32>,
    pub(super) crossing: Vec<u32>,
}

/// Which knots of an item a cut holds.
#[derive(Clone, Copy)]
pub(super) enum Held<'c> {
    None,
    Some(&'c [bool]),
    All,
}

impl Held<'_> {
    #[inline]
    pub(super) fn holds(self, knot: usize) -> bool {
        match self {
            Held::None => false,
            Held::Some(knots) => knots[knot],
            Held::All => true,
        }
    }
}

impl Cut {
    pub(super) fn new(held: Vec<(usize, Option<Vec<bool>>)>, visited: Option<usize>) -> Self {
        Self { held, visited, price: 0.0, legs: 0.0, target: 2.0, pairs: Vec::new(), crossing: Vec::new() }
    }

    #[inline]
    pub(super) fn of(&self, item: usize) -> Held<'_> {
        match self.held.binary_search_by(|h| h.0.cmp(&item)).map(|at| &self.held[at].1) {
            Ok(Some(knots)) => Held::Some(knots),
            Ok(None) => Held::All,
            Err(_) => Held::None,
        }
    }

    /// Whether some leg between two items can cross it.
    pub(super) fn may_cross(&self, ends: [usize; 2]) -> bool {
        !matches!(ends.map(|k| self.of(k)), [Held::None, Held::None] | [Held::All, Held::All])
    }

    /// The knots of the item that pays twice the price.
    pub(super) fn visited_knots(&self) -> impl Iterator<Item = (usize, usize)> + '_ {
        let of = self.visited.map(|k| (k, self.of(k)));
        of.into_iter().flat_map(|(k, held)| {
            let knots = if let Held::Some(knots) = held { knots } else { &[] };
            knots.iter().enumerate().filter(|v| *v.1).map(move |(v, _)| (k, v))
        })
    }
}
