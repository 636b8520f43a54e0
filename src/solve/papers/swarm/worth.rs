//! What a particle is worth: its keys made a tour, improved by local search if that is on, made an allowed one, and
//! measured.

use super::super::keys::Keys;
use super::super::legs::Legs;
use super::super::local::{Choose, Ground, Polish};
use super::super::repair::Repair;
use crate::problem::{NodeId, Problem};
use crate::solve::epsilon::EPSILON;

/// Moves that decoding an item, or repairing and measuring one, are counted for: by the clock, a leg each.
const READ: u64 = 4;

/// The way from keys to lengths, a piece at a time.
pub(super) struct Worth<'p> {
    pub(super) keys: Keys<'p>,
    pub(super) ground: Ground<'p>,
    /// How orders become allowed; `None`: all of them are.
    repair: Option<Repair>,
    /// Local search is on.
    local: bool,
    /// Some item has several nodes.
    entries: bool,
    polish: Polish,
    stage: Stage,
}

enum Stage {
    /// Moves of the local search.
    Polish,
    /// Entries for the order it came to.
    Choose(Choose),
    /// Entries for the allowed order made of it.
    Last(Choose),
    /// Done.
    Ready,
}

/// What came of keys.
pub(super) struct Valued {
    /// The tour the keys stand for, after local search.
    pub(super) tour: Vec<NodeId>,
    /// The allowed tour made of it.
    pub(super) allowed: Vec<NodeId>,
    /// Its length by the measure.
    pub(super) value: f64,
}

impl<'p> Worth<'p> {
    pub(super) fn new(legs: Legs<'p>, keys: Keys<'p>, local: bool) -> Self {
        let problem = legs.problem();
        let ground = Ground::new(legs);
        let polish = Polish::new(problem, keys.led, keys.pinned.is_some());
        let entries = keys.count() > keys.items().len();
        Self { keys, ground, repair: Repair::needed(problem), local, entries, polish, stage: Stage::Ready }
    }

    fn problem(&self) -> &'p Problem {
        self.ground.legs.problem()
    }

    /// Begins with keys. `settled`: a tour that local search left as it is.
    pub(super) fn begin(&mut self, keys: &[f64], settled: &[NodeId]) -> (u64, Option<Valued>) {
        let tour = self.keys.tour(keys);
        let cost = READ * tour.len() as u64;
        if !self.local || tour.len() < 2 {
            let allowed = self.allowed(&tour);
            return (2 * cost, Some(self.valued(tour, allowed)));
        }
        self.polish.begin(&self.ground, tour, settled);
        self.stage = Stage::Polish;
        (cost, None)
    }

    /// Works on; the price, and what came of it at the end.
    pub(super) fn piece(&mut self) -> (u64, Option<Valued>) {
        let held = self.keys.led && (self.keys.pinned.is_some() || self.problem().table().is_some());
        match &mut self.stage {
            Stage::Polish => {
                if let Some(priced) = self.polish.piece(&self.ground) {
                    return (priced, None);
                }
                if self.entries {
                    self.stage = Stage::Choose(Choose::new(self.polish.tour().to_vec(), held));
                    return (1, None);
                }
                self.settled(held)
            }
            Stage::Choose(choose) => {
                if let Some(priced) = choose.piece(&self.ground.legs) {
                    return (priced, None);
                }
                let chosen = choose.tour();
                let legs = &self.ground.legs;
                if legs.around(&chosen) >= legs.around(self.polish.tour()) - EPSILON {
                    return self.settled(held);
                }
                let before = self.polish.tour().to_vec();
                let cost = chosen.len() as u64;
                self.polish.begin(&self.ground, chosen, &before);
                self.stage = Stage::Polish;
                (cost, None)
            }
            Stage::Last(choose) => {
                if let Some(priced) = choose.piece(&self.ground.legs) {
                    return (priced, None);
                }
                let allowed = choose.tour();
                self.ready(allowed)
            }
            Stage::Ready => (1, None),
        }
    }

    /// Local search is over: the allowed order, with entries of its own where it is another one.
    fn settled(&mut self, held: bool) -> (u64, Option<Valued>) {
        let allowed = self.allowed(self.polish.tour());
        if self.entries && allowed != self.polish.tour() {
            let cost = READ * allowed.len() as u64;
            // A start that precedence took from the front holds nothing any more.
            let held = held && allowed.first() == self.polish.tour().first();
            self.stage = Stage::Last(Choose::new(allowed, held));
            return (cost, None);
        }
        self.ready(allowed)
    }

    fn ready(&mut self, allowed: Vec<NodeId>) -> (u64, Option<Valued>) {
        self.stage = Stage::Ready;
        let tour = self.polish.tour().to_vec();
        (READ * tour.len() as u64, Some(self.valued(tour, allowed)))
    }

    fn valued(&self, tour: Vec<NodeId>, allowed: Vec<NodeId>) -> Valued {
        let value = self.ground.legs.around(&allowed);
        Valued { tour, allowed, value }
    }

    /// Makes keys stand for the tour that local search made of them; without it they do already.
    pub(super) fn keep(&self, tour: &[NodeId], keys: &mut [f64]) {
        if self.local {
            self.keys.set(tour, keys);
        }
    }

    /// The allowed tour nearest to a tour.
    pub(super) fn allowed(&self, tour: &[NodeId]) -> Vec<NodeId> {
        let repaired = self.repair.as_ref().map(|repair| repair.tour(self.problem(), tour));
        repaired.unwrap_or_else(|| tour.to_vec())
    }
}
