//! Builds the flat tree of an XML file from its tags.

use super::super::entities::Entities;
use super::document::{Attribute, Document, Element, Space};
use crate::drawing::{Limits, ReadError};
use quick_xml::Reader;
use quick_xml::events::Event;
use quick_xml::events::attributes::Attributes;
use std::borrow::Cow;

/// Deepest nesting of elements that is read. Drawing programs nest groups 10 to 30 deep; libxml2 stops at the same depth.
const DEEPEST: usize = 256;
/// Most namespace declarations in force at one place. Inkscape writes about ten.
const MOST_NAMESPACES: usize = 256;

/// Most characters that are kept of comments before the first element in the root.
const LONGEST_PREAMBLE: usize = 4096;

pub(super) struct Builder<'a> {
    text: &'a str,
    most: usize,
    document: Document<'a>,
    entities: Entities<'a>,
    open: Vec<u32>,
    /// Namespace declarations in force: nesting depth, prefix and namespace.
    namespaces: Vec<(usize, &'a str, Space)>,
    /// Whether the root has no namespace, as in SVG written by hand or cut out of a web page.
    bare_root: bool,
}

impl<'a> Builder<'a> {
    pub(super) fn new(text: &'a str, limits: &Limits) -> Self {
        Self {
            text,
            most: limits.elements,
            document: Document::default(),
            entities: Entities::default(),
            open: Vec::new(),
            namespaces: Vec::new(),
            bare_root: false,
        }
    }

