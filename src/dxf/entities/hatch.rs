//! HATCH: its boundaries. The filling is not cut.
//!
//! A HATCH does not show whether its boundary is also drawn as separate lines and arcs; in most files it is. The
//! boundary is therefore taken and reported (`outline-taken`), and the sheet stage removes it as a duplicate where it
//! coincides with other geometry.

use crate::dxf::entity::{Edge, Geometry, Loop, PlaneEllipse, Spline, Vertex};
use crate::dxf::ocs::{axes, without_whole_turns};
use crate::dxf::record::Record;
use crate::dxf::tag::Tag;
use crate::geometry::math;
use glam::{DVec2, DVec3};
use std::f64::consts::TAU;

/// Boundary type flag: the frame of a text box, which is not visible in the drawing either.
const TEXT_BOX: i64 = 8;
const POLYLINE: i64 = 2;

pub(super) fn hatch<'a>(record: &Record<'a>) -> Geometry<'a> {
    let elevation = record.real(30).unwrap_or(0.0);
    let mut tags = TagCursor { tags: &record.tags, at: 0 };
    let mut loops = Vec::new();
    let mut incomplete = false;
    if tags.seek(91).is_some() {
        while let Some(flags) = tags.seek_path() {
            let mut lost = false;
            let read = if flags & POLYLINE != 0 { polyline(&mut tags) } else { edges(&mut tags, &mut lost) };
            if flags & TEXT_BOX == 0 {
                loops.extend(read);
                incomplete |= lost;
            }
        }
    }
    if loops.is_empty() {
        let why = if incomplete { "its boundary lacks values" } else { "it has no boundary" };
        return Geometry::Invalid(why, record.point(10).map(|p| axes(record.normal) * p));
    }
    Geometry::Hatch { loops, incomplete, elevation, normal: record.normal }
}

fn polyline(tags: &mut TagCursor<'_, '_>) -> Option<Loop> {
    let mut vertices: Vec<Vertex> = Vec::new();
    let mut closed = true;
    while let Some(tag) = tags.next_in_path() {
        match (tag.code, tag.real(), vertices.last_mut()) {
            (73, Some(v), _) => closed = v > 0.0,
            (10, Some(x), _) => vertices.push(Vertex { at: DVec2::new(x, 0.0), bulge: 0.0 }),
            (20, Some(y), Some(v)) => v.at.y = y,
            (42, Some(b), Some(v)) => v.bulge = b,
            _ => {}
        }
    }
    (vertices.len() > 1).then_some(Loop::Polyline(vertices, closed))
}

/// A boundary of edges. `lost` becomes true if one of them cannot be read.
fn edges(tags: &mut TagCursor<'_, '_>, lost: &mut bool) -> Option<Loop> {
    let mut edges = Vec::new();
    let mut kind = None;
    let mut edge = Numbers::default();
    let mut end = |kind: Option<i64>, edge: &mut Numbers| {
        let read = edge.take(kind.unwrap_or(0));
        *lost |= kind.is_some() && read.is_none();
        edges.extend(read);
    };
    while let Some(tag) = tags.next_in_path() {
        if tag.code == 72 {
            end(kind, &mut edge);
            kind = Some(tag.int().unwrap_or(0));
        } else {
            edge.add(tag);
        }
    }
    end(kind, &mut edge);
    (!edges.is_empty()).then_some(Loop::Edges(edges))
}

/// The numbers of one edge, of any kind.
#[derive(Default)]
struct Numbers {
    points: Vec<DVec2>,
    second: Vec<DVec2>,
    values: Vec<f64>,
    weights: Vec<f64>,
    angles: [f64; 2],
    degree: usize,
    tangents: [Option<DVec2>; 2],
    /// Group 73: counter-clockwise (arcs) or rational (splines).
    ccw: bool,
    /// Group 74: periodic.
    periodic: bool,
}

impl Numbers {
    fn add(&mut self, tag: &Tag<'_>) {
        let Some(v) = tag.real() else { return };
        let set_y = |p: Option<&mut DVec2>| {
            if let Some(p) = p {
                p.y = v;
            }
        };
        match tag.code {
            10 => self.points.push(DVec2::new(v, 0.0)),
            20 => set_y(self.points.last_mut()),
            11 => self.second.push(DVec2::new(v, 0.0)),
            21 => set_y(self.second.last_mut()),
            12 => self.tangents[0] = Some(DVec2::new(v, 0.0)),
            22 => set_y(self.tangents[0].as_mut()),
            13 => self.tangents[1] = Some(DVec2::new(v, 0.0)),
            23 => set_y(self.tangents[1].as_mut()),
            40 => self.values.push(v),
            42 => self.weights.push(v),
            50 => self.angles[0] = without_whole_turns(v),
            51 => self.angles[1] = without_whole_turns(v),
            73 => self.ccw = v > 0.0,
            74 => self.periodic = v > 0.0,
            94 => self.degree = tag.int().and_then(|n| usize::try_from(n).ok()).unwrap_or(0),
            _ => {}
        }
    }

