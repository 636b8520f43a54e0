//! The best path as flat arrays, for drawing it. Stop k cuts contour `contours[k]`, or a stretch of it.

use super::cutting_times::{contour_of, cutting_times};
use super::halves::{Half, halves};
use super::{Geometry, Run};
use crate::geometry::{Path, Segment};
use crate::machine::{CornerKind, PLANS_ALL_LEVERS};
use crate::plan::{Move, Plan, Way};
use crate::problem::{Item, Span, Stroke};
use crate::sheet::Sheet;
use crate::solve::{Begun, begun};

/// The path of the head.
#[derive(Clone, Debug, PartialEq, Default)]
pub struct BestPath {
    /// Contour of each stop.
    pub contours: Vec<u32>,
    /// Entry x, y and exit x, y of each stop, mm.
    pub points: Vec<f64>,
    /// Arc length from the contour's stored start to the entry, mm.
    pub along: Vec<f64>,
    /// Arc length from the stored start to where the stop ends, mm. If it equals `along`, the stop cuts the whole contour;
    /// a contour that is left unfinished has several stops.
    pub until: Vec<f64>,
    /// 1 where a stop cuts its contour against the stored direction.
    pub reversed: Vec<u8>,
    /// Seconds from the start of the job at which each stop starts and stops cutting.
    pub times: Vec<f64>,
    /// The lead-in and the lead-out of each stop, in this order; no paths if there are no leads.
    pub leads: Geometry,
    /// The micro-joints, which stay uncut, in the order of the stops.
    pub joints: Geometry,
    /// The loops at corners, in the order of the stops.
    pub loops: Geometry,
    /// Positions of pre-cuts: x, y each, mm.
    pub pre_cuts: Vec<f64>,
    /// Sharp corners where a cut pauses: x, y each, mm.
    pub pauses: Vec<f64>,
    /// What the move to each stop does about pieces that may have tipped, and last that of the way home: 0 nothing, 1 it goes around
    /// them, 2 it is lifted over them, 3 it crosses them with the head down; 4: it is a cut through waste; 5: it
    /// goes to a place on a kerf, and is a cut through waste from there. Empty if the machine has no
    /// `levers.tips` and the plan no chains.
    pub ways: Vec<u8>,
    /// The places on the way around tipped pieces, and those on kerfs: x, y each, mm.
    pub via: Vec<f64>,
    /// The stop to which each of these moves leads; for the way home, the number of stops.
    pub via_of: Vec<u32>,
    /// Contours that bound pieces which may tip once they are free; of a strip between parts, a cut across its end.
    pub tips: Vec<u32>,
    /// The stop that frees each of these pieces.
    pub freed_by: Vec<u32>,
    /// Seconds that the head waits before each stop until what was cut nearby has cooled; empty if it never does.
    pub waits: Vec<f64>,
}

impl BestPath {
    /// The best path of a run, and its plan.
    pub fn of(run: &Run, sheet: &Sheet) -> (Self, Plan) {
        let plan = run.plan(sheet);
        let problem = run.problem();
        let mut path = Self::default();
        // For each motion, the lengths of its stretches, each after that of the way to it with the beam off.
        let mut parts: Vec<Vec<[f64; 2]>> = Vec::new();
        let starts = if PLANS_ALL_LEVERS { begun(problem, &run.best().stops) } else { Vec::new() };
        for (k, stop) in run.best().stops.iter().enumerate() {
            let node = &problem.nodes[stop.node as usize];
            let begins = starts.get(k).copied().and_then(Begun::start);
            if let Some(both) = begins.and_then(|begins| halves(sheet, problem, *stop, begins)) {
                path.add_halves(both);
                parts.extend(vec![vec![[0.0, 1.0]]; 2]);
                continue;
            }
            if let Some(sub_path) = problem.items.get(node.item as usize).and_then(|i| i.path(stop.node)) {
                path.add_group(&sub_path.stretch(stop.along, stop.until), sheet, &mut parts);
                continue;
            }
            let (entry, exit) = stop.ends(problem).unwrap_or((node.entry, node.exit));
            path.contours.push(node.item);
            path.points.extend([entry.x, entry.y, exit.x, exit.y]);
            path.along.push(stop.along);
            path.until.push(stop.until);
            path.reversed.push(node.reversed.into());
            parts.push(vec![[0.0, 1.0]]);
        }
        for step in &plan.moves {
            match step {
                Move::PreCut { to, .. } => path.pre_cuts.extend([to.x, to.y]),
                Move::Macro { at, .. } => path.pauses.extend([at.x, at.y]),
                _ => {}
            }
        }
        path.leads = leads(run, path.contours.len());
        path.joints = Geometry::of(joints(run, sheet).iter());
        if PLANS_ALL_LEVERS {
            path.loops = loops(&plan);
        }
        if let Some(zones) = problem.zones.as_ref().filter(|_| PLANS_ALL_LEVERS) {
            path.add_tips(zones.pieces().iter().map(|p| (p.drawn, p.cut_by.as_slice())));
        }
        if problem.zones.is_some() || plan.summary.chains > 0 {
            path.add_ways(&plan);
        }
        path.add_waits(&plan);
        path.times = cutting_times(&plan, &run.machine, sheet, &parts);
        (path, plan)
    }

