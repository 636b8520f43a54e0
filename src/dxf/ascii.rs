//! Reads the tags of an ASCII file in one pass, borrowing from it.
//!
//! An ASCII DXF alternates lines: group code, value. Real files break this alternation: lines are lost, doubled or
//! swapped, merge conflicts are committed, text runs over two lines. The reader is then out of sync. It resumes at the
//! next line where a run of pairs is plausible (known codes, values of their type, up to the next group 0 with a
//! keyword). It marks the tags on both sides of the break, so that their entity is reported as damaged and is not cut
//! unless asked for.
//!
//! Lines end with LF, CR LF, CR, or CR CR LF. Blank lines before a group code are skipped, and a file in which every
//! second line is blank is read without them. A byte order mark and the old end mark ^Z are ignored.

use super::breaks::{Break, BreakKind};
use super::plausible::{group_code, is_conflict_marker, is_plausible, is_structure};
use super::tag::{Tag, Value, ValueType, is_keyword, value_of, value_type};

/// Number of plausible pairs after which the reader is back in sync: half a LINE entity. With fewer, coordinates that
/// happen to be whole numbers pass as group codes; with more, more sound data is skipped.
const PAIRS_TO_TRUST: usize = 5;

/// A position between two lines.
#[derive(Clone, Copy, Debug)]
struct LineCursor {
    /// Byte offset from the start of the file.
    at: usize,
    /// Number of lines before it.
    line: u32,
}

/// Reader of the tags of an ASCII file.
#[derive(Debug)]
pub(super) struct Ascii<'a> {
    data: &'a [u8],
    cursor: LineCursor,
    double_spaced: bool,
    after_break: bool,
    breaks: Vec<Break>,
    cut_off: bool,
}

impl<'a> Ascii<'a> {
    /// Creates a reader at the start of `data`.
    pub(super) fn new(data: &'a [u8]) -> Self {
        let data = data.strip_prefix(b"\xEF\xBB\xBF").unwrap_or(data);
        let mut reader = Self {
            data,
            cursor: LineCursor { at: 0, line: 0 },
            double_spaced: false,
            after_break: false,
            breaks: Vec::new(),
            cut_off: false,
        };
        reader.double_spaced = reader.is_double_spaced();
        reader
    }

    /// The breaks found since the last call, in order.
    pub(super) fn take_breaks(&mut self) -> Vec<Break> {
        std::mem::take(&mut self.breaks)
    }

    /// Whether the file ended between a group code and its value, or within its last line.
    pub(super) fn cut_off(&self) -> bool {
        self.cut_off
    }

    /// Whether anything but white space is left.
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
                if let Some(tag) = self.out_of_sync(start, first, after_first) {
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
                // A group code that no release defines is accepted only if the pairs after it are plausible.
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

    /// Handles a group code whose value is not of its type. The value is bad, a blank line is in between, or the reader
    /// is out of sync.
    fn bad_pair(
        &mut self,
        start: LineCursor,
        code: i32,
        second: &'a [u8],
        after_first: LineCursor,
        after_second: LineCursor,
    ) -> Option<Tag<'a>> {
        if value_type(code) != ValueType::Unknown && self.run_is_sound(after_second) {
            self.cursor = after_second;
            return Some(self.repaired(start, BreakKind::BadValue, code, Value::Bad));
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
            // An entity starts here but its name is lost. Its values must not go to the entity before it.
            return Some(self.repaired(start, BreakKind::OutOfSync, 0, Value::Bad));
        }
        self.note(start, BreakKind::OutOfSync);
        self.after_break = true;
        None
    }

    /// Handles a line that should be a group code and is not.
    fn out_of_sync(&mut self, start: LineCursor, text: &'a [u8], after: LineCursor) -> Option<Tag<'a>> {
        if is_conflict_marker(text) {
            self.cursor = after;
            self.note(start, BreakKind::MergeConflict);
            // A conflict marker between two entities damages neither of them.
            self.after_break |= !self.starts_with_keyword(after);
            return None;
        }
        if is_structure(text) && self.run_is_sound(after) {
            self.cursor = after;
            return Some(self.repaired(start, BreakKind::OutOfSync, 0, Value::Text(text)));
        }
        self.cursor = self.next_sound_run(after);
        self.note(start, BreakKind::OutOfSync);
        self.after_break = true;
        None
    }

    fn repaired(&mut self, start: LineCursor, kind: BreakKind, code: i32, value: Value<'a>) -> Tag<'a> {
        self.note(start, kind);
        self.after_break = false;
        Tag { code, value, after_break: true, repaired: true }
    }

    fn note(&mut self, start: LineCursor, kind: BreakKind) {
        self.breaks.push(Break { place: start.line + 1, kind });
    }

    /// The first line from `from` on where a run of pairs is plausible, or the end of the file.
    fn next_sound_run(&self, from: LineCursor) -> LineCursor {
        let mut here = from;
        while let Some((text, after)) = self.read_line(here) {
            // A run may start with blank lines. Starting a test at each of them would take quadratic time.
            if !text.is_empty() && self.run_is_sound(here) {
                return here;
            }
            here = after;
        }
        here
    }

    /// Whether the pairs from `from` on are plausible, up to a known keyword, the end, or [`PAIRS_TO_TRUST`] pairs.
    fn run_is_sound(&self, from: LineCursor) -> bool {
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
    fn starts_with_keyword(&self, from: LineCursor) -> bool {
        let Some((first, after)) = self.read_line(from) else { return true };
        group_code(first) == Some(0) && self.read_line(after).is_some_and(|(second, _)| is_keyword(second))
    }

    /// The line at `from` without surrounding white space, and the position after it.
    fn read_line(&self, from: LineCursor) -> Option<(&'a [u8], LineCursor)> {
        let (text, after) = self.read_raw_line(from)?;
        if self.double_spaced
            && let Some((next, after_next)) = self.read_raw_line(after)
            && next.is_empty()
        {
            return Some((text, after_next));
        }
        Some((text, after))
    }

    fn read_raw_line(&self, from: LineCursor) -> Option<(&'a [u8], LineCursor)> {
        let rest = self.data.get(from.at..).filter(|rest| !rest.is_empty())?;
        let length = rest.iter().position(|b| matches!(b, b'\n' | b'\r')).unwrap_or(rest.len());
        let (text, end) = rest.split_at(length);
        let end_length = match end {
            [b'\r', b'\r', b'\n', ..] => 3,
            [b'\r', b'\n', ..] => 2,
            [_, ..] => 1,
            [] => 0,
        };
        let after = LineCursor { at: from.at + length + end_length, line: from.line.saturating_add(1) };
        Some((text.trim_ascii(), after))
    }

    /// Records that the file ends within its last line: it has no line end, and the line is not EOF.
    fn note_cut_in_last_line(&mut self) {
        if self.cursor.at == self.data.len() {
            self.cut_off = !matches!(self.data.last(), Some(b'\n' | b'\r' | 0x1A));
        }
    }

    /// Whether every second line is blank, from the first group code on.
    fn is_double_spaced(&self) -> bool {
        // These lines hold eight pairs, and a header has no run of empty values that long.
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
