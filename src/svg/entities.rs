//! Entities that the document type declares, as Illustrator does for its namespaces.
//!
//! An entity that contains others can expand to any size ("billion laughs"), and a long one that is used often does so
//! as well. Drawing programs write neither, so both are refused.

use crate::drawing::ReadError;
use rustc_hash::FxHashMap;
use std::borrow::Cow;

/// Longest value of an entity. Illustrator's are addresses of about fifty characters.
const LONGEST: usize = 4096;
/// Most characters that all entities of a file expand to. Only a file made to exhaust memory has more.
const MOST: usize = 1 << 24;

/// The entities of a file.
#[derive(Debug, Default)]
pub(super) struct Entities<'a> {
    values: FxHashMap<&'a str, &'a str>,
    longest: usize,
    expanded: usize,
}

impl<'a> Entities<'a> {
    /// The entities that a document type declaration defines.
    pub(super) fn declared(doctype: &'a str) -> Result<Self, ReadError> {
        let mut entities = Self::default();
        for declaration in doctype.split("<!ENTITY").skip(1) {
            let mut rest = declaration.trim_start();
            // A parameter entity (`% name`) only serves the document type itself.
            if rest.starts_with('%') {
                continue;
            }
            let end = rest.find(|c: char| c.is_whitespace()).unwrap_or(rest.len());
            let (name, after) = rest.split_at(end);
            rest = after.trim_start();
            // What has no quoted value here is in another file, which is not read.
            let Some(quote) = rest.chars().next().filter(|q| matches!(q, '"' | '\'')) else { continue };
            let Some((value, _)) = rest.get(1..).unwrap_or_default().split_once(quote) else { continue };
            if value.bytes().any(|b| b == b'&') || value.len() > LONGEST {
                return Err(bomb(name));
            }
            entities.longest = entities.longest.max(value.len());
            entities.values.entry(name).or_insert(value);
        }
        Ok(entities)
    }

    pub(super) fn is_declared(&self, name: &str) -> bool {
        self.values.contains_key(name)
    }

    /// A value with its entities and character references expanded. An unknown one is kept as written.
    pub(super) fn expand(&mut self, raw: &'a str) -> Result<Cow<'a, str>, ReadError> {
        let references = raw.bytes().filter(|b| *b == b'&').count();
        if references == 0 {
            return Ok(Cow::Borrowed(raw));
        }
        self.expanded = self.expanded.saturating_add(references.saturating_mul(self.longest));
        if self.expanded > MOST {
            return Err(bomb(""));
        }
        let value_of = |name: &str| {
            let known = quick_xml::escape::resolve_predefined_entity(name);
            known.or_else(|| self.values.get(name).copied())
        };
        Ok(quick_xml::escape::unescape_with(raw, value_of).unwrap_or(Cow::Borrowed(raw)))
    }
}

fn bomb(name: &str) -> ReadError {
    let which = if name.is_empty() {
        "The entities of the SVG expand".to_owned()
    } else {
        format!("The entity \"{}\" of the SVG may expand", name.chars().take(40).collect::<String>())
    };
    ReadError::Limit(format!(
        "{which} to more text than a drawing has. Save the drawing again as plain SVG, without a document type."
    ))
}
