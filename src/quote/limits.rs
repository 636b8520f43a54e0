//! Limits of what a shop makes, and the places where a drawing exceeds them (design for manufacture).

use super::narrow::{self, Web};
use super::parts::Part;
use super::shape::Shape;
use crate::fields::{self, Field, FieldError, Kind, Range, Shaped};
use crate::geometry::{Aabb, DVec2};
use serde::{Deserialize, Serialize};

/// Limits of what a shop makes. A limit that is not given is not checked.
#[derive(Clone, Debug, PartialEq, Default, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
#[cfg_attr(test, derive(ts_rs::TS), ts(optional_fields))]
pub struct Limits {
    /// Least width of a hole, mm: the diameter of a round one, the width of a slot.
    pub smallest_hole: Option<f64>,
    /// Least material between two holes, mm.
    pub smallest_web: Option<f64>,
    /// Least material between a hole and the edge of its part, mm.
    pub hole_to_edge: Option<f64>,
    /// Least width and height of a part, mm, the longer side first.
    pub smallest_part: Option<[f64; 2]>,
    /// Largest width and height of a part, mm, the longer side first.
    pub largest_part: Option<[f64; 2]>,
    /// Whether pieces that lie loose in a hole of another part are accepted: the inside of a letter O, a part nested in a part.
    pub floating_pieces: Option<bool>,
}

const LENGTH: Range = Range::new(1e-3, 1e5, "mm", "a limit is a length of a part");
const SIDES: Kind = Kind::Pair(&Kind::Number(LENGTH));

/// The fields of [`Limits`].
pub(super) const LIMITS: &[Field] = &[
    Field::nullable("smallest_hole", Kind::Number(LENGTH)),
    Field::nullable("smallest_web", Kind::Number(LENGTH)),
    Field::nullable("hole_to_edge", Kind::Number(LENGTH)),
    Field::nullable("smallest_part", SIDES),
    Field::nullable("largest_part", SIDES),
    Field::nullable("floating_pieces", Kind::Flag),
];

impl Shaped for Limits {
    const SHAPE: fields::Shape =
        fields::Shape { owner: "The limits", item: "field", value: "The limits' field", fields: LIMITS };
}

impl Limits {
    /// Checks the numbers, which may not have been read through [`Shaped`].
    pub(super) fn check(&self) -> Result<(), FieldError> {
        let side = |sides: Option<[f64; 2]>, k: usize| sides.and_then(|s| s.get(k).copied());
        let numbers = [
            ("smallest_hole", self.smallest_hole),
            ("smallest_web", self.smallest_web),
            ("hole_to_edge", self.hole_to_edge),
            ("smallest_part[0]", side(self.smallest_part, 0)),
            ("smallest_part[1]", side(self.smallest_part, 1)),
            ("largest_part[0]", side(self.largest_part, 0)),
            ("largest_part[1]", side(self.largest_part, 1)),
        ];
        for (name, value) in numbers {
            if let Some(n) = value.filter(|n| !LENGTH.holds(*n)) {
                return Err(FieldError::out_of_range(Self::SHAPE.value, name, n, &LENGTH));
            }
        }
        Ok(())
    }
}

/// What a limit is about.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize)]
#[serde(rename_all = "kebab-case")]
#[cfg_attr(test, derive(ts_rs::TS), ts(rename = "LimitCode"))]
pub enum CheckCode {
    /// A hole is narrower than the limit.
    HoleTooSmall,
    /// The material between two holes is narrower than the limit.
    WebTooThin,
    /// The material between a hole and the edge is narrower than the limit.
    HoleTooCloseToEdge,
    /// A part is smaller than the limit.
    PartTooSmall,
    /// A part is larger than the limit.
    PartTooLarge,
    /// A piece lies loose in a hole of another part.
    FloatingPiece,
}

/// A place where a part exceeds a limit.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(rename = "LimitExceeded"))]
pub struct Exceeded {
    /// What the limit is about.
    pub code: CheckCode,
    /// The part: the id of its outer contour.
    pub part: u32,
    /// The contours concerned.
    pub contours: Vec<u32>,
    /// The place, mm.
    pub at: [f64; 2],
    /// The measured length, mm; `None` for a floating piece.
    pub measured: Option<f64>,
    /// The limit, mm; `None` for a floating piece.
    pub limit: Option<f64>,
    /// One sentence for people.
    pub message: String,
}

/// The limits as given, and where they are exceeded.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(rename = "LimitChecks"))]
pub struct Checks {
    /// The limits; those that are `None` were not checked.
    #[cfg_attr(test, ts(type = "{ [K in keyof Required<Limits>]: Required<Limits>[K] | null }"))]
    pub limits: Limits,
    /// Where they are exceeded, by part; at most 200 of each kind.
    pub exceeded: Vec<Exceeded>,
    /// Number of further places that are not listed.
    pub unlisted: u32,
}

/// Places of one kind that are listed. A sheet with a thousand wrong holes needs no longer list.
const LISTED: usize = 200;

struct List<'l> {
    checks: &'l mut Checks,
    counts: [usize; 6],
}

