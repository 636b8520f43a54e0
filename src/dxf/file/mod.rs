//! From tags to typed entities: sections, tables, blocks.
//!
//! The keyword of a group 0 decides what comes, not the section it stands in: sections, ENDSEC, EOF and the whole
//! header may be missing. Sections that hold no geometry are passed over. Nothing is ever looked up by handle:
//! handles repeat in real files.

mod reader;

use super::entities::{self, Soundness};
use super::entity::{Entity, Form};
use super::header::Header;
use super::layers::Layers;
use super::record::Record;
use super::report::{Note, Notes};
use crate::finding::{Code, Severity};
use glam::DVec3;
use reader::Reader;
use rustc_hash::FxHashMap;

/// A block definition.
#[derive(Debug)]
pub(super) struct Block<'a> {
    /// Name as written.
    pub(super) name: &'a [u8],
    /// The point of it that an insert puts in place.
    pub(super) base: DVec3,
    /// A break in the file touches its start: its base point may be wrong.
    pub(super) damaged: bool,
    /// Refers to another file; holds nothing itself.
    pub(super) external: bool,
    /// What it holds.
    pub(super) entities: Vec<Entity<'a>>,
}

/// Everything read from a file, in the units of the drawing.
#[derive(Debug, Default)]
pub(super) struct File<'a> {
    /// Header variables.
    pub(super) header: Header<'a>,
    /// Layers.
    pub(super) layers: Layers<'a>,
    /// Blocks in order of the file.
    pub(super) blocks: Vec<Block<'a>>,
    /// Entities outside blocks.
    pub(super) model: Vec<Entity<'a>>,
    /// Names of kinds without an outline, see [`Form::Other`].
    pub(super) other_names: Vec<&'a [u8]>,
    /// What was noticed while reading.
    pub(super) notes: Notes<'a>,
    /// A SECTION, a TABLE or a known entity was met: it is a DXF.
    pub(super) recognised: bool,
    blocks_by_name: FxHashMap<Vec<u8>, usize>,
    other_index: FxHashMap<&'a [u8], u32>,
}

impl<'a> File<'a> {
    /// Reads all of `bytes`.
    pub(super) fn read(bytes: &'a [u8]) -> Self {
        let mut file = Self::default();
        file.layers.zero();
        Reader::new(bytes).run(&mut file);
        file.find_blocks();
        file
    }

    /// Tells every insert where its block is.
    fn find_blocks(&mut self) {
        let by_name = &self.blocks_by_name;
        for entity in self.model.iter_mut().chain(self.blocks.iter_mut().flat_map(|b| &mut b.entities)) {
            if let Form::Insert(insert) = &mut entity.form {
                insert.block = by_name.get(&insert.name.to_ascii_uppercase()).copied();
            }
        }
    }

    /// The name behind [`Form::Other`].
    pub(super) fn other_name(&self, index: u32) -> &'a [u8] {
        self.other_names.get(index as usize).copied().unwrap_or_default()
    }

    fn other(&mut self, name: &'a [u8]) -> u32 {
        let next = u32::try_from(self.other_names.len()).unwrap_or(u32::MAX);
        let index = *self.other_index.entry(name).or_insert(next);
        if index == next {
            self.other_names.push(name);
        }
        index
    }

    fn open_block(&mut self, record: &Record<'a>) -> usize {
        const EXTERNAL: i64 = 4;
        let name = record.text(2).or(record.text(3)).unwrap_or_default();
        let index = self.blocks.len();
        self.blocks.push(Block {
            name,
            base: record.point(10).unwrap_or(DVec3::ZERO),
            damaged: record.damaged || entities::judge(record) == Soundness::Broken,
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
