//! Walks through the drawing: groups, nested pages and copies, down to shapes with their place and style.
//!
//! The walk keeps a stack of its own, so that nesting takes no stack of the machine. Every element that is visited counts
//! against a limit, which copies of copies soon reach: such a file is refused. So are long chains of copies and rules that
//! are compared with all ancestors of all elements, which take time and make nothing.

mod copies;
mod roles;
mod shapes;
mod transforms;

use super::css::StyleSheet;
use super::declarations::{declarations, without_comments};
use super::layers::Key;
use super::length::{Length, Lengths};
use super::own::Own;
use super::report::Report;
use super::scale::Scale;
use super::shape;
use super::steps::Steps;
use super::style::{self, Style};
use super::subject::{Hidden, Subject};
use super::viewport;
use super::xml::Document;
use crate::drawing::{EntityKindCount, ReadError, ReadOptions, Shape};
use crate::geometry::{Affine, DVec2};
use std::collections::BTreeMap;

/// What a walk found.
pub(super) struct Walked {
    /// Shapes with the key of their layer.
    pub(super) shapes: Vec<(Key, Shape)>,
    /// Labels of the groups that are layers.
    pub(super) groups: Vec<String>,
    /// Elements by kind, most frequent first.
    pub(super) kinds: Vec<EntityKindCount>,
    pub(super) report: Report,
}

/// Walks through all that is drawn.
///
/// # Errors
/// The drawing has more elements than the limits allow, with all copies, takes too long, or lies too far from its origin.
pub(super) fn walk(
    document: &Document<'_>,
    scale: &Scale,
    options: &ReadOptions,
) -> Result<Walked, ReadError> {
    let css = without_comments(&document.style);
    let mut sheet = StyleSheet::read(&css);
    for text in document.texts_of("style").filter(|text| text.contains("--")) {
        sheet.custom.add(declarations(text));
    }
    let mut walker = Walker {
        document,
        sheet: &sheet,
        options,
        dpi: scale.dpi,
        by_illustrator: document.is_by_illustrator(),
        open: Vec::new(),
        copies: Vec::new(),
        visited: 0,
        steps: Steps::new(options.limits.bytes),
        elements: 0,
        far: 0,
        kinds: BTreeMap::new(),
        walked: Walked {
            shapes: Vec::new(),
            groups: Vec::new(),
            kinds: Vec::new(),
            report: Report::default(),
        },
    };
    walker.walked.report.count_all(Subject::Rules, sheet.not_understood);
    walker.walked.report.count_all(Subject::Sheets, document.sheets_left);
    walker.walked.report.count_all(Subject::Entities, document.entities_left);
    let place = Place {
        map: scale.map,
        style: Style::INITIAL,
        viewport: scale.viewport,
        group: None,
        hidden: None,
        copy: None,
    };
    walker.root(&place);
    walker.run()?;
    walker.finish()
}

/// Where an element is, and what it inherits.
#[derive(Clone, Copy)]
struct Place {
    /// User units to mm on the sheet.
    map: Affine,
    style: Style,
    viewport: DVec2,
    /// Index of the layer around it.
    group: Option<u32>,
    /// Why nothing here is drawn.
    hidden: Option<Hidden>,
    /// Index of the innermost copy (`use`) around it.
    copy: Option<u32>,
}

/// Elements that are still to be visited at one place.
struct Frame {
    next: u32,
    end: u32,
    place: Place,
    /// The size that a `use` gives to the `symbol` or `svg` it copies.
    instance: Option<[Option<f64>; 2]>,
}

/// A `use` with its target.
struct Copy {
    target: u32,
    outer: Option<u32>,
}

struct Walker<'w, 'a> {
    document: &'w Document<'a>,
    sheet: &'w StyleSheet<'w>,
    options: &'w ReadOptions,
    dpi: f64,
    by_illustrator: bool,
    open: Vec<Frame>,
    copies: Vec<Copy>,
    visited: usize,
    steps: Steps,
    elements: usize,
    far: usize,
    kinds: BTreeMap<&'a str, (u32, bool)>,
    walked: Walked,
}

impl<'w, 'a> Walker<'w, 'a> {
    fn run(&mut self) -> Result<(), ReadError> {
        while let Some(frame) = self.open.last_mut() {
            if frame.next >= frame.end {
                self.open.pop();
                continue;
            }
            let (element, place, instance) = (frame.next, frame.place, frame.instance);
            frame.next = self.document.get(element).map_or(frame.end, |e| e.end);
            self.visited += 1;
            self.check()?;
            self.element(element, &place, instance);
        }
        Ok(())
    }

    fn root(&mut self, place: &Place) {
        let (inside, own) = self.enter(0, place);
        if own.is_transformed() {
            self.walked.report.count(Subject::Page, None, None, None);
        }
        self.notes(0, &own, &inside);
        self.open_children(0, inside);
    }

    fn open_children(&mut self, element: u32, place: Place) {
        let end = self.document.get(element).map_or(0, |e| e.end);
        self.open.push(Frame { next: element + 1, end, place, instance: None });
    }

