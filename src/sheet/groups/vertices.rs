//! Inserts vertices into a path where its group has nodes.
//!
//! Contours that meet within the tolerance must meet bit for bit. A path therefore gets a vertex at the exact position
//! of each of its nodes. A near end or joint is moved there; elsewhere the element is divided.

use super::super::element::ROUNDING;
use crate::geometry::{Arc, DVec2, Path, Segment, math};

/// The path with vertices at these places, which are given with their arc lengths in order, and the arc lengths of
/// these vertices. `None` if a place is farther than `limit` mm from the path, or if nothing is left of an element.
pub(super) fn with_vertices(path: &Path, places: &[(f64, DVec2)], limit: f64) -> Option<(Path, Vec<f64>)> {
    let ends: Vec<f64> = path
        .segments
        .iter()
        .scan(0.0, |sum, s| {
            *sum += s.length();
            Some(*sum)
        })
        .collect();
    let length = *ends.last()?;
    let count = path.segments.len();
    // New position of joint k, the start of element k. The last end of a closed path is its first start.
    let mut joints: Vec<Option<DVec2>> = vec![None; count + 1];
    let mut divided: Vec<Vec<(f64, DVec2)>> = vec![Vec::new(); count];
    for &(along, place) in places {
        if path.at(along)?.distance(place) > limit {
            return None;
        }
        let k = ends.partition_point(|&end| end < along);
        let start = |k: usize| if k == 0 { 0.0 } else { ends[k - 1] };
        let near = [k, (k + 1).min(count)].into_iter().find(|&j| (start(j) - along).abs() <= limit);
        match near {
            Some(j) if path.closed && (j == 0 || j == count) => {
                joints[0] = Some(place);
                joints[count] = Some(place);
            }
            Some(j) => joints[j] = Some(place),
            None => divided[k].push(((along - start(k)) / (ends[k] - start(k)), place)),
        }
    }
    let mut segments = Vec::with_capacity(count + places.len());
    let mut gone = 0.0;
    let mut at: Vec<(DVec2, f64)> = vec![(joints[0].or_else(|| path.start())?, 0.0)];
    for (k, segment) in path.segments.iter().enumerate() {
        let end = joints[k + 1].unwrap_or_else(|| segment.end());
        let mut from = (0.0, joints[k].unwrap_or_else(|| segment.start()));
        for &to in divided[k].iter().chain([&(1.0, end)]) {
            let piece = moved(segment.piece(from.0, to.0), from.1, to.1)?;
            gone += piece.length();
            at.push((to.1, gone));
            segments.push(piece);
            from = to;
        }
    }
    // A closed path ends where it starts, so that vertex is at arc length 0.
    if path.closed {
        at.pop();
    }
    let is_last = |along: f64| !path.closed && along > 0.5 * length;
    let find = |&(along, place): &(f64, DVec2)| {
        let mut vertices = at.iter().filter(|v| v.0 == place).map(|v| v.1);
        if is_last(along) { vertices.next_back() } else { vertices.next() }
    };
    let alongs = places.iter().map(find).collect::<Option<Vec<f64>>>()?;
    Some((Path::new(segments, path.closed), alongs))
}

/// An element with new ends. An arc keeps its centre if they moved only by rounding, and its sweep if they moved
/// farther.
fn moved(s: Segment, start: DVec2, end: DVec2) -> Option<Segment> {
    let far = s.start().distance(start).max(s.end().distance(end)) > ROUNDING;
    let new = match s {
        Segment::Line(_) => Segment::line(start, end),
        Segment::Arc(a) if far => Segment::Arc(Arc::from_bulge(start, end, math::tan(0.25 * a.sweep))?),
        Segment::Arc(a) => Segment::Arc(Arc { start, end, ..a }),
    };
    (new.length() > ROUNDING).then_some(new)
}
