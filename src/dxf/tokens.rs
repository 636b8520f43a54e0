//! Reads the tags of a file, ASCII or binary.

use super::ascii::Ascii;
use super::binary::{Binary, SENTINEL};
use super::breaks::Break;
use super::tag::Tag;

/// Reader of an ASCII or binary file.
#[derive(Debug)]
pub(super) enum Tokens<'a> {
    /// An ASCII file.
    Ascii(Ascii<'a>),
    /// A binary file (`AutoCAD Binary DXF`).
    Binary(Binary<'a>),
}

impl<'a> Tokens<'a> {
    /// Creates the reader for `bytes`.
    pub(super) fn new(bytes: &'a [u8]) -> Self {
        if bytes.starts_with(SENTINEL) {
            Self::Binary(Binary::new(bytes))
        } else {
            Self::Ascii(Ascii::new(bytes))
        }
    }

    /// The next tag that is not a comment; `None` at the end of the file.
    pub(super) fn next(&mut self) -> Option<Tag<'a>> {
        const COMMENT: i32 = 999;
        loop {
            let tag = match self {
                Self::Ascii(t) => t.next(),
                Self::Binary(t) => t.next(),
            }?;
            // A comment after a break is kept, because it carries the break to its entity.
            if tag.code != COMMENT || tag.after_break {
                return Some(tag);
            }
        }
    }

    /// The unit in which places are counted, for messages.
    pub(super) fn place_word(&self) -> &'static str {
        match self {
            Self::Ascii(_) => "line",
            Self::Binary(_) => "byte",
        }
    }

    /// The breaks found since the last call, in order.
    pub(super) fn take_breaks(&mut self) -> Vec<Break> {
        match self {
            Self::Ascii(t) => t.take_breaks(),
            Self::Binary(t) => t.take_breaks(),
        }
    }

    /// Whether the file ended within a tag.
    pub(super) fn cut_off(&self) -> bool {
        match self {
            Self::Ascii(t) => t.cut_off(),
            Self::Binary(t) => t.cut_off(),
        }
    }

    /// Whether anything but white space is left.
    pub(super) fn has_more(&self) -> bool {
        match self {
            Self::Ascii(t) => t.has_more(),
            Self::Binary(t) => t.has_more(),
        }
    }
}
