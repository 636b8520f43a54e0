//! The lines of a program: comments in the dialect's style and plain characters, and lines that fit the controller.
//!
//! GRBL picks its real-time commands (`?`, `!`, `~`, and every byte from 0x80) out of the stream before it recognises
//! comments, and other controllers act on other marks, so names are reduced to plain letters, digits and a few marks. A
//! name that is too long for its line is shortened in its middle; a fact that is too long continues on the next line.

use super::facts::{Facts, Part};
use crate::machine::dialect::{Comments, Dialect, LineEnd};

/// Characters of a comment line that are not its text: the marks around it, a space, and one in reserve.
const AROUND_COMMENT: usize = 4;
/// Stands for the middle of a name that is too long.
const GAP: &str = "...";

/// Collects the lines of a program.
pub(super) struct Lines<'d> {
    dialect: &'d Dialect,
    program: String,
    /// The first line that is longer than the dialect allows.
    too_long: Option<String>,
}

impl<'d> Lines<'d> {
    pub(super) fn new(dialect: &'d Dialect) -> Self {
        Self { dialect, program: String::new(), too_long: None }
    }

    /// The program; an error is a line that is longer than the dialect allows.
    pub(super) fn into_program(self) -> Result<String, String> {
        self.too_long.map_or(Ok(self.program), Err)
    }

    /// Writes a line unchanged.
    pub(super) fn push(&mut self, line: &str) {
        if line.len() > self.dialect.line_length as usize && self.too_long.is_none() {
            self.too_long = Some(line.to_owned());
        }
        self.program.push_str(line);
        self.program.push_str(match self.dialect.line_end {
            LineEnd::Lf => "\n",
            LineEnd::Crlf => "\r\n",
        });
    }

    /// Writes a line of the dialect's header or footer. A line without a value for one of its placeholders is left out.
    pub(super) fn push_template(&mut self, line: &str, facts: &Facts) {
        match line.strip_prefix(';') {
            Some(text) => {
                if let Some(parts) = facts.parts(text.trim_start()) {
                    self.comment(&parts);
                }
            }
            None => {
                if let Some(parts) = facts.parts(line) {
                    let line: String = parts.iter().map(Part::text).collect();
                    self.push(&line);
                }
            }
        }
    }

    /// Writes a comment that ends in a name.
    pub(super) fn comment_naming(&mut self, words: &str, name: &str) {
        self.comment(&[Part::Text(words.to_owned()), Part::Name(name.to_owned())]);
    }

    /// Writes a comment line in plain characters.
    pub(super) fn comment(&mut self, parts: &[Part]) {
        let room = (self.dialect.line_length as usize).saturating_sub(AROUND_COMMENT);
        let plain = parts.iter().map(|p| plain(p.text())).collect::<Vec<_>>();
        let length: usize = plain.iter().map(String::len).sum();
        // The longest name gives way, so that every fact remains.
        let names = (0..parts.len()).filter(|&k| matches!(parts[k], Part::Name(_)));
        let longest = names.max_by_key(|&k| plain[k].len()).filter(|_| length > room);
        let shortened = |(k, text): (usize, &String)| match longest {
            Some(l) if l == k => shortened(text, room.saturating_sub(length - text.len())),
            _ => text.clone(),
        };
        let whole: String = plain.iter().enumerate().map(shortened).collect();
        let mut rest = whole.trim_end();
        while rest.len() > room {
            let at =
                rest.get(..=room).and_then(|start| start.rfind(' ')).filter(|&at| at > 0).unwrap_or(room);
            self.comment_line(rest.get(..at).unwrap_or_default());
            rest = rest.get(at..).unwrap_or_default().trim_start();
        }
        self.comment_line(rest);
    }

    fn comment_line(&mut self, text: &str) {
        match self.dialect.comments {
            Comments::Semicolon => self.push(&format!("; {text}")),
            Comments::Parentheses => self.push(&format!("({text})")),
            Comments::None => {}
        }
    }
}

/// A name of at most `room` characters: its start and, for a file's extension, its end.
fn shortened(name: &str, room: usize) -> String {
    let kept = room.saturating_sub(GAP.len());
    // Plain characters take one byte each.
    let (start, end) =
        (&name[..(kept - kept / 2).min(name.len())], &name[name.len().saturating_sub(kept / 2)..]);
    format!("{start}{GAP}{end}")
}

/// Replaces characters that a controller may act upon. Parentheses are removed, because they delimit comments.
fn plain(text: &str) -> String {
    let plain = |c: char| match c {
        ' ' | '.' | ',' | ':' | '_' | '+' | '-' | '=' | '/' => c,
        c if c.is_ascii_alphanumeric() => c,
        _ => '_',
    };
    text.chars().filter(|c| !matches!(c, '(' | ')')).map(plain).collect()
}
