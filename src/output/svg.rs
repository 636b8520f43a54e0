//! Draws a plan as SVG: in millimetres, with y flipped, without scripts, readable on light and dark ground.
//!
//! Contours are in cutting order as exact arcs, each with a title that names it. Air moves are dashed. Entries are dots
//! with their number in cutting order, where there is room for it; a contour that is cut in parts has one for each part. Widths and text size
//! follow the size of the sheet, so the picture is readable for a tag and for a three-metre plate.
//!
//! An SVG arc is given by its ends and radius. Near half a turn its centre is ill-conditioned, so arcs are written in
//! pieces of at most a third of a turn, where an error in the ends moves the arc by no more than itself. Everything
//! lies within 0.003 mm of the plan.

use super::cuts::{Cut, closes, contour_cuts};
use super::labels;
use super::sheet_facts::SheetFacts;
use crate::geometry::{Aabb, DVec2, Segment, arcs};
use crate::machine::{CornerKind, Profile};
use crate::number::{Fixed, fixed};
use crate::plan::{Move, Plan};
use std::f64::consts::TAU;
use std::fmt::Write as _;

/// Decimals of a coordinate, mm.
const DECIMALS: usize = 3;
/// Largest sweep of one arc command, rad.
const LARGEST_SWEEP: f64 = TAU / 3.0;
/// Line width as a fraction of the sheet's longer side: a thin line when the sheet fills a screen.
const LINE: f64 = 1.0 / 1000.0;
/// Margin around everything, in line widths.
const MARGIN: f64 = 20.0;
/// Height of the numbers, in line widths.
const TEXT_HEIGHT: f64 = 12.0;
/// Distance of a number to its entry along both axes, in line widths.
const BESIDE: f64 = 4.0;
/// Above this number of contours the numbers are omitted, because they would cover the picture. The titles remain.
const MAX_NUMBERED: usize = 1000;

/// The picture of a plan. The head starts at the home of `profile`.
pub fn svg(plan: &Plan, sheet: &SheetFacts, profile: &Profile) -> String {
    let bounds = reach(plan, profile.home());
    let width = (bounds.size().max_element() * LINE).max(1e-3);
    let view = bounds.grown(width * MARGIN);
    let (corner, size) = (Point(DVec2::new(view.min.x, view.max.y)), view.size());
    let (w, h) = (number(size.x), number(size.y));

    let mut out = String::new();
    let _ = writeln!(
        out,
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{w}mm\" height=\"{h}mm\" viewBox=\"{corner} {w} {h}\">"
    );
    let sums = &plan.summary;
    let _ = writeln!(out, "<title>{} contours, about {} s</title>", sums.contours, fixed(sums.total_time, 1));
    style(&mut out, width);
    contours(&mut out, plan, sheet);
    leads(&mut out, plan);
    loops(&mut out, plan);
    chains(&mut out, plan);
    bridges(&mut out, plan, width);
    joints(&mut out, plan, width);
    air(&mut out, plan, profile.home());
    entries(&mut out, plan, &view, width);
    out.push_str("</svg>\n");
    out
}

/// The box of all places the head visits.
fn reach(plan: &Plan, home: DVec2) -> Aabb {
    plan.moves.iter().fold(Aabb::of(home), |b, step| match step {
        Move::Air { to, .. } | Move::PreCut { to, .. } => b.with(*to),
        Move::Pierce | Move::MovingStart | Move::Macro { .. } | Move::Height { .. } | Move::Wait { .. } => b,
        Move::Cut { path, .. } | Move::Joint { path, .. } | Move::Fly { path } | Move::Chain { path } => {
            path.iter().fold(b, |b, s| b.union(s.bounds()))
        }
    })
}

