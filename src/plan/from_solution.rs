//! Converts a solution to moves of the head: air, pierce, cut, and so on, then home.

use super::cooled::cooled;
use super::evaluate::evaluate;
use super::model::{Leads, Move, Plan, Turn};
use super::past_tipped::past_tipped;
use crate::corner::{Corner, turned};
use crate::geometry::{DVec2, Path, Segment};
use crate::joint::{ContourJoints, Divided, Stretch, divided};
use crate::lead::{Lead, Run, starts_moving};
use crate::machine::{JointKind, PLANS_ALL_LEVERS, Process, Profile};
use crate::problem::{Item, NodeId, Problem, Stroke, begins_on_kerf};
use crate::sheet::{Sheet, Strip};
use crate::solve::{Begun, Solution, Stop, begun};

/// The plan of a solution. `solution` must belong to `problem`, and `problem` to `sheet`.
///
/// Cuts are pierced in every pass; marks are not. A contour that is left unfinished gets a pre-cut where it is left, if
/// the machine charges for pre-cuts, and is resumed without piercing; so is a pierce group. A cut pauses in sharp corners, and
/// is interrupted by micro-joints. There is no air move if the head
/// is already in place. Between nodes with a link there is a chain or an edge start instead, and no piercing. Each cut begins in the quickest way that there is,
/// which may be on a kerf that was cut before; cuts through bridges begin on that of the cut around the connected parts.
pub fn from_solution(sheet: &Sheet, problem: &Problem, solution: &Solution) -> Plan {
    let mut moves = Vec::with_capacity(3 * solution.stops.len() + 1);
    let mut head = problem.home;
    let pre_cuts = problem.machine.charges_for_pre_cuts();
    // For each contour, the place where it was begun.
    let mut begun_at: Vec<Option<f64>> = vec![None; sheet.contours.len()];
    let mut last: Option<NodeId> = None;
    let starts = begun(problem, &solution.stops);
    for (k, stop) in solution.stops.iter().enumerate() {
        let Some(node) = problem.nodes.get(stop.node as usize) else { continue };
        let contour = node.item;
        let before = last.replace(stop.node);
        let how = starts.get(k).copied().filter(|_| PLANS_ALL_LEVERS);
        let begins = how.and_then(Begun::start);
        let link = before.and_then(|before| problem.links.between(before, stop.node));
        let link = link.filter(|_| how.is_none_or(|how| how == Begun::Linked));
        let Some(known) = sheet.contours.get(contour as usize) else { continue };
        if let Some(path) = problem.items.get(contour as usize).and_then(|i| i.path(stop.node)) {
            if let Some((from, to)) = stop.ends(problem) {
                go(&mut moves, &mut head, from);
                let lead = path.lead_in.filter(|_| stop.along == 0.0);
                through(&mut moves, &problem.machine, from, lead, &path.stretch(stop.along, stop.until));
                head = to;
            }
            continue;
        }
        let item = problem.items.get(contour as usize);
        if let Some((lead, joints)) = item.and_then(|i| with_joints(i, stop)) {
            let cut = divided(lead, &known.path, stop.along, &joints.joints);
            let Some(entry) = cut.stretches.first().and_then(|s| s.path.first()).map(Segment::start) else {
                continue;
            };
            go(&mut moves, &mut head, entry);
            let corners = item.map(|i| i.turns(stop.node)).unwrap_or_default();
            let flying = joints.kind == JointKind::Flying;
            over_joints(&mut moves, &problem.machine, contour, cut, flying, corners);
            head = moves.iter().rev().find_map(end_of_cut).unwrap_or(entry);
            continue;
        }
        let lead = item.and_then(|i| i.lead(stop.node)).map(|l| l.0);
        let approach = lead.and_then(|lead| lead.approach).filter(|_| PLANS_ALL_LEVERS);
        if let Some(begins) = begins.filter(|_| known.skeleton) {
            skeleton_cut(&mut moves, &mut head, (stop.node, begins.from), problem);
            continue;
        }
        let (path, leads) = match lead.filter(|lead| approach.is_none() || !lead.is_bare()) {
            Some(lead) => with_leads(lead, &known.path, stop.along),
            None => (path_of(&known.path, stop, node.reversed), Leads::default()),
        };
        let (Some(start), Some(end)) = (path.first(), path.last()) else { continue };
        let (entry, exit) = (start.start(), end.end());
        let (path, turns) = with_turns(path, leads, item.map(|i| i.turns(stop.node)).unwrap_or_default());
        if let Some(link) = link {
            link.via.iter().for_each(|&via| go(&mut moves, &mut head, via));
            moves.push(Move::Chain { path: vec![Segment::line(head, entry)] });
        } else if let Some(approach) = approach {
            go(&mut moves, &mut head, approach.start());
            moves.push(Move::Chain { path: vec![approach] });
        } else if let Some(begins) = begins {
            go(&mut moves, &mut head, begins.from);
            moves.push(Move::Chain { path: vec![Segment::line(begins.from, entry)] });
        } else {
            go(&mut moves, &mut head, entry);
        }
        let resumed = begun_at[contour as usize].is_some();
        let passes = sheet.passes_at_once(known, &problem.machine);
        let moving =
            item.is_none_or(|i| i.joints.is_none()) && starts_moving(sheet, &problem.machine, known, lead);
        let on_kerf = PLANS_ALL_LEVERS && begins_on_kerf(sheet, &problem.machine, &problem.items, known);
        let start = match (moving, known.is_mark()) {
            _ if on_kerf => None,
            _ if resumed || link.is_some() || approach.is_some() || begins.is_some() => None,
            (true, _) => Some(Move::MovingStart),
            (false, true) => None,
            (false, false) => Some(Move::Pierce),
        };
        let mut lowered = false;
        for pass in 0..passes {
            lowered |= lower(&mut moves, known.pass + pass, &sheet.process_of(known, &problem.machine));
            // An open contour is run there and back.
            let back = !known.path.closed && !pass.is_multiple_of(2);
            let path = if back { Path::new(path.clone(), false).reversed().segments } else { path.clone() };
            moves.extend(start.clone());
            run(&mut moves, &problem.machine, contour, path, (leads, &turns), known.is_mark());
        }
        if lowered {
            moves.push(Move::Height { z: 0.0 });
        }
        head = if !known.path.closed && passes.is_multiple_of(2) { entry } else { exit };
        let start = *begun_at[contour as usize].get_or_insert(stop.along);
        #[expect(clippy::float_cmp, reason = "the last visit ends where the first began, bit for bit")]
        let left = stop.until != start;
        if left && pre_cuts {
            let rest = Path::new(known.path.between(stop.until, start), false);
            let ahead = problem.machine.cut_ahead(&rest);
            moves.push(Move::PreCut { contour, to: head, ahead });
        }
    }
    if problem.closed {
        go(&mut moves, &mut head, problem.home);
    }
    let moves = match &problem.zones {
        Some(zones) if PLANS_ALL_LEVERS => past_tipped(zones, &problem.machine, moves),
        _ => moves,
    };
    let (mut moves, hot_pairs) = match problem.cooling() {
        Some(cooling) => cooled(cooling, sheet, &problem.machine, moves),
        None => (moves, 0),
    };
    let bridges: Vec<Strip> = if PLANS_ALL_LEVERS {
        name_bridged(&mut moves, sheet);
        sheet.bridged.iter().flat_map(|b| &b.strips).copied().collect()
    } else {
        Vec::new()
    };
    let mut summary = evaluate(&moves, sheet, &problem.machine);
    summary.joints = joints_of(problem);
    summary.hot_pairs = hot_pairs;
    summary.bridges = u32::try_from(bridges.len()).unwrap_or(u32::MAX);
    summary.parts = u32::try_from(sheet.parts.len()).unwrap_or(u32::MAX);
    Plan { moves, summary, bridges }
}

