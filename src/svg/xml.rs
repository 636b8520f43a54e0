//! The elements and attributes of an XML file, as a flat tree.
//!
//! `quick-xml` finds the tags; this module resolves namespaces, expands entities and keeps the text of style sheets. It
//! works without recursion, so that deep nesting takes no stack.

use super::entities::Entities;
use crate::drawing::{Limits, ReadError};
use quick_xml::Reader;
use quick_xml::events::Event;
use quick_xml::events::attributes::Attributes;
use rustc_hash::FxHashMap;
use std::borrow::Cow;

/// Deepest nesting of elements that is read. Drawing programs nest groups 10 to 30 deep; libxml2 stops at the same depth.
const DEEPEST: usize = 256;
/// Most namespace declarations in force at one place. Inkscape writes about ten.
const MOST_NAMESPACES: usize = 256;

/// Most characters that are kept of comments before the root element.
const LONGEST_PREAMBLE: usize = 4096;

/// A namespace that matters here.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Space {
    /// No namespace.
    None,
    /// `http://www.w3.org/2000/svg`.
    Svg,
    /// `http://www.w3.org/1999/xlink`.
    Xlink,
    /// `http://www.inkscape.org/namespaces/inkscape`.
    Inkscape,
    /// Any other.
    Other,
}

impl Space {
    fn of(uri: &str) -> Self {
        match uri {
            "" => Self::None,
            "http://www.w3.org/2000/svg" => Self::Svg,
            "http://www.w3.org/1999/xlink" => Self::Xlink,
            "http://www.inkscape.org/namespaces/inkscape" => Self::Inkscape,
            _ => Self::Other,
        }
    }
}

/// An attribute.
#[derive(Debug)]
pub(super) struct Attribute<'a> {
    pub(super) space: Space,
    /// Name without prefix.
    pub(super) name: &'a str,
    /// Value with entities expanded.
    pub(super) value: Cow<'a, str>,
}

/// An element. Its children follow it in the list of elements.
#[derive(Debug)]
pub(super) struct Element<'a> {
    /// Name without prefix; empty for an element of another namespace, which SVG ignores.
    pub(super) name: &'a str,
    /// Index of the element around it.
    pub(super) parent: Option<u32>,
    /// Index of the first element after it that is not inside it.
    pub(super) end: u32,
    first_attribute: u32,
    last_attribute: u32,
}

/// The elements of a file in document order.
#[derive(Debug, Default)]
pub(super) struct Document<'a> {
    pub(super) elements: Vec<Element<'a>>,
    attributes: Vec<Attribute<'a>>,
    ids: FxHashMap<String, u32>,
    /// The text of all `style` elements.
    pub(super) style: String,
    /// The comments before the root element, where Illustrator and other programs write their names.
    pub(super) preamble: String,
    /// Number of entities in the text of elements that are not expanded.
    pub(super) entities_left: u32,
}

impl<'a> Document<'a> {
    /// An attribute of SVG itself, which has no namespace.
    pub(super) fn attribute(&self, element: u32, name: &str) -> Option<&str> {
        self.attribute_in(element, Space::None, name)
    }

    /// An attribute in a namespace.
    pub(super) fn attribute_in(&self, element: u32, space: Space, name: &str) -> Option<&str> {
        self.attributes(element).iter().find(|a| a.space == space && a.name == name).map(|a| a.value.as_ref())
    }

    /// All attributes of an element.
    pub(super) fn attributes(&self, element: u32) -> &[Attribute<'a>] {
        let range = self.get(element).map(|e| e.first_attribute as usize..e.last_attribute as usize);
        range.and_then(|r| self.attributes.get(r)).unwrap_or_default()
    }

    /// The element with this id; the first one if several have it, as in browsers.
    pub(super) fn by_id(&self, id: &str) -> Option<u32> {
        self.ids.get(id).copied()
    }

    pub(super) fn get(&self, element: u32) -> Option<&Element<'a>> {
        self.elements.get(element as usize)
    }

    /// Name of an element.
    pub(super) fn name(&self, element: u32) -> &'a str {
        self.get(element).map_or("", |e| e.name)
    }

    /// The children of an element, in order.
    pub(super) fn children(&self, element: u32) -> impl Iterator<Item = u32> + '_ {
        let end = self.get(element).map_or(0, |e| e.end);
        std::iter::successors(Some(element + 1), |&e| self.get(e).map(|e| e.end))
            .take_while(move |&e| e < end)
    }

    /// Whether Illustrator wrote the file.
    pub(super) fn is_by_illustrator(&self) -> bool {
        self.preamble.as_bytes().windows(17).any(|w| w == b"Adobe Illustrator")
    }

    /// The version of SVG that the root names (`SVG 1.1`).
    pub(super) fn version(&self) -> Option<String> {
        self.attribute(0, "version").filter(|v| !v.is_empty() && v.len() < 20).map(|v| format!("SVG {v}"))
    }
}

