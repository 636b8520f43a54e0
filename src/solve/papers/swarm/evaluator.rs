//! Evaluates particles: keys become a tour, local search improves it (if it is on), and the tour is repaired and measured.

use super::super::keys::Keys;
use super::super::legs::Legs;
use super::super::local::{EntryChoice, LocalSearch, NearItems, SearchSpace};
use super::super::repair::Repair;
use crate::problem::{NodeId, Problem};
use crate::solve::epsilon::EPSILON;

/// Cost of decoding an item, or of repairing and measuring one, in moves: the time it takes compared with pricing a leg.
const READ: u64 = 4;

/// Converts keys to tour lengths, one piece of work at a time.
pub(super) struct Evaluator<'p> {
    pub(super) keys: Keys<'p>,
    pub(super) space: SearchSpace<'p>,
    /// Repairs the order; `None` if every order is feasible.
    repair: Option<Repair>,
    /// Whether local search is on.
    local: bool,
    /// Whether some item has several nodes.
    entries: bool,
    local_search: LocalSearch,
    stage: Stage,
}

enum Stage {
    /// The local search applies moves.
    LocalSearch,
    /// Chooses entries for the order that local search found.
    EntryChoice(EntryChoice),
    /// Chooses entries for the repaired order.
    Last(EntryChoice),
    /// The evaluation is finished.
    Ready,
}

/// The result of an evaluation.
pub(super) struct Evaluation {
    /// The tour that the keys represent, after local search.
    pub(super) tour: Vec<NodeId>,
    /// The repaired tour.
    pub(super) allowed: Vec<NodeId>,
    /// Length of the repaired tour, by the measure.
    pub(super) value: f64,
}

impl<'p> Evaluator<'p> {
    pub(super) fn new(legs: Legs<'p>, keys: Keys<'p>, near: NearItems, local: bool) -> Self {
        let problem = legs.problem();
        let space = SearchSpace::new(legs, near);
        let local_search = LocalSearch::new(problem, keys.led, keys.pinned.is_some());
        let entries = keys.has_entries();
        Self {
            keys,
            space,
            repair: Repair::needed(problem),
            local,
            entries,
            local_search,
            stage: Stage::Ready,
        }
    }

    fn problem(&self) -> &'p Problem {
        self.space.legs.problem()
    }

    /// Starts with the keys of a particle. `settled` is a tour that local search cannot improve. Returns the cost, and the
    /// result if it is already there.
    pub(super) fn begin(&mut self, keys: &[f64], settled: &[NodeId]) -> (u64, Option<Evaluation>) {
        let tour = self.keys.tour(&self.space.legs, keys);
        let cost = READ * tour.len() as u64 + self.keys.priced();
        if !self.local || tour.len() < 2 {
            let allowed = self.allowed(&tour);
            return (2 * cost, Some(self.evaluation(tour, allowed)));
        }
        self.local_search.begin(&self.space, tour, settled);
        self.stage = Stage::LocalSearch;
        (cost, None)
    }

    /// Continues. Returns the cost, and the result at the end.
    pub(super) fn piece(&mut self) -> (u64, Option<Evaluation>) {
        let held = self.keys.led && (self.keys.pinned.is_some() || self.problem().table().is_some());
        match &mut self.stage {
            Stage::LocalSearch => {
                if let Some(priced) = self.local_search.piece(&self.space) {
                    return (priced, None);
                }
                if self.entries {
                    self.stage =
                        Stage::EntryChoice(EntryChoice::new(self.local_search.tour().to_vec(), held));
                    return (1, None);
                }
                self.settled(held)
            }
            Stage::EntryChoice(choose) => {
                if let Some(priced) = choose.piece(&self.space.legs) {
                    return (priced, None);
                }
                let chosen = choose.tour();
                let legs = &self.space.legs;
                if legs.tour_length(&chosen) >= legs.tour_length(self.local_search.tour()) - EPSILON {
                    return self.settled(held);
                }
                let before = self.local_search.tour().to_vec();
                let cost = chosen.len() as u64;
                self.local_search.begin(&self.space, chosen, &before);
                self.stage = Stage::LocalSearch;
                (cost, None)
            }
            Stage::Last(choose) => {
                if let Some(priced) = choose.piece(&self.space.legs) {
                    return (priced, None);
                }
                let allowed = choose.tour();
                self.ready(allowed)
            }
            Stage::Ready => (1, None),
        }
    }

    /// Local search has finished: repairs the order and, if that changes it, chooses its entries.
    fn settled(&mut self, held: bool) -> (u64, Option<Evaluation>) {
        let allowed = self.allowed(self.local_search.tour());
        if self.entries && allowed != self.local_search.tour() {
            let cost = READ * allowed.len() as u64;
            // If the repair moved the first item, its node is no longer fixed.
            let held = held && allowed.first() == self.local_search.tour().first();
            self.stage = Stage::Last(EntryChoice::new(allowed, held));
            return (cost, None);
        }
        self.ready(allowed)
    }

    fn ready(&mut self, allowed: Vec<NodeId>) -> (u64, Option<Evaluation>) {
        self.stage = Stage::Ready;
        let tour = self.local_search.tour().to_vec();
        (READ * tour.len() as u64, Some(self.evaluation(tour, allowed)))
    }

    fn evaluation(&self, tour: Vec<NodeId>, allowed: Vec<NodeId>) -> Evaluation {
        let value = self.space.legs.tour_length(&allowed);
        Evaluation { tour, allowed, value }
    }

    /// Changes keys so that they represent the tour found by local search. Without local search they already do.
    pub(super) fn keep(&self, tour: &[NodeId], keys: &mut [f64]) {
        if self.local {
            self.keys.set(tour, keys);
        }
    }

    /// The feasible tour closest to a given one.
    pub(super) fn allowed(&self, tour: &[NodeId]) -> Vec<NodeId> {
        let repaired = self.repair.as_ref().map(|repair| repair.tour(self.problem(), tour));
        repaired.unwrap_or_else(|| tour.to_vec())
    }
}
