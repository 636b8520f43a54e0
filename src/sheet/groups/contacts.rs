//! Contacts: which contours end on which others, and where.

use super::super::cluster::cluster;
use super::super::model::Contour;
use super::stretches::Stretches;
use super::vertices::with_vertices;
use crate::geometry::{DVec2, Path, Union};
use crate::order::{real, sort_by};

/// Breaks that are at most this far apart, in tolerances, are one node.
pub(super) const SAME_NODE: f64 = 2.0;

/// A place on a contour where its group has a node.
#[derive(Clone, Copy, Debug)]
pub(super) struct Break {
    pub(super) contour: u32,
    /// Arc length from the contour's start, mm.
    pub(super) along: f64,
    pub(super) at: DVec2,
}

/// Contours that are connected by contacts, and the places where they meet.
pub(super) struct Set {
    /// Contour ids, ascending.
    pub(super) contours: Vec<u32>,
    /// Sorted by contour, then by position on it.
    pub(super) breaks: Vec<Break>,
    /// The node of each break.
    pub(super) node: Vec<u32>,
}

/// Connected sets of those contours that are `sound`.
pub(super) fn sets(contours: &[Contour], sound: &[bool], tolerance: f64) -> Vec<Set> {
    let open = |c: &(u32, &Contour)| sound[c.0 as usize] && !c.1.path.closed;
    if !(0..).zip(contours).any(|c| open(&c)) {
        return Vec::new();
    }
    let stretches = Stretches::new(contours, sound);
    let mut together = Union::new(contours.len());
    let mut breaks: Vec<Break> = Vec::new();
    let mut met: Vec<u32> = Vec::new();
    for (id, contour) in (0..).zip(contours).filter(open) {
        let ends = [contour.path.start(), contour.path.end()].map(Option::unwrap_or_default);
        let touched = ends.map(|end| touching(contours, &stretches, id, end, tolerance));
        if touched.iter().any(Vec::is_empty) {
            continue;
        }
        met.push(id);
        for found in touched.into_iter().flatten() {
            together.join(id, found.contour);
            breaks.push(found);
        }
    }
    // The ends of an open contour are breaks even if nothing touches them.
    met.extend(breaks.iter().map(|b| b.contour));
    sort_by(&mut met, |&c| [c.into(), 0, 0]);
    met.dedup();
    for id in met {
        let path = &contours[id as usize].path;
        if let (Some(start), Some(end), false) = (path.start(), path.end(), path.closed) {
            breaks.push(Break { contour: id, along: 0.0, at: start });
            breaks.push(Break { contour: id, along: path.length(), at: end });
        }
    }
    let mut by_set: Vec<(u32, Break)> = breaks.into_iter().map(|b| (together.root(b.contour), b)).collect();
    sort_by(&mut by_set, |(set, b)| [u64::from(*set) << 32 | u64::from(b.contour), real(b.along), 0]);
    by_set.chunk_by(|a, b| a.0 == b.0).map(|set| joined(contours, set, tolerance)).collect()
}

/// The places of other contours at a point.
fn touching(contours: &[Contour], stretches: &Stretches, own: u32, at: DVec2, tolerance: f64) -> Vec<Break> {
    // Twice the tolerance, as the ends of stretches are rounded.
    let others = stretches.around(at, 2.0 * tolerance).into_iter().filter(|c| *c != own);
    others
        .filter_map(|contour| {
            let (along, place) = contours[contour as usize].path.nearest(at)?;
            (place.distance(at) <= tolerance).then_some(Break { contour, along, at: place })
        })
        .collect()
}

/// A set with its nodes. Breaks near each other are one node, and those of one contour are one break.
fn joined(contours: &[Contour], set: &[(u32, Break)], tolerance: f64) -> Set {
    let points: Vec<DVec2> = set.iter().map(|s| s.1.at).collect();
    let node = cluster(&points, SAME_NODE * tolerance);
    let mut out = Set { contours: Vec::new(), breaks: Vec::new(), node: Vec::new() };
    for (&(_, b), &n) in set.iter().zip(&node) {
        if out.contours.last() != Some(&b.contour) {
            out.contours.push(b.contour);
        }
        let same = |k: usize| out.breaks[k].contour == b.contour && out.node[k] == n;
        // The two ends of an open contour remain separate breaks; other places of one contour at a node are merged.
        let known = (0..out.breaks.len())
            .rev()
            .take_while(|&k| out.breaks[k].contour == b.contour)
            .find(|&k| same(k));
        let is_end = |b: &Break| {
            let path = &contours[b.contour as usize].path;
            !path.closed && (b.along <= 0.0 || b.along >= path.length())
        };
        match known {
            Some(k)
                if is_end(&b)
                    && is_end(&out.breaks[k])
                    && (out.breaks[k].along - b.along).abs() > tolerance =>
            {
                out.breaks.push(b);
                out.node.push(n);
            }
            Some(k) if is_end(&b) => out.breaks[k] = b,
            Some(_) => {}
            None => {
                out.breaks.push(b);
                out.node.push(n);
            }
        }
    }
    out
}

/// The paths of the contours of a set with vertices at its nodes, so that they meet bit for bit. `None` if something
/// would move farther than `limit` mm.
pub(super) fn join(contours: &[Contour], set: &mut Set, limit: f64) -> Option<Vec<Path>> {
    let nodes = set.node.iter().max().map_or(0, |n| *n as usize + 1);
    let mut place: Vec<Option<DVec2>> = vec![None; nodes];
    let is_inner = |b: &Break| {
        let path = &contours[b.contour as usize].path;
        path.closed || (b.along > 0.0 && b.along < path.length())
    };
    // Contours that pass through a node stay, and ends move onto them.
    for inner in [true, false] {
        for (b, &n) in set.breaks.iter().zip(&set.node) {
            if is_inner(b) == inner && place[n as usize].is_none() {
                place[n as usize] = contours[b.contour as usize].path.at(b.along);
            }
        }
    }
    let mut paths = Vec::with_capacity(set.contours.len());
    let mut alongs = Vec::with_capacity(set.breaks.len());
    for &id in &set.contours {
        let first = set.breaks.partition_point(|b| b.contour < id);
        let own = set.breaks.iter().zip(&set.node).skip(first).take_while(|(b, _)| b.contour == id);
        let places = own.map(|(b, &n)| Some((b.along, place[n as usize]?))).collect::<Option<Vec<_>>>();
        let path = &contours[id as usize].path;
        let (path, new) = with_vertices(path, &places?, limit)?;
        paths.push(path);
        alongs.extend(new);
    }
    for (b, along) in set.breaks.iter_mut().zip(alongs) {
        b.along = along;
    }
    Some(paths)
}
