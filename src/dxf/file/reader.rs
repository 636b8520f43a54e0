//! Reads the records of a file one after the other, and tracks the section they are in.

use super::contents::File;
use super::notes::{note_breaks, note_end};
use super::properties::with_properties;
use super::section::Section;
use crate::dxf::entities::{self, Gathering, Soundness};
use crate::dxf::entity::{Entity, Geometry, Hidden};
use crate::dxf::ocs;
use crate::dxf::record::Record;
use crate::dxf::report::Note;
use crate::dxf::tokens::Tokens;
use crate::finding::{Code, Severity};

/// How the names of the blocks of paper layouts begin: the active one is `*Paper_Space`, others have a number.
const LAYOUT: &[u8] = b"*PAPER_SPACE";

/// Number of texts whose heights are kept, as hints at the unit.
const TEXTS: usize = 500;

pub(super) struct Reader<'a> {
    tokens: Tokens<'a>,
    section: Section,
    block: Option<usize>,
    polyline: Option<(Entity<'a>, Gathering)>,
    ended: bool,
}

impl<'a> Reader<'a> {
    pub(super) fn new(bytes: &'a [u8]) -> Self {
        Self {
            tokens: Tokens::new(bytes),
            section: Section::Unknown,
            block: None,
            polyline: None,
            ended: false,
        }
    }

    /// Reads all records into `file`, or those `until_recognised`.
    pub(super) fn run(mut self, file: &mut File<'a>, until_recognised: bool) {
        let mut record = Record::default();
        let mut variable: &[u8] = b"";
        let mut next = self.tokens.next();
        while let Some(tag) = next.take() {
            match tag.keyword() {
                Some(b"SECTION") => {
                    self.close_polyline(file, false);
                    self.block = None;
                    variable = b"";
                    file.recognised = true;
                    next = self.tokens.next();
                    self.section = next.as_ref().map_or(Section::Unknown, Section::named_by);
                }
                Some(b"ENDSEC") => {
                    self.close_polyline(file, false);
                    self.block = None;
                    self.section = Section::Unknown;
                }
                Some(b"EOF") => {
                    self.close_polyline(file, false);
                    self.ended = true;
                    break;
                }
                Some(b"DICTIONARY" | b"SPATIAL_FILTER") if self.section == Section::Objects => {
                    next = record.gather(tag, &mut self.tokens);
                    file.clips.take(&record);
                }
                Some(_) if matches!(self.section, Section::Objects | Section::Other) => {}
                Some(_) => {
                    next = record.gather(tag, &mut self.tokens);
                    note_breaks(&mut self.tokens, file, Some(&record));
                    if !self.opens_section(&record, file) {
                        self.take(&record, file);
                    }
                }
                None if tag.code == 9 => variable = tag.text().unwrap_or_default(),
                None => file.header.take(variable, &tag),
            }
            note_breaks(&mut self.tokens, file, None);
            if until_recognised && file.recognised {
                return;
            }
            if next.is_none() {
                next = self.tokens.next();
            }
        }
        self.close_polyline(file, !self.ended);
        note_breaks(&mut self.tokens, file, None);
        note_end(&self.tokens, self.ended, file);
    }

    /// Whether an unknown record outside every section is the misspelt start of a section, because it names one. If so,
    /// enters that section.
    fn opens_section(&mut self, record: &Record<'a>, file: &mut File<'a>) -> bool {
        let Some((name, rest)) = record.tags.split_first().filter(|(tag, _)| tag.code == 2) else {
            return false;
        };
        let section = Section::named_by(name);
        if self.section != Section::Unknown || section == Section::Unknown || is_expected(record.name) {
            return false;
        }
        self.close_polyline(file, false);
        self.block = None;
        self.section = section;
        let mut variable: &[u8] = b"";
        for tag in rest {
            match tag.code {
                9 => variable = tag.text().unwrap_or_default(),
                _ => file.header.take(variable, tag),
            }
        }
        file.recognised = true;
        let message = "The word {} is in the place of SECTION: what follows is read as the section it names.";
        file.notes
            .push(Note { name: record.name, ..Note::new(Code::Resynchronised, Severity::Warning, message) });
        true
    }

