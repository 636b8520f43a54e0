//! Writes a plan as a LightBurn project (`.lbrn2`), for machines whose controller takes no G-code.
//!
//! The shapes stand in cutting order, each as a path from its entry, with one LightBurn layer for each way of cutting
//! (speed, power, least power, height, air). LightBurn's own optimisation is switched off in the project, so that the
//! order stays. An arc becomes cubic Bezier curves of at most 30 degrees, which lie within 4e-7 of the radius.
//!
//! A LightBurn layer has no order among others unless LightBurn orders by layer; marks and cuts alternate as planned.
//! Every pass is a shape of its own, in a layer at the height of that pass, and LightBurn's number of passes is 1: LightBurn
//! would repeat the whole layer, after the parts have fallen out.
//!
//! What the project does not hold, such as the piercing time, is said in its notes, which LightBurn shows when it opens it.
//!
//! Sources: project files written by LightBurn 1.4 and 2.0 in public repositories.

use super::cuts::{Cut, closes, cuts};
use super::gcode::OutputError;
use super::process::CutProcess;
use super::sheet_facts::SheetFacts;
use crate::geometry::{Arc, DVec2, Segment, arcs, math};
use crate::machine::Profile;
use crate::number::{Fixed, fixed};
use crate::plan::{Move, Plan};
use std::f64::consts::PI;
use std::fmt::Write as _;

/// Largest sweep of one curve, rad.
const LARGEST_SWEEP: f64 = PI / 6.0;
/// LightBurn has thirty layers, C00 to C29.
const LAYERS: usize = 30;
/// Decimals of coordinates: LightBurn keeps six.
const DECIMALS: usize = 6;

/// LightBurn's settings of order and optimisation. -1 takes a criterion out of the list of orders; everything else is off.
const PREFERENCES: [(&str, &str); 14] = [
    ("Optimize_ByLayer", "-1"),
    ("Optimize_ByGroup", "-1"),
    ("Optimize_ByPriority", "-1"),
    ("Optimize_WhichDirection", "0"),
    ("Optimize_InnerToOuter", "0"),
    ("Optimize_ByDirection", "0"),
    ("Optimize_ReduceTravel", "0"),
    ("Optimize_HideBacklash", "0"),
    ("Optimize_ReduceDirChanges", "0"),
    ("Optimize_ChooseCorners", "0"),
    ("Optimize_AllowReverse", "0"),
    ("Optimize_RemoveOverlaps", "0"),
    ("Optimize_OptimalEntryPoint", "0"),
    ("Optimize_OverlapDist", "0.025"),
];

/// The LightBurn project of a plan.
///
/// # Errors
/// The plan cuts in more ways than LightBurn has layers.
pub fn lbrn2(plan: &Plan, sheet: &SheetFacts, profile: &Profile) -> Result<String, OutputError> {
    let cuts = cuts(plan);
    let layer_of = |cut: &Cut| (CutProcess::of_cut(sheet, profile, cut), cut.mark);
    let mut layers: Vec<(CutProcess, bool)> = Vec::new();
    for cut in &cuts {
        let layer = layer_of(cut);
        if !layers.contains(&layer) {
            layers.push(layer);
        }
    }
    if layers.len() > LAYERS {
        return Err(OutputError::Format(format!(
            "LightBurn has {LAYERS} layers, and this plan cuts in {} ways: give some layers the same settings.",
            layers.len()
        )));
    }
    let mut out = String::from(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<LightBurnProject AppVersion=\"1.4.00\" FormatVersion=\"1\" \
         MaterialHeight=\"0\" MirrorX=\"False\" MirrorY=\"False\">\n    <UIPrefs>\n",
    );
    for (name, value) in PREFERENCES {
        let _ = writeln!(out, "        <{name} Value=\"{value}\"/>");
    }
    out.push_str("    </UIPrefs>\n");
    for (index, (process, mark)) in layers.iter().enumerate() {
        setting(&mut out, index, process, *mark);
    }
    for cut in &cuts {
        let layer = layer_of(cut);
        let index = layers.iter().position(|l| *l == layer).unwrap_or(0);
        shape(&mut out, index, cut, closes(sheet, cut));
    }
    let notes = notes(plan, profile, &cuts);
    let show = u8::from(!notes.is_empty());
    let _ = writeln!(out, "    <Notes ShowOnLoad=\"{show}\" Notes=\"{}\"/>", notes.join("&#10;"));
    out.push_str("</LightBurnProject>\n");
    Ok(out)
}

