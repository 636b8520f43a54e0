//! Writes a plan as DXF for other cutting software. Contours are in cutting order, each as one polyline that begins at
//! its entry and runs in the direction of the cut. Coordinates are in mm.
//!
//! Software that cuts "in drawing order, as drawn" then cuts the plan. Layers keep their names and colours. Air moves
//! are not in the file, because they would be cut. A contour that is cut in parts becomes one open polyline per part.
//!
//! **Why R2000 (AC1015), ASCII.** It is the oldest version that states its unit ($INSUNITS; R12 cannot, and AutoCAD
//! refuses unknown header variables), that keeps layer names (R12 allows 31 upper-case letters), and that has
//! LWPOLYLINE, one record with bulges per contour. Every DXF reader supports it. The frame around the entities is the
//! minimum that AutoCAD accepts, see [`frame`].
//!
//! An arc is written as a bulge, tan(sweep / 4). Arcs of more than half a turn are divided, so no bulge exceeds 1, and
//! a circle becomes two halves from its entry. Characters outside ASCII are written `\U+XXXX`, which readers of every
//! code page understand.

mod frame;
mod layers;
mod tags;

use super::cuts::{closes, cuts};
use super::sheet_facts::{LayerFacts, SheetFacts};
use crate::geometry::{Aabb, Arc, DVec2, Segment, arcs, math};
use crate::machine::Settings;
use crate::number::fixed;
use crate::plan::Plan;
use layers::Layers;
use std::f64::consts::PI;
use tags::{DECIMALS, Tags};

/// Decimals of a bulge. On a chord of 1 km the last one moves the arc by half a nanometre.
const BULGE_DECIMALS: usize = 12;

/// The contours of a plan as a DXF drawing.
pub fn dxf(plan: &Plan, sheet: &SheetFacts) -> String {
    let layers = Layers::of(sheet);
    let mut tags = Tags::default();
    frame::before_entities(&mut tags, plan.summary.bounds, &layers, cuts(plan).len());
    for cut in cuts(plan) {
        polyline(&mut tags, layers.of_contour(sheet, cut.contour), &cut.path, closes(sheet, &cut));
    }
    frame::after_entities(&mut tags);
    tags.into_text()
}

/// What is left of a sheet as a DXF drawing: its outline on the layer `SHEET`, and what was cut out of it on `CUT OUT`.
pub fn remainder(outlines: &[Vec<Segment>]) -> String {
    let layer = |name: &str, color| LayerFacts { name: name.to_owned(), color, settings: Settings::NONE };
    let sheet = SheetFacts { layers: vec![layer("SHEET", 8), layer("CUT OUT", 1)], contours: Vec::new() };
    let bounds = outlines.iter().flatten().fold(Aabb::EMPTY, |b, s| b.union(s.bounds()));
    let mut tags = Tags::default();
    let [low, high] = [bounds.min, bounds.max];
    frame::before_entities(&mut tags, [low.x, low.y, high.x, high.y], &Layers::of(&sheet), outlines.len());
    for (k, outline) in outlines.iter().enumerate() {
        polyline(&mut tags, if k == 0 { "SHEET" } else { "CUT OUT" }, outline, true);
    }
    frame::after_entities(&mut tags);
    tags.into_text()
}

fn polyline(tags: &mut Tags, layer: &str, path: &[Segment], closed: bool) {
    let mut vertices: Vec<(DVec2, f64)> = Vec::with_capacity(path.len() + 1);
    for segment in path {
        match segment {
            Segment::Line(l) => vertices.push((l.start, 0.0)),
            Segment::Arc(a) => vertices.extend(arcs::split(a, PI).map(|piece| (piece.start, bulge(&piece)))),
        }
    }
    if !closed {
        vertices.extend(path.last().map(|s| (s.end(), 0.0)));
    }

    tags.put(0, "LWPOLYLINE");
    tags.put_new_handle(5);
    tags.put(330, frame::MODEL_SPACE);
    tags.put(100, "AcDbEntity");
    tags.put(8, layer);
    tags.put(100, "AcDbPolyline");
    tags.put(90, vertices.len());
    tags.put(70, u8::from(closed));
    for (at, bulge) in vertices {
        tags.put(10, fixed(at.x, DECIMALS));
        tags.put(20, fixed(at.y, DECIMALS));
        if bulge != 0.0 {
            tags.put(42, fixed(bulge, BULGE_DECIMALS));
        }
    }
}

/// The bulge of an arc of at most half a turn, positive counter-clockwise.
fn bulge(arc: &Arc) -> f64 {
    math::tan(arc.sweep * 0.25)
}
