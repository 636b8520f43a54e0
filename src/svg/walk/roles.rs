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
    name.filter(|_| is_top && by_illustrator).map(|n| n.replace("_x20_", " "))
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
