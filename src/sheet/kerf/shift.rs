//! Shifts of whole parts that bring them one kerf from a neighbour, so that one line between them cuts both (`levers.common_cuts`).
//!
//! Each part stays, or moves across a straight side that faces one of a neighbour until they are one kerf apart, and from there once more in a
//! direction that is square to the first: at most by the distance that the machine states from where it is drawn. It never comes nearer
//! than a kerf to anything: neither to other parts, where they are by then, nor to marks and open cuts beside it. What lies in a part
//! moves with it.
//!
//! Parts that can meet are chosen together, by a beam search: one part after the other, from the upper right on and again from the lower left
//! on, keeping the choices by which the most length is one kerf apart, and of these the ones that move the least.

use super::super::model::Sheet;
use super::facing::{Moved, PARALLEL, Parts, ROUNDING};
use crate::geometry::{Affine, DVec2, Union};
use crate::order::{real, sort_by};

/// Most choices that are kept after each part of those that can meet. Wider finds more, and takes longer
/// (`cargo test --features png --test it kerf::shift_choice`).
const WIDEST: usize = 128;
/// Bounds the work for many parts that can meet: their number times the choices kept.
const WORK: usize = 2_000;
/// How often the parts are placed again.
const PASSES: usize = 6;
/// Lengths that differ by less are the same, mm.
const SAME_LENGTH: f64 = 1e-3;

/// A part that would stand one kerf from a neighbour.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Shift {
    /// Its outer contour.
    pub(crate) contour: u32,
    /// By how much it is moved, mm.
    pub(crate) by: DVec2,
}

/// A choice for the parts so far.
#[derive(Clone, Default)]
struct Choice {
    /// By part: how far it is moved.
    by: Vec<DVec2>,
    /// How much longer than in the drawing the sides one kerf apart are, mm.
    gain: f64,
    /// Sum of the distances by which parts are moved, mm.
    moved: f64,
}

/// The shifts, each of at most `most` mm, that bring parts `width` mm from a neighbour; distances that differ by up to `same` mm are one.
pub(crate) fn shifts(sheet: &Sheet, width: f64, most: f64, same: f64) -> Vec<Shift> {
    let parts = Parts::new(sheet, width, most, same);
    let mut order: Vec<(u32, DVec2)> = (0..)
        .zip(&sheet.contours)
        .filter(|(id, _)| parts.is_part(*id))
        .map(|(id, c)| (id, c.bounds.min))
        .collect();
    sort_by(&mut order, |(id, low)| [real(low.x + low.y), (*id).into(), 0]);
    let mut found = Vec::new();
    let mut slots = vec![None; sheet.contours.len()];
    for group in groups(&parts, &order, sheet.contours.len()) {
        let by = chosen(&parts, &group, &mut slots);
        let shifts = group.into_iter().zip(by).map(|(contour, by)| Shift { contour, by });
        found.extend(shifts.filter(|s| s.by != DVec2::ZERO));
    }
    found
}

/// The parts that can meet, in their order, group by group.
fn groups(parts: &Parts<'_>, order: &[(u32, DVec2)], count: usize) -> Vec<Vec<u32>> {
    let mut together = Union::new(count);
    for &(id, _) in order {
        for other in parts.near(id).into_iter().filter(|&other| parts.is_part(other)) {
            together.join(id, other);
        }
    }
    let of = together.numbered();
    let mut groups = vec![Vec::new(); count];
    for &(id, _) in order {
        if let Some(group) = of.get(id as usize).and_then(|&k| groups.get_mut(k as usize)) {
            group.push(id);
        }
    }
    groups.retain(|group| group.len() > 1);
    groups
}

/// How far each part of a group is moved. `slots`: room for the place of each part in its group, by contour; nothing is in it before and after.
fn chosen(parts: &Parts<'_>, group: &[u32], slots: &mut [Option<u32>]) -> Vec<DVec2> {
    for (slot, &id) in (0..).zip(group) {
        if let Some(place) = slots.get_mut(id as usize) {
            *place = Some(slot);
        }
    }
    let upwards: Vec<(usize, u32)> = group.iter().copied().enumerate().collect();
    let downwards: Vec<(usize, u32)> = upwards.iter().rev().copied().collect();
    let mut best = Vec::new();
    // Of equal choices the one that is found first stays: from the upper right on, where the parts at the lower left stay.
    for orders in [[&downwards, &upwards], [&upwards, &downwards]] {
        let mut choice = Choice { by: vec![DVec2::ZERO; group.len()], ..Choice::default() };
        for (pass, order) in orders.into_iter().cycle().take(PASSES).enumerate() {
            let Some(next) = search(parts, order, slots, choice.clone(), pass == 0) else { break };
            let is_better = next.gain > choice.gain + SAME_LENGTH;
            choice = next;
            if !is_better {
                break;
            }
        }
        best.push(choice);
    }
    for &id in group {
        slots[id as usize] = None;
    }
    best_first(&mut best, |c| (c.gain, c.moved));
    best.into_iter().next().map(|c| c.by).unwrap_or_default()
}

