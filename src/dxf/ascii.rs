//! Tags of an ASCII file, one pass, borrowing from it.
//!
//! An ASCII DXF alternates lines: group code, value. Real files break the rhythm: lines lost, doubled or swapped,
//! merge conflicts committed, text spilled over two lines. The reader then has lost step; it reads on from the
//! next line where a run of pairs is plausible again (codes known, values of their type, up to the next group 0
//! with a keyword), and marks the tags on both sides of the break so that the entity they belong to is reported
//! as damaged and never cut by accident.
//!
//! Line ends are LF, CR LF, CR, or CR CR LF; blank lines before a group code are skipped; a file with every
//! second line blank is read as if they were not there; a byte order mark and the old end mark ^Z are ignored.

use super::breaks::{Break, BreakKind};
use super::plausible::{group_code, is_conflict_marker, is_plausible, is_structure};
use super::tag::{Tag, Value, ValueType, is_keyword, value_of, value_type};

/// Pairs that must be plausible before the reader trusts its step again. Shorter runs let coordinates that happen
/// to be whole numbers pass as group codes; longer ones skip more of what is sound. Half a LINE entity.
const PAIRS_TO_TRUST: usize = 5;

/// A place between two lines.
#[derive(Clone, Copy, Debug)]
struct Cursor {
    /// Byte offset.
    at: usize,
    /// Lines before it.
    line: u32,
}

/// Reads tags from ASCII.
#[derive(Debug)]
pub(super) struct Ascii<'a> {
    data: &'a [u8],
    cursor: Cursor,
    double_spaced: bool,
    after_break: bool,
    breaks: Vec<Break>,
    cut_off: bool,
}

impl<'a> Ascii<'a> {
    /// A reader at the start of `data`.
    pub(super) fn new(data: &'a [u8]) -> Self {
        let data = data.strip_prefix(b"\xEF\xBB\xBF").unwrap_or(data);
        let mut reader = Self {
            data,
            cursor: Cursor { at: 0, line: 0 },
            double_spaced: false,
            after_break: false,
            breaks: Vec::new(),
            cut_off: false,
        };
        reader.double_spaced = reader.is_double_spaced();
        reader
    }

    /// The breaks met since the last call, in order.
    pub(super) fn take_breaks(&mut self) -> Vec<Break> {
        std::mem::take(&mut self.breaks)
    }

    /// The file ended between a group code and its value, or within its last line.
    pub(super) fn cut_off(&self) -> bool {
        self.cut_off
    }

    /// Whether anything but white space follows.
    pub(super) fn has_more(&self) -> bool {
        self.data
            .get(self.cursor.at..)
            .is_some_and(|rest| rest.iter().any(|b| !b.is_ascii_whitespace() && *b != 0x1A))
    }

