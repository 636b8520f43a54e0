//! One entity as it stands in the file: its tags, and what every entity has.
//!
//! What does not belong to the entity is left out while the tags are gathered: application groups (102 `{` to
//! `}`), objects embedded in it (all that follows group 101), extended data (codes from 1000).

use super::tag::Tag;
use super::tokens::Tokens;
use glam::DVec3;

/// An entity, not interpreted yet. One is reused for the whole file.
#[derive(Debug, Default)]
pub(super) struct Record<'a> {
    /// Keyword of its group 0; empty when it was lost.
    pub(super) name: &'a [u8],
    /// Group 5.
    pub(super) handle: Option<&'a [u8]>,
    /// Group 8.
    pub(super) layer: Option<&'a [u8]>,
    /// Group 62.
    pub(super) color: Option<i64>,
    /// Group 67: on a paper layout, not in the model.
    pub(super) paper: bool,
    /// Group 60: switched invisible.
    pub(super) invisible: bool,
    /// Groups 210, 220, 230.
    pub(super) normal: DVec3,
    /// A break in the file touches it.
    pub(super) damaged: bool,
    /// The file ends within it or right after it.
    pub(super) last_in_file: bool,
    /// Its other tags, in order.
    pub(super) tags: Vec<Tag<'a>>,
}

impl<'a> Record<'a> {
    /// Gathers the entity that starts with `head`; returns the group 0 after it.
    pub(super) fn gather(&mut self, head: Tag<'a>, tokens: &mut Tokens<'a>) -> Option<Tag<'a>> {
        let tags = std::mem::take(&mut self.tags);
        *self = Self { normal: DVec3::Z, damaged: head.mended, tags, ..Self::default() };
        self.name = head.keyword().unwrap_or_default();
        self.tags.clear();
        let mut part = Part::Own;
        while let Some(tag) = tokens.next() {
            self.damaged |= tag.after_break || tag.mended;
            if tag.code == 0 {
                return Some(tag);
            }
            part = part.after(&tag);
            if matches!(part, Part::Own) {
                self.take(tag);
            }
        }
        self.last_in_file = true;
        self.damaged |= tokens.cut_off();
        None
    }

    fn take(&mut self, tag: Tag<'a>) {
        match tag.code {
            5 if self.handle.is_none() => self.handle = tag.text(),
            8 if self.layer.is_none() => self.layer = tag.text().filter(|name| !name.is_empty()),
            62 if self.color.is_none() => self.color = tag.int(),
            67 => self.paper = tag.int() == Some(1),
            60 => self.invisible = tag.int() == Some(1),
            210 => self.normal.x = tag.real().unwrap_or(0.0),
            220 => self.normal.y = tag.real().unwrap_or(0.0),
            230 => self.normal.z = tag.real().unwrap_or(1.0),
            // Line type, thickness, plot styles and owners have no part in the outline. Nor has a true colour (420):
            // who writes one writes the nearest colour number (62) beside it, and colours are only shown.
            6 | 39 | 48 | 330 | 347 | 348 | 370 | 390 | 410 | 420 | 430 | 440 => {}
            _ => self.tags.push(tag),
        }
    }

    /// The first value of group `code` as a real number.
    pub(super) fn real(&self, code: i32) -> Option<f64> {
        self.tags.iter().find(|t| t.code == code).and_then(Tag::real)
    }

    /// The first value of group `code` as a whole number.
    pub(super) fn int(&self, code: i32) -> Option<i64> {
        self.tags.iter().find(|t| t.code == code).and_then(Tag::int)
    }

    /// The first value of group `code` as text.
    pub(super) fn text(&self, code: i32) -> Option<&'a [u8]> {
        self.tags.iter().find(|t| t.code == code).and_then(Tag::text)
    }

    /// Whether bit `bit` of group 70 is set.
    pub(super) fn flag(&self, bit: i64) -> bool {
        self.int(70).unwrap_or(0) & bit != 0
    }

    /// The point whose x is the first group `code`; y and z (codes + 10, + 20) are 0 when missing.
    pub(super) fn point(&self, code: i32) -> Option<DVec3> {
        let x = self.real(code)?;
        Some(DVec3::new(x, self.real(code + 10).unwrap_or(0.0), self.real(code + 20).unwrap_or(0.0)))
    }

    /// How many groups `code` it has.
    pub(super) fn count(&self, code: i32) -> usize {
        self.tags.iter().filter(|t| t.code == code).count()
    }
}

/// Which part of an entity a tag belongs to.
#[derive(Clone, Copy)]
enum Part {
    Own,
    Application,
    Foreign,
    /// The closing brace of an application group: left out itself.
    Closing,
}

impl Part {
    fn after(self, tag: &Tag<'_>) -> Self {
        match (self, tag.code) {
            (Self::Foreign, _) | (_, 101 | 1000..) => Self::Foreign,
            (_, 102) if tag.text().is_some_and(|t| t.starts_with(b"{")) => Self::Application,
            (Self::Application, 102) => Self::Closing,
            // A group that was never closed ends where the next part of the entity starts.
            (Self::Application, 100) => Self::Own,
            (Self::Application, _) => Self::Application,
            _ => Self::Own,
        }
    }
}
