//! Reads a file of any format that is known by its content. A name may lie, so it is not looked at.

use crate::drawing::{Drawing, ReadError, ReadOptions};
use crate::{dxf, svg};

/// Whether a file is SVG, by its first 256 kB.
pub fn is_svg(head: &[u8]) -> bool {
    svg::is_svg(head)
}

/// Reads a drawing: SVG, or DXF. For a file of another format the error names it and says what to do.
pub(super) fn read(bytes: &[u8], options: &ReadOptions) -> Result<Drawing, ReadError> {
    if !svg::is_svg(bytes) {
        return dxf::read(bytes, options);
    }
    // Without the feature, the compiler leaves the reader out.
    if cfg!(feature = "svg") {
        return svg::read(bytes, options);
    }
    let message = "This is an SVG file, which this build of Kerfway does not read. Use the whole package, or save the drawing as DXF.";
    Err(ReadError::NotADrawing(message.into()))
}
