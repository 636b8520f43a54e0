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
mod work;

use super::leads::Planners;
use super::model::{Item, Node, count};
use crate::machine::{AirTime, LeadSide, PLANS_ALL_LEVERS, Profile};
use crate::order::sort_by;
use crate::sheet::{Contour, Operation, Sheet};
use crate::tipping::Zones;
use rustc_hash::FxHashSet;
use work::{Flown, Work};

/// The contours of a sheet that are cut on the run.
#[derive(Default)]
pub(super) struct FlyGroups {
    groups: Vec<Flown>,
    /// By contour: the group it is in.
    of: Vec<Option<u32>>,
}

impl FlyGroups {
    /// Those of a sheet; `ranks` are those of the contours. What shares cuts with others and is cut with them is not flown. `avoided`: the pieces that moves keep clear of. Nothing that frees one of them is flown,
    /// and no pattern that crosses one of them, because the head stays down.
    pub(super) fn new(
        sheet: &Sheet,
        machine: &Profile,
        planners: &Planners,
        ranks: &[u32],
        avoided: Option<&Zones>,
    ) -> Self {
        let Some(lever) = machine.levers.fly.filter(|_| PLANS_ALL_LEVERS && machine.pre_cut_time.is_none())
        else {
            return Self::default();
        };
        let mut all = Self { groups: Vec::new(), of: vec![None; sheet.contours.len()] };
        let tips: FxHashSet<u32> =
            avoided.iter().flat_map(|z| z.pieces()).flat_map(|p| p.cut_by.iter().copied()).collect();
        let shared = sheet.may_be_cut_as_one(machine.cuts_as_one());
        let is_clear = |group: &Flown| avoided.is_none_or(|zones| group.is_clear(zones));
        for mut alike in candidates(sheet, machine, planners, ranks) {
            alike.retain(|c| !tips.contains(c) && !shared[*c as usize]);
            let Some(&first) = alike.first() else { continue };
            let process = sheet.process_by_id(first, machine);
            let work = Work { sheet, machine, lever, process, air: AirTime::new(machine) };
            let mut rows = rows::rows(&work, &alike);
            rows.retain(&is_clear);
            for grid in grids::grids(&work, &alike).into_iter().filter(&is_clear) {
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

    /// Whether a contour is cut on the run.
    pub(super) fn holds(&self, contour: u32) -> bool {
        self.of.get(contour as usize).is_some_and(Option::is_some)
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
