//! Converts tags to typed entities: sections, tables, blocks.
//!
//! The keyword of a group 0 decides how a record is read, not its section, because sections, ENDSEC, EOF and the whole
//! header may be missing. Sections without geometry are skipped. No geometry is looked up by handle, because handles
//! repeat in real files.

mod clips;
mod contents;
mod notes;
mod properties;
mod reader;
mod section;

pub(super) use contents::File;
use reader::Reader;

/// Whether something in these bytes is that of a DXF file. Reads no further than that.
pub(super) fn is_recognised(bytes: &[u8]) -> bool {
    let mut file = File::default();
    Reader::new(bytes).run(&mut file, true);
    file.recognised
}

/// Reads the whole file.
pub(super) fn read(bytes: &[u8]) -> File<'_> {
    let mut file = File::default();
    file.layers.add_zero();
    Reader::new(bytes).run(&mut file, false);
    file.find_blocks();
    file.find_clipped();
    file
}
