//! The moves of a plan document, and how they come from a plan.
//!
//! An arc has no sweep in this format: its ends, centre and direction say it, and one that ends exactly where it starts is
//! a full circle. Where rounding could turn next to nothing into a circle, or a circle into next to nothing, the arc is
//! replaced by what is safe: one flatter than [`FLAT`] by its chord, one nearer to a full turn than [`NEAR_TURN`] by two
//! halves.

use super::super::model::{self, Way};
use crate::geometry::{Arc, DVec2, Segment, arcs};
use crate::machine::CornerKind;
use serde::{Deserialize, Serialize};
use std::f64::consts::{PI, TAU};

/// An arc no farther than this from its chord is written as a line, mm: a thousandth of the smallest thing a drawing
/// says, and a thousand times the rounding of a place on the largest sheet.
const FLAT: f64 = 1e-9;
/// An arc this near to a full turn, but not joined, is written as two, rad: on a circle of 1 m, a micrometre.
const NEAR_TURN: f64 = 1e-6;

/// One thing the head does. It starts where the last one ended, the first at the machine's home. Places in mm.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(tag = "kind", rename_all = "kebab-case")]
pub enum Move {
    /// Beam off, to a place.
    Air {
        /// Where to.
        to: [f64; 2],
        /// What it does about pieces that may have tipped: `around`, to a place on the way around them; `lifted`, over them
        /// with the head lifted; `crosses`, over them with the head down. Left out: it meets none.
        #[serde(default, skip_serializing_if = "Way::is_plain")]
        way: Way,
    },
    /// Piercing on the spot.
    Pierce,
    /// The beam goes on as the next cut or mark begins to move: no wait before it.
    MovingStart,
    /// A bit of a contour cut ahead where the head is: the contour is resumed there later without piercing.
    PreCut {
        /// The contour's id.
        contour: u32,
        /// Where the head is.
        to: [f64; 2],
        /// What is cut ahead from there, before the head comes back dark; empty where pre-cuts have no length.
        #[serde(default, skip_serializing_if = "Vec::is_empty")]
        ahead: Vec<Element>,
    },
    /// A pause in a sharp corner, beam off; the next move goes on with the cut.
    Macro {
        /// The contour's id.
        contour: u32,
        /// The corner.
        at: [f64; 2],
    },
    /// A micro-joint: a length of a contour that stays uncut. The beam is off; the contour is cut on at its end.
    Joint {
        /// The contour's id.
        contour: u32,
        /// The elements of the contour that stay uncut.
        path: Vec<Element>,
        /// Whether the head runs along them without stopping. If not, it moves straight to their end and pierces there.
        #[serde(default, skip_serializing_if = "std::ops::Not::not")]
        flying: bool,
    },
    /// The head runs on from one cut to the next without stopping, beam off: both cuts are one motion.
    Fly {
        /// The elements of the way.
        path: Vec<Element>,
    },
    /// Beam on through waste, from the end of one cut to the beginning of the next, which is not pierced.
    Chain {
        /// Elements in order.
        path: Vec<Element>,
    },
    /// The head is lowered or raised, beam off.
    Height {
        /// mm; 0 as focused, negative when lowered.
        z: f64,
    },
    /// The head waits, beam off, until what was cut nearby has cooled.
    Wait {
        /// s.
        seconds: f64,
    },
    /// Beam on along a contour, or a stretch of it; cutting or marking as the contour's operation says.
    Cut {
        /// The contour, or all contours that share this cut.
        contour: Contours,
        /// Elements in order, each from where the last one ended.
        path: Vec<Element>,
        /// How many of the first elements are the lead-in.
        #[serde(default, skip_serializing_if = "is_zero")]
        lead_in: usize,
        /// How many elements after the contour repeat its beginning.
        #[serde(default, skip_serializing_if = "is_zero")]
        overcut: usize,
        /// How many of the last elements are the lead-out.
        #[serde(default, skip_serializing_if = "is_zero")]
        lead_out: usize,
        /// The corners that are cut in a loop or rounded, in order.
        #[serde(default, skip_serializing_if = "Vec::is_empty")]
        corners: Vec<Corner>,
    },
}

/// A corner in which a cut does not stop.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Corner {
    /// `loop`: through waste and back through the corner; `round`: along an arc instead of the corner.
    pub kind: CornerKind,
    /// The corner, mm.
    pub at: [f64; 2],
    /// How many elements of the cut come before those of the loop or the arc.
    pub first: usize,
    /// How many elements these are.
    pub count: usize,
}

/// The contour of a cut, or the contours that share it, by id.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(untagged)]
pub enum Contours {
    /// One contour.
    One(u32),
    /// The contours of a pierce group that the cut runs along, in order.
    Several(Vec<u32>),
}

/// A line or an arc from where the last element ended. Places in mm.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(untagged)]
pub enum Element {
    /// A straight line.
    Line {
        /// Its end.
        line: [f64; 2],
    },
    /// A circular arc; one that ends where it starts is a full circle.
    Arc {
        /// Its end.
        arc: [f64; 2],
        /// Its centre.
        center: [f64; 2],
        /// Whether it runs counter-clockwise.
        ccw: bool,
    },
}

