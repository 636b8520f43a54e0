//! Recognises the sheet's own border: a single rectangle around everything, drawn to show the sheet and not to be cut.
//!
//! A plate with holes looks similar, and so does a frame that is cut. Three things speak for a border: the name of its
//! layer, a size in which stock is sold, and parts inside it, which are contours with holes of their own. The name of a
//! layer of part outlines speaks against it. Clear evidence makes the border ignored; thin evidence asks the person.

use super::model::{Contour, LayerUse, Operation};
use super::{findings, layer_names};
use crate::drawing::Drawing;
use crate::finding::{Code, Finding, Severity};
use crate::geometry::{DVec2, Segment};

/// A border fills at least this fraction of its box, which is aligned with its longest side. This accepts rounded or
/// clipped corners, but not an ellipse (0.79).
const MIN_BOX_FILL: f64 = 0.95;
/// Smallest fraction of the area directly inside a border that belongs to contours with holes. A plate with one window
/// in which another part lies is not a sheet of parts.
const MIN_SHARE_WITH_HOLES: f64 = 0.5;
/// Largest distance between the centres of two circles that are a countersunk hole, as a fraction of the outer one's size.
const CONCENTRIC: f64 = 0.05;
/// A drawn sheet differs from its stock size by at most this, mm.
const STOCK_TOLERANCE: f64 = 1.5;
/// Sizes in which sheets are sold, mm: metal by EN 10131 and the American 4 x 8 ft family, plywood and acrylic for small
/// lasers (A-sizes of dealers, 12 x 20 and 18 x 24 in, the templates of Ponoko).
const STOCK: &[[f64; 2]] = &[
    [200.0, 300.0],
    [300.0, 400.0],
    [300.0, 600.0],
    [400.0, 600.0],
    [500.0, 1000.0],
    [600.0, 900.0],
    [600.0, 1000.0],
    [600.0, 1200.0],
    [900.0, 1300.0],
    [1000.0, 1500.0],
    [1000.0, 2000.0],
    [1250.0, 2500.0],
    [1500.0, 3000.0],
    [1525.0, 3050.0],
    [2000.0, 4000.0],
    [2000.0, 6000.0],
    [304.8, 508.0],
    [304.8, 609.6],
    [457.2, 609.6],
    [610.0, 1220.0],
    [1220.0, 2440.0],
    [1220.0, 3050.0],
    [384.0, 790.0],
    [384.0, 384.0],
    [181.0, 181.0],
];

/// How clearly a rectangle is the border of the sheet.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Evidence {
    /// It is ignored unless the person keeps it.
    Clear,
    /// It is cut unless the person ignores it.
    Thin,
}

/// The contour that looks like the sheet's border, with what speaks for it.
#[derive(Clone, Debug)]
pub(super) struct Border {
    pub(super) contour: u32,
    pub(super) evidence: Evidence,
    reason: String,
}

/// The contour that looks like the sheet's border.
pub(super) fn find(contours: &[Contour], layers: &[LayerUse]) -> Option<Border> {
    let mut outermost = (0_u32..).zip(contours).filter(|(_, c)| c.inside.is_none() && c.is_processed());
    let (index, border) = outermost.next()?;
    let lone = outermost.next().is_none() && contours.len() > 1;
    if !lone || !border.path.closed || border.operation != Operation::Cut {
        return None;
    }
    let [short, long] = rectangle(border)?;
    let name = layers.get(border.layer as usize).map_or("", |l| l.name.as_str());
    let alone = alone_on_layer(contours, index);
    let named = alone && layer_names::names_sheet(name);
    let inside = Inside::of(contours, index);
    let stock = is_stock([short, long]);
    let (holds, part_named) = (inside.holds_parts(), layer_names::names_parts(name));
    let clear =
        (named && inside.contours > 1) || (!part_named && holds && inside.parts > 1 && (alone || stock));
    if !(clear || named || (holds && !part_named)) {
        return None;
    }
    let mut reasons = Vec::new();
    if named {
        reasons.push(format!("it is alone on layer {name}"));
    }
    if holds {
        reasons.push(findings::plural(inside.parts, "part lies inside it", "parts lie inside it"));
    }
    if stock {
        reasons.push(format!("sheets of {long:.0} x {short:.0} mm are sold"));
    }
    if alone && !named {
        reasons.push(format!("nothing else is on layer {name}"));
    }
    let reason = reasons.join(", and ");
    let evidence = if clear { Evidence::Clear } else { Evidence::Thin };
    Some(Border { contour: index, evidence, reason })
}