/// Names the outlines of connected parts in each cut that goes around them.
fn name_bridged(moves: &mut [Move], sheet: &Sheet) {
    for step in moves {
        let Move::Cut { contour, with, .. } = step else { continue };
        let around = sheet.contours.get(*contour as usize).filter(|c| c.path.closed);
        let Some(root) = around.and_then(|c| c.bridged) else { continue };
        let group = sheet.bridged.binary_search_by_key(&root, |b| b.contour).ok();
        let group = group.and_then(|k| sheet.bridged.get(k));
        let outlines = group.iter().flat_map(|b| &b.outlines).map(|o| o.0);
        with.extend(outlines.filter(|&id| id != root));
    }
}

/// A skeleton cut that begins without piercing at a place: at its end, or on another one that it crosses, from where it is cut to both ends.
fn skeleton_cut(moves: &mut Vec<Move>, head: &mut DVec2, (node, from): (NodeId, DVec2), problem: &Problem) {
    let Some(node) = problem.nodes.get(node as usize) else { return };
    let ends = [node.entry, node.exit];
    for &to in ends.iter().filter(|&&to| to != from) {
        go(moves, head, from);
        let (path, leads) = (vec![Segment::line(from, to)], Leads::default());
        moves.push(Move::Cut {
            contour: node.item,
            with: Vec::new(),
            path,
            mark: false,
            leads,
            turns: Vec::new(),
        });
        *head = to;
    }
}