impl List<'_> {
    fn add(&mut self, found: Exceeded) {
        let count = self.counts.get_mut(found.code as usize);
        let listed = count.as_ref().is_some_and(|n| **n < LISTED);
        if let Some(count) = count {
            *count += 1;
        }
        if listed {
            self.checks.exceeded.push(found);
        } else {
            self.checks.unlisted = self.checks.unlisted.saturating_add(1);
        }
    }
}

/// Compares every part with the limits.
pub(super) fn checks(parts: &[Part], shapes: &[Shape], limits: &Limits) -> Checks {
    let mut checks = Checks { limits: limits.clone(), exceeded: Vec::new(), unlisted: 0 };
    let mut list = List { checks: &mut checks, counts: [0; 6] };
    for part in parts {
        sizes(part, shapes, limits, &mut list);
        holes(part, shapes, limits, &mut list);
        webs(part, shapes, limits, &mut list);
        if limits.floating_pieces == Some(false) && part.in_hole {
            list.add(Exceeded {
                code: CheckCode::FloatingPiece,
                part: id(part.outer),
                contours: vec![id(part.outer)],
                at: middle(shapes, part.outer).into(),
                measured: None,
                limit: None,
                message: "This piece lies loose in a hole of another part and falls out.".into(),
            });
        }
    }
    checks
}

fn sizes(part: &Part, shapes: &[Shape], limits: &Limits, list: &mut List) {
    let Some(shape) = shapes.get(part.outer) else { return };
    let size = shape.bounds().size();
    let sides = [size.x.max(size.y), size.x.min(size.y)];
    let mut compare = |code, limit: Option<[f64; 2]>, beyond: fn(f64, f64) -> bool, word: &str| {
        let Some(limit) = limit.map(|[a, b]| [a.max(b), a.min(b)]) else { return };
        let Some(k) = (0..2).find(|&k| beyond(sides[k], limit[k])) else { return };
        let [long, short] = sides;
        list.add(Exceeded {
            code,
            part: id(part.outer),
            contours: vec![id(part.outer)],
            at: middle(shapes, part.outer).into(),
            measured: Some(sides[k]),
            limit: Some(limit[k]),
            message: format!(
                "The part measures {long:.2} x {short:.2} mm; {word} {} x {} mm.",
                limit[0], limit[1]
            ),
        });
    };
    // A part as large as the limit is accepted, whatever the rounding of its arcs.
    compare(
        CheckCode::PartTooSmall,
        limits.smallest_part,
        |side, limit| side < limit - SLACK,
        "the smallest is",
    );
    compare(
        CheckCode::PartTooLarge,
        limits.largest_part,
        |side, limit| side > limit + SLACK,
        "the largest is",
    );
}

/// What is nearer to its limit than this has reached it, mm: arcs are measured as chords within 0.01 mm.
const SLACK: f64 = 0.02;

fn holes(part: &Part, shapes: &[Shape], limits: &Limits, list: &mut List) {
    let Some(limit) = limits.smallest_hole else { return };
    for &hole in &part.holes {
        let Some(width) = shapes.get(hole).and_then(|s| s.narrower_than(limit - SLACK)) else { continue };
        list.add(Exceeded {
            code: CheckCode::HoleTooSmall,
            part: id(part.outer),
            contours: vec![id(hole)],
            at: middle(shapes, hole).into(),
            measured: Some(width),
            limit: Some(limit),
            message: format!("The hole is {width:.2} mm wide; the least is {limit} mm."),
        });
    }
}

fn webs(part: &Part, shapes: &[Shape], limits: &Limits, list: &mut List) {
    let reach = [limits.smallest_web, limits.hole_to_edge].into_iter().flatten().fold(0.0, f64::max);
    if reach <= SLACK || part.holes.is_empty() {
        return;
    }
    let all: Vec<usize> = std::iter::once(part.outer).chain(part.holes.iter().copied()).collect();
    for Web { contours, width, at } in narrow::closer_than(shapes, &all, reach) {
        let edge = contours.contains(&part.outer);
        let (code, limit, what) = if edge {
            (CheckCode::HoleTooCloseToEdge, limits.hole_to_edge, "Between the hole and the edge there are")
        } else {
            (CheckCode::WebTooThin, limits.smallest_web, "Between the two holes there are")
        };
        let Some(limit) = limit.filter(|limit| width < limit - SLACK) else { continue };
        list.add(Exceeded {
            code,
            part: id(part.outer),
            contours: contours.iter().map(|&c| id(c)).collect(),
            at: at.into(),
            measured: Some(width),
            limit: Some(limit),
            message: format!("{what} {width:.2} mm of material; the least is {limit} mm."),
        });
    }
}

fn middle(shapes: &[Shape], contour: usize) -> DVec2 {
    shapes.get(contour).map(Shape::bounds).filter(|b| !b.is_empty()).map_or(DVec2::ZERO, |b: Aabb| b.center())
}

fn id(contour: usize) -> u32 {
    u32::try_from(contour).unwrap_or(u32::MAX)
}