    /// The edge of kind 1 to 4 that these numbers describe. Resets the numbers.
    fn take(&mut self, kind: i64) -> Option<Edge> {
        let n = std::mem::take(self);
        let (first, second) = (n.points.first().copied(), n.second.first().copied());
        // Clockwise edges are stored with their angles mirrored at the x axis.
        let sign = if n.ccw { 1.0 } else { -1.0 };
        match kind {
            1 => Some(Edge::Line(first?, second?)),
            2 => {
                let sweep = degrees_sweep(n.angles[0], n.angles[1]);
                Some(Edge::Arc(first?, *n.values.first()?, sign * n.angles[0], sign * sweep))
            }
            3 => {
                let (center, major) = (first?, second?);
                let minor = major.perp() * *n.values.first()?;
                let from = n.angles[0].to_radians();
                let to = from + degrees_sweep(n.angles[0], n.angles[1]);
                let ratio = n.values.first()?.abs();
                let (start, end) = (ellipse_parameter(from, ratio), ellipse_parameter(to, ratio));
                let sweep = sign * (end - start);
                Some(Edge::Ellipse(PlaneEllipse { center, major, minor, start: sign * start, sweep }))
            }
            4 => {
                let lift =
                    |points: &[DVec2]| -> Vec<DVec3> { points.iter().map(|p| p.extend(0.0)).collect() };
                Some(Edge::Spline(Spline {
                    degree: n.degree,
                    closed: n.periodic,
                    knots: n.values,
                    control: lift(&n.points),
                    weights: n.weights,
                    fit: lift(&n.second),
                    start_tangent: n.tangents[0].map(|t| t.extend(0.0)),
                    end_tangent: n.tangents[1].map(|t| t.extend(0.0)),
                }))
            }
            _ => None,
        }
    }
}

/// The parameter of an ellipse in the direction `angle` from its centre, measured from its major axis, rad. Unlike an
/// ELLIPSE, a HATCH states these directions. Both agree on the axes, and whole turns are kept.
fn ellipse_parameter(angle: f64, ratio: f64) -> f64 {
    let direction = math::unit(angle);
    angle + math::turn(direction, DVec2::new(ratio * direction.x, direction.y))
}

/// The counter-clockwise angle from `start` to `end` (degrees), as radians in (0, 2 pi].
fn degrees_sweep(start: f64, end: f64) -> f64 {
    let sweep = math::wrap_tau((end - start).to_radians());
    // A full turn is written as 0 to 360, with six digits or more.
    if !(1e-6..=TAU - 1e-6).contains(&sweep) { TAU } else { sweep }
}

/// A position among the tags of a hatch.
struct TagCursor<'t, 'a> {
    tags: &'t [Tag<'a>],
    at: usize,
}

impl<'t, 'a> TagCursor<'t, 'a> {
    fn seek(&mut self, code: i32) -> Option<&'t Tag<'a>> {
        let rest = self.tags.get(self.at..)?;
        let found = rest.iter().position(|t| t.code == code)?;
        self.at += found + 1;
        rest.get(found)
    }

    /// The flags of the next boundary; `None` when the description of the filling starts.
    fn seek_path(&mut self) -> Option<i64> {
        let rest = self.tags.get(self.at..)?;
        let found = rest.iter().position(|t| matches!(t.code, 92 | 75 | 76))?;
        let tag = rest.get(found).filter(|t| t.code == 92)?;
        self.at += found + 1;
        tag.int()
    }

    /// The next tag of a boundary; `None` where the next boundary or the filling starts. The list of its source objects
    /// (97, 330) does not end it, since a spline edge has a 97 of its own; the readers of boundaries pass over both.
    fn next_in_path(&mut self) -> Option<&'t Tag<'a>> {
        let tag = self.tags.get(self.at)?;
        if matches!(tag.code, 92 | 75 | 76) {
            return None;
        }
        self.at += 1;
        Some(tag)
    }
}
