//! Measures the number of elements, the nesting and the extent of a drawing before anything is expanded.
//!
//! Ten nested blocks that each insert the next one ten times take a kilobyte and expand to 10^10 entities. Every block
//! is measured once, or twice if it is also inserted on a layer that is off, so the time is proportional to the size of
//! the file, whatever the number of inserts. A file that exceeds a limit is refused here with a sentence that names the
//! block.

use super::entity::{Edge, Entity, Geometry, Loop};
use super::file::File;
use super::{ocs, placement};
use crate::drawing::{Limits, ReadError};
use glam::{DAffine3, DVec2, DVec3};

/// A box in space. It is empty when `min` exceeds `max`.
#[derive(Clone, Copy, Debug)]
struct Extent {
    min: DVec3,
    max: DVec3,
}

impl Extent {
    const EMPTY: Self = Self { min: DVec3::INFINITY, max: DVec3::NEG_INFINITY };

    fn add(&mut self, p: DVec3) {
        self.min = self.min.min(p);
        self.max = self.max.max(p);
    }

    fn corners(&self) -> impl Iterator<Item = DVec3> + '_ {
        let corner = |i: u32| {
            let pick = |bit: u32, min: f64, max: f64| if i & bit == 0 { min } else { max };
            DVec3::new(
                pick(1, self.min.x, self.max.x),
                pick(2, self.min.y, self.max.y),
                pick(4, self.min.z, self.max.z),
            )
        };
        let empty = self.min.x > self.max.x;
        (0..8).filter(move |_| !empty).map(corner)
    }
}

/// Measurements of a block.
#[derive(Clone, Copy, Debug)]
struct Measure {
    /// The larger of the numbers of visited entities and of elements, with all nested inserts expanded.
    elements: u64,
    /// Levels of blocks nested in it.
    height: usize,
    extent: Extent,
}

#[derive(Clone, Copy, Debug)]
enum State {
    New,
    /// The block is being measured, so an insert of it found now means that it contains itself.
    InProgress,
    Done(Measure),
}

/// The size of the model, in drawing units, with blocks expanded.
///
/// # Errors
/// The file has more elements or deeper nesting than `limits` allow.
pub(super) fn size(file: &File<'_>, limits: &Limits) -> Result<DVec2, ReadError> {
    let mut measurer = Measurer { file, limits, states: vec![[State::New; 2]; file.blocks.len()] };
    let model = measurer.entities(&file.model, 0, None)?;
    measurer.check(model.elements, None)?;
    let size = model.extent.max - model.extent.min;
    Ok(if size.x >= 0.0 { size.truncate() } else { DVec2::ZERO })
}

struct Measurer<'f, 'a> {
    file: &'f File<'a>,
    limits: &'f Limits,
    /// Of every block, inserted on a layer that is on and on one that is off.
    states: Vec<[State; 2]>,
}

