//! How a cut is begun: pierced, at the end of a chain, or on a kerf if the contour of that kerf has been cut before.
//!
//! However a cut is begun, it ends at the same place (`problem::Start`). So the quickest way that is there by then is the best one, whatever
//! comes after it. Where moves avoid pieces that may have tipped, a chain passes none of them, and a cut begins on no kerf that is near one. Where
//! cuts heat each other, what is due counts as well: the head waits before a start on a kerf as it does before piercing, but not before a chain, which
//! begins as the cut before it ends. How a cut is begun then changes when it ends, and so what is due later; each cut is begun as is best by itself.

use super::visit::Visit;
use crate::geometry::DVec2;
use crate::heat::Cooling;
use crate::machine::{AirTime, PLANS_ALL_LEVERS};
use crate::problem::{ItemId, Link, NodeId, Problem, Start};
use crate::solve::traits::Stop;
use crate::tipping::{Piece, Zones};

/// Where the head is before a cut: its place, and the node that it has left.
#[derive(Clone, Copy)]
pub(super) struct Head {
    pub(super) at: DVec2,
    pub(super) left: Option<NodeId>,
}

/// How a cut is begun.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Begun {
    /// After a move with the beam off, where it is entered.
    Moved,
    /// By the link from the cut before it.
    Linked,
    /// Without piercing elsewhere.
    At(Start),
}

impl Begun {
    /// Where it begins elsewhere.
    pub fn start(self) -> Option<Start> {
        if let Self::At(start) = self { Some(start) } else { None }
    }
}

/// What moves with the beam off take: straight ones, or past the pieces that may have tipped.
#[derive(Clone, Copy)]
pub(super) struct Ways<'p> {
    pub(super) air: &'p AirTime,
    pub(super) zones: Option<&'p Zones>,
}

impl Ways<'_> {
    fn seconds(&self, from: DVec2, to: DVec2, is_free: impl Fn(&Piece) -> bool) -> f64 {
        match self.zones {
            Some(zones) => zones.leg(from, to, is_free).seconds,
            None => self.air.seconds(from, to),
        }
    }

    /// Seconds of a link, with the way to where it begins; `None` if it passes a piece that may have tipped.
    fn link(&self, head: DVec2, link: &Link, to: DVec2, is_free: impl Fn(&Piece) -> bool) -> Option<f64> {
        let Some(zones) = self.zones else { return Some(link.seconds) };
        let Some(via) = link.via else {
            return (!zones.crosses(head, to, is_free)).then_some(link.seconds);
        };
        let more = || zones.leg(head, via, &is_free).seconds - self.air.seconds(head, via);
        let passes = zones.is_near(via, &is_free) || zones.crosses(via, to, &is_free);
        (!passes).then(|| link.seconds + more())
    }
}

/// A way to begin a cut, and what it takes.
#[derive(Clone, Copy)]
pub(super) struct Beginning {
    pub(super) how: Begun,
    /// Seconds in place of those of a move to where it is pierced.
    pub(super) seconds: f64,
    /// What it counts as, s: these seconds, and what is due because of heat.
    pub(super) price: f64,
}

/// The price of a beginning where nothing is hot: its seconds. The first argument is how long it takes until the cut begins, where the head may wait; `None`
/// for a chain, which begins at once.
pub(super) fn cold(_until: Option<f64>, seconds: f64) -> f64 {
    seconds
}

/// The price of a beginning of an item after `now` seconds: what is due counts, and what has to wait and cannot has none. `before`: the items cut so
/// far with the seconds at which they ended, the last first.
pub(super) fn hot<'c>(
    cooling: &'c Cooling,
    item: ItemId,
    now: f64,
    before: impl Iterator<Item = (ItemId, f64)> + Clone + 'c,
) -> impl Fn(Option<f64>, f64) -> f64 + 'c {
    move |until, seconds| {
        let due = cooling.due(item, now + until.unwrap_or(0.0), before.clone());
        let cannot = until.is_none() && due.wait > 0.0;
        if cannot { f64::INFINITY } else { seconds + cooling.cost(due) }
    }
}

impl Beginning {
    fn new(
        how: Begun,
        (until, seconds): (Option<f64>, f64),
        price: impl Fn(Option<f64>, f64) -> f64,
    ) -> Self {
        Self { how, seconds, price: price(until, seconds) }
    }

    /// When the cut that takes `cut` seconds ends, if it is begun like this after `now` seconds, s.
    pub(super) fn end(&self, cooling: &Cooling, now: f64, cut: f64) -> f64 {
        let wait = if cooling.waits() { self.price - self.seconds } else { 0.0 };
        now + self.seconds + wait + cut
    }
}

