//! Findings about what cleaning removed, one per shape.

use super::remainder::Remainder;
use crate::finding::{Code, Finding, Findings, Severity};
use crate::geometry::Path;
use crate::number::fixed;
use crate::sheet::element::Element;
use crate::sheet::findings::{count, plural};
use crate::sheet::source::Source;

/// Reports elements of a shape that have no length.
pub(super) fn zero_length(source: Source, index: u32, path: &Path, dropped: usize) -> Finding {
    let kind = source.kind(index);
    let message = if path.segments.len() == dropped {
        format!("This {kind} has no length: there is nothing to cut, it is left out.")
    } else {
        format!("{} without length left out of this {kind}.", plural(dropped, "piece", "pieces"))
    };
    source.finding(index, Code::ZeroLength, Severity::Info, message, path.start()).times(count(dropped))
}

/// Reports a closed shape that collapsed to a line.
pub(super) fn sliver(source: Source, index: u32, path: &Path, tolerance: f64) -> Finding {
    let kind = source.kind(index);
    let message = format!(
        "This closed {kind} is narrower than the tolerance of {tolerance} mm: it is cut once, as a line, and is no part."
    );
    source.finding(index, Code::SliverCollapsed, Severity::Warning, message, path.start())
}

/// Reports every shape that lost something to another one.
pub(super) fn removed(source: Source, elements: &[Element], kept: &[Remainder], findings: &mut Findings) {
    let mut from = 0;
    for group in elements.chunk_by(|a, b| a.shape == b.shape) {
        let kept = &kept[from..from + group.len()];
        from += group.len();
        if let Some(f) = lost(source, group, kept) {
            findings.push(f);
        }
    }
}

fn lost(source: Source, elements: &[Element], kept: &[Remainder]) -> Option<Finding> {
    let first = kept.iter().position(|k| *k != Remainder::Whole)?;
    let (element, loss) = (elements.get(first)?, kept.get(first)?);
    let copies = kept.iter().filter(|k| **k == Remainder::Copy).count();
    let gone = copies + kept.iter().filter(|k| **k == Remainder::Covered).count();
    let touched = kept.iter().filter(|k| **k != Remainder::Whole).count();
    let length: f64 = elements.iter().zip(kept).map(|(e, k)| e.segment.length() * (1.0 - share(k))).sum();
    let kind = source.kind(element.shape);
    let (code, message) = if copies == elements.len() {
        (Code::DuplicateRemoved, format!("This {kind} lies on top of another one: it is cut once."))
    } else if copies == touched {
        let (pieces, lie) = (plural(copies, "piece", "pieces"), if copies == 1 { "lies" } else { "lie" });
        (Code::DuplicateRemoved, format!("{pieces} of this {kind} {lie} on top of other lines: cut once."))
    } else if gone == elements.len() {
        (Code::OverlapRemoved, format!("This {kind} lies wholly along other lines: it is cut once."))
    } else {
        let text =
            format!("{} mm of this {kind} lie along other lines: they are cut once.", fixed(length, 3));
        (Code::OverlapRemoved, text)
    };
    let at = element.segment.at(first_loss(loss));
    Some(source.finding(element.shape, code, Severity::Info, message, Some(at)).times(count(touched)))
}

/// The kept fraction of an element, 0 to 1.
fn share(kept: &Remainder) -> f64 {
    match kept {
        Remainder::Whole => 1.0,
        Remainder::Pieces(p) => p.iter().map(|(a, b)| b - a).sum(),
        Remainder::Copy | Remainder::Covered => 0.0,
    }
}

/// The middle of the first removed part, as a fraction of the element.
fn first_loss(kept: &Remainder) -> f64 {
    match kept {
        Remainder::Pieces(p) => match p[..] {
            [(from, _), ..] if from > 0.0 => from * 0.5,
            [(_, to), (from, _), ..] => (from + to) * 0.5,
            [(_, to)] => (1.0 + to) * 0.5,
            [] => 0.5,
        },
        _ => 0.5,
    }
}
