//! Group codes and values, the alphabet of DXF, and the handles that number the objects of a drawing.

use std::fmt::{Display, Write as _};

/// Decimals of a coordinate, mm: a nanometre, far below any joining tolerance.
pub(super) const DECIMALS: usize = 6;
/// First handle given to layers and entities: above the fixed ones of the frame.
const FIRST_HANDLE: usize = 0x100;

/// A DXF text as it grows.
pub(super) struct Tags {
    text: String,
    next_handle: usize,
}

impl Default for Tags {
    fn default() -> Self {
        Self { text: String::new(), next_handle: FIRST_HANDLE }
    }
}

impl Tags {
    /// One group: code and value, a line each.
    pub(super) fn put(&mut self, code: u16, value: impl Display) {
        let _ = writeln!(self.text, "{code}\n{value}");
    }

    /// Groups as they stand, `code value` a line; blanks around each are cut.
    pub(super) fn put_all(&mut self, groups: &str) {
        for group in groups.lines().map(str::trim).filter(|g| !g.is_empty()) {
            let (code, value) = group.split_once(' ').unwrap_or((group, ""));
            let _ = writeln!(self.text, "{code}\n{value}");
        }
    }

    /// A handle of its own.
    pub(super) fn put_new_handle(&mut self, code: u16) {
        self.put_handle_after(code, 0);
        self.next_handle += 1;
    }

    /// The handle that is free after `objects` more objects.
    pub(super) fn put_handle_after(&mut self, code: u16, objects: usize) {
        let handle = self.next_handle + objects;
        self.put(code, format_args!("{handle:X}"));
    }

    /// The whole text.
    pub(super) fn into_text(self) -> String {
        self.text
    }
}
