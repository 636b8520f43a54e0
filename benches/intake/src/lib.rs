//! What `npm run bench -- intake` measures, for wasm and native alike: each function does one stage and returns a count
//! that shows it did it.

use kerfway::drawing::{Drawing, ReadOptions};
use kerfway::{dxf, sheet, svg};
use std::io::Cursor;
use wasm_bindgen::prelude::wasm_bindgen;

/// Reads with Kerfway's reader; lines and arcs found, 0 when the file is refused.
#[wasm_bindgen]
pub fn read_kerfway(bytes: &[u8]) -> usize {
    let drawing = dxf::read(bytes, &ReadOptions::default());
    drawing.map_or(0, |d| d.shapes.iter().map(|s| s.path.segments.len()).sum())
}

/// Reads an SVG file; lines and arcs found, 0 when the file is refused.
#[wasm_bindgen]
pub fn read_svg(bytes: &[u8]) -> usize {
    let drawing = svg::read(bytes, &ReadOptions::default());
    drawing.map_or(0, |d| d.shapes.iter().map(|s| s.path.segments.len()).sum())
}

/// Reads with the `dxf` crate; entities found, 0 when the file is refused.
#[wasm_bindgen]
pub fn read_dxf_crate(bytes: &[u8]) -> usize {
    ::dxf::Drawing::load(&mut Cursor::new(bytes)).map_or(0, |d| d.entities().count())
}

/// A drawing that has been read, to be assembled as often as wanted.
#[wasm_bindgen]
pub struct Read(Drawing);

#[wasm_bindgen]
impl Read {
    /// Reads; `undefined` when the file is refused.
    pub fn open(bytes: &[u8]) -> Option<Read> {
        dxf::read(bytes, &ReadOptions::default()).ok().map(Read)
    }

    /// Joins, cleans and nests; contours found.
    pub fn assemble(&self) -> usize {
        sheet::build(&self.0, &sheet::SheetOptions::default()).contours.len()
    }
}