/// The cheapest way to begin the cut of a node that is entered at `entry`, by its price, which is never less than the seconds. `is_cut`: whether an item
/// has been cut before.
pub(super) fn begin(
    problem: &Problem,
    ways: Ways<'_>,
    head: Head,
    (node, entry): (NodeId, DVec2),
    is_cut: impl Fn(ItemId) -> bool,
    price: impl Fn(Option<f64>, f64) -> f64,
) -> Beginning {
    let is_free = |piece: &Piece| piece.cut_by.iter().all(|&c| is_cut(c));
    let link = head.left.and_then(|left| problem.links.between(left, node));
    let linked = link.and_then(|link| {
        let seconds = ways.link(head.at, link, entry, is_free)?;
        let until = link.via.map(|via| ways.seconds(head.at, via, is_free));
        Some(Beginning::new(Begun::Linked, (until, seconds), &price))
    });
    let moved = || {
        let seconds = ways.seconds(head.at, entry, is_free);
        Beginning::new(Begun::Moved, (Some(seconds), seconds), &price)
    };
    let mut best = match linked {
        // Without pieces that tip and without heat, a link takes less than a move.
        Some(linked) if ways.zones.is_none() && problem.cooling().is_none() => linked,
        _ => moved(),
    };
    if let Some(linked) = linked.filter(|linked| linked.price < best.price) {
        best = linked;
    }
    for start in problem.starts.of(node).iter().filter(|s| s.kerf.is_none_or(&is_cut)) {
        // No way takes less than a straight one.
        if ways.air.seconds(head.at, start.from) + start.seconds >= best.price {
            continue;
        }
        let passes = |z: &Zones| z.is_near(start.from, &is_free) || z.crosses(start.from, entry, is_free);
        if start.from != entry && ways.zones.is_some_and(passes) {
            continue;
        }
        let until = ways.seconds(head.at, start.from, is_free);
        let found = Beginning::new(Begun::At(*start), (Some(until), until + start.seconds), &price);
        if found.price < best.price {
            best = found;
        }
    }
    best
}

/// How each cut of a sequence of stops is begun; empty where each is begun by its link if it has one.
pub fn begun(problem: &Problem, stops: &[Stop]) -> Vec<Begun> {
    if !PLANS_ALL_LEVERS || !varies(problem) {
        return Vec::new();
    }
    let air = straight(problem);
    let ways = Ways { air: &air, zones: problem.avoided() };
    let mut head = Head { at: problem.home, left: None };
    let mut cut = vec![false; problem.items.len()];
    // The cuts so far with the seconds at which they ended.
    let mut ended: Vec<(ItemId, f64)> = Vec::new();
    let how = |stop: &Stop| {
        let visit = Visit::new(problem, *stop)?;
        let is_cut = |item: ItemId| cut.get(item as usize).is_some_and(|c| *c);
        let to = (stop.node, visit.entry);
        let how = match problem.cooling() {
            Some(cooling) => {
                let now = ended.last().map_or(0.0, |e| e.1);
                let price = hot(cooling, visit.item, now, ended.iter().rev().copied());
                let found = begin(problem, ways, head, to, is_cut, price);
                ended.push((visit.item, found.end(cooling, now, visit.seconds)));
                found.how
            }
            None => begin(problem, ways, head, to, is_cut, cold).how,
        };
        head = Head { at: visit.exit, left: Some(stop.node) };
        if let Some(cut) = cut.get_mut(visit.item as usize) {
            *cut = true;
        }
        Some(how)
    };
    stops.iter().map(how).map(|how| how.unwrap_or(Begun::Moved)).collect()
}

/// Whether how a cut is begun depends on more than the cut before it.
fn varies(problem: &Problem) -> bool {
    let linked = !problem.links.is_empty() && (problem.avoided().is_some() || problem.cooling().is_some());
    linked || !problem.starts.is_empty()
}

/// Whether there is more than one way to begin a cut.
pub(super) fn may_choose(problem: &Problem) -> bool {
    !problem.links.is_empty() || !problem.starts.is_empty()
}

/// Seconds of straight moves: with the head down, where it is lifted only to pass pieces that may have tipped.
pub(super) fn straight(problem: &Problem) -> AirTime {
    if problem.avoided().is_some() {
        AirTime::head_down(&problem.machine)
    } else {
        AirTime::new(&problem.machine)
    }
}