/// Lowers the head for a pass, if the process asks for it; returns whether it did.
fn lower(moves: &mut Vec<Move>, pass: u32, process: &Process) -> bool {
    let z = 0.0 - f64::from(pass) * process.z_step;
    if z < 0.0 {
        moves.push(Move::Height { z });
    }
    z < 0.0
}

/// One pass over a contour, or a stretch of it, after the beam's start.
fn run(
    moves: &mut Vec<Move>,
    machine: &Profile,
    contour: u32,
    path: Vec<Segment>,
    (leads, turns): (Leads, &[Turn]),
    mark: bool,
) {
    if mark {
        moves.push(Move::Cut { contour, with: Vec::new(), path, mark, leads, turns: Vec::new() });
        return;
    }
    cut(moves, machine, &path, (leads, turns), |_| contour);
}

/// The elements of a cut with the corners that are cut in loops or rounded: all that may be, and which of them are.
fn with_turns(
    path: Vec<Segment>,
    leads: Leads,
    (corners, chosen): (&[Corner], &[usize]),
) -> (Vec<Segment>, Vec<Turn>) {
    if !PLANS_ALL_LEVERS || chosen.is_empty() {
        return (path, Vec::new());
    }
    let on = leads.lead_in..path.len().saturating_sub(leads.overcut + leads.lead_out);
    let (path, made) = turned(&path, on, corners, chosen);
    let turns = made.into_iter().filter_map(|made| {
        let corner = corners.get(made.corner)?;
        Some(Turn { kind: corner.kind, at: corner.at, first: made.first, count: made.count })
    });
    (path, turns.collect())
}

/// The lead and the joints of a visit of a contour that has joints.
fn with_joints<'p>(item: &'p Item, stop: &Stop) -> Option<(&'p Lead, &'p ContourJoints)> {
    let joints = item.joints.as_deref().filter(|j| !j.joints.is_empty())?;
    Some((item.lead(stop.node)?.0, joints))
}

/// Number of joints of all contours.
fn joints_of(problem: &Problem) -> u32 {
    let joints = problem.items.iter().filter_map(|i| i.joints.as_ref());
    u32::try_from(joints.map(|j| j.joints.len()).sum::<usize>()).unwrap_or(u32::MAX)
}

/// The stretches of a contour with joints, from its entry on.
fn over_joints(
    moves: &mut Vec<Move>,
    machine: &Profile,
    contour: u32,
    divided: Divided,
    flying: bool,
    corners: (&[Corner], &[usize]),
) {
    let mut joints = divided.joints.into_iter();
    for (k, stretch) in divided.stretches.into_iter().enumerate() {
        if k == 0 || !flying {
            moves.push(Move::Pierce);
        }
        let Stretch { path, lead_in, overcut, lead_out } = stretch;
        let leads = Leads { lead_in, overcut, lead_out };
        let (path, turns) = with_turns(path, leads, corners);
        cut(moves, machine, &path, (leads, &turns), |_| contour);
        if let Some(path) = joints.next() {
            moves.push(Move::Joint { contour, path, flying });
        }
    }
}

