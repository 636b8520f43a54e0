//! What must be true for any bytes: the promises of the reader and of the whole intake. Used by the fuzz
//! targets of what they invent, and by the tests of every file that once broke one of them.

use kerfway::drawing::{Drawing, Limits, ReadError, ReadOptions, Unit};
use kerfway::job::problem_of;
use kerfway::{dxf, machine, plan, sheet, solve, svg};

/// Smaller than in life, so that an input is done in milliseconds; the code on the way is the same.
const LIMITS: Limits = Limits { bytes: 1 << 20, elements: 20_000, depth: 16, coordinate: 1e6 };
/// Shapes up to which a sheet is built, and contours up to which it is planned.
const BUILT: usize = 2_000;
const PLANNED: usize = 300;

/// The reader of DXF.
pub fn of_the_reader(data: &[u8]) {
    of_a_reader(data, dxf::read);
}

/// The reader of SVG, whatever the file looks like.
pub fn of_the_svg_reader(data: &[u8]) {
    svg::is_svg(data);
    of_a_reader(data, svg::read);
}

/// A reader: a sentence, or shapes that are finite, joined and on layers that are shown.
fn of_a_reader(data: &[u8], read: fn(&[u8], &ReadOptions) -> Result<Drawing, ReadError>) {
    for (keep_damaged, unit) in [(false, None), (true, Some(Unit::Mm))] {
        let options = ReadOptions { keep_damaged, unit, limits: LIMITS, ..ReadOptions::default() };
        let drawing = match read(data, &options) {
            Ok(drawing) => drawing,
            Err(error) => {
                assert!(!error.to_string().is_empty());
                continue;
            }
        };
        assert!(drawing.shapes.len() <= LIMITS.elements);
        for shape in &drawing.shapes {
            let layer = drawing.layers.get(shape.layer as usize);
            assert!(layer.is_some_and(|l| l.visible), "a shape on a layer that is not shown");
            assert!(!shape.path.segments.is_empty(), "a shape without elements");
            assert!(shape.path.largest_gap() <= 0.0, "elements that do not join");
            let bounds = shape.path.bounds();
            assert!(shape.path.length().is_finite() && bounds.min.is_finite() && bounds.max.is_finite());
            assert!(keep_damaged || !shape.damaged);
        }
        assert!(drawing.findings.iter().all(|f| f.count > 0 && !f.message.is_empty()));
    }
}

/// Reader, contours, parts, problem, greedy order and plan: contours with a length that join and nest, and a plan
/// that its checker passes.
pub fn of_the_intake(data: &[u8]) {
    let options = ReadOptions { unit: Some(Unit::Mm), limits: LIMITS, ..ReadOptions::default() };
    let read = if svg::is_svg(data) { svg::read } else { dxf::read };
    let Ok(drawing) = read(data, &options) else { return };
    if drawing.shapes.iter().map(|s| s.path.segments.len()).sum::<usize>() > BUILT {
        return;
    }
    let sheet = sheet::build(&drawing, &sheet::SheetOptions::default());
    let count = u32::try_from(sheet.contours.len()).unwrap();
    for (i, c) in (0..).zip(&sheet.contours) {
        assert!(c.length > 0.0 && c.length.is_finite() && c.area >= 0.0 && c.area.is_finite());
        assert!(c.path.largest_gap() <= 0.0, "contour {i} does not join");
        assert!((c.layer as usize) < sheet.layers.len());
        assert!(c.inside.is_none_or(|k| k < count && k != i));
        let depth = c.inside.map_or(0, |k| sheet.contours[k as usize].depth + 1);
        assert_eq!(c.depth, depth, "contour {i}");
    }
    for p in &sheet.parts {
        assert!(p.outer < count && p.holes.iter().all(|h| *h < count));
    }
    if sheet.contours.len() > PLANNED {
        return;
    }
    for profile in machine::presets().iter().take(2) {
        let problem = problem_of(&sheet, profile);
        let plan = plan::from_solution(&sheet, &problem, &solve::greedy(&problem));
        if let Err(violations) = plan::check(&sheet, profile, &plan) {
            panic!("{}: {violations:?}", profile.name);
        }
    }
}
