//! The elements and attributes of an XML file, as a flat tree.
//!
//! `quick-xml` finds the tags; `builder.rs` resolves namespaces, expands entities and keeps the text of style sheets. It works
//! without recursion, so that deep nesting takes no stack.

mod builder;
mod document;

use crate::drawing::{Limits, ReadError};
use builder::Builder;
pub(super) use document::{Document, Space};

/// Reads the elements of a file.
///
/// # Errors
/// The XML is damaged, its root is not `svg`, or it exceeds a limit.
pub(super) fn read<'a>(text: &'a str, limits: &Limits) -> Result<Document<'a>, ReadError> {
    let document = Builder::new(text, limits).run()?;
    if document.elements.is_empty() {
        return Err(ReadError::NotADrawing(
            "The file ends before its first element. Save the SVG again.".to_owned(),
        ));
    }
    Ok(document)
}