/// What has to be set by hand, one sentence each. There is no text of others in them, so nothing to escape.
fn notes(plan: &Plan, profile: &Profile, cuts: &[Cut]) -> Vec<String> {
    let mut notes = Vec::new();
    let pierce = profile.pierce_time + profile.beam_on_delay;
    if pierce > 0.0 && cuts.iter().any(|c| c.pierced) {
        notes.push(format!(
            "Piercing is not in this project: set the start pause time of the cutting layers to {} s.",
            fixed(pierce, 3)
        ));
    }
    if plan.moves.iter().any(|m| matches!(m, Move::Macro { .. })) {
        notes.push("The pauses in sharp corners are not in this project: LightBurn has none.".to_owned());
    }
    if plan.moves.iter().any(Move::cuts_ahead) {
        notes.push("The pre-cuts are not in this project: LightBurn has none.".to_owned());
    }
    if plan.summary.waits > 0 {
        notes.push("The waits until it has cooled are not in this project: LightBurn has none.".to_owned());
    }
    if plan.summary.lifts + plan.summary.detours > 0 {
        notes.push(
            "The lifts of the head between cuts are not in this project: set the lift in the controller, for every move."
                .to_owned(),
        );
    }
    if cuts.iter().any(|c| c.z < 0.0) {
        notes.push(
            "Layers whose name ends with a height have a Z offset: switch on Z moves in the device settings."
                .to_owned(),
        );
    }
    notes
}

/// One layer: speed in mm/s, powers in per cent, height in mm. LightBurn counts a Z offset downwards.
fn setting(out: &mut String, index: usize, process: &CutProcess, mark: bool) {
    let percent = |power: f64| fixed(power * 100.0, 3).to_string();
    let (least, power) = (percent(process.min_power.unwrap_or(process.power)), percent(process.power));
    let name = if mark { "Mark" } else { "Cut" };
    let depth = fixed(-process.z, 3);
    let at = if process.z < 0.0 { format!(", {depth} mm down") } else { String::new() };
    let values = [
        ("index", index.to_string()),
        ("name", format!("{name} {index:02}{at}")),
        ("minPower", least.clone()),
        ("maxPower", power.clone()),
        ("minPower2", least),
        ("maxPower2", power),
        ("speed", fixed(process.speed, 3).to_string()),
        ("zOffset", depth.to_string()),
        ("numPasses", "1".to_owned()),
        ("runBlower", u8::from(process.air).to_string()),
        ("priority", index.to_string()),
    ];
    out.push_str("    <CutSetting type=\"Cut\">\n");
    for (name, value) in values {
        let _ = writeln!(out, "        <{name} Value=\"{value}\"/>");
    }
    out.push_str("    </CutSetting>\n");
}

/// A vertex with the control points of the curves before and after it.
#[derive(Default)]
struct Vertex {
    at: DVec2,
    after: Option<DVec2>,
    before: Option<DVec2>,
}

fn shape(out: &mut String, layer: usize, cut: &Cut, closed: bool) {
    let mut vertices = vec![Vertex { at: cut.entry, ..Vertex::default() }];
    let mut curves = Vec::new();
    let mut add = |end: DVec2, handles: Option<[DVec2; 2]>| {
        if let Some(last) = vertices.last_mut() {
            last.after = handles.map(|h| h[0]);
        }
        curves.push(handles.is_some());
        vertices.push(Vertex { at: end, before: handles.map(|h| h[1]), after: None });
    };
    for segment in cut.path.iter() {
        match segment {
            Segment::Line(l) => add(l.end, None),
            Segment::Arc(a) => {
                arcs::split(a, LARGEST_SWEEP).for_each(|piece| add(piece.end, Some(handles(&piece))))
            }
        }
    }
    if closed
        && let Some(last) = vertices.pop()
        && let Some(first) = vertices.first_mut()
    {
        first.before = last.before;
    }
    let _ = write!(
        out,
        "    <Shape Type=\"Path\" CutIndex=\"{layer}\">\n        <XForm>1 0 0 1 0 0</XForm>\n        <VertList>"
    );
    for v in &vertices {
        let _ = write!(out, "V{} {}", number(v.at.x), number(v.at.y));
        for (name, handle) in [("c0", v.after), ("c1", v.before)] {
            let _ = match handle {
                Some(h) => write!(out, "{name}x{}{name}y{}", number(h.x), number(h.y)),
                None => write!(out, "{name}x1"),
            };
        }
    }
    out.push_str("</VertList>\n        <PrimList>");
    for (k, curve) in curves.iter().enumerate() {
        let next = if k + 1 < vertices.len() { k + 1 } else { 0 };
        let _ = write!(out, "{}{k} {next}", if *curve { "B" } else { "L" });
    }
    out.push_str("</PrimList>\n    </Shape>\n");
}

/// The control points of a cubic curve for a short arc: along the tangents, 4/3 tan(sweep / 4) of the radius away.
fn handles(arc: &Arc) -> [DVec2; 2] {
    let k = 4.0 / 3.0 * math::tan(arc.sweep * 0.25);
    let tangent = |p: DVec2| (p - arc.center).perp();
    [arc.start + tangent(arc.start) * k, arc.end - tangent(arc.end) * k]
}

fn number(v: f64) -> Fixed {
    fixed(v, DECIMALS)
}
