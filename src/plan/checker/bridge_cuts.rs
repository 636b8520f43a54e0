//! Checks cuts through bridges: they complete the outline of every connected part, after the cut around all of them.
//!
//! Where each strip ends on an outline is known. Along every such stretch one cut has to run beside the outline, half a kerf outside it, from the
//! kerf of the cut around the parts to that kerf, and through the piece that it goes around. With what `bridges.rs` finds, all outlines are cut
//! from end to end then. A cut that is not pierced begins where an earlier move has cut.

use super::bridges::opening;
use super::kerfs::Kerfs;
use super::nesting::winding;
use super::tolerance::SAME;
use super::violation::Violation;
use super::visits::Visits;
use crate::geometry::{DVec2, Path, Segment};
use crate::machine::{PLANS_ALL_LEVERS, Profile};
use crate::plan::model::{Move, Plan};
use crate::sheet::{Bridged, Operation, Sheet};

/// Places along a cut, and along the stretch that it completes, as fractions.
const PLACES: [f64; 7] = [0.0, 0.13, 0.31, 0.5, 0.72, 0.89, 1.0];

/// Distance from its ends at which a cut has left the kerf on which it begins, mm.
const LEAVES: f64 = 1e-4;

/// The moves that may cut through a bridge without piercing, in order.
pub(super) fn on_kerfs(sheet: &Sheet, plan: &Plan) -> Vec<usize> {
    if sheet.bridged.is_empty() {
        return Vec::new();
    }
    let contour = |id: u32| sheet.contours.get(id as usize);
    let kerfs = Kerfs::new(plan, |id| contour(id).is_some_and(|c| c.path.closed && c.bridged.is_some()));
    let begins = |(step, m): (usize, &Move)| {
        let Move::Cut { contour: id, path, .. } = m else { return None };
        contour(*id)?.completes()?;
        let at = path.first()?.start();
        kerfs.at(at).iter().any(|k| k.0 < step).then_some(step)
    };
    plan.moves.iter().enumerate().filter_map(begins).collect()
}

pub(super) fn check(sheet: &Sheet, machine: &Profile, visits: &Visits, found: &mut Vec<Violation>) {
    if !PLANS_ALL_LEVERS {
        return;
    }
    let mut cuts: Vec<(u32, u32, &Path)> = Vec::new();
    for (id, contour) in (0..).zip(&sheet.contours) {
        let Some(outline) = contour.completes() else { continue };
        let mut say = |what| {
            let at = contour.path.start().unwrap_or_default();
            found.push(Violation::Bridge { contour: outline, what, at });
        };
        let around = sheet.contours.get(outline as usize).and_then(|c| c.bridged);
        match around.and_then(|id| visits.ends(id)).zip(visits.begins(id)) {
            Some((end, begin)) if end < begin => {}
            _ => say("is completed before the cut around the connected parts"),
        }
        if contour.operation != Operation::Cut {
            say("is not cut where a bridge ends on it");
        }
        if contour.next_pass.is_none() {
            cuts.push((id, outline, &contour.path));
        }
    }
    let later = machine.levers.bridges.is_some_and(|bridges| bridges.cut_later);
    if let (Some((_, outline, path)), false) = (cuts.first(), later) {
        let (what, at) = ("has a cut through a bridge, which the machine does not make", path.start());
        found.push(Violation::Bridge { contour: *outline, what, at: at.unwrap_or_default() });
    }
    if !later {
        return;
    }
    let mut ends = 0;
    for group in sheet.bridged.iter() {
        for (id, outline) in &group.outlines {
            let own: Vec<&Path> = cuts.iter().filter(|c| c.1 == *id).map(|c| c.2).collect();
            for [from, to] in group.strips.iter().filter_map(|strip| opening(strip, *id)) {
                ends += 1;
                let count =
                    own.iter().filter(|cut| completes(sheet, machine, group, outline, [from, to], cut));
                if count.count() != 1 {
                    let what = "is not cut once along the stretch where a bridge ends on it";
                    found.push(Violation::Bridge { contour: *id, what, at: from });
                }
            }
        }
    }
    if let Some((_, outline, path)) = cuts.get(ends) {
        let (what, at) = ("has more cuts through bridges than bridges end on it", path.start());
        found.push(Violation::Bridge { contour: *outline, what, at: at.unwrap_or_default() });
    }
}

/// Whether a cut runs along the stretch of an outline that a bridge leaves open, from kerf to kerf.
fn completes(
    sheet: &Sheet,
    machine: &Profile,
    group: &Bridged,
    outline: &Path,
    [from, to]: [DVec2; 2],
    cut: &Path,
) -> bool {
    let (Some(around), [shape]) = (sheet.contours.get(group.contour as usize), cut.segments.as_slice())
    else {
        return false;
    };
    let beside = if around.drawn.is_some() { 0.5 * machine.kerf_width } else { 0.0 };
    let off = |path: &Path, p: DVec2| path.nearest(p).map_or(f64::INFINITY, |(_, at)| at.distance(p));
    let outside = |p: DVec2| beside == 0.0 || winding(outline, p) == 0.0;
    let along = PLACES.map(|f| shape.at(f));
    let runs = along.iter().all(|&p| (off(outline, p) - beside).abs() <= SAME && outside(p));
    let place = |p: DVec2| outline.nearest(p).map_or(0.0, |n| n.0);
    let (begin, whole) = (place(from), outline.length());
    let length = (place(to) - begin).rem_euclid(whole);
    let covers = || {
        PLACES.iter().all(|f| {
            let at = outline.at((begin + f * length) % whole);
            at.is_some_and(|p| near(shape, p) <= beside + SAME)
        })
    };
    // The way around all parts is long, and looked at last.
    if !runs || !covers() {
        return false;
    }
    let joins = [shape.start(), shape.end()].iter().all(|&p| off(&around.path, p) <= SAME);
    // Nothing of it is cut a second time: just inside its ends it has left the cut around the parts.
    let inside = (LEAVES / shape.length()).min(0.25);
    let leaves = [inside, 1.0 - inside].iter().all(|&f| off(&around.path, shape.at(f)) > SAME);
    let through = leaves && winding(&around.path, shape.at(0.5)) != 0.0;
    joins && through
}

fn near(shape: &Segment, p: DVec2) -> f64 {
    shape.nearest(p).1.sqrt()
}
