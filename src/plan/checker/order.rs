//! Checks the order of contours: inner before outer, by layer, marks before small holes before other cuts, and sequences.

use super::groups::Groups;
use super::nesting;
use super::violation::Violation;
use super::visits::Visits;
use crate::machine::{PLANS_ALL_LEVERS, Profile};
use crate::order::sort_by;
use crate::sheet::{Contour, Operation, Pin, Sheet};

/// `visits` knows when each contour is cut. Within a pierce group, `groups.rs` follows element by element what is held.
pub(super) fn check(
    sheet: &Sheet,
    machine: &Profile,
    visits: &Visits,
    groups: &Groups,
    found: &mut Vec<Violation>,
) {
    // By pinning first, then by layer, then by pass, then marks, small holes, other cuts.
    let mut rank: Vec<(Pin, u32, u32, bool, bool)> = sheet
        .contours
        .iter()
        .map(|c| {
            let layer = sheet.layers.get(c.layer as usize).map_or(0, |l| l.rank);
            let cut = c.operation == Operation::Cut;
            (c.pin, layer, c.pass, cut, cut && !is_small_hole(c, machine))
        })
        .collect();
    let mut nested = nesting::pairs(sheet);
    // A cut through a bridge lies in the piece that it divides, and comes after the cut around that.
    let apart = if PLANS_ALL_LEVERS { apart(sheet) } else { Vec::new() };
    if PLANS_ALL_LEVERS {
        nested.retain(|&(inner, outer)| apart.binary_search(&(outer, inner)).is_err());
    }
    for &(inner, outer) in &nested {
        // What is left of an outline that shares sides with its group frees nothing by itself: `groups.rs` knows what does.
        let is_followed = groups.same(inner, outer)
            || groups.holds(outer) && sheet.contours.get(outer as usize).is_some_and(|c| !c.path.closed);
        if let (Some(inside), Some(around)) = (visits.ends(inner), visits.ends(outer))
            && around < inside
            && !is_followed
        {
            found.push(Violation::CutFree { outer, inner });
        }
    }
    let turns = turns(sheet);
    nested.extend(apart);
    // A hole that breaks through an edge does not lie inside the outline, but is cut before it all the same.
    nested.extend((0..).zip(&sheet.contours).filter_map(|(id, c)| Some((id, c.inside?))));
    raise(&turns, &nested, groups, &mut rank);
    in_turn(&turns, visits, found);

    let mut highest: Option<u32> = None;
    for &contour in &visits.order {
        match highest {
            Some(h) if rank[contour as usize] < rank[h as usize] => {
                found.push(Violation::Rank { earlier: h, later: contour });
            }
            _ => highest = Some(contour),
        }
    }
    if sheet.part_by_part {
        part_by_part(sheet, visits, &rank, found);
    }
    together(sheet, visits, &rank, found);
}

/// The cuts through bridges, each after the cut around the parts that it separates, in order.
fn apart(sheet: &Sheet) -> Vec<(u32, u32)> {
    let around = |outline: u32| sheet.contours.get(outline as usize).and_then(|c| c.bridged);
    let all = (0..).zip(&sheet.contours).filter_map(|(id, c)| Some((around(c.completes()?)?, id)));
    let mut all: Vec<(u32, u32)> = all.collect();
    sort_by(&mut all, |&(a, b)| [a.into(), b.into(), 0]);
    all
}

/// Whether a contour is a hole that comes before other cuts because it is small for the thickness of the plate.
fn is_small_hole(contour: &Contour, machine: &Profile) -> bool {
    let small = machine.levers.heat.filter(|_| PLANS_ALL_LEVERS).and_then(|heat| heat.small_holes);
    let size = contour.path.bounds().size();
    contour.path.closed
        && contour.depth % 2 == 1
        && small.is_some_and(|s| size.x.max(size.y) - s.ratio * s.thickness < 1e-6)
}

/// Checks that all contours of a part that have the same rank, including those inside its holes, are cut with nothing else
/// of that rank in between.
fn part_by_part<R: Copy + PartialEq>(sheet: &Sheet, visits: &Visits, rank: &[R], found: &mut Vec<Violation>) {
    let mut parts: Vec<Vec<u32>> = vec![Vec::new(); sheet.contours.len()];
    for (part, p) in (0..).zip(&sheet.parts) {
        for contour in p.holes.iter().chain([&p.outer]) {
            let around = |&k: &u32| sheet.parts.get(k as usize).and_then(|p| p.inside);
            parts[*contour as usize] = std::iter::successors(Some(part), around).collect();
        }
    }
    // What lies in a hole and is no part, such as an open cut, has to be cut before the hole.
    let in_hole =
        |c: &Contour| c.inside.and_then(|hole| parts.get(hole as usize)).cloned().unwrap_or_default();
    let held: Vec<_> = sheet.contours.iter().map(in_hole).collect();
    for (own, held) in parts.iter_mut().zip(held).filter(|(own, _)| own.is_empty()) {
        *own = held;
    }
    // An earlier pass over a contour belongs to the parts of the contour.
    let next = |&c: &u32| sheet.contours.get(c as usize).and_then(|c| c.next_pass);
    for pass in (0..).zip(&sheet.contours).filter(|(_, c)| c.next_pass.is_some()).map(|(id, _)| id) {
        if let Some(last) = std::iter::successors(Some(pass), next).last() {
            parts[pass as usize] = parts[last as usize].clone();
        }
    }
    // For each part, the position of its last contour so far among those of its rank.
    let mut last: Vec<Option<(usize, u32)>> = vec![None; sheet.parts.len()];
    for (k, &contour) in visits.order.iter().enumerate() {
        for &part in &parts[contour as usize] {
            let seen = last[part as usize].replace((k, contour));
            if let Some((before, earlier)) = seen
                && before + 1 != k
                && rank[earlier as usize] == rank[contour as usize]
            {
                found.push(Violation::Torn { part, contour });
            }
        }
    }
}

