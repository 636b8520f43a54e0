//! Layers: those of the layer table, and those that only entities name.

use super::record::Record;
use rustc_hash::FxHashMap;

/// A layer as read from the file.
#[derive(Clone, Copy, Debug)]
pub(super) struct RawLayer<'a> {
    /// Name as written, not decoded.
    pub(super) name: &'a [u8],
    /// Colour index.
    pub(super) color: i16,
    /// Whether it is frozen, so that neither its entities nor inserts on it are visible.
    pub(super) frozen: bool,
    /// Whether it is off (negative colour), so that its entities are not visible.
    pub(super) off: bool,
}

/// All layers by name. Names are compared without case.
#[derive(Debug, Default)]
pub(super) struct Layers<'a> {
    list: Vec<RawLayer<'a>>,
    as_written: FxHashMap<&'a [u8], u32>,
    folded: FxHashMap<Vec<u8>, u32>,
}

impl<'a> Layers<'a> {
    /// Index of the layer with this name. A layer named for the first time is added, visible and white (7).
    pub(super) fn index(&mut self, name: &'a [u8]) -> u32 {
        if let Some(index) = self.as_written.get(name) {
            return *index;
        }
        let next = u32::try_from(self.list.len()).unwrap_or(u32::MAX);
        let index = *self.folded.entry(name.to_ascii_uppercase()).or_insert(next);
        if index == next {
            self.list.push(RawLayer { name, color: 7, frozen: false, off: false });
        }
        self.as_written.insert(name, index);
        index
    }

    /// Adds or updates a layer from a LAYER record of the table.
    pub(super) fn define(&mut self, record: &Record<'a>) {
        const FROZEN: i64 = 1;
        let Some(name) = record.text(2) else { return };
        let index = self.index(name) as usize;
        if let Some(layer) = self.list.get_mut(index) {
            let color = record.color.unwrap_or(7);
            layer.color = color.unsigned_abs().try_into().unwrap_or(7);
            layer.off = color < 0;
            layer.frozen = record.flag(FROZEN);
        }
    }

    /// The layer at `index`.
    pub(super) fn get(&self, index: u32) -> Option<&RawLayer<'a>> {
        self.list.get(index as usize)
    }

    /// All layers, by index.
    pub(super) fn list(&self) -> &[RawLayer<'a>] {
        &self.list
    }

    /// Index of layer "0", whose entities in a block take the layer of the insert.
    pub(super) const ZERO: u32 = 0;

    /// Adds layer "0", before all others.
    pub(super) fn add_zero(&mut self) {
        self.index(b"0");
    }
}
