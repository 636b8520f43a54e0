//! Draws a plan as PNG with tiny-skia, from the text of its [document](crate::plan::document).
//!
//! The input is text and not a document in memory, because this module is in a wasm file of its own (feature `png`),
//! which is loaded only when a picture is requested. The ground is white, cuts are dark, marks blue, leads green, joints purple, air moves thin,
//! dashed and orange, and entries are dots: the colours of the SVG on white.

mod frame;

use crate::geometry::{Aabb, Arc, Segment, arcs, math};
use crate::machine::CornerKind;
use crate::plan::document::{Document, Stroke as Drawn, strokes};
use crate::sheet::Operation;
use frame::Frame;
use std::f64::consts::FRAC_PI_4;
use tiny_skia::{
    Color, FillRule, LineCap, LineJoin, Paint, Path, PathBuilder, Pixmap, Stroke, StrokeDash, Transform,
};

/// Smallest and largest width of a picture, px.
pub const WIDTHS: std::ops::RangeInclusive<u32> = 64..=8192;

const INK: [u8; 3] = [0x1b, 0x1f, 0x24];
const BLUE: [u8; 3] = [0x25, 0x63, 0xc9];
const GREEN: [u8; 3] = [0x1a, 0x8f, 0x5a];
const PURPLE: [u8; 3] = [0xb3, 0x26, 0x7a];
const ORANGE: [u8; 3] = [0xc2, 0x57, 0x1a];

/// Width of contours and of air moves, and radius of entries, in line px ([`Frame::line_px`]).
const CONTOUR_WIDTH: f32 = 1.8;
const JOINT_WIDTH: f32 = 4.0;
const AIR_WIDTH: f32 = 1.0;
const ENTRY_RADIUS: f32 = 3.0;
/// Dash and gap of air moves, in line px.
const DASH: [f32; 2] = [6.0, 4.0];

/// Largest sweep drawn as one cubic. It deviates from the arc by 4e-6 of the radius, 0.03 px in the largest picture.
const LARGEST_SWEEP: f64 = FRAC_PI_4;

/// Draws the plan in `plan_json` as a PNG file `width` px wide ([`WIDTHS`]), with the height that the sheet needs. An
/// error is a sentence for people. No picture has more than 33.5 million px; a higher sheet is drawn smaller.
pub fn render(plan_json: &str, width: u32) -> Result<Vec<u8>, String> {
    if !WIDTHS.contains(&width) {
        return Err(format!(
            "A picture cannot be {width} pixels wide. Choose {} to {}.",
            WIDTHS.start(),
            WIDTHS.end()
        ));
    }
    let document = Document::read(plan_json)?;
    let strokes = strokes(&document);
    let frame = Frame::around(bounds(&document, &strokes), width)
        .ok_or("The plan has no size that can be drawn: a coordinate is out of range.")?;
    let mut pixels =
        Pixmap::new(frame.width, frame.height).ok_or("There is not enough memory for the picture.")?;
    pixels.fill(Color::WHITE);
    draw(&mut pixels, &document, &strokes, &frame);
    pixels.encode_png().map_err(|_| "The picture could not be written.".to_owned())
}

/// The box of everything that is drawn, mm.
fn bounds(document: &Document, strokes: &[Drawn]) -> Aabb {
    strokes.iter().fold(Aabb::of(document.machine.home()), |b, stroke| match stroke {
        Drawn::Air { to, .. } => b.with(*to),
        Drawn::Beam { path, .. }
        | Drawn::Joint { path, .. }
        | Drawn::Fly { path }
        | Drawn::Chain { path } => path.iter().fold(b, |b, s| b.union(s.bounds())),
    })
}

