//! What is read of SVG files agrees with usvg within 0.01 mm: 40 files in the styles of the programs that write them, and
//! 160 made from seeds.
//!
//! usvg resolves styles, copies and transforms with other code, and turns every shape into lines and Bézier curves. Both
//! outlines are sampled, and every sample of one has to lie on the other.
//!
//! `KERFWAY_SVG=FOLDER` compares the files of another folder as well, such as the tests of resvg.
#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]
#![allow(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "counts of samples and cells of a page"
)]

use crate::testkit::{files, fixtures, name, svg_text};
use kerfway::drawing::{Drawing, ReadOptions, Unit};
use kerfway::geometry::{DVec2, Segment};
use kerfway::svg;
use std::collections::HashMap;
use usvg::tiny_skia_path::PathSegment;

/// Largest distance between the two readings, mm.
const AGREES: f64 = 0.01;
/// Distance between samples of an outline, mm.
const STEP: f64 = 0.5;

/// Millimetres for a pixel of usvg.
const PIXEL: f64 = 25.4 / 96.0;

/// Both ends of short straight pieces of what usvg draws, in mm with y up.
fn drawn_by_usvg(text: &str) -> Option<Vec<[DVec2; 2]>> {
    let tree = usvg::Tree::from_str(text, &usvg::Options::default()).ok()?;
    let height = f64::from(tree.size().height());
    let mut pieces = Vec::new();
    collect(tree.root(), height, &mut pieces);
    Some(pieces)
}

fn collect(group: &usvg::Group, height: f64, pieces: &mut Vec<[DVec2; 2]>) {
    for node in group.children() {
        match node {
            usvg::Node::Group(inner) => collect(inner, height, pieces),
            usvg::Node::Path(path) if path.is_visible() => {
                let t = path.abs_transform();
                let place = |x: f32, y: f32| {
                    let [x, y] = [x, y].map(f64::from);
                    let [sx, kx, ky, sy, tx, ty] = [t.sx, t.kx, t.ky, t.sy, t.tx, t.ty].map(f64::from);
                    DVec2::new(sx * x + kx * y + tx, height - (ky * x + sy * y + ty)) * PIXEL
                };
                // A fill closes every subpath, and shows nothing of a single straight line.
                let closing = path.stroke().is_none();
                for one in subpaths(path.data())
                    .filter(|one| !closing || !matches!(one[..], [_, PathSegment::LineTo(_)]))
                {
                    let close = closing && !matches!(one.last(), Some(PathSegment::Close));
                    flatten(one.into_iter().chain(close.then_some(PathSegment::Close)), place, pieces);
                }
            }
            _ => {}
        }
    }
}

/// The parts of a path, each from a move to the next. What follows a closed part without a move begins where that began.
fn subpaths(path: &usvg::tiny_skia_path::Path) -> impl Iterator<Item = Vec<PathSegment>> {
    let mut all: Vec<Vec<PathSegment>> = Vec::new();
    for segment in path.segments() {
        let ended = all.last().is_none_or(|one| matches!(one.last(), Some(PathSegment::Close)));
        match segment {
            PathSegment::MoveTo(_) => all.push(Vec::new()),
            _ if ended => {
                let start = all.last().and_then(|one| one.first().copied());
                all.push(start.into_iter().collect());
            }
            _ => {}
        }
        all.last_mut().unwrap().push(segment);
    }
    all.into_iter()
}

fn flatten(
    segments: impl Iterator<Item = PathSegment>,
    place: impl Fn(f32, f32) -> DVec2,
    pieces: &mut Vec<[DVec2; 2]>,
) {
    let (mut at, mut start) = (DVec2::ZERO, DVec2::ZERO);
    let mut curve = |c: [DVec2; 4]| {
        let length = c.windows(2).map(|w| w[0].distance(w[1])).sum::<f64>();
        // Chords of a tenth of a millimetre are nearer to a curve than a tenth of the tolerance.
        let steps = (length / 0.1).ceil().clamp(8.0, 4000.0) as usize;
        let mut before = c[0];
        for i in 1..=steps {
            let (t, s) = (i as f64 / steps as f64, 1.0 - i as f64 / steps as f64);
            let p =
                c[0] * (s * s * s) + c[1] * (3.0 * s * s * t) + c[2] * (3.0 * s * t * t) + c[3] * (t * t * t);
            pieces.push([before, p]);
            before = p;
        }
    };
    for segment in segments {
        match segment {
            PathSegment::MoveTo(p) => {
                at = place(p.x, p.y);
                start = at;
            }
            PathSegment::LineTo(p) => {
                let to = place(p.x, p.y);
                curve([at, at.lerp(to, 1.0 / 3.0), at.lerp(to, 2.0 / 3.0), to]);
                at = to;
            }
            PathSegment::QuadTo(c, p) => {
                let (c, to) = (place(c.x, c.y), place(p.x, p.y));
                curve([at, at + (c - at) * (2.0 / 3.0), to + (c - to) * (2.0 / 3.0), to]);
                at = to;
            }
            PathSegment::CubicTo(a, b, p) => {
                let to = place(p.x, p.y);
                curve([at, place(a.x, a.y), place(b.x, b.y), to]);
                at = to;
            }
            PathSegment::Close => {
                curve([at, at.lerp(start, 1.0 / 3.0), at.lerp(start, 2.0 / 3.0), start]);
                at = start;
            }
        }
    }
}

/// Elements by the cells of a grid that their boxes touch.
struct Grid {
    segments: Vec<Segment>,
    cells: HashMap<(i64, i64), Vec<usize>>,
}

