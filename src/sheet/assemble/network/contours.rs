//! The chains of the faces, and what remains open.

use super::graph::{Face, Graph, HalfEdge};
use super::joined::Joined;
use super::owners::Owners;
use super::shapes::Known;
use crate::geometry::{Path, Segment};
use crate::order::sort_by;
use crate::sheet::assemble::close::meet;
use crate::sheet::element::{Chain, Chains, Element, ROUNDING, with_start};

/// The chains with a contour for each face; `None` if there is no face that is not a contour already.
pub(super) fn made(
    joined: &Joined,
    graph: &Graph,
    faces: &[Face],
    known: &[Known],
    covered: &[Path],
) -> Option<Chains> {
    let mut owners = Owners::new(joined, graph, faces, known);
    owners.take_free();
    owners.restore(covered, joined.tolerance);
    if owners.order.is_empty() {
        return None;
    }
    let mut out = Chains { outlines: joined.chains.outlines.clone(), ..Chains::default() };
    let mut order = Vec::new();
    for (c, chain) in (0_u32..).zip(&joined.chains.chains) {
        let edges = graph.of(c);
        let elements = joined.chains.of(chain);
        let replaced = owners.replaced[c as usize] || edges.clone().any(|e| owners.of[e].is_some());
        if !replaced {
            push(&mut out, &mut order, elements, chain.clone());
            continue;
        }
        for run in
            edges.collect::<Vec<_>>().chunk_by(|a, b| owners.of[*a].is_none() == owners.of[*b].is_none())
        {
            if run.first().is_none_or(|&e| owners.of[e].is_some()) {
                continue;
            }
            let rest: Vec<Element> = run.iter().flat_map(|&e| graph.edges[e].elements.clone()).collect();
            for piece in joined_runs(rest) {
                push(&mut out, &mut order, &piece, open(None));
            }
        }
    }
    for &f in &owners.order {
        face(&mut out, &mut order, graph, &faces[f], |h| owners.of[h / 2] == Some(f));
    }
    // Chains stay in drawing order.
    let mut chains: Vec<(u32, Chain)> = order.into_iter().zip(std::mem::take(&mut out.chains)).collect();
    sort_by(&mut chains, |(shape, _)| [(*shape).into(), 0, 0]);
    out.chains = chains.into_iter().map(|(_, chain)| chain).collect();
    Some(out)
}

fn open(rest_of: Option<u32>) -> Chain {
    Chain { elements: 0..0, closed: false, left_over: true, rest_of }
}

fn push(out: &mut Chains, order: &mut Vec<u32>, elements: &[Element], chain: Chain) {
    let from = out.elements.len();
    out.elements.extend_from_slice(elements);
    order.push(elements.iter().map(|e| e.shape).min().unwrap_or(u32::MAX));
    out.chains.push(Chain { elements: from..out.elements.len(), ..chain });
}

/// The contour of a face: a closed chain, or the rest of its outline where neighbours have the other edges. It starts
/// with its first edge, in the direction in which that is drawn.
fn face(out: &mut Chains, order: &mut Vec<u32>, graph: &Graph, face: &Face, owns: impl Fn(HalfEdge) -> bool) {
    let mut around = face.around.clone();
    let first = (0..around.len()).filter(|&k| owns(around[k])).min_by_key(|&k| around[k] / 2).unwrap_or(0);
    if around[first] % 2 == 1 {
        around.reverse();
        around.iter_mut().for_each(|h| *h ^= 1);
        around.rotate_left(face.around.len() - 1 - first);
    } else {
        around.rotate_left(first);
    }
    let elements = |run: &[HalfEdge]| run.iter().flat_map(|&h| graph.elements(h)).collect::<Vec<Element>>();
    let outline = u32::try_from(out.outlines.len()).ok();
    let all = elements(&around);
    out.outlines.push(closed(&all));
    if around.iter().all(|&h| owns(h)) {
        let mut runs = joined_runs(all);
        if let [run] = &mut runs[..] {
            let gap = run.last().zip(run.first()).map(|(l, f)| l.segment.end().distance(f.segment.start()));
            if gap.is_some_and(|gap| gap <= ROUNDING) {
                if let [first, .., last] = &mut run[..] {
                    first.segment = with_start(first.segment, last.segment.end());
                }
                push(out, order, run, Chain { closed: true, left_over: false, ..open(None) });
                return;
            }
        }
        // The assembly closes the gaps and reports them.
        runs.iter().for_each(|run| push(out, order, run, open(outline)));
        return;
    }
    // A run does not go across the first edge, unless that is where the loop closes.
    let before = around.iter().rev().take_while(|&&h| owns(h)).count();
    around.rotate_right(before);
    for run in around.chunk_by(|a, b| owns(*a) == owns(*b)).filter(|run| owns(run[0])) {
        joined_runs(elements(run)).iter().for_each(|run| push(out, order, run, open(outline)));
    }
}

/// Elements that follow each other, in runs that are joined bit for bit. Ends within rounding are made equal.
fn joined_runs(elements: Vec<Element>) -> Vec<Vec<Element>> {
    let mut runs: Vec<Vec<Element>> = Vec::new();
    for mut e in elements {
        match runs.last_mut().and_then(|run| run.last().map(|l| l.segment.end()).map(|end| (run, end))) {
            Some((run, end)) if end.distance(e.segment.start()) <= ROUNDING => {
                e.segment = with_start(e.segment, end);
                run.push(e);
            }
            _ => runs.push(vec![e]),
        }
    }
    runs
}

/// The outline of a face, with its gaps closed.
fn closed(elements: &[Element]) -> Path {
    let mut segments: Vec<Segment> = Vec::with_capacity(elements.len());
    for e in elements {
        match segments.pop() {
            Some(last) => {
                let (last, bridge, next) = meet(last, e.segment);
                segments.push(last);
                segments.extend(bridge);
                segments.push(next);
            }
            None => segments.push(e.segment),
        }
    }
    if let [first, .., last] = &mut segments[..] {
        let (a, bridge, b) = meet(*last, *first);
        (*last, *first) = (a, b);
        segments.extend(bridge);
    }
    Path::new(segments, true)
}