fn draw(pixels: &mut Pixmap, document: &Document, strokes: &[Drawn], frame: &Frame) {
    let px = frame.line_px();
    let [mut cuts, mut marks, mut leads, mut joints, mut air, mut entries] =
        [(); 6].map(|()| PathBuilder::new());
    // A pre-cut is a cut.
    let is_mark =
        |id: u32| document.contours.get(id as usize).is_some_and(|c| c.operation == Operation::Mark);
    for stroke in strokes {
        match stroke {
            Drawn::Air { from, to } => {
                move_to(&mut air, frame.place(*from));
                line_to(&mut air, frame.place(*to));
            }
            Drawn::Fly { path } => trace(&mut air, frame, path),
            Drawn::Chain { path } => trace(&mut leads, frame, path),
            Drawn::Joint { path, .. } => trace(&mut joints, frame, path),
            Drawn::Beam { contour, path, leads: parts, turns } => {
                let to = if contour.is_some_and(is_mark) { &mut marks } else { &mut cuts };
                trace(to, frame, path);
                let [lead_in, _, overcut, lead_out] = parts.divide(path);
                [lead_in, overcut, lead_out].into_iter().for_each(|part| trace(&mut leads, frame, part));
                let loops = turns.iter().filter(|turn| turn.kind == CornerKind::Loop);
                loops.for_each(|turn| trace(&mut leads, frame, turn.of(path)));
                if let Some(first) = path.first() {
                    let (x, y) = frame.place(first.start());
                    entries.push_circle(x, y, ENTRY_RADIUS * px);
                }
            }
        }
    }

    for [from, to] in document.bridges.iter().flat_map(|strip| strip.sides) {
        move_to(&mut leads, frame.place(from));
        line_to(&mut leads, frame.place(to));
    }

    let contour = Stroke { width: CONTOUR_WIDTH * px, line_join: LineJoin::Round, ..Stroke::default() };
    line(pixels, cuts, INK, &contour);
    line(pixels, marks, BLUE, &contour);
    line(pixels, leads, GREEN, &contour);
    line(pixels, joints, PURPLE, &Stroke { width: JOINT_WIDTH * px, ..contour.clone() });
    let dash = StrokeDash::new(DASH.map(|d| d * px).to_vec(), 0.0);
    let dashed = Stroke { width: AIR_WIDTH * px, line_cap: LineCap::Butt, dash, ..Stroke::default() };
    line(pixels, air, ORANGE, &dashed);
    if let Some(dots) = entries.finish() {
        pixels.fill_path(&dots, &paint(ORANGE), FillRule::Winding, Transform::identity(), None);
    }
}

fn line(pixels: &mut Pixmap, path: PathBuilder, color: [u8; 3], stroke: &Stroke) {
    let path: Option<Path> = path.finish();
    if let Some(path) = path {
        pixels.stroke_path(&path, &paint(color), stroke, Transform::identity(), None);
    }
}

fn paint([r, g, b]: [u8; 3]) -> Paint<'static> {
    let mut paint = Paint::default();
    paint.set_color_rgba8(r, g, b, 255);
    paint
}

/// Adds a chain of elements to a path: lines as lines, arcs as cubics.
fn trace(to: &mut PathBuilder, frame: &Frame, path: &[Segment]) {
    let Some(first) = path.first() else { return };
    move_to(to, frame.place(first.start()));
    for segment in path {
        match segment {
            Segment::Line(l) => line_to(to, frame.place(l.end)),
            Segment::Arc(a) => arcs::split(a, LARGEST_SWEEP).for_each(|piece| cubic_to(to, frame, &piece)),
        }
    }
}

/// The cubic with the ends, tangents and middle of a short arc. Its handles are 4/3 tan(sweep / 4) radii long.
fn cubic_to(to: &mut PathBuilder, frame: &Frame, arc: &Arc) {
    let handle = 4.0 / 3.0 * math::tan(arc.sweep * 0.25);
    let (a, b) = (arc.start - arc.center, arc.end - arc.center);
    let (c1, c2) = (frame.place(arc.start + a.perp() * handle), frame.place(arc.end - b.perp() * handle));
    let end = frame.place(arc.end);
    to.cubic_to(c1.0, c1.1, c2.0, c2.1, end.0, end.1);
}

fn move_to(path: &mut PathBuilder, (x, y): (f32, f32)) {
    path.move_to(x, y);
}

fn line_to(path: &mut PathBuilder, (x, y): (f32, f32)) {
    path.line_to(x, y);
}
