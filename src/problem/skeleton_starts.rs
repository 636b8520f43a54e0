//! Skeleton cuts that begin without piercing (`levers.chains.edge_starts`): at the edge of the sheet if that is drawn, and on the kerf of a
//! skeleton cut that was made before.
//!
//! A skeleton cut keeps its distance from parts, so no kerf of theirs is near. But it runs to the edge of the sheet where nothing is in
//! its way, and its ends may lie on another skeleton cut. Where it only crosses that one, it is cut from there to one end and, after a move
//! back with the beam off, to the other. Each way through a skeleton cut is a node of its item, as those through pierce groups are.

use super::ids::{ItemId, NodeId};
use super::model::{Item, Node, count};
use super::sub_path::{Span, Stroke, SubPath};
use crate::geometry::{DVec2, Path, Segment};
use crate::machine::{AirTime, PLANS_ALL_LEVERS, Process, Profile, cut_time};
use crate::order::{real, sort_by};
use crate::sheet::{Contour, Sheet};

/// Most crossings at which one skeleton cut may begin, the quickest ones: the lines of a sheet cross all those of the other direction.
const MOST: usize = 4;
/// Distance within which an end of a skeleton cut lies on the edge of the sheet or on another cut, mm: rounding of coordinates.
const SAME: f64 = 1e-6;
/// Least seconds that such a way saves: less is rounding.
const LEAST: f64 = 1e-9;

/// The skeleton cuts of a sheet.
pub(super) struct SkeletonStarts<'s> {
    sheet: &'s Sheet,
    machine: &'s Profile,
    edge: Option<&'s Path>,
    air: AirTime,
    cuts: Vec<(u32, Segment)>,
}

/// A way through a skeleton cut, and the skeleton cut on whose kerf it begins.
struct Way {
    path: SubPath,
    kerf: Option<u32>,
}

impl<'s> SkeletonStarts<'s> {
    /// Those of a sheet on a machine with edge starts. A cut in several passes is pierced in each.
    pub(super) fn new(sheet: &'s Sheet, machine: &'s Profile) -> Option<Self> {
        machine.levers.chains.filter(|l| PLANS_ALL_LEVERS && l.edge_starts)?;
        let cuts = (0..).zip(&sheet.contours).filter(|(_, c)| c.skeleton).filter_map(|(id, c)| {
            let once = sheet.process_of(c, machine).passes == 1;
            let line = c.path.segments.first().filter(|s| once && matches!(s, Segment::Line(_)));
            Some((id, *line?))
        });
        let cuts: Vec<(u32, Segment)> = cuts.collect();
        let new = Self { sheet, machine, edge: sheet.edge(), air: AirTime::new(machine), cuts };
        (!new.cuts.is_empty()).then_some(new)
    }

    /// The item of a skeleton cut, if it may begin without piercing. Adds its nodes, and to `kerfs` those that begin on the kerf of another one.
    pub(super) fn item(
        &self,
        id: ItemId,
        contour: &Contour,
        rank: u32,
        nodes: &mut Vec<Node>,
        kerfs: &mut Vec<(NodeId, ItemId)>,
    ) -> Option<Item> {
        let line = self.cuts.iter().find(|c| c.0 == id)?.1;
        let ways = self.ways(id, contour, line);
        if ways.iter().all(|w| matches!(w.path.strokes.first(), Some(Stroke::Pierce))) {
            return None;
        }
        let first = count(nodes);
        let fixed = ways.iter().map(|w| w.path.seconds).fold(f64::INFINITY, f64::min);
        let mut paths = Vec::with_capacity(ways.len());
        for (Way { path, kerf }, node) in ways.into_iter().zip(first..) {
            let [entry, exit] = path.ends;
            nodes.push(Node { item: id, entry, exit, along: 0.0, reversed: false, twin: node });
            kerfs.extend(kerf.map(|kerf| (node, kerf)));
            paths.push(path);
        }
        Some(Item { nodes: first..count(nodes), rank, fixed, paths, ..Item::default() })
    }