impl From<&model::Move> for Move {
    fn from(step: &model::Move) -> Self {
        match step {
            model::Move::Air { to, way } => Self::Air { to: place(*to), way: *way },
            model::Move::Pierce => Self::Pierce,
            model::Move::MovingStart => Self::MovingStart,
            model::Move::PreCut { contour, to, ahead } => {
                Self::PreCut { contour: *contour, to: place(*to), ahead: Element::all(ahead) }
            }
            model::Move::Macro { contour, at } => Self::Macro { contour: *contour, at: place(*at) },
            model::Move::Joint { contour, path, flying } => {
                Self::Joint { contour: *contour, path: Element::all(path), flying: *flying }
            }
            model::Move::Fly { path } => Self::Fly { path: Element::all(path) },
            model::Move::Chain { path } => Self::Chain { path: Element::all(path) },
            model::Move::Height { z } => Self::Height { z: *z },
            model::Move::Wait { seconds } => Self::Wait { seconds: *seconds },
            model::Move::Cut { contour, with, path, leads, turns, .. } => {
                // An arc may become two elements, so each part is counted as it is written.
                let [lead_in, on, overcut, lead_out] = leads.divide(path).map(Element::all);
                let counts = [&lead_in, &overcut, &lead_out].map(Vec::len);
                // The corners are in order, so that the elements before each are counted on from the one before.
                let (mut done, mut first) = (0, 0);
                let corner = |turn: &model::Turn| {
                    first += Element::all(path.get(done..turn.first).unwrap_or_default()).len();
                    done = turn.first;
                    let count = Element::all(turn.of(path)).len();
                    Corner { kind: turn.kind, at: place(turn.at), first, count }
                };
                Self::Cut {
                    contour: Contours::of(*contour, with),
                    path: [lead_in, on, overcut, lead_out].concat(),
                    lead_in: counts[0],
                    overcut: counts[1],
                    lead_out: counts[2],
                    corners: turns.iter().map(corner).collect(),
                }
            }
        }
    }
}

impl From<&Corner> for model::Turn {
    fn from(corner: &Corner) -> Self {
        let Corner { kind, at, first, count } = *corner;
        Self { kind, at: at.into(), first, count }
    }
}

#[allow(clippy::trivially_copy_pass_by_ref, reason = "what serde asks for")]
fn is_zero(count: &usize) -> bool {
    *count == 0
}

impl Contours {
    fn of(contour: u32, with: &[u32]) -> Self {
        match with {
            [] => Self::One(contour),
            others => Self::Several(std::iter::once(contour).chain(others.iter().copied()).collect()),
        }
    }

    /// The contour, or the first of several.
    pub fn first(&self) -> Option<u32> {
        match self {
            Self::One(id) => Some(*id),
            Self::Several(ids) => ids.first().copied(),
        }
    }
}

impl Element {
    /// The elements that say what these segments are.
    pub(super) fn all(segments: &[Segment]) -> Vec<Self> {
        let mut all = Vec::with_capacity(segments.len());
        for segment in segments {
            match segment {
                Segment::Arc(a) if !is_flat(a) => {
                    all.extend(arcs::split(a, largest_sweep(a)).map(|a| Self::arc(&a)));
                }
                Segment::Line(_) | Segment::Arc(_) => all.push(Self::Line { line: place(segment.end()) }),
            }
        }
        all
    }

    /// Elements with both ends, the first from `at`, which moves on to the end of the last.
    pub fn segments(path: &[Self], at: &mut DVec2) -> Vec<Segment> {
        segments(path, at)
    }

    fn arc(arc: &Arc) -> Self {
        Self::Arc { arc: place(arc.end), center: place(arc.center), ccw: arc.ccw() }
    }

    fn segment(self, from: DVec2) -> Segment {
        match self {
            Self::Line { line } => Segment::line(from, line.into()),
            Self::Arc { arc, center, ccw } => Segment::Arc(Arc::new(from, arc.into(), center.into(), ccw)),
        }
    }
}

/// Elements with both ends, the first from `at`, which moves on to the end of the last.
pub(crate) fn segments(path: &[Element], at: &mut DVec2) -> Vec<Segment> {
    let segment = |element: &Element| {
        let segment = element.segment(*at);
        *at = segment.end();
        segment
    };
    path.iter().map(segment).collect()
}

/// A point without minus zeros.
pub(super) fn place(p: DVec2) -> [f64; 2] {
    [p.x + 0.0, p.y + 0.0]
}

/// Whether every reader takes the arc for its chord.
fn is_flat(arc: &Arc) -> bool {
    arc.sweep.abs() < PI && arcs::sagitta(arc) < FLAT
}

/// The largest sweep that ends, centre and direction of this arc's pieces say safely.
fn largest_sweep(arc: &Arc) -> f64 {
    let joined = arc.is_circle() && arc.start == arc.end;
    if joined || arc.sweep.abs() < TAU - NEAR_TURN { TAU } else { PI }
}
