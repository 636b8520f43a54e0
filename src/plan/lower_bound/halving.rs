//! Which pieces of contours to halve, and what becomes of their knots.

use super::net::Item;
use crate::geometry::DVec2;
use crate::order::{real, sort_by};

/// Share of all lost seconds at the knots beside which pieces are halved: the rest costs more time than it gains.
const SHARE: f64 = 0.9;

/// Marks the pieces beside the knots with the largest losses; `None` if nothing is lost, or only beside pieces
/// that are too short. `lost`: the seconds lost at each knot.
pub(super) fn marks(items: &[Item], lost: &[Vec<f64>]) -> Option<Vec<Vec<bool>>> {
    let of_item = |(k, knots): (usize, &Vec<f64>)| {
        let halves = items[k].can_halve();
        knots.iter().enumerate().filter(|_| halves).map(|(v, &s)| (s, k, v)).collect::<Vec<_>>()
    };
    let mut ranked: Vec<(f64, usize, usize)> = lost.iter().enumerate().flat_map(of_item).collect();
    ranked.retain(|r| r.0 > 0.0);
    sort_by(&mut ranked, |r| [u64::MAX - real(r.0), r.1 as u64, r.2 as u64]);
    let mut rest = SHARE * ranked.iter().map(|r| r.0).sum::<f64>();
    let mut marks: Vec<Vec<bool>> = items.iter().map(|i| vec![false; i.pieces.len()]).collect();
    for &(seconds, k, v) in ranked.iter().take_while(|r| {
        let more = rest > 0.0;
        rest -= r.0;
        more
    }) {
        debug_assert!(seconds > 0.0, "sorted by what is lost");
        for (mark, piece) in marks[k].iter_mut().zip(&items[k].pieces) {
            *mark |= piece.knots.contains(&v) && items[k].can_be_halved(piece);
        }
    }
    marks.iter().flatten().any(|&marked| marked).then_some(marks)
}

/// The item with the marked pieces halved, and for each of its knots the two old ones around it, or twice the same; `None` if nothing
/// changes.
pub(super) fn halved(item: &Item, marked: &[bool]) -> Option<(Item, Vec<[usize; 2]>)> {
    let finer = if marked.contains(&true) { item.halved(marked) } else { None }?;
    let beside = |s: &f64| {
        let next = item.along.partition_point(|x| x < s);
        let same = item.along.get(next).is_some_and(|x| x.to_bits() == s.to_bits());
        let before = (next + item.knots - 1) % item.knots;
        if same { [next; 2] } else { [before, next % item.knots] }
    };
    let around = finer.along.iter().map(beside).collect();
    Some((finer, around))
}

/// Where the knots of an item are.
pub(super) fn places(item: &Item) -> Vec<DVec2> {
    let mut places = vec![DVec2::ZERO; item.knots];
    for piece in &item.pieces {
        places[piece.knots[0]] = piece.ends[0];
        places[piece.knots[1]] = piece.ends[1];
    }
    places
}
