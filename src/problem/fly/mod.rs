//! Fly cuts (`levers.fly` of the machine): which contours are cut on the run, and the ways through them.
//!
//! Two patterns pay. In a *row* (`rows.rs`), each contour is cut in one go from a place where it runs along the row, and the head
//! goes straight on to the next one. In a *grid* (`grids.rs`), the sides that lie on one line are cut in one run, and a contour is
//! complete when all its sides are. The contours of a row or a grid are one item with a few ways through it, like those of a pierce
//! group: the search chooses the way, and what comes before and after it.
//!
//! A pattern is flown only where that takes fewer seconds than cutting its contours one by one, each at its least, with the
//! shortest moves between them. Where patterns overlap, those that save more win.

mod grids;
mod rows;

use super::from_sheet::{count, seconds_alone};
use super::leads::Planners;
use super::model::{Item, Node};
use super::sub_path::{Stroke, SubPath};
use crate::geometry::{DVec2, Segment};
use crate::machine::{AirTime, Fly, LeadSide, Process, Profile, cut_time};
use crate::order::{real, sort_by};
use crate::sheet::{Contour, Operation, Sheet};

/// Contours that are cut on the run, and the ways through them: each is followed by the same way back.
struct Flown {
    contours: Vec<u32>,
    ways: Vec<SubPath>,
    /// Seconds less than one by one.
    saved: f64,
}

/// The contours of a sheet that are cut on the run.
#[derive(Default)]
pub(super) struct FlyGroups {
    groups: Vec<Flown>,
    /// By contour: the group it is in.
    of: Vec<Option<u32>>,
}

impl FlyGroups {
    /// Those of a sheet; `ranks` are those of the contours.
    pub(super) fn new(sheet: &Sheet, machine: &Profile, planners: &Planners, ranks: &[u32]) -> Self {
        let Some(lever) = machine.levers.fly.filter(|_| machine.pre_cut_time.is_none()) else {
            return Self::default();
        };
        let mut all = Self { groups: Vec::new(), of: vec![None; sheet.contours.len()] };
        for alike in candidates(sheet, machine, planners, ranks) {
            let Some(&first) = alike.first() else { continue };
            let process = sheet.process_by_id(first, machine);
            let work = Work { sheet, machine, lever, process, air: AirTime::new(machine) };
            let mut rows = rows::rows(&work, &alike);
            for grid in grids::grids(&work, &alike) {
                let overlaps =
                    |row: &Flown| row.contours.iter().any(|c| grid.contours.binary_search(c).is_ok());
                let (within, rest): (Vec<Flown>, Vec<Flown>) = rows.into_iter().partition(overlaps);
                rows = rest;
                if grid.saved > within.iter().map(|r| r.saved).sum() {
                    all.add(grid);
                } else {
                    rows.extend(within);
                }
            }
            rows.into_iter().for_each(|row| all.add(row));
        }
        all
    }

    fn add(&mut self, group: Flown) {
        let index = u32::try_from(self.groups.len()).ok();
        // A row of which a grid has taken some contours is not flown.
        if group.contours.iter().any(|&c| self.of.get(c as usize).is_none_or(Option::is_some)) {
            return;
        }
        for &c in &group.contours {
            if let Some(of) = self.of.get_mut(c as usize) {
                *of = index;
            }
        }
        self.groups.push(group);
    }

    /// The item of a contour that is cut on the run: the first contour of a group gets all ways through it as nodes, the others
    /// get none. `before`: the contour around all of them.
    pub(super) fn item(
        &self,
        contour: u32,
        rank: u32,
        before: Option<u32>,
        nodes: &mut Vec<Node>,
    ) -> Option<Item> {
        let group = self.groups.get(self.of.get(contour as usize).copied().flatten()? as usize)?;
        let first = count(nodes);
        if group.contours.first() != Some(&contour) {
            return Some(Item { nodes: first..first, rank, ..Item::default() });
        }
        for (path, id) in group.ways.iter().zip(first..) {
            let [entry, exit] = path.ends;
            let twin = first + ((id - first) ^ 1);
            nodes.push(Node { item: contour, entry, exit, along: 0.0, reversed: false, twin });
        }
        let fixed = group.ways.iter().map(|p| p.seconds).fold(f64::INFINITY, f64::min);
        let paths = group.ways.clone();
        Some(Item { nodes: first..count(nodes), before, rank, fixed, paths, ..Item::default() })
    }
}

