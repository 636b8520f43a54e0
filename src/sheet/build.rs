//! Builds a sheet: runs all steps of this stage.

use super::assemble::{Assembled, assemble};
use super::clean::clean;
use super::findings::{self, layer_name, plural};
use super::groups::{self, PierceGroup};
use super::lettering;
use super::model::{CommonCuts, Contour, Ignored, LayerUse, Operation, Pin, Sheet, SheetOptions};
use super::outline::{Decision, Evidence};
use super::source::Source;
use super::{
    choices, crossings, exclude, layers, narrow, near_copies, nest, outline, parts, sequence, together,
};
use crate::drawing::Drawing;
use crate::finding::{Code, Finding, Findings, Severity};
use crate::geometry::Aabb;
use crate::machine::far_out;
use crate::order::sort_by;
use std::sync::Arc;

/// Depth of a crossing, mm, up to which it is rounding of a drawing in which lines end on each other.
const MIN_CROSSING_DEPTH: f64 = 0.001;

/// Builds the sheet of a drawing: cleans, joins and nests. It never fails, because everything unusual becomes a
/// finding. The sheet has the findings of this stage only; those of the reader stay with the drawing.
pub fn build(drawing: &Drawing, options: &SheetOptions) -> Sheet {
    let mut findings = Findings::default();
    let mut layers = layers::layers(drawing, options, &mut findings);
    let mut ignored = layers::ignored(drawing, &layers, &mut findings);
    let (join, copy) = tolerances(options);
    let (mut contours, searched) = assembled(drawing, &layers, (join, copy), &mut findings);
    sort_by(&mut contours, |c| [c.first_shape.into(), 0, 0]);
    exclude::exclude(&mut contours, &options.exclude, copy, &mut findings);
    exclude::mark(&mut contours, &options.mark, copy);
    let in_groups = lettering::find(drawing, &mut contours, &options.groups, &mut findings);
    // Where areas were not searched for, an open line may well free a part, which one finding already reports.
    if searched {
        findings::open_contours(drawing, &contours, &in_groups, &mut findings);
    }
    let depth = copy.max(MIN_CROSSING_DEPTH);
    let mut crossing = crossings::find(Source::Drawing(drawing), &mut contours, depth, &mut findings);
    near_copies::find(drawing, &contours, [copy, join], &mut findings);
    if !nest::nest(&mut contours, &crossing, join) {
        let message =
            "So many contours interlock that it was only partly determined which lies inside which.";
        findings.push(Finding::new(Code::NotAllChecked, Severity::Warning, message));
    }
    let outline = border(drawing, &mut contours, &layers, options, &mut findings);
    if let Some(Border { index, ignored: true }) = outline {
        crossing.retain(|&(a, b)| a != index && b != index);
        nest::nest(&mut contours, &crossing, join);
    }
    narrow::find(drawing, &contours, narrow::Limit::FinestBeam, &mut findings);
    parts::orient(&mut contours);
    pin(&mut contours, options);
    sequence::assign(&mut contours, &options.sequences);
    together::assign(&mut contours, &options.together);
    let groups = find_groups(&contours, &layers, &crossing, options, join);
    let bounds = count(&contours, &mut layers, &mut ignored);
    if let Some(far) = far_out(&bounds) {
        findings.push(findings::far_from_origin(&far));
    }
    Sheet {
        parts: parts::parts(&contours),
        part_by_part: options.part_by_part,
        groups,
        pass_order: options.pass_order,
        common_cuts: options.common_cuts,
        bridged: Arc::default(),
        joints: options.joints.clone(),
        choices: choices::by_contour(&options.contours),
        joined_within: join,
        bounds,
        contours,
        layers,
        ignored,
        outline: outline.filter(|border| !border.ignored).map(|border| border.index),
        findings: findings.into_list(),
    }
}

/// The cleaned and joined contours of a drawing, and whether areas were searched for among them.
fn assembled(
    drawing: &Drawing,
    layers: &[LayerUse],
    (join, copy): (f64, f64),
    findings: &mut Findings,
) -> (Vec<Contour>, bool) {
    let source = Source::Drawing(drawing);
    let (mut contours, mut searched) = (Vec::new(), true);
    // Cuts and marks are cleaned and joined separately, so a line that is both marked and cut remains both.
    for operation in [Operation::Cut, Operation::Mark] {
        let lines = layers::lines_of(drawing, layers, operation);
        let chains = clean(source, &lines, copy, join, findings);
        let assembly = assemble(source, &chains, join, operation == Operation::Cut, findings);
        searched &= assembly.searched;
        for a in assembly.contours {
            contours.push(contour(drawing, a, operation, findings));
        }
    }
    (contours, searched)
}

/// The contour that is the border of the sheet.
#[derive(Clone, Copy)]
struct Border {
    index: u32,
    ignored: bool,
}

/// Finds the border of the sheet, and ignores it unless the options or thin evidence speak against that.
fn border(
    drawing: &Drawing,
    contours: &mut [Contour],
    layers: &[LayerUse],
    options: &SheetOptions,
    findings: &mut Findings,
) -> Option<Border> {
    let border = outline::find(contours, layers)?;
    let decision = match (options.keep_border, options.ignore_outline, border.evidence) {
        (true, ..) => Decision::Kept,
        (false, true, _) | (false, false, Evidence::Clear) => Decision::Ignored,
        (false, false, Evidence::Thin) => Decision::Open,
    };
    let index = border.contour;
    findings.push(outline::finding(drawing, &contours[index as usize], &border, decision));
    let ignored = decision == Decision::Ignored;
    if ignored {
        contours[index as usize].operation = Operation::Ignore;
        // One finding about the border is enough.
        let layer = contours[index as usize].layer;
        if contours.iter().filter(|c| c.layer == layer).count() == 1 {
            let name = &layers[layer as usize].name;
            findings.withdraw(|f| f.code == Code::LayerSuggestion && f.layer.as_ref() == Some(name));
        }
    }
    Some(Border { index, ignored })
}

