//! The kerf: what the beam burns away, and the line it has to follow so that parts come out as drawn.
//!
//! Drawn contours are outlines of parts and holes. A beam of some width that follows them takes half of that from either
//! side, so its line lies half a kerf away in the waste: around parts, within holes. Contours are turned so that waste is
//! on the right (outer ones run counter-clockwise, holes clockwise), so one rule does for both.
//!
//! 1. **Room** ([`room`]). Contours with waste between them that is narrower than the kerf both keep their drawn line, as do
//!    those that share sides as drawn: no line between them would leave both whole.
//! 2. **Offset** ([`offset`]). The others are moved one by one. Corners stay corners where there is room, so that parts laid out
//!    one kerf apart have one line in the middle between them, up to the corners where four of them meet.
//! 3. **Once** (the cleaning and joining of this stage). Lines that have become the same are cut once.
//!
//! Contours keep their ids, nesting, parts and areas: these are of what is made. Rests of a contour that is left in several
//! pieces come last, with ids of their own. Whatever keeps its drawn line is told with its place.

mod offset;
mod raw;
mod room;
mod told;

use super::build::{find_groups, length_or};
use super::clean::clean;
use super::cross;
use super::model::{Contour, Operation, Sheet, SheetOptions};
use super::small;
use super::source::{Line, Source};
use crate::dxf::Drawing;
use crate::finding::{Code, Finding, Findings};
use crate::geometry::{Aabb, Path};
use room::Room;
use told::Why;

/// What cannot be told from a kerf at all, as a part of its width, where the copy tolerance is more than that.
const SLACK: f64 = 0.25;

/// A sheet with the lines that a beam of `width` mm follows instead of the outlines drawn, and what is worth knowing of them.
/// `drawing` and `options` are those the sheet was built of.
pub(crate) fn compensated(
    drawing: &Drawing,
    sheet: &Sheet,
    options: &SheetOptions,
    width: f64,
) -> (Sheet, Vec<Finding>) {
    let mut findings = Findings::default();
    let join = length_or(options.join_tolerance, 0.0);
    let copy = length_or(options.copy_tolerance, 0.0).min(join);
    let room = Room::new(&sheet.contours, width, copy.min(SLACK * width));
    let lines = moved(drawing, sheet, &room, width, &mut findings);
    let mut out = sheet.clone();
    // Measured again, against this kerf.
    out.findings.retain(|f| f.code != Code::FeatureTooSmall);
    small::find(drawing, &sheet.contours, small::Limit::Kerf(width), &mut findings);
    for (contour, line) in out.contours.iter_mut().zip(&lines) {
        if line.is_some() {
            contour.drawn = Some(std::mem::take(&mut contour.path));
        }
    }
    cut_once(&mut out, &lines, [copy, join], &mut findings);
    let crossing = cross::find(Source::MovedContours, &mut out.contours, copy, &mut Findings::default());
    out.groups = find_groups(&out.contours, &out.layers, &crossing, options, join);
    out.bounds = Aabb::EMPTY;
    out.layers.iter_mut().for_each(|l| l.contours = 0);
    for c in out.contours.iter().filter(|c| c.is_worked()) {
        out.bounds = out.bounds.union(c.bounds);
        if let Some(layer) = out.layers.get_mut(c.layer as usize) {
            layer.contours += 1;
        }
    }
    (out, findings.into_list())
}

/// The line of each contour that is moved.
fn moved(
    drawing: &Drawing,
    sheet: &Sheet,
    room: &Room,
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
            line(id, contour, room, width)
                .map_err(|why| findings.push(told::kept(drawing, contour, why, width)))
        } else {
            Err(())
        };
        lines.push(line.ok());
    }
    if let Some(border) = sheet.outline.and_then(|id| sheet.contours.get(id as usize)) {
        findings.push(told::border(drawing, border));
    }
    if room.cut_short {
        findings.push(told::crowded());
    }
    if let Some(finding) = told::open(&open) {
        findings.push(finding);
    }
    lines
}

fn line(id: u32, contour: &Contour, room: &Room, width: f64) -> Result<Path, Why> {
    if !contour.path.closed {
        return Err(Why::SharesSides);
    }
    if contour.self_crossing {
        return Err(Why::CrossesItself);
    }
    if let Some((gap, at)) = room.near(id) {
        return Err(Why::Near(gap, at));
    }
    offset::offset(&contour.path, 0.5 * width, |s| room.is_free(id, s)).map_err(Why::Narrow)
}

/// Gives the moved contours their lines, each stretch that several share to one of them.
fn cut_once(sheet: &mut Sheet, moved: &[Option<Path>], [copy, join]: [f64; 2], findings: &mut Findings) {
    let moved: Vec<Line> = (0..)
        .zip(moved)
        .filter_map(|(index, path)| Some(Line { index, layer: 0, path: path.as_ref()? }))
        .filter(|line| !line.path.segments.is_empty())
        .collect();
    // What is cut once is told of the whole sheet, below; and of groups, by who plans them.
    let mut quiet = Findings::default();
    let chains = clean(Source::MovedContours, &moved, copy, join, &mut quiet);
    let mut lines: Vec<Vec<(Path, Option<Path>)>> = vec![Vec::new(); sheet.contours.len()];
    for a in super::assemble::assemble(Source::MovedContours, &chains, join, &mut quiet) {
        // Whatever bounds the area stands for the contour.
        let of = &mut lines[a.first_shape as usize];
        let place = if a.path.closed || a.outline.is_some() { 0 } else { of.len() };
        of.insert(place, (a.path, a.outline));
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
            // Nothing of it is shared: as it was moved, whatever cleaning thinks of its smallest elements.
            Some((path, _)) if alone && path.closed => set(contour, line.clone(), None),
            Some((path, outline)) => set(contour, path, outline),
            None => contour.operation = Operation::Ignore,
        }
        if !contour.path.closed {
            at = at.or(line.start());
        }
        after += contour.length * f64::from(u8::from(contour.is_worked()));
        let rest = Contour { area: 0.0, ..contour.clone() };
        for (path, outline) in own {
            let mut rest = rest.clone();
            set(&mut rest, path, outline);
            after += rest.length;
            let part = sheet.parts.iter_mut().find(|p| p.outer == id || p.holes.contains(&id));
            if let (Some(part), Ok(new)) = (part, u32::try_from(sheet.contours.len())) {
                part.holes.push(new);
            }
            sheet.contours.push(rest);
        }
    }
    if let Some(at) = at {
        findings.push(told::once(before - after, at));
    }
}

fn set(contour: &mut Contour, path: Path, outline: Option<Path>) {
    (contour.length, contour.bounds) = (path.length(), path.bounds());
    (contour.path, contour.outline) = (path, outline);
}
