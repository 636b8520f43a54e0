//! Offsets a closed outline to its right.
//!
//! The points at a given distance from an outline lie on a few simple curves ([`raw`]): its elements, offset, and joins
//! around its corners. These are divided where they meet, stretches that come too near to the outline are dropped, and
//! the remaining ones, joined end to end, are the offset (X.-Z. Liu et al., "An offset algorithm for polyline curves",
//! Computers in Industry 58 (2007), doi:10.1016/j.compind.2006.06.002; this implementation tests every distance and
//! needs no dual curves). Arcs remain arcs.
//!
//! The existing crate (`cavalier_contours`) cannot be used. It takes sines from the platform, so its last bits differ
//! between a browser and a native program, and it panics where its own assumptions fail. The tests compare with it.

use super::super::cluster::cluster;
use super::super::element::{ROUNDING, with_end, with_start};
use super::raw::{self, MEETING_DISTANCE, MITER_LIMIT, Raw};
use crate::geometry::{Aabb, BoxIndex, DVec2, Path, Segment, intersect};
use crate::order::{real, sort_by};

/// Number of elements visited per element on average, and for a small outline in total. An outline needs about ten; a
/// star of thousands of lines from one point needs thousands and keeps its drawn line.
const NEIGHBOURS_PER_ELEMENT: usize = 400;
const MIN_NEIGHBOURS: usize = 400_000;
/// Largest distance between ends in one cluster, mm.
const SAME_PLACE: f64 = 8.0 * MEETING_DISTANCE;
/// Largest number of consecutive short fragments that are removed; real drawings have one or two.
const MAX_FRAGMENTS: usize = 16;
/// Shortest offset that is used, mm.
const MIN_LENGTH: f64 = 0.01;

/// The outline offset to its right by `by` mm, starting beside the outline's start. `free` says whether the beam may
/// follow the sharp corner over a given segment.
///
/// # Errors
/// A place where the outline cannot be offset: it vanishes, falls into several pieces or turns over, or an element of
/// it is so far from the offset that the beam would miss what was drawn.
pub(super) fn offset(outline: &Path, by: f64, free: impl Fn(&Segment) -> bool) -> Result<Path, DVec2> {
    let start = outline.start().unwrap_or_default();
    let drawn = BoxIndex::new(outline.segments.iter().map(Segment::bounds));
    let raw = raw::pieces(outline, by, &drawn, &free);
    let mut look = (NEIGHBOURS_PER_ELEMENT * raw.len()).max(MIN_NEIGHBOURS);
    let mut stretches = divided(&raw, &mut look).ok_or(start)?;
    let mut is_clear = |p: DVec2| {
        let mut clear = true;
        drawn.visit(Aabb::of(p).grown(by), |j| {
            look = look.saturating_sub(1);
            let near = by - ROUNDING;
            clear = outline.segments[j].nearest(p).1 >= near * near;
            clear && look > 0
        });
        clear && look > 0
    };
    stretches.retain(|s| is_clear(s.segment.at(0.5)));
    if look == 0 {
        return Err(start);
    }
    let line = joined_around(stretches, start)?;
    let same_way = (line.0.area() > 0.0) == (outline.area() > 0.0);
    if !same_way || line.0.length() < MIN_LENGTH {
        return Err(start);
    }
    missed_element(outline, &line, by).map_or_else(|| Ok(from_beside(line.0, start)), Err)
}

/// The raw pieces, divided where they meet. `None` when there are too many elements to visit.
fn divided(raw: &[Raw], look: &mut usize) -> Option<Vec<Raw>> {
    let boxes: Vec<Aabb> = raw.iter().map(|r| r.segment.bounds().grown(MEETING_DISTANCE)).collect();
    let index = BoxIndex::new(boxes.iter().copied());
    let mut cuts: Vec<Vec<(f64, DVec2)>> = vec![Vec::new(); raw.len()];
    for (i, a) in raw.iter().enumerate() {
        index.visit(boxes[i], |j| {
            *look = look.saturating_sub(1);
            if j > i {
                let met = intersect(&a.segment, &raw[j].segment, MEETING_DISTANCE);
                let stretches = met.overlaps.iter().flat_map(|o| [(o.a[0], o.b[0]), (o.a[1], o.b[1])]);
                for (f, g) in met.points.iter().map(|m| (m.a, m.b)).chain(stretches) {
                    let at = a.segment.at(f);
                    cuts[i].push((f, at));
                    cuts[j].push((g, at));
                }
            }
            *look > 0
        });
    }
    if *look == 0 {
        return None;
    }
    let mut out = Vec::with_capacity(raw.len());
    for (r, mut cuts) in raw.iter().zip(cuts) {
        sort_by(&mut cuts, |c| [real(c.0), 0, 0]);
        let length = r.segment.length();
        let inner = |f: f64| f * length > MEETING_DISTANCE && (1.0 - f) * length > MEETING_DISTANCE;
        let mut from = (0.0, r.segment.start());
        for to in cuts.into_iter().filter(|c| inner(c.0)).chain([(1.0, r.segment.end())]) {
            if (to.0 - from.0) * length > MEETING_DISTANCE {
                let piece = r.segment.piece(from.0, to.0);
                out.push(Raw { segment: with_end(with_start(piece, from.1), to.1), of: r.of });
                from = to;
            }
        }
    }
    Some(out)
}

