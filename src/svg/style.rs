//! The style of an element as far as cutting goes: stroke, fill, and what is visible.
//!
//! Attributes are the weakest, then come rules of style sheets, then the `style` attribute, then whatever is marked
//! `!important`.

use super::color::{self, Rgb};
use super::css::StyleSheet;
use super::declarations::{Declaration, declarations, without_comments};
use super::length::{Axis, Length, LengthUnit, Lengths};
use super::numbers::Scanner;
use super::own::{GEOMETRY, Own, Reference, path_of};
use super::steps::Steps;
use super::xml::{Document, Space};
use std::borrow::Cow;

/// What a line or an area is painted with.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Paint {
    None,
    Color(Rgb),
    /// A gradient, or a paint that is taken from elsewhere.
    Other,
    /// A pattern, whose own lines are not read.
    Pattern,
    /// A colour that cannot be read: `oklch()`, or `var()` of a property that is not known.
    Unread,
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

/// The style of an element inside one with the style `inherited`. `steps`: as for [`StyleSheet::matching`].
pub(super) fn resolve(
    document: &Document<'_>,
    sheet: &StyleSheet<'_>,
    element: u32,
    inherited: &Style,
    lengths: &Lengths,
    steps: &mut Steps,
) -> (Style, Own) {
    let rules = sheet.matching(document, element, steps);
    let mut cascade = Cascade {
        document,
        sheet,
        inherited,
        lengths,
        steps,
        style: *inherited,
        own: Own::default(),
        painted: [false; 2],
    };
    for a in document.attributes(element).iter().filter(|a| a.space == Space::None) {
        cascade.apply(a.name, a.value.trim());
    }
    let inline = without_comments(document.attribute(element, "style").unwrap_or_default());
    let inline: Vec<Declaration<'_>> = declarations(&inline).collect();
    for important in [false, true] {
        for d in rules.iter().chain(&inline).filter(|d| d.important == important) {
            let has_capitals = d.name.bytes().any(|b| b.is_ascii_uppercase());
            let name = if has_capitals { Cow::Owned(d.name.to_ascii_lowercase()) } else { d.name.into() };
            if !cascade.apply_property(&name, d.value) {
                cascade.apply(&name, d.value);
            }
        }
    }
    (cascade.style, cascade.own)
}

struct Cascade<'c> {
    document: &'c Document<'c>,
    sheet: &'c StyleSheet<'c>,
    inherited: &'c Style,
    lengths: &'c Lengths,
    steps: &'c mut Steps,
    style: Style,
    own: Own,
    /// Whether the element itself has set its stroke, and its fill.
    painted: [bool; 2],
}

