//! A plan document (`kerfway.plan/1`) as strokes of the head, in order: what is drawn of it, and what is measured.

#![cfg_attr(not(feature = "png"), expect(dead_code, reason = "a quote measures strokes, and draws none"))]

use crate::geometry::{Aabb, Arc, DVec2, Segment};
use crate::sheet::Operation;
use serde::Deserialize;

/// The format this reads.
const SCHEMA: &str = "kerfway.plan/1";

/// One stroke of the head.
pub(crate) enum Stroke {
    /// Beam off.
    Air {
        /// mm.
        from: DVec2,
        /// mm.
        to: DVec2,
    },
    /// Beam on.
    Beam {
        /// The contour's id; `None` for a pre-cut.
        contour: Option<usize>,
        /// Elements, mm.
        path: Vec<Segment>,
    },
}

/// The strokes of a plan, the first from home.
pub(crate) struct Picture {
    home: DVec2,
    operations: Vec<Operation>,
    /// By contour: the outline of what is made, where that is not the line cut.
    pub(crate) outlines: Vec<Option<Vec<Segment>>>,
    pub(crate) strokes: Vec<Stroke>,
}

#[derive(Deserialize)]
struct Document {
    schema: String,
    machine: Machine,
    contours: Vec<Contour>,
    moves: Vec<Move>,
}

#[derive(Deserialize)]
struct Machine {
    home: [f64; 2],
}

#[derive(Deserialize)]
struct Contour {
    operation: Operation,
    #[serde(default)]
    drawn: Option<Outline>,
}

#[derive(Deserialize)]
struct Outline {
    from: [f64; 2],
    path: Vec<Element>,
}

#[derive(Deserialize)]
#[serde(tag = "kind", rename_all = "kebab-case")]
enum Move {
    Air { to: [f64; 2] },
    Pierce,
    PreCut { to: [f64; 2] },
    Macro,
    Cut { contour: Contours, path: Vec<Element> },
}

/// The contour of a cut, or the contours that share it.
#[derive(Deserialize)]
#[serde(untagged)]
enum Contours {
    One(usize),
    Shared(Vec<usize>),
}

#[derive(Deserialize)]
#[serde(untagged)]
enum Element {
    Line { line: [f64; 2] },
    Arc { arc: [f64; 2], center: [f64; 2], ccw: bool },
}

impl Picture {
    /// The picture of a plan document; an error is a sentence for people.
    pub(crate) fn read(plan_json: &str) -> Result<Self, String> {
        let document: Document = serde_json::from_str(plan_json)
            .map_err(|e| format!("This is not a plan of the kind {SCHEMA}: {e}."))?;
        if document.schema != SCHEMA {
            return Err(format!("This is a document of the kind {}, not {SCHEMA}.", document.schema));
        }
        let home = point(document.machine.home);
        let mut at = home;
        let mut strokes = Vec::with_capacity(document.moves.len());
        for step in document.moves {
            let from = at;
            match step {
                Move::Air { to } => {
                    at = point(to);
                    strokes.push(Stroke::Air { from, to: at });
                }
                Move::Pierce | Move::Macro => {}
                Move::PreCut { to } => {
                    at = point(to);
                    strokes.push(Stroke::Beam { contour: None, path: vec![Segment::line(from, at)] });
                }
                Move::Cut { contour, path } => {
                    let id = match contour {
                        Contours::One(id) => Some(id),
                        Contours::Shared(ids) => ids.first().copied(),
                    };
                    let path: Vec<Segment> = path.into_iter().map(|e| e.segment(&mut at)).collect();
                    strokes.push(Stroke::Beam { contour: id, path });
                }
            }
        }
        let operations = document.contours.iter().map(|c| c.operation).collect();
        let outline = |o: Outline| {
            let mut at = point(o.from);
            o.path.into_iter().map(|e| e.segment(&mut at)).collect()
        };
        let outlines = document.contours.into_iter().map(|c| c.drawn.map(outline)).collect();
        Ok(Self { home, operations, outlines, strokes })
    }

    /// What is done along a contour; pre-cuts are cuts.
    pub(crate) fn operation(&self, contour: Option<usize>) -> Operation {
        contour.and_then(|id| self.operations.get(id)).copied().unwrap_or(Operation::Cut)
    }

    /// The box of everything drawn, mm.
    pub(crate) fn bounds(&self) -> Aabb {
        self.strokes.iter().fold(Aabb::of(self.home), |b, stroke| match stroke {
            Stroke::Air { to, .. } => b.with(*to),
            Stroke::Beam { path, .. } => path.iter().fold(b, |b, s| b.union(s.bounds())),
        })
    }
}

impl Element {
    /// The element that starts at `at`, which moves on to its end.
    fn segment(self, at: &mut DVec2) -> Segment {
        let start = *at;
        let segment = match self {
            Self::Line { line } => Segment::line(start, point(line)),
            Self::Arc { arc, center, ccw } => Segment::Arc(Arc::new(start, point(arc), point(center), ccw)),
        };
        *at = segment.end();
        segment
    }
}

fn point([x, y]: [f64; 2]) -> DVec2 {
    DVec2::new(x, y)
}
