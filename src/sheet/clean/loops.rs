//! Closed shapes drawn in pieces.
//!
//! An outline of LINEs and ARCs is closed as a polyline is, but joining comes after the removal of overlaps, and a side
//! that it shares with another outline would be gone by then. So loops that lose something to overlaps are found
//! before: loops in which every end meets exactly one other end. From then on they count as closed shapes, with the
//! same rights as polylines. Outlines that meet in a corner are not found here, but by the network of the assembly.

use super::remainder::Remainder;
use super::run::Run;
use crate::geometry::{DVec2, Path, Segment};
use crate::sheet::cluster::cluster;
use crate::sheet::element::{Element, ROUNDING, with_start};
use rustc_hash::FxHashSet;

/// Elements and runs in which loops that lost something are closed runs; `None` if there are no such loops.
pub(super) fn closed(
    elements: &[Element],
    runs: &[Run],
    kept: &[Remainder],
    tolerance: f64,
) -> Option<(Vec<Element>, Vec<Run>)> {
    let lost = |run: &Run| kept[run.elements.clone()].iter().any(|k| *k != Remainder::Whole);
    if !runs.iter().any(|run| !run.closed && lost(run)) {
        return None;
    }
    // The sides of a sliver are one line.
    let encloses = |path: &Path| 2.0 * path.area().abs() > tolerance * path.length();
    // For each run, the loop that begins with it; runs inside a loop are dropped.
    let mut loop_at: Vec<Option<Vec<Side>>> = vec![None; runs.len()];
    let mut inside = vec![false; runs.len()];
    for sides in loops(elements, runs) {
        if sides.iter().any(|side| lost(&runs[side.run])) && encloses(&path_of(elements, runs, &sides)) {
            sides.iter().for_each(|side| inside[side.run] = true);
            let first = sides[0].run;
            loop_at[first] = Some(sides);
        }
    }
    if !inside.contains(&true) {
        return None;
    }
    let mut out: (Vec<Element>, Vec<Run>) = (Vec::with_capacity(elements.len()), Vec::new());
    for (r, run) in runs.iter().enumerate() {
        let from = out.0.len();
        match &loop_at[r] {
            Some(sides) => {
                for side in sides {
                    append(&mut out.0, from, &elements[runs[side.run].elements.clone()], side.reversed);
                }
                if let [first, .., last] = &mut out.0[from..] {
                    first.segment = with_start(first.segment, last.segment.end());
                }
                out.1.push(Run { elements: from..out.0.len(), closed: true, is_loop: true });
            }
            None if !inside[r] => {
                out.0.extend_from_slice(&elements[run.elements.clone()]);
                out.1.push(Run { elements: from..out.0.len(), ..*run });
            }
            None => {}
        }
    }
    Some(out)
}

/// A run on a loop.
#[derive(Clone, Copy)]
struct Side {
    run: usize,
    reversed: bool,
}

/// The loops of open runs in which every end meets exactly one other end.
fn loops(elements: &[Element], runs: &[Run]) -> Vec<Vec<Side>> {
    // The ends of the run `open[k]` have the numbers 2 k and 2 k + 1.
    let open = once(elements, runs);
    let points: Vec<DVec2> = open.iter().flat_map(|&r| ends_of(elements, &runs[r])).collect();
    let node = cluster(&points, 2.0 * ROUNDING);
    // For a node of two ends, the sum of their numbers tells the other one.
    let mut ends = vec![(0_usize, 0_usize); points.len()];
    for (end, &n) in node.iter().enumerate() {
        let (count, sum) = &mut ends[n as usize];
        (*count, *sum) = (*count + 1, *sum + end);
    }
    let other = |end: usize| {
        let (count, sum) = ends[node[end] as usize];
        (count == 2 && sum != 2 * end).then(|| sum - end)
    };
    let mut seen = vec![false; open.len()];
    let mut found = Vec::new();
    for first in 0..open.len() {
        if seen[first] {
            continue;
        }
        let mut sides = Vec::new();
        let mut end = 2 * first;
        let closes = loop {
            seen[end / 2] = true;
            sides.push(Side { run: open[end / 2], reversed: end % 2 == 1 });
            match other(end ^ 1) {
                Some(next) if next == 2 * first => break true,
                Some(next) if !seen[next / 2] => end = next,
                _ => break false,
            }
        };
        if closes {
            found.push(sides);
        }
    }
    found
}

/// A loop as one path.
fn path_of(elements: &[Element], runs: &[Run], sides: &[Side]) -> Path {
    let segments = sides.iter().flat_map(|side| {
        let run = elements[runs[side.run].elements.clone()].iter().map(|e| e.segment);
        let run: Vec<Segment> =
            if side.reversed { run.rev().map(|s| s.reversed()).collect() } else { run.collect() };
        run
    });
    Path::new(segments.collect(), true)
}

/// The open runs, without those that are drawn twice.
fn once(elements: &[Element], runs: &[Run]) -> Vec<usize> {
    let open: Vec<usize> = (0..runs.len()).filter(|&r| !runs[r].closed).collect();
    let middle = |run: &Run| elements[run.elements.start + run.elements.len() / 2].segment.at(0.5);
    let points: Vec<DVec2> = open
        .iter()
        .flat_map(|&r| {
            let [start, end] = ends_of(elements, &runs[r]);
            [start, end, middle(&runs[r])]
        })
        .collect();
    let at = cluster(&points, 2.0 * ROUNDING);
    let mut seen: FxHashSet<[u32; 3]> = FxHashSet::default();
    let place = |k: usize| {
        let (a, b) = (at[3 * k], at[3 * k + 1]);
        [a.min(b), a.max(b), at[3 * k + 2]]
    };
    (0..open.len()).filter(|&k| seen.insert(place(k))).map(|k| open[k]).collect()
}

/// The two ends of a run.
fn ends_of(elements: &[Element], run: &Run) -> [DVec2; 2] {
    [elements[run.elements.start].segment.start(), elements[run.elements.end - 1].segment.end()]
}

/// Appends a run, or the run reversed, so that it meets the elements since `from` bit for bit.
fn append(out: &mut Vec<Element>, from: usize, run: &[Element], reversed: bool) {
    for k in 0..run.len() {
        let mut e = if reversed { run[run.len() - 1 - k] } else { run[k] };
        if reversed {
            e.segment = e.segment.reversed();
        }
        if let Some(last) = out[from..].last() {
            e.segment = with_start(e.segment, last.segment.end());
        }
        out.push(e);
    }
}