/// The contours that may be cut on the run, those together that may be in one run: closed cuts in one pass with nothing inside
/// them, on one layer, inside one contour and of one rank. What has joints or leads, belongs to a sequence, or crosses itself is
/// not cut on the run.
fn candidates(sheet: &Sheet, machine: &Profile, planners: &Planners, ranks: &[u32]) -> Vec<Vec<u32>> {
    let mut holds = vec![false; sheet.contours.len()];
    for outer in sheet.contours.iter().filter(|c| c.is_processed()).filter_map(|c| c.inside) {
        if let Some(holds) = holds.get_mut(outer as usize) {
            *holds = true;
        }
    }
    let may = |id: u32, c: &Contour| {
        let once = sheet.process_of(c, machine).passes == 1 && c.pass == 0 && c.next_pass.is_none();
        let hole = c.depth % 2 == 1;
        c.path.closed
            && c.operation == Operation::Cut
            && once
            && !c.self_crossing
            && !holds.get(id as usize).is_some_and(|h| *h)
            && !sheet.has_turn(c)
            && !has_lead(sheet, machine, id, c)
            && planners.joints(id).is_none()
            // Outlines of other parts may not come in between.
            && (hole || !sheet.part_by_part)
    };
    let key = |id: u32, c: &Contour| {
        let place = |of: Option<u32>| of.map_or(0, |c| 1 + u64::from(c));
        let rank = ranks.get(id as usize).copied().unwrap_or_default();
        [place(c.inside), place(c.together) << 32 | u64::from(c.layer), rank.into()]
    };
    let mut all: Vec<([u64; 3], u32)> =
        (0..).zip(&sheet.contours).filter(|(id, c)| may(*id, c)).map(|(id, c)| (key(id, c), id)).collect();
    sort_by(&mut all, |(key, _)| *key);
    all.chunk_by(|a, b| a.0 == b.0).map(|alike| alike.iter().map(|a| a.1).collect()).collect()
}

/// Whether a rule or a person asks for the lead of a contour.
fn has_lead(sheet: &Sheet, machine: &Profile, id: u32, contour: &Contour) -> bool {
    let side = if contour.depth % 2 == 1 { LeadSide::Hole } else { LeadSide::Outer };
    let size = contour.path.bounds().size().max_element();
    let rule = || machine.leads.as_ref()?.rule(side, size, contour.path.length());
    sheet.chosen_lead(id).is_some() || rule().is_some()
}

/// What both patterns need: the contours and their seconds.
struct Work<'s> {
    sheet: &'s Sheet,
    machine: &'s Profile,
    lever: Fly,
    process: Process,
    air: AirTime,
}

impl Work<'_> {
    fn contour(&self, id: u32) -> Option<&Contour> {
        self.sheet.contours.get(id as usize)
    }

    /// A way of these strokes from a place to another, with its seconds.
    fn way(&self, strokes: Vec<Stroke>) -> Option<SubPath> {
        let start =
            strokes.iter().find_map(|s| if let Stroke::Cut { path, .. } = s { path.first() } else { None });
        let start = start?.start();
        let (mut head, mut seconds) = (start, 0.0);
        let mut motion: Vec<Segment> = Vec::new();
        for (k, stroke) in strokes.iter().enumerate() {
            match stroke {
                Stroke::Air(to) => {
                    seconds += self.air.seconds(head, *to);
                    head = *to;
                }
                Stroke::Cut { path, .. } | Stroke::Fly(path) => {
                    motion.extend(path);
                    head = path.last().map_or(head, Segment::end);
                    if !matches!(strokes.get(k + 1), Some(Stroke::Cut { .. } | Stroke::Fly(_))) {
                        seconds +=
                            cut_time(self.machine, &self.process, &motion) + self.machine.delays_of_cut(true);
                        motion.clear();
                    }
                }
                Stroke::Pierce | Stroke::MovingStart | Stroke::PreCut { .. } => {}
            }
        }
        let ends = [start, head];
        Some(SubPath { ends, strokes, seconds, leave_points: Vec::new(), falls: Vec::new() })
    }

    /// Contours as one group, if that saves seconds. `hop`: the least distance between two of them that follow each other, mm.
    fn flown(&self, mut contours: Vec<u32>, ways: Vec<SubPath>, hop: f64) -> Option<Flown> {
        let alone = |id: &u32| self.contour(*id).map_or(0.0, |c| seconds_alone(self.sheet, self.machine, c));
        let hops = contours.len().saturating_sub(1) as f64;
        // Along either axis a move is not faster than along both.
        let hop = self
            .air
            .seconds(DVec2::ZERO, DVec2::new(hop, 0.0))
            .min(self.air.seconds(DVec2::ZERO, DVec2::new(0.0, hop)));
        let alone = contours.iter().map(alone).sum::<f64>() + hops * hop;
        let least = ways.iter().map(|w| w.seconds).fold(f64::INFINITY, f64::min);
        sort_by(&mut contours, |&c| [c.into(), 0, 0]);
        let saved = alone - least;
        (saved > 0.0).then_some(Flown { contours, ways, saved })
    }
}

/// The distance between two boxes along the farther axis, mm.
fn apart(a: &Contour, b: &Contour) -> f64 {
    let gap = (a.bounds.min - b.bounds.max).max(b.bounds.min - a.bounds.max);
    gap.max_element().max(0.0)
}

/// Sorts by two numbers.
fn sort_by_two<T>(items: &mut Vec<T>, numbers: impl Fn(&T) -> [f64; 2]) {
    sort_by(items, |item| {
        let [a, b] = numbers(item);
        [real(a), real(b), 0]
    });
}
