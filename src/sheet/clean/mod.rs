//! Cleaning: every line and arc remains once.
//!
//! 1. **Explode.** Closed shapes narrower than the tolerance collapse to a line. Shapes are divided into elements; those
//!    without length are dropped. Elements of a shape that follow
//!    each other bit for bit form a run.
//! 2. **Carriers** ([`carriers`]). Lines on one straight line and arcs on one circle are merged as intervals on it.
//!    This finds exact and reversed copies, circles drawn twice from different starts, and every collinear and
//!    co-circular overlap, in O(n log n) however many lie on top of each other.
//! 3. **Near copies** ([`near`]). Elements within the tolerance of another element on a different carrier are found:
//!    an arc beside its chord, a spline fitted twice, a slightly rotated line.
//! 4. **Loops** ([`loops`]). If outlines that are drawn in pieces lost something, they become closed runs, and steps 2 and
//!    3 are done again.
//! 5. **Rebuild.** Runs are divided where something was removed, and become chains. A closed shape that shares a side
//!    with another one loses that side, because it is cut once. Its rest is not joined to other chains and keeps the
//!    shape's outline, so that it still contains what lies inside the shape.
//!
//! The union of all elements is kept: of two elements on top of each other one stays whole, and the other loses the
//! covered part. The order decides which shapes stay closed. Closed shapes come first (a whole shape before the next, loops last),
//! then elements whose two ends meet other ends (the sides of a square made of lines, before a long line that passes
//! along it), then the longer element, then the one drawn first.

mod carriers;
mod cover;
mod loops;
mod near;
mod remainder;
mod report;
mod run;

use super::cluster::cluster;
use super::element::{Chain, Chains, Element, ROUNDING, with_start};
use super::findings::near_copies_partly_checked;
use super::sliver;
use super::source::{Line, Source};
use crate::finding::Findings;
use crate::geometry::{DVec2, Path, Segment};
use crate::order;
pub(super) use near::SLACK;
use remainder::Remainder;
use run::Run;

/// Number of times that loops are looked for. Two passes find all loops of a sheet; chains of shapes that each overlap
/// the next one only at a corner need more.
const MAX_LOOP_PASSES: usize = 4;

/// Cleans the given paths. `tolerance` (mm) is the distance up to which elements are copies of each other, `join` (mm)
/// the distance up to which ends meet.
pub(super) fn clean(
    source: Source,
    lines: &[Line],
    tolerance: f64,
    join: f64,
    findings: &mut Findings,
) -> Chains {
    let (mut elements, mut runs) = explode(source, lines, tolerance, findings);
    let (mut kept, mut complete) = united(&elements, &runs, tolerance, join);
    // A loop that becomes a closed shape takes overlaps from another one, which is then found to be a loop, too.
    for _ in 0..MAX_LOOP_PASSES {
        let Some(closed) = loops::closed(&elements, &runs, &kept, tolerance) else { break };
        (elements, runs) = closed;
        (kept, complete) = united(&elements, &runs, tolerance, join);
    }
    if !complete {
        findings.push(near_copies_partly_checked());
    }
    report::removed(source, &elements, &kept, findings);
    rebuild(&elements, &runs, &kept, tolerance)
}

/// The remainders of all elements, and whether all near copies were checked.
fn united(elements: &[Element], runs: &[Run], tolerance: f64, join: f64) -> (Vec<Remainder>, bool) {
    let mut kept = vec![Remainder::Whole; elements.len()];
    let rank = ranks(elements, runs, join);
    carriers::unite(elements, &rank, tolerance, &mut kept);
    let complete = near::unite(elements, &rank, tolerance, &mut kept);
    (kept, complete)
}

/// Divides paths into elements and runs, and drops elements shorter than rounding.
fn explode(
    source: Source,
    lines: &[Line],
    tolerance: f64,
    findings: &mut Findings,
) -> (Vec<Element>, Vec<Run>) {
    let mut elements: Vec<Element> = Vec::new();
    let mut runs: Vec<Run> = Vec::new();
    for &Line { index, layer, path } in lines {
        let line = sliver::collapsed(path, tolerance);
        if line.is_some() {
            findings.push(report::sliver(source, index, path, tolerance));
        }
        let path = line.as_ref().unwrap_or(path);
        let first_run = runs.len();
        let mut dropped = 0;
        for &segment in &path.segments {
            let length = segment.length();
            if length.is_nan() || length <= ROUNDING {
                dropped += 1;
                continue;
            }
            let mut element = Element { segment, shape: index, layer };
            match elements.last() {
                Some(last)
                    if runs.len() > first_run
                        && last.segment.end().distance(segment.start()) <= ROUNDING
                        && !is_circle(&segment)
                        && !is_circle(&last.segment) =>
                {
                    element.segment = with_start(segment, last.segment.end());
                }
                _ => {
                    runs.push(Run { elements: elements.len()..elements.len(), closed: false, is_loop: false })
                }
            }
            elements.push(element);
            if let Some(run) = runs.last_mut() {
                run.elements.end = elements.len();
            }
        }
        if let [run] = &mut runs[first_run..] {
            close(run, &mut elements, path.closed);
        }
        for run in &mut runs[first_run..] {
            run.closed |= run.elements.len() == 1 && is_circle(&elements[run.elements.start].segment);
        }
        if dropped > 0 {
            findings.push(report::zero_length(source, index, path, dropped));
        }
    }
    (elements, runs)
}

/// Marks the only run of a shape as closed when the shape is marked so or its ends are one point.
fn close(run: &mut Run, elements: &mut [Element], marked_closed: bool) {
    let many = run.elements.len() > 1;
    let [first, .., last] = &mut elements[run.elements.clone()] else { return };
    let gap = last.segment.end().distance(first.segment.start());
    if many && gap <= if marked_closed { ROUNDING } else { 0.0 } {
        first.segment = with_start(first.segment, last.segment.end());
        run.closed = true;
    }
}