    /// Adds the pieces that may tip, each with the last of the stops that free it. `pieces`: the contour of each, and the contours that free it.
    fn add_tips<'p>(&mut self, pieces: impl Iterator<Item = (u32, &'p [u32])>) {
        let mut last: Vec<Option<u32>> = Vec::new();
        for (stop, &contour) in (0..).zip(&self.contours) {
            let contour = contour as usize;
            if last.len() <= contour {
                last.resize(contour + 1, None);
            }
            last[contour] = Some(stop);
        }
        for (contour, cut_by) in pieces {
            let stops = cut_by.iter().filter_map(|&c| last.get(c as usize).copied().flatten());
            if let Some(stop) = stops.max() {
                self.tips.push(contour);
                self.freed_by.push(stop);
            }
        }
    }

    /// Adds a visit of a pierce group or of contours that are cut on the run: one stop for each stretch of a contour.
    fn add_group(&mut self, strokes: &[Stroke], sheet: &Sheet, parts: &mut Vec<Vec<[f64; 2]>>) {
        let mut dark = None;
        for stroke in strokes {
            match stroke {
                Stroke::Fly(path) => dark = Some(path.iter().map(Segment::length).sum::<f64>()),
                Stroke::Cut { spans, .. } => {
                    let on_the_run = dark.take();
                    let lengths = spans.iter().map(|s| [0.0, s.length]);
                    match (on_the_run, parts.last_mut()) {
                        (Some(way), Some(motion)) => {
                            let begins = motion.len();
                            motion.extend(lengths);
                            motion.get_mut(begins).iter_mut().for_each(|first| first[0] = way);
                        }
                        _ => parts.push(lengths.collect()),
                    }
                    self.add_spans(spans, sheet);
                }
                _ => {}
            }
        }
    }

    /// Notes what the air moves do about tipped pieces, and where there are chains in their place. An air move leads to the stop of
    /// the next cut.
    fn add_ways(&mut self, plan: &Plan) {
        self.ways = vec![0; self.contours.len() + 1];
        let (mut stop, mut cut) = (0, false);
        for (index, step) in plan.moves.iter().enumerate() {
            cut |= matches!(step, Move::Cut { .. });
            if !matches!(step, Move::Air { .. } | Move::Chain { .. }) {
                continue;
            }
            let next = plan.moves.iter().skip(index).find_map(contour_of);
            // After a cut it leads to another stop, which may be on the same contour.
            let from = stop + usize::from(std::mem::take(&mut cut));
            let rest = self.contours.iter().enumerate().skip(from);
            let home = self.contours.len();
            stop = next.map_or(home, |c| rest.into_iter().find(|s| *s.1 == c).map_or(stop, |s| s.0));
            let before = index.checked_sub(1).and_then(|k| plan.moves.get(k));
            // Where the head waits before it cuts through waste, it has arrived before that.
            let arrived = match before {
                Some(Move::Wait { .. }) if PLANS_ALL_LEVERS => {
                    index.checked_sub(2).and_then(|k| plan.moves.get(k))
                }
                _ => before,
            };
            let kind = match step {
                Move::Air { way: Way::Around, .. } => 1,
                Move::Air { way: Way::Lifted, .. } => 2,
                Move::Air { way: Way::Crosses, .. } => 3,
                Move::Chain { .. } if matches!(before, Some(Move::Cut { .. })) => 4,
                Move::Chain { .. } => 5,
                _ => continue,
            };
            if let Some(noted) = self.ways.get_mut(stop) {
                *noted = kind.max(*noted);
            }
            let via = match (step, arrived) {
                (Move::Air { to, way: Way::Around }, _) => Some(to),
                (Move::Chain { .. }, Some(Move::Air { to, .. })) => Some(to),
                _ => None,
            };
            if let Some(to) = via {
                self.via.extend([to.x, to.y]);
                self.via_of.push(u32::try_from(stop).unwrap_or(u32::MAX));
            }
        }
    }

    /// Notes the waits. A machine that waits cuts every contour in one stop.
    fn add_waits(&mut self, plan: &Plan) {
        if plan.summary.waits == 0 {
            return;
        }
        self.waits = vec![0.0; self.contours.len()];
        let mut stop = 0;
        for (index, step) in plan.moves.iter().enumerate() {
            let Move::Wait { seconds } = step else { continue };
            let next = plan.moves.iter().skip(index).find_map(contour_of);
            let rest = self.contours.iter().skip(stop);
            stop += rest.zip(0..).find(|s| Some(*s.0) == next).map_or(0, |s| s.1);
            if let Some(noted) = self.waits.get_mut(stop) {
                *noted = *seconds;
            }
        }
    }

    fn add_halves(&mut self, both: [Half; 2]) {
        for Half { contour, ends: [from, to], along, until, reversed } in both {
            self.contours.push(contour);
            self.points.extend([from.x, from.y, to.x, to.y]);
            self.along.push(along);
            self.until.push(until);
            self.reversed.push(reversed.into());
        }
    }

    fn add_spans(&mut self, spans: &[Span], sheet: &Sheet) {
        for span in spans {
            let at = |along: f64| {
                sheet.contours.get(span.contour as usize).and_then(|c| c.path.at(along)).unwrap_or_default()
            };
            let (from, to) = (at(span.along), at(span.until));
            self.contours.push(span.contour);
            self.points.extend([from.x, from.y, to.x, to.y]);
            self.along.push(span.along);
            self.until.push(span.until);
            self.reversed.push(span.reversed.into());
        }
    }
}

