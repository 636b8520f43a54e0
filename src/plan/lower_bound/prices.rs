//! Lower bounds of the cost of legs between two pieces: by the machine's air time, or by a table.

use super::extras::HAS_EXTRAS;
use super::minorant::Minorant;
#[cfg(feature = "research")]
use super::mixtures::Mixtures;
use super::net::{Item, Piece};
use crate::geometry::DVec2;
use crate::problem::{NodeId, Problem, Table};

/// Prices legs.
#[derive(Clone, Debug)]
pub(super) struct Prices {
    pub(super) minorant: Minorant,
    /// The item whose legs cost nothing: where an open path ends.
    end: Option<usize>,
    table: Option<Box<Given>>,
    directed: bool,
    /// How much each axis counts in some legs.
    #[cfg(feature = "research")]
    pub(super) mixtures: Mixtures,
    #[cfg(feature = "research")]
    none_below: Option<f64>,
}

/// Given costs; they may differ by direction.
#[derive(Clone, Debug)]
struct Given {
    table: Table,
    /// First node of each item.
    nodes: Vec<NodeId>,
}

impl Prices {
    pub(super) fn new(problem: &Problem) -> Self {
        let given = problem.table().map(|table| {
            let mut nodes: Vec<NodeId> = problem.items.iter().map(|i| i.nodes.start).collect();
            nodes.rotate_right(1);
            Box::new(Given { table: table.clone(), nodes })
        });
        Self {
            minorant: Minorant::new(&problem.machine),
            end: (given.is_none() && !problem.closed).then_some(1),
            table: given,
            directed: problem.table().is_some_and(|t| !t.is_symmetric()),
            #[cfg(feature = "research")]
            mixtures: Mixtures::default(),
            #[cfg(feature = "research")]
            none_below: None,
        }
    }

    /// The same, but where one of the four numbers between two pieces would be less than `least`, which is not negative, all are 0: every leg
    /// takes at least that, so these numbers need no allowance for rounding.
    #[cfg(feature = "research")]
    pub(super) fn none_below(self, least: f64) -> Self {
        Self { none_below: Some(least), ..self }
    }

    /// Whether costs are given by a table: boxes then mean nothing.
    pub(super) fn given(&self) -> bool {
        self.table.is_some()
    }

    /// Whether a leg may cost more one way than the other.
    pub(super) fn directed(&self) -> bool {
        self.directed
    }

    /// Lower bounds of the cost of a leg between the ends of pieces of two items: its seconds (see [`Minorant::corners`]) and half of the extra
    /// seconds of both stops.
    pub(super) fn corners(&self, items: [usize; 2], p: &Piece, q: &Piece) -> [[f64; 2]; 2] {
        let seconds = match &self.table {
            Some(given) => {
                let node = |item: usize, knot: usize| {
                    given.nodes[item] + NodeId::try_from(knot).unwrap_or(NodeId::MAX)
                };
                let (a, b) = (node(items[0], p.knots[0]), node(items[1], q.knots[0]));
                [[given.table.cost(a, b); 2]; 2]
            }
            _ if self.end == Some(items[0]) => [[0.0; 2]; 2],
            _ => {
                #[cfg(feature = "research")]
                let mixture = self.mixtures.between(items);
                #[cfg(not(feature = "research"))]
                let mixture = None;
                self.minorant.corners(p, q, mixture)
            }
        };
        let corners = if HAS_EXTRAS {
            [0, 1].map(|i| [0, 1].map(|j| seconds[i][j] + p.halves[i] + q.halves[j]))
        } else {
            seconds
        };
        #[cfg(feature = "research")]
        if self.table.is_none()
            && self.none_below.is_some_and(|least| corners.as_flattened().iter().any(|&s| s < least))
        {
            return [[0.0; 2]; 2];
        }
        corners
    }

    /// What a leg costs between two knots, each given as its item, its number and its place.
    pub(super) fn real(&self, stops: [(&Item, usize, DVec2); 2]) -> f64 {
        let [one, other] = stops.map(|(item, knot, _)| item.half(knot));
        self.minorant.air().seconds(stops[0].2, stops[1].2) + one + other
    }
}
