//! The strip of a sheet that is cut off in one piece and kept.

use super::super::model::Sheet;
use super::blocked::Across;
use super::outline;
use crate::geometry::{Aabb, DVec2, Path, Segment, intersect};
use crate::machine::Skeleton;

/// Places where the cut meets the outline within this distance are one, mm: the end of one side and the start of the next.
const ONE: f64 = 1e-6;

/// A strip at an edge of the sheet that no part reaches.
pub(super) struct Strip {
    /// The cut that separates it.
    pub(super) cut: Across,
    /// The box of the rest of the sheet.
    pub(super) rest: Aabb,
    /// Its outline.
    pub(super) path: Path,
}

/// The largest strip that is at least `least` mm wide.
pub(super) fn strip(sheet: &Sheet, outline: &Path, skeleton: &Skeleton, least: f64) -> Option<Strip> {
    let (room, parts) = (outline.bounds(), outline::parts(sheet).grown(skeleton.clearance));
    let sides = [(true, true), (false, true), (true, false), (false, false)];
    let strips = sides.into_iter().filter_map(|(upright, high)| {
        let pick = |p: DVec2| if upright { p.x } else { p.y };
        let at = pick(if high { parts.max } else { parts.min });
        let width = if high { pick(room.max) - at } else { at - pick(room.min) };
        if width < least {
            return None;
        }
        let mut rest = room;
        let end = if high { &mut rest.max } else { &mut rest.min };
        *(if upright { &mut end.x } else { &mut end.y }) = at;
        let cut = Across { upright, at };
        let beyond = |p: DVec2| (pick(p) > at) == high;
        Some(Strip { cut, rest, path: half(outline, cut, beyond)? })
    });
    // The first of equal ones.
    strips.reduce(|a, b| if b.path.area().abs() > a.path.area().abs() { b } else { a })
}

/// The part of a closed path beyond a line that crosses it twice.
fn half(outline: &Path, cut: Across, beyond: impl Fn(DVec2) -> bool) -> Option<Path> {
    let (first, last) = cut.within(&outline.bounds().grown(1.0));
    let line = Segment::line(cut.point(first), cut.point(last));
    let mut places: Vec<f64> = Vec::new();
    let mut before = 0.0;
    for element in &outline.segments {
        places.extend(intersect(element, &line, ONE).points.iter().map(|m| before + m.a * element.length()));
        before += element.length();
    }
    let same = |a: f64, b: f64| (a - b).abs() < ONE || (a - b).abs() > before - ONE;
    places.sort_by(f64::total_cmp);
    places.dedup_by(|a, b| same(*a, *b));
    if let [first, .., last] = places[..]
        && places.len() > 2
        && same(first, last)
    {
        places.pop();
    }
    let [a, b] = places[..] else { return None };
    let runs = [outline.between(a, b), outline.between(b, a)];
    let mut run = runs.into_iter().find(|run| {
        let path = Path::new(run.clone(), false);
        path.at(0.5 * path.length()).is_some_and(&beyond)
    })?;
    let (start, end) = (run.first()?.start(), run.last()?.end());
    run.push(Segment::line(end, start));
    Some(Path::new(run, true))
}
