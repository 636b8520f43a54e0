//! From tags to typed entities: sections, tables, blocks.
//!
//! The keyword of a group 0 decides what comes, not the section it stands in: sections, ENDSEC, EOF and the whole
//! header may be missing. Sections that hold no geometry are passed over. Nothing is ever looked up by handle:
//! handles repeat in real files.

mod contents;
mod reader;

pub(super) use contents::File;
use reader::Reader;

/// Reads all of `bytes`.
pub(super) fn read(bytes: &[u8]) -> File<'_> {
    let mut file = File::default();
    file.layers.zero();
    Reader::new(bytes).run(&mut file);
    file.find_blocks();
    file
}
