//! Gaps: joins free ends up to the tolerance in order of ascending distance, and reports those that stay open.

use super::ends::Ends;
use super::junctions::Branch;
use crate::finding::{Code, Findings, Severity};
use crate::geometry::DVec2;
use crate::number::fixed;
use crate::sheet::cluster::cell;
use crate::sheet::element::ROUNDING;
use crate::sheet::source::Source;
use rustc_hash::FxHashMap;

/// Factor between one step of distance and the next. After a step no two free ends are nearer than its distance, so a
/// cell of the next step holds at most a few dozen ends, however crowded the drawing was.
const STEP: f64 = 4.0;
/// Free ends within this many tolerances of each other are reported as a near miss.
const NEAR_MISS: f64 = 10.0;
/// Ends farther apart than this, mm (or than twice the tolerance if that is more), are no near miss: such a gap is intended.
const NEAR_MISS_AT_MOST: f64 = 1.0;

/// Joins free ends whose distance is at most `tolerance` mm.
pub(super) fn join(ends: &mut Ends, tolerance: f64) {
    let mut reach = ROUNDING;
    while reach < tolerance {
        reach = (reach * STEP).min(tolerance);
        let free = ends.all_free();
        if free.len() < 2 {
            return;
        }
        let cells = Cells::new(ends, &free, reach);
        let mut pairs = Vec::new();
        for &a in &free {
            for b in cells.around(ends.point[a as usize]) {
                let gap = ends.gap(a, b);
                if a < b && gap <= reach && ends.may_join(a, b) {
                    // Distances that differ only by rounding count as equal.
                    #[allow(
                        clippy::cast_possible_truncation,
                        clippy::cast_sign_loss,
                        reason = "a tolerance is well under 1e9 mm"
                    )]
                    let distance = (gap / ROUNDING).round() as u64;
                    let [bend, names] = ends.preference(a, b);
                    pairs.push(([distance, bend, names], a, b));
                }
            }
        }
        ends.join_in_order(pairs);
    }
}

/// Ends by grid cell, to find neighbours within the side of a cell.
struct Cells {
    side: f64,
    ends: FxHashMap<(i64, i64), Vec<u32>>,
}

impl Cells {
    fn new(ends: &Ends, of: &[u32], side: f64) -> Self {
        let mut map: FxHashMap<(i64, i64), Vec<u32>> = FxHashMap::default();
        for &e in of {
            map.entry(cell(ends.point[e as usize], side)).or_default().push(e);
        }
        Self { side, ends: map }
    }

    /// The ends in the nine cells around a point, cell by cell.
    fn around(&self, p: DVec2) -> impl Iterator<Item = u32> {
        let (x, y) = cell(p, self.side);
        (0..9_i64)
            .filter_map(move |k| self.ends.get(&(x.saturating_add(k % 3 - 1), y.saturating_add(k / 3 - 1))))
            .flatten()
            .copied()
    }
}

/// Reports branches, and near misses among the ends that stay open.
pub(super) fn report(
    source: Source,
    ends: &Ends,
    branches: &[Branch],
    tolerance: f64,
    findings: &mut Findings,
) {
    for b in branches {
        let message = format!(
            "{} ends meet in one point: the straightest were joined. Check that the contours are the intended ones.",
            b.ends
        );
        let shape = ends.shape[b.end as usize];
        findings.push(source.finding(shape, Code::Branch, Severity::Warning, message, Some(b.at)));
    }
    let free = ends.all_free();
    left_at_joints(source, ends, &free, tolerance, findings);
    near_misses(source, ends, &free, tolerance, findings);
}

/// Reports free ends within the tolerance of ends that found a better match: branches across a gap.
fn left_at_joints(source: Source, ends: &Ends, free: &[u32], tolerance: f64, findings: &mut Findings) {
    let open: Vec<u32> = (0_u32..).zip(&ends.mate).filter(|(e, m)| e != *m).map(|(e, _)| e).collect();
    let cells = Cells::new(ends, &open, tolerance.max(ROUNDING));
    for &e in free.iter().filter(|&&e| !ends.at_branch[e as usize]) {
        let p = ends.point[e as usize];
        let met =
            cells.around(p).find(|&o| !ends.free(o) && ends.compatible(e, o) && ends.gap(e, o) <= tolerance);
        if met.is_some() {
            let message = "An end meets two others that fit each other better: it stays open.".to_owned();
            let shape = ends.shape[e as usize];
            findings.push(source.finding(shape, Code::Branch, Severity::Warning, message, Some(p)));
        }
    }
}

/// Reports free ends that are near each other, but farther apart than the tolerance.
fn near_misses(source: Source, ends: &Ends, free: &[u32], tolerance: f64, findings: &mut Findings) {
    let reach = (NEAR_MISS * tolerance.max(ROUNDING)).min(NEAR_MISS_AT_MOST.max(2.0 * tolerance));
    let cells = Cells::new(ends, free, reach);
    let nearest = |e: u32| {
        let near = cells.around(ends.point[e as usize]).filter(|&o| ends.may_join(e, o));
        let near = near.map(|o| (ends.gap(e, o), o)).filter(|(gap, _)| *gap <= reach);
        near.min_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)))
    };
    for &e in free {
        let Some((gap, o)) = nearest(e) else { continue };
        // Two ends that are each other's nearest are reported once, at the first of them.
        if o < e && nearest(o).is_some_and(|(_, back)| back == e) {
            continue;
        }
        let message = format!(
            "A gap of {} mm is left open: it is wider than the joining tolerance of {tolerance} mm. \
             Raise the tolerance to close it.",
            fixed(gap, 3)
        );
        let at = (ends.point[e as usize] + ends.point[o as usize]) * 0.5;
        let shape = ends.shape[e as usize];
        findings.push(source.finding(shape, Code::GapLeft, Severity::Warning, message, Some(at)));
    }
}
