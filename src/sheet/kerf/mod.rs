//! Kerf compensation: the line that the beam has to follow so that parts come out as drawn.
//!
//! Drawn contours are outlines of parts and holes. A beam that follows them removes half its width on either side, so
//! its line is offset by half the kerf into the waste: around parts, and within holes. Outer contours run
//! counter-clockwise and holes clockwise, so the waste is always on the right, and one rule serves both.
//!
//! 1. **Clearance** ([`clearance`]). Two contours keep their drawn lines if the waste between them is narrower than the
//!    kerf, or if they share sides as drawn, because no line between them would leave both whole. So do two that cross as drawn and
//!    would lie in each other with the kerf ([`crossed`]).
//! 2. **Offset** ([`offset`]). The other contours are offset one by one. Corners stay sharp where there is room, so
//!    parts that lie one kerf apart have one line in the middle between them, up to the corners where four of them meet.
//! 3. **Shared lines** (the cleaning and joining of this stage). Lines that now coincide are cut once, and every contour
//!    keeps a stretch of its own ([`covered`]).
//!
//! Contours keep their ids, nesting, parts and areas, which refer to the part as drawn. If a contour is left in several
//! pieces, the additional ones come last, with new ids. A finding reports every contour that keeps its drawn line, with
//! its place.

mod clearance;
mod covered;
mod crossed;
mod facing;
mod findings;
mod offset;
mod raw;
mod shift;

pub(crate) use shift::{Shift, shifts};

use super::assemble::assemble;
use super::build::{find_groups, tolerances};
use super::clean::clean;
use super::crossings;
use super::model::{Contour, Operation, Sheet, SheetOptions};
use super::narrow;
use super::source::{Line, Source};
use crate::drawing::Drawing;
use crate::finding::{Code, Finding, Findings};
use crate::geometry::{Aabb, Path};
use clearance::Clearance;
use findings::Reason;

/// Differences below this fraction of the kerf width are ignored, unless the copy tolerance is smaller.
const WIDTH_TOLERANCE: f64 = 0.25;

/// A sheet with the lines that a beam of `width` mm follows instead of the drawn outlines, with the findings about
/// them. `drawing` and `options` are those that the sheet was built from.
pub(crate) fn compensated(
    drawing: &Drawing,
    sheet: &Sheet,
    options: &SheetOptions,
    width: f64,
) -> (Sheet, Vec<Finding>) {
    let mut findings = Findings::default();
    let (join, copy) = tolerances(options);
    let clearance = Clearance::new(&sheet.contours, width, copy.min(WIDTH_TOLERANCE * width));
    let lines = moved(drawing, sheet, &clearance, width, &mut findings);
    // Whoever keeps the border has decided that it is a part.
    let border = sheet.outline.filter(|_| !options.keep_border);
    if let Some(border) = border.and_then(|id| sheet.contours.get(id as usize)) {
        findings.push(findings::border(drawing, border));
    }
    let mut out = sheet.clone();
    // Widths are measured again, against this kerf.
    out.findings.retain(|f| f.code != Code::FeatureTooSmall);
    narrow::find(drawing, &sheet.contours, narrow::Limit::Kerf(width), &mut findings);
    for (contour, line) in out.contours.iter_mut().zip(&lines) {
        if line.is_some() {
            contour.drawn = Some(std::mem::take(&mut contour.path));
        }
    }
    cut_once(&mut out, &lines, [copy, join], &mut findings);
    let crossing = crossings::find(Source::MovedContours, &mut out.contours, copy, &mut Findings::default());
    out.groups = find_groups(&out.contours, &out.layers, &crossing, options, join);
    out.bounds = Aabb::EMPTY;
    out.layers.iter_mut().for_each(|l| l.contours = 0);
    for c in out.contours.iter().filter(|c| c.is_processed()) {
        out.bounds = out.bounds.union(c.bounds);
        if let Some(layer) = out.layers.get_mut(c.layer as usize) {
            layer.contours += 1;
        }
    }
    (out, findings.into_list())
}

