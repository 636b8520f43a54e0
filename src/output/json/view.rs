//! The parts of a document as they are written.
//!
//! An arc has no sweep in this format: ends, centre and direction say it, and one that ends exactly where it starts is a
//! full circle. Where rounding could turn next to nothing into a circle, or a circle into next to nothing, the arc goes
//! out as what is safe: flatter than [`FLAT`] as its chord, nearer to a full turn than [`NEAR_TURN`] as two halves.

use super::super::arcs;
use super::super::cuts::layer_name;
use super::{Budget, Document};
use crate::dxf::{Unit, UnitsSource};
use crate::finding::Finding;
use crate::geometry::{Arc, DVec2, Segment};
use crate::machine::Profile;
use crate::plan::{Move, Summary};
use crate::sheet::{CommonCuts, Operation};
use serde::{Serialize, Serializer};
use std::f64::consts::{PI, TAU};

/// The name of the format.
const SCHEMA: &str = "kerfway.plan/1";

/// An arc no farther than this from its chord is written as a line, mm: a thousandth of the smallest thing a drawing
/// says, and a thousand times the rounding of a place on the largest sheet.
const FLAT: f64 = 1e-9;
/// An arc this near to a full turn, but not joined, is written as two, rad: on a circle of 1 m, a micrometre.
const NEAR_TURN: f64 = 1e-6;

#[derive(Serialize)]
pub(super) struct View<'a> {
    schema: &'static str,
    units: Unit,
    method: &'a str,
    #[serde(skip_serializing_if = "Option::is_none")]
    parameters: Option<&'a str>,
    seed: u64,
    budget: Budget,
    input: InputView<'a>,
    machine: &'a Profile,
    options: OptionsView<'a>,
    summary: &'a Summary,
    contours: Vec<ContourView<'a>>,
    moves: Vec<MoveView<'a>>,
    findings: Vec<&'a Finding>,
}

#[derive(Serialize)]
struct InputView<'a> {
    sha256: &'a str,
    name: &'a str,
    units: Unit,
    units_source: UnitsSource,
}

#[derive(Serialize)]
struct OptionsView<'a> {
    units: Option<Unit>,
    tolerance: f64,
    keep_damaged: bool,
    join_tolerance: f64,
    copy_tolerance: f64,
    layers: Vec<LayerView<'a>>,
    order_by_layer: bool,
    ignore_outline: bool,
    part_by_part: bool,
    common_cuts: CommonCuts,
    first: &'a [u32],
    last: &'a [u32],
    #[serde(skip_serializing_if = "<[u32]>::is_empty")]
    exclude: &'a [u32],
}

#[derive(Serialize)]
struct LayerView<'a> {
    name: &'a str,
    operation: Operation,
}

#[derive(Serialize)]
struct ContourView<'a> {
    id: u32,
    closed: bool,
    layer: &'a str,
    operation: Operation,
    inside: Option<u32>,
    length: f64,
    area: f64,
    /// The outline of what is made, where the line that is cut is not that.
    #[serde(skip_serializing_if = "Option::is_none")]
    drawn: Option<OutlineView<'a>>,
}

#[derive(Serialize)]
struct OutlineView<'a> {
    from: Place,
    path: PathView<'a>,
}

impl<'a> OutlineView<'a> {
    fn of(path: &'a crate::geometry::Path) -> Option<Self> {
        Some(Self { from: Place(path.start()?), path: PathView(&path.segments) })
    }
}

#[derive(Serialize)]
#[serde(tag = "kind", rename_all = "kebab-case")]
enum MoveView<'a> {
    Air {
        to: Place,
    },
    Pierce,
    PreCut {
        contour: u32,
        to: Place,
        #[serde(skip_serializing_if = "PathView::is_empty")]
        ahead: PathView<'a>,
    },
    Macro {
        contour: u32,
        at: Place,
    },
    Cut {
        contour: Named,
        path: PathView<'a>,
    },
}

/// The contours of a cut: one number, or a list where it runs through a pierce group.
#[derive(Serialize)]
#[serde(untagged)]
enum Named {
    One(u32),
    Several(Vec<u32>),
}

impl Named {
    fn of(contour: u32, with: &[u32]) -> Self {
        match with {
            [] => Self::One(contour),
            others => Self::Several(std::iter::once(contour).chain(others.iter().copied()).collect()),
        }
    }
}

#[derive(Serialize)]
#[serde(untagged)]
enum ElementView {
    Line { line: Place },
    Arc { arc: Place, center: Place, ccw: bool },
}

/// A point as `[x, y]`, without minus zeros.
struct Place(DVec2);

