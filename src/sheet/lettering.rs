//! Lettering: many small open strokes close together, as single-line fonts and glyph templates draw them, and the leaders
//! that lead to them.
//!
//! Cut through, such strokes burn the text into the part and cost minutes, so they are offered as one group that the
//! person marks or ignores. Nothing is changed without that choice. A living hinge also consists of many short open cuts,
//! but these are straight; letters bend.
//!
//! 1. Small open contours whose boxes are near each other for their size form clusters.
//! 2. A cluster of enough strokes, enough of which bend, is lettering. Small closed contours among them belong to it (the
//!    O of a word), except circles, which may be holes.
//! 3. Other open contours with one end at such a cluster are leaders.

use super::findings::{count, plural};
use super::model::{Contour, Group, Operation};
use crate::drawing::Drawing;
use crate::finding::{Code, Finding, Findings, Severity};
use crate::geometry::{Aabb, BoxIndex, Segment, Union};
use crate::order::{real, sort_by};
use rustc_hash::FxHashSet;

/// Largest side of a stroke's box, mm. Larger letters are signs, and their strokes are as likely slots.
const LARGEST_STROKE: f64 = 30.0;
/// Strokes are near each other within this fraction of the larger one's size: the space between two words is less.
const NEAR: f64 = 0.7;
/// Strokes of one cluster differ in size by at most this factor: a comma and a capital letter.
const SIZE_FACTOR: f64 = 10.0;
/// Smallest number of open strokes in a cluster, and in all clusters together. Fewer are read at a glance.
const MIN_IN_CLUSTER: usize = 5;
const MIN_IN_ALL: usize = 10;
/// Smallest fraction of the open strokes in a cluster that bend. In capital letters of one-stroke fonts it is about half.
const MIN_BENT: f64 = 0.2;
/// Number of boxes looked at for each stroke. Letters have a few neighbours; a crowd of thousands is found through them.
const BOXES_PER_STROKE: usize = 64;

/// Finds the groups, reports them, and gives them the operations that were chosen. Returns the contours of the groups:
/// that they are open is what their group says.
pub(super) fn find(
    drawing: &Drawing,
    contours: &mut [Contour],
    choices: &[(Group, Operation)],
    findings: &mut Findings,
) -> FxHashSet<usize> {
    let lettering = lettering(contours);
    if lettering.is_empty() {
        return FxHashSet::default();
    }
    let leaders = leaders(contours, &lettering);
    let all = lettering.iter().chain(&leaders).copied().collect();
    for (group, members) in [(Group::Lettering, lettering), (Group::Leaders, leaders)] {
        let Some(&first) = members.first() else { continue };
        let choice = choices.iter().rev().find(|(g, _)| *g == group).map(|(_, operation)| *operation);
        let (code, what) = match group {
            Group::Lettering => (Code::Lettering, told(contours, &members)),
            Group::Leaders => {
                (Code::Leaders, plural(members.len(), "open line leads", "open lines lead") + " to lettering")
            }
        };
        let (severity, rest) = match choice {
            None => (Severity::Warning, "currently cut. Mark or ignore them."),
            Some(Operation::Cut) => (Severity::Info, "cut, as you chose."),
            Some(Operation::Mark) => (Severity::Info, "marked, as you chose."),
            Some(Operation::Ignore) => (Severity::Info, "ignored, as you chose."),
        };
        let mut finding = Finding::new(code, severity, format!("{what}: {rest}")).times(count(members.len()));
        finding.at = contours[first].path.start();
        let layer = contours[first].layer;
        if members.iter().all(|&c| contours[c].layer == layer) {
            finding.layer = drawing.layers.get(layer as usize).map(|l| l.name.clone());
        }
        findings.push(finding);
        if let Some(operation) = choice {
            members.iter().for_each(|&c| contours[c].operation = operation);
        }
    }
    all
}

fn told(contours: &[Contour], members: &[usize]) -> String {
    let largest = members.iter().map(|&c| size(&contours[c])).fold(0.0, f64::max);
    let strokes = plural(members.len(), "small stroke", "small strokes");
    format!("{strokes} of up to {largest:.1} mm lie close together, like lettering")
}

fn size(c: &Contour) -> f64 {
    c.bounds.size().max_element()
}

fn is_open_cut(c: &Contour) -> bool {
    c.operation == Operation::Cut && c.boundary().is_none() && c.rest_of.is_none()
}

