//! One record of the file: the properties common to all entities, and its other tags.
//!
//! Tags that do not belong to the entity are skipped: application groups (102 `{` to `}`), embedded objects (everything
//! after group 101), and extended data (codes from 1000).

use super::tag::Tag;
use super::tokens::Tokens;
use glam::DVec3;

/// An entity that is not interpreted yet. One record is reused for the whole file.
#[derive(Debug, Default)]
pub(super) struct Record<'a> {
    /// Keyword of its group 0; empty when it was lost.
    pub(super) name: &'a [u8],
    /// Handle (group 5).
    pub(super) handle: Option<&'a [u8]>,
    /// Handle of its owner (group 330).
    pub(super) owner: Option<&'a [u8]>,
    /// Layer name (group 8).
    pub(super) layer: Option<&'a [u8]>,
    /// Colour number (group 62).
    pub(super) color: Option<i64>,
    /// Whether it is on a paper layout instead of in the model (group 67).
    pub(super) paper: bool,
    /// Whether it is marked as invisible (group 60).
    pub(super) invisible: bool,
    /// Extrusion direction (groups 210, 220, 230).
    pub(super) normal: DVec3,
    /// Whether a break in the file touches it.
    pub(super) damaged: bool,
    /// Whether the file ends within it or right after it.
    pub(super) last_in_file: bool,
    /// Its other tags, in order.
    pub(super) tags: Vec<Tag<'a>>,
}

impl<'a> Record<'a> {
    /// Collects the entity that starts with `head`; returns the group 0 after it.
    pub(super) fn gather(&mut self, head: Tag<'a>, tokens: &mut Tokens<'a>) -> Option<Tag<'a>> {
        let tags = std::mem::take(&mut self.tags);
        *self = Self { normal: DVec3::Z, damaged: head.repaired, tags, ..Self::default() };
        self.name = head.keyword().unwrap_or_default();
        self.tags.clear();
        let mut part = Part::Own;
        while let Some(tag) = tokens.next() {
            self.damaged |= tag.after_break || tag.repaired;
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
            330 if self.owner.is_none() => self.owner = tag.text(),
            62 if self.color.is_none() => self.color = tag.int(),
            67 => self.paper = tag.int() == Some(1),
            60 => self.invisible = tag.int() == Some(1),
            210 => self.normal.x = tag.real().unwrap_or(0.0),
            220 => self.normal.y = tag.real().unwrap_or(0.0),
            230 => self.normal.z = tag.real().unwrap_or(1.0),
            // Line type, thickness, plot styles and owners do not affect the outline. Neither does a true colour (420):
            // it is written with the nearest colour number (62), and colours are only displayed.
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

    /// Number of groups `code`.
    pub(super) fn count(&self, code: i32) -> usize {
        self.tags.iter().filter(|t| t.code == code).count()
    }
}

/// The part of an entity that a tag belongs to.
#[derive(Clone, Copy)]
enum Part {
    Own,
    Application,
    Foreign,
    /// The closing brace of an application group, which is skipped too.
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
