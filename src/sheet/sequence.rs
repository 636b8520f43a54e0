//! Contours that a person has put in an order. A contour takes its turn together with everything inside it.

use super::model::{Contour, Sheet};
use crate::order::sort_by;
use std::iter::successors;

/// Gives the contours of the sequences their turns: the number of the sequence and the place in it.
pub(super) fn assign(contours: &mut [Contour], sequences: &[Vec<u32>]) {
    for (list, sequence) in (0..).zip(sequences) {
        for (place, &id) in (0..).zip(sequence) {
            if let Some(contour) = contours.get_mut(id as usize) {
                contour.turn = Some((list, place));
            }
        }
    }
}

/// A contour and those around it, from the inside outwards.
fn outwards(contours: &[Contour], contour: u32) -> impl Iterator<Item = u32> + '_ {
    let inside = |&c: &u32| contours.get(c as usize).and_then(|c| c.inside).filter(|&o| o != c);
    successors(Some(contour), inside).take(contours.len())
}

/// Whether a contour, or one around it, is part of a sequence.
pub(super) fn has_turn(contours: &[Contour], contour: &Contour) -> bool {
    contour.turn.is_some()
        || contour.inside.is_some_and(|o| {
            outwards(contours, o).any(|c| contours.get(c as usize).is_some_and(|c| c.turn.is_some()))
        })
}

impl Sheet {
    /// The sequences in which a contour has its turn, itself or inside another one.
    pub(super) fn sequences_of(&self, contour: u32) -> impl Iterator<Item = u32> {
        outwards(&self.contours, contour).filter_map(|c| Some(self.contours.get(c as usize)?.turn?.0))
    }

    /// Whether a contour, or one around it, is part of a sequence.
    pub(crate) fn has_turn(&self, contour: &Contour) -> bool {
        has_turn(&self.contours, contour)
    }

    /// Pairs of contours of which the first is finished before the second begins, from the sequences. Passes that are run
    /// sheet by sheet have the order of the sequence each.
    pub(crate) fn in_turn(&self) -> Vec<(u32, u32)> {
        let contours = &self.contours;
        let turn = |c: u32| contours.get(c as usize).filter(|c| c.is_processed()).and_then(|c| c.turn);
        let pass = |c: u32| contours.get(c as usize).map(|c| c.pass);
        let mut turns: Vec<((u32, u32), u32)> =
            (0..).take(contours.len()).filter_map(|c| Some((turn(c)?, c))).collect();
        sort_by(&mut turns, |&((list, place), c)| [list.into(), place.into(), c.into()]);
        let mut pairs = Vec::new();
        for then in (0..).take(contours.len()).filter(|_| !turns.is_empty()) {
            if contours.get(then as usize).is_none_or(|c| !c.is_processed()) {
                continue;
            }
            let mut known = Vec::new();
            for (list, place) in outwards(contours, then).filter_map(turn) {
                // In each sequence the turn of the innermost contour counts.
                if known.contains(&list) {
                    continue;
                }
                known.push(list);
                let end = turns.partition_point(|t| t.0 < (list, place));
                let before = turns.get(..end).and_then(|t| t.last()).map(|t| t.0).filter(|t| t.0 == list);
                let first = turns.iter().take(end).rev().take_while(|t| Some(t.0) == before).map(|t| t.1);
                // What lies around a contour comes after it in any case.
                let around = |&c: &u32| outwards(contours, c).any(|o| o == then);
                pairs.extend(
                    first.filter(|&c| pass(c) == pass(then)).filter(|c| !around(c)).map(|c| (c, then)),
                );
            }
        }
        sort_by(&mut pairs, |&(a, b)| [a.into(), b.into(), 0]);
        pairs.dedup();
        pairs
    }

    /// A contour that would have to come before itself, because sequences contradict each other, the nesting, or the parts that
    /// are cut one after the other.
    pub(crate) fn contradiction(&self) -> Option<u32> {
        let mut pairs = self.in_turn();
        if pairs.is_empty() {
            return None;
        }
        if self.part_by_part {
            pairs = self.between_parts(&pairs);
        }
        // The contours, and the beginnings of parts.
        let count = self.contours.len() + self.parts.len();
        let mut after: Vec<Vec<u32>> = vec![Vec::new(); count];
        let mut waits_for = vec![0_usize; count];
        let nested = (0..).zip(&self.contours).filter_map(|(c, contour)| Some((c, contour.inside?)));
        for (first, then) in nested.chain(pairs) {
            if let (Some(list), Some(count)) =
                (after.get_mut(first as usize), waits_for.get_mut(then as usize))
            {
                list.push(then);
                *count += 1;
            }
        }
        let mut free: Vec<u32> =
            (0..).zip(&waits_for).filter(|(_, n)| **n == 0).map(|(contour, _)| contour).collect();
        while let Some(done) = free.pop() {
            for then in after.get(done as usize).into_iter().flatten() {
                if let Some(count) = waits_for.get_mut(*then as usize) {
                    *count -= 1;
                    if *count == 0 {
                        free.push(*then);
                    }
                }
            }
        }
        (0..).zip(&waits_for).take(self.contours.len()).find(|(_, n)| **n > 0).map(|(contour, _)| contour)
    }

    /// What waits for what where each part is cut without any other contour in between: if a contour waits for one of another
    /// part, the whole of its part waits for the outline there, which is cut last. Beginnings of parts have the numbers after
    /// those of contours.
    fn between_parts(&self, pairs: &[(u32, u32)]) -> Vec<(u32, u32)> {
        let of = self.part_of();
        let begin = |p: u32| u32::try_from(self.contours.len()).unwrap_or(u32::MAX).saturating_add(p);
        let outline = |p: u32| Some(self.parts.get(p as usize)?.outer);
        let mut all: Vec<(u32, u32)> =
            (0..).zip(&of).filter_map(|(contour, of)| Some((begin((*of)?), contour))).collect();
        all.extend((0..).zip(&self.parts).filter_map(|(p, known)| Some((begin(known.inside?), begin(p)))));
        for &(first, then) in pairs {
            let [before, after] = [(first, then), (then, first)].map(|(a, b)| self.part_without(&of, a, b));
            all.push((before.and_then(outline).unwrap_or(first), after.map_or(then, begin)));
        }
        all
    }
}