impl Measurer<'_, '_> {
    /// Measures the entities of the model, or of a block that is inserted on a layer.
    fn entities(
        &mut self,
        entities: &[Entity<'_>],
        depth: usize,
        of_insert: Option<u32>,
    ) -> Result<Measure, ReadError> {
        let mut total = Measure { elements: 0, height: 0, extent: Extent::EMPTY };
        for entity in entities {
            let layer = self.file.layer_of(entity, of_insert);
            match &entity.geometry {
                _ if self.file.hidden(entity, layer).is_some() => {
                    total.elements = total.elements.saturating_add(1);
                }
                Geometry::Insert(insert) => {
                    total.elements = total.elements.saturating_add(1);
                    let Some(block) = insert.block else { continue };
                    let Some(inner) = self.block(block, depth + 1, layer)? else { continue };
                    let [columns, rows] = insert.counts;
                    let cells = u64::from(columns) * u64::from(rows);
                    let elements = inner.elements.saturating_mul(cells);
                    self.check(elements, Some((insert.name, insert.counts)))?;
                    total.elements = total.elements.saturating_add(elements);
                    total.height = total.height.max(inner.height + 1);
                    let base = self.file.blocks.get(block).map_or(DVec3::ZERO, |b| b.base);
                    for (column, row) in placement::corner_cells(insert) {
                        let map = placement::cell(insert, base, column, row);
                        inner.extent.corners().for_each(|p| total.extent.add(map.transform_point3(p)));
                    }
                }
                geometry => {
                    total.elements = total.elements.saturating_add(elements(geometry));
                    each_point(geometry, |p| total.extent.add(p));
                }
            }
        }
        Ok(total)
    }

    /// Measures a block that is inserted on `layer`; `None` when it contains itself.
    fn block(&mut self, index: usize, depth: usize, layer: u32) -> Result<Option<Measure>, ReadError> {
        let Some(block) = self.file.blocks.get(index) else { return Ok(None) };
        let off = usize::from(self.file.layers.get(layer).is_some_and(|l| l.off));
        let state = self.states[index][off];
        let height = if let State::Done(m) = state { m.height } else { 0 };
        if depth + height > self.limits.depth {
            return Err(ReadError::Limit(format!(
                "Blocks are nested more than {} deep at \"{}\". Explode the blocks in the drawing program and save again.",
                self.limits.depth,
                String::from_utf8_lossy(block.name)
            )));
        }
        match state {
            State::Done(measure) => Ok(Some(measure)),
            State::InProgress => Ok(None),
            State::New => {
                self.states[index][off] = State::InProgress;
                let measure = self.entities(&block.entities, depth, Some(layer))?;
                self.states[index][off] = State::Done(measure);
                Ok(Some(measure))
            }
        }
    }

    fn check(&self, elements: u64, insert: Option<(&[u8], [u32; 2])>) -> Result<(), ReadError> {
        let limit = self.limits.elements as u64;
        if elements <= limit {
            return Ok(());
        }
        let what = match insert {
            Some((name, [1, 1])) => format!("The block \"{}\" makes", String::from_utf8_lossy(name)),
            Some((name, [columns, rows])) => format!(
                "The block \"{}\", inserted {columns} x {rows} times, makes",
                String::from_utf8_lossy(name)
            ),
            None => "The drawing makes".to_owned(),
        };
        Err(ReadError::Limit(format!(
            "{what} {elements} elements with all blocks expanded; up to {limit} can be read. Cut fewer copies at once, or delete what is not to be cut."
        )))
    }
}

/// Approximate number of elements an entity makes, good enough for comparison with a limit.
fn elements(geometry: &Geometry<'_>) -> u64 {
    // At a tolerance of 0.01 mm a spline takes a few elements per knot, and an ellipse about eight.
    const PER_CONTROL_POINT: usize = 4;
    const PER_ELLIPSE: usize = 8;
    let n = match geometry {
        Geometry::Polyline { vertices, .. } => vertices.len(),
        Geometry::Polylines3d(chains) => chains.iter().map(|c| c.points.len()).sum(),
        Geometry::Ellipse { .. } => PER_ELLIPSE,
        Geometry::Spline(s) => PER_CONTROL_POINT * s.control.len().max(s.fit.len()),
        Geometry::Hatch { loops, .. } => loops
            .iter()
            .map(|l| match l {
                Loop::Polyline(vertices, _) => vertices.len(),
                Loop::Edges(edges) => PER_ELLIPSE * edges.len(),
            })
            .sum(),
        _ => 1,
    };
    n.max(1) as u64
}

/// Visits points that show the extent of an entity; for curves, a few points on them.
fn each_point(geometry: &Geometry<'_>, mut f: impl FnMut(DVec3)) {
    match geometry {
        Geometry::Line(a, b) => [*a, *b].into_iter().for_each(f),
        Geometry::Arc { center, radius, start, end, normal } => {
            let plane = ocs::axes(*normal);
            let sweep = end.map_or(360.0, |end| (end - start).rem_euclid(360.0));
            for i in 0..=8 {
                let v = ocs::unit_at_degrees(start + sweep * f64::from(i) / 8.0) * *radius;
                f(plane * (*center + v.extend(0.0)));
            }
        }
        Geometry::Polyline { vertices, elevation, normal, .. } => {
            let plane = ocs::plane(*normal, *elevation);
            vertices.iter().for_each(|v| f(plane.transform_point3(v.at.extend(0.0))));
        }
        Geometry::Polylines3d(chains) => chains.iter().flat_map(|c| &c.points).for_each(|p| f(*p)),
        Geometry::Ellipse { center, major, minor, .. } => {
            [*major, -*major, *minor, -*minor].into_iter().for_each(|v| f(*center + v));
        }
        Geometry::Spline(s) => s.control.iter().chain(&s.fit).for_each(|p| f(*p)),
        Geometry::Hatch { loops, elevation, normal, .. } => {
            let plane: DAffine3 = ocs::plane(*normal, *elevation);
            let mut flat = |p: DVec2| f(plane.transform_point3(p.extend(0.0)));
            for l in loops {
                match l {
                    Loop::Polyline(vertices, _) => vertices.iter().for_each(|v| flat(v.at)),
                    Loop::Edges(edges) => edges.iter().for_each(|e| match e {
                        Edge::Line(a, b) => [*a, *b].into_iter().for_each(&mut flat),
                        Edge::Arc(center, ..) => flat(*center),
                        Edge::Ellipse(e) => flat(e.center),
                        Edge::Spline(s) => s.control.iter().chain(&s.fit).for_each(|p| flat(p.truncate())),
                    }),
                }
            }
        }
        Geometry::Insert(_) | Geometry::Other(..) | Geometry::Invalid(..) => {}
    }
}
