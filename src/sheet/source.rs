//! The input of cleaning and joining: paths, and where they come from, for the findings about them.

use super::findings;
use crate::drawing::Drawing;
use crate::finding::{Code, Finding, Severity};
use crate::geometry::{DVec2, Path};

/// A path to be cleaned and joined.
#[derive(Clone, Copy)]
pub(super) struct Line<'a> {
    /// Its index in the source.
    pub(super) index: u32,
    /// Its layer.
    pub(super) layer: u32,
    /// Its geometry, mm.
    pub(super) path: &'a Path,
}

/// Where the paths come from.
#[derive(Clone, Copy)]
pub(super) enum Source<'a> {
    /// The shapes of a drawing, by index.
    Drawing(&'a Drawing),
    /// Contours offset by the kerf, by id. The drawing has nothing at their place.
    MovedContours,
}

impl<'a> Source<'a> {
    /// The kind of a path, in words.
    pub(super) fn kind(self, index: u32) -> &'static str {
        match self {
            Self::Drawing(drawing) => drawing.shapes.get(index as usize).map_or("shape", |s| s.kind),
            Self::MovedContours => "contour",
        }
    }

    /// The handle of a path in the file.
    pub(super) fn handle(self, index: u32) -> Option<&'a str> {
        match self {
            Self::Drawing(drawing) => drawing.shapes.get(index as usize)?.handle.as_deref(),
            Self::MovedContours => None,
        }
    }

    /// A finding about a path.
    pub(super) fn finding(
        self,
        index: u32,
        code: Code,
        severity: Severity,
        message: String,
        at: Option<DVec2>,
    ) -> Finding {
        match self {
            Self::Drawing(drawing) => findings::shape(drawing, index, code, severity, message, at),
            Self::MovedContours => Finding { at, ..Finding::new(code, severity, message) },
        }
    }
}
