//! The figures of a quote (`kerfway.quote/2`), and how they come from a plan document.

use super::confidence::{Confidence, Defect, confidence, defects, of_parts};
use super::limits::{self, Checks, Limits};
use super::material::Material;
use super::narrow::{self, Web};
use super::parts::{self, Part, PartGroup, PartItem};
use super::seconds::{Seconds, seconds};
use super::shape::Shape;
use super::terms::Terms;
use super::times::Times;
use crate::geometry::Aabb;
use crate::machine::Profile;
use crate::plan::document::{Contour, Document, Input, Options, Placement};
use crate::sheet::Operation;
use serde::ser::Error;
use serde::{Serialize, Serializer};

/// The format this writes.
const SCHEMA: &str = "kerfway.quote/2";

/// What a price depends on. Lengths are in mm, areas in mm2, times in s, weights in g. docs/quote.md describes every field.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct Quote {
    /// Name and version of the format.
    #[cfg_attr(test, ts(type = "'kerfway.quote/2'"))]
    pub schema: &'static str,
    /// The version of the planner that made the report. It is not part of the hash.
    pub version: &'static str,
    /// SHA-256 of the whole report with `hash`, `version` and `input.name` empty. The same drawing, options, seed and moves give the same
    /// hash natively, in Node and in every browser, whatever the file is called. A server that plans again with `moves` can confirm
    /// the report of a browser.
    pub hash: String,
    /// The drawing.
    #[cfg_attr(test, ts(inline))]
    pub input: Input,
    /// The machine's whole profile.
    #[serde(serialize_with = "by_name")]
    pub machine: Profile,
    /// Name of the setting in the machine's library of materials that it was planned with; the machine has it on. `None`: with
    /// its own.
    pub setting: Option<String>,
    /// How the drawing was read and arranged, as in the plan document.
    #[serde(serialize_with = "by_name")]
    #[cfg_attr(test, ts(type = "Record<string, unknown>"))]
    pub options: Options,
    /// Where the job lies on the bed; `None`: where it was drawn.
    #[cfg_attr(test, ts(type = "{ shift: [number, number], start: Start } | null"))]
    pub placement: Option<Placement>,
    /// Name of the search method.
    pub method: String,
    /// Parameters of the method; `None` if all are the defaults.
    pub parameters: Option<String>,
    /// Seed of all random choices.
    pub seed: u64,
    /// Number of moves that the search made. The same moves, seed and workers give the same plan.
    pub moves: u64,
    /// Number of parallel searches; `None` for one.
    pub workers: Option<u32>,
    /// Whether the plan comes from a path that was given: then the three do not give it again.
    #[serde(skip_serializing_if = "std::ops::Not::not")]
    #[cfg_attr(test, ts(as = "Option<bool>", optional))]
    pub from_path: bool,
    /// The material, as given.
    #[cfg_attr(test, ts(type = "{ [K in keyof Required<Material>]: Required<Material>[K] | null }"))]
    pub material: Material,
    /// Seconds of the job.
    pub times: Times,
    /// Seconds of cuts and marks that belong to no part. Those of all parts and these add up to `times`.
    pub loose_times: Times,
    /// Length of cuts and marks, leads included.
    pub cut_length: f64,
    /// Length of lead-ins, lead-outs and overcuts.
    #[serde(skip_serializing_if = "crate::fields::is_zero")]
    #[cfg_attr(test, ts(as = "Option<f64>", optional))]
    pub lead_length: f64,
    /// Length of air moves.
    pub air_length: f64,
    /// Number of piercings.
    pub pierces: u32,
    /// Number of pre-cuts.
    pub pre_cuts: u32,
    /// Number of micro-joints.
    #[serde(skip_serializing_if = "is_none")]
    #[cfg_attr(test, ts(as = "Option<u32>", optional))]
    pub joints: u32,
    /// Time of stopping at micro-joints, which is part of the times of air moves and of piercing.
    #[serde(skip_serializing_if = "crate::fields::is_zero")]
    #[cfg_attr(test, ts(as = "Option<f64>", optional))]
    pub joint_time: f64,
    /// Number of skeleton cuts, which are not among the contours.
    #[serde(skip_serializing_if = "is_none")]
    #[cfg_attr(test, ts(as = "Option<u32>", optional))]
    pub skeleton_cuts: u32,
    /// Length of skeleton cuts, which is part of the length of cuts.
    #[serde(skip_serializing_if = "crate::fields::is_zero")]
    #[cfg_attr(test, ts(as = "Option<f64>", optional))]
    pub skeleton_length: f64,
    /// Time from the end of the last other cut to the end of the last skeleton cut.
    #[serde(skip_serializing_if = "crate::fields::is_zero")]
    #[cfg_attr(test, ts(as = "Option<f64>", optional))]
    pub skeleton_time: f64,
    /// Cut and marked contours by layer.
    pub layers: Vec<LayerUse>,
    /// Number of parts.
    pub part_count: usize,
    /// Groups of equal parts, the largest part first. Mirrored parts are equal.
    pub parts: Vec<PartGroup>,
    /// xmin, ymin, xmax, ymax of everything that is cut or marked.
    pub bounds: [f64; 4],
    /// Area of all parts without their holes.
    pub net_area: f64,
    /// Area of the box `bounds`.
    pub box_area: f64,
    /// Weight of all parts, g, if thickness and density are given.
    pub weight: Option<f64>,
    /// The narrowest hole.
    pub smallest_hole: Option<Smallest>,
    /// The narrowest web: where two cuts of one part are closest to each other.
    pub narrowest_web: Option<Narrowest>,
    /// Where the drawing exceeds the limits of the shop, if limits were given.
    pub checks: Option<Checks>,
    /// What a person should look at before cutting.
    pub defects: Vec<Defect>,
    /// How far the figures can be relied on.
    pub confidence: Confidence,
}

