//! Any bytes through the whole intake: reader, contours, parts, problem, greedy order, plan, and its check.

#![no_main]

use kerfway::dxf::{Limits, ReadOptions, Unit, read};
use kerfway::{machine, plan, problem, sheet, solve};
use libfuzzer_sys::fuzz_target;

/// Smaller than in life, so that an input is done in milliseconds.
const LIMITS: Limits = Limits { bytes: 1 << 20, elements: 4_000, depth: 16, coordinate: 1e6 };
/// Contours up to which a plan is made.
const PLANNED: usize = 300;

fuzz_target!(|data: &[u8]| {
    let options = ReadOptions { unit: Some(Unit::Mm), limits: LIMITS, ..ReadOptions::default() };
    let Ok(drawing) = read(data, &options) else { return };
    let sheet = sheet::build(&drawing, &sheet::SheetOptions::default());
    let count = u32::try_from(sheet.contours.len()).unwrap();
    for (i, c) in sheet.contours.iter().enumerate() {
        assert!(c.length > 0.0 && c.length.is_finite() && c.area >= 0.0 && c.area.is_finite());
        assert!(c.path.largest_gap() == 0.0, "contour {i} does not join");
        assert!((c.layer as usize) < sheet.layers.len());
        assert!(c.inside.is_none_or(|k| k < count && k as usize != i));
        let around = c.inside.map_or(0, |k| sheet.contours[k as usize].depth + 1);
        assert!(c.depth == around, "contour {i} at depth {} inside one at depth {around} - 1", c.depth);
    }
    for p in &sheet.parts {
        assert!(p.outer < count && p.holes.iter().all(|h| *h < count));
    }
    if sheet.contours.len() > PLANNED {
        return;
    }
    for profile in machine::presets().iter().take(2) {
        let problem = problem::from_sheet(&sheet, profile);
        let solution = solve::greedy(&problem);
        let plan = plan::from_solution(&sheet, &problem, &solution);
        if let Err(violations) = plan::check(&sheet, profile, &plan) {
            panic!("{violations:?}");
        }
    }
});