/// Dark for cuts, blue for marks, orange for air moves: distinguishable without red and green, on white and on black.
fn style(out: &mut String, width: f64) {
    let [line, dash, dot, letters] = [width, width * 4.0, width * 5.0, width * TEXT_HEIGHT].map(number);
    let _ = writeln!(
        out,
        "<style>path{{fill:none;stroke-width:{line};stroke-linejoin:round}}.cut{{stroke:#1b1f24}}.mark{{stroke:#2563c9}}\
         .air{{stroke:#c2571a;stroke-dasharray:{dash}}}.entry{{stroke:#c2571a;stroke-width:{dot};stroke-linecap:round}}\
         text{{font:{letters}px sans-serif;fill:#1b1f24}}\
         @media(prefers-color-scheme:dark){{.cut{{stroke:#e6e9ee}}.mark{{stroke:#7fb0ff}}.air,.entry{{stroke:#ff9a5c}}\
         text{{fill:#e6e9ee}}}}</style>"
    );
}

fn contours(out: &mut String, plan: &Plan, sheet: &SheetFacts) {
    for (order, cut) in contour_cuts(plan).iter().enumerate() {
        let &Cut { contour, entry, ref path, mark, .. } = cut;
        let class = if mark { "mark" } else { "cut" };
        let _ = write!(out, "<path class=\"{class}\" d=\"M{}", Point(entry));
        for segment in path.iter() {
            element(out, segment);
        }
        let end = if closes(sheet, cut) { "Z" } else { "" };
        let (order, layer) = (order + 1, Escaped(sheet.layer_name(contour)));
        let called = sheet.called(contour);
        let _ = writeln!(out, "{end}\"><title>{order}: contour {called}, layer {layer}</title></path>");
    }
}