fn bends(c: &Contour) -> bool {
    c.path.segments.len() > 1 || c.path.segments.iter().any(|s| matches!(s, Segment::Arc(_)))
}

fn is_circle(c: &Contour) -> bool {
    matches!(c.path.segments[..], [Segment::Arc(_)])
}

/// The box of a contour, grown by the distance at which others are near.
fn reach(c: &Contour) -> Aabb {
    c.bounds.grown(NEAR * size(c))
}

/// The contours that are lettering, in ascending order.
fn lettering(contours: &[Contour]) -> Vec<usize> {
    let small = |c: &Contour| size(c) <= LARGEST_STROKE && c.operation == Operation::Cut;
    let strokes: Vec<usize> =
        (0..contours.len()).filter(|&i| small(&contours[i]) && is_open_cut(&contours[i])).collect();
    if strokes.len() < MIN_IN_ALL {
        return Vec::new();
    }
    let index = BoxIndex::new(strokes.iter().map(|&i| reach(&contours[i])));
    let mut union = Union::new(strokes.len());
    for (k, &i) in (0_u32..).zip(&strokes) {
        let mut looked_at = 0;
        index.visit(contours[i].bounds, |other| {
            looked_at += 1;
            let (a, b) = (size(&contours[i]), size(&contours[strokes[other]]));
            if let (Ok(other), true) = (u32::try_from(other), a <= SIZE_FACTOR * b && b <= SIZE_FACTOR * a) {
                union.join(k, other);
            }
            looked_at < BOXES_PER_STROKE
        });
    }
    let mut by_cluster: Vec<(u32, usize)> =
        (0_u32..).zip(&strokes).map(|(k, &i)| (union.root(k), i)).collect();
    sort_by(&mut by_cluster, |(cluster, i)| [(*cluster).into(), *i as u64, 0]);
    let mut members: Vec<usize> = Vec::new();
    for cluster in by_cluster.chunk_by(|a, b| a.0 == b.0) {
        let bent = cluster.iter().filter(|(_, i)| bends(&contours[*i])).count();
        #[allow(clippy::cast_precision_loss, reason = "counts are far below 2^52")]
        let enough = bent as f64 >= MIN_BENT * cluster.len() as f64;
        if cluster.len() >= MIN_IN_CLUSTER && enough {
            members.extend(cluster.iter().map(|(_, i)| *i));
        }
    }
    if members.len() < MIN_IN_ALL {
        return Vec::new();
    }
    members.extend(closed_letters(contours, &members));
    sort_by(&mut members, |&i| [i as u64, 0, 0]);
    members
}

/// Small closed contours among the strokes; there are never more of them than strokes.
fn closed_letters(contours: &[Contour], strokes: &[usize]) -> Vec<usize> {
    let mut sizes: Vec<f64> = strokes.iter().map(|&i| size(&contours[i])).collect();
    sort_by(&mut sizes, |&s| [real(s), 0, 0]);
    let letter = sizes.get(sizes.len() * 9 / 10).copied().unwrap_or(0.0);
    let index = BoxIndex::new(strokes.iter().map(|&i| reach(&contours[i])));
    let among = |c: &Contour| {
        let mut near = false;
        index.visit(c.bounds, |_| {
            near = true;
            false
        });
        near
    };
    let fits = |c: &Contour| {
        c.operation == Operation::Cut
            && c.boundary().is_some()
            && !is_circle(c)
            && size(c) <= 1.5 * letter
            && among(c)
    };
    let closed: Vec<usize> = (0..contours.len()).filter(|&i| fits(&contours[i])).collect();
    if closed.len() <= strokes.len() { closed } else { Vec::new() }
}

/// Open contours with exactly one end at lettering.
fn leaders(contours: &[Contour], lettering: &[usize]) -> Vec<usize> {
    let index = BoxIndex::new(lettering.iter().map(|&i| reach(&contours[i])));
    let at_text = |p| {
        let mut near = false;
        index.visit(Aabb::of(p), |_| {
            near = true;
            false
        });
        near
    };
    let leads = |i: &usize| {
        let c = &contours[*i];
        let ends = [c.path.start(), c.path.end()].into_iter().flatten().filter(|p| at_text(*p)).count();
        is_open_cut(c) && lettering.binary_search(i).is_err() && ends == 1
    };
    (0..contours.len()).filter(leads).collect()
}