/// Reads the elements of a file.
///
/// # Errors
/// The XML is damaged, its root is not `svg`, or it exceeds a limit.
pub(super) fn read<'a>(text: &'a str, limits: &Limits) -> Result<Document<'a>, ReadError> {
    let mut builder = Builder {
        text,
        most: limits.elements,
        document: Document::default(),
        entities: Entities::default(),
        open: Vec::new(),
        namespaces: Vec::new(),
        bare_root: false,
    };
    builder.run()?;
    let Builder { document, .. } = builder;
    if document.elements.is_empty() {
        return Err(ReadError::NotADrawing(
            "The file ends before its first element. Save the SVG again.".to_owned(),
        ));
    }
    Ok(document)
}

struct Builder<'a> {
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
    fn run(&mut self) -> Result<(), ReadError> {
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
                Event::Eof if self.open.is_empty() => return Ok(()),
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
                // Programs write one line; a longer comment is not their name.
                Event::Comment(comment)
                    if self.document.elements.is_empty()
                        && self.document.preamble.len() + comment.len() < LONGEST_PREAMBLE =>
                {
                    self.document.preamble.push_str(&comment);
                }
                Event::DocType(_) => {
                    self.entities = Entities::declared(self.text.get(from..to).unwrap_or_default())?;
                }
                Event::Text(text) if self.in_style() => self.document.style.push_str(&text),
                Event::CData(text) if self.in_style() => self.document.style.push_str(&text),
                Event::GeneralRef(name) => self.reference(&name),
                _ => {}
            }
        }
    }

    /// Opens an element, whose tag is `text[from..to]` and ends with `tail` characters after its attributes.
    fn start(&mut self, from: usize, to: usize, tail: usize) -> Result<(), ReadError> {
        if self.open.len() >= DEEPEST {
            return Err(ReadError::Limit(format!(
                "Groups are nested more than {DEEPEST} deep at line {}. Ungroup them in the drawing program and save again.",
                self.line(from)
            )));
        }
        if self.document.elements.len() >= self.most {
            return Err(ReadError::Limit(format!(
                "The SVG has more than {} elements. Delete what is not to be cut, or split the drawing.",
                self.most
            )));
        }
        let tag = self.text.get(from + 1..to.saturating_sub(tail)).unwrap_or_default();
        let length = tag.bytes().position(|b| b.is_ascii_whitespace()).unwrap_or(tag.len());
        let depth = self.open.len();
        let first_attribute = index(self.document.attributes.len());
        let mut declared = Vec::new();
        let mut attributes = Attributes::new(tag, length);
        for attribute in attributes.with_checks(false) {
            let Ok(attribute) = attribute else {
                return Err(self.damaged(from, "an attribute is not written as name=\"value\""));
            };
            let name = attribute.key.into_inner();
            let Cow::Borrowed(raw) = attribute.value else { continue };
            let value = self.entities.expand(raw)?;
            match name.split_once(':') {
                _ if name == "xmlns" => declared.push((depth, "", Space::of(&value))),
                Some(("xmlns", prefix)) => declared.push((depth, prefix, Space::of(&value))),
                // The namespace of a prefix is known when all attributes of the tag are.
                _ => self.document.attributes.push(Attribute { space: Space::None, name, value }),
            }
        }
        self.namespaces.extend(declared);
        if self.namespaces.len() > MOST_NAMESPACES {
            let message = format!(
                "More than {MOST_NAMESPACES} namespaces are declared at line {}. Save the SVG again as plain SVG.",
                self.line(from)
            );
            return Err(ReadError::Limit(message));
        }
        let namespaces = &self.namespaces;
        let space_of = |prefix: &str| namespaces.iter().rev().find(|n| n.1 == prefix).map(|n| n.2);
        for a in &mut self.document.attributes[first_attribute as usize..] {
            if let Some((prefix, local)) = a.name.split_once(':') {
                // Without its declaration, `xlink:href` is still understood, as browsers do in web pages.
                a.space =
                    space_of(prefix).unwrap_or(if prefix == "xlink" { Space::Xlink } else { Space::Other });
                a.name = local;
            }
        }
        let name = tag.get(..length).unwrap_or_default();
        let (prefix, local) = name.split_once(':').unwrap_or(("", name));
        let space = space_of(prefix).unwrap_or(if prefix.is_empty() { Space::None } else { Space::Other });
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
        self.open.last().is_some_and(|&e| self.document.name(e) == "style")
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

fn position(at: u64) -> usize {
    usize::try_from(at).unwrap_or(usize::MAX)
}

fn index(n: usize) -> u32 {
    u32::try_from(n).unwrap_or(u32::MAX)
}
