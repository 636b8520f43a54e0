//! The contents of a file, in drawing units.

use super::clips::Clips;
use crate::dxf::entities::{self, Soundness};
use crate::dxf::entity::{Entity, Geometry, Hidden};
use crate::dxf::header::Header;
use crate::dxf::layers::Layers;
use crate::dxf::record::Record;
use crate::dxf::report::{Note, Notes};
use crate::finding::{Code, Severity};
use glam::DVec3;
use rustc_hash::{FxHashMap, FxHashSet};

/// A block definition.
#[derive(Debug)]
pub(in crate::dxf) struct Block<'a> {
    /// Name as written.
    pub(in crate::dxf) name: &'a [u8],
    /// The base point, which an insert places.
    pub(in crate::dxf) base: DVec3,
    /// Whether a break in the file touches its start, so that its base point may be wrong.
    pub(in crate::dxf) damaged: bool,
    /// Whether it refers to another file, so that it holds nothing itself.
    pub(in crate::dxf) external: bool,
    /// Entities of the block.
    pub(in crate::dxf) entities: Vec<Entity<'a>>,
}

/// Everything read from a file, in drawing units.
#[derive(Debug, Default)]
pub(in crate::dxf) struct File<'a> {
    /// Header variables.
    pub(in crate::dxf) header: Header<'a>,
    /// Layers.
    pub(in crate::dxf) layers: Layers<'a>,
    /// Blocks in order of the file.
    pub(in crate::dxf) blocks: Vec<Block<'a>>,
    /// Entities outside blocks.
    pub(in crate::dxf) model: Vec<Entity<'a>>,
    /// Names of kinds without an outline, see [`Geometry::Other`].
    pub(in crate::dxf) other_names: Vec<&'a [u8]>,
    /// Heights of texts that are not on paper, as far as they are kept.
    pub(in crate::dxf) text_heights: Vec<f64>,
    /// Handles of the inserts that show only a part of their block.
    pub(in crate::dxf) clipped: FxHashSet<&'a [u8]>,
    /// Findings made while reading.
    pub(in crate::dxf) notes: Notes<'a>,
    /// Whether a SECTION, a TABLE or a known entity was found, so that the file is a DXF.
    pub(in crate::dxf) recognised: bool,
    pub(super) clips: Clips<'a>,
    blocks_by_name: FxHashMap<Vec<u8>, usize>,
    other_index: FxHashMap<&'a [u8], u32>,
}

impl<'a> File<'a> {
    /// Sets the block index of every insert.
    pub(super) fn find_blocks(&mut self) {
        let by_name = &self.blocks_by_name;
        for entity in self.model.iter_mut().chain(self.blocks.iter_mut().flat_map(|b| &mut b.entities)) {
            if let Geometry::Insert(insert) = &mut entity.geometry {
                insert.block = by_name.get(&insert.name.to_ascii_uppercase()).copied();
            }
        }
    }

    /// Finds the clipped inserts. What clips an unknown one is a finding for the whole file.
    pub(super) fn find_clipped(&mut self) {
        if self.clips.is_empty() {
            return;
        }
        let entities = self.model.iter().chain(self.blocks.iter().flat_map(|b| &b.entities));
        let inserts = entities.filter(|e| matches!(e.geometry, Geometry::Insert(_))).filter_map(|e| e.handle);
        let (clipped, unknown) = self.clips.inserts(&inserts.collect());
        self.clipped = clipped;
        if unknown > 0 {
            let message = format!(
                "{unknown} blocks or references may be clipped (XCLIP), but are cut whole. Trim them in the drawing program and save again."
            );
            let note = Note::new(Code::UnsupportedEntity, Severity::Warning, message);
            self.notes.push(Note { count: unknown, ..note });
        }
    }

    /// The effective layer of an entity: on layer "0" in a block it is that of the insert.
    pub(in crate::dxf) fn layer_of(&self, entity: &Entity<'_>, of_insert: Option<u32>) -> u32 {
        of_insert.filter(|_| entity.layer == Layers::ZERO).unwrap_or(entity.layer)
    }

    /// Why an entity with this effective layer is not visible. An insert on a layer that is off shows its block.
    pub(in crate::dxf) fn hidden(&self, entity: &Entity<'_>, layer: u32) -> Option<Hidden> {
        let is_insert = matches!(entity.geometry, Geometry::Insert(_));
        match self.layers.get(layer) {
            _ if entity.hidden.is_some() => entity.hidden,
            Some(l) if l.frozen => Some(Hidden::Frozen),
            Some(l) if l.off && !is_insert => Some(Hidden::Off),
            _ => None,
        }
    }

    /// The name of a [`Geometry::Other`].
    pub(in crate::dxf) fn other_name(&self, index: u32) -> &'a [u8] {
        self.other_names.get(index as usize).copied().unwrap_or_default()
    }

    pub(super) fn other(&mut self, name: &'a [u8]) -> u32 {
        let next = u32::try_from(self.other_names.len()).unwrap_or(u32::MAX);
        let index = *self.other_index.entry(name).or_insert(next);
        if index == next {
            self.other_names.push(name);
        }
        index
    }

    pub(super) fn open_block(&mut self, record: &Record<'a>) -> usize {
        const EXTERNAL: i64 = 4;
        let name = record.text(2).or(record.text(3)).unwrap_or_default();
        let index = self.blocks.len();
        self.blocks.push(Block {
            name,
            base: record.point(10).unwrap_or(DVec3::ZERO),
            damaged: record.damaged || entities::check_soundness(record) == Soundness::Broken,
            external: record.flag(EXTERNAL),
            entities: Vec::new(),
        });
        let first = *self.blocks_by_name.entry(name.to_ascii_uppercase()).or_insert(index);
        if first != index {
            self.notes.push(Note {
                handle: record.handle,
                name,
                ..Note::new(
                    Code::InvalidGeometry,
                    Severity::Warning,
                    "The block \"{}\" is defined twice; the first definition is used.",
                )
            });
        }
        index
    }
}