/// Joins the stretches end to end around the outline; returns the path and the drawn elements that its elements run
/// beside.
fn joined_around(mut stretches: Vec<Raw>, start: DVec2) -> Result<(Path, Vec<usize>), DVec2> {
    let ends: Vec<DVec2> = stretches.iter().flat_map(|r| [r.segment.start(), r.segment.end()]).collect();
    let node = cluster(&ends, 4.0 * MEETING_DISTANCE);
    drop_doubled(&mut stretches, &node);
    drop_dangling(&mut stretches, &node);
    let place = |at: usize| node[at];
    let mut leaving: Vec<Vec<usize>> = vec![Vec::new(); ends.len()];
    let known: Vec<(usize, Raw)> = stretches
        .iter()
        .enumerate()
        .filter(|(_, r)| r.segment.length() > 0.0)
        .map(|(k, r)| (k, *r))
        .collect();
    for &(k, _) in &known {
        leaving[place(2 * k) as usize].push(k);
    }
    leaving.iter_mut().for_each(|l| l.reverse());
    let Some(&(first, _)) = known.first() else { return Err(start) };
    let mut segments: Vec<Segment> = Vec::with_capacity(known.len());
    let mut beside = Vec::with_capacity(known.len());
    let mut at = place(2 * first);
    while let Some(k) = leaving[at as usize].pop() {
        let joined = segments.last().map_or(stretches[k].segment.start(), Segment::end);
        segments.push(with_start(stretches[k].segment, joined));
        beside.extend(stretches[k].of);
        at = place(2 * k + 1);
        if at == place(2 * first) {
            break;
        }
    }
    // A stretch that is left over belongs to another cycle, or to an open end.
    if let Some(&k) = leaving.iter().flatten().next() {
        return Err(stretches[k].segment.start());
    }
    let [head, ..] = segments[..] else { return Err(start) };
    let open = segments.last().is_none_or(|last| last.end().distance(head.start()) > SAME_PLACE);
    if open {
        return Err(segments.last().map_or(start, Segment::end));
    }
    if let Some(last) = segments.last_mut() {
        *last = with_end(*last, head.start());
    }
    Ok((Path::new(segments, true), beside))
}

/// Removes stretches that connect the same places twice. If they run in opposite directions, both are removed (the
/// middle of a slot exactly as wide as the kerf); otherwise one stays (an arc and a line that leave a corner side by
/// side).
fn drop_doubled(stretches: &mut [Raw], node: &[u32]) {
    let ends = |k: usize| [node[2 * k], node[2 * k + 1]];
    let key = |k: usize| [ends(k)[0].min(ends(k)[1]), ends(k)[0].max(ends(k)[1])];
    let mut order: Vec<usize> = (0..stretches.len()).collect();
    sort_by(&mut order, |&k| [key(k)[0].into(), key(k)[1].into(), 0]);
    let middle = |s: &Raw| s.segment.at(0.5);
    for alike in order.chunk_by(|&a, &b| key(a) == key(b)) {
        for (i, &a) in alike.iter().enumerate() {
            let other = alike[i + 1..].iter().copied().find(|&b| {
                let there = stretches[a].segment.length() > 0.0 && stretches[b].segment.length() > 0.0;
                there && middle(&stretches[a]).distance(middle(&stretches[b])) <= ROUNDING
            });
            let Some(b) = other else { continue };
            stretches[b].segment = zero_length(&stretches[b]);
            if ends(a) != ends(b) {
                stretches[a].segment = zero_length(&stretches[a]);
            }
        }
    }
}

/// Removes stretches that lead nowhere or come from nowhere: short fragments between two elements that cross at a very
/// small angle, whose distance from the outline is right up to rounding. Also removes stretches that are as short as a
/// point.
fn drop_dangling(stretches: &mut [Raw], node: &[u32]) {
    for _ in 0..MAX_FRAGMENTS {
        let there = |r: &Raw| r.segment.length() > 0.0;
        // For each node, whether a stretch begins there, and whether one ends there.
        let mut used = vec![[false; 2]; node.len()];
        for (k, _) in stretches.iter().enumerate().filter(|(_, r)| there(r)) {
            used[node[2 * k] as usize][0] = true;
            used[node[2 * k + 1] as usize][1] = true;
        }
        let mut dropped = false;
        for (k, r) in stretches.iter_mut().enumerate().filter(|(_, r)| there(r)) {
            let [from, to] = [node[2 * k], node[2 * k + 1]];
            let place = from == to && r.segment.length() <= SAME_PLACE;
            if place || !used[from as usize][1] || !used[to as usize][0] {
                r.segment = zero_length(r);
                dropped = true;
            }
        }
        if !dropped {
            break;
        }
    }
}

fn zero_length(of: &Raw) -> Segment {
    Segment::line(of.segment.start(), of.segment.start())
}

/// The middle of a drawn element that no part of the line runs beside, and that is too far from all of it.
fn missed_element(outline: &Path, (line, beside): &(Path, Vec<usize>), by: f64) -> Option<DVec2> {
    let mut present = vec![false; outline.segments.len()];
    beside.iter().for_each(|&k| present[k] = true);
    let index = BoxIndex::new(line.segments.iter().map(Segment::bounds));
    let reach = MITER_LIMIT * by;
    let absent = outline.segments.iter().zip(present).filter(|(_, present)| !present);
    absent.map(|(s, _)| s.at(0.5)).find(|&p| {
        let mut near = false;
        index.visit(Aabb::of(p).grown(reach), |j| {
            near = line.segments[j].nearest(p).1 <= reach * reach;
            !near
        });
        !near
    })
}

/// The line with its start moved to the vertex nearest to a place, and with no more divisions than necessary.
fn from_beside(mut line: Path, place: DVec2) -> Path {
    let near = |k: &usize| line.segments[*k].start().distance_squared(place);
    let first = (0..line.segments.len()).min_by(|a, b| near(a).total_cmp(&near(b)));
    line.segments.rotate_left(first.unwrap_or(0));
    line
}
