//! Tags of a file, whatever way it is written.

use super::ascii::Ascii;
use super::binary::{Binary, SENTINEL};
use super::breaks::Break;
use super::tag::Tag;

/// Reads tags from ASCII or binary.
#[derive(Debug)]
pub(super) enum Tokens<'a> {
    /// Lines of text.
    Ascii(Ascii<'a>),
    /// `AutoCAD Binary DXF`.
    Binary(Binary<'a>),
}

impl<'a> Tokens<'a> {
    /// A reader for `bytes`.
    pub(super) fn new(bytes: &'a [u8]) -> Self {
        if bytes.starts_with(SENTINEL) {
            Self::Binary(Binary::new(bytes))
        } else {
            Self::Ascii(Ascii::new(bytes))
        }
    }

    /// The next tag; `None` at the end of the file.
    pub(super) fn next(&mut self) -> Option<Tag<'a>> {
        match self {
            Self::Ascii(t) => t.next(),
            Self::Binary(t) => t.next(),
        }
    }

    /// What places are counted in: for messages.
    pub(super) fn place_word(&self) -> &'static str {
        match self {
            Self::Ascii(_) => "line",
            Self::Binary(_) => "byte",
        }
    }

    /// The breaks met since the last call, in order.
    pub(super) fn take_breaks(&mut self) -> Vec<Break> {
        match self {
            Self::Ascii(t) => t.take_breaks(),
            Self::Binary(t) => t.take_breaks(),
        }
    }

    /// The file ended within a tag.
    pub(super) fn cut_off(&self) -> bool {
        match self {
            Self::Ascii(t) => t.cut_off(),
            Self::Binary(t) => t.cut_off(),
        }
    }

    /// Whether anything but filler follows.
    pub(super) fn has_more(&self) -> bool {
        match self {
            Self::Ascii(t) => t.has_more(),
            Self::Binary(t) => t.has_more(),
        }
    }
}
