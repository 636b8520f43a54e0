//! How a cut is begun: pierced, at the end of a chain, or on a kerf if the contour of that kerf has been cut before.
//!
//! However a cut is begun, it ends at the same place (`problem::Start`). So the quickest way that is there by then is the best one, whatever
//! comes after it. Where moves avoid pieces that may have tipped, a chain passes none of them, and a cut begins on no kerf that is near one.

use crate::geometry::DVec2;
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

/// The quickest way to begin the cut of a node that is entered at `entry`, and its seconds. `is_cut`: whether an item has been cut before.
pub(super) fn begin(
    problem: &Problem,
    ways: Ways<'_>,
    head: Head,
    (node, entry): (NodeId, DVec2),
    is_cut: impl Fn(ItemId) -> bool,
) -> (Begun, f64) {
    let is_free = |piece: &Piece| piece.cut_by.iter().all(|&c| is_cut(c));
    let link = head.left.and_then(|left| problem.links.between(left, node));
    let linked = link.and_then(|link| ways.link(head.at, link, entry, is_free));
    let mut best = match linked {
        // Without pieces that tip, a link takes less than a move.
        Some(seconds) if ways.zones.is_none() => (Begun::Linked, seconds),
        _ => (Begun::Moved, ways.seconds(head.at, entry, is_free)),
    };
    if let Some(seconds) = linked.filter(|seconds| *seconds < best.1) {
        best = (Begun::Linked, seconds);
    }
    for start in problem.starts.of(node).iter().filter(|s| s.kerf.is_none_or(&is_cut)) {
        // No way takes less than a straight one.
        if ways.air.seconds(head.at, start.from) + start.seconds >= best.1 {
            continue;
        }
        let passes = |z: &Zones| z.is_near(start.from, &is_free) || z.crosses(start.from, entry, is_free);
        if start.from != entry && ways.zones.is_some_and(passes) {
            continue;
        }
        let seconds = ways.seconds(head.at, start.from, is_free) + start.seconds;
        if seconds < best.1 {
            best = (Begun::At(*start), seconds);
        }
    }
    best
}

/// How each cut of a sequence of stops is begun; empty where each is begun by its link if it has one.
pub fn begun(problem: &Problem, stops: &[Stop]) -> Vec<Begun> {
    let zones = problem.avoided().filter(|_| !problem.links.is_empty() || !problem.starts.is_empty());
    if !PLANS_ALL_LEVERS || (problem.starts.is_empty() && zones.is_none()) {
        return Vec::new();
    }
    let air = straight(problem);
    let ways = Ways { air: &air, zones };
    let mut head = Head { at: problem.home, left: None };
    let mut cut = vec![false; problem.items.len()];
    let how = |stop: &Stop| {
        let (entry, exit) = stop.ends(problem)?;
        let is_cut = |item: ItemId| cut.get(item as usize).is_some_and(|c| *c);
        let how = begin(problem, ways, head, (stop.node, entry), is_cut).0;
        head = Head { at: exit, left: Some(stop.node) };
        let item = problem.nodes.get(stop.node as usize)?.item;
        if let Some(cut) = cut.get_mut(item as usize) {
            *cut = true;
        }
        Some(how)
    };
    stops.iter().map(how).map(|how| how.unwrap_or(Begun::Moved)).collect()
}

/// Seconds of straight moves: with the head down, where it is lifted only to pass pieces that may have tipped.
pub(super) fn straight(problem: &Problem) -> AirTime {
    if problem.avoided().is_some() {
        AirTime::head_down(&problem.machine)
    } else {
        AirTime::new(&problem.machine)
    }
}