/// The choice by which the most length is one kerf apart, of those that are kept when parts are placed again in this order. `may_follow`: a part
/// that is not placed yet is in no one's way, because it may still move out of it.
fn search(
    parts: &Parts<'_>,
    order: &[(usize, u32)],
    slots: &[Option<u32>],
    first: Choice,
    may_follow: bool,
) -> Option<Choice> {
    let kept = (WORK / order.len()).clamp(1, WIDEST);
    let mut beam = vec![first];
    // Whether each part of the group may still move out of the way.
    let mut left = vec![may_follow; order.len()];
    let slot_of = |part: u32| slots.get(part as usize).copied().flatten();
    for &(slot, id) in order {
        let near = parts.near(id);
        let mut in_way = near.clone();
        in_way.retain(|&other| {
            let slot = parts.root(other).and_then(slot_of);
            slot.is_none_or(|slot| left.get(slot as usize) != Some(&true))
        });
        if let Some(is_left) = left.get_mut(slot) {
            *is_left = false;
        }
        let mut next: Vec<(usize, DVec2, f64, f64)> = Vec::new();
        for (from, choice) in beam.iter().enumerate() {
            let moved = Moved { slots, by: &choice.by };
            let shared = |by| parts.shared(&parts.facing(id, by, &near, &moved));
            let before = choice.by.get(slot).copied().unwrap_or_default();
            let (gain, way) = (choice.gain - shared(before), choice.moved - before.length());
            for by in places(parts, id, before, [&near, &in_way], &moved) {
                next.push((from, by, gain + shared(by), way + by.length()));
            }
        }
        best_first(&mut next, |(_, _, gain, moved)| (*gain, *moved));
        next.truncate(kept);
        let with = |(from, by, gain, moved): (usize, DVec2, f64, f64)| {
            let mut choice = beam.get(from)?.clone();
            *choice.by.get_mut(slot)? = by;
            Some(Choice { gain, moved, ..choice })
        };
        beam = next.into_iter().filter_map(with).collect();
    }
    beam.into_iter().next()
}

/// The greatest gain first, and the least movement among equal ones.
fn best_first<T>(items: &mut Vec<T>, of: impl Fn(&T) -> (f64, f64)) {
    sort_by(items, |item| {
        let (gain, moved) = of(item);
        [real(-(gain / SAME_LENGTH).round()), real(moved), 0]
    });
}

/// Where a part may stand, as distances from where it is drawn: where it is, where it is drawn, and one kerf from one or two neighbours.
fn places(
    parts: &Parts<'_>,
    id: u32,
    now: DVec2,
    [near, in_way]: [&[u32]; 2],
    moved: &Moved<'_>,
) -> Vec<DVec2> {
    let mut places: Vec<DVec2> = Vec::new();
    // Where nothing has moved, parts may be as near as they are drawn.
    let (mut moved_ones, as_it_is) = (in_way.to_vec(), now == DVec2::ZERO);
    moved_ones.retain(|&other| !as_it_is || parts.by(other, moved) != DVec2::ZERO);
    if parts.is_clear(id, now, &moved_ones, moved) {
        places.push(now);
    }
    let add = |to: DVec2, places: &mut Vec<DVec2>| {
        let is_new = to != now && places.iter().all(|p| (*p - to).length() > ROUNDING);
        if is_new && parts.is_clear(id, to, in_way, moved) {
            places.push(to);
        }
    };
    add(DVec2::ZERO, &mut places);
    let onwards = |from: DVec2| {
        // Away only from a part that has come too near: those that are drawn so stay.
        let facing = parts.facing(id, from, near, moved).into_iter();
        let facing = facing.filter(|f| f.way > parts.same || f.is_moved && f.way < -parts.same);
        let within = move |to: &(DVec2, DVec2)| to.0.length() <= parts.most + ROUNDING;
        facing.map(move |f| (from + f.normal * f.way, f.normal)).filter(within)
    };
    for (first, normal) in onwards(DVec2::ZERO) {
        let second = onwards(first).filter(|(_, n)| n.dot(normal).abs() < PARALLEL).map(|(to, _)| to);
        for to in [first].into_iter().chain(second) {
            add(to, &mut places);
        }
    }
    places
}

impl Sheet {
    /// The sheet with parts moved.
    pub(crate) fn shifted(&self, shifts: &[Shift]) -> Self {
        let mut sheet = self.clone();
        let up = |c: &u32| self.contours.get(*c as usize).and_then(|c| c.inside).filter(|o| o != c);
        let mut by = vec![None; self.contours.len()];
        for shift in shifts {
            if let Some(by) = by.get_mut(shift.contour as usize) {
                *by = Some(shift.by);
            }
        }
        for (id, contour) in (0..).zip(&mut sheet.contours) {
            let around = std::iter::successors(Some(id), up).take(self.contours.len());
            let Some(by) = around.last().and_then(|root| by.get(root as usize).copied().flatten()) else {
                continue;
            };
            let moved = Affine::translation(by);
            contour.path = moved.path(&contour.path, 0.0);
            contour.outline = contour.outline.as_ref().map(|o| moved.path(o, 0.0));
            contour.bounds = contour.path.bounds();
        }
        sheet
    }
}