/// Something that is drawn over the contours.
struct Overlay {
    class: &'static str,
    /// Its colours on light and on dark ground.
    colors: [&'static str; 2],
    /// Width of its lines, if it is not the usual one.
    width: Option<f64>,
    title: &'static str,
}

impl Overlay {
    /// Draws paths, if there are any.
    fn draw(&self, out: &mut String, paths: &[&[Segment]]) {
        let Self { class, colors: [light, dark], width, title } = self;
        if paths.iter().all(|path| path.is_empty()) {
            return;
        }
        let wide = width.map(|width| format!(";stroke-width:{}", number(width))).unwrap_or_default();
        let _ = write!(
            out,
            "<style>.{class}{{stroke:{light}{wide}}}@media(prefers-color-scheme:dark){{.{class}{{stroke:{dark}}}}}</style>\n\
             <path class=\"{class}\" d=\""
        );
        for path in paths {
            if let Some(first) = path.first() {
                let _ = write!(out, "M{}", Point(first.start()));
            }
            path.iter().for_each(|segment| element(out, segment));
        }
        let _ = writeln!(out, "\"><title>{title}</title></path>");
    }
}

/// Leads and overcuts, drawn over their contours.
fn leads(out: &mut String, plan: &Plan) {
    let cuts = contour_cuts(plan);
    let parts = cuts.iter().flat_map(|cut| {
        let [lead_in, _, overcut, lead_out] = cut.leads.divide(&cut.path);
        [lead_in, overcut, lead_out]
    });
    let colors = ["#1a8f5a", "#5fd39b"];
    Overlay { class: "lead", colors, width: None, title: "Lead-ins, lead-outs, overcuts" }
        .draw(out, &parts.collect::<Vec<_>>());
}

/// Loops at corners.
fn loops(out: &mut String, plan: &Plan) {
    let mut loops = Vec::new();
    for m in &plan.moves {
        if let Move::Cut { path, turns, .. } = m {
            loops.extend(turns.iter().filter(|t| t.kind == CornerKind::Loop).map(|turn| turn.of(path)));
        }
    }
    let colors = ["#1a8f5a", "#5fd39b"];
    Overlay { class: "loop", colors, width: None, title: "Loops at corners" }.draw(out, &loops);
}

/// Cuts through waste that join contours.
fn chains(out: &mut String, plan: &Plan) {
    let paths = plan.moves.iter();
    let paths = paths.filter_map(|m| if let Move::Chain { path } = m { Some(path.as_slice()) } else { None });
    let colors = ["#8a4fc7", "#c39bff"];
    Overlay { class: "chain", colors, width: None, title: "Cuts through waste" }
        .draw(out, &paths.collect::<Vec<_>>());
}

/// Strips of material that connect parts: their sides as drawn, wider than a cut.
fn bridges(out: &mut String, plan: &Plan, width: f64) {
    let sides = plan.bridges.iter().flat_map(|strip| strip.sides);
    let sides: Vec<[Segment; 1]> = sides.map(|[from, to]| [Segment::line(from, to)]).collect();
    let sides: Vec<&[Segment]> = sides.iter().map(|side| side.as_slice()).collect();
    let (colors, width) = (["#8a4fc7", "#c39bff"], Some(2.0 * width));
    Overlay { class: "bridge", colors, width, title: "Sides of bridges between parts" }.draw(out, &sides);
}

/// Micro-joints, as short wide strokes between the stretches of their contours.
fn joints(out: &mut String, plan: &Plan, width: f64) {
    let paths = plan.moves.iter();
    let paths =
        paths.filter_map(|m| if let Move::Joint { path, .. } = m { Some(path.as_slice()) } else { None });
    let (colors, width) = (["#b3267a", "#ff7ac0"], Some(4.0 * width));
    Overlay { class: "joint", colors, width, title: "Micro-joints" }.draw(out, &paths.collect::<Vec<_>>());
}

fn element(out: &mut String, segment: &Segment) {
    match segment {
        Segment::Line(l) => {
            let _ = write!(out, "L{}", Point(l.end));
        }
        Segment::Arc(a) => {
            let r = number(a.radius());
            // SVG has y down, so a counter-clockwise arc with y up has sweep flag 0.
            let sweep = u8::from(!a.ccw());
            for piece in arcs::split(a, LARGEST_SWEEP) {
                let _ = write!(out, "A{r} {r} 0 0 {sweep} {}", Point(piece.end));
            }
        }
    }
}

fn air(out: &mut String, plan: &Plan, home: DVec2) {
    let mut at = home;
    out.push_str("<path class=\"air\" d=\"");
    for step in &plan.moves {
        match step {
            Move::Air { to, .. } => {
                let _ = write!(out, "M{}L{}", Point(at), Point(*to));
                at = *to;
            }
            Move::Pierce
            | Move::MovingStart
            | Move::Macro { .. }
            | Move::Height { .. }
            | Move::Wait { .. } => {}
            Move::PreCut { to, .. } => at = *to,
            Move::Fly { path } => {
                let _ = write!(out, "M{}", Point(at));
                path.iter().for_each(|s| element(out, s));
                at = path.last().map_or(at, Segment::end);
            }
            Move::Cut { path, .. } | Move::Joint { path, .. } | Move::Chain { path } => {
                at = path.last().map_or(at, Segment::end);
            }
        }
    }
    out.push_str("\"/>\n");
}

fn entries(out: &mut String, plan: &Plan, view: &Aabb, width: f64) {
    let places: Vec<DVec2> = contour_cuts(plan).iter().map(|c| c.entry).collect();
    out.push_str("<path class=\"entry\" d=\"");
    for p in &places {
        let _ = write!(out, "M{}h0", Point(*p));
    }
    out.push_str("\"/>\n");
    if places.len() <= MAX_NUMBERED {
        for (order, corner) in
            labels::numbers(&places, view, width * BESIDE, width * TEXT_HEIGHT).iter().enumerate()
        {
            let Some(corner) = corner else { continue };
            let (x, y) = (number(corner.x), number(-corner.y));
            let _ = writeln!(out, "<text x=\"{x}\" y=\"{y}\">{}</text>", order + 1);
        }
    }
}

fn number(v: f64) -> Fixed {
    fixed(v, DECIMALS)
}

/// A place of the sheet in the picture's coordinates, with y down.
struct Point(DVec2);

impl std::fmt::Display for Point {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{} {}", number(self.0.x), number(-self.0.y))
    }
}

/// Text escaped for XML; characters that XML forbids become the replacement character.
struct Escaped<'a>(&'a str);

impl std::fmt::Display for Escaped<'_> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        self.0.chars().try_for_each(|c| match c {
            '&' => f.write_str("&amp;"),
            '<' => f.write_str("&lt;"),
            '>' => f.write_str("&gt;"),
            '\u{0}'..='\u{1f}' | '\u{7f}'..='\u{9f}' | '\u{fffe}' | '\u{ffff}' => f.write_str("\u{fffd}"),
            c => write!(f, "{c}"),
        })
    }
}
