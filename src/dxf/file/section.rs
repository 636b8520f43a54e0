//! The sections of a file.

use crate::dxf::tag::Tag;

/// Kind of section that the reader is in.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Section {
    /// Outside all sections, or the line that opened the section is missing.
    Unknown,
    Header,
    Tables,
    /// An entity outside a block in this section has lost the start of its block.
    Blocks,
    Entities,
    /// Where the boundaries of clipped inserts are.
    Objects,
    /// A section without geometry.
    Other,
}

impl Section {
    /// Whether what stands in it is drawn.
    pub(super) fn holds_entities(self) -> bool {
        matches!(self, Self::Blocks | Self::Entities)
    }

    /// The section that a tag names.
    pub(super) fn named_by(tag: &Tag<'_>) -> Self {
        match tag.text() {
            Some(b"HEADER") => Self::Header,
            Some(b"TABLES") => Self::Tables,
            Some(b"BLOCKS") => Self::Blocks,
            Some(b"ENTITIES") => Self::Entities,
            Some(b"OBJECTS") => Self::Objects,
            Some(b"CLASSES" | b"THUMBNAILIMAGE" | b"ACDSDATA") => Self::Other,
            _ => Self::Unknown,
        }
    }
}
