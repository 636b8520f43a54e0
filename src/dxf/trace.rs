//! Converts an entity and the map that places it on the sheet to chains of lines and arcs in mm.
//!
//! Under a map that keeps angles, arcs remain exact arcs. Under any other map they become ellipses, which are fitted
//! within the tolerance like splines. End points are the exact images of the points in the file, so shapes that meet in
//! the drawing meet on the sheet.

use super::entity::{Edge, Geometry, Loop, PlaneEllipse, Polyline3d, Spline, Vertex};
use super::ocs::{self, Projection};
use crate::geometry::{Affine, Arc, Ellipse, Nurbs, Path, Segment, pin_ends};
use glam::{DAffine3, DVec2, DVec3};
use std::f64::consts::TAU;

/// The outline of one entity on the sheet.
#[derive(Debug, Default)]
pub(super) struct Outline {
    /// Chains, mm.
    pub(super) paths: Vec<Path>,
    /// Whether the entity is tilted against the sheet, so that it is seen in projection.
    pub(super) tilted: bool,
}

/// Largest difference in height, mm, that counts as flat; it allows for rounding in the file.
const FLAT: f64 = 1e-6;

/// The outline of `geometry`, placed on the sheet by `to_sheet`, with curves fitted within `tolerance` mm.
///
/// # Errors
/// A sentence fragment that says why its values make no outline.
pub(super) fn outline(
    geometry: &Geometry<'_>,
    to_sheet: &DAffine3,
    tolerance: f64,
) -> Result<Outline, String> {
    let tracer = Tracer { to_sheet, tolerance };
    match geometry {
        Geometry::Line(a, b) => Ok(tracer.chain(&[*a, *b], false)),
        Geometry::Arc { center, radius, start, end, normal } => {
            let plane = tracer.plane(*normal, center.z);
            let arc = arc(center.truncate(), *radius, *start, *end).ok_or("it has no length")?;
            Ok(flat(plane, vec![tracer.arc(&arc, &plane.map)]))
        }
        Geometry::Polyline { vertices, closed, elevation, normal, .. } => {
            let plane = tracer.plane(*normal, *elevation);
            Ok(flat(plane, vec![tracer.polyline(vertices, *closed, &plane.map)]))
        }
        Geometry::Polylines3d(chains) => {
            let mut all = Outline::default();
            for Polyline3d { points, closed } in chains {
                let one = tracer.chain(points, *closed);
                all.paths.extend(one.paths);
                all.tilted |= one.tilted;
            }
            Ok(all)
        }
        Geometry::Ellipse { center, major, minor, start, sweep } => {
            let m = to_sheet.matrix3;
            let (u, v) = (m * *major, m * *minor);
            let ellipse = Ellipse {
                center: to_sheet.transform_point3(*center).truncate(),
                major: u.truncate(),
                minor: v.truncate(),
                start: *start,
                sweep: *sweep,
            };
            Ok(Outline { paths: vec![tracer.ellipse(&ellipse)], tilted: u.z.abs().max(v.z.abs()) > FLAT })
        }
        Geometry::Spline(spline) => {
            let place = |p: &DVec3| to_sheet.transform_point3(*p).truncate();
            let heights = spline.control.iter().chain(&spline.fit).map(|p| to_sheet.transform_point3(*p).z);
            let tilted = spread(heights) > FLAT;
            let flat = |elevation| tracer.plane(DVec3::Z, elevation).map;
            Ok(Outline { paths: vec![tracer.spline(spline, place, flat)?], tilted })
        }
        Geometry::Hatch { loops, elevation, normal, .. } => {
            let plane = tracer.plane(*normal, *elevation);
            let mut paths = Vec::new();
            for boundary in loops {
                match boundary {
                    Loop::Polyline(vertices, closed) => {
                        paths.push(tracer.polyline(vertices, *closed, &plane.map));
                    }
                    Loop::Edges(edges) => {
                        for edge in edges {
                            paths.push(tracer.edge(edge, &plane.map)?);
                        }
                    }
                }
            }
            Ok(flat(plane, paths))
        }
        Geometry::Insert(_) | Geometry::Other(..) | Geometry::Invalid(..) => Ok(Outline::default()),
    }
}

fn flat(plane: Projection, paths: Vec<Path>) -> Outline {
    Outline { paths, tilted: plane.tilted }
}

/// A counter-clockwise arc in its plane: a circle when its angles are a full turn apart, `None` when they are equal.
fn arc(center: DVec2, radius: f64, start: f64, end: Option<f64>) -> Option<Arc> {
    let end = end.unwrap_or(start + 360.0);
    // Angles are written with six digits or more; a smaller difference is zero.
    const NONE: f64 = 1e-9;
    if (end - start).abs() < NONE {
        return None;
    }
    let sweep = (end - start).rem_euclid(360.0);
    let whole = !(NONE..=360.0 - NONE).contains(&sweep);
    let from = center + radius * ocs::unit_at_degrees(start);
    let to = if whole { from } else { center + radius * ocs::unit_at_degrees(end) };
    Some(Arc { start: from, end: to, center, sweep: if whole { TAU } else { sweep.to_radians() } })
}

struct Tracer<'m> {
    to_sheet: &'m DAffine3,
    tolerance: f64,
}

