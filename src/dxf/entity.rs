//! Entities as read: typed, in the units of the drawing, blocks not expanded.

use glam::{DVec2, DVec3};

/// Colour numbers with a meaning of their own.
pub(super) const BY_BLOCK: i16 = 0;
/// Colour of the entity's layer.
pub(super) const BY_LAYER: i16 = 256;

/// An entity of model space or of a block.
#[derive(Debug)]
pub(super) struct Entity<'a> {
    /// DXF name; for kinds without geometry see [`Form::Other`].
    pub(super) kind: &'static str,
    /// Handle as written.
    pub(super) handle: Option<&'a [u8]>,
    /// Index of its layer.
    pub(super) layer: u32,
    /// Colour number as written: [`BY_LAYER`], [`BY_BLOCK`] or a colour.
    pub(super) color: i16,
    /// A break in the file touches it.
    pub(super) damaged: bool,
    /// A value is missing; what was taken instead.
    pub(super) assumed: Option<&'static str>,
    /// Not seen, whatever its layer says.
    pub(super) hidden: Option<Hidden>,
    /// What it is.
    pub(super) form: Form<'a>,
}

/// Why an entity is not seen.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Hidden {
    /// On a paper layout (67 = 1).
    Paper,
    /// Switched invisible (60 = 1).
    Invisible,
    /// Its layer, or that of the insert around it, is frozen.
    Frozen,
    /// Its layer is off.
    Off,
}

/// A vertex of a two-dimensional polyline.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Vertex {
    /// Place in the plane of the polyline.
    pub(super) at: DVec2,
    /// tan(sweep / 4) of the arc to the next vertex; 0: a line.
    pub(super) bulge: f64,
}

/// A B-spline, or the points one goes through.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Spline {
    /// Degree.
    pub(super) degree: usize,
    /// Flags 1 (closed) or 2 (periodic).
    pub(super) closed: bool,
    /// Knots.
    pub(super) knots: Vec<f64>,
    /// Control points.
    pub(super) control: Vec<DVec3>,
    /// Weights; empty when all are 1.
    pub(super) weights: Vec<f64>,
    /// Points it goes through.
    pub(super) fit: Vec<DVec3>,
    /// Direction at the start.
    pub(super) start_tangent: Option<DVec3>,
    /// Direction at the end.
    pub(super) end_tangent: Option<DVec3>,
}

/// A block put in place.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Insert<'a> {
    /// Name of the block, as written.
    pub(super) name: &'a [u8],
    /// Index of the block; `None` when the file does not hold it.
    pub(super) block: Option<usize>,
    /// Place, in the plane of `normal`.
    pub(super) at: DVec3,
    /// Scale along the axes of the block.
    pub(super) scale: DVec3,
    /// Turn, degrees.
    pub(super) rotation: f64,
    /// Columns and rows; 1 at least.
    pub(super) counts: [u32; 2],
    /// Distance of columns and of rows, in the turned but unscaled axes of the insert.
    pub(super) spacing: DVec2,
    /// Extrusion direction.
    pub(super) normal: DVec3,
}

/// A chain of straight lines in the world.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Chain {
    /// Its points.
    pub(super) points: Vec<DVec3>,
    /// Comes back to its start.
    pub(super) closed: bool,
}

/// An element of the boundary of a hatch, in its plane.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Edge {
    /// Straight.
    Line(DVec2, DVec2),
    /// Centre, radius, start in degrees, signed sweep in radians.
    Arc(DVec2, f64, f64, f64),
    /// Elliptic.
    Ellipse(PlaneEllipse),
    /// A spline; its points have z = 0.
    Spline(Spline),
}

/// An elliptic arc in a plane: centre + cos(t) major + sin(t) minor.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct PlaneEllipse {
    /// Centre.
    pub(super) center: DVec2,
    /// Major half axis.
    pub(super) major: DVec2,
    /// Minor half axis.
    pub(super) minor: DVec2,
    /// First parameter, rad.
    pub(super) start: f64,
    /// Signed sweep of the parameter, rad.
    pub(super) sweep: f64,
}

/// A boundary of a hatch.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Loop {
    /// Vertices with bulges.
    Polyline(Vec<Vertex>, bool),
    /// Elements end to end.
    Edges(Vec<Edge>),
}

/// The geometry of an entity.
#[derive(Debug)]
pub(super) enum Form<'a> {
    /// LINE, in the world.
    Line(DVec3, DVec3),
    /// CIRCLE and ARC, in the plane of `normal`: start in degrees, sweep in radians.
    Arc {
        /// Centre.
        center: DVec3,
        /// Radius.
        radius: f64,
        /// First angle, degrees.
        start: f64,
        /// Last angle, degrees; `None` for a circle.
        end: Option<f64>,
        /// Extrusion direction.
        normal: DVec3,
    },
    /// LWPOLYLINE and two-dimensional POLYLINE.
    Polyline {
        /// Vertices.
        vertices: Vec<Vertex>,
        /// Comes back to its start.
        closed: bool,
        /// Drawn with a width somewhere.
        wide: bool,
        /// Height of its plane.
        elevation: f64,
        /// Extrusion direction.
        normal: DVec3,
    },
    /// Three-dimensional POLYLINE, outlines of SOLID, TRACE and 3DFACE, in the world.
    Chains(Vec<Chain>),
    /// ELLIPSE, in the world: centre, half axes, first parameter and sweep in radians.
    Ellipse {
        /// Centre.
        center: DVec3,
        /// Major half axis.
        major: DVec3,
        /// Minor half axis.
        minor: DVec3,
        /// First parameter, rad.
        start: f64,
        /// Sweep of the parameter, rad.
        sweep: f64,
    },
    /// SPLINE, in the world.
    Spline(Box<Spline>),
    /// INSERT.
    Insert(Box<Insert<'a>>),
    /// HATCH: its boundaries, in the plane of `normal`.
    Hatch {
        /// Boundaries.
        loops: Vec<Loop>,
        /// Height of its plane.
        elevation: f64,
        /// Extrusion direction.
        normal: DVec3,
    },
    /// No geometry to cut: index of its name, and a place.
    Other(u32, Option<DVec3>),
    /// Meant as geometry, but its values make none: why.
    Invalid(&'static str, Option<DVec3>),
}
