//! Clipped inserts (XCLIP): which INSERT shows only a part of its block.
//!
//! The boundary is a SPATIAL_FILTER among the objects of the file. It is in a dictionary, which is in the dictionary of
//! the INSERT, so the INSERT is the owner of the owner of its owner. Blocks are not clipped; the insert gets a finding.

use crate::dxf::record::Record;
use rustc_hash::{FxHashMap, FxHashSet};

/// The boundaries found so far, and the owners of dictionaries.
#[derive(Debug, Default)]
pub(super) struct Clips<'a> {
    owners: FxHashMap<&'a [u8], &'a [u8]>,
    /// The owners of all boundaries that are switched on.
    filters: Vec<Option<&'a [u8]>>,
}

impl<'a> Clips<'a> {
    /// Notes a DICTIONARY or a SPATIAL_FILTER.
    pub(super) fn take(&mut self, record: &Record<'a>) {
        if record.name == b"SPATIAL_FILTER" {
            if record.int(71) != Some(0) {
                self.filters.push(record.owner);
            }
        } else if let (Some(handle), Some(owner)) = (record.handle, record.owner) {
            self.owners.insert(handle, owner);
        }
    }

    /// The handles of the clipped inserts among `inserts`, and the number of boundaries of which the insert is unknown.
    pub(super) fn inserts(&self, inserts: &FxHashSet<&'a [u8]>) -> (FxHashSet<&'a [u8]>, u32) {
        let mut unknown = 0;
        let mut found = FxHashSet::default();
        for filter in &self.filters {
            let owner_of = |handle: &'a [u8]| self.owners.get(handle).copied();
            match filter.and_then(owner_of).and_then(owner_of).filter(|h| inserts.contains(h)) {
                Some(insert) => {
                    found.insert(insert);
                }
                None => unknown += 1,
            }
        }
        (found, unknown)
    }

    /// Whether there is no boundary.
    pub(super) fn is_empty(&self) -> bool {
        self.filters.is_empty()
    }
}