/// The offset line of each contour that is moved.
fn moved(
    drawing: &Drawing,
    sheet: &Sheet,
    clearance: &Clearance,
    width: f64,
    findings: &mut Findings,
) -> Vec<Option<Path>> {
    let mut open = Vec::new();
    let mut lines = Vec::with_capacity(sheet.contours.len());
    for (id, contour) in (0..).zip(&sheet.contours) {
        let is_cut = contour.operation == Operation::Cut;
        if is_cut && !contour.path.closed && contour.outline.is_none() {
            open.extend(contour.path.start());
        }
        let line = if is_cut && contour.boundary().is_some() {
            offset_line(id, contour, clearance, width)
                .map_err(|why| findings.push(findings::keeps_drawn_line(drawing, contour, why, width)))
        } else {
            Err(())
        };
        lines.push(line.ok());
    }
    for (id, why) in crossed::keep_drawn(&sheet.contours, &clearance.touching, &mut lines) {
        if let Some(contour) = sheet.contours.get(id as usize) {
            findings.push(findings::keeps_drawn_line(drawing, contour, why, width));
        }
    }
    if clearance.cut_short {
        findings.push(findings::partly_checked());
    }
    if let Some(finding) = findings::open_contours(&open) {
        findings.push(finding);
    }
    lines
}

fn offset_line(id: u32, contour: &Contour, clearance: &Clearance, width: f64) -> Result<Path, Reason> {
    if !contour.path.closed {
        return Err(Reason::SharesSides);
    }
    if contour.self_crossing {
        return Err(Reason::CrossesItself);
    }
    if let Some((gap, at)) = clearance.near(id) {
        return Err(Reason::Near(gap, at));
    }
    offset::offset(&contour.path, 0.5 * width, |s| clearance.is_free(id, s)).map_err(Reason::Narrow)
}

/// Assigns the offset lines to the moved contours. A stretch that several contours share goes to one of them.
fn cut_once(sheet: &mut Sheet, moved: &[Option<Path>], [copy, join]: [f64; 2], findings: &mut Findings) {
    let moved: Vec<Line> = (0..)
        .zip(moved)
        .filter_map(|(index, path)| Some(Line { index, layer: 0, path: path.as_ref()? }))
        .filter(|line| !line.path.segments.is_empty())
        .collect();
    // The total length that is cut once is reported below for the whole sheet; groups are reported by the planner.
    let mut quiet = Findings::default();
    let chains = clean(Source::MovedContours, &moved, copy, join, &mut quiet);
    let mut lines = vec![covered::Pieces::new(); sheet.contours.len()];
    for a in assemble(Source::MovedContours, &chains, join, false, &mut quiet).contours {
        // The contour gets the piece that bounds its area.
        let of = &mut lines[a.first_shape as usize];
        let place = if a.path.closed || a.outline.is_some() { 0 } else { of.len() };
        of.insert(place, (a.path, a.outline));
    }
    covered::give_back(&mut lines, &moved, copy);
    let mut part_of = vec![None; sheet.contours.len()];
    for (k, part) in sheet.parts.iter().enumerate() {
        for &contour in part.holes.iter().chain([&part.outer]) {
            part_of[contour as usize] = Some(k);
        }
    }
    let before: f64 = moved.iter().map(|line| line.path.length()).sum();
    let mut after = 0.0;
    let mut at = None;
    for Line { index: id, path: line, .. } in moved {
        let own = std::mem::take(&mut lines[id as usize]);
        let alone = own.len() == 1;
        let mut own = own.into_iter();
        let contour = &mut sheet.contours[id as usize];
        match own.next() {
            // Nothing is shared, so the contour keeps the whole offset line, even if cleaning removed some of its
            // shortest elements.
            Some((path, _)) if alone && path.closed => set(contour, line.clone(), None),
            Some((path, outline)) => set(contour, path, outline),
            None => contour.operation = Operation::Ignore,
        }
        if !contour.path.closed {
            at = at.or(line.start());
        }
        after += contour.length * f64::from(u8::from(contour.is_processed()));
        let rest = Contour { area: 0.0, ..contour.clone() };
        for (path, outline) in own {
            let mut rest = rest.clone();
            set(&mut rest, path, outline);
            after += rest.length;
            let part = part_of[id as usize].and_then(|k| sheet.parts.get_mut(k));
            if let (Some(part), Ok(new)) = (part, u32::try_from(sheet.contours.len())) {
                part.holes.push(new);
            }
            sheet.contours.push(rest);
        }
    }
    if let Some(at) = at {
        findings.push(findings::cut_once(before - after, at));
    }
}

fn set(contour: &mut Contour, path: Path, outline: Option<Path>) {
    (contour.length, contour.bounds) = (path.length(), path.bounds());
    (contour.path, contour.outline) = (path, outline);
}