/// The leads of `stops` stops. Skeleton cuts, which come last and may have two stops each, have none.
fn leads(run: &Run, stops: usize) -> Geometry {
    let problem = run.problem();
    let led = |i: &Item| i.leads.is_some() || i.paths.iter().any(|path| path.lead_in.is_some());
    if !problem.items.iter().any(led) {
        return Geometry::default();
    }
    let mut paths: Vec<Path> = Vec::with_capacity(2 * run.best().stops.len());
    for stop in &run.best().stops {
        let item = problem.nodes.get(stop.node as usize).and_then(|n| problem.items.get(n.item as usize));
        // Of a pierce group, each stretch is a stop, and the first one has the lead.
        if let Some(path) = item.and_then(|i| i.path(stop.node)) {
            paths.push(Path::new(path.lead_in.into_iter().collect(), false));
            paths.extend(vec![Path::default(); 2 * path.spans().count() - 1]);
            continue;
        }
        let lead = item.and_then(|i| i.lead(stop.node)).map(|l| l.0);
        let lead = lead.cloned().unwrap_or_default();
        paths.extend([lead.lead_in, lead.lead_out].map(|path| Path::new(path, false)));
    }
    if PLANS_ALL_LEVERS {
        paths.resize(2 * stops, Path::default());
    }
    Geometry::of(paths.iter())
}

/// The loops of a plan.
fn loops(plan: &Plan) -> Geometry {
    let of = |m: &Move| match m {
        Move::Cut { path, turns, .. } => {
            let loops = turns.iter().filter(|turn| turn.kind == CornerKind::Loop);
            loops.map(|turn| Path::new(turn.of(path).to_vec(), false)).collect()
        }
        _ => Vec::new(),
    };
    let paths: Vec<Path> = plan.moves.iter().flat_map(of).collect();
    if paths.is_empty() { Geometry::default() } else { Geometry::of(paths.iter()) }
}

/// The joints of the stops.
fn joints(run: &Run, sheet: &Sheet) -> Vec<Path> {
    let problem = run.problem();
    let mut paths = Vec::new();
    for stop in &run.best().stops {
        let Some(contour) = problem.nodes.get(stop.node as usize).map(|n| n.item as usize) else { continue };
        let item = problem.items.get(contour).and_then(|i| i.joints.as_ref());
        if let (Some(joints), Some(known)) = (item, sheet.contours.get(contour)) {
            paths.extend(joints.joints.iter().map(|j| Path::new(known.path.between(j.from, j.to), false)));
        }
    }
    paths
}