/// Elements, turned into their views as they are written.
struct PathView<'a>(&'a [Segment]);

impl PathView<'_> {
    fn is_empty(&self) -> bool {
        self.0.is_empty()
    }
}

impl Serialize for Place {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        [self.0.x + 0.0, self.0.y + 0.0].serialize(serializer)
    }
}

impl Serialize for PathView<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_seq(self.0.iter().flat_map(|segment| {
            let (line, arc) = match segment {
                Segment::Line(l) => (Some(ElementView::line(l.end)), None),
                Segment::Arc(a) if flat(a) => (Some(ElementView::line(a.end)), None),
                Segment::Arc(a) => {
                    (None, Some(arcs::split(a, largest_sweep(a)).map(|a| ElementView::arc(&a))))
                }
            };
            line.into_iter().chain(arc.into_iter().flatten())
        }))
    }
}

impl ElementView {
    fn line(to: DVec2) -> Self {
        Self::Line { line: Place(to) }
    }

    fn arc(arc: &Arc) -> Self {
        Self::Arc { arc: Place(arc.end), center: Place(arc.center), ccw: arc.ccw() }
    }
}

/// Whether an arc is its chord to every reader.
fn flat(arc: &Arc) -> bool {
    arc.sweep.abs() < PI && arcs::sagitta(arc) < FLAT
}

/// The largest sweep that ends, centre and direction of this arc's pieces say safely.
fn largest_sweep(arc: &Arc) -> f64 {
    let joined = arc.is_circle() && arc.start == arc.end;
    if joined || arc.sweep.abs() < TAU - NEAR_TURN { TAU } else { PI }
}

impl<'a> View<'a> {
    pub(super) fn of(document: &Document<'a>) -> Self {
        let &Document {
            input,
            drawing,
            sheet,
            read,
            arrange,
            machine,
            method,
            parameters,
            seed,
            budget,
            more,
            plan,
        } = document;
        // Contours of a pierce group are cut stretch by stretch, in any order.
        let groups = sheet.cut_as_one(machine.makes_pre_cuts()).iter();
        let mut pieces = vec![false; sheet.contours.len()];
        for id in groups.flat_map(|g| &g.contours) {
            if let Some(p) = pieces.get_mut(*id as usize) {
                *p = true;
            }
        }
        let in_pieces = |id: u32| pieces.get(id as usize).is_some_and(|p| *p);
        Self {
            schema: SCHEMA,
            units: Unit::Mm,
            method,
            parameters,
            seed,
            budget,
            input: InputView {
                sha256: input.sha256,
                name: input.name,
                units: drawing.units.unit,
                units_source: drawing.units.source,
            },
            machine,
            options: OptionsView {
                units: read.unit,
                tolerance: read.tolerance,
                keep_damaged: read.keep_damaged,
                join_tolerance: arrange.join_tolerance,
                copy_tolerance: arrange.copy_tolerance,
                layers: arrange
                    .layers
                    .iter()
                    .map(|(name, operation)| LayerView { name, operation: *operation })
                    .collect(),
                order_by_layer: arrange.order_by_layer,
                ignore_outline: arrange.ignore_outline,
                part_by_part: arrange.part_by_part,
                common_cuts: arrange.common_cuts,
                first: &arrange.first,
                last: &arrange.last,
                exclude: &arrange.exclude,
            },
            summary: &plan.summary,
            contours: (0..)
                .zip(&sheet.contours)
                .map(|(id, c)| ContourView {
                    id,
                    closed: c.path.closed,
                    layer: layer_name(sheet, id),
                    operation: c.operation,
                    inside: c.inside,
                    length: c.length,
                    area: c.area,
                    drawn: c
                        .part_outline()
                        .or_else(|| c.boundary().filter(|_| in_pieces(id)))
                        .and_then(OutlineView::of),
                })
                .collect(),
            moves: plan
                .moves
                .iter()
                .map(|step| match step {
                    Move::Air { to } => MoveView::Air { to: Place(*to) },
                    Move::Pierce => MoveView::Pierce,
                    Move::PreCut { contour, to, ahead } => {
                        MoveView::PreCut { contour: *contour, to: Place(*to), ahead: PathView(ahead) }
                    }
                    Move::Macro { contour, at } => MoveView::Macro { contour: *contour, at: Place(*at) },
                    Move::Cut { contour, with, path, .. } => {
                        MoveView::Cut { contour: Named::of(*contour, with), path: PathView(path) }
                    }
                })
                .collect(),
            findings: drawing.findings.iter().chain(&sheet.findings).chain(more).collect(),
        }
    }
}
