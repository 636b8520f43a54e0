//! What an element is to the walk: a layer, a chosen child of a `switch`, or a definition that draws nothing.

use super::super::xml::{Document, Space};

/// The label of a group that is a layer.
pub(super) fn layer_label(document: &Document<'_>, element: u32, by_illustrator: bool) -> Option<String> {
    let id = || document.attribute(element, "id");
    let label = || document.attribute_in(element, Space::Inkscape, "label");
    if document.attribute_in(element, Space::Inkscape, "groupmode") == Some("layer") {
        return label().or(id()).map(str::to_owned);
    }
    // Illustrator writes its layers as groups of the page, with their names as ids.
    let is_top = document.get(element).is_some_and(|e| e.parent == Some(0));
    let name = document.attribute(element, "data-name").or(id());
    name.filter(|_| is_top && by_illustrator).map(decoded)
}

/// A name as it was before Illustrator made it an id: `Cut_x20_1` is `Cut 1`, and `_x5F_` is an underscore.
fn decoded(id: &str) -> String {
    let mut name = String::with_capacity(id.len());
    let mut rest = id;
    while let Some((before, after)) = rest.split_once("_x") {
        let code = after.split_once('_').filter(|(digits, _)| (2..=4).contains(&digits.len()));
        let sign = code.and_then(|(digits, after)| {
            let code = u32::from_str_radix(digits, 16).ok()?;
            Some((char::from_u32(code)?, after))
        });
        name.push_str(before);
        rest = match sign {
            Some((sign, after)) => {
                name.push(sign);
                after
            }
            None => {
                name.push_str("_x");
                after
            }
        };
    }
    name + rest
}

/// Whether a `switch` shows this child: what needs an extension or another language is skipped.
pub(super) fn is_chosen(document: &Document<'_>, child: u32) -> bool {
    let attribute = |name: &str| document.attribute(child, name);
    let language =
        attribute("systemLanguage").is_none_or(|l| l.split(',').any(|l| l.trim().starts_with("en")));
    !document.name(child).is_empty() && attribute("requiredExtensions").is_none_or(str::is_empty) && language
}

/// Elements that draw nothing themselves.
pub(super) fn is_definition(name: &str) -> bool {
    const DEFINITIONS: [&str; 27] = [
        "defs",
        "symbol",
        "clipPath",
        "mask",
        "marker",
        "pattern",
        "linearGradient",
        "radialGradient",
        "meshgradient",
        "hatch",
        "filter",
        "style",
        "script",
        "title",
        "desc",
        "metadata",
        "view",
        "cursor",
        "font",
        "font-face",
        "color-profile",
        "solidColor",
        "animate",
        "animateTransform",
        "animateMotion",
        "animateColor",
        "set",
    ];
    DEFINITIONS.contains(&name)
}
