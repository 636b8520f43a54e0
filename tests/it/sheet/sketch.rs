//! Drawings made by hand: paths on layers, without a file.

use kerfway::drawing::{Drawing, Layer, Shape, Unit, Units, UnitsSource};
use kerfway::finding::{Code, Finding};
use kerfway::geometry::{Arc, DVec2, Path, Segment};
use kerfway::sheet::{Sheet, SheetOptions, build};

pub(crate) fn p(x: f64, y: f64) -> DVec2 {
    DVec2::new(x, y)
}

pub(crate) fn line(x0: f64, y0: f64, x1: f64, y1: f64) -> Path {
    Path::new(vec![Segment::line(p(x0, y0), p(x1, y1))], false)
}

pub(crate) fn circle(x: f64, y: f64, r: f64) -> Path {
    circle_from(x, y, r, 0.0)
}

/// A circle whose seam lies at the angle `from`, in rad.
pub(crate) fn circle_from(x: f64, y: f64, r: f64, from: f64) -> Path {
    Path::new(vec![Segment::Arc(Arc::from_angles(p(x, y), r, from, std::f64::consts::TAU))], true)
}

/// An arc from the angle `from` over `sweep`, both in degrees.
pub(crate) fn arc(x: f64, y: f64, r: f64, from: f64, sweep: f64) -> Path {
    Path::new(vec![Segment::Arc(Arc::from_angles(p(x, y), r, from.to_radians(), sweep.to_radians()))], false)
}

pub(crate) fn polyline(points: &[(f64, f64)], closed: bool) -> Path {
    let points: Vec<DVec2> = points.iter().map(|&(x, y)| p(x, y)).collect();
    let mut segments: Vec<_> = points.windows(2).map(|w| Segment::line(w[0], w[1])).collect();
    if closed {
        segments.push(Segment::line(points[points.len() - 1], points[0]));
    }
    Path::new(segments, closed)
}

pub(crate) fn rect(x: f64, y: f64, w: f64, h: f64) -> Path {
    polyline(&[(x, y), (x + w, y), (x + w, y + h), (x, y + h)], true)
}

/// Every element a path of its own.
pub(crate) fn exploded(path: &Path) -> Vec<Path> {
    path.segments.iter().map(|&s| Path::new(vec![s], matches!(s, Segment::Arc(a) if a.is_circle()))).collect()
}

/// A drawing of paths on layers; layers in order of first use.
pub(crate) fn drawing<'a>(shapes: impl IntoIterator<Item = (&'a str, Path)>) -> Drawing {
    let mut layers: Vec<Layer> = Vec::new();
    let mut out = Vec::new();
    for (name, path) in shapes {
        let layer = layers.iter().position(|l| l.name == name).unwrap_or_else(|| {
            layers.push(Layer { name: name.to_owned(), color: 7, visible: true });
            layers.len() - 1
        });
        let kind = match &path.segments[..] {
            [Segment::Line(_)] => "LINE",
            [Segment::Arc(a)] if a.is_circle() => "CIRCLE",
            [Segment::Arc(_)] => "ARC",
            _ => "LWPOLYLINE",
        };
        let handle = Some(format!("{:X}", 0x100 + out.len()));
        out.push(Shape {
            path,
            layer: u32::try_from(layer).unwrap(),
            color: 7,
            handle,
            kind,
            damaged: false,
        });
    }
    let units = Units {
        unit: Unit::Mm,
        dpi: None,
        scale: 1.0,
        source: UnitsSource::Given,
        reason: String::new(),
        doubtful: false,
        confidence: 1.0,
    };
    Drawing { version: None, units, layers, shapes: out, entities: Vec::new(), findings: Vec::new() }
}

/// The sheet of paths on one layer, with default options.
pub(crate) fn sheet(paths: impl IntoIterator<Item = Path>) -> Sheet {
    sheet_with(paths, &SheetOptions::default())
}

pub(crate) fn sheet_with(paths: impl IntoIterator<Item = Path>, options: &SheetOptions) -> Sheet {
    checked(build(&drawing(paths.into_iter().map(|p| ("0", p))), options))
}

/// The sheet of a drawing with the usual options.
pub(crate) fn arranged(drawing: &Drawing) -> Sheet {
    built(drawing, &SheetOptions::default())
}

/// The sheet of a drawing, after checking what is true of every sheet.
pub(crate) fn built(drawing: &Drawing, options: &SheetOptions) -> Sheet {
    checked(build(drawing, options))
}

/// Checks what is true of every sheet: contours are joined bit for bit, oriented, nested without cycles and in drawing order.
pub(crate) fn checked(sheet: Sheet) -> Sheet {
    for (i, c) in sheet.contours.iter().enumerate() {
        assert!(c.path.largest_gap() <= 0.0, "contour {i} is joined bit for bit");
        assert!((c.length - c.path.length()).abs() < 1e-9);
        assert!(c.length > 0.0);
        if c.path.closed {
            let hole = c.operation == kerfway::sheet::Operation::Cut && c.depth % 2 == 1;
            assert_eq!(c.path.area() < 0.0, hole, "contour {i} at depth {} turns the right way", c.depth);
            assert_eq!(c.path.start(), c.path.end());
        } else {
            assert_eq!(c.area > 0.0, c.outline.is_some());
        }
        match c.inside {
            None => assert_eq!(c.depth, 0),
            Some(o) => {
                let o = &sheet.contours[o as usize];
                assert!(o.bounds_area() && o.area > c.area);
                assert_eq!(c.depth, o.depth + 1);
            }
        }
    }
    assert!(sheet.contours.windows(2).all(|w| w[0].first_shape <= w[1].first_shape), "drawing order");
    for part in &sheet.parts {
        let outer = &sheet.contours[part.outer as usize];
        assert!(outer.bounds_area() && outer.depth.is_multiple_of(2));
        assert!(part.holes.iter().all(|&h| sheet.contours[h as usize].inside == Some(part.outer)));
    }
    sheet
}

pub(crate) fn findings(sheet: &Sheet, code: Code) -> Vec<&Finding> {
    sheet.findings.iter().filter(|f| f.code == code).collect()
}

/// Closed contours, open contours.
pub(crate) fn counts(sheet: &Sheet) -> (usize, usize) {
    let closed = sheet.contours.iter().filter(|c| c.path.closed).count();
    (closed, sheet.contours.len() - closed)
}

pub(crate) fn total_length(sheet: &Sheet) -> f64 {
    sheet.contours.iter().map(|c| c.length).sum()
}

#[track_caller]
pub(crate) fn close(a: f64, b: f64) {
    assert!((a - b).abs() < 1e-6, "{a} is not {b}");
}