fn is_circle(s: &Segment) -> bool {
    matches!(s, Segment::Arc(a) if a.is_circle())
}

/// The rank of every element; of two overlapping elements the one with the lower rank stays whole. See the module's
/// documentation.
fn ranks(elements: &[Element], runs: &[Run], join: f64) -> Vec<u32> {
    let ends: Vec<DVec2> = elements.iter().flat_map(|e| [e.segment.start(), e.segment.end()]).collect();
    let meeting = cluster(&ends, join.max(ROUNDING));
    let mut count = vec![0_u32; ends.len()];
    for &c in &meeting {
        count[c as usize] += 1;
    }
    let mut keys = Vec::with_capacity(elements.len());
    for run in runs {
        let shape = elements[run.elements.clone()].iter().map(|e| e.shape).min().unwrap_or(0);
        for i in run.elements.clone() {
            let loose = meeting[2 * i..2 * i + 2].iter().filter(|&&c| count[c as usize] < 2).count();
            #[allow(clippy::cast_possible_truncation, reason = "lengths are under 1e13 roundings")]
            let length = (elements[i].segment.length() / ROUNDING).round() as i64;
            keys.push(if run.closed {
                (0, usize::from(run.is_loop), i64::from(shape), i)
            } else {
                (1, loose, -length, i)
            });
        }
    }
    order::sort_by(&mut keys, |k| [k.0, k.1 as u64, order::whole(k.2)]);
    let mut rank = vec![0; elements.len()];
    for (r, key) in (0_u32..).zip(keys) {
        rank[key.3] = r;
    }
    rank
}

/// Builds chains from the remainders. A closed run that lost something becomes open there, and its outline is stored
/// separately.
fn rebuild(elements: &[Element], runs: &[Run], kept: &[Remainder], tolerance: f64) -> Chains {
    let mut out = Chains::default();
    out.elements.reserve(elements.len());
    out.chains.reserve(runs.len());
    for run in runs {
        let range = run.elements.clone();
        if kept[range.clone()].iter().all(|k| *k == Remainder::Whole) {
            let from = out.elements.len();
            out.elements.extend_from_slice(&elements[range]);
            let elements = from..out.elements.len();
            out.chains.push(Chain { elements, closed: run.closed, left_over: false, rest_of: None });
            continue;
        }
        let mut chains = broken(&elements[range.clone()], &kept[range.clone()], run.closed);
        let mut rest_of = None;
        if run.closed && chains.is_empty() {
            out.covered.push(elements[range.clone()].to_vec());
        }
        if run.closed && !chains.is_empty() {
            chains = divided(chains, tolerance);
            rest_of = u32::try_from(out.outlines.len()).ok();
            out.outlines.push(Path::new(elements[range].iter().map(|e| e.segment).collect(), true));
        }
        for pieces in chains {
            let from = out.elements.len();
            out.elements.extend(pieces);
            out.chains.push(Chain {
                elements: from..out.elements.len(),
                closed: false,
                left_over: true,
                rest_of,
            });
        }
    }
    out
}

/// The pieces of a run that lost something, as chains. Pieces that meet at the start of a closed run stay together.
fn broken(elements: &[Element], kept: &[Remainder], closed: bool) -> Vec<Vec<Element>> {
    let mut chains: Vec<Vec<Element>> = Vec::new();
    let mut attached = false;
    let mut first_at_seam = false;
    for (i, (element, kept)) in elements.iter().zip(kept).enumerate() {
        let whole = [(0.0, 1.0)];
        let pieces = match kept {
            Remainder::Whole => &whole[..],
            Remainder::Pieces(p) => p,
            Remainder::Copy | Remainder::Covered => &[],
        };
        if pieces.is_empty() {
            attached = false;
        }
        for &(from, to) in pieces {
            let piece = Element { segment: element.segment.piece(from, to), ..*element };
            match chains.last_mut() {
                Some(chain) if attached && from <= 0.0 => chain.push(piece),
                _ => {
                    first_at_seam |= i == 0 && from <= 0.0;
                    chains.push(vec![piece]);
                }
            }
            attached = to >= 1.0;
        }
    }
    if closed && attached && first_at_seam && chains.len() > 1 {
        let head = chains.remove(0);
        if let Some(last) = chains.last_mut() {
            last.extend(head);
        }
        // The chain across the start contains the first element, so it stays first in drawing order.
        chains.rotate_right(1);
    }
    chains
}

/// Divides the chains of a closed run at the corners that their open ends touch. A spike in an outline, drawn out and
/// back along one line, loses its way back. Divided at its foot, the outline can close without it.
fn divided(chains: Vec<Vec<Element>>, tolerance: f64) -> Vec<Vec<Element>> {
    let mut points: Vec<DVec2> = Vec::new();
    for chain in &chains {
        points.extend(chain.iter().map(|e| e.segment.start()));
        points.extend(chain.last().map(|e| e.segment.end()));
    }
    let place = cluster(&points, 2.0 * tolerance.max(ROUNDING));
    let mut open = vec![false; points.len()];
    let mut from = 0;
    for chain in &chains {
        open[place[from] as usize] = true;
        open[place[from + chain.len()] as usize] = true;
        from += chain.len() + 1;
    }
    let mut out: Vec<Vec<Element>> = Vec::new();
    from = 0;
    for chain in chains {
        for (i, e) in chain.iter().enumerate() {
            match out.last_mut() {
                Some(last) if i > 0 && !open[place[from + i] as usize] => last.push(*e),
                _ => out.push(vec![*e]),
            }
        }
        from += chain.len() + 1;
    }
    out
}