fn end_of_cut(step: &Move) -> Option<DVec2> {
    if let Move::Cut { path, .. } = step { path.last().map(Segment::end) } else { None }
}

/// The moves of a visit of a pierce group or of contours that are cut on the run, which begins at `head`, with a lead to the first cut if
/// there is one.
fn through(
    moves: &mut Vec<Move>,
    machine: &Profile,
    mut head: DVec2,
    mut lead: Option<Segment>,
    strokes: &[Stroke],
) {
    for stroke in strokes {
        match stroke {
            Stroke::Air(to) => go(moves, &mut head, *to),
            Stroke::Pierce => moves.push(Move::Pierce),
            Stroke::MovingStart => moves.push(Move::MovingStart),
            Stroke::Fly(path) => {
                moves.push(Move::Fly { path: path.clone() });
                head = path.last().map_or(head, Segment::end);
            }
            Stroke::PreCut { contour, ahead } => {
                moves.push(Move::PreCut { contour: *contour, to: head, ahead: ahead.clone() });
            }
            Stroke::Cut { spans, path, overcut } => {
                let whose = spans.iter().flat_map(|s| std::iter::repeat_n(s.contour, s.elements));
                let whose: Vec<u32> = whose.collect();
                let path: Vec<Segment> = lead.take().into_iter().chain(path.iter().copied()).collect();
                let lead_in = path.len() - (whose.len() + overcut).min(path.len());
                let leads = Leads { lead_in, overcut: *overcut, ..Leads::default() };
                cut(moves, machine, &path, (leads, &[]), |element| {
                    whose.get(element.saturating_sub(lead_in)).or(whose.last()).copied().unwrap_or_default()
                });
                head = path.last().map_or(head, Segment::end);
            }
        }
    }
}

/// Cuts along elements, with a macro in each sharp corner. `whose` gives the contour of each element.
fn cut(
    moves: &mut Vec<Move>,
    machine: &Profile,
    path: &[Segment],
    (leads, turns): (Leads, &[Turn]),
    whose: impl Fn(usize) -> u32,
) {
    let mut done = 0;
    for run in machine.runs(path) {
        let Some(first) = run.first() else { continue };
        if done > 0 {
            moves.push(Move::Macro { contour: whose(done - 1), at: first.start() });
        }
        let (contour, mut with) = (whose(done), Vec::new());
        for other in (done..done + run.len()).map(&whose) {
            if other != contour && !with.contains(&other) {
                with.push(other);
            }
        }
        let leads = leads.of_stretch(done, run.len(), path.len());
        let here = |turn: &&Turn| (done..done + run.len()).contains(&turn.first);
        let turns =
            turns.iter().filter(here).map(|turn| Turn { first: turn.first - done, ..*turn }).collect();
        moves.push(Move::Cut { contour, with, path: run.to_vec(), mark: false, leads, turns });
        done += run.len();
    }
}

fn go(moves: &mut Vec<Move>, head: &mut DVec2, to: DVec2) {
    if *head != to {
        moves.push(Move::air(to));
        *head = to;
    }
}

/// The elements of a cut with its leads.
fn with_leads(lead: &Lead, contour: &Path, along: f64) -> (Vec<Segment>, Leads) {
    let Run { path, lead_in, overcut, lead_out } = lead.run(contour, along);
    (path, Leads { lead_in, overcut, lead_out })
}

/// The elements of a visit. A visit of a whole contour may run against its direction.
fn path_of(path: &Path, stop: &Stop, reversed: bool) -> Vec<Segment> {
    if !stop.is_whole() {
        return path.between(stop.along, stop.until);
    }
    let from_entry = path.starting_at(stop.along);
    if reversed { from_entry.reversed().segments } else { from_entry.segments }
}
