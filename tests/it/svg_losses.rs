//! What SVG files lost or moved without a word, and copies that took minutes.

use super::svg_files::{layers, page};
use crate::testkit::drawings::found;
use kerfway::finding::Code;
use std::time::{Duration, Instant};

/// A square with a red outline.
const SQUARE: &str = "<path d=\"M50 10h20v20h-20z\" fill=\"none\" stroke=\"red\"/>";

/// Each copy looked for a place among all 8,000 words of the text, which took 20 s.
#[test]
fn copies_of_a_text_of_many_words_are_read_at_once() {
    let (words, copies) = ("<tspan/>".repeat(8_000), "<use href=\"#t\"/>".repeat(8_000));
    let start = Instant::now();
    let drawing = page(&format!("{SQUARE}<text id=\"t\">{words}</text>{copies}"));
    assert!(start.elapsed() < Duration::from_secs(4), "{:?}", start.elapsed());
    assert_eq!(found(&drawing, Code::UnsupportedEntity).count, 8_001);
}

/// Only the nearest ancestor of a kind was tried.
#[test]
fn a_rule_holds_if_a_farther_ancestor_has_the_parent_it_asks_for() {
    let nested = |rule: &str, before: &str, after: &str| {
        let body = format!(
            "<style>{rule} {{fill:none;stroke:#00f}}</style>{before}<path d=\"M10 10h20v20h-20z\"/>{after}"
        );
        layers(&page(&body)).join(" ")
    };
    let deep = "<g class=\"cut\"><g class=\"a\"><g><g>";
    let end = "</g></g></g></g>";
    for (rule, holds) in [
        (".cut > g path", true),
        (".cut > .a > g path", true),
        ("svg > .cut > g g > path", true),
        (".cut > g > path", false),
        (".a > .a g path", false),
        ("svg > .a path", false),
    ] {
        let layer = if holds { "#0000ff" } else { "fill #000000" };
        assert_eq!(nested(rule, deep, end), layer, "{rule}");
    }
    // The first g around the path has no parent of this class, and the second one does not lie in a g.
    assert_eq!(nested("g .cut > g path", "<g class=\"cut\"><g><g>", "</g></g></g>"), "fill #000000");
}

/// Where no child of a `switch` was chosen, all of it was lost without a finding.
#[test]
fn a_switch_without_a_chosen_child_is_a_finding() {
    let in_german = format!("<switch><g systemLanguage=\"de\">{SQUARE}{SQUARE}</g></switch>");
    let drawing = page(&format!("{SQUARE}{in_german}"));
    assert_eq!(drawing.shapes.len(), 1);
    let hidden = found(&drawing, Code::HiddenEntity);
    assert!(hidden.count == 2 && hidden.message.contains("not displayed"), "{hidden:?}");
    let chosen = page(&format!("<switch><g systemLanguage=\"de\">{SQUARE}</g>{SQUARE}</switch>"));
    assert_eq!((chosen.shapes.len(), chosen.findings.len()), (1, 0));
}
