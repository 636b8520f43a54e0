//! Layers: their operations, what their names suggest, and their place in the order of layers.
//!
//! Everything is cut unless the person chooses otherwise. Only Defpoints is ignored by default, because no CAD program
//! plots it. Names are compared without case, as DXF does. What a name suggests is reported as a finding and changes
//! nothing.

use super::findings::{count, plural};
use super::layer_names;
use super::model::{Ignored, LayerUse, Operation, SheetOptions};
use super::source::Line;
use crate::drawing::Drawing;
use crate::fields::nearest;
use crate::finding::{Code, Finding, Findings, Severity};
use crate::letters::same_letters;
use crate::machine::Settings;

/// The layers of a drawing with their operations, at the same indices. The contours on them are counted later.
pub(super) fn layers(drawing: &Drawing, options: &SheetOptions, findings: &mut Findings) -> Vec<LayerUse> {
    let mut shapes = vec![0_usize; drawing.layers.len()];
    for s in &drawing.shapes {
        if let Some(n) = shapes.get_mut(s.layer as usize) {
            *n += 1;
        }
    }
    for (name, _) in &options.layers {
        if !drawing.layers.iter().any(|l| same_letters(&l.name, name)) {
            findings.push(unknown(name, drawing));
        }
    }
    let place = |name: &str| options.layers.iter().rposition(|(n, _)| same_letters(n, name));
    let mut out = Vec::with_capacity(drawing.layers.len());
    for (index, layer) in (0_u32..).zip(&drawing.layers) {
        let asked = place(&layer.name);
        let chosen = asked.and_then(|i| options.layers.get(i)?.1);
        let operation = chosen.unwrap_or_else(|| usual_operation(&layer.name));
        let suggestion = layer_names::suggestion(&layer.name).filter(|s| chosen.is_none() && *s != operation);
        let used = shapes[index as usize];
        if let (Some(s), true) = (suggestion, used > 0) {
            findings.push(suggested(&layer.name, s, used));
        }
        let rank = if options.order_by_layer {
            asked.map_or(count(options.layers.len()).saturating_add(index), count)
        } else {
            u32::from(operation == Operation::Cut)
        };
        let (name, color) = (layer.name.clone(), layer.color);
        let mut settings = options.settings.iter().rev();
        let settings = settings.find(|(n, _)| same_letters(n, &name)).map_or(Settings::NONE, |s| s.1);
        out.push(LayerUse { name, color, operation, suggestion, settings, rank, contours: 0 });
    }
    out
}

/// What is done with a layer where nobody has chosen anything: everything is cut but what CAD programs never plot.
pub(crate) fn usual_operation(layer: &str) -> Operation {
    if same_letters(layer, "defpoints") { Operation::Ignore } else { Operation::Cut }
}

/// Reports a layer of the options that the drawing does not have.
fn unknown(name: &str, drawing: &Drawing) -> Finding {
    let hint = match nearest(name, drawing.layers.iter().map(|l| l.name.as_str())) {
        Some(near) => format!("Did you mean \"{near}\"?"),
        None => "Check its name.".to_owned(),
    };
    let message = format!("The drawing has no layer \"{name}\", so the choice for it does nothing. {hint}");
    Finding::new(Code::LayerUnknown, Severity::Warning, message).on_layer(name)
}

fn suggested(name: &str, suggestion: Operation, shapes: usize) -> Finding {
    let what = plural(shapes, "shape is", "shapes are");
    let message = match suggestion {
        Operation::Mark => {
            format!(
                "{what} on layer {name}, whose name suggests marking: currently cut. Choose mark or ignore."
            )
        }
        _ => format!(
            "{what} on layer {name}, whose name suggests that it is not cut: currently cut. Choose ignore to skip it."
        ),
    };
    Finding::new(Code::LayerSuggestion, Severity::Warning, message).on_layer(name).times(count(shapes))
}

/// The shapes of ignored layers, with a finding for each such layer.
pub(super) fn ignored(drawing: &Drawing, layers: &[LayerUse], findings: &mut Findings) -> Vec<Ignored> {
    let mut held = vec![0_usize; layers.len()];
    let mut out = Vec::new();
    for s in &drawing.shapes {
        let Some(layer) = layers.get(s.layer as usize) else { continue };
        if layer.operation == Operation::Ignore {
            held[s.layer as usize] += 1;
            out.push(Ignored { path: s.path.clone(), layer: s.layer });
        }
    }
    for (layer, n) in layers.iter().zip(held).filter(|(_, n)| *n > 0) {
        let message = format!("{} on layer {} left out.", plural(n, "shape", "shapes"), layer.name);
        findings.push(
            Finding::new(Code::LayerIgnored, Severity::Info, message).on_layer(&layer.name).times(count(n)),
        );
    }
    out
}

/// The shapes of one operation, in drawing order. A shape whose layer is not in the list is cut.
pub(super) fn lines_of<'d>(drawing: &'d Drawing, layers: &[LayerUse], operation: Operation) -> Vec<Line<'d>> {
    let of = |layer: u32| layers.get(layer as usize).map_or(Operation::Cut, |l| l.operation);
    (0_u32..)
        .zip(&drawing.shapes)
        .filter(|(_, s)| of(s.layer) == operation)
        .map(|(index, s)| Line { index, layer: s.layer, path: &s.path })
        .collect()
}
