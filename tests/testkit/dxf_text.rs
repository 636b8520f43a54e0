//! Drawings as text, for tests: entities that can be moved, turned, mirrored, scaled, reversed and taken apart, and
//! a writer that lays them out as DXF. It shares nothing with the reader.

use kerfway::geometry::{DVec2, math};
use std::f64::consts::{PI, TAU};
use std::fmt::Write;

/// An entity in drawing units, angles in rad.
#[derive(Clone, Debug)]
pub enum Entity {
    Line(DVec2, DVec2),
    Circle(DVec2, f64),
    /// Centre, radius, from angle, to angle, counter-clockwise.
    Arc(DVec2, f64, f64, f64),
    /// Vertices with bulges, closed or not.
    Polyline(Vec<(DVec2, f64)>, bool),
    /// Centre, major axis, ratio, from parameter, to parameter.
    Ellipse(DVec2, DVec2, f64, f64, f64),
    /// A cubic with clamped uniform knots through its first and last control point.
    Spline(Vec<DVec2>),
}

/// Mirrors in the x axis (or not), turns, scales, then moves.
#[derive(Clone, Copy, Debug)]
pub struct Similarity {
    pub mirror: bool,
    pub turn: f64,
    pub scale: f64,
    pub shift: DVec2,
}

impl Similarity {
    pub const IDENTITY: Self = Self { mirror: false, turn: 0.0, scale: 1.0, shift: DVec2::ZERO };

    pub fn vector(&self, v: DVec2) -> DVec2 {
        let v = if self.mirror { DVec2::new(v.x, -v.y) } else { v };
        math::rotate(v, self.turn) * self.scale
    }

    pub fn point(&self, p: DVec2) -> DVec2 {
        self.vector(p) + self.shift
    }
}

impl Entity {
    pub fn transformed(&self, t: &Similarity) -> Self {
        // Angles from `a` to `b` seen in a mirror run from -b to -a.
        let angles =
            |a: f64, b: f64| if t.mirror { (t.turn - b, t.turn - a) } else { (t.turn + a, t.turn + b) };
        match self {
            Self::Line(a, b) => Self::Line(t.point(*a), t.point(*b)),
            Self::Circle(c, r) => Self::Circle(t.point(*c), r * t.scale),
            Self::Arc(c, r, a, b) => {
                let (a, b) = angles(*a, *b);
                Self::Arc(t.point(*c), r * t.scale, a, b)
            }
            Self::Polyline(v, closed) => {
                let sign = if t.mirror { -1.0 } else { 1.0 };
                Self::Polyline(v.iter().map(|(p, b)| (t.point(*p), b * sign)).collect(), *closed)
            }
            Self::Ellipse(c, major, ratio, a, b) => {
                let (a, b) = if t.mirror { (-b, -a) } else { (*a, *b) };
                Self::Ellipse(t.point(*c), t.vector(*major), *ratio, a, b)
            }
            Self::Spline(points) => Self::Spline(points.iter().map(|p| t.point(*p)).collect()),
        }
    }

    /// The same curve written from its other end, where the format can say so.
    pub fn reversed(&self) -> Self {
        match self {
            Self::Line(a, b) => Self::Line(*b, *a),
            Self::Polyline(v, closed) => {
                let n = v.len();
                let bulge = |i: usize| -v[(2 * n - 2 - i) % n].1;
                let out = (0..n).map(|i| (v[n - 1 - i].0, bulge(i)));
                Self::Polyline(out.collect(), *closed)
            }
            Self::Spline(points) => Self::Spline(points.iter().rev().copied().collect()),
            // Half a turn on, the same ellipse from the other side.
            Self::Ellipse(c, major, ratio, a, b) => Self::Ellipse(*c, -*major, *ratio, a - PI, b - PI),
            other => other.clone(),
        }
    }

    /// A polyline as its lines and arcs; other entities unchanged.
    pub fn exploded(&self) -> Vec<Self> {
        let Self::Polyline(v, closed) = self else { return vec![self.clone()] };
        let count = if *closed { v.len() } else { v.len() - 1 };
        let piece = |i: usize| {
            let ((a, bulge), (b, _)) = (v[i], v[(i + 1) % v.len()]);
            if bulge == 0.0 {
                return Self::Line(a, b);
            }
            let center = (a + b) * 0.5 + (b - a).perp() * ((1.0 - bulge * bulge) / (4.0 * bulge));
            let (from, to) = (math::angle_of(a - center), math::angle_of(b - center));
            let (from, to) = if bulge > 0.0 { (from, to) } else { (to, from) };
            Self::Arc(center, a.distance(center), from, if to < from { to + TAU } else { to })
        };
        (0..count).map(piece).collect()
    }

