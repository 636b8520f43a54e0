//! Writes group codes and values, and assigns the handles that number the objects of a drawing.

use std::fmt::{Display, Write as _};

/// Decimals of a coordinate in mm: one nanometre, far below any joining tolerance.
pub(super) const DECIMALS: usize = 6;
/// First handle for layers and entities, above the fixed handles of the frame.
const FIRST_HANDLE: usize = 0x100;

/// The text of a DXF under construction.
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
    /// Writes one group: its code and value on a line each.
    pub(super) fn put(&mut self, code: u16, value: impl Display) {
        let _ = writeln!(self.text, "{code}\n{value}");
    }

    /// Writes several groups given as lines of `code value`; blanks around each are removed.
    pub(super) fn put_all(&mut self, groups: &str) {
        for group in groups.lines().map(str::trim).filter(|g| !g.is_empty()) {
            let (code, value) = group.split_once(' ').unwrap_or((group, ""));
            let _ = writeln!(self.text, "{code}\n{value}");
        }
    }

    /// Writes a new handle.
    pub(super) fn put_new_handle(&mut self, code: u16) {
        self.put_handle_after(code, 0);
        self.next_handle += 1;
    }

    /// Writes the handle that will be free after `objects` more objects.
    pub(super) fn put_handle_after(&mut self, code: u16, objects: usize) {
        let handle = self.next_handle + objects;
        self.put(code, format_args!("{handle:X}"));
    }

    /// The complete text.
    pub(super) fn into_text(self) -> String {
        self.text
    }
}
