//! Places that every tour enters and leaves if it stops at one of them: what a cut is made of.

/// Some knots.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Places {
    /// The items of which it holds some knots, in ascending order, and which: `None` for all. Home is not among them.
    pub(super) held: Vec<(usize, Option<Vec<bool>>)>,
    /// The item whose stops here count: for each of them, two legs cross the border. `None`: an item is held whole, so that every tour has
    /// two such legs.
    pub(super) visited: Option<usize>,
}

/// Which knots of an item are held.
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

impl Places {
    #[inline]
    pub(super) fn of(&self, item: usize) -> Held<'_> {
        match self.held.binary_search_by(|h| h.0.cmp(&item)).map(|at| &self.held[at].1) {
            Ok(Some(knots)) => Held::Some(knots),
            Ok(None) => Held::All,
            Err(_) => Held::None,
        }
    }

    /// Whether it holds some knots of an item.
    pub(super) fn holds(&self, item: usize) -> bool {
        !matches!(self.of(item), Held::None)
    }

    /// Whether some leg between two items can cross the border.
    pub(super) fn may_cross(&self, ends: [usize; 2]) -> bool {
        !matches!(ends.map(|k| self.of(k)), [Held::None, Held::None] | [Held::All, Held::All])
    }

    /// The knots of the item whose stops count.
    pub(super) fn visited_knots(&self) -> impl Iterator<Item = (usize, usize)> + '_ {
        let of = self.visited.map(|k| (k, self.of(k)));
        of.into_iter().flat_map(|(k, held)| {
            let knots = if let Held::Some(knots) = held { knots } else { &[] };
            knots.iter().enumerate().filter(|v| *v.1).map(move |(v, _)| (k, v))
        })
    }

    /// The same places after pieces were halved. `around`: for each knot of each item the two knots around it before, or twice the same. A new
    /// knot between one inside and one outside is outside.
    pub(super) fn halve(&mut self, around: &[Vec<[usize; 2]>]) {
        for (k, held) in &mut self.held {
            if let Some(knots) = held {
                *knots = around[*k].iter().map(|[v, w]| knots[*v] && knots[*w]).collect();
            }
        }
    }
}