    fn write(&self, layer: &str, out: &mut String) {
        let mut tags = Tags(out);
        match self {
            Self::Line(a, b) => tags.head("LINE", layer, &["AcDbLine"]).point(10, *a).point(11, *b),
            Self::Circle(c, r) => tags.head("CIRCLE", layer, &["AcDbCircle"]).point(10, *c).number(40, *r),
            Self::Arc(c, r, a, b) => tags
                .head("ARC", layer, &["AcDbCircle"])
                .point(10, *c)
                .number(40, *r)
                .number(50, a.to_degrees())
                .number(51, b.to_degrees()),
            Self::Polyline(v, closed) => {
                tags.head("LWPOLYLINE", layer, &["AcDbPolyline"])
                    .int(90, v.len())
                    .int(70, usize::from(*closed));
                for (p, bulge) in v {
                    tags.number(10, p.x).number(20, p.y);
                    if *bulge != 0.0 {
                        tags.number(42, *bulge);
                    }
                }
                &mut tags
            }
            Self::Ellipse(c, major, ratio, a, b) => tags
                .head("ELLIPSE", layer, &["AcDbEllipse"])
                .point(10, *c)
                .point(11, *major)
                .number(40, *ratio)
                .number(41, *a)
                .number(42, *b),
            Self::Spline(points) => {
                let inner = points.len() - 4;
                let mut knots = vec![0.0; 4];
                knots.extend((1..=inner).map(|i| i as f64));
                knots.extend([inner as f64 + 1.0; 4]);
                tags.head("SPLINE", layer, &["AcDbSpline"]).int(70, 8).int(71, 3).int(72, knots.len());
                tags.int(73, points.len()).int(74, 0);
                for k in knots {
                    tags.number(40, k);
                }
                for p in points {
                    tags.point(10, *p);
                }
                &mut tags
            }
        };
    }
}

/// Group codes and values, a line each.
struct Tags<'a>(&'a mut String);

impl Tags<'_> {
    fn text(&mut self, code: u32, value: &str) -> &mut Self {
        let _ = write!(self.0, "{code:>3}\r\n{value}\r\n");
        self
    }

    fn number(&mut self, code: u32, value: f64) -> &mut Self {
        self.text(code, &format!("{value:?}"))
    }

    fn int(&mut self, code: u32, value: usize) -> &mut Self {
        self.text(code, &value.to_string())
    }

    fn point(&mut self, code: u32, p: DVec2) -> &mut Self {
        self.number(code, p.x).number(code + 10, p.y).number(code + 20, 0.0)
    }

    fn head(&mut self, kind: &str, layer: &str, classes: &[&str]) -> &mut Self {
        self.text(0, kind).text(100, "AcDbEntity").text(8, layer);
        for class in classes {
            self.text(100, class);
        }
        self
    }
}

/// A drawing: its entities, and the block and insert that they may be wrapped in.
#[derive(Clone, Debug)]
pub struct Scene {
    /// Entities with their layers.
    pub entities: Vec<(Entity, String)>,
    /// $INSUNITS.
    pub units: u32,
}

impl Scene {
    pub fn map(&self, f: impl Fn(&Entity) -> Vec<Entity>) -> Self {
        let entities = self.entities.iter().flat_map(|(e, l)| f(e).into_iter().map(|e| (e, l.clone())));
        Self { entities: entities.collect(), units: self.units }
    }

    pub fn transformed(&self, t: &Similarity) -> Self {
        self.map(|e| vec![e.transformed(t)])
    }

    /// All in model space.
    pub fn dxf(&self) -> String {
        document(self.units, "", &self.body())
    }

    /// All in a block with a base point, inserted so that it lands as `t` would put it; `depth` blocks around each
    /// other.
    pub fn dxf_in_block(&self, t: &Similarity, base: DVec2, depth: usize) -> String {
        let mut blocks = String::new();
        block("B0", base, &self.body(), &mut blocks);
        for i in 1..depth {
            // Base and insertion point cancel, so nested entities keep their places.
            let at = if i == 1 { base } else { DVec2::ZERO };
            let inner = insert(&format!("B{}", i - 1), at, &Similarity::IDENTITY);
            block(&format!("B{i}"), DVec2::ZERO, &inner, &mut blocks);
        }
        let at = if depth > 1 { t.shift } else { t.point(base) };
        document(self.units, &blocks, &insert(&format!("B{}", depth - 1), at, t))
    }

    fn body(&self) -> String {
        let mut out = String::new();
        for (e, layer) in &self.entities {
            e.write(layer, &mut out);
        }
        out
    }
}

/// A BLOCK with its content.
pub fn block(name: &str, base: DVec2, body: &str, out: &mut String) {
    Tags(out).head("BLOCK", "0", &["AcDbBlockBegin"]).text(2, name).int(70, 0).point(10, base).text(3, name);
    out.push_str(body);
    Tags(out).head("ENDBLK", "0", &["AcDbBlockEnd"]);
}

/// An INSERT at a point.
pub fn insert(name: &str, at: DVec2, t: &Similarity) -> String {
    let mut out = String::new();
    let y = if t.mirror { -t.scale } else { t.scale };
    Tags(&mut out)
        .head("INSERT", "0", &["AcDbBlockReference"])
        .text(2, name)
        .point(10, at)
        .number(41, t.scale)
        .number(42, y)
        .number(43, t.scale)
        .number(50, t.turn.to_degrees());
    out
}

/// A whole file around blocks and entities that are written already.
pub fn document(units: u32, blocks: &str, entities: &str) -> String {
    let mut out = String::new();
    let mut tags = Tags(&mut out);
    tags.text(0, "SECTION").text(2, "HEADER").text(9, "$ACADVER").text(1, "AC1015").text(9, "$INSUNITS");
    tags.text(70, &units.to_string()).text(0, "ENDSEC").text(0, "SECTION").text(2, "BLOCKS");
    out.push_str(blocks);
    Tags(&mut out).text(0, "ENDSEC").text(0, "SECTION").text(2, "ENTITIES");
    out.push_str(entities);
    Tags(&mut out).text(0, "ENDSEC").text(0, "EOF");
    out
}
