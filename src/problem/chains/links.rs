//! Chains and edge starts as links between the nodes of contours that may be joined.

use super::super::ids::NodeId;
use super::super::links::{Link, Links};
use super::super::model::{Item, Node};
use super::super::seconds::start_seconds;
use super::{Candidates, Joined};
use crate::geometry::{DVec2, Path, Segment};
use crate::heat::Cooling;
use crate::lead::starts_moving;
use crate::machine::{AirTime, cut_time};

/// A chain leaves a contour with at least this slope, the sine of its angle. It is a little less than what the exact test
/// demands, and rejects most pairs at once.
const SLOPE: f64 = 0.2;
/// Distance of the points of a contour beside a place from which its direction is taken, mm.
const BESIDE: f64 = 1e-3;
/// Least seconds that a chain saves: less is rounding.
const LEAST: f64 = 1e-9;

impl Candidates<'_> {
    /// Whether a straight cut from a place on the kerf of a contour to where another one begins lies in waste. `to`: the path of the second
    /// one and the place on it, if the cut ends there and not at a lead.
    pub(in crate::problem) fn joins(
        &self,
        contours: [u32; 2],
        (path, from): (&Path, DVec2),
        (to, entry): (Option<(&Path, f64)>, DVec2),
    ) -> bool {
        let way = (entry - from).normalize_or_zero();
        let begins = End {
            node: NodeId::MAX,
            place: from,
            normals: path.nearest(from).and_then(|n| normals(path, n.0)),
        };
        let ends = End {
            node: NodeId::MAX,
            place: entry,
            normals: to.and_then(|(path, along)| normals(path, along)),
        };
        begins.leaves(way) && ends.leaves(-way) && self.scrap.joins(contours, from, entry)
    }

    /// The links between the nodes of the contours. A chain begins as the contour before it ends, so there is none between near contours that wait until
    /// they are cold.
    pub(in crate::problem) fn links(
        &self,
        items: &[Item],
        nodes: &[Node],
        cooling: Option<&Cooling>,
    ) -> Links {
        let (sheet, machine) = (self.sheet, self.machine);
        let air = AirTime::new(machine);
        let mut found = Vec::new();
        for (a, b) in self.pairs() {
            let (Some(first), Some(second)) = (self.all.get(a), self.all.get(b)) else { continue };
            let process = sheet.process_by_id(first.contour, machine);
            let waits = cooling.is_some_and(|c| c.waits() && c.are_near(first.contour, second.contour));
            for (one, other) in [(first, second), (second, first)] {
                let ends = self.ends(one, items, nodes, false);
                // What the item's own seconds contain: a contour that begins moving is not pierced.
                let start = self.start(other, items);
                for entry in self.ends(other, items, nodes, true) {
                    let cut = |from: &End| {
                        let way = entry.place - from.place;
                        let length = way.length();
                        let fits = length <= self.lever.reach
                            && from.leaves(way / length)
                            && entry.leaves(-way / length)
                            && self.scrap.joins([one.contour, other.contour], from.place, entry.place);
                        fits.then(|| cut_time(machine, &process, &[Segment::line(from.place, entry.place)]))
                    };
                    let from_ends: Vec<Option<f64>> = ends.iter().map(cut).collect();
                    let edges = self.edges(one, &ends, &from_ends, entry.place, cut);
                    for (exit, seconds) in ends.iter().zip(from_ends) {
                        let chain = seconds.filter(|_| !waits).map(|s| (s - start, None));
                        let edge = edges.iter().map(|&(place, seconds)| {
                            let lit = seconds + machine.beam_delays();
                            (air.seconds(exit.place, place) + lit - start, Some(place))
                        });
                        let best = chain.into_iter().chain(edge).min_by(|a, b| a.0.total_cmp(&b.0));
                        let Some((seconds, via)) = best else { continue };
                        let saved = air.seconds(exit.place, entry.place) - seconds;
                        if saved > LEAST {
                            found.push((exit.node, Link { to: entry.node, via, seconds, saved }));
                        }
                    }
                }
            }
        }
        Links::new(nodes.len(), found, |node| nodes.get(node as usize).map(|n| n.item))
    }

    /// Seconds of piercing and of the beam's delays of a contour that is not joined.
    fn start(&self, joined: &Joined, items: &[Item]) -> f64 {
        let (sheet, machine) = (self.sheet, self.machine);
        let leads = items.get(joined.contour as usize).and_then(|i| i.leads.as_ref());
        let moving = self.contour(joined).is_some_and(|contour| match leads {
            Some(leads) => leads.start_moving(sheet, machine, contour),
            None => starts_moving(sheet, machine, contour, None),
        });
        start_seconds(machine, false, moving)
    }

    /// The places on the kerf of a contour where a cut to `entry` may begin, with the seconds of that cut. `ends` are its nodes, from
    /// which `from_ends` are the seconds.
    fn edges(
        &self,
        joined: &Joined,
        ends: &[End],
        from_ends: &[Option<f64>],
        entry: DVec2,
        cut: impl Fn(&End) -> Option<f64>,
    ) -> Vec<(DVec2, f64)> {
        let Some(path) = self.contour(joined).map(|c| &c.path).filter(|_| self.lever.edge_starts) else {
            return Vec::new();
        };
        // The ends of leads are not on the kerf of the contour, which may have a gap.
        if ends.iter().any(|end| end.normals.is_none()) {
            return Vec::new();
        }
        let of_nodes = ends.iter().zip(from_ends);
        let mut all: Vec<(DVec2, f64)> =
            of_nodes.filter_map(|(end, seconds)| Some((end.place, (*seconds)?))).collect();
        if let Some((along, place)) = path.nearest(entry) {
            let end = End { node: NodeId::MAX, place, normals: normals(path, along) };
            all.extend(cut(&end).map(|seconds| (place, seconds)));
        }
        all
    }

    /// Where the nodes of a contour begin (`entry`) or end, with the directions into the waste there.
    fn ends(&self, joined: &Joined, items: &[Item], nodes: &[Node], entry: bool) -> Vec<End> {
        let item = items.get(joined.contour as usize);
        let ids = item.map(|i| i.nodes.clone()).unwrap_or_default();
        let path = self.contour(joined).map(|c| &c.path);
        let end = |node: NodeId| {
            let known = nodes.get(node as usize)?;
            let place = if entry { known.entry } else { known.exit };
            let lead = item?.lead(node).map(|l| l.0);
            if entry && lead.is_some_and(|l| l.approach.is_some()) {
                return None;
            }
            // A lead has left the contour in a direction of its own.
            let free = lead.is_some_and(|l| !l.is_bare());
            Some(End { node, place, normals: if free { None } else { normals(path?, known.along) } })
        };
        ids.filter_map(end).collect()
    }
}

/// Where a chain may begin or end.
struct End {
    node: NodeId,
    place: DVec2,
    /// The directions into the waste, just before the place and just behind it; `None`: any direction is tried.
    normals: Option<[DVec2; 2]>,
}

impl End {
    /// Whether a direction leads into the waste.
    fn leaves(&self, direction: DVec2) -> bool {
        self.normals.is_none_or(|n| n.iter().any(|n| n.dot(direction) >= SLOPE))
    }
}

/// The directions into the waste at a place of a closed contour. Outer contours are counter-clockwise and holes clockwise, so the
/// waste is on the right.
fn normals(path: &Path, along: f64) -> Option<[DVec2; 2]> {
    let length = path.length();
    let beside = BESIDE.min(length / 8.0);
    let place = |along: f64| path.at(along.rem_euclid(length));
    let (before, here, after) = (place(along - beside)?, place(along)?, place(along + beside)?);
    let right = |d: DVec2| -d.perp().normalize_or_zero();
    Some([right(here - before), right(after - here)])
}
