//! The contours of a plan document.

use super::super::model::Move;
use super::moves::{Element, place, segments};
use crate::geometry::{Affine, DVec2, Path, Segment};
use crate::machine::{PLANS_ALL_LEVERS, Profile};
use crate::order::sort_by;
use crate::sheet::{Operation, Sheet};
use serde::{Deserialize, Serialize};

/// A chain of lines and arcs.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Contour {
    /// Its index, which is its name everywhere.
    pub id: u32,
    /// Whether it ends where it starts.
    pub closed: bool,
    /// Name of its layer.
    pub layer: String,
    /// Cut, mark, or ignore: left out, no move works it.
    pub operation: Operation,
    /// The smallest closed contour around it that is cut, after it; `None`: there is none.
    pub inside: Option<u32>,
    /// Length, mm.
    pub length: f64,
    /// Area of what a closed contour bounds, as drawn, mm2; 0 of an open one.
    pub area: f64,
    /// Number of passes over it.
    #[serde(default = "one", skip_serializing_if = "is_one")]
    pub passes: u32,
    /// The contour that is the next pass over the same line; `None`: this is the last one, or all passes follow each other.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub next_pass: Option<u32>,
    /// Whether it is a skeleton cut, which nobody drew.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub skeleton: bool,
    /// The contour with which this outline is cut, or itself, because bridges connect their parts: a cut goes around all of these
    /// parts, and names all of these contours. Length, area and `drawn` are those of the part alone. Of an open cut through a bridge: the
    /// outline that it completes.
    #[serde(default, skip_serializing_if = "is_alone")]
    pub bridged: Option<u32>,
    /// The outline of what is made, where the line that is cut is not that outline: it runs half a kerf beside it, leaves
    /// out a side that is cut with another contour, or is cut stretch by stretch with others.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub drawn: Option<Outline>,
}

/// An outline of a part or a hole.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Outline {
    /// Where it begins and ends, mm.
    pub from: [f64; 2],
    /// Its elements in order, each from where the last one ended.
    pub path: Vec<Element>,
}

impl Contour {
    /// Whether it bounds a part or a hole. Where several contours are cut stretch by stretch, the outlines that were drawn
    /// say so.
    pub fn bounds_area(&self) -> bool {
        let drawn = self.drawn.is_some() && self.area > 0.0;
        self.next_pass.is_none() && (drawn || (self.closed && self.operation == Operation::Cut))
    }

    /// Length of its outline, mm, including sides that are cut with another contour.
    pub fn outline_length(&self) -> f64 {
        let outline = self.drawn.as_ref().filter(|_| !self.closed);
        outline.map_or(self.length, |o| o.segments().iter().map(Segment::length).sum())
    }

    /// Of a cut through a bridge: the outline of the part that it completes.
    pub fn completes(&self) -> Option<u32> {
        if PLANS_ALL_LEVERS && !self.closed { self.bridged } else { None }
    }

    /// Whether it is a cut that nobody drew: a skeleton cut, or one through a bridge.
    pub fn is_added(&self) -> bool {
        self.skeleton || self.completes().is_some()
    }

    /// Whether it frees no part.
    pub fn is_open(&self) -> bool {
        self.next_pass.is_none() && !self.closed && self.drawn.is_none() && !self.is_added()
    }
}

impl Outline {
    /// The outline, moved by `shift` mm.
    fn of(path: &Path, shift: DVec2) -> Option<Self> {
        if shift != DVec2::ZERO {
            return Self::of(&Affine::translation(shift).path(path, 0.0), DVec2::ZERO);
        }
        Some(Self { from: place(path.start()?), path: Element::all(&path.segments) })
    }

    /// Its elements with both ends.
    pub fn segments(&self) -> Vec<Segment> {
        segments(&self.path, &mut DVec2::from(self.from))
    }
}

#[allow(clippy::trivially_copy_pass_by_ref, reason = "the signature that serde asks for")]
fn is_alone(bridged: &Option<u32>) -> bool {
    !PLANS_ALL_LEVERS || bridged.is_none()
}

fn one() -> u32 {
    1
}

#[allow(clippy::trivially_copy_pass_by_ref, reason = "the signature that serde asks for")]
fn is_one(passes: &u32) -> bool {
    *passes == 1
}

/// The contours that are cut in several stretches, if the plan has cuts on the run.
fn side_by_side(sheet: &Sheet, moves: &[Move]) -> Vec<bool> {
    let mut cuts = vec![0_u32; sheet.contours.len()];
    let flies = moves.iter().any(|m| matches!(m, Move::Fly { .. }));
    for m in moves.iter().filter(|_| flies) {
        if let Move::Cut { contour, .. } = m
            && let Some(count) = cuts.get_mut(*contour as usize)
        {
            *count += 1;
        }
    }
    cuts.into_iter().map(|count| count > 1).collect()
}

/// The contours of a sheet as a machine works them; `shift` moves what is drawn to where it lies on the machine, mm.
///
/// `moves` are those of the plan.
pub fn contours(sheet: &Sheet, machine: &Profile, moves: &[Move], shift: DVec2) -> Vec<Contour> {
    // Contours of a pierce group are cut stretch by stretch, in any order, and so are those that are cut side by side on the run.
    let mut in_group = side_by_side(sheet, moves);
    for (known, grouped) in in_group.iter_mut().zip(sheet.may_be_cut_as_one(machine.cuts_as_one())) {
        *known |= grouped;
    }
    // What is left of a closed shape in several pieces is no open contour, so each piece has the outline of the shape.
    let mut shapes: Vec<(u32, &Path)> =
        sheet.contours.iter().filter_map(|c| Some((c.rest_of?, c.outline.as_ref()?))).collect();
    sort_by(&mut shapes, |(shape, _)| [(*shape).into(), 0, 0]);
    let shape_of = |c: &crate::sheet::Contour| {
        let shape = c.rest_of.filter(|_| c.operation == Operation::Cut && !c.path.closed)?;
        shapes
            .binary_search_by_key(&shape, |(s, _)| *s)
            .ok()
            .and_then(|k| shapes.get(k))
            .map(|(_, path)| *path)
    };
    let contour = |(id, (c, in_group)): (u32, (&crate::sheet::Contour, bool))| Contour {
        id,
        closed: c.path.closed,
        layer: sheet.layer_name(id).to_owned(),
        operation: c.operation,
        inside: c.inside,
        length: c.length,
        area: c.area,
        passes: if c.next_pass.is_some() { 1 } else { sheet.process_of(c, machine).passes },
        next_pass: c.next_pass,
        skeleton: c.skeleton,
        bridged: c.bridged,
        drawn: c
            .part_outline()
            .or_else(|| c.boundary().filter(|_| in_group))
            .or_else(|| shape_of(c))
            .and_then(|path| Outline::of(path, shift)),
    };
    let mut all: Vec<Contour> = (0..).zip(sheet.contours.iter().zip(in_group)).map(contour).collect();
    if PLANS_ALL_LEVERS {
        bridged(&mut all, sheet, shift);
    }
    all
}

/// Says of connected parts what each is by itself.
fn bridged(all: &mut [Contour], sheet: &Sheet, shift: DVec2) {
    for group in sheet.bridged.iter() {
        for (id, outline) in &group.outlines {
            let Some(contour) = all.get_mut(*id as usize) else { continue };
            contour.operation = Operation::Cut;
            (contour.length, contour.area) = (outline.length(), outline.area().abs());
            contour.drawn = Outline::of(outline, shift);
        }
        for (id, outline) in &group.within {
            if let Some(contour) = all.get_mut(*id as usize) {
                contour.inside = Some(*outline);
            }
        }
    }
}
