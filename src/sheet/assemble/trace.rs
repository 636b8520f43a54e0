//! Converts joined chains to paths whose elements meet bit for bit.

use super::close;
use super::ends::{Ends, NONE};
use crate::finding::{Code, Finding, Findings, Severity};
use crate::geometry::{DVec2, Path};
use crate::order::sort_by;
use crate::sheet::element::{Chain, Chains, ROUNDING};
use crate::sheet::findings::{count, plural};
use crate::sheet::source::Source;

/// A contour before nesting.
pub(crate) struct Assembled {
    /// Elements that meet bit for bit, in the direction of the first shape.
    pub(crate) path: Path,
    /// Smallest index of the shapes it consists of.
    pub(crate) first_shape: u32,
    /// Layer index and length (mm) of each element.
    pub(crate) layers: Vec<(u32, f64)>,
    /// If it is the rest of a closed shape whose other part is cut with another contour: the number of that shape.
    pub(crate) rest_of: Option<u32>,
    /// The outline of that shape; set on the longest of its rests only.
    pub(crate) outline: Option<Path>,
}

/// Traces all contours in drawing order and reports the gaps that were closed. A short rest of removed overlaps is
/// dropped if it joins nothing and is no longer than the joining tolerance, because it would only burn a spot beside a
/// cut.
pub(super) fn contours(
    source: Source,
    chains: &Chains,
    ends: &Ends,
    tolerance: f64,
    findings: &mut Findings,
) -> Vec<Assembled> {
    let mut scraps: Vec<DVec2> = Vec::new();
    let mut visited = vec![false; chains.chains.len()];
    let mut out: Vec<Assembled> = Vec::new();
    let mut rests: Vec<(u32, usize)> = Vec::new();
    for first in 0_u32.. {
        let Some(false) = visited.get(first as usize) else {
            if first as usize >= visited.len() {
                break;
            }
            continue;
        };
        let mut builder = ContourBuilder::default();
        let mut left_over = true;
        let start = first_end(ends, 2 * first);
        let mut end = start;
        loop {
            let chain = end / 2;
            visited[chain as usize] = true;
            left_over &= chains.chains[chain as usize].left_over;
            builder.take(chains, &chains.chains[chain as usize], end % 2 == 1);
            let mate = ends.mate[(end ^ 1) as usize];
            if mate == NONE || mate == start || mate == end ^ 1 {
                builder.closed = mate != NONE;
                break;
            }
            end = mate;
        }
        builder.finish();
        if left_over && !builder.closed && builder.contour.path.length() <= tolerance {
            scraps.extend(builder.contour.path.start());
            continue;
        }
        builder.report_gaps(source, findings);
        if let Some(of) = chains.chains[first as usize].rest_of {
            builder.contour.rest_of = Some(of);
            rests.push((of, out.len()));
        }
        out.push(builder.contour);
    }
    if let Some(&at) = scraps.first() {
        let text = plural(scraps.len(), "piece", "pieces");
        let message =
            format!("Next to removed overlaps, {text} no longer than the joining tolerance left out.");
        let finding = Finding::new(Code::OverlapRemoved, Severity::Info, message);
        findings.push(finding.at(at).times(count(scraps.len())));
    }
    sort_by(&mut rests, |(of, _)| [(*of).into(), 0, 0]);
    for rests in rests.chunk_by(|(a, _), (b, _)| a == b) {
        give_outline(&mut out, rests, &chains.outlines[rests[0].0 as usize]);
    }
    out
}

/// Gives the outline of a closed shape to the longest of its rests, unless one of them closes by itself.
fn give_outline(contours: &mut [Assembled], rests: &[(u32, usize)], outline: &Path) {
    let rests = rests.iter().map(|&(_, i)| i);
    if rests.clone().any(|i| contours[i].path.closed) {
        return;
    }
    let length = |i: usize| contours[i].path.length();
    // Of equally long ones, the first.
    let longest = rests.rev().max_by(|&a, &b| length(a).total_cmp(&length(b)));
    if let Some(i) = longest {
        contours[i].outline = Some(outline.clone());
    }
}

/// The end at which the contour through chain end `start` begins: the free end behind it, or `start` itself when the
/// contour is closed.
fn first_end(ends: &Ends, start: u32) -> u32 {
    let mut end = start;
    loop {
        let mate = ends.mate[end as usize];
        if mate == NONE || mate == end || mate ^ 1 == start {
            return if mate == NONE { end } else { start };
        }
        end = mate ^ 1;
    }
}

/// A contour under construction.
struct ContourBuilder {
    contour: Assembled,
    closed: bool,
    gaps: Vec<(f64, DVec2)>,
}

impl Default for ContourBuilder {
    fn default() -> Self {
        let contour = Assembled {
            path: Path::default(),
            first_shape: u32::MAX,
            layers: Vec::new(),
            rest_of: None,
            outline: None,
        };
        Self { contour, closed: false, gaps: Vec::new() }
    }
}

impl ContourBuilder {
    /// Appends a chain, whose first element is made to meet the last element so far.
    fn take(&mut self, chains: &Chains, chain: &Chain, reversed: bool) {
        let elements = chains.of(chain);
        for e in elements {
            self.contour.layers.push((e.layer, e.segment.length()));
            self.contour.first_shape = self.contour.first_shape.min(e.shape);
        }
        let from = self.contour.path.segments.len();
        if reversed {
            self.contour.path.segments.extend(elements.iter().rev().map(|e| e.segment.reversed()));
        } else {
            self.contour.path.segments.extend(elements.iter().map(|e| e.segment));
        }
        let segments = &mut self.contour.path.segments;
        if let Some(before) = from.checked_sub(1) {
            let (a, b) = (segments[before], segments[from]);
            self.gaps.push((a.end().distance(b.start()), (a.end() + b.start()) * 0.5));
            let (a, bridge, b) = close::meet(a, b);
            segments[before] = a;
            segments[from] = b;
            segments.splice(from..from, bridge);
        }
    }

    /// Makes the last end of a closed contour meet the first start.
    fn finish(&mut self) {
        self.contour.path.closed = self.closed;
        let segments = &mut self.contour.path.segments;
        let (Some(&first), Some(&last), true) = (segments.first(), segments.last(), self.closed) else {
            return;
        };
        self.gaps.push((last.end().distance(first.start()), (last.end() + first.start()) * 0.5));
        if segments.len() == 1 {
            *segments = close::ring(first);
            return;
        }
        let (a, bridge, b) = close::meet(last, first);
        segments[0] = b;
        if let Some(l) = segments.last_mut() {
            *l = a;
        }
        segments.extend(bridge);
    }

    fn report_gaps(&self, source: Source, findings: &mut Findings) {
        let closed: Vec<_> = self.gaps.iter().filter(|(gap, _)| *gap > ROUNDING).collect();
        let Some((gap, at)) = closed.iter().max_by(|a, b| a.0.total_cmp(&b.0)) else { return };
        // A gap that was closed is not shown as nothing.
        let gap = gap.max(0.0001);
        let message = if closed.len() == 1 {
            format!("A gap of {gap:.4} mm in this contour was closed.")
        } else {
            format!(
                "{} in this contour were closed, the widest {gap:.4} mm.",
                plural(closed.len(), "gap", "gaps")
            )
        };
        let shape = self.contour.first_shape;
        let finding = source.finding(shape, Code::GapClosed, Severity::Info, message, Some(*at));
        findings.push(finding.times(count(closed.len())));
    }
}
