//! Other entries of a stop.

use super::sequence::Sequence;
use super::visit::Visit;
use crate::solve::traits::Stop;

/// Parts of a contour's length by which an entry slides.
const SLIDES: [f64; 3] = [32.0, 256.0, 2048.0];

/// The entries that are tried for the stop at `k`: its nodes, and along its contour those nearest to the stops around it and a
/// little to either side. Those with the shortest straight legs come first: once one of them is taken, most others cannot gain.
/// Where cuts heat each other or begin on kerfs, these say little, and entries keep their order.
pub(super) fn entries(sequence: &Sequence, k: usize) -> Vec<Visit> {
    let (Some(item), Some(visit)) = (sequence.item(k), sequence.visit(k)) else { return Vec::new() };
    let (problem, stop) = (sequence.problem, visit.stop);
    let mut stops: Vec<Stop> = item.nodes.clone().map(|node| Stop::at(problem, node)).collect();
    if let Some(track) = &item.track {
        let before = k.checked_sub(1).and_then(|b| sequence.visit(b)).map_or(problem.home, |v| v.exit);
        let after = sequence.visit(k + 1).map_or(problem.home, |v| v.entry);
        let length = track.length();
        let near = [before, after, (before + after) * 0.5].into_iter().filter_map(|p| track.nearest(p));
        let slides = SLIDES.iter().flat_map(|part| [length / part, -length / part]);
        let places = near.map(|n| n.0).chain(slides.map(|by| (stop.along + by).rem_euclid(length)));
        let within = places.filter(|along| (0.0..=length).contains(along));
        stops.extend(within.map(|along| Stop::whole(stop.node, along)));
    }
    let others = stops.into_iter().filter(|s| *s != stop);
    let entries = others.filter_map(|s| Visit::new(problem, s));
    if !sequence.only_tips() {
        return entries.collect();
    }
    let mut by: Vec<(f64, Visit)> = entries.map(|v| (sequence.straight_by(k, &v), v)).collect();
    by.sort_by(|a, b| a.0.total_cmp(&b.0));
    by.into_iter().map(|b| b.1).collect()
}