    /// The place inside an element, with its style and transform.
    fn enter(&mut self, element: u32, place: &Place) -> (Place, Own) {
        let lengths = self.lengths(place);
        self.steps.take(self.document.attributes(element).iter().map(|a| a.value.len()).sum());
        let (style, own) =
            style::resolve(self.document, self.sheet, element, &place.style, &lengths, &mut self.steps);
        let map = self.transforms(element, &own, place).then(&place.map);
        let hidden = place.hidden.or((own.undisplayed || own.transparent).then_some(Hidden::Gone));
        (Place { map, style, hidden, ..*place }, own)
    }

    /// Counts what an element asks for that is not done.
    fn notes(&mut self, element: u32, own: &Own, inside: &Place) {
        if inside.hidden.is_some() {
            return;
        }
        for (is_so, subject) in [
            (own.clipped, Subject::Clipped),
            (own.masked, Subject::Masked),
            (own.marked, Subject::Marked),
            (own.unread, Subject::Style),
            (self.is_misplaced(element, own), Subject::Length),
        ] {
            if is_so {
                self.walked.report.count(subject, None, self.id(element), None);
            }
        }
    }

    /// Whether a place or size of a copy or a page cannot be read. Those of shapes are found when they are drawn.
    fn is_misplaced(&self, element: u32, own: &Own) -> bool {
        let is_unread = |name: &str| {
            let text = own.geometry(self.document, element, name);
            text.is_some_and(|t| !shape::is_missing(t) && Length::read(t).is_none())
        };
        matches!(self.document.name(element), "use" | "svg" | "symbol")
            && ["x", "y", "width", "height"].into_iter().any(is_unread)
    }

    fn element(&mut self, element: u32, place: &Place, instance: Option<[Option<f64>; 2]>) {
        let name = self.document.name(element);
        if roles::is_definition(name) && !(name == "symbol" && instance.is_some()) {
            return;
        }
        let (mut inside, own) = self.enter(element, place);
        self.notes(element, &own, &inside);
        match name {
            "g" | "a" => {
                if let Some(label) = roles::layer_label(self.document, element, self.by_illustrator) {
                    inside.group = u32::try_from(self.walked.groups.len()).ok();
                    self.walked.groups.push(label);
                }
                self.open_children(element, inside);
            }
            "svg" | "symbol" => {
                let lengths = self.lengths(place);
                let (map, viewport) =
                    viewport::inside(self.document, element, &own, instance.unwrap_or_default(), &lengths);
                inside.map = map.then(&inside.map);
                inside.viewport = viewport;
                self.open_children(element, inside);
            }
            "switch" => {
                let mut children = self.document.children(element).inspect(|_| self.steps.take(1));
                let chosen = children.find(|c| roles::is_chosen(self.document, *c));
                if let Some(child) = chosen {
                    let end = self.document.get(child).map_or(0, |e| e.end);
                    self.open.push(Frame { next: child, end, place: inside, instance: None });
                } else {
                    inside.hidden = inside.hidden.or(Some(Hidden::Gone));
                    self.open_children(element, inside);
                }
            }
            "use" => {
                self.count_kind(name, true, place);
                self.copy(element, &own, inside);
            }
            _ => match shape::kind(name) {
                Some(kind) => {
                    self.count_kind(name, true, place);
                    self.shape(element, kind, &own, &inside);
                }
                None => {
                    self.count_kind(name, false, place);
                    self.unsupported(element, name, &inside);
                }
            },
        }
    }

    fn count_kind(&mut self, name: &'a str, supported: bool, place: &Place) {
        if place.copy.is_none() && !name.is_empty() {
            self.kinds.entry(name).or_insert((0, supported)).0 += 1;
        }
    }

    fn lengths(&self, place: &Place) -> Lengths {
        Lengths { dpi: self.dpi, viewport: place.viewport }
    }

    fn id(&self, element: u32) -> Option<&'w str> {
        self.document.attribute(element, "id")
    }

    fn check(&self) -> Result<(), ReadError> {
        let limit = self.options.limits.elements;
        if self.steps.are_used_up() {
            return Err(ReadError::Limit(
                "The copies (use) and style rules of the drawing take too long to work out. Turn copies into objects of their own, and save it as plain SVG."
                    .to_owned(),
            ));
        }
        if self.elements.max(self.visited) <= limit {
            return Ok(());
        }
        Err(ReadError::Limit(format!(
            "The drawing makes more than {limit} elements with all copies (use) expanded and curves turned into lines and arcs. Delete what is not to be cut."
        )))
    }

    fn finish(mut self) -> Result<Walked, ReadError> {
        self.check()?;
        if self.walked.shapes.is_empty() && self.far > 0 {
            return Err(ReadError::Limit(format!(
                "Everything in the drawing lies more than {} m from its origin. Check the units, or move the drawing onto its page and save again.",
                self.options.limits.coordinate / 1000.0
            )));
        }
        let count = |(kind, (count, supported)): (&str, (u32, bool))| EntityKindCount {
            kind: kind.to_owned(),
            count,
            supported,
        };
        self.walked.kinds = self.kinds.into_iter().map(count).collect();
        // The sort is stable, so kinds with equal counts stay in alphabetical order.
        crate::order::sort_by(&mut self.walked.kinds, |c| [u64::MAX - u64::from(c.count), 0, 0]);
        Ok(self.walked)
    }
}
