//! What the reader counts instead of listing it, and the sentence for each.

use crate::finding::{Code, Severity};

/// What is counted instead of listed.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Subject {
    /// Elements of a kind without an outline.
    Unsupported(String),
    /// Shapes that are not drawn.
    Hidden(Hidden),
    /// Filled shapes without a stroke, of a kind.
    Filled(&'static str),
    /// Shapes with a wide stroke.
    Wide,
    /// Shapes in a colour that cannot be read.
    Color,
    /// Shapes whose stroke has no width.
    Thin,
    /// Shapes with a dashed stroke.
    Dashed,
    /// Elements of which only a part is shown.
    Clipped,
    /// Elements that a mask fades.
    Masked,
    /// Elements with arrowheads or other markers.
    Marked,
    /// Shapes filled with a pattern.
    Patterned,
    /// Copies of an element that is not in the file.
    Missing(String),
    /// Copies of an element inside itself.
    Cyclic(String),
    /// Elements whose `transform` cannot be read.
    Transform,
    /// Elements whose `transform-origin` is not supported.
    Origin,
    /// Elements with another value that cannot be read and decides what is drawn, or where.
    Style,
    /// Copies and pages whose place or size cannot be read.
    Length,
    /// A page with a transform.
    Page,
    /// Rules of style sheets.
    Rules,
    /// Style sheets.
    Sheets,
    /// Entities in text.
    Entities,
}

/// Why a shape is not drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Hidden {
    /// `display: none`, or an opacity of 0, on it or around it.
    Gone,
    /// `visibility: hidden`.
    Invisible,
    /// Neither stroke nor fill.
    Unpainted,
}

impl Subject {
    /// The code, the severity and the sentence of the finding for `n` of them.
    pub(super) fn sentence(&self, n: u32) -> (Code, Severity, String) {
        use Severity::{Error, Info, Warning};
        let many = |one: &str, many: &str| if n == 1 { format!("1 {one}") } else { format!("{n} {many}") };
        match self {
            Self::Unsupported(kind) => {
                (Code::UnsupportedEntity, Warning, format!("{n} {kind} left out: {}.", advice(kind)))
            }
            Self::Hidden(why) => {
                let why = match why {
                    Hidden::Gone => "not displayed (display: none, opacity 0, or a hidden layer)",
                    Hidden::Invisible => "switched invisible",
                    Hidden::Unpainted => "without stroke and fill, so not visible,",
                };
                (Code::HiddenEntity, Info, format!("{} {why} and not cut.", many("shape is", "shapes are")))
            }
            Self::Filled(kind) => (
                Code::OutlineTaken,
                Info,
                format!(
                    "The outline of {n} filled {kind} without a stroke is taken as lines to cut; the filling is not. Choose mark or ignore for its layer if it is an engraving."
                ),
            ),
            Self::Wide => (
                Code::OutlineTaken,
                Info,
                format!(
                    "{} a stroke wider than 1 mm: cut along its middle line, once.",
                    many("shape has", "shapes have")
                ),
            ),
            Self::Color => (
                Code::OutlineTaken,
                Warning,
                format!(
                    "{} drawn in a colour that cannot be read (var(), oklch() and the like): cut all the same. Give a plain colour in the drawing program, or choose what happens to the layer.",
                    many("shape is", "shapes are")
                ),
            ),
            Self::Thin => (
                Code::OutlineTaken,
                Info,
                format!(
                    "{} a stroke of width 0, which no screen shows: cut all the same.",
                    many("shape has", "shapes have")
                ),
            ),
            Self::Dashed => (
                Code::OutlineTaken,
                Info,
                format!(
                    "{} a dashed stroke: cut as a whole line, without gaps.",
                    many("shape has", "shapes have")
                ),
            ),
            Self::Clipped => (
                Code::UnsupportedEntity,
                Warning,
                format!(
                    "{} clipped in the drawing, but cut whole. Apply the clip (intersection) in the drawing program.",
                    many("object is", "objects are")
                ),
            ),
            Self::Masked => (
                Code::UnsupportedEntity,
                Warning,
                format!(
                    "{} a mask, which is not applied: cut whole. Apply the mask in the drawing program.",
                    many("object has", "objects have")
                ),
            ),
            Self::Marked => (
                Code::UnsupportedEntity,
                Warning,
                format!(
                    "{} arrowheads or other markers, which are not cut. Convert them to paths in the drawing program.",
                    many("object has", "objects have")
                ),
            ),
            Self::Patterned => (
                Code::UnsupportedEntity,
                Warning,
                format!(
                    "{} filled with a pattern, whose lines are not cut. Convert the pattern to objects in the drawing program.",
                    many("shape is", "shapes are")
                ),
            ),
            Self::Missing(target) => (
                Code::MissingBlock,
                Error,
                format!(
                    "{} of \"{target}\", which is not in the file: the content is missing.",
                    many("copy", "copies")
                ),
            ),
            Self::Cyclic(target) => (
                Code::CyclicBlock,
                Error,
                format!(
                    "\"{target}\" contains itself; the inner {} left out.",
                    many("copy is", "copies are")
                ),
            ),
            Self::Transform => (
                Code::InvalidGeometry,
                Warning,
                format!(
                    "{} a transform that cannot be read: placed without it. Apply the transform in the drawing program.",
                    many("object has", "objects have")
                ),
            ),
            Self::Origin => (
                Code::InvalidGeometry,
                Warning,
                format!(
                    "{} turned or scaled about a point that cannot be read (transform-origin): the origin of the page is taken. Apply the transform in the drawing program.",
                    many("object is", "objects are")
                ),
            ),
            Self::Style => (
                Code::InvalidGeometry,
                Warning,
                format!(
                    "{} a style with a value that cannot be read (var(), offset-path and the like), which is left out. Save the drawing as plain SVG.",
                    many("object has", "objects have")
                ),
            ),
            Self::Length => (
                Code::InvalidGeometry,
                Warning,
                format!(
                    "{} a place or size that cannot be read, which counts as missing. Write it as a number with a unit.",
                    many("object has", "objects have")
                ),
            ),
            Self::Page => (
                Code::InvalidGeometry,
                Warning,
                "The page itself has a transform, which is applied about its corner; browsers take its middle. Check the place of the drawing, or apply the transform in the drawing program.".to_owned(),
            ),
            Self::Sheets => (
                Code::UnsupportedEntity,
                Info,
                format!(
                    "{} not read: another file, or not one for screens. Check that nothing is missing.",
                    many("style sheet is", "style sheets are")
                ),
            ),
            Self::Rules => (
                Code::UnsupportedEntity,
                Info,
                format!(
                    "{} not understood (media queries, states, attribute selectors). Check that nothing is missing.",
                    many("rule of the style sheet is", "rules of the style sheet are")
                ),
            ),
            Self::Entities => (
                Code::UnsupportedEntity,
                Warning,
                format!(
                    "{} in the content not expanded. Save the drawing again as plain SVG.",
                    many("entity is", "entities are")
                ),
            ),
        }
    }
}

/// What to do about an element without an outline.
fn advice(kind: &str) -> &'static str {
    match kind {
        "text" | "flowRoot" => {
            "letters have no outline until the text is converted to paths (Inkscape: Path, Object to Path; Illustrator: Type, Create Outlines)"
        }
        "image" => "a picture has no lines; trace it in the drawing program (Inkscape: Path, Trace Bitmap)",
        "foreignObject" => "it holds text or a web page, which has no lines",
        _ => "it has no outline to cut; convert it to paths in the drawing program",
    }
}
