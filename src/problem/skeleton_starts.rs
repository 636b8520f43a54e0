//! Skeleton cuts that begin without piercing (`levers.chains.edge_starts`): at the edge of the sheet if that is drawn, and on the kerf of a
//! skeleton cut that was made before.
//!
//! A skeleton cut keeps its distance from parts, so no kerf of theirs is near. But it runs to the edge of the sheet where nothing is in
//! its way, and its ends may lie on another skeleton cut. Where it only crosses that one, it is cut from there to one end and, after a move
//! back with the beam off, to the other.

use super::ids::NodeId;
use super::model::{Item, Node};
use super::starts::Start;
use crate::geometry::{Aabb, BoxIndex, DVec2, Segment};
use crate::machine::{AirTime, Profile, cut_time};
use crate::order::{real, sort_by};
use crate::sheet::Sheet;

/// Most crossings at which one skeleton cut may begin, the quickest ones: the lines of a sheet cross all those of the other direction.
const MOST: usize = 8;
/// Distance within which an end of a skeleton cut lies on the edge of the sheet or on another cut, mm: rounding of coordinates.
const SAME: f64 = 1e-6;
/// Least seconds that such a start saves: less is rounding.
const LEAST: f64 = 1e-9;

/// The starts of skeleton cuts on a machine with edge starts. A cut in several passes is pierced in each, and has none.
pub(super) fn skeleton_starts(
    sheet: &Sheet,
    machine: &Profile,
    items: &[Item],
    nodes: &[Node],
) -> Vec<(NodeId, Start)> {
    let mut all = Vec::new();
    if !machine.levers.chains.is_some_and(|l| l.edge_starts) {
        return all;
    }
    let cuts = (0..).zip(&sheet.contours).filter(|(_, c)| c.skeleton).filter_map(|(id, c)| {
        let once = sheet.process_of(c, machine).passes == 1;
        c.path.segments.first().filter(|s| once && matches!(s, Segment::Line(_))).map(|line| (id, *line))
    });
    let cuts: Vec<(u32, Segment)> = cuts.collect();
    let index = BoxIndex::new(cuts.iter().map(|(_, line)| line.bounds()));
    let edge = sheet.edge().map(|path| path.segments.as_slice()).unwrap_or_default();
    let on_edge = |at: DVec2| edge.iter().any(|s| s.nearest(at).1.sqrt() <= SAME);
    let air = AirTime::new(machine);
    for &(id, _) in &cuts {
        let process = sheet.process_by_id(id, machine);
        let cut = |from: DVec2, to: DVec2| cut_time(machine, &process, &[Segment::line(from, to)]);
        for n in items.get(id as usize).map(|i| i.nodes.clone()).unwrap_or_default() {
            let Some(&Node { entry, exit, .. }) = nodes.get(n as usize) else { continue };
            if on_edge(entry) {
                all.push((n, Start { kerf: None, from: entry, seconds: -machine.pierce_time }));
                continue;
            }
            let mut own: Vec<Start> = Vec::new();
            let area = Aabb::of(entry).with(exit).grown(4.0 * SAME);
            let near = index.query(area).into_iter().filter_map(|i| cuts.get(i).copied());
            for (other, across) in near.filter(|c| c.0 != id) {
                let Some(from) = crossing([entry, exit], &across) else { continue };
                let kerf = Some(other);
                if from.distance(entry) <= SAME {
                    own.push(Start { kerf, from: entry, seconds: -machine.pierce_time });
                } else if from.distance(exit) > SAME {
                    let twice = cut(from, entry) + air.seconds(entry, from) + cut(from, exit);
                    let seconds = twice + machine.beam_delays() - cut(entry, exit) - machine.pierce_time;
                    own.push(Start { kerf, from, seconds });
                }
            }
            own.retain(|s| s.seconds < -LEAST);
            sort_by(&mut own, |s| [real(s.seconds), s.kerf.unwrap_or(u32::MAX).into(), 0]);
            own.truncate(MOST);
            all.extend(own.into_iter().map(|start| (n, start)));
        }
    }
    all
}

/// Where a straight cut is crossed by another one, or ends on it.
fn crossing([from, to]: [DVec2; 2], other: &Segment) -> Option<DVec2> {
    let (way, begin, across) = (to - from, other.start(), other.end() - other.start());
    let det = way.perp_dot(across);
    // Upright lines cross level ones.
    if det.abs() <= 0.5 * way.length() * across.length() {
        return None;
    }
    let (t, u) = ((begin - from).perp_dot(across) / det, (begin - from).perp_dot(way) / det);
    let within = |t: f64, length: f64| (-SAME..=length + SAME).contains(&(t * length));
    (within(t, way.length()) && within(u, across.length())).then(|| from + way * t.clamp(0.0, 1.0))
}