    fn ways(&self, id: u32, contour: &Contour, line: Segment) -> Vec<Way> {
        let process = self.sheet.process_of(contour, self.machine);
        let cut = Cut { contour: id, line, process, machine: self.machine, air: &self.air };
        let on_edge =
            |at: DVec2| self.edge.is_some_and(|e| e.segments.iter().any(|s| s.nearest(at).1.sqrt() <= SAME));
        let length = line.length();
        let ends = [(0.0, line.start()), (length, line.end())];
        let mut ways: Vec<Way> = Vec::new();
        for (from, at) in ends {
            ways.push(Way { path: cut.way(from, &[length - from], !on_edge(at)), kerf: None });
        }
        if ends.iter().any(|e| on_edge(e.1)) {
            return ways;
        }
        let pierced = ways.iter().map(|w| w.path.seconds).fold(f64::INFINITY, f64::min);
        let mut crossed: Vec<Way> = Vec::new();
        for &(other, across) in self.cuts.iter().filter(|c| c.0 != id) {
            let Some(along) = crossing(&line, &across) else { continue };
            let mut ways: Vec<Way> = Vec::new();
            for (end, _) in ends {
                let far = length - end;
                let to = if (along - end).abs() <= SAME {
                    vec![far]
                } else if (along - far).abs() <= SAME {
                    continue;
                } else {
                    vec![end, far]
                };
                ways.push(Way { path: cut.way(along, &to, false), kerf: Some(other) });
            }
            crossed.extend(ways.into_iter().filter(|w| w.path.seconds < pierced - LEAST));
        }
        sort_by(&mut crossed, |w| [real(w.path.seconds), w.kerf.unwrap_or(u32::MAX).into(), 0]);
        crossed.truncate(2 * MOST);
        ways.extend(crossed);
        ways
    }
}

/// Where a line is crossed by another one, or ends on it: the length of the line up to there, mm.
fn crossing(line: &Segment, other: &Segment) -> Option<f64> {
    let (from, way) = (line.start(), line.end() - line.start());
    let (begin, across) = (other.start(), other.end() - other.start());
    let det = way.perp_dot(across);
    // Upright lines cross level ones.
    if det.abs() <= 0.5 * way.length() * across.length() {
        return None;
    }
    let (t, u) = ((begin - from).perp_dot(across) / det, (begin - from).perp_dot(way) / det);
    let within = |t: f64, length: f64| (-SAME..=length + SAME).contains(&(t * length));
    let length = way.length();
    (within(t, length) && within(u, across.length())).then_some((t * length).clamp(0.0, length))
}

/// A skeleton cut.
struct Cut<'m> {
    contour: u32,
    line: Segment,
    process: Process,
    machine: &'m Profile,
    air: &'m AirTime,
}

impl Cut<'_> {
    /// The way that begins `from` mm along the line and cuts to each of these places in turn, each time from where it began.
    fn way(&self, from: f64, to: &[f64], is_pierced: bool) -> SubPath {
        let length = self.line.length();
        let at = |along: f64| self.line.at(if length > 0.0 { along / length } else { 0.0 });
        let mut seconds = 0.0;
        let mut strokes = Vec::new();
        if is_pierced {
            strokes.push(Stroke::Pierce);
            seconds += self.machine.pierce_time;
        }
        for (k, &until) in to.iter().enumerate() {
            if k > 0 {
                let head = to.get(k - 1).map_or(from, |&before| before);
                strokes.push(Stroke::Air(at(from)));
                seconds += self.air.seconds(at(head), at(from));
            }
            let path = vec![Segment::line(at(from), at(until))];
            seconds += self.machine.beam_delays() + cut_time(self.machine, &self.process, &path);
            let (reversed, length) = (until < from, (until - from).abs());
            let span = Span { contour: self.contour, along: from, until, reversed, length, elements: 1 };
            strokes.push(Stroke::Cut { spans: vec![span], path, overcut: 0 });
        }
        let ends = [at(from), to.last().map_or(at(from), |&until| at(until))];
        SubPath { ends, lead_in: None, strokes, seconds, leave_points: Vec::new(), falls: Vec::new() }
    }
}