    /// The next tag; `None` at the end of the file.
    pub(super) fn next(&mut self) -> Option<Tag<'a>> {
        loop {
            let start = self.cursor;
            let (first, after_first) = self.read_line(start)?;
            if first.is_empty() || first == b"\x1A" {
                self.cursor = after_first;
                continue;
            }
            let Some(code) = group_code(first) else {
                if let Some(tag) = self.lost_step(start, first, after_first) {
                    return Some(tag);
                }
                continue;
            };
            let Some((second, after_second)) = self.read_line(after_first) else {
                self.cut_off = true;
                self.cursor = after_first;
                return None;
            };
            let value = value_of(code, second);
            match value {
                // A code no release defines is believed only where the pairs after it make sense.
                Some(value) if value_type(code) != ValueType::Unknown || self.run_is_sound(after_second) => {
                    self.cursor = after_second;
                    self.note_cut_in_last_line();
                    let after_break = std::mem::take(&mut self.after_break);
                    return Some(Tag { after_break, ..Tag::sound(code, value) });
                }
                _ => {
                    if let Some(tag) = self.bad_pair(start, code, second, after_first, after_second) {
                        return Some(tag);
                    }
                }
            }
        }
    }

    /// A group code whose value is not of its type: a bad value, a blank line in between, or lost step.
    fn bad_pair(
        &mut self,
        start: Cursor,
        code: i32,
        second: &'a [u8],
        after_first: Cursor,
        after_second: Cursor,
    ) -> Option<Tag<'a>> {
        if value_type(code) != ValueType::Unknown && self.run_is_sound(after_second) {
            self.cursor = after_second;
            return Some(self.mended(start, BreakKind::BadValue, code, Value::Bad));
        }
        if second.is_empty() {
            let mut next = after_second;
            while let Some((text, after)) = self.read_line(next) {
                if text.is_empty() {
                    next = after;
                    continue;
                }
                if let Some(value) = value_of(code, text).filter(|_| self.run_is_sound(after)) {
                    self.cursor = after;
                    let after_break = std::mem::take(&mut self.after_break);
                    return Some(Tag { after_break, ..Tag::sound(code, value) });
                }
                break;
            }
        }
        self.cursor = self.next_sound_run(after_first);
        if code == 0 {
            // Something started here; its name is lost. Its values must not fall to the entity before.
            return Some(self.mended(start, BreakKind::LostStep, 0, Value::Bad));
        }
        self.note(start, BreakKind::LostStep);
        self.after_break = true;
        None
    }

    /// A line where a group code should be and none is.
    fn lost_step(&mut self, start: Cursor, text: &'a [u8], after: Cursor) -> Option<Tag<'a>> {
        if is_conflict_marker(text) {
            self.cursor = after;
            self.note(start, BreakKind::MergeConflict);
            // Between two entities a marker harms neither of them.
            self.after_break |= !self.starts_with_keyword(after);
            return None;
        }
        if is_structure(text) && self.run_is_sound(after) {
            self.cursor = after;
            return Some(self.mended(start, BreakKind::LostStep, 0, Value::Text(text)));
        }
        self.cursor = self.next_sound_run(after);
        self.note(start, BreakKind::LostStep);
        self.after_break = true;
        None
    }

    fn mended(&mut self, start: Cursor, kind: BreakKind, code: i32, value: Value<'a>) -> Tag<'a> {
        self.note(start, kind);
        self.after_break = false;
        Tag { code, value, after_break: true, mended: true }
    }

    fn note(&mut self, start: Cursor, kind: BreakKind) {
        self.breaks.push(Break { place: start.line + 1, kind });
    }

    /// The first line from `from` on where a run of pairs is plausible, or the end.
    fn next_sound_run(&self, from: Cursor) -> Cursor {
        let mut here = from;
        while let Some((text, after)) = self.read_line(here) {
            // A run may start with blank lines: without this, many of them would be looked at again and again.
            if !text.is_empty() && self.run_is_sound(here) {
                return here;
            }
            here = after;
        }
        here
    }

    /// Whether the pairs from `from` on are plausible: up to a known keyword, the end, or [`PAIRS_TO_TRUST`].
    fn run_is_sound(&self, from: Cursor) -> bool {
        let mut here = from;
        for _ in 0..PAIRS_TO_TRUST {
            let (first, after_first) = loop {
                match self.read_line(here) {
                    Some((text, after)) if text.is_empty() || text == b"\x1A" => here = after,
                    Some(line) => break line,
                    None => return true,
                }
            };
            if is_conflict_marker(first) {
                here = after_first;
                continue;
            }
            let Some(code) = group_code(first) else { return false };
            let Some((second, after_second)) = self.read_line(after_first) else { return false };
            if !is_plausible(code, second) {
                return false;
            }
            if code == 0 && is_structure(second) {
                return true;
            }
            here = after_second;
        }
        true
    }

    /// Whether the next pair is a group 0.
    fn starts_with_keyword(&self, from: Cursor) -> bool {
        let Some((first, after)) = self.read_line(from) else { return true };
        group_code(first) == Some(0) && self.read_line(after).is_some_and(|(second, _)| is_keyword(second))
    }

    /// The line at `from` without white space around it, and the place after it.
    fn read_line(&self, from: Cursor) -> Option<(&'a [u8], Cursor)> {
        let (text, after) = self.read_raw_line(from)?;
        if self.double_spaced
            && let Some((next, after_next)) = self.read_raw_line(after)
            && next.is_empty()
        {
            return Some((text, after_next));
        }
        Some((text, after))
    }

    fn read_raw_line(&self, from: Cursor) -> Option<(&'a [u8], Cursor)> {
        let rest = self.data.get(from.at..).filter(|rest| !rest.is_empty())?;
        let length = rest.iter().position(|b| matches!(b, b'\n' | b'\r')).unwrap_or(rest.len());
        let (text, end) = rest.split_at(length);
        let end_length = match end {
            [b'\r', b'\r', b'\n', ..] => 3,
            [b'\r', b'\n', ..] => 2,
            [_, ..] => 1,
            [] => 0,
        };
        let after = Cursor { at: from.at + length + end_length, line: from.line.saturating_add(1) };
        Some((text.trim_ascii(), after))
    }

    /// The file ends within its last line: without a line end, and not with the word EOF.
    fn note_cut_in_last_line(&mut self) {
        if self.cursor.at == self.data.len() {
            self.cut_off = !matches!(self.data.last(), Some(b'\n' | b'\r' | 0x1A));
        }
    }

    /// Every second line blank, from the first group code on.
    fn is_double_spaced(&self) -> bool {
        // Eight pairs: a header has no run of empty values that long.
        const LINES: usize = 16;
        let mut here = self.cursor;
        let (mut filled, mut blank) = (0usize, 0usize);
        while filled < LINES {
            let Some((text, after)) = self.read_line(here) else { break };
            if text.is_empty() {
                blank += usize::from(filled > 0);
            } else {
                filled += 1;
            }
            here = after;
        }
        filled > 2 && blank + 1 >= filled
    }
}
