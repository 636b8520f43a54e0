//! Replays which parts and which strips between them come free by cuts through bridges, and whether what is cut through lies still.
//!
//! The connected parts are a graph: parts and strips, and a tie wherever a strip ends on a part. A cut along the stretch that a strip leaves open breaks
//! that tie. What has no tie left is free; what has some hangs together with all that it can be reached from. A tie is broken in what has a part in it
//! that stays on the slats by itself: anything else may have dropped or tipped by then.

use super::bridges::opening;
use super::tip_sizes::{SIZE_SLACK, stays, tips_up};
use super::violation::Violation;
use crate::geometry::{DVec2, Path, Segment};
use crate::machine::Tips;
use crate::plan::model::{Move, Plan};
use crate::sheet::{Bridged, Sheet, Strip};
use rustc_hash::{FxHashMap, FxHashSet};

/// A part or a strip that may tip and is free after a move.
pub(super) struct Apart {
    pub(super) contour: u32,
    pub(super) outline: Path,
    pub(super) free_from: usize,
}

/// A place where a strip ends on a part: both by their places in the list of nodes, and the move that cuts there.
struct Tie {
    ends: [usize; 2],
    part: u32,
    at: DVec2,
    broken: Option<usize>,
}

/// The parts and then the strips of one piece, with their ties.
struct Nodes {
    outlines: Vec<(u32, Path)>,
    lies: Vec<bool>,
    ties: Vec<Tie>,
    /// By node: its ties.
    of: Vec<Vec<usize>>,
}

/// The pieces that come free by cuts through bridges and may tip. What is cut through and may not lie still is a violation. `joints`: by contour, a
/// place on each of its micro-joints.
pub(super) fn pieces(
    sheet: &Sheet,
    tips: &Tips,
    plan: &Plan,
    joints: &FxHashMap<u32, Vec<DVec2>>,
    found: &mut Vec<Violation>,
) -> Vec<Apart> {
    let mut pieces = Vec::new();
    if sheet.bridged.is_empty() {
        return pieces;
    }
    let mut last: FxHashMap<u32, usize> = FxHashMap::default();
    for (step, m) in plan.moves.iter().enumerate() {
        if let Move::Cut { contour, .. } = m {
            last.insert(*contour, step);
        }
    }
    let mut completing: FxHashMap<u32, Vec<(u32, &Path)>> = FxHashMap::default();
    for (id, contour) in (0..).zip(&sheet.contours).filter(|(_, c)| c.next_pass.is_none()) {
        if let Some(part) = contour.completes() {
            completing.entry(part).or_default().push((id, &contour.path));
        }
    }
    // Pieces that a person separates have no cuts through bridges.
    let apart = |group: &&Bridged| group.outlines.iter().any(|o| completing.contains_key(&o.0));
    for group in sheet.bridged.iter().filter(apart) {
        let broken = |part: u32, at: DVec2| {
            let off = |path: &Path| path.nearest(at).map_or(f64::INFINITY, |n| n.1.distance(at));
            let cuts = completing.get(&part)?.iter();
            last.get(&cuts.min_by(|a, b| off(a.1).total_cmp(&off(b.1)))?.0).copied()
        };
        let nodes = Nodes::new(group, tips, broken);
        let Some(around) = last.get(&group.contour).copied() else { continue };
        for tie in &nodes.ties {
            let Some(step) = tie.broken.filter(|step| *step > around) else { continue };
            if !nodes.hangs_on_what_lies(tie.ends[0], step) {
                let what = "cuts through a bridge of what may have dropped or tipped";
                found.push(Violation::Tipped { step, contour: tie.part, what, at: tie.at });
            }
        }
        let held = nodes.held(joints.get(&group.contour).map_or(&[], Vec::as_slice));
        for (node, ties) in nodes.of.iter().enumerate().filter(|(node, _)| !held.contains(node)) {
            let steps = ties.iter().map(|&t| nodes.ties.get(t)?.broken);
            let free_from =
                steps.collect::<Option<Vec<usize>>>().map(|steps| steps.into_iter().fold(around, usize::max));
            if let Some((free_from, (contour, outline))) = free_from.zip(nodes.outlines.get(node))
                && tips_up(tips, outline, false, SIZE_SLACK)
            {
                pieces.push(Apart { contour: *contour, outline: outline.clone(), free_from });
            }
        }
    }
    pieces
}

impl Nodes {
    /// Those of connected parts; `broken`: the last move that cuts the outline of a part at a place.
    fn new(group: &Bridged, tips: &Tips, broken: impl Fn(u32, DVec2) -> Option<usize>) -> Self {
        let places: FxHashMap<u32, usize> = group.outlines.iter().map(|o| o.0).zip(0..).collect();
        let strips = group.strips.iter().map(|strip| (group.contour, edge(strip)));
        let outlines: Vec<(u32, Path)> = group.outlines.iter().cloned().chain(strips).collect();
        let parts = group.outlines.len();
        let lies = outlines.iter().enumerate();
        let lies = lies.map(|(k, o)| k < parts && stays(tips, &o.1, SIZE_SLACK)).collect();
        let mut new = Self { of: vec![Vec::new(); outlines.len()], outlines, lies, ties: Vec::new() };
        for (strip, node) in group.strips.iter().zip(parts..) {
            for part in strip.contours {
                let Some((place, [from, to])) = places.get(&part).copied().zip(opening(strip, part)) else {
                    continue;
                };
                let at = (from + to) * 0.5;
                for end in [place, node] {
                    new.of[end].push(new.ties.len());
                }
                new.ties.push(Tie { ends: [place, node], part, at, broken: broken(part, at) });
            }
        }
        new
    }

    /// Whether a node hangs together, before a move, with a part that stays by itself.
    fn hangs_on_what_lies(&self, from: usize, step: usize) -> bool {
        let mut seen: FxHashSet<usize> = [from].into_iter().collect();
        let mut reached = vec![from];
        while let Some(node) = reached.pop() {
            if self.lies.get(node) == Some(&true) {
                return true;
            }
            let ties = self.of.get(node).into_iter().flatten().filter_map(|&t| self.ties.get(t));
            let whole = ties.filter(|tie| tie.broken.is_none_or(|broken| broken >= step));
            reached.extend(whole.flat_map(|tie| tie.ends).filter(|&end| seen.insert(end)));
        }
        false
    }

    /// The nodes that micro-joints at these places hold.
    fn held(&self, joints: &[DVec2]) -> FxHashSet<usize> {
        let on = |at: &DVec2| {
            let off = |path: &Path| path.nearest(*at).map_or(f64::INFINITY, |n| n.1.distance(*at));
            let all = self.outlines.iter().map(|o| off(&o.1)).enumerate();
            all.min_by(|a, b| a.1.total_cmp(&b.1)).map(|n| n.0)
        };
        joints.iter().filter_map(on).collect()
    }
}

/// What bounds a strip.
fn edge(strip: &Strip) -> Path {
    let [[a, b], [c, d]] = strip.sides;
    Path::new([(a, b), (b, c), (c, d), (d, a)].map(|(from, to)| Segment::line(from, to)).to_vec(), true)
}