/// Whether it is alone on its layer. A layer FRAME that also holds all parts is no evidence of a border.
fn alone_on_layer(contours: &[Contour], index: u32) -> bool {
    let layer = contours[index as usize].layer;
    contours.iter().filter(|c| c.layer == layer && c.is_processed()).count() == 1
}

fn is_stock(size: [f64; 2]) -> bool {
    let near = |a: f64, b: f64| (a - b).abs() <= STOCK_TOLERANCE;
    STOCK.iter().any(|s| near(s[0], size[0]) && near(s[1], size[1]))
}

/// What lies directly inside a contour.
struct Inside {
    contours: usize,
    /// Those of them with holes of their own; countersunk holes are none.
    parts: usize,
    /// Fraction of their area that belongs to these.
    share: f64,
}

impl Inside {
    fn of(contours: &[Contour], around: u32) -> Self {
        let mut holes: Vec<Vec<&Contour>> = vec![Vec::new(); contours.len()];
        for c in contours.iter().filter(|c| c.bounds_area()) {
            if let Some(of) = c.inside.and_then(|of| holes.get_mut(of as usize)) {
                of.push(c);
            }
        }
        let (mut all, mut with_holes, mut parts, mut count) = (0.0, 0.0, 0, 0);
        for (c, holes) in contours.iter().zip(&holes).filter(|(c, _)| c.inside == Some(around)) {
            count += usize::from(c.bounds_area());
            all += c.area;
            if !holes.is_empty() && !is_countersunk(c, holes) {
                with_holes += c.area;
                parts += 1;
            }
        }
        Self { contours: count, parts, share: if all > 0.0 { with_holes / all } else { 0.0 } }
    }

    fn holds_parts(&self) -> bool {
        self.parts > 0 && self.share >= MIN_SHARE_WITH_HOLES
    }
}

/// Whether a contour and the only one inside it are concentric circles.
fn is_countersunk(outer: &Contour, holes: &[&Contour]) -> bool {
    let circle =
        |c: &Contour| c.boundary().is_some_and(|p| p.segments.iter().all(|s| matches!(s, Segment::Arc(_))));
    let [hole] = holes else { return false };
    let away = outer.bounds.center().distance(hole.bounds.center());
    circle(outer) && circle(hole) && away <= CONCENTRIC * outer.bounds.size().x
}

/// The sides of a rectangular contour, the shorter first.
fn rectangle(c: &Contour) -> Option<[f64; 2]> {
    let longest = c.path.segments.iter().filter(|s| matches!(s, Segment::Line(_)));
    let side = longest.max_by(|a, b| a.length().total_cmp(&b.length()))?;
    let along = side.tangent(0.0);
    let extent = |d: DVec2| {
        let on = c.path.segments.iter().map(|s| s.start().dot(d));
        let (low, high) = on.fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), v| (l.min(v), h.max(v)));
        high - low
    };
    let sides = [extent(along), extent(along.perp())];
    (c.area >= MIN_BOX_FILL * sides[0] * sides[1]).then(|| [sides[0].min(sides[1]), sides[0].max(sides[1])])
}

/// What was done with the border.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Decision {
    /// It was ignored.
    Ignored,
    /// It is cut because the person keeps it.
    Kept,
    /// It is cut, and the person should say whether that is right.
    Open,
}

/// Reports the border.
pub(super) fn finding(drawing: &Drawing, contour: &Contour, border: &Border, decision: Decision) -> Finding {
    let reason = &border.reason;
    let message = match decision {
        Decision::Ignored => {
            format!(
                "The border around everything is taken for the sheet and ignored: {reason}. Keep it if it is a cut."
            )
        }
        Decision::Kept => format!("The border around everything is cut, as you chose, although {reason}."),
        Decision::Open => format!(
            "The rectangle around everything may be the sheet and not a cut: {reason}. It is currently cut: keep it, or \
             ignore it."
        ),
    };
    let severity = if decision == Decision::Open { Severity::Warning } else { Severity::Info };
    findings::shape(drawing, contour.first_shape, Code::SheetOutline, severity, message, contour.path.start())
}
