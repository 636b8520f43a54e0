//! Conversion of a sheet to a problem: one item for each contour, with entries, precedence from the nesting, and a rank.

use super::between_parts::between_parts;
use super::chains::Candidates;
use super::fly::FlyGroups;
use super::groups::Groups;
use super::heat;
use super::ids::{ItemId, NodeId};
use super::kerf_starts::KerfStarts;
use super::leads::Planners;
use super::links::Links;
use super::model::{Item, Node, Problem};
use super::pierce_groups::PierceGroups;
use super::single::Singles;
use super::skeleton_starts::skeleton_starts;
use super::starts::{Start, Starts};
use super::sub_path::SubPath;
use super::tipping;
use crate::machine::{AirTime, PLANS_ALL_LEVERS, Profile};
use crate::order::sort_by;
use crate::sheet::{Operation, Sheet};

/// The problem of cutting a sheet on a machine. The item of a contour has the contour's index.
///
/// * Nodes: the entries of a contour (`entries.rs`); which of the following a contour has is decided in `single.rs`.
/// * Precedence: a contour is cut after everything inside it, because a part that is cut free may shift.
/// * Rank: contours that are pinned first or last, then layers if the sheet is ordered by layer, then marks before cuts, and small
///   holes before other cuts on a machine that asks for it. A
///   contour around another one has at least its rank: if the order by layer would cut an outer contour first, the nesting
///   wins.
/// * Fixed seconds: piercing (cuts only), beam delays, and the run along the contour from its cheapest entry. What other
///   entries cost beyond that is charged by place.
/// * Leaving: closed cuts may be left unfinished if the machine allows it, but not when parts are cut one by one.
/// * Pierce groups: if the machine makes pre-cuts or has `levers.common_cuts`, the item of the group's first contour stands for all of them, and its
///   nodes are paths through the group. The items of the other contours have no nodes. A path may be left at its leave
///   points, but not when parts are cut one by one.
/// * Passes: at once, they are one item whose seconds count for each pass; sheet by sheet, each is an item of its own, and
///   comes before the next.
/// * Leads: if the machine has rules for them, the entries of a closed cut are those where its lead fits, and the seconds of
///   the lead are part of the entry. Nothing is left unfinished then, and pierce groups have no leads but
///   the one to where they are pierced, without pre-cuts.
/// * Fly cuts: if the machine cuts rows and grids on the run, the item of the first contour stands for all of them, and its nodes
///   are ways through them.
/// * Chains: where contours may be joined through waste, their nodes include places opposite each other, and links between nodes
///   say what a chain takes. A contour with links is entered at its nodes only. Where near cuts wait until they are cold, they have no chain between them.
/// * Edge starts: a contour near the edge of the sheet is also entered from there, without piercing. What begins on the kerfs of others, once they are
///   cut, and skeleton cuts that begin at the edge or on each other, have starts beside their nodes.
/// * Joints: a contour with micro-joints is entered where its leads are away from them, or at the end of one. It is not left
///   unfinished, and is pierced at rest.
/// * Cuts through bridges come after the cut around the connected parts, on whose kerf they begin: pairs of items, too.
/// * Sequences: pairs of items. Contours in a sequence are not left unfinished, and have at least the rank of those before them.
/// * Skipped contours: items without nodes.
/// * Groups: what a person keeps together, and the parts, if the sheet is cut part by part.
///
/// `paths`: the paths through each pierce group, as a solver of [`group_problems`](super::group_problems) finds them. The
/// contours of a group without a path are items of their own.
pub fn from_sheet(sheet: &Sheet, machine: &Profile, paths: &[Vec<SubPath>]) -> Problem {
    let planners = Planners::new(sheet, machine);
    let joined = PierceGroups::new(sheet, machine, planners.leads.as_ref(), paths);
    let mut pairs = pairs(sheet, &joined);
    let ranks = ranks(sheet, machine, &joined, &pairs);
    if sheet.part_by_part {
        pairs.extend(between_parts(sheet, &ranks, &pairs));
    }
    // In a pierce group, no contour has joints.
    let zones = tipping::zones(sheet, machine, |c| planners.joints(c).filter(|_| !joined.holds(c)));
    let avoided = zones.as_deref().filter(|z| PLANS_ALL_LEVERS && z.avoids());
    let flown = FlyGroups::new(sheet, machine, &planners, &ranks, avoided);
    let is_alone = |c| !joined.holds(c) && !flown.holds(c);
    let chained = Candidates::new(sheet, machine, &planners, is_alone);
    let starts = if PLANS_ALL_LEVERS { KerfStarts::new(sheet, machine, chained.as_ref()) } else { None };
    let mut items = Vec::with_capacity(sheet.contours.len());
    let mut nodes: Vec<Node> = Vec::new();
    let singles = Singles {
        sheet,
        machine,
        planners: &planners,
        joined: &joined,
        chained: chained.as_ref(),
        starts: starts.as_ref(),
        keeps_together: sheet.keeps_together(),
    };
    for ((contour, &rank), id) in sheet.contours.iter().zip(&ranks).zip(0..) {
        let together = joined.item(id, rank, &mut nodes);
        let together = together.or_else(|| flown.item(id, rank, joined.before(id), &mut nodes));
        items.push(match together {
            Some(item) => item,
            None if !contour.is_processed() => Item::default(),
            None => singles.item(id, contour, rank, &items, &mut nodes),
        });
    }
    let on_kerfs =
        starts.filter(|_| PLANS_ALL_LEVERS).map(|s| s.on_kerfs(&items, &nodes)).unwrap_or_default();
    let cooling = heat::cooling(sheet, machine);
    let chained = chained.filter(|_| PLANS_ALL_LEVERS);
    let links = chained.map_or_else(Links::default, |c| c.links(&items, &nodes, cooling.as_deref()));
    let starts = starts_of(sheet, machine, &items, &nodes, &links, on_kerfs);
    for item in items.iter_mut() {
        if item.nodes.clone().any(|n| links.touch(n) || !starts.of(n).is_empty()) {
            item.track = None;
        }
    }
    Problem {
        items,
        nodes,
        home: machine.home(),
        closed: machine.return_home,
        machine: machine.clone(),
        pairs,
        groups: groups(sheet),
        table: None,
        zones,
        cooling,
        links,
        starts,
    }
}

