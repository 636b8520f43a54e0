//! Entities as read from the file: typed, in drawing units, with blocks not expanded.

use glam::{DVec2, DVec3};

/// Colour number: the colour of the insert.
pub(super) const BY_BLOCK: i16 = 0;
/// Colour number: the colour of the layer.
pub(super) const BY_LAYER: i16 = 256;

/// An entity of model space or of a block.
#[derive(Debug)]
pub(super) struct Entity<'a> {
    /// DXF name; for kinds without geometry see [`Geometry::Other`].
    pub(super) kind: &'static str,
    /// Handle as written.
    pub(super) handle: Option<&'a [u8]>,
    /// Index of its layer.
    pub(super) layer: u32,
    /// Colour number as written: [`BY_LAYER`], [`BY_BLOCK`] or a colour.
    pub(super) color: i16,
    /// Whether a break in the file touches the entity.
    pub(super) damaged: bool,
    /// If a value is missing, the text that says what was assumed.
    pub(super) assumed: Option<&'static str>,
    /// Why the entity is not visible, whatever its layer says.
    pub(super) hidden: Option<Hidden>,
    /// Geometry.
    pub(super) geometry: Geometry<'a>,
}

/// Why an entity is not visible.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Hidden {
    /// It is on a paper layout (67 = 1).
    Paper,
    /// It is marked as invisible (60 = 1).
    Invisible,
    /// Its layer, or that of an insert around it, is frozen.
    Frozen,
    /// Its layer is off.
    Off,
}

/// A vertex of a two-dimensional polyline.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Vertex {
    /// Position in the plane of the polyline.
    pub(super) at: DVec2,
    /// tan(sweep / 4) of the arc to the next vertex; 0 for a line.
    pub(super) bulge: f64,
}

/// A B-spline, defined by control points or by fit points.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Spline {
    /// Degree.
    pub(super) degree: usize,
    /// Whether flag 1 (closed) or 2 (periodic) is set.
    pub(super) closed: bool,
    /// Knots.
    pub(super) knots: Vec<f64>,
    /// Control points.
    pub(super) control: Vec<DVec3>,
    /// Weights; empty when all are 1.
    pub(super) weights: Vec<f64>,
    /// Fit points, through which the curve passes.
    pub(super) fit: Vec<DVec3>,
    /// Direction at the start, if given.
    pub(super) start_tangent: Option<DVec3>,
    /// Direction at the end, if given.
    pub(super) end_tangent: Option<DVec3>,
}

/// An instance of a block.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Insert<'a> {
    /// Name of the block, as written.
    pub(super) name: &'a [u8],
    /// Index of the block; `None` when the file does not define it.
    pub(super) block: Option<usize>,
    /// Position, in the plane of `normal`.
    pub(super) at: DVec3,
    /// Scale along the axes of the block.
    pub(super) scale: DVec3,
    /// Rotation, degrees.
    pub(super) rotation: f64,
    /// Number of columns and rows; 1 at least.
    pub(super) counts: [u32; 2],
    /// Distance between columns and between rows, along the rotated but unscaled axes of the insert.
    pub(super) spacing: DVec2,
    /// Extrusion direction.
    pub(super) normal: DVec3,
}

/// A chain of straight lines in world coordinates.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Polyline3d {
    /// Its points.
    pub(super) points: Vec<DVec3>,
    /// Whether it returns to its start.
    pub(super) closed: bool,
}

/// An element of the boundary of a hatch, in the hatch's plane.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Edge {
    /// A straight line.
    Line(DVec2, DVec2),
    /// Centre, radius, start angle in degrees, signed sweep in radians.
    Arc(DVec2, f64, f64, f64),
    /// An elliptic arc.
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
    /// Vertices with bulges, and whether it is closed.
    Polyline(Vec<Vertex>, bool),
    /// Elements joined end to end.
    Edges(Vec<Edge>),
}

/// The geometry of an entity.
#[derive(Debug)]
pub(super) enum Geometry<'a> {
    /// LINE, in world coordinates.
    Line(DVec3, DVec3),
    /// CIRCLE and ARC, in the plane of `normal`.
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
        /// Whether it returns to its start.
        closed: bool,
        /// Whether it has a width anywhere.
        wide: bool,
        /// Height of its plane.
        elevation: f64,
        /// Extrusion direction.
        normal: DVec3,
    },
    /// Three-dimensional POLYLINE, and outlines of SOLID, TRACE and 3DFACE, in world coordinates.
    Polylines3d(Vec<Polyline3d>),
    /// ELLIPSE, in world coordinates.
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
    /// SPLINE, in world coordinates.
    Spline(Box<Spline>),
    /// INSERT.
    Insert(Box<Insert<'a>>),
    /// HATCH: its boundaries, in the plane of `normal`.
    Hatch {
        /// Boundaries.
        loops: Vec<Loop>,
        /// Whether an edge of them lacks a value, so that it is left out.
        incomplete: bool,
        /// Height of its plane.
        elevation: f64,
        /// Extrusion direction.
        normal: DVec3,
    },
    /// Without geometry to cut: index of the kind's name, and a position.
    Other(u32, Option<DVec3>),
    /// A kind with geometry, but its values describe none: the reason, and a position.
    Invalid(&'static str, Option<DVec3>),
}
