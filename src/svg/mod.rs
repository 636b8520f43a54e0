//! Reads SVG: bytes in, a [`Drawing`] in millimetres out. Everything unusual becomes a finding.
//!
//! ```text
//! bytes -> text       UTF-8, UTF-16 or the encoding that the XML declaration names
//!       -> xml        elements and attributes; entities are expanded within a budget
//!       -> scale      the length of one user unit in mm: from the size of the page, the program that wrote it, or a person
//!       -> walk       groups, use, symbol, nested svg; style says what is visible, and in which colour
//!       -> shape      path data and basic shapes as outlines in user units
//!       -> trace      lines and arcs in mm
//!       -> layers     Inkscape layers and stroke colours become layers
//! ```
//!
//! The y axis of SVG points down; on the sheet it points up, so the drawing keeps its look, and the lower left corner of
//! the page is the origin.
//!
//! Source: "Scalable Vector Graphics (SVG) 2" (W3C, 2018), with SVG 1.1 where programs still write it.

mod aspect;
mod color;
mod color_names;
mod css;
mod custom;
mod declarations;
mod entities;
mod layers;
mod length;
mod numbers;
mod outline;
mod own;
mod path_data;
mod report;
mod scale;
mod shape;
mod sniff;
mod steps;
mod style;
mod subject;
mod text;
mod trace;
mod transform;
mod viewport;
mod walk;
mod xml;

pub use sniff::is_svg;

use crate::drawing::{Drawing, ReadError, ReadOptions};
use crate::finding::{Code, Finding};

/// Reads a drawing from the bytes of an SVG file.
///
/// # Errors
/// The file is not an SVG, holds nothing to cut, or exceeds a limit of `options`. The error is one sentence for people.
pub fn read(bytes: &[u8], options: &ReadOptions) -> Result<Drawing, ReadError> {
    options.limits.check_size(bytes.len())?;
    let text = text::decode(bytes, options.decoder);
    let document = xml::read(&text, &options.limits)?;
    let mut scale = scale::decide(&document, options);
    let mut walked = walk::walk(&document, &scale, options)?;
    if !scale.has_page {
        // Without a page, the lower edge of the drawing is y = 0.
        let bottom = walked.shapes.iter().map(|(_, s)| s.path.bounds().min.y).fold(f64::INFINITY, f64::min);
        if bottom.is_finite() {
            scale.map.origin.y -= bottom;
            walked = walk::walk(&document, &scale, options)?;
        }
    }
    let (layers, shapes, names) = layers::name(walked.shapes, &walked.groups);
    let mut findings: Vec<Finding> = scale.finding.into_iter().collect();
    findings.extend(walked.report.into_findings(&names));
    if shapes.is_empty() {
        return Err(ReadError::Empty(nothing_to_cut(&findings)));
    }
    Ok(Drawing {
        version: document.version(),
        units: scale.units,
        layers,
        shapes,
        entities: walked.kinds,
        findings,
    })
}

/// Explains why a drawing has no shapes.
fn nothing_to_cut(findings: &[Finding]) -> String {
    let count = |code: Code| -> u32 { findings.iter().filter(|f| f.code == code).map(|f| f.count).sum() };
    let mut reasons: Vec<String> = Vec::new();
    let mut say = |n: u32, what: &str| {
        if n > 0 {
            reasons.push(format!("{n} {what}"));
        }
    };
    say(count(Code::HiddenEntity), "hidden, or without stroke and fill");
    say(count(Code::UnsupportedEntity), "without an outline (text, pictures, ...)");
    say(count(Code::InvalidGeometry), "without a usable geometry");
    say(count(Code::MissingBlock), "copies of objects that are not in the file");
    if reasons.is_empty() {
        return "The SVG holds nothing to cut. Check that the outlines were exported.".to_owned();
    }
    format!(
        "The SVG holds nothing that can be cut: {}. Show it, or convert it to paths, in the drawing program and save again.",
        reasons.join(", ")
    )
}