    /// Processes one record of any kind.
    fn take(&mut self, record: &Record<'a>, file: &mut File<'a>) {
        match record.name {
            b"VERTEX" if self.polyline.is_some() => {
                if let Some((head, gathering)) = &mut self.polyline {
                    head.damaged |= record.damaged || entities::check_soundness(record) == Soundness::Broken;
                    gathering.add(record);
                }
                return;
            }
            b"SEQEND" => return self.close_polyline(file, record.damaged && self.polyline.is_some()),
            // An unknown record where a polyline should end may mean that vertices were lost.
            name => self.close_polyline(file, !is_expected(name)),
        }
        match record.name {
            b"LAYER" if !self.section.holds_entities() => {
                file.recognised = true;
                file.layers.define(record);
            }
            b"BLOCK" => {
                file.recognised = true;
                self.block = Some(file.open_block(record));
            }
            b"ENDBLK" => self.block = None,
            // Entities among the tables are there because the lines between the sections are lost.
            name if matches!(self.section, Section::Tables | Section::Header)
                && entities::kind(name).is_none() => {}
            b"POLYLINE" => {
                file.recognised = true;
                let head = with_properties(record, file, "POLYLINE", Geometry::Invalid("", None));
                self.polyline = Some((head, entities::begin_polyline(record)));
            }
            name => {
                let Some(geometry) = self.geometry(record, file) else { return };
                let kind = entities::kind(name).map_or("", |k| k.name);
                let entity = with_properties(record, file, kind, geometry);
                self.push(file, entity);
            }
        }
    }

    /// The geometry of a record; `None` when it is not an entity.
    fn geometry(&self, record: &Record<'a>, file: &mut File<'a>) -> Option<Geometry<'a>> {
        if let Some(kind) = entities::kind(record.name) {
            file.recognised = true;
            return Some(entities::geometry(kind, record));
        }
        // Outside the entity sections an unknown keyword may be anything.
        if !self.section.holds_entities() && !entities::is_known(record.name) {
            return None;
        }
        if record.name.is_empty() {
            return Some(Geometry::Invalid("its kind is lost", record.point(10)));
        }
        let block = self.block.and_then(|i| file.blocks.get(i));
        let on_paper = record.paper || block.is_some_and(|b| is_layout(b.name));
        if !on_paper && matches!(record.name, b"TEXT" | b"MTEXT") && file.text_heights.len() < TEXTS {
            file.text_heights.extend(record.real(40));
        }
        // Texts are written in the plane of their extrusion direction, other kinds in world coordinates.
        let is_flat = matches!(record.name, b"TEXT" | b"ATTRIB" | b"ATTDEF" | b"SHAPE");
        let place = record.point(10).map(|p| if is_flat { ocs::axes(record.normal) * p } else { p });
        Some(Geometry::Other(file.other(record.name), place))
    }

    fn close_polyline(&mut self, file: &mut File<'a>, cut_off: bool) {
        let Some((mut entity, gathering)) = self.polyline.take() else { return };
        entity.damaged |= cut_off;
        entity.geometry = match gathering.end() {
            Ok(geometry) => geometry,
            Err((name, place)) => {
                entity.kind = "";
                Geometry::Other(file.other(name.as_bytes()), place)
            }
        };
        self.push(file, entity);
    }

    fn push(&self, file: &mut File<'a>, mut entity: Entity<'a>) {
        entity.damaged |= self.section == Section::Blocks && self.block.is_none();
        let is_viewport =
            matches!(entity.geometry, Geometry::Other(name, _) if file.other_name(name) == b"VIEWPORT");
        let block = self.block.and_then(|i| file.blocks.get_mut(i));
        match block {
            // In most files the block of model space is empty. Where it is not, its entities belong to the model.
            Some(b) if b.name.eq_ignore_ascii_case(b"*MODEL_SPACE") => file.model.push(entity),
            // The blocks of layouts are never inserted. That of the active one is empty in most files, because its
            // entities are among those of the model (67 = 1). A view of the model is nothing that anybody misses.
            Some(b) if is_layout(b.name) => {
                if !is_viewport {
                    entity.hidden = Some(Hidden::Paper);
                    file.model.push(entity);
                }
            }
            Some(b) => b.entities.push(entity),
            None => file.model.push(entity),
        }
    }
}

/// Whether this record may follow a polyline whose end is not written.
fn is_expected(name: &[u8]) -> bool {
    matches!(name, b"BLOCK" | b"ENDBLK") || entities::kind(name).is_some() || entities::is_known(name)
}

/// Whether a block of this name is that of a paper layout.
fn is_layout(name: &[u8]) -> bool {
    name.get(..LAYOUT.len()).is_some_and(|n| n.eq_ignore_ascii_case(LAYOUT))
}
