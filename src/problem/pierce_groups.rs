//! Pierce groups as items: which contours are one item, and which item it must come before.

use super::beside::in_one_go;
use super::ids::{ItemId, NodeId};
use super::model::{Item, Node};
use super::seconds::seconds_alone;
use super::sub_path::{Stroke, SubPath};
use crate::geometry::{Aabb, Segment, winding_number};
use crate::lead::Planner;
use crate::machine::{PLANS_ALL_LEVERS, Profile, air_time, process_time};
use crate::sheet::{Contour, PierceGroup, Sheet};

/// The pierce groups of a sheet that are cut as one, with the paths through each.
pub(super) struct PierceGroups<'s> {
    sheet: &'s Sheet,
    /// Whether groups are never left for other items.
    in_one_go: bool,
    groups: Vec<(&'s PierceGroup, Vec<SubPath>)>,
    /// By contour: the group it is in.
    of: Vec<Option<u32>>,
    /// By contour: the group that closes it in, the smallest of several.
    within: Vec<Option<u32>>,
    /// By contour: the area in which it lies, of the group that it comes directly before.
    area: Vec<Option<u32>>,
}

/// Whether cutting a group as one takes fewer seconds than cutting its contours one by one, each from its best entry and without
/// moves between them. With pre-cuts it always does: plate is pierced for seconds.
fn pays(sheet: &Sheet, machine: &Profile, group: &PierceGroup, paths: &[SubPath]) -> bool {
    let contours = group.contours.iter().filter_map(|&c| sheet.contours.get(c as usize));
    let alone: f64 = contours.map(|c| seconds_alone(sheet, machine, c)).sum();
    !PLANS_ALL_LEVERS || machine.makes_pre_cuts() || paths.iter().any(|path| path.seconds < alone)
}

/// The pairs of paths that begin with a lead-in; without one, if none does.
fn with_leads(machine: &Profile, leads: &Planner, paths: &[SubPath]) -> Vec<SubPath> {
    let led: Vec<SubPath> = paths.iter().map(|path| with_lead(machine, leads, path)).collect();
    let pairs = led.chunks(2).filter(|pair| pair.iter().all(|path| path.lead_in.is_some()));
    let all: Vec<SubPath> = pairs.flatten().cloned().collect();
    if all.is_empty() { paths.to_vec() } else { all }
}

/// A path with the lead-in to where it is pierced, if there is one.
fn with_lead(machine: &Profile, leads: &Planner, path: &SubPath) -> SubPath {
    let mut path = path.clone();
    // The head moves to the lead in place of the first stroke's beginning.
    let skipped = match path.strokes.first() {
        Some(Stroke::Air(to)) => air_time(machine, path.ends[0], *to),
        _ => 0.0,
    };
    let first = path.strokes.iter().find_map(|s| match s {
        Stroke::Cut { spans, path, .. } => Some((spans.first()?.contour, path)),
        _ => None,
    });
    let Some((contour, run)) = first else { return path };
    let lead = run.first().and_then(|s| leads.lead_to_node(contour, s.start()));
    let Some(lead) = lead else { return path };
    let seconds = |path: &[Segment]| process_time(machine, &machine.cut, false, path);
    let with: Vec<Segment> = std::iter::once(lead).chain(run.iter().copied()).collect();
    path.seconds += seconds(&with) - seconds(run) - skipped;
    if matches!(path.strokes.first(), Some(Stroke::Air(_))) {
        path.strokes.remove(0);
    }
    path.ends[0] = lead.start();
    path.lead_in = Some(lead);
    path
}

impl<'s> PierceGroups<'s> {
    /// The groups that the machine cuts as one, and through which there is a path. Without pre-cuts, they are cut as one where
    /// that takes fewer seconds, and with lead-ins. `paths`: the paths through each group.
    pub(super) fn new(
        sheet: &'s Sheet,
        machine: &Profile,
        leads: Option<&Planner>,
        paths: &[Vec<SubPath>],
    ) -> Self {
        let leads = leads.filter(|_| PLANS_ALL_LEVERS && !machine.makes_pre_cuts());
        let none = vec![None; sheet.contours.len()];
        let in_one_go = in_one_go(sheet, machine);
        let mut all =
            Self { sheet, in_one_go, groups: Vec::new(), of: none.clone(), within: none.clone(), area: none };
        let groups = sheet.cut_as_one(machine.cuts_as_one());
        for (group, paths) in groups.iter().zip(paths) {
            if paths.is_empty() || !pays(sheet, machine, group, paths) {
                continue;
            }
            let index = u32::try_from(all.groups.len()).ok();
            for &c in &group.contours {
                all.of[c as usize] = index;
            }
            for &c in &group.inside {
                let size = |g: u32| all.groups[g as usize].0.inside.len();
                let larger = all.within[c as usize].is_none_or(|g| size(g) > group.inside.len());
                if larger {
                    all.within[c as usize] = index;
                }
            }
            all.groups.push((group, leads.map_or_else(|| paths.clone(), |l| with_leads(machine, l, paths))));
        }
        all.find_areas();
        all
    }

