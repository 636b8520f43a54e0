//! Expands blocks: every visible entity becomes shapes at its place, with its effective layer and colour.
//!
//! An entity on layer "0" in a block takes the layer of the insert, and colour BYBLOCK takes that of the insert. A
//! frozen layer hides an insert with everything in it; a layer that is off hides only its own entities.

use super::entity::{BY_BLOCK, BY_LAYER, Entity, Geometry, Insert};
use super::file::File;
use super::report::{Note, Notes, Subject};
use super::{placement, trace};
use crate::drawing::{ReadError, ReadOptions, Shape};
use crate::finding::{Code, Severity};
use glam::{DAffine3, DVec2, DVec3};

/// Expands the model of `file` onto the sheet; `scale` is the length of one drawing unit in mm.
///
/// # Errors
/// The drawing makes more elements than the limits of `options` allow.
pub(super) fn shapes<'a>(
    file: &File<'a>,
    scale: f64,
    options: &ReadOptions,
    notes: &mut Notes<'a>,
) -> Result<Vec<Shape>, ReadError> {
    let mut expander = Expander {
        file,
        options,
        notes,
        shapes: Vec::new(),
        visited: 0,
        elements: 0,
        open: Vec::new(),
        far: 0,
    };
    let root =
        Placement { to_sheet: DAffine3::from_scale(DVec3::splat(scale)), layer: None, color: BY_LAYER };
    expander.entities(&file.model, &root)?;
    if expander.shapes.is_empty() && expander.far > 0 {
        return Err(ReadError::Limit(format!(
            "Everything in the drawing lies more than {} m from its origin. Check the units, or move the drawing to the origin and save again.",
            options.limits.coordinate / 1000.0
        )));
    }
    Ok(expander.shapes)
}

/// Where a block, or the model, is placed.
struct Placement {
    to_sheet: DAffine3,
    /// Layer of the insert; `None` in model space.
    layer: Option<u32>,
    /// Resolved colour of the insert.
    color: i16,
}

struct Expander<'f, 'a, 'n> {
    file: &'f File<'a>,
    options: &'f ReadOptions,
    notes: &'n mut Notes<'a>,
    shapes: Vec<Shape>,
    visited: usize,
    elements: usize,
    /// Indices of the blocks around the current entity, to find blocks that contain themselves.
    open: Vec<usize>,
    far: usize,
}