/// The contours of a layer with the same operation.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(rename = "QuoteLayer"))]
pub struct LayerUse {
    /// Name of the layer.
    pub layer: String,
    /// Cut or mark.
    #[cfg_attr(test, ts(type = "Exclude<Operation, 'ignore'>"))]
    pub operation: Operation,
    /// Number of contours on it.
    pub contours: u32,
    /// Number of open contours among them.
    pub open: u32,
    /// Length of all its contours.
    pub length: f64,
}

/// The hole with the least width.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(rename = "SmallestHole"))]
pub struct Smallest {
    /// The contour's id.
    pub contour: usize,
    /// Diameter of the largest circle inside it: a circle's diameter, a slot's width, also where the slot is bent.
    pub width: f64,
    /// Width divided by the thickness, if that is given.
    pub over_thickness: Option<f64>,
}

/// Where material is thinnest between two cuts of a part.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(rename = "NarrowestWeb"))]
pub struct Narrowest {
    /// The two contours.
    pub contours: [usize; 2],
    /// Distance between them.
    pub width: f64,
    /// Middle of the narrowest place.
    pub at: [f64; 2],
    /// Width divided by the thickness, if that is given.
    pub over_thickness: Option<f64>,
}

/// Writes the fields of a struct in the order of their names: the hash of a quote is over that order.
fn by_name<T: Serialize, S: Serializer>(value: &T, serializer: S) -> Result<S::Ok, S::Error> {
    serde_json::to_value(value).map_err(S::Error::custom)?.serialize(serializer)
}

#[allow(clippy::trivially_copy_pass_by_ref, reason = "what serde asks for")]
fn is_none(count: &u32) -> bool {
    *count == 0
}