    /// Finds the area of each contour that comes before a group which may be left for it.
    fn find_areas(&mut self) {
        for (group, paths) in &self.groups {
            let inside = |c: &&u32| self.before(**c) == Some(group.contours[0]);
            let inside: Vec<u32> = group.inside.iter().filter(inside).copied().collect();
            if inside.is_empty() || paths.iter().all(|p| p.leave_points.is_empty()) {
                continue;
            }
            let outlines = group.outlines();
            let bounds: Vec<Aabb> = outlines
                .iter()
                .map(|o| o.iter().fold(Aabb::EMPTY, |b, s: &Segment| b.union(s.bounds())))
                .collect();
            for c in inside {
                let path = &self.sheet.contours[c as usize].path;
                // The middle is used because the ends may lie on the outline.
                let Some(at) = path.at(0.5 * path.length()) else { continue };
                let holds =
                    |area: &usize| bounds[*area].contains(at) && winding_number(&outlines[*area], at) != 0;
                self.area[c as usize] =
                    (1..outlines.len()).find(holds).and_then(|area| u32::try_from(area).ok());
            }
        }
    }

    /// Whether a contour is in a group.
    pub(super) fn holds(&self, contour: u32) -> bool {
        self.of.get(contour as usize).is_some_and(Option::is_some)
    }

    /// The area of a group in which a contour lies that comes directly before the group.
    pub(super) fn area(&self, contour: u32) -> Option<u32> {
        self.area[contour as usize]
    }

    /// The contour whose item stands for a contour: the first of its group.
    pub(super) fn stands_for(&self, contour: u32) -> ItemId {
        let group = self.of.get(contour as usize).copied().flatten();
        group.map_or(contour, |g| self.groups[g as usize].0.contours[0])
    }

    /// The contour that a contour, or all of its group, must come before.
    pub(super) fn before(&self, contour: u32) -> Option<ItemId> {
        let up = |c: &u32| self.sheet.contours.get(*c as usize).and_then(|c| c.inside).filter(|o| o != c);
        // Contours around it may be skipped, because others cut all of them.
        let is_processed = |o: &u32| self.sheet.contours.get(*o as usize).is_some_and(Contour::is_processed);
        let inside = |c: u32| std::iter::successors(up(&c), up).take(self.of.len()).find(is_processed);
        let own = self.of[contour as usize];
        // The contour around the whole group, not one of its members.
        let mut outer = inside(contour);
        while let Some(o) = outer.filter(|&o| own.is_some() && self.of[o as usize] == own) {
            outer = inside(o);
        }
        let closed_in = self.within[contour as usize].filter(|&g| Some(g) != own);
        let Some((group, _)) = closed_in.and_then(|g| self.groups.get(g as usize)) else {
            return outer.map(|o| self.stands_for(o));
        };
        // A contour around it inside the group is nearer than the group.
        let nearer = outer.filter(|o| group.inside.contains(o));
        Some(nearer.map_or(group.contours[0], |o| self.stands_for(o)))
    }

    /// The item of a contour in a group: the first contour gets all paths through the group as nodes, the others get none.
    pub(super) fn item(&self, contour: u32, rank: u32, nodes: &mut Vec<Node>) -> Option<Item> {
        let (group, paths) = &self.groups[self.of[contour as usize]? as usize];
        let first = NodeId::try_from(nodes.len()).ok()?;
        let stands = group.contours[0] == contour;
        let mut paths = if stands { paths.clone() } else { Vec::new() };
        if self.in_one_go {
            paths.iter_mut().for_each(|p| p.leave_points.clear());
        }
        for (path, id) in paths.iter().zip(first..) {
            let [entry, exit] = path.ends;
            let twin = first + ((id - first) ^ 1);
            nodes.push(Node { item: contour, entry, exit, along: 0.0, reversed: false, twin });
        }
        let least = paths.iter().map(|p| p.seconds).fold(f64::INFINITY, f64::min);
        Some(Item {
            nodes: first..NodeId::try_from(nodes.len()).ok()?,
            before: self.before(contour).filter(|_| stands),
            rank,
            fixed: if stands { least } else { 0.0 },
            paths,
            area: self.area(contour),
            ..Item::default()
        })
    }

    /// Raises all contours of a group to one rank, which is not below that of anything they enclose, and the contours
    /// around the group to at least that rank.
    pub(super) fn raise(&self, ranks: &mut [u32]) {
        for (group, _) in &self.groups {
            let all = group.contours.iter().chain(&group.inside);
            let most = all.map(|&c| ranks[c as usize]).max().unwrap_or(0);
            group.contours.iter().for_each(|&c| ranks[c as usize] = most);
            let mut outer = self.before(group.contours[0]);
            // The limit ends the loop whatever the nesting says.
            for _ in 0..ranks.len() {
                let Some(o) = outer else { break };
                ranks[o as usize] = ranks[o as usize].max(most);
                outer = self.before(o);
            }
        }
    }
}