    /// The elements of the whole file.
    pub(super) fn run(mut self) -> Result<Document<'a>, ReadError> {
        let mut reader = Reader::from_str(self.text);
        loop {
            let from = position(reader.buffer_position());
            let event = match reader.read_event() {
                Ok(event) => event,
                Err(error) => {
                    return Err(self.damaged(position(reader.error_position()).max(from), &error.to_string()));
                }
            };
            let to = position(reader.buffer_position());
            match event {
                Event::Eof if self.open.is_empty() => return Ok(self.document),
                Event::Eof => {
                    let message = "The SVG ends in the middle: it was probably not copied whole. Save or download it again.";
                    return Err(ReadError::NotADrawing(message.to_owned()));
                }
                Event::Start(_) => self.start(from, to, 1)?,
                Event::Empty(_) => {
                    self.start(from, to, 2)?;
                    self.end();
                }
                Event::End(_) => self.end(),
                // Programs write one line; a longer comment is not their name. Illustrator writes it into the root since 2024.
                Event::Comment(comment)
                    if self.document.elements.len() <= 1
                        && self.document.preamble.len() + comment.len() < LONGEST_PREAMBLE =>
                {
                    self.document.preamble.push_str(&comment);
                }
                Event::DocType(_) => {
                    self.entities = Entities::declared(self.text.get(from..to).unwrap_or_default())?;
                }
                Event::Text(text) if self.in_style() => self.document.style.push_str(&text),
                Event::CData(text) if self.in_style() => self.document.style.push_str(&text),
                Event::PI(instruction) if instruction.starts_with("xml-stylesheet") => {
                    self.document.sheets_left += 1;
                }
                Event::GeneralRef(name) => self.reference(&name),
                _ => {}
            }
        }
    }

    /// Opens an element, whose tag is `text[from..to]` and ends with `tail` characters after its attributes.
    fn start(&mut self, from: usize, to: usize, tail: usize) -> Result<(), ReadError> {
        self.check_limits(from)?;
        let tag = self.text.get(from + 1..to.saturating_sub(tail)).unwrap_or_default();
        let length = tag.bytes().position(|b| b.is_ascii_whitespace()).unwrap_or(tag.len());
        let first_attribute = index(self.document.attributes.len());
        self.attributes(tag, length, from)?;
        let name = tag.get(..length).unwrap_or_default();
        let (prefix, local) = name.split_once(':').unwrap_or(("", name));
        let unknown = if prefix.is_empty() { Space::None } else { Space::Other };
        let space = space_of(&self.namespaces, prefix).unwrap_or(unknown);
        if self.document.elements.is_empty() {
            self.bare_root = space == Space::None;
            if local != "svg" || !matches!(space, Space::Svg | Space::None) {
                return Err(ReadError::NotADrawing(
                    "This is an XML file, but not an SVG: its first element is not svg. Save the drawing as SVG or DXF.".to_owned(),
                ));
            }
        }
        let is_svg = space == Space::Svg || (space == Space::None && self.bare_root);
        let this = index(self.document.elements.len());
        let attributes = self.document.attributes.get(first_attribute as usize..).unwrap_or_default();
        if let Some(id) = attributes.iter().find(|a| a.name == "id" && a.space == Space::None) {
            self.document.ids.entry(id.value.clone().into_owned()).or_insert(this);
        }
        self.document.elements.push(Element {
            name: if is_svg { local } else { "" },
            parent: self.open.last().copied(),
            end: this + 1,
            first_attribute,
            last_attribute: index(self.document.attributes.len()),
        });
        self.open.push(this);
        self.document.sheets_left += u32::from(local == "style" && is_svg && !self.is_applied(this));
        Ok(())
    }

    /// Refuses files with too many elements, and elements too deep inside others.
    fn check_limits(&self, at: usize) -> Result<(), ReadError> {
        if self.open.len() >= DEEPEST {
            return Err(ReadError::Limit(format!(
                "Groups are nested more than {DEEPEST} deep at line {}. Ungroup them in the drawing program and save again.",
                self.line(at)
            )));
        }
        if self.document.elements.len() >= self.most {
            return Err(ReadError::Limit(format!(
                "The SVG has more than {} elements. Delete what is not to be cut, or split the drawing.",
                self.most
            )));
        }
        Ok(())
    }

    /// Reads the attributes of a tag, whose name has this length, and the namespaces that it declares.
    fn attributes(&mut self, tag: &'a str, length: usize, at: usize) -> Result<(), ReadError> {
        let depth = self.open.len();
        let first = self.document.attributes.len();
        for attribute in Attributes::new(tag, length).with_checks(false) {
            let Ok(attribute) = attribute else {
                return Err(self.damaged(at, "an attribute is not written as name=\"value\""));
            };
            let name = attribute.key.into_inner();
            let Cow::Borrowed(raw) = attribute.value else { continue };
            let value = self.entities.expand(raw)?;
            match name.split_once(':') {
                _ if name == "xmlns" => self.namespaces.push((depth, "", Space::of(&value))),
                Some(("xmlns", prefix)) => self.namespaces.push((depth, prefix, Space::of(&value))),
                // The namespace of a prefix is known when all attributes of the tag are.
                _ => self.document.attributes.push(Attribute { space: Space::None, name, value }),
            }
        }
        if self.namespaces.len() > MOST_NAMESPACES {
            let message = format!(
                "More than {MOST_NAMESPACES} namespaces are declared at line {}. Save the SVG again as plain SVG.",
                self.line(at)
            );
            return Err(ReadError::Limit(message));
        }
        for a in self.document.attributes.iter_mut().skip(first) {
            if let Some((prefix, local)) = a.name.split_once(':') {
                // Without its declaration, `xlink:href` is still understood, as browsers do in web pages.
                let unknown = if prefix == "xlink" { Space::Xlink } else { Space::Other };
                a.space = space_of(&self.namespaces, prefix).unwrap_or(unknown);
                a.name = local;
            }
        }
        Ok(())
    }

    fn end(&mut self) {
        let Some(closed) = self.open.pop() else { return };
        let end = index(self.document.elements.len());
        if let Some(element) = self.document.elements.get_mut(closed as usize) {
            element.end = end;
        }
        let depth = self.open.len();
        while self.namespaces.pop_if(|n| n.0 >= depth).is_some() {}
    }

    fn in_style(&self) -> bool {
        self.open.last().is_some_and(|&e| self.document.name(e) == "style" && self.is_applied(e))
    }

    /// Whether a style sheet is one of CSS, and for screens.
    fn is_applied(&self, sheet: u32) -> bool {
        const SCREENS: [&str; 5] = ["", "all", "screen", "only all", "only screen"];
        let value =
            |name: &str| self.document.attribute(sheet, name).unwrap_or_default().trim().to_ascii_lowercase();
        let (language, media) = (value("type"), value("media"));
        matches!(language.as_str(), "" | "text/css")
            && media.split(',').any(|one| SCREENS.contains(&one.trim()))
    }

    /// A reference to an entity in the text of an element.
    fn reference(&mut self, name: &str) {
        if self.in_style() {
            self.document
                .style
                .push_str(quick_xml::escape::resolve_predefined_entity(name).unwrap_or_default());
        } else if self.entities.is_declared(name) {
            self.document.entities_left += 1;
        }
    }

    fn damaged(&self, at: usize, what: &str) -> ReadError {
        ReadError::NotADrawing(format!(
            "The SVG is damaged at line {} ({}). Open it in the program that made it and save it again.",
            self.line(at),
            what.trim_end_matches('.')
        ))
    }

    /// Line number of a position, from 1.
    fn line(&self, at: usize) -> usize {
        let before = self.text.as_bytes().get(..at).unwrap_or(self.text.as_bytes());
        1 + before.iter().filter(|b| **b == b'\n').count()
    }
}

/// The namespace of a prefix: the innermost declaration counts.
fn space_of(namespaces: &[(usize, &str, Space)], prefix: &str) -> Option<Space> {
    namespaces.iter().rev().find(|n| n.1 == prefix).map(|n| n.2)
}

fn position(at: u64) -> usize {
    usize::try_from(at).unwrap_or(usize::MAX)
}

fn index(n: usize) -> u32 {
    u32::try_from(n).unwrap_or(u32::MAX)
}