/// All starts: those on the kerfs of contours, and those of skeleton cuts.
fn starts_of(
    sheet: &Sheet,
    machine: &Profile,
    items: &[Item],
    nodes: &[Node],
    links: &Links,
    on_kerfs: Vec<(NodeId, Start)>,
) -> Starts {
    if !PLANS_ALL_LEVERS {
        return Starts::default();
    }
    let mut found = on_kerfs;
    found.extend(skeleton_starts(sheet, machine, items, nodes));
    let air = AirTime::head_down(machine);
    // The way to the start may be short enough for the head to stay down.
    let lifted = machine.levers.lift.map_or(0.0, |lift| 2.0 * machine.height_seconds(lift.height));
    let saved = |node: NodeId, start: &Start| {
        let node = nodes.get(node as usize)?;
        Some((node.item, air.seconds(start.from, node.entry) + lifted - start.seconds))
    };
    Starts::new(nodes.len(), found, saved, |item| links.saved(item))
}

/// The groups of a person, and the parts if the sheet is cut part by part. A part in a hole is within the part around it, any
/// other within its group.
fn groups(sheet: &Sheet) -> Groups {
    let mut of: Vec<Option<u32>> = sheet.contours.iter().map(|c| c.together).collect();
    let own = sheet.groups_together();
    let mut around = vec![None; own as usize];
    if !sheet.part_by_part {
        return if own > 0 { Groups::new(of, around) } else { Groups::default() };
    }
    for p in &sheet.parts {
        around.push(p.inside.map(|q| own + q).or_else(|| sheet.contours.get(p.outer as usize)?.together));
    }
    for (group, part) in of.iter_mut().zip(sheet.part_of()) {
        *group = part.map(|p| own + p).or(*group);
    }
    Groups::new(of, around)
}

/// The order that sequences ask for, and the cuts through bridges after the cut around the connected parts, between items.
fn pairs(sheet: &Sheet, joined: &PierceGroups) -> Vec<(ItemId, ItemId)> {
    let items = |(a, b): (u32, u32)| (joined.stands_for(a), joined.stands_for(b));
    let mut all = sheet.in_turn();
    if PLANS_ALL_LEVERS {
        all.extend(sheet.cut_apart());
    }
    let mut pairs: Vec<_> = all.into_iter().map(items).filter(|(a, b)| a != b).collect();
    sort_by(&mut pairs, |&(a, b)| [a.into(), b.into(), 0]);
    pairs.dedup();
    pairs
}

/// The rank of each contour: by pin, then by layer, then by pass, then marks before small holes before other cuts; never below the rank of anything
/// that comes before it by nesting or in a sequence.
fn ranks(sheet: &Sheet, machine: &Profile, joined: &PierceGroups, pairs: &[(ItemId, ItemId)]) -> Vec<u32> {
    let layers = 1 + sheet.layers.iter().map(|l| l.rank).max().unwrap_or(0);
    let passes = 1 + sheet.contours.iter().map(|c| c.pass).max().unwrap_or(0);
    let mut ranks: Vec<u32> = sheet
        .contours
        .iter()
        .map(|c| {
            let layer = sheet.layers.get(c.layer as usize).map_or(0, |l| l.rank);
            let kind = match c.operation {
                Operation::Cut if heat::is_small_hole(c, machine) => 1,
                Operation::Cut => 2,
                _ => 0,
            };
            3 * ((layers * c.pin as u32 + layer) * passes + c.pass) + kind
        })
        .collect();
    // The innermost come first, and earlier passes before later ones, so that a raised rank is passed on outwards.
    let mut inwards: Vec<usize> = (0..ranks.len()).collect();
    sort_by(&mut inwards, |&c| {
        [u64::MAX - u64::from(sheet.contours[c].depth), sheet.contours[c].pass.into(), 0]
    });
    loop {
        for &c in &inwards {
            let rank = ranks[c];
            if let Some(outer) = sheet.contours[c].inside.and_then(|o| ranks.get_mut(o as usize)) {
                *outer = rank.max(*outer);
            }
        }
        joined.raise(&mut ranks);
        let mut raised = false;
        for &(first, then) in pairs {
            let least = ranks[first as usize];
            raised |= ranks[then as usize] < least;
            ranks[then as usize] = ranks[then as usize].max(least);
        }
        if !raised {
            return ranks;
        }
    }
}
