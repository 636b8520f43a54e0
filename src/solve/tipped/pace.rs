//! How the method and the local search take turns.
//!
//! The method is the search that knows nothing of tipping. The plan has to be good whenever the search is stopped, and no worse than the best
//! path of the method alone, led past tipped pieces afterwards. A method that anneals improves in leaps, after long stretches without any, and
//! a leap that comes late costs more than the local search gains meanwhile. So the local search gets a small share of the moves while the
//! method still improves, which is enough to descend from each of its best paths, and more once it has settled.

use super::sequence::only_tips;
use crate::problem::Problem;
use crate::solve::epsilon::EPSILON;

/// Least moves of a turn of the method, and moves of a turn by item.
const TURN: u64 = 2_000;
const TURN_BY_ITEM: u64 = 1;
/// The method gains for as long as its last gain was within this part of its moves, and has settled once it was before all but
/// this part of them.
const RECENT: u64 = 32;
const SETTLED: u64 = 8;
/// The local search goes on from the method's best once this part of the method's moves (one in 4, one in 64) was made since it last did:
/// while the method gains, and after that. It takes about as long as four moves by item to price all of a path.
const TAKEN: [u64; 2] = [4, 64];
/// Moves by item before the local search begins, unless the method has gained before and does not any more: its first descent
/// gains more than the local search could.
const HEAD_START: u64 = 200;
/// A turn of the local search has this part of the moves of one of the method.
const SESSION: u64 = 8;
/// Time of a move of the local search, in moves of the method.
const LOCAL: u64 = 5;
/// The local search has one unit of work in this number of units: while the method gains; while it descends from what the method has
/// found; and while it kicks that. Most of what tipped pieces cost is gained by a descent, which is short. The rest
/// is little, and what the method finds later is worth more.
const GAINING: u64 = 128;
const FRESH: u64 = 32;
const KICKED: u64 = 64;
/// The same once the method has settled: until the local search has gained nothing in half of its moves, and after that.
const STALLED: [u64; 2] = [2, 8];
/// Where heat counts, the method makes one in four moves and the local search the others: the method does not know the cost of heat.
const HEATED_SHARE: u64 = 4;
/// Where cuts begin on kerfs, the local search has one move in this number: the method finds chains better, and leaves little to do.
const STARTS_SHARE: u64 = 12;
/// Moves of a turn by item there and where heat counts, of either search.
const LONG_TURN: u64 = 4;

/// How what has been cut before counts.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Kind {
    /// Pieces may have tipped, and nothing else.
    Tips,
    /// Cuts begin on kerfs.
    Starts,
    /// Cuts heat each other.
    Heat,
}

/// The moves of both searches, and when the method gained.
pub(super) struct Pace {
    items: u64,
    kind: Kind,
    /// Moves done so far by both, and by the local search.
    pub(super) done: u64,
    local_done: u64,
    /// The least cost of the method after a turn, and its moves by then; 0 before its first gain.
    cost: f64,
    gained_at: u64,
    /// Moves of the method when its best was last taken; 0 before.
    taken_at: u64,
    /// Whether it was new then.
    took_new: bool,
}

/// What the local search has reached.
pub(super) struct LocalState {
    /// Whether nothing is left to be looked at before the next kick.
    pub(super) settled: bool,
    /// Its moves since its last gain.
    pub(super) since_gain: u64,
}

impl Pace {
    pub(super) fn new(problem: &Problem, cost: f64) -> Self {
        let kind = match (only_tips(problem), problem.cooling()) {
            (true, _) => Kind::Tips,
            (false, None) => Kind::Starts,
            (false, Some(_)) => Kind::Heat,
        };
        let items = problem.items.len() as u64;
        Self { items, kind, done: 0, local_done: 0, cost, gained_at: 0, taken_at: 0, took_new: false }
    }

    /// Counts moves of the local search.
    pub(super) fn did(&mut self, moves: u64) {
        self.done += moves;
        self.local_done += moves;
    }

    /// Moves of the method.
    fn method_done(&self) -> u64 {
        self.done - self.local_done
    }

    /// Moves of a turn of the method.
    pub(super) fn turn(&self) -> u64 {
        let by_item = if self.kind == Kind::Tips { TURN_BY_ITEM } else { LONG_TURN };
        (by_item * self.items).max(TURN)
    }

    /// Moves of a turn of the local search.
    pub(super) fn session(&self) -> u64 {
        if self.kind == Kind::Tips { self.turn() / SESSION } else { self.turn() }
    }

    /// Notes the cost of the method after a turn.
    pub(super) fn saw(&mut self, cost: f64) {
        if cost < self.cost - EPSILON {
            (self.cost, self.gained_at) = (cost, self.method_done());
        }
    }

    /// Notes that the local search goes on from the method's best, if that is new.
    pub(super) fn took(&mut self, is_new: bool) {
        self.took_new = is_new;
        self.taken_at = self.method_done();
    }

    /// Whether the method has gained not long ago.
    fn is_gaining(&self) -> bool {
        let method = self.method_done();
        method - self.gained_at < method / RECENT
    }

    /// Whether the local search may go on from the method's best.
    pub(super) fn may_take(&self) -> bool {
        let parts = TAKEN[usize::from(!self.is_gaining())];
        let due = (self.method_done() - self.taken_at) * parts > self.method_done();
        self.kind != Kind::Tips || (self.has_begun() && due)
    }

    /// Whether the local search may have begun.
    fn has_begun(&self) -> bool {
        let has_gained = self.gained_at > 0 && !self.is_gaining();
        self.taken_at > 0 || has_gained || self.method_done() > HEAD_START * self.items
    }

    /// Whether the local search works next.
    pub(super) fn is_due(&self, local: &LocalState) -> bool {
        let method = self.method_done();
        match self.kind {
            Kind::Heat => return method * HEATED_SHARE > self.done,
            Kind::Starts => {
                let early = self.took_new && self.done < HEAD_START * self.items;
                return !early && self.local_done * STARTS_SHARE < self.done;
            }
            Kind::Tips => {}
        }
        let share = if method - self.gained_at > method - method / SETTLED {
            STALLED[usize::from(local.since_gain > self.local_done / 2)]
        } else if self.is_gaining() {
            GAINING
        } else if local.settled {
            KICKED
        } else {
            FRESH
        };
        self.has_begun() && self.local_done * LOCAL * (share - 1) < method
    }
}