/// Side of a cell, mm.
const CELL: f64 = 2.0;

impl Grid {
    /// Long elements are divided, so that their boxes touch few cells.
    fn new(elements: &[Segment]) -> Self {
        let divided = |s: &Segment| -> Vec<Segment> {
            let n = (s.length() / CELL).ceil().clamp(1.0, 2000.0) as usize;
            (0..n).map(|i| s.piece(i as f64 / n as f64, (i + 1) as f64 / n as f64)).collect()
        };
        let segments: Vec<Segment> = elements.iter().flat_map(divided).collect();
        let mut cells: HashMap<(i64, i64), Vec<usize>> = HashMap::new();
        for (k, s) in segments.iter().enumerate() {
            let b = s.bounds();
            let (low, high) = (cell(b.min - CELL), cell(b.max + CELL));
            for x in low.0..=high.0 {
                for y in low.1..=high.1 {
                    cells.entry((x, y)).or_default().push(k);
                }
            }
        }
        Self { segments, cells }
    }

    /// Distance of a point from the nearest element, mm; at least the side of a cell if none is in reach.
    fn distance(&self, p: DVec2) -> f64 {
        let near = self.cells.get(&cell(p)).into_iter().flatten();
        near.map(|&k| self.segments[k].nearest(p).1).fold(CELL * CELL, f64::min).sqrt()
    }
}

fn cell(p: DVec2) -> (i64, i64) {
    ((p.x / CELL).floor() as i64, (p.y / CELL).floor() as i64)
}

/// The largest distance from samples of the one outline to the other, both ways, with the place.
fn largest_distance(drawing: &Drawing, pieces: &[[DVec2; 2]]) -> (f64, DVec2) {
    let elements: Vec<Segment> =
        drawing.shapes.iter().flat_map(|s| s.path.segments.iter().copied()).collect();
    // A path that closes where it starts is a dot, which Kerfway reports instead of cutting it.
    let pieces: Vec<[DVec2; 2]> = pieces.iter().filter(|[a, b]| a.distance(*b) > 1e-9).copied().collect();
    let lines: Vec<Segment> = pieces.iter().map(|[a, b]| Segment::line(*a, *b)).collect();
    let (ours, theirs) = (Grid::new(&elements), Grid::new(&lines));
    let mut worst = (0.0, DVec2::ZERO);
    let mut take = |d: f64, p: DVec2| {
        if d > worst.0 {
            worst = (d, p);
        }
    };
    let mut last = DVec2::INFINITY;
    for [a, b] in &pieces {
        if a.distance(last) >= STEP || b.distance(*a) >= STEP {
            take(ours.distance(*a), *a);
            last = *a;
        }
    }
    for s in &elements {
        let steps = (s.length() / STEP).ceil().clamp(1.0, 500.0) as usize;
        for i in 0..=steps {
            let p = s.at(i as f64 / steps as f64);
            take(theirs.distance(p), p);
        }
    }
    worst
}

/// What is wrong with the reading of a file, if anything.
fn difference(text: &str) -> Option<String> {
    // usvg knows 96 pixels to the inch only.
    let is_guess = |d: &Drawing| d.units.unit == Unit::Px && d.units.dpi != Some(96.0);
    let mut options = ReadOptions { tolerance: 0.002, ..ReadOptions::default() };
    let mut drawing = match (svg::read(text.as_bytes(), &options), drawn_by_usvg(text)) {
        (Ok(drawing), Some(_)) => drawing,
        (Err(_), None) => return None,
        (Err(error), Some(pieces)) => return (!pieces.is_empty()).then(|| format!("not read: {error}")),
        (Ok(drawing), None) => {
            return Some(format!("{} shapes that usvg does not read", drawing.shapes.len()));
        }
    };
    if is_guess(&drawing) {
        options.dpi = Some(96.0);
        drawing = svg::read(text.as_bytes(), &options).unwrap();
    }
    let pieces = drawn_by_usvg(text).unwrap();
    let (distance, at) = largest_distance(&drawing, &pieces);
    (distance > AGREES).then(|| format!("{distance:.4} mm at {:.3}, {:.3}", at.x, at.y))
}

#[test]
fn two_hundred_files_agree_with_usvg() {
    let drawn = files(&fixtures().join("svg"), "svg");
    assert!(drawn.len() >= 40, "{}", drawn.len());
    let mut wrong = Vec::new();
    for path in &drawn {
        let text = std::fs::read_to_string(path).unwrap();
        wrong.extend(difference(&text).map(|d| format!("{}: {d}", name(path))));
    }
    for seed in 0..160 {
        let text = svg_text::seeded(seed);
        wrong.extend(difference(&text).map(|d| format!("seed {seed}: {d}")));
    }
    assert!(wrong.is_empty(), "{} of {}:\n{}", wrong.len(), drawn.len() + 160, wrong.join("\n"));
}

#[test]
fn files_of_another_folder_agree_with_usvg() {
    let Some(folder) = std::env::var_os("KERFWAY_SVG") else { return };
    let found = files(std::path::Path::new(&folder), "svg");
    let mut wrong = Vec::new();
    for path in &found {
        let Ok(text) = std::fs::read_to_string(path) else { continue };
        wrong.extend(difference(&text).map(|d| format!("{}: {d}", name(path))));
    }
    assert!(wrong.is_empty(), "{} of {}:\n{}", wrong.len(), found.len(), wrong.join("\n"));
}
