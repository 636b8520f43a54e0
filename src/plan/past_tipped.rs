//! Finds for each air move of a plan its way past the pieces that may have tipped by then.

use super::air::AirMoves;
use super::model::{Move, Way};
use crate::geometry::DVec2;
use crate::machine::Profile;
use crate::tipping::{LegWay, Piece, Zones};

/// The same moves, each air move straight, around or lifted as takes the fewest seconds. Where risky moves are ignored, those
/// that cross a piece with the head down are only marked.
pub(super) fn past_tipped(zones: &Zones, machine: &Profile, moves: Vec<Move>) -> Vec<Move> {
    let air = AirMoves::new(machine);
    let last = last_cuts(&moves);
    let mut out = Vec::with_capacity(moves.len());
    let mut head = machine.home();
    for (index, step) in moves.into_iter().enumerate() {
        let from = head;
        head = step.end().unwrap_or(head);
        let Move::Air { to, way } = step else {
            out.push(step);
            continue;
        };
        let cut = |c: &u32| last.get(*c as usize).is_some_and(|last| last.is_some_and(|l| l < index));
        let is_free = |piece: &Piece| piece.cut_by.iter().all(cut);
        if air.is_lifted(from, to, way) {
            out.push(step);
            continue;
        }
        match zones.leg(from, to, is_free).way {
            LegWay::Straight => out.push(step),
            LegWay::Crosses => out.push(Move::Air { to, way: Way::Crosses }),
            LegWay::Lifted => out.push(Move::Air { to, way: Way::Lifted }),
            LegWay::Around(places) => {
                let around = |to: DVec2| Move::Air { to, way: Way::Around };
                out.extend(places.into_iter().map(around));
                out.push(step);
            }
        }
    }
    out
}

/// By contour: the index of the last move that cuts it.
fn last_cuts(moves: &[Move]) -> Vec<Option<usize>> {
    let mut last: Vec<Option<usize>> = Vec::new();
    for (index, step) in moves.iter().enumerate() {
        let Move::Cut { contour, with, .. } = step else { continue };
        for &id in with.iter().chain([contour]) {
            if last.len() <= id as usize {
                last.resize(id as usize + 1, None);
            }
            if let Some(last) = last.get_mut(id as usize) {
                *last = Some(index);
            }
        }
    }
    last
}
