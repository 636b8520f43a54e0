//! Reads DXF: bytes in, a [`Drawing`] in millimetres out. Everything unusual becomes a finding.
//!
//! ```text
//! bytes -> tokens     group codes and values, ASCII or binary, borrowed from the bytes; resynchronises after damage
//!       -> file       sections, layers, blocks; records become typed entities (entities/), in drawing units
//!       -> measure    number of elements, nesting and extent, before anything is expanded
//!       -> units      from the header, guessed, or chosen by the person; doubt is reported
//!       -> expand     blocks, layers, colours, hidden entities; trace: lines and arcs in mm
//! ```
//!
//! Source: "DXF Reference" (Autodesk, 2012 and later). Where it is unclear, files are read as drawing programs read
//! them.

mod ascii;
mod binary;
mod breaks;
mod encoding;
mod entities;
mod entity;
mod expand;
mod file;
mod header;
mod layers;
mod measure;
mod multi_byte;
mod number;
mod ocs;
mod placement;
mod plausible;
mod record;
mod report;
mod single_byte;
mod tag;
mod tokens;
mod trace;
mod units;

use crate::drawing::{Drawing, EntityKindCount, Layer, ReadError, ReadOptions, Units, other_format};
use crate::finding::{Code, Finding, Severity};
use encoding::Decoder;
use entity::{Geometry, Hidden};
use file::File;
use std::collections::BTreeMap;

/// Bytes within which a large file has to show that it is a DXF, so that junk is refused at once. Drawing programs write
/// the first section within a hundred.
const HEAD: usize = 1 << 20;

/// Reads a drawing from the bytes of a DXF file, ASCII or binary.
///
/// # Errors
/// The file is not a DXF, holds nothing to cut, or exceeds a limit of `options`. The error is one sentence for people.
pub fn read(bytes: &[u8], options: &ReadOptions) -> Result<Drawing, ReadError> {
    options.limits.check_size(bytes.len())?;
    if let Some(sentence) = other_format(bytes) {
        return Err(ReadError::NotADrawing(sentence.to_owned()));
    }
    let junk = bytes.get(..HEAD).filter(|head| !file::is_recognised(head));
    let mut file = file::read(junk.unwrap_or(bytes));
    if !file.recognised {
        return Err(ReadError::NotADrawing(
            "This is neither a DXF nor an SVG file, or one damaged beyond reading. Save the drawing as DXF or SVG.".to_owned(),
        ));
    }
    let size = measure::size(&file, &options.limits)?;
    let (units, units_finding) =
        units::decide(&file, Units::chosen(options.unit, options.dpi), size.max_element());
    let mut notes = std::mem::take(&mut file.notes);
    let shapes = expand::shapes(&file, units.scale, options, &mut notes)?;
    let mut decoder = Decoder::new(&file.header, options.decoder);
    let layers = layers(&file, &mut decoder);
    let mut findings: Vec<Finding> = units_finding.into_iter().collect();
    findings.extend(notes.into_findings(&mut decoder, &layers));
    if decoder.replaced() > 0 {
        let message = format!(
            "{} names hold characters that are not in {}, the encoding the file says; they are shown as well as possible.",
            decoder.replaced(),
            decoder.name()
        );
        findings.push(Finding::new(Code::Encoding, Severity::Info, message).times(decoder.replaced()));
    }
    let entities = counts(&file, &mut decoder);
    if shapes.is_empty() {
        return Err(ReadError::Empty(nothing_to_cut(&entities, &findings)));
    }
    let version = file.header.version.map(|v| decoder.text(v).into_owned());
    Ok(Drawing { version, units, layers, shapes, entities, findings })
}

fn layers(file: &File<'_>, decoder: &mut Decoder) -> Vec<Layer> {
    let one = |l: &layers::RawLayer<'_>| Layer {
        name: decoder.text(l.name).into_owned(),
        color: l.color,
        visible: !(l.frozen || l.off),
    };
    file.layers.list().iter().map(one).collect()
}

/// Entities of the model by kind, most frequent first.
fn counts(file: &File<'_>, decoder: &mut Decoder) -> Vec<EntityKindCount> {
    let mut by_name: BTreeMap<(&[u8], bool), u32> = BTreeMap::new();
    for entity in file.model.iter().filter(|e| e.hidden != Some(Hidden::Paper)) {
        let key = match entity.geometry {
            Geometry::Other(name, _) => (file.other_name(name), false),
            _ if entity.kind.is_empty() => (b"?".as_slice(), false),
            _ => (entity.kind.as_bytes(), true),
        };
        *by_name.entry(key).or_default() += 1;
    }
    let mut counts: Vec<EntityKindCount> = by_name
        .into_iter()
        .map(|((kind, supported), count)| EntityKindCount {
            kind: decoder.text(kind).into_owned(),
            count,
            supported,
        })
        .collect();
    // The sort is stable, so kinds with equal counts stay in alphabetical order.
    crate::order::sort_by(&mut counts, |c| [u64::MAX - u64::from(c.count), 0, 0]);
    counts
}

/// Explains why a drawing has no shapes.
fn nothing_to_cut(entities: &[EntityKindCount], findings: &[Finding]) -> String {
    let count = |code: Code| -> u32 { findings.iter().filter(|f| f.code == code).map(|f| f.count).sum() };
    let mut reasons: Vec<String> = Vec::new();
    let mut say = |n: u32, what: &str| {
        if n > 0 {
            reasons.push(format!("{n} {what}"));
        }
    };
    say(count(Code::HiddenEntity), "hidden (frozen or off layers, paper layouts)");
    say(count(Code::DamagedEntity), "damaged");
    say(count(Code::UnsupportedEntity), "without an outline (text, dimensions, pictures, ...)");
    say(count(Code::InvalidGeometry), "without a usable geometry");
    say(count(Code::MissingBlock), "blocks that are not in the file");
    let truncated = count(Code::Truncated) > 0;
    match (entities.is_empty(), reasons.is_empty()) {
        (true, _) | (_, true) if truncated => {
            "The file ends before anything to cut: it was probably not copied whole. Save or download it again.".to_owned()
        }
        (true, _) | (_, true) => {
            "The drawing holds nothing to cut. Check that the outlines were exported.".to_owned()
        }
        _ => format!(
            "The drawing holds nothing that can be cut: {}. Show or explode it in the drawing program and save again.",
            reasons.join(", ")
        ),
    }
}
