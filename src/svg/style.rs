//! The style of an element as far as cutting goes: stroke, fill, and what is visible.
//!
//! Attributes are the weakest, then come rules of style sheets, then the `style` attribute, then whatever is marked
//! `!important`.

use super::color::{self, Rgb};
use super::css::{Declaration, StyleSheet, declarations, without_comments};
use super::length::{Axis, Lengths};
use super::numbers::Scanner;
use super::steps::Steps;
use super::xml::{Document, Space};

/// What a line or an area is painted with.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Paint {
    None,
    Color(Rgb),
    /// A gradient, or a paint that is taken from elsewhere.
    Other,
    /// A pattern, whose own lines are not read.
    Pattern,
    /// The colour that the property `color` has where it is painted.
    Current,
}

/// The inherited style of an element.
#[derive(Clone, Copy, Debug)]
pub(super) struct Style {
    pub(super) stroke: Paint,
    pub(super) fill: Paint,
    color: Rgb,
    pub(super) visible: bool,
    /// Width of strokes in user units.
    pub(super) width: f64,
    pub(super) dashed: bool,
    stroke_opaque: bool,
    fill_opaque: bool,
}

impl Style {
    /// The initial values of the specification.
    pub(super) const INITIAL: Self = Self {
        stroke: Paint::None,
        fill: Paint::Color(Rgb::BLACK),
        color: Rgb::BLACK,
        visible: true,
        width: 1.0,
        dashed: false,
        stroke_opaque: true,
        fill_opaque: true,
    };

    /// The stroke, if anything of it is visible.
    pub(super) fn visible_stroke(&self) -> Paint {
        if self.stroke_opaque { self.with_color(self.stroke) } else { Paint::None }
    }

    /// The fill, if anything of it is visible.
    pub(super) fn visible_fill(&self) -> Paint {
        if self.fill_opaque { self.with_color(self.fill) } else { Paint::None }
    }

    fn with_color(&self, paint: Paint) -> Paint {
        if paint == Paint::Current { Paint::Color(self.color) } else { paint }
    }
}

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
    /// Whether `transform-box` places this origin in the element's own box.
    pub(super) own_box: bool,
    pub(super) clipped: bool,
    pub(super) masked: bool,
    pub(super) marked: bool,
}

/// The style of an element inside one with the style `inherited`. `steps`: as for [`StyleSheet::matching`].
pub(super) fn resolve(
    document: &Document<'_>,
    sheet: &StyleSheet<'_>,
    element: u32,
    inherited: &Style,
    lengths: &Lengths,
    steps: &mut Steps,
) -> (Style, Own) {
    let mut cascade = Cascade { document, inherited, lengths, style: *inherited, own: Own::default() };
    for a in document.attributes(element).iter().filter(|a| a.space == Space::None) {
        cascade.apply(a.name, a.value.trim());
    }
    let rules = sheet.matching(document, element, steps);
    let inline = without_comments(document.attribute(element, "style").unwrap_or_default());
    let inline: Vec<Declaration<'_>> = declarations(&inline).collect();
    for important in [false, true] {
        for d in rules.iter().chain(&inline).filter(|d| d.important == important) {
            cascade.apply(d.name, d.value);
        }
    }
    (cascade.style, cascade.own)
}

struct Cascade<'c> {
    document: &'c Document<'c>,
    inherited: &'c Style,
    lengths: &'c Lengths,
    style: Style,
    own: Own,
}

impl Cascade<'_> {
    fn apply(&mut self, name: &str, value: &str) {
        let (style, inherited) = (&mut self.style, self.inherited);
        let inherits = value == "inherit";
        let is_reference = value.starts_with("url(");
        match name {
            "stroke" | "fill" => {
                let is_stroke = name == "stroke";
                let before = if is_stroke { inherited.stroke } else { inherited.fill };
                let paint = if inherits { Some(before) } else { self.paint(value) };
                if let Some(paint) = paint {
                    *(if is_stroke { &mut self.style.stroke } else { &mut self.style.fill }) = paint;
                }
            }
            "color" if inherits => style.color = inherited.color,
            "color" => style.color = color::read(value).map_or(style.color, |c| c.0),
            "visibility" if inherits => style.visible = inherited.visible,
            "visibility" => style.visible = !(is(value, "hidden") || is(value, "collapse")),
            "display" => self.own.undisplayed = is(value, "none"),
            "opacity" => self.own.transparent = is_zero(value),
            "stroke-opacity" => style.stroke_opaque = !is_zero(value),
            "fill-opacity" => style.fill_opaque = !is_zero(value),
            "stroke-width" => {
                style.width = self.lengths.read(value, Axis::Diagonal).unwrap_or(style.width);
            }
            "stroke-dasharray" => style.dashed = value.bytes().any(|b| b.is_ascii_digit() && b != b'0'),
            "transform" => self.own.transform = Some(value.to_owned()),
            "transform-origin" => self.own.origin = Some(value.to_owned()),
            "transform-box" => self.own.own_box = !matches!(value, "view-box" | "initial" | "unset"),
            // A reference, or a basic shape such as `circle(5px)`.
            "clip-path" => self.own.clipped = value.contains('('),
            "mask" => self.own.masked = is_reference,
            "marker" | "marker-start" | "marker-mid" | "marker-end" => self.own.marked |= is_reference,
            _ => {}
        }
    }

    /// A paint; `None` if the value is none, so that it is ignored.
    fn paint(&self, value: &str) -> Option<Paint> {
        Some(match value {
            _ if is(value, "none") => Paint::None,
            _ if is(value, "currentColor") => Paint::Current,
            "context-fill" | "context-stroke" => Paint::Other,
            _ => match value.strip_prefix("url(") {
                Some(reference) => {
                    let id = reference.split(')').next().unwrap_or_default();
                    let id = id.trim().trim_matches(['"', '\'']).trim_start_matches('#');
                    let server = self.document.by_id(id).map(|e| self.document.name(e));
                    if server == Some("pattern") { Paint::Pattern } else { Paint::Other }
                }
                None => match color::read(value)? {
                    (rgb, true) => Paint::Color(rgb),
                    (_, false) => Paint::None,
                },
            },
        })
    }
}

/// Whether a value is this keyword. Upper and lower case mean the same.
fn is(value: &str, keyword: &str) -> bool {
    value.eq_ignore_ascii_case(keyword)
}

fn is_zero(value: &str) -> bool {
    let mut scanner = Scanner::new(value);
    scanner.number().is_some_and(|v| v <= 0.0) && matches!(scanner.rest(), b"" | b"%")
}
