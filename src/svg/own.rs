//! What an element sets for itself, and no element inside it inherits: whether it is shown, its transforms, and the places and
//! sizes that style sheets give it.

use super::length::{Axis, Lengths};
use super::xml::Document;

/// What an element sets for itself only.
#[derive(Clone, Debug, Default)]
pub(super) struct Own {
    /// Whether it and everything in it is not displayed.
    pub(super) undisplayed: bool,
    /// Whether it and everything in it has an opacity of 0.
    pub(super) transparent: bool,
    /// The value of the property or attribute `transform`.
    pub(super) transform: Option<String>,
    /// The value of `transform-origin`.
    pub(super) origin: Option<String>,
    /// The box in which `transform-box` places this origin.
    pub(super) reference: Reference,
    /// The values of `translate`, `rotate` and `scale`, which come before `transform`.
    pub(super) moves: [Option<String>; 3],
    /// Places and sizes that style sheets give to a shape, a copy or a page, the strongest last.
    pub(super) geometry: Vec<(String, String)>,
    /// Whether a value that decides what is drawn, or where, cannot be read.
    pub(super) unread: bool,
    pub(super) clipped: bool,
    pub(super) masked: bool,
    pub(super) marked: bool,
}

/// The box that the origin of a transform refers to.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) enum Reference {
    /// The nearest viewport.
    #[default]
    View,
    /// The box of the element without its stroke.
    Fill,
    /// That with its stroke.
    Stroke,
}

/// The properties of [`Own::geometry`].
pub(super) const GEOMETRY: [&str; 10] = ["x", "y", "width", "height", "rx", "ry", "cx", "cy", "r", "d"];

impl Own {
    /// Whether it is moved, turned or scaled.
    pub(super) fn is_transformed(&self) -> bool {
        self.transform.is_some() || self.moves.iter().any(Option::is_some)
    }

    /// A place or size in user units; `None` if there is none that can be read.
    pub(super) fn length(
        &self,
        document: &Document<'_>,
        element: u32,
        name: &str,
        axis: Axis,
        lengths: &Lengths,
    ) -> Option<f64> {
        self.geometry(document, element, name).and_then(|text| lengths.read(text, axis))
    }

    /// A place or size: that of a style sheet, or else the attribute.
    pub(super) fn geometry<'o>(
        &'o self,
        document: &'o Document<'_>,
        element: u32,
        name: &str,
    ) -> Option<&'o str> {
        let from_style = self.geometry.iter().rfind(|(n, _)| n == name).map(|(_, value)| value.as_str());
        from_style.or_else(|| document.attribute(element, name))
    }
}

/// The path data of `path("...")`; empty for `none`.
pub(super) fn path_of(value: &str) -> Option<&str> {
    if value.eq_ignore_ascii_case("none") {
        return Some("");
    }
    let inside = value.strip_prefix("path(")?.strip_suffix(')')?.trim();
    let quoted = |quote: char| inside.strip_prefix(quote)?.strip_suffix(quote);
    quoted('"').or_else(|| quoted('\''))
}