impl Tracer<'_> {
    fn plane(&self, normal: DVec3, elevation: f64) -> Projection {
        ocs::project(&(*self.to_sheet * ocs::plane(normal, elevation)))
    }

    fn chain(&self, points: &[DVec3], closed: bool) -> Outline {
        let placed: Vec<DVec3> = points.iter().map(|p| self.to_sheet.transform_point3(*p)).collect();
        let tilted = spread(placed.iter().map(|p| p.z)) > FLAT;
        let flat: Vec<Vertex> = placed.iter().map(|p| Vertex { at: p.truncate(), bulge: 0.0 }).collect();
        Outline { paths: vec![self.polyline(&flat, closed, &Affine::IDENTITY)], tilted }
    }

    fn arc(&self, arc: &Arc, map: &Affine) -> Path {
        match map.segment(&Segment::Arc(*arc)) {
            Some(image) => Path::new(vec![image], arc.is_circle()),
            None => {
                let mut path = self.ellipse(&Ellipse::of_arc(arc, map));
                if !arc.is_circle() {
                    pin_ends(&mut path.segments, map.point(arc.start), map.point(arc.end));
                }
                Path::closed_if_ends_meet(path.segments)
            }
        }
    }

    fn polyline(&self, vertices: &[Vertex], closed: bool, map: &Affine) -> Path {
        let mut segments = Vec::with_capacity(vertices.len());
        let mut run = |a: &Vertex, b: &Vertex| {
            let (from, to) = (map.point(a.at), map.point(b.at));
            match Arc::from_bulge(a.at, b.at, a.bulge) {
                Some(arc) => {
                    let mut piece = self.arc(&arc, map).segments;
                    pin_ends(&mut piece, from, to);
                    segments.extend(piece);
                }
                None => segments.push(Segment::line(from, to)),
            }
        };
        for pair in vertices.windows(2) {
            if let [a, b] = pair {
                run(a, b);
            }
        }
        if let (true, [first, .., last]) = (closed, vertices)
            && first.at != last.at
        {
            run(last, first);
        }
        // A polyline drawn back to its first vertex is closed even without the flag.
        Path::closed_if_ends_meet(segments)
    }

    fn ellipse(&self, e: &Ellipse) -> Path {
        let segments = far_placeholder(&[e.center, e.center + e.major, e.center + e.minor]);
        Path::closed_if_ends_meet(segments.unwrap_or_else(|| e.to_segments(self.tolerance)))
    }

    fn spline(
        &self,
        spline: &Spline,
        place: impl Fn(&DVec3) -> DVec2,
        flat: impl Fn(f64) -> Affine,
    ) -> Result<Path, String> {
        // A curve through fit points depends on their distances, which the map may change. It is therefore computed in
        // its own plane, and its control points are mapped to the sheet.
        let through = || {
            let fit: Vec<DVec2> = spline.fit.iter().map(|p| p.truncate()).collect();
            let tangent = |t: Option<DVec3>| t.map(|t| t.truncate());
            let (start, end) = (tangent(spline.start_tangent), tangent(spline.end_tangent));
            let elevation = spline.fit.first().map_or(0.0, |p| p.z);
            Nurbs::interpolate(&fit, start, end, spline.closed)
                .map(|curve| curve.transformed(&flat(elevation)))
        };
        let curve = if spline.control.is_empty() {
            through()
        } else {
            let control: Vec<DVec2> = spline.control.iter().map(&place).collect();
            let (weights, knots) = (spline.weights.clone(), spline.knots.clone());
            let made = if spline.closed {
                Nurbs::closed(spline.degree, control, weights, knots)
            } else {
                Nurbs::new(spline.degree, control, weights, knots)
            };
            made.or_else(|fault| if spline.fit.is_empty() { Err(fault) } else { through() })
        };
        let curve = curve.map_err(|fault| fault.to_string())?;
        let segments = far_placeholder(curve.control()).unwrap_or_else(|| curve.to_segments(self.tolerance));
        Ok(Path::closed_if_ends_meet(segments))
    }

    fn edge(&self, edge: &Edge, map: &Affine) -> Result<Path, String> {
        Ok(match edge {
            Edge::Line(a, b) => Path::new(vec![Segment::line(map.point(*a), map.point(*b))], false),
            Edge::Arc(center, radius, start, sweep) => {
                let at = |degrees: f64| *center + *radius * ocs::unit_at_degrees(degrees);
                let (from, whole) = (at(*start), sweep.abs() >= TAU);
                let to = if whole { from } else { at(start + sweep.to_degrees()) };
                self.arc(&Arc { start: from, end: to, center: *center, sweep: *sweep }, map)
            }
            Edge::Ellipse(PlaneEllipse { center, major, minor, start, sweep }) => {
                let e =
                    Ellipse { center: *center, major: *major, minor: *minor, start: *start, sweep: *sweep };
                self.ellipse(&e.transformed(map))
            }
            Edge::Spline(spline) => self.spline(spline, |p| map.point(p.truncate()), |_| *map)?,
        })
    }
}

/// Replaces a curve that comes from farther away than any sheet by straight lines through its points, which are then
/// refused for their position. Fitting such a curve would take thousands of elements and a tenth of a second.
fn far_placeholder(points: &[DVec2]) -> Option<Vec<Segment>> {
    // A hundred times the limit of coordinates: a curve on the sheet has control points about as near as itself.
    const FARTHEST: f64 = 1e8;
    let is_far = |p: &DVec2| p.abs().max_element() > FARTHEST;
    points.iter().any(is_far).then(|| {
        let there_and_back = points.iter().chain(points.iter().rev()).copied();
        let points: Vec<DVec2> = there_and_back.collect();
        points.windows(2).map(|w| Segment::line(w[0], w[1])).collect()
    })
}

fn spread(heights: impl Iterator<Item = f64>) -> f64 {
    let (min, max) = heights.fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), z| (a.min(z), b.max(z)));
    max - min
}