/// The report, its hash still empty.
pub(super) fn made(document: &Document, shapes: &[Shape], terms: &Terms) -> Quote {
    let material = &terms.material;
    let Document { budget, input, summary, contours, .. } = document;
    let parts = parts::parts(contours);
    let holes: f64 = parts.iter().flat_map(|p| &p.holes).map(|&h| contours[h].area).sum();
    let net_area = parts.iter().map(|p| contours[p.outer].area).sum::<f64>() - holes;
    let [x0, y0, x1, y1] = summary.bounds;
    let defects = defects(&document.findings);
    let unset = material.name.as_deref().filter(|_| document.material.is_none());
    let confidence =
        confidence(input, &defects, contours, unset.map(|name| (name, document.machine.title.as_str())));
    let boxes: Vec<Aabb> = parts.iter().map(|p| shapes[p.outer].bounds()).collect();
    let (seconds, loose) = seconds(document, parts.len(), &parts::part_of(&parts, contours));
    let items = items(&parts, &boxes, &seconds, of_parts(&document.findings, &boxes));
    let volume = material.thickness.map(|t| t * net_area / 1000.0);
    Quote {
        schema: SCHEMA,
        version: env!("CARGO_PKG_VERSION"),
        hash: String::new(),
        input: input.clone(),
        machine: document.machine.clone(),
        setting: document.material.clone(),
        options: document.options.clone(),
        placement: document.placement,
        method: document.method.clone(),
        parameters: document.parameters.clone(),
        seed: document.seed,
        moves: budget.done,
        workers: budget.workers,
        from_path: budget.from_path,
        material: material.clone(),
        times: Times {
            total: summary.total_time,
            cut: summary.cut_time,
            air: summary.air_time,
            pierce: summary.pierce_time,
            pre_cut: summary.pre_cut_time,
            macros: summary.macro_time,
        },
        loose_times: loose.times,
        cut_length: summary.cut_length,
        lead_length: summary.lead_length,
        air_length: summary.air_length,
        pierces: summary.pierces,
        pre_cuts: summary.pre_cuts,
        joints: summary.joints,
        joint_time: summary.joint_time,
        skeleton_cuts: summary.skeleton_cuts,
        skeleton_length: summary.skeleton_length,
        skeleton_time: summary.skeleton_time,
        layers: layers(contours),
        part_count: parts.len(),
        parts: parts::groups(&parts, contours, shapes, items),
        bounds: summary.bounds,
        net_area,
        box_area: (x1 - x0) * (y1 - y0),
        weight: volume.zip(material.density).map(|(cm3, density)| cm3 * density),
        smallest_hole: smallest(&parts, shapes, material),
        narrowest_web: narrowest(&parts, shapes, material),
        checks: (terms.limits != Limits::default()).then(|| limits::checks(&parts, shapes, &terms.limits)),
        defects,
        confidence,
    }
}

/// The parts as the report lists them.
fn items(parts: &[Part], boxes: &[Aabb], seconds: &[Seconds], confidence: Vec<Confidence>) -> Vec<PartItem> {
    let item = |(((part, b), s), confidence): (((&Part, &Aabb), &Seconds), Confidence)| PartItem {
        id: u32::try_from(part.outer).unwrap_or(u32::MAX),
        bounds: if b.is_empty() { [0.0; 4] } else { [b.min.x, b.min.y, b.max.x, b.max.y] },
        times: s.times,
        pierces: s.pierces,
        confidence,
    };
    parts.iter().zip(boxes).zip(seconds).zip(confidence).map(item).collect()
}

fn layers(contours: &[Contour]) -> Vec<LayerUse> {
    let mut all: Vec<LayerUse> = Vec::new();
    for c in
        contours.iter().filter(|c| c.operation != Operation::Ignore && c.next_pass.is_none() && !c.is_added())
    {
        let known = all.iter().position(|l| l.layer == c.layer && l.operation == c.operation);
        let at = known.unwrap_or_else(|| {
            let (layer, operation) = (c.layer.clone(), c.operation);
            all.push(LayerUse { layer, operation, contours: 0, open: 0, length: 0.0 });
            all.len() - 1
        });
        all[at].contours += 1;
        all[at].open += u32::from(c.is_open());
        all[at].length += c.length;
    }
    all
}

fn smallest(parts: &[Part], shapes: &[Shape], material: &Material) -> Option<Smallest> {
    let mut least: Option<Smallest> = None;
    for &contour in parts.iter().flat_map(|p| &p.holes) {
        if let Some(width) = shapes[contour].narrower_than(least.map_or(f64::INFINITY, |l| l.width)) {
            least = Some(Smallest { contour, width, over_thickness: material.thickness.map(|t| width / t) });
        }
    }
    least
}

fn narrowest(parts: &[Part], shapes: &[Shape], material: &Material) -> Option<Narrowest> {
    let mut least: Option<Web> = None;
    for part in parts {
        let all: Vec<usize> = std::iter::once(part.outer).chain(part.holes.iter().copied()).collect();
        if let Some(web) = narrow::between(shapes, &all)
            && least.is_none_or(|l| web.width < l.width)
        {
            least = Some(web);
        }
    }
    least.map(|Web { contours, width, at }| {
        let over_thickness = material.thickness.map(|t| width / t);
        Narrowest { contours, width, at: at.into(), over_thickness }
    })
}