/// Counts the contours of each layer that are cut or marked, and adds the others to those that are ignored. Returns the bounds of the
/// former.
fn count(contours: &[Contour], layers: &mut [LayerUse], ignored: &mut Vec<Ignored>) -> Aabb {
    let mut bounds = Aabb::EMPTY;
    for c in contours {
        match layers.get_mut(c.layer as usize) {
            Some(l) if c.is_processed() => {
                l.contours += 1;
                bounds = bounds.union(c.bounds);
            }
            _ => ignored.push(Ignored { path: c.path.clone(), layer: c.layer }),
        }
    }
    bounds
}

/// Finds contours that share cuts. There are none if the options ask for separate contours or for part by part.
pub(super) fn find_groups(
    contours: &[Contour],
    layers: &[LayerUse],
    crossing: &[(u32, u32)],
    options: &SheetOptions,
    join: f64,
) -> Vec<PierceGroup> {
    if options.common_cuts == CommonCuts::Off || options.part_by_part {
        return Vec::new();
    }
    let rank = |c: &Contour| (c.pin, layers.get(c.layer as usize).map_or(0, |l| l.rank));
    // A layer with settings of its own is not cut at the speed of the group.
    let plain = |c: &Contour| layers.get(c.layer as usize).is_none_or(|l| l.settings.is_none());
    // Neither is one that has its turn in a sequence, or is kept together with others.
    let free = |c: &Contour| c.together.is_none() && !sequence::has_turn(contours, c);
    let alike = |a: &Contour, b: &Contour| rank(a) == rank(b) && plain(a) && plain(b) && free(a) && free(b);
    groups::find(contours, crossing, [join, options.copy_tolerance], alike)
}

/// Pins contours, with everything inside those that come first. What lies around those that come last waits for them in
/// any case.
fn pin(contours: &mut [Contour], options: &SheetOptions) {
    for (ids, pin) in [(&options.first, Pin::First), (&options.last, Pin::Last)] {
        for &id in ids {
            if let Some(c) = contours.get_mut(id as usize) {
                c.pin = pin;
            }
        }
    }
    let mut inwards: Vec<usize> = (0..contours.len()).collect();
    sort_by(&mut inwards, |&c| [contours[c].depth.into(), 0, 0]);
    for c in inwards {
        let around = contours[c].inside.and_then(|o| contours.get(o as usize)).map(|o| o.pin);
        if around == Some(Pin::First) && contours[c].pin == Pin::None {
            contours[c].pin = Pin::First;
        }
    }
}

/// The tolerances for joining and for copies, mm. A copy is nearer than what is joined.
pub(super) fn tolerances(options: &SheetOptions) -> (f64, f64) {
    // They come from outside, and may be negative or no numbers.
    let length = |v: f64| if v.is_finite() { v.max(0.0) } else { 0.0 };
    let join = length(options.join_tolerance);
    (join, length(options.copy_tolerance).min(join))
}

/// Sums the lengths of elements by layer.
fn by_layer(mut lengths: Vec<(u32, f64)>) -> Vec<(u32, f64)> {
    sort_by(&mut lengths, |(layer, _)| [(*layer).into(), 0, 0]);
    lengths.dedup_by(|next, sum| {
        let same = next.0 == sum.0;
        sum.1 += if same { next.1 } else { 0.0 };
        same
    });
    lengths
}

fn contour(drawing: &Drawing, a: Assembled, operation: Operation, findings: &mut Findings) -> Contour {
    let layers = by_layer(a.layers);
    let most = layers.iter().fold((0, f64::NEG_INFINITY), |m, &(l, d)| if d > m.1 { (l, d) } else { m });
    let layer = most.0;
    let at = a.path.start();
    if layers.len() > 1 {
        let names: Vec<_> = layers.iter().filter_map(|&(l, _)| layer_name(drawing, l)).collect();
        let message = format!(
            "This contour lies on {}: {}. It is taken to be on {}, where most of it lies.",
            plural(names.len(), "layer", "layers"),
            names.join(", "),
            layer_name(drawing, layer).unwrap_or_default(),
        );
        findings.push(findings::shape(
            drawing,
            a.first_shape,
            Code::SeveralLayers,
            Severity::Warning,
            message,
            at,
        ));
    }
    let length = a.path.length();
    Contour {
        layer,
        operation,
        inside: None,
        depth: 0,
        length,
        area: if a.path.closed { Some(&a.path) } else { a.outline.as_ref() }.map_or(0.0, |p| p.area().abs()),
        bounds: a.path.bounds(),
        self_crossing: false,
        pass: 0,
        next_pass: None,
        pin: Pin::None,
        turn: None,
        together: None,
        first_shape: a.first_shape,
        rest_of: a.rest_of.filter(|_| !a.path.closed),
        outline: a.outline,
        drawn: None,
        skeleton: false,
        bridged: None,
        path: a.path,
    }
}