/// Checks that a group that a person keeps together is not left for a contour of the same rank outside it. A contour inside
/// another one belongs to its group.
fn together<R: Copy + PartialEq>(sheet: &Sheet, visits: &Visits, rank: &[R], found: &mut Vec<Violation>) {
    let group_of = |c: &u32| sheet.contours.get(*c as usize).and_then(|c| c.together);
    let groups = sheet.contours.iter().filter_map(|c| c.together).max().map_or(0, |last| last as usize + 1);
    // For each group, the ranks of the contours at which it was left.
    let mut left: Vec<Vec<R>> = vec![Vec::new(); groups];
    for pair in visits.order.windows(2) {
        let [before, now] = [pair[0], pair[1]];
        let entered = group_of(&now).filter(|g| Some(*g) != group_of(&before));
        if let Some(group) = group_of(&before).filter(|g| Some(*g) != group_of(&now)) {
            left[group as usize].push(rank[before as usize]);
        }
        if entered.is_some_and(|group| left[group as usize].contains(&rank[now as usize])) {
            found.push(Violation::Apart { contour: now });
        }
    }
}

/// A contour that has a turn, itself or inside another one: its sequence, its pass, its place, and its id.
type Turn = (u32, u32, u32, u32);

/// The contours that have a turn, in the order of the sequences.
fn turns(sheet: &Sheet) -> Vec<Turn> {
    let around = |&c: &u32| sheet.contours.get(c as usize).and_then(|c| c.inside).filter(|&o| o != c);
    let mut turns = Vec::new();
    for (id, contour) in (0..).zip(&sheet.contours).filter(|(_, c)| c.is_processed()) {
        let outwards = std::iter::successors(Some(id), around).take(sheet.contours.len());
        let mut own: Vec<Turn> = Vec::new();
        for (list, place) in outwards.filter_map(|c| sheet.contours.get(c as usize)?.turn) {
            // In each sequence the turn of the innermost contour counts.
            if own.iter().all(|t| t.0 != list) {
                own.push((list, contour.pass, place, id));
            }
        }
        turns.append(&mut own);
    }
    sort_by(&mut turns, |&(list, pass, place, id)| {
        [(u64::from(list) << 32) + u64::from(pass), place.into(), id.into()]
    });
    turns
}

/// The contours of each place of each sequence.
fn places(turns: &[Turn]) -> impl Iterator<Item = impl Iterator<Item = &[Turn]>> {
    let lists = turns.chunk_by(|a, b| (a.0, a.1) == (b.0, b.1));
    lists.map(|list| list.chunk_by(|a, b| a.2 == b.2))
}

/// Raises ranks: no contour of a sequence has a lower one than the contours before it, and none a lower one than what it waits for
/// because that lies inside it, whatever its layer. All contours of a pierce group have one rank, and wait for what lies inside any of them.
fn raise<R: Copy + Ord>(turns: &[Turn], nested: &[(u32, u32)], groups: &Groups, rank: &mut [R]) {
    loop {
        let before = rank.to_vec();
        for list in places(turns) {
            let mut highest = None;
            for place in list {
                for &(.., id) in place {
                    rank[id as usize] = highest.map_or(rank[id as usize], |h| rank[id as usize].max(h));
                }
                highest = highest.max(place.iter().map(|t| rank[t.3 as usize]).max());
            }
        }
        for &(inner, outer) in nested {
            let least = rank.get(inner as usize).copied();
            if let Some((rank, least)) = rank.get_mut(outer as usize).zip(least) {
                *rank = least.max(*rank);
            }
        }
        for group in groups.each() {
            let all = group.contours.iter().chain(&group.inside);
            if let Some(highest) = all.map(|&c| rank[c as usize]).max() {
                group.contours.iter().for_each(|&c| rank[c as usize] = highest);
            }
        }
        if before == rank {
            return;
        }
    }
}

/// Checks that every contour of a sequence begins after all before it have ended.
fn in_turn(turns: &[Turn], visits: &Visits, found: &mut Vec<Violation>) {
    for list in places(turns) {
        let mut done: Option<(usize, u32)> = None;
        for place in list {
            for &(.., later) in place {
                if let (Some(begin), Some((end, earlier))) = (visits.begins(later), done)
                    && begin < end
                    && later != earlier
                {
                    found.push(Violation::Rank { earlier: later, later: earlier });
                }
            }
            done = done.max(place.iter().filter_map(|t| Some((visits.ends(t.3)?, t.3))).max());
        }
    }
}