impl Cascade<'_> {
    /// A value with custom properties replaced; `None` if that is not possible.
    fn replaced<'v>(&mut self, value: &'v str) -> Option<Cow<'v, str>> {
        if value.contains("var(") {
            self.sheet.custom.replaced(value, self.steps)
        } else {
            Some(value.into())
        }
    }

    /// Applies an attribute or a property.
    fn apply(&mut self, name: &str, value: &str) {
        const READ: [&str; 6] =
            ["visibility", "display", "opacity", "stroke-opacity", "fill-opacity", "transform"];
        let Some(value) = self.replaced(value) else {
            match name {
                "stroke" => self.set_paint(0, Paint::Unread),
                "fill" => self.set_paint(1, Paint::Unread),
                _ => self.own.unread |= READ.contains(&name),
            }
            return;
        };
        let value = value.as_ref();
        let (style, inherited) = (&mut self.style, self.inherited);
        let inherits = value == "inherit";
        let is_reference = value.starts_with("url(");
        match name {
            "stroke" | "fill" => {
                let k = usize::from(name == "fill");
                let paint = match value {
                    "inherit" | "unset" | "revert" => Some([inherited.stroke, inherited.fill][k]),
                    "initial" => Some([Style::INITIAL.stroke, Style::INITIAL.fill][k]),
                    _ => self.paint(value),
                };
                if let Some(paint) = paint {
                    self.set_paint(k, paint);
                }
            }
            "color" if inherits => style.color = inherited.color,
            "color" => style.color = color::read(value).map_or(style.color, |c| c.0),
            "visibility" if inherits => style.visible = inherited.visible,
            // What is no value changes nothing.
            "visibility" if is(value, "visible") => style.visible = true,
            "visibility" if is(value, "hidden") || is(value, "collapse") => style.visible = false,
            "display" => self.own.undisplayed = is(value, "none"),
            "opacity" => self.own.transparent = is_zero(value).unwrap_or(self.own.transparent),
            "stroke-opacity" => {
                style.stroke_opaque = is_zero(value).map_or(style.stroke_opaque, |zero| !zero)
            }
            "fill-opacity" => style.fill_opaque = is_zero(value).map_or(style.fill_opaque, |zero| !zero),
            "stroke-width" => {
                style.width = self.lengths.read(value, Axis::Diagonal).unwrap_or(style.width);
            }
            "stroke-dasharray" => style.dashed = value.bytes().any(|b| b.is_ascii_digit() && b != b'0'),
            "transform" => self.own.transform = Some(value.to_owned()),
            "transform-origin" => self.own.origin = Some(value.to_owned()),
            "transform-box" => {
                self.own.reference = match value {
                    "fill-box" | "content-box" => Reference::Fill,
                    "stroke-box" | "border-box" => Reference::Stroke,
                    _ => Reference::View,
                };
            }
            // A reference, or a basic shape such as `circle(5px)`.
            "clip-path" => self.own.clipped = value.contains('('),
            "mask" => self.own.masked = is_reference,
            "marker" | "marker-start" | "marker-mid" | "marker-end" => self.own.marked |= is_reference,
            _ => {}
        }
    }

    /// Applies what is a property only: as an attribute, it is none, or has another syntax. Returns whether it is one of these.
    fn apply_property(&mut self, name: &str, value: &str) -> bool {
        let is_geometry = GEOMETRY.contains(&name);
        let which = ["translate", "rotate", "scale"].iter().position(|n| *n == name);
        if !is_geometry && which.is_none() && !matches!(name, "offset" | "offset-path") {
            return false;
        }
        let Some(value) = self.replaced(value) else {
            self.own.unread = true;
            return true;
        };
        match which {
            Some(k) => self.own.moves[k] = Some(value.into_owned()).filter(|v| v != "none"),
            None if name == "d" => match path_of(&value) {
                Some(data) => self.own.geometry.push((name.to_owned(), data.to_owned())),
                None => self.own.unread = true,
            },
            None if is_geometry => {
                // Only 0 needs no unit: browsers ignore other numbers.
                let is_bare = |l: Length| l.unit == LengthUnit::None && l.number.abs() > 0.0;
                if !Length::read(&value).is_some_and(is_bare) {
                    self.own.geometry.push((name.to_owned(), value.into_owned()));
                }
            }
            None => self.own.unread |= value != "none",
        }
        true
    }

    fn set_paint(&mut self, which: usize, paint: Paint) {
        // Programs write a colour that all read before one that few read.
        if paint == Paint::Unread && self.painted[which] {
            return;
        }
        self.painted[which] = true;
        *(if which == 0 { &mut self.style.stroke } else { &mut self.style.fill }) = paint;
    }

    /// A paint; `None` if the value is none, so that it is ignored.
    fn paint(&self, value: &str) -> Option<Paint> {
        Some(match value {
            "context-fill" | "context-stroke" => Paint::Other,
            _ => match value.strip_prefix("url(") {
                Some(reference) => {
                    let (id, otherwise) = reference.split_once(')').unwrap_or((reference, ""));
                    let id = id.trim().trim_matches(['"', '\'']);
                    let server = self.document.by_id(id.trim_start_matches('#'));
                    match server.map(|e| self.document.name(e)) {
                        Some("pattern") => Paint::Pattern,
                        None if id.starts_with('#') => match otherwise.trim() {
                            "" => Paint::None,
                            otherwise => color_paint(otherwise)?,
                        },
                        _ => Paint::Other,
                    }
                }
                None => color_paint(value)?,
            },
        })
    }
}

/// A paint that is a colour, or none.
fn color_paint(value: &str) -> Option<Paint> {
    Some(match color::read(value) {
        _ if is(value, "none") => Paint::None,
        _ if is(value, "currentColor") => Paint::Current,
        Some((rgb, true)) => Paint::Color(rgb),
        Some((_, false)) => Paint::None,
        None if value.contains('(') => Paint::Unread,
        None => return None,
    })
}

/// Whether a value is this keyword. Upper and lower case mean the same.
fn is(value: &str, keyword: &str) -> bool {
    value.eq_ignore_ascii_case(keyword)
}

/// Whether a number or percentage is 0; `None` if it is none.
fn is_zero(value: &str) -> Option<bool> {
    let mut scanner = Scanner::new(value);
    let number = scanner.number().filter(|_| matches!(scanner.rest(), b"" | b"%"));
    number.map(|v| v <= 0.0)
}
