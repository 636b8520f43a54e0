//! The flat tree of an XML file.

use rustc_hash::FxHashMap;
use std::borrow::Cow;

/// A namespace that matters here.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::svg) enum Space {
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
    pub(in crate::svg) fn of(uri: &str) -> Self {
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
pub(in crate::svg) struct Attribute<'a> {
    pub(in crate::svg) space: Space,
    /// Name without prefix.
    pub(in crate::svg) name: &'a str,
    /// Value with entities expanded.
    pub(in crate::svg) value: Cow<'a, str>,
}

/// An element. Its children follow it in the list of elements.
#[derive(Debug)]
pub(in crate::svg) struct Element<'a> {
    /// Name without prefix; empty for an element of another namespace, which SVG ignores.
    pub(in crate::svg) name: &'a str,
    /// Index of the element around it.
    pub(in crate::svg) parent: Option<u32>,
    /// Index of the first element after it that is not inside it.
    pub(in crate::svg) end: u32,
    pub(in crate::svg) first_attribute: u32,
    pub(in crate::svg) last_attribute: u32,
}

/// The elements of a file in document order.
#[derive(Debug, Default)]
pub(in crate::svg) struct Document<'a> {
    pub(in crate::svg) elements: Vec<Element<'a>>,
    pub(in crate::svg) attributes: Vec<Attribute<'a>>,
    pub(in crate::svg) ids: FxHashMap<String, u32>,
    /// The text of all `style` elements.
    pub(in crate::svg) style: String,
    /// The comments before the first element in the root, where Illustrator and other programs write their names.
    pub(in crate::svg) preamble: String,
    /// Number of style sheets that are not part of the file, or not for screens.
    pub(in crate::svg) sheets_left: u32,
    /// Number of entities in the text of elements that are not expanded.
    pub(in crate::svg) entities_left: u32,
}

impl<'a> Document<'a> {
    /// An attribute of SVG itself, which has no namespace.
    pub(in crate::svg) fn attribute(&self, element: u32, name: &str) -> Option<&str> {
        self.attribute_in(element, Space::None, name)
    }

    /// An attribute in a namespace.
    pub(in crate::svg) fn attribute_in(&self, element: u32, space: Space, name: &str) -> Option<&str> {
        self.attributes(element).iter().find(|a| a.space == space && a.name == name).map(|a| a.value.as_ref())
    }

    /// All attributes of an element.
    pub(in crate::svg) fn attributes(&self, element: u32) -> &[Attribute<'a>] {
        let range = self.get(element).map(|e| e.first_attribute as usize..e.last_attribute as usize);
        range.and_then(|r| self.attributes.get(r)).unwrap_or_default()
    }

    /// The texts of an attribute of SVG on all elements.
    pub(in crate::svg) fn texts_of(&self, name: &str) -> impl Iterator<Item = &str> {
        self.attributes
            .iter()
            .filter(move |a| a.space == Space::None && a.name == name)
            .map(|a| a.value.as_ref())
    }

    /// The element with this id; the first one if several have it, as in browsers.
    pub(in crate::svg) fn by_id(&self, id: &str) -> Option<u32> {
        self.ids.get(id).copied()
    }

    pub(in crate::svg) fn get(&self, element: u32) -> Option<&Element<'a>> {
        self.elements.get(element as usize)
    }

    /// Name of an element.
    pub(in crate::svg) fn name(&self, element: u32) -> &'a str {
        self.get(element).map_or("", |e| e.name)
    }

    /// The children of an element, in order.
    pub(in crate::svg) fn children(&self, element: u32) -> impl Iterator<Item = u32> + '_ {
        let end = self.get(element).map_or(0, |e| e.end);
        std::iter::successors(Some(element + 1), |&e| self.get(e).map(|e| e.end))
            .take_while(move |&e| e < end)
    }

    /// Whether Illustrator wrote the file.
    pub(in crate::svg) fn is_by_illustrator(&self) -> bool {
        self.preamble.as_bytes().windows(17).any(|w| w == b"Adobe Illustrator")
    }

    /// The version of SVG that the root names (`SVG 1.1`).
    pub(in crate::svg) fn version(&self) -> Option<String> {
        self.attribute(0, "version").filter(|v| !v.is_empty() && v.len() < 20).map(|v| format!("SVG {v}"))
    }
}