impl<'a> Expander<'_, 'a, '_> {
    fn entities(&mut self, entities: &[Entity<'a>], place: &Placement) -> Result<(), ReadError> {
        entities.iter().try_for_each(|e| self.entity(e, place))
    }

    fn entity(&mut self, entity: &Entity<'a>, place: &Placement) -> Result<(), ReadError> {
        self.visited += 1;
        self.check()?;
        let layer = self.file.layer_of(entity, place.layer);
        let at = || first_point(&entity.geometry).map(|p| place.to_sheet.transform_point3(p).truncate());
        if let Some(why) = self.file.hidden(entity, layer) {
            self.notes.count(Subject::Hidden(why), layer, entity.handle, at());
            return Ok(());
        }
        if let Geometry::Other(name, _) = entity.geometry {
            self.notes.count(Subject::Unsupported(self.file.other_name(name)), layer, entity.handle, at());
            return Ok(());
        }
        let damaged = entity.damaged || self.inserts_damaged_block(entity);
        if damaged {
            self.damaged(entity, layer, at());
            if !self.options.keep_damaged {
                return Ok(());
            }
        } else if let Some(what) = entity.assumed {
            self.note(entity, layer, at(), Code::InvalidGeometry, format!("{}: {what}.", name(entity)));
        }
        let color = match entity.color {
            BY_BLOCK if place.layer.is_some() => place.color,
            BY_BLOCK | BY_LAYER => self.file.layers.get(layer).map_or(7, |l| l.color),
            color => color,
        };
        match &entity.geometry {
            Geometry::Insert(insert) => {
                self.insert(entity, insert, &Placement { layer: Some(layer), color, ..*place })
            }
            Geometry::Invalid(why, _) => {
                self.invalid(entity, layer, at(), why);
                Ok(())
            }
            geometry => {
                match trace::outline(geometry, &place.to_sheet, self.options.tolerance) {
                    Err(why) => self.invalid(entity, layer, at(), &why),
                    Ok(outline) => {
                        if outline.tilted {
                            self.notes.count(Subject::Projected(entity.kind), layer, entity.handle, at());
                        }
                        if matches!(entity.kind, "SOLID" | "TRACE" | "3DFACE" | "HATCH") {
                            self.notes.count(Subject::Outline(entity.kind), layer, entity.handle, at());
                        }
                        if matches!(geometry, Geometry::Hatch { incomplete: true, .. }) {
                            let what = "an edge of its boundary lacks a value and is left out";
                            self.note(
                                entity,
                                layer,
                                at(),
                                Code::InvalidGeometry,
                                format!("{}: {what}.", name(entity)),
                            );
                        }
                        if matches!(geometry, Geometry::Polyline { wide: true, .. }) {
                            self.notes.count(Subject::Wide(entity.kind), layer, entity.handle, at());
                        }
                        for path in outline.paths {
                            self.shape(entity, layer, color, path, at);
                        }
                    }
                }
                self.check()
            }
        }
    }

    fn shape(
        &mut self,
        entity: &Entity<'a>,
        layer: u32,
        color: i16,
        path: crate::geometry::Path,
        at: impl Fn() -> Option<DVec2>,
    ) {
        if path.segments.is_empty() {
            return self.invalid(entity, layer, at(), "it has no length");
        }
        let bounds = path.bounds();
        let limits = &self.options.limits;
        if !(limits.is_near(bounds.min) && limits.is_near(bounds.max)) {
            self.far += 1;
            let limit = limits.coordinate;
            let why = format!("it reaches farther than {} m from the origin", limit / 1000.0);
            return self.invalid(entity, layer, path.start(), &why);
        }
        self.elements += path.segments.len();
        self.shapes.push(Shape {
            path,
            layer,
            color,
            handle: entity.handle.map(|h| String::from_utf8_lossy(h).into_owned()),
            kind: entity.kind,
            damaged: entity.damaged,
        });
    }

    fn insert(
        &mut self,
        entity: &Entity<'a>,
        insert: &Insert<'a>,
        place: &Placement,
    ) -> Result<(), ReadError> {
        let layer = place.layer.unwrap_or(entity.layer);
        let at = place.to_sheet.transform_point3(super::ocs::axes(insert.normal) * insert.at).truncate();
        let file = self.file;
        let found = insert.block.and_then(|i| file.blocks.get(i).map(|b| (i, b)));
        let Some((index, block)) = found else {
            self.notes.count(Subject::MissingBlock(insert.name), layer, entity.handle, Some(at));
            return Ok(());
        };
        if self.open.contains(&index) {
            self.notes.count(Subject::CyclicBlock(insert.name), layer, entity.handle, Some(at));
            return Ok(());
        }
        if entity.handle.is_some_and(|handle| file.clipped.contains(handle)) {
            self.notes.count(Subject::ClippedBlock(insert.name), layer, entity.handle, Some(at));
        }
        if block.entities.is_empty() {
            if block.external {
                self.notes.count(Subject::ExternalBlock(insert.name), layer, entity.handle, Some(at));
            }
            return Ok(());
        }
        self.open.push(index);
        let [columns, rows] = insert.counts;
        for row in 0..rows {
            for column in 0..columns {
                let to_sheet = place.to_sheet * placement::cell(insert, block.base, column, row);
                self.entities(&block.entities, &Placement { to_sheet, ..*place })?;
            }
        }
        self.open.pop();
        Ok(())
    }

    fn damaged(&mut self, entity: &Entity<'a>, layer: u32, at: Option<DVec2>) {
        let fate = if self.options.keep_damaged {
            "It is cut nevertheless, as requested"
        } else {
            "It is left out; compare it with the original"
        };
        let message = format!("{} was read where the file is broken and may be wrong. {fate}.", name(entity));
        self.note(entity, layer, at, Code::DamagedEntity, message);
    }

    fn invalid(&mut self, entity: &Entity<'a>, layer: u32, at: Option<DVec2>, why: &str) {
        let message = format!("{} cannot be cut: {why}.", name(entity));
        self.note(entity, layer, at, Code::InvalidGeometry, message);
    }

    fn note(&mut self, entity: &Entity<'a>, layer: u32, at: Option<DVec2>, code: Code, message: String) {
        let note = Note::new(code, Severity::Warning, message);
        self.notes.push(Note { layer: Some(layer), handle: entity.handle, at, ..note });
    }

    fn inserts_damaged_block(&self, entity: &Entity<'a>) -> bool {
        let Geometry::Insert(insert) = &entity.geometry else { return false };
        insert.block.and_then(|i| self.file.blocks.get(i)).is_some_and(|b| b.damaged)
    }

    /// Compares the exact number of elements with the limit; the earlier measurement was an estimate.
    fn check(&self) -> Result<(), ReadError> {
        let limit = self.options.limits.elements;
        if self.elements.max(self.visited) <= limit {
            return Ok(());
        }
        Err(ReadError::Limit(format!(
            "The drawing makes more than {limit} elements with all blocks expanded and curves turned into lines and arcs. Delete what is not to be cut."
        )))
    }
}

fn name(entity: &Entity<'_>) -> &'static str {
    if entity.kind.is_empty() { "An entity" } else { entity.kind }
}

/// A point of an entity, in the coordinates of its block.
fn first_point(geometry: &Geometry<'_>) -> Option<DVec3> {
    match geometry {
        Geometry::Line(a, _) => Some(*a),
        Geometry::Arc { center, normal, .. } => Some(super::ocs::axes(*normal) * *center),
        Geometry::Polyline { vertices, elevation, normal, .. } => {
            vertices.first().map(|v| super::ocs::axes(*normal) * v.at.extend(*elevation))
        }
        Geometry::Polylines3d(chains) => chains.first().and_then(|c| c.points.first()).copied(),
        Geometry::Ellipse { center, .. } => Some(*center),
        Geometry::Spline(s) => s.control.first().or(s.fit.first()).copied(),
        Geometry::Insert(i) => Some(super::ocs::axes(i.normal) * i.at),
        Geometry::Hatch { loops, elevation, normal, .. } => {
            let p = loops.first().and_then(|l| match l {
                super::entity::Loop::Polyline(vertices, _) => vertices.first().map(|v| v.at),
                super::entity::Loop::Edges(edges) => edges.first().and_then(|e| match e {
                    super::entity::Edge::Line(a, _) => Some(*a),
                    super::entity::Edge::Arc(c, ..) => Some(*c),
                    super::entity::Edge::Ellipse(e) => Some(e.center),
                    super::entity::Edge::Spline(s) => {
                        s.control.first().or(s.fit.first()).map(|p| p.truncate())
                    }
                }),
            })?;
            Some(super::ocs::axes(*normal) * p.extend(*elevation))
        }
        Geometry::Other(_, p) | Geometry::Invalid(_, p) => *p,
    }
}
