//! Any bytes through the DXF reader: no panic, no hang, and whatever comes out keeps the promises of `Drawing`.

#![no_main]

use kerfway::dxf::{Limits, ReadOptions, Unit, read};
use libfuzzer_sys::fuzz_target;

/// Smaller than in life, so that an input is done in milliseconds; the code on the way is the same.
const LIMITS: Limits = Limits { bytes: 1 << 20, elements: 20_000, depth: 16, coordinate: 1e6 };

fuzz_target!(|data: &[u8]| {
    for (keep_damaged, unit) in [(false, None), (true, Some(Unit::Mm))] {
        let options = ReadOptions { keep_damaged, unit, limits: LIMITS, ..ReadOptions::default() };
        match read(data, &options) {
            Err(error) => assert!(!error.to_string().is_empty()),
            Ok(drawing) => {
                assert!(drawing.shapes.len() <= LIMITS.elements);
                for shape in &drawing.shapes {
                    let layer = drawing.layers.get(shape.layer as usize);
                    assert!(layer.is_some_and(|l| l.visible), "a shape on a layer that is not shown");
                    assert!(!shape.path.segments.is_empty(), "a shape without elements");
                    assert!(shape.path.largest_gap() == 0.0, "elements that do not join");
                    assert!(shape.path.length().is_finite());
                    let bounds = shape.path.bounds();
                    assert!(bounds.min.is_finite() && bounds.max.is_finite());
                    assert!(keep_damaged || !shape.damaged);
                }
                assert!(drawing.findings.iter().all(|f| f.count > 0 && !f.message.is_empty()));
            }
        }
    }
});
